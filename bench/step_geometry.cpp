#include "bench/step_geometry.hpp"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

using std::numbers::pi;

gp_Dir axis() { return {0.0, 0.0, 1.0}; }

int count(const std::vector<Complex>& values) { return static_cast<int>(values.size()); }

TColStd_Array1OfReal reals(const std::vector<double>& values) {
  TColStd_Array1OfReal array(1, static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), array.begin());
  return array;
}

TColStd_Array1OfInteger integers(const std::vector<int>& values) {
  TColStd_Array1OfInteger array(1, static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), array.begin());
  return array;
}

Handle(Geom_Curve) spline_curve(const TColgp_Array1OfPnt& poles, const WallKnots& knots) {
  return new Geom_BSplineCurve(poles, reals(knots.distinct), integers(knots.multiplicity),
                               knots.degree);
}

gp_Dir away_from_middle(const Wall& wall, double turn) {
  const double angle = 0.5 * (wall.begin_angle + wall.end_angle) + turn;
  return {-std::cos(angle), -std::sin(angle), 0.0};
}

gp_Dir direction(Complex d) { return {d.real(), d.imag(), 0.0}; }

}  // namespace

std::vector<StepLevel> levels_of(const WallLoop& loop, double face_width) {
  std::vector<StepLevel> levels;
  for (int i = 0; i <= loop.slices; ++i) {
    const double z = face_width * (2 * i - loop.slices) / (2.0 * loop.slices);
    levels.push_back({z, loop.twist * z, std::polar(1.0, loop.twist * z)});
  }
  return levels;
}

StepSlice slice_between(const StepLevel& low, const StepLevel& high, const HelixSpline& helix) {
  StepSlice slice{low, high, 0.5 * (low.angle + high.angle), {}, {}, {}};
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

gp_Pnt point_at(Complex section_point, const StepLevel& level) {
  const Complex w = section_point * level.turn;
  return {w.real(), w.imag(), level.z};
}

StepRange u_range(const Wall& wall) {
  switch (wall.shape) {
    case WallShape::spline: return {0.0, 1.0};
    case WallShape::circle: {
      const double half = 0.5 * (wall.end_angle - wall.begin_angle);
      return {pi - half, pi + half};
    }
    case WallShape::line: return {0.0, std::abs(wall.end - wall.begin)};
  }
  contract_failed("postcondition", "known wall shape", __FILE__, __LINE__);
}

Handle(Geom_Curve) level_curve(const Wall& wall, const StepLevel& level) {
  switch (wall.shape) {
    case WallShape::spline: {
      TColgp_Array1OfPnt poles(1, count(wall.poles));
      std::transform(wall.poles.begin(), wall.poles.end(), poles.begin(),
                     [&](Complex c) { return point_at(c, level); });
      return spline_curve(poles, *wall.knots);
    }
    case WallShape::circle:
      return new Geom_Circle(
          gp_Ax2(gp_Pnt(0.0, 0.0, level.z), axis(), away_from_middle(wall, level.angle)),
          wall.radius);
    case WallShape::line:
      return new Geom_Line(point_at(wall.begin, level),
                           direction((wall.end - wall.begin) * level.turn));
  }
  contract_failed("postcondition", "known wall shape", __FILE__, __LINE__);
}

Handle(Geom_Curve) upright_curve(Complex section_point, const StepSlice& slice) {
  if (slice.straight()) {
    const Complex w = section_point * slice.low.turn;
    return new Geom_Line(gp_Pnt(w.real(), w.imag(), 0.0), axis());
  }
  TColgp_Array1OfPnt poles(1, count(slice.helix));
  for (std::size_t j = 0; j < slice.helix.size(); ++j) {
    const Complex w = section_point * slice.helix[j];
    poles(static_cast<int>(j) + 1) = gp_Pnt(w.real(), w.imag(), slice.height[j]);
  }
  return spline_curve(poles, slice.knots);
}

Handle(Geom_Surface) wall_surface(const Wall& wall, const StepSlice& slice) {
  switch (wall.shape) {
    case WallShape::spline: {
      TColgp_Array2OfPnt poles(1, count(wall.poles), 1, count(slice.helix));
      for (std::size_t i = 0; i < wall.poles.size(); ++i) {
        for (std::size_t j = 0; j < slice.helix.size(); ++j) {
          const Complex w = wall.poles[i] * slice.helix[j];
          poles(static_cast<int>(i) + 1, static_cast<int>(j) + 1) =
              gp_Pnt(w.real(), w.imag(), slice.height[j]);
        }
      }
      return new Geom_BSplineSurface(
          poles, reals(wall.knots->distinct), reals(slice.knots.distinct),
          integers(wall.knots->multiplicity), integers(slice.knots.multiplicity),
          wall.knots->degree, slice.knots.degree);
    }
    case WallShape::circle:
      return new Geom_CylindricalSurface(
          gp_Ax3(gp_Pnt(0.0, 0.0, 0.0), axis(), away_from_middle(wall, slice.middle_angle)),
          wall.radius);
    case WallShape::line: {
      GW_EXPECTS(slice.straight());
      const gp_Dir along = direction(wall.end - wall.begin);
      // Normal = along × axis points out of the loop; u runs along, v upwards.
      return new Geom_Plane(
          gp_Ax3(gp_Pnt(wall.begin.real(), wall.begin.imag(), 0.0), along.Crossed(axis()), along));
    }
  }
  contract_failed("postcondition", "known wall shape", __FILE__, __LINE__);
}

Handle(Geom2d_Curve) level_trace(const Wall& wall, const StepSlice& slice, const StepLevel& level) {
  if (wall.shape == WallShape::line) return {};
  // A level's circle starts where that level has turned to, the cylinder in the slice's middle.
  const double shift = wall.shape == WallShape::circle ? level.angle - slice.middle_angle : 0.0;
  return new Geom2d_Line(gp_Pnt2d(shift, level.z), gp_Dir2d(1.0, 0.0));
}

Handle(Geom2d_Curve) upright_trace(const Wall& wall, const StepSlice& slice, double u) {
  if (wall.shape == WallShape::line) return {};
  if (wall.shape == WallShape::spline || slice.straight()) {
    return new Geom2d_Line(gp_Pnt2d(u, 0.0), gp_Dir2d(0.0, 1.0));
  }
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = gp_Pnt2d(u + (slice.low.angle - slice.middle_angle), slice.low.z);
  poles(2) = gp_Pnt2d(u + (slice.high.angle - slice.middle_angle), slice.high.z);
  return new Geom2d_BSplineCurve(poles, reals({slice.low.z, slice.high.z}), integers({2, 2}), 1);
}

}  // namespace gearwright
