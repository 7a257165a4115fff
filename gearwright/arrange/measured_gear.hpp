// Computes the inspection dimensions of a gear: span, dimensions over balls and pins, chords, and
// flank tolerances.
//
//   const auto measures = measure(*gear, {.span_teeth = 3});
//   if (measures && measures->span) use(measures->span->length);
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright {

struct ChordMeasure {
  double diameter;  ///< mm, diameter at which the flanks touch the measuring faces
  ChordalThickness<double> chord;
};

struct BallMeasure {
  BallSeat seat;
  double dimension;  ///< M_d  mm, dimension over or between two balls
};

struct PinMeasure {
  BallSeat seat;
  PinReading reading;
};

struct ThicknessAt {
  double diameter;    ///< d_y  mm
  double transverse;  ///< s_yt  mm, arc length
  double normal;      ///< s_yn  mm, arc length
  double half_angle;  ///< rad, half of the angle of the tooth at d_y
  double helix;       ///< β_y  rad, signed
};

struct GearMeasures {
  std::optional<Span> span;
  std::vector<Span> spans;  ///< the spans that can be measured, at most 31
  std::optional<BallMeasure> balls;
  std::optional<PinMeasure> pins;
  std::optional<BallSizes> sizes;
  std::optional<ChordMeasure> chord;
  std::optional<ConstantChord> constant;
  std::optional<ThicknessAt> thickness;
  std::optional<ReferenceGeometry<double>> reference;  ///< none for circular-arc teeth
  std::optional<EvaluationRanges> ranges;
  std::optional<FlankToleranceValues> tolerances;  ///< none if no grade is given
};

struct MeasureRequest {
  int which = 1;
  MeasureInput tools{};        ///< absent tools are replaced by default tools
  const Pair* pair = nullptr;  ///< mounted pair, for the active flank; null for a single gear
  std::optional<double> bearing_span{};  ///< L  mm, for the tolerances of the axes
  /// Converts an error to the text of a warning. If it is not set, the error's message is used.
  std::function<std::string(const Error&)> words{};
};

/// Returns all inspection dimensions of a gear. A dimension that cannot be measured is absent. If
/// the tool of such a dimension is not given, one of the warnings `no_chord`, `no_span` and
/// `no_balls` gives the reason. A tool that touches outside the usable flank also causes a warning.
///
/// Errors    `gearN.measure.…` if a given tool does not fit; `gearN.tolerance.quality` if the
///           edition of ISO 1328-1 has no such grade
Result<GearMeasures> measure(const Arranged& arranged, const MeasureRequest& request,
                             std::vector<Warning>& warnings);
Result<GearMeasures> measure(const Gear& gear, const MeasureInput& tools = {});

/// Returns the data of a gear that determine its flank tolerances, without the mating gear.
ToleranceSubject tolerance_subject(const Gear& gear);

}  // namespace gearwright
