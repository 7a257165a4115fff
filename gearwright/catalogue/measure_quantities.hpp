// The quantities that a workshop measures, and a gear as another rack describes it: `measure` and
// `as_rack` of a result.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"
#include "gearwright/inspection/constant_chord.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright {

struct ChordView {
  double diameter;  ///< mm, at which the jaws touch
  ChordalThickness<double> chord;
};

struct BallView {
  BallSeat seat;
  double dimension;  ///< M_d  mm, over or between two
};

struct PinView {
  BallSeat seat;
  PinReading reading;
};

struct ThicknessView {
  double diameter;    ///< d_y  mm
  double transverse;  ///< s_yt  mm, arc
  double normal;      ///< s_yn  mm, arc
  double half_angle;  ///< rad
  double helix;       ///< β_y  rad, signed
};

/// All that is measured of one gear; what it does not have is none.
struct MeasureView {
  std::optional<Span> span;
  std::vector<Span> spans;  ///< usable ones
  std::optional<BallView> balls;
  std::optional<PinView> pins;
  std::optional<BallSizes> sizes;
  std::optional<ChordView> chord;
  std::optional<ConstantChord> constant;
  std::optional<ThicknessView> thickness;
  std::optional<ReferenceGeometry<double>> reference;  ///< of an involute gear
  std::optional<EvaluationRanges> ranges;
  std::optional<FlankToleranceValues> tolerances;  ///< with a grade
};

/// Of one gear.
const Quantities<MeasureView>& measure_quantities();

/// Of a rack that would cut the same teeth.
const Quantities<ReferenceInput<double>>& as_rack_quantities();

}  // namespace gearwright
