#include "gearwright/catalogue/drawing_keys.hpp"

namespace gearwright {

const KeyTable& drawing_keys() {
  using D = DrawingInput;
  static const KeyTable table{
      "drawing",
      "The title block of the report and of drawings",
      {Key::text("title", &D::title, "the spec's `title`", "title of the drawing"),
       Key::text("number", &D::number, "", "drawing number")
           .with_also({"drawing_number", "no", "part_number"}),
       Key::text("author", &D::author, "", "name of the author"),
       Key::text("date", &D::date, "",
                 "date in any form, in quotes; it is never filled in automatically"),
       Key::text("material", &D::material, "", "remark"),
       Key::text("note", &D::note, "", "additional notes for the workshop")
           .with_also({"notes", "remark", "comment"})}};
  return table;
}

}  // namespace gearwright
