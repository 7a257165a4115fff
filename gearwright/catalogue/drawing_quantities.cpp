#include "gearwright/catalogue/drawing_quantities.hpp"

namespace gearwright {

const Quantities<DrawingInput>& drawing_quantities() {
  using D = DrawingInput;
  static const Quantities<D> kAll("drawing", [](Quantities<D>& q) {
    const auto line = [&q](const char* key, const char* words, std::string D::*member) {
      q.add(Type::text, key, words, "", "text as given; null if absent",
            [member](const D& d) { return (d.*member).empty() ? Value() : Value(d.*member); });
    };
    line("title", "title", &D::title);
    line("number", "number", &D::number);
    line("author", "author", &D::author);
    line("date", "date", &D::date);
    line("material", "material", &D::material);
    line("heat_treatment", "heat treatment", &D::heat_treatment);
    line("surface_texture", "surface texture", &D::surface_texture);
    line("edges", "edges", &D::edges);
    line("general_tolerances", "general tolerances", &D::general_tolerances);
    line("bore_fit", "fit of the bore", &D::bore_fit);
    line("keyway_fit", "fit of the keyway", &D::keyway_fit);
    line("note", "note", &D::note);
  });
  return kAll;
}

}  // namespace gearwright
