// A crossed pair over the pressure angle of the common rack: its positions without backlash with
// their data, and the common axis of its pictures.
//
//   α_wn  pressure angle of the common rack, the only free parameter     Σ, a  position of the axes
//   ε     contact ratio, tip to tip       f, f′  face widths, of one flank and of both
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct CrossedSample {
  CrossedPlace place;
  double contact_ratio;      ///< ε
  FaceWidths<double> faces;  ///< f, f′
};

/// The pair without backlash on the rack with the pressure angle α_wn. None if there is no such
/// rack.
///
/// Formula   crossed_place, then mesh_of at that position
/// Domain    crossed axes (contract)
std::optional<CrossedSample> crossed_sample(const CrossedPair& pair, Angle normal_pressure_angle);

/// Samples with increasing α_wn over the relevant range. The range contains all angles with ε ≥ 1, the
/// position of the pair and the least centre distance, with some margin, as far as racks exist.
///
/// Domain    crossed axes (contract)
/// Laws      at least two samples; the pair's α_wn lies within, to 1e-6 rad
std::vector<CrossedSample> crossed_samples(const CrossedPair& pair);

/// A manual approximation for the pair: its name and the resulting α_wn.
struct Approximation {
  const char* name;
  const char* letter;  ///< in pictures
  Angle normal_pressure_angle;
};

/// The approximate solutions of the least centre distance (pair/series.hpp) of external pairs. There
/// are none unless both gears have the same rack, with module and pressure angle equal within a relative 1e-9.
/// Solutions without a rack are omitted.
std::vector<Approximation> approximations(const CrossedPair& pair);

/// An axis of α_wn in degrees.
FigureAxis angle_axis(double lo, double hi);

/// The axis of these samples, with a band where ε ≥ 1 and lines at the least centre distance and at
/// the position of the pair, which are named above the plot. The y axis is set before, and the
/// curves are added after.
void add_angles(Figure& figure, const CrossedPair& pair, const std::vector<CrossedSample>& samples);

/// Values of the samples as a curve over α_wn in degrees.
template <class Value>
std::vector<Vec2> over_angle(const std::vector<CrossedSample>& samples, const Value& value) {
  std::vector<Vec2> points;
  for (const CrossedSample& s : samples) {
    points.push_back({s.place.normal_pressure_angle.deg(), value(s)});
  }
  return points;
}

}  // namespace gearwright
