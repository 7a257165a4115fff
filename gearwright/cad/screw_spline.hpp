// Represents a screw surface by a tensor-product B-spline, the product of a section spline and a
// helix spline.
//
//   W(u)   arc of the transverse outline, a complex number x + iy, mm; u in [0, 1]
//   φ      rotation angle of the section, rad; over one slice φ runs from −Δ/2 to Δ/2
//   C(u)   spline of the section, C ≈ W
//   H(v)   spline of the rotation, H ≈ e^{iφ} with φ linear in v
//   S      the surface: S_xy(u, v) = H(v) C(u), z linear in v; its poles are the products h_j c_i
//
// The exact surface is e^{iφ} W, so interpolation on the grid of Greville points gives exactly the
// product of the two interpolants. The section is fitted only once for all helices.
//
// The distance to the exact surface follows from the errors of two plane curves. With H = e^{iφ}(1
// + ε), a point of S becomes C(1 + ε) when it is turned back by φ. The distance from C(1 + ε) to W
// is at most e + |C||ε|, where e is the normal distance from C to W. The distance in space is even
// smaller, because the surface normal is inclined to the plane of the section.
#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "gearwright/generation/outline.hpp"
#include "gearwright/math/bspline.hpp"

namespace gearwright {

using Complex = std::complex<double>;

/// The target and the greatest permitted value of e, mm. The target is 1/50 of the finest tolerance
/// in the profile measurement of gears, which is 1 µm. If e exceeds the greatest value, the result
/// is an error.
inline constexpr double kSectionTarget_mm = 2e-5;
inline constexpr double kSectionMax_mm = 1e-4;
/// The target of R|ε|, mm, at the greatest radius R. The spline of a helix is the common edge of a
/// flank and a true cylinder. The target is half of 1e-7 mm, the tolerance of all edges and
/// vertices.
inline constexpr double kHelixTarget_mm = 5e-8;

struct SectionSpline {
  BSplineBasis basis;
  std::vector<Complex> poles;  ///< c_i  mm; the first and the last pole are the ends of the arc
  double deviation_mm;         ///< e, the greatest distance at 24 points between neighbouring knots
  bool by_length;  ///< if true, u is the relative arc length; if false, u is the curve's parameter

  Complex at(double u) const;
};

/// Fits a spline of degree 5 to the arc. The number of poles increases until the target is reached.
/// The parameter u follows the curve's own parameter or the arc length. The parametrization that
/// needs fewer poles is used. If at most one of the two reaches the target, the one with the
/// smaller deviation is used. A trochoid needs fewer poles with the arc length, and an involute
/// near its base circle needs fewer poles with the roll angle. The curve's own parameter is used
/// only if its slowest speed exceeds 1/100 of the mean, because a spline has no normal where the
/// speed is 0.
///
/// Units     mm
/// Domain    the ends of the arc lie within 1e-5 mm of its curve
/// Accuracy  deviation_mm ≤ target, or the best value reached with kMaxPoles, which the caller must
///           check. The error has at most 5 half waves between two knots, so half a step of the 24
///           points is a phase of π/9.6, and the true maximum is below deviation_mm/cos(π/9.6) <
///           1.06 deviation_mm
SectionSpline fit_section(const Arc& arc, double target_mm = kSectionTarget_mm);

inline constexpr int kMaxPoles = 240;

/// Returns the points (k + ½)/n of each span between two knots, k = 0 … n − 1.
std::vector<double> places_between_knots(const BSplineBasis& basis, int n);

/// Returns, for each span, the greatest error at the points of places_between_knots().
std::vector<double> worst_by_span(const BSplineBasis& basis, int n,
                                  const std::function<double(double)>& error);

/// Returns the basis in which every span that misses the target is halved. Returns none if all
/// these spans are already so short that more knots do not help. This happens, for example, if the
/// curve has a gap.
std::optional<BSplineBasis> refined(const BSplineBasis& basis,
                                    const std::vector<double>& span_deviation, double target);

struct HelixSpline {
  BSplineBasis basis;          ///< degree 5; degree 1 without twist
  std::vector<Complex> poles;  ///< h_j for φ from −Δ/2 to Δ/2; two poles, both 1, without twist
  double deviation;            ///< |ε|, the greatest value at 24 points between neighbouring knots

  Complex at(double v) const;
};

/// Computes the spline of the rotation by Δ over one slice. The error of the spline at `radius` is
/// at most kHelixTarget_mm.
///
/// Units     Δ in rad, signed; mm
/// Domain    |Δ| ≤ π, radius > 0 (contract)
/// Accuracy  radius · deviation ≤ max(target, 1e-14 radius); the fit always converges (contract)
HelixSpline fit_helix(double delta, double radius);

}  // namespace gearwright
