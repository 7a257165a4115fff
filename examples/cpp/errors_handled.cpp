// Errors and warnings are values. An error contains the field to correct, a warning a defect of the gear.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

void show(const Error& error) { std::printf("error: %s\n", error.message().c_str()); }

void show(const Result<Gear>& gear) {
  if (!gear) return show(gear.error());
  std::printf("%d teeth, tip diameter %.3f mm\n", gear->spec.teeth, gear->tip_diameter);
  for (const Warning& warning : gear->warnings)
    std::printf("  warning %s\n", to_string(warning.code));
}

int main() {
  // An invalid number: the message contains its name and the allowed range.
  show(make_gear({.teeth = 17, .normal_module = -1, .face_width = 5}));

  // An undercut gear can be made, so undercut is a warning, not an error.
  show(make_gear({.teeth = 9, .normal_module = 2, .face_width = 5}));

  // Two gears that cannot mesh.
  const Result<Gear> one = make_gear({.teeth = 20, .normal_module = 2, .face_width = 10});
  const Result<Gear> other = make_gear({.teeth = 30, .normal_module = 2.5, .face_width = 10});
  if (!one || !other) return 1;
  const Result<Pair> pair = mount(*one, *other, {.center_distance = 56});
  if (!pair) show(pair.error());
  if (!pair && pair.error().field == "gear2.normal_module") std::printf("to correct: the wheel\n");

  // Two gears that mesh, but lose contact because the shafts are too far apart.
  const Result<Pair> far = mount(*one, *one, {.center_distance = 42});
  if (!far) return 1;
  const Result<Contact> touching = contact(*far, {.center_distance = 3});
  if (!touching) return 1;
  std::printf("contact lost: %s\n", touching->contact_lost ? "yes" : "no");
}

/* prints
error: normal_module = -1: must lie between 0.001 mm and 1000 mm
9 teeth, tip diameter 22.000 mm
  warning undercut
error: gear2.normal_module = 2.5: the normal base pitches differ by 1.47607 mm, because gear 1 has 5.90426 mm and gear 2 has 7.38033 mm; gears mesh only with equal m_n cos α_n. Gear 2 needs the module 2 mm at its pressure angle (diametral pitch 12.7), or the base diameter 56.3815572 mm at its base helix angle
to correct: the wheel
contact lost: yes
*/
