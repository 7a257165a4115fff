#include "gearwright/catalogue/drawing_quantities.hpp"

namespace gearwright {

const Quantities<DrawingInput>& drawing_quantities() {
  using D = DrawingInput;
  static const Quantities<D> kAll("drawing", [](Quantities<D>& q) {
    const auto said = [&q](const char* key, const char* words, std::string D::*member) {
      q.add(Type::text, Unit::none, "", key, words, "", "as given; null without",
            [member](const D& d) { return (d.*member).empty() ? Value() : Value(d.*member); });
    };
    said("title", "title", &D::title);
    said("number", "number", &D::number);
    said("author", "author", &D::author);
    said("date", "date", &D::date);
    said("material", "material", &D::material);
    said("note", "note", &D::note);
  });
  return kAll;
}

}  // namespace gearwright
