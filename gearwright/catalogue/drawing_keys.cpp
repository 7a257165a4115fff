#include "gearwright/catalogue/drawing_keys.hpp"

#include <utility>

#include "gearwright/base/printable.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright {

namespace {

// Greatest number of letters of a surface texture. A longer text does not fit into the symbol on
// the drawing. Examples of textures that fit are "0.008-0.8/Ra 0.8" and "U Rz 4; L Ra 0.2".
constexpr std::size_t kTextureLetters = 20;

// A fit is valid if the table of deviations contains it for this size, mm. For this size, the table
// contains every fit that it has for any size.
constexpr double kAnySize = 20.0;

std::optional<KeyFault> check_texts(DrawingInput& d, const KeyGiven&) {
  for (const auto& [key, texture] : {std::pair("flank_roughness", &d.flank_roughness),
                                     std::pair("face_roughness", &d.face_roughness),
                                     std::pair("bore_roughness", &d.bore_roughness)})
    if (code_points(*texture).size() > kTextureLetters)
      return KeyFault{key, "must have at most 20 letters, for example \"MRR Ra 0.8\""};
  const bool bore = d.bore_fit.empty() || d.bore_fit.starts_with('H');
  if (!bore || (!d.bore_fit.empty() && !hole_deviations(d.bore_fit, kAnySize)))
    return KeyFault{"bore_fit", "must be H1 to H12 of ISO 286, for example H7"};
  const auto& k = d.keyway_fit;
  if (!k.empty() && k != "JS9" && k != "N9" && k != "P9")
    return KeyFault{"keyway_fit", "must be JS9, N9 or P9, the fits of DIN 6885"};
  return std::nullopt;
}

Key texture(std::string_view key, std::string DrawingInput::*member, std::string_view fallback,
            std::string_view meaning) {
  return Key::text(key, member, fallback, meaning)
      .with_form("a text of at most 20 letters, such as \"MRR Ra 0.8\"");
}

}  // namespace

bool DrawingInput::given() const {
  for (const std::string* words :
       {&title, &number, &author, &date, &material, &note, &heat_treatment, &surface_texture,
        &flank_roughness, &face_roughness, &bore_roughness, &edges, &general_tolerances, &bore_fit,
        &keyway_fit})
    if (!words->empty()) return true;
  return false;
}

const KeyTable& drawing_keys() {
  using D = DrawingInput;
  static const KeyTable table{
      "drawing",
      "The title block of the report and of drawings",
      {Key::text("title", &D::title, "value of the key `title` of the spec",
                 "title of the drawing"),
       Key::text("number", &D::number, "", "drawing number")
           .with_also({"drawing_number", "no", "part_number"}),
       Key::text("author", &D::author, "", "name of the author"),
       Key::text("date", &D::date, "", "date in any form, in quotes"),
       Key::text("material", &D::material, "name of `[gearN.material]`", "material, in words"),
       Key::text("heat_treatment", &D::heat_treatment,
                 "kind and given hardness of `[gearN.material]`, unless `material` is given",
                 "heat treatment, with hardness and depth")
           .with_also({"hardness", "hardening"}),
       Key::text("surface_texture", &D::surface_texture, "",
                 "texture of all surfaces that have no symbol of their own")
           .with_also({"roughness", "surface"}),
       texture("flank_roughness", &D::flank_roughness,
               "Rz of `flank_roughness_um` in [rating], or a blank symbol",
               "surface texture of the flanks, in a symbol of ISO 21920-1; the text may begin with "
               "MRR (material is removed), NMR (no material is removed) or APA (any process)"),
       texture("face_roughness", &D::face_roughness, "a blank symbol",
               "surface texture of both faces, in the form of `flank_roughness`"),
       texture("bore_roughness", &D::bore_roughness, "a blank symbol",
               "surface texture of the bore, in the form of `flank_roughness`"),
       Key::text("edges", &D::edges, "", "edges of undefined shape by ISO 13715"),
       Key::text("general_tolerances", &D::general_tolerances, "",
                 "general tolerances by ISO 22081 or ISO 2768"),
       Key::text(
           "bore_fit", &D::bore_fit, "no limits",
           "fit of the bore by ISO 286 (H1 to H12); the drawing shows the limits of the diameter")
           .with_form("a fit such as \"H7\""),
       Key::text("keyway_fit", &D::keyway_fit, "no limits",
                 "fit of the keyway width by DIN 6885 (JS9, N9 or P9); the drawing shows the "
                 "limits of width and depth")
           .with_form("a fit such as \"JS9\""),
       Key::text("note", &D::note, "", "additional notes for the workshop")
           .with_also({"notes", "remark", "comment"})},
      check_texts};
  return table;
}

}  // namespace gearwright
