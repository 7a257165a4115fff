#include "gearwright/catalogue/drawing_keys.hpp"

namespace gearwright {

const KeyTable& drawing_keys() {
  using D = DrawingInput;
  static const KeyTable table{
      "drawing",
      "The title block of the report and of drawings, as given",
      {{.key = "title",
        .kind = KeyKind::text,
        .place = &D::title,
        .fallback = "the spec's `title`",
        .meaning = "what the drawing shows"},
       {.key = "number",
        .kind = KeyKind::text,
        .place = &D::number,
        .meaning = "drawing number",
        .also = {"drawing_number", "no", "part_number"}},
       {.key = "author", .kind = KeyKind::text, .place = &D::author, .meaning = "who drew it"},
       {.key = "date",
        .kind = KeyKind::text,
        .place = &D::date,
        .meaning = "in quotes, any form; never that of today by itself"},
       {.key = "material", .kind = KeyKind::text, .place = &D::material, .meaning = "in words"},
       {.key = "note",
        .kind = KeyKind::text,
        .place = &D::note,
        .meaning = "what a workshop should know besides",
        .also = {"notes", "remark", "comment"}}}};
  return table;
}

}  // namespace gearwright
