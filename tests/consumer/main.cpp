// What a user of the installed library writes first: exact turns of a gear of 20 teeth.
#include <cstdio>

#include "gearwright/base/angle.hpp"

int main() {
  const auto quarter = gearwright::sincos_turn(5, 20);
  const auto helix = gearwright::Angle::degrees(15.0);
  std::printf("tooth 5 of 20: sin %g cos %g, helix %.6f rad\n", quarter.sin, quarter.cos,
              helix.rad());
  return quarter.sin == 1.0 && quarter.cos == 0.0 ? 0 : 1;
}
