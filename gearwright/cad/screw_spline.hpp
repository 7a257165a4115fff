// Represents a screw surface by a tensor-product B-spline, which is the product of a section spline and
// a helix spline.
//
//   W(u)   arc of the transverse outline, a complex number x + iy, mm; u in [0, 1]
//   φ      angle by which the section has turned, rad; over one slice φ runs from −Δ/2 to Δ/2
//   C(u)   spline of the section, C ≈ W        H(v)   spline of the turn, H ≈ e^{iφ}, φ linear in v
//   S      the surface: S_xy(u, v) = H(v) C(u), z linear in v; its poles are the products h_j c_i
//
// The exact surface is e^{iφ} W, so interpolation on the grid of Greville points gives exactly the
// product of the two interpolants. The section is fitted once for every helix, and the distance to
// the exact surface is that of two plane curves. With H = e^{iφ}(1 + ε), a point of S, turned back
// by φ, is C(1 + ε). Its distance from W is at most e + |C||ε|, where e is the normal distance from
// C to W. The distance in space is smaller, because the surface is steeper than its section.
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
/// in profile measurement of gears (1 µm). A surface beyond the greatest value is an error.
inline constexpr double kSectionTarget_mm = 2e-5;
inline constexpr double kSectionMax_mm = 1e-4;
/// Target of R|ε|, mm. It is half of 1e-7, the tolerance of every edge and vertex, because the
/// spline of a helix is the common edge of a flank and of a true cylinder.
inline constexpr double kHelixTarget_mm = 5e-8;

struct SectionSpline {
  BSplineBasis basis;
  std::vector<Complex> poles;  ///< c_i  mm; the first and the last are the ends of the arc
  double deviation_mm;         ///< e, greatest of 24 points between neighbouring knots
  bool by_length;  ///< if true, u is the relative arc length; otherwise the curve's parameter

  Complex at(double u) const;
};

/// Fits a spline of degree 5 to the arc, with the fewest poles that reach the target.
///
/// Both the curve's own parameter and its arc length are tried, and the one with fewer poles is
/// used. A trochoid needs fewer poles by length, an involute near its base circle by roll angle.
/// The own parameter is used only if its slowest speed is above 1/100 of the mean, so that no
/// corner loses its normal. If uniform knots do not converge, spans that miss the target are
/// halved.
///
/// Units     mm
/// Domain    the arc's ends lie within 1e-5 mm of its curve
/// Accuracy  deviation_mm ≤ target, or the best that kMaxPoles gave, which the caller must check.
///           The error has at most 5 lobes between two knots. 24 points miss the top of a lobe by a
///           half step of π/9.6 at most, so the true maximum is below 1.06 deviation_mm
SectionSpline fit_section(const Arc& arc, double target_mm = kSectionTarget_mm);

inline constexpr int kMaxPoles = 240;

/// Places between the knots, none of which is a Greville point: (k + ½)/n of each span.
std::vector<double> places_between_knots(const BSplineBasis& basis, int n);

/// The greatest error at those places, span by span.
std::vector<double> worst_by_span(const BSplineBasis& basis, int n,
                                  const std::function<double(double)>& error);

/// The basis in which every span that misses the target is halved. None if all these spans are already
/// so short that more knots do not help, because the curve has a gap there.
std::optional<BSplineBasis> refined(const BSplineBasis& basis,
                                    const std::vector<double>& span_deviation, double target);

struct HelixSpline {
  BSplineBasis basis;          ///< degree 5; degree 1 without twist
  std::vector<Complex> poles;  ///< h_j for φ from −Δ/2 to Δ/2; two poles, both 1, without twist
  double deviation;            ///< |ε|, greatest of 24 points between neighbouring knots

  Complex at(double v) const;
};

/// Computes the spline of the turn by Δ over one slice, with an error of at most `target_mm` at the
/// radius `radius`.
///
/// Units     Δ in rad, signed; mm
/// Domain    |Δ| ≤ π, radius > 0 (contract)
/// Accuracy  radius · deviation ≤ max(target, 1e-14 radius) (contract, it always converges)
HelixSpline fit_helix(double delta, double radius, double target_mm = kHelixTarget_mm);

}  // namespace gearwright
