#include "gearwright/catalogue/file_quantities.hpp"

#include "gearwright/base/units.hpp"

namespace gearwright {

const Quantities<FileView>& file_quantities() {
  using F = FileView;
  return define("file", [](Quantities<F>& q) {
    q.text("file", "name of the file", &F::file);
    q.text("what", "content of the file", &F::what);
    q.number("max_deviation_um", "maximum deviation", "",
             "greatest distance from the exact surface or outline",
             [](const F& f) { return f.deviation ? Value(kUmPerMm * *f.deviation) : Value(); });
    q.text("note", "remarks on the file", &F::note);
  });
}

const Quantities<ArcView>& outline_quantities() {
  using A = ArcView;
  return define("outline.arc", [](Quantities<A>& q) {
    q.word("name", "arc",
           "name of the arc; the arcs are listed from the middle of the space to the middle of the "
           "tooth",
           [](const A& a) { return to_string(a.arc->name); })
        .one_of({"root_land", "root_fillet", "flank", "tip_fillet", "tip_land"});
    q.number("points", "points", "",
             "[x, y] in `unit` on the side y > 0; the centre line of the tooth is the x axis",
             [](const A& a) { return sample(*a.arc, a.points); });
    q.text("unit", "unit of the points, spelled as in keys", [](const A&) { return "mm"; });
  });
}

const Quantities<DrawingInput>& drawing_quantities() {
  using D = DrawingInput;
  return define("drawing", [](Quantities<D>& q) {
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
    line("flank_roughness", "surface texture of the flanks", &D::flank_roughness);
    line("face_roughness", "surface texture of the faces", &D::face_roughness);
    line("bore_roughness", "surface texture of the bore", &D::bore_roughness);
    line("edges", "edges", &D::edges);
    line("general_tolerances", "general tolerances", &D::general_tolerances);
    line("bore_fit", "fit of the bore", &D::bore_fit);
    line("keyway_fit", "fit of the keyway", &D::keyway_fit);
    line("note", "note", &D::note);
  });
}

}  // namespace gearwright
