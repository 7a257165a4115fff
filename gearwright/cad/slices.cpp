#include "gearwright/cad/slices.hpp"

#include <complex>

namespace gearwright {

std::vector<WallLevel> levels_of(const WallLoop& loop, double face_width) {
  std::vector<WallLevel> levels;
  for (int i = 0; i <= loop.slices; ++i) {
    const double z = face_width * (2 * i - loop.slices) / (2.0 * loop.slices);
    levels.push_back({z, loop.twist * z, std::polar(1.0, loop.twist * z)});
  }
  return levels;
}

WallSlice slice_between(const WallLevel& low, const WallLevel& high, const HelixSpline& helix) {
  WallSlice slice{low, high, 0.5 * (low.angle + high.angle), {}, {}, {}};
  const Complex middle = std::polar(1.0, slice.middle_angle);
  const auto z_at = [&](double v) { return low.z + (high.z - low.z) * v; };
  for (const Complex& h : helix.poles) slice.helix.push_back(middle * h);
  for (const double g : helix.basis.greville()) slice.height.push_back(z_at(g));
  slice.knots = {helix.basis.degree(), helix.basis.distinct_knots(), helix.basis.multiplicities()};
  for (double& knot : slice.knots.distinct) knot = z_at(knot);
  slice.helix.front() = low.turn;
  slice.helix.back() = high.turn;
  slice.height.back() = high.z;
  slice.knots.distinct.back() = high.z;
  return slice;
}

Vec3 point_at(Complex section_point, const WallLevel& level) {
  const Complex w = section_point * level.turn;
  return {w.real(), w.imag(), level.z};
}

Vec3 climbing_pole(Complex section_point, const WallSlice& slice, std::size_t j) {
  const Complex w = section_point * slice.helix[j];
  return {w.real(), w.imag(), slice.height[j]};
}

}  // namespace gearwright
