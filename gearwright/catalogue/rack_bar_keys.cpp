#include "gearwright/catalogue/rack_bar_keys.hpp"

#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

const KeyTable& rack_bar_keys() {
  static const KeyTable table{
      "rack_bar",
      "A rack as gear 2, with the profile of the basic rack of gear 1",
      {Key::word("form", {"rack"}, KeyPlace::unused(), kRequired, "gear 2 is a rack"),
       Key::number("teeth", "z", KeyRange::between(1, 100'000), &RackBar::teeth,
                   "as many as are needed", "number of teeth; the rack is as long as their pitches")
           .with_also({"number_of_teeth"}),
       Key::positive("face_width_mm", "b", &RackBar::face_width, "that of gear 1", "face width")
           .with_also({"width", "face"}),
       Key::positive("height_mm", "", &RackBar::height, "no mounting distance",
                     "height from the back of the rack to its datum line")
           .with_also({"height", "back"}),
       Key::number("thickness_allowance_mm", "E_sn", {}, &RackBar::thickness_allowance, "0",
                   "allowance on the normal tooth thickness at the datum line; < 0 thins the teeth")
           .with_also({"allowance", "thinning"})}};
  return table;
}

}  // namespace gearwright
