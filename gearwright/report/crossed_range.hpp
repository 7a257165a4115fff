// Computes properties of a crossed pair without backlash as functions of the pressure angle of the
// common rack, and the common x axis of their pictures.
//
//   α_wn  pressure angle of the common rack, the only free parameter     Σ, a  position of the axes
//   ε     contact ratio, from tip to tip      f, f′  face widths for one flank and for both flanks
#pragma once

#include <optional>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct CrossedSample {
  CrossedPlace place;
  double contact_ratio;      ///< ε
  FaceWidths<double> faces;  ///< f, f′
};

/// Returns the position without backlash at which the common rack of both gears has the pressure
/// angle α_wn, with the contact ratio and the face widths at this position. Returns none if there
/// is no such rack, or if the shaft angle would be out of range.
///
/// Formula   crossed_place() for the position, mesh_of() for the contact ratio and the face widths
/// Domain    crossed axes (contract)
std::optional<CrossedSample> crossed_sample(const CrossedPair& pair, Angle normal_pressure_angle);

/// Returns samples with increasing α_wn. Their range contains all angles with ε ≥ 1, the mounted
/// position and the least centre distance, with some margin. The range ends where no rack exists.
///
/// Domain    crossed axes (contract)
/// Laws      at least two samples; the range contains the pair's α_wn within 1e-6 rad
std::vector<CrossedSample> crossed_samples(const CrossedPair& pair);

/// An approximation for manual calculation, with its name and the resulting α_wn.
struct Approximation {
  const char* name;
  const char* letter;  ///< letter of the approximation in pictures
  Angle normal_pressure_angle;
};

/// Returns the approximate solutions of pair/series.hpp for the least centre distance. The result
/// is empty if there is no least centre distance, if the pair is internal, or if the modules or the
/// pressure angles of the racks of both gears have a relative difference above 1e-9. Solutions for
/// which no rack exists are omitted.
std::vector<Approximation> approximations(const CrossedPair& pair);

FigureAxis angle_axis(double lo, double hi);

/// Sets the x axis of a figure to the range of the samples, with a band where ε ≥ 1. Lines mark the
/// least centre distance and the mounted pair, and their names are above the plot. The caller sets
/// the y axis before this call and adds curves afterwards.
void add_angles(Figure& figure, const CrossedPair& pair, const std::vector<CrossedSample>& samples);

/// Returns the curve of a value of the samples over α_wn in degrees.
template <class Value>
std::vector<Vec2> over_angle(const std::vector<CrossedSample>& samples, const Value& value) {
  std::vector<Vec2> points;
  for (const CrossedSample& s : samples) {
    points.push_back({s.place.normal_pressure_angle.deg(), value(s)});
  }
  return points;
}

}  // namespace gearwright
