// All that a workshop measures of a gear: span, balls, pins, chords, the flanks' tolerances.
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
#include "gearwright/inspection/constant_chord.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright {

struct ChordMeasure {
  double diameter;  ///< mm, at which the jaws touch
  ChordalThickness<double> chord;
};

struct BallMeasure {
  BallSeat seat;
  double dimension;  ///< M_d  mm, over or between two
};

struct PinMeasure {
  BallSeat seat;
  PinReading reading;
};

struct ThicknessAt {
  double diameter;    ///< d_y  mm
  double transverse;  ///< s_yt  mm, arc
  double normal;      ///< s_yn  mm, arc
  double half_angle;  ///< rad
  double helix;       ///< β_y  rad, signed
};

/// All that is measured of one gear; what it does not have is none.
struct GearMeasures {
  std::optional<Span> span;
  std::vector<Span> spans;  ///< usable ones
  std::optional<BallMeasure> balls;
  std::optional<PinMeasure> pins;
  std::optional<BallSizes> sizes;
  std::optional<ChordMeasure> chord;
  std::optional<ConstantChord> constant;
  std::optional<ThicknessAt> thickness;
  std::optional<ReferenceGeometry<double>> reference;  ///< of an involute gear
  std::optional<EvaluationRanges> ranges;
  std::optional<FlankToleranceValues> tolerances;  ///< with a grade
};

/// Which gear, with which tools, and what is known besides.
struct MeasureRequest {
  int which = 1;
  MeasureInput tools{};                  ///< absent: the usual ones
  const Pair* pair = nullptr;            ///< as mounted, for the active flank; null: alone
  std::optional<double> bearing_span{};  ///< L  mm, for the tolerances of the axes
  /// Words of an error inside a warning; empty: its message.
  std::function<std::string(const Error&)> words{};
};

/// What a gear does not have is none and, where its tool was not given, a warning: `no_chord`,
/// `no_span`, `no_balls`; a contact that is off the usable flank is a warning too.
///
/// Errors    `gearN.measure.…`: a tool that was given and does not fit
Result<GearMeasures> measure(const Arranged& arranged, const MeasureRequest& request,
                             std::vector<Warning>& warnings);
Result<GearMeasures> measure(const Gear& gear, const MeasureInput& tools = {});

/// What tolerances of flanks depend on; without the mating gear.
ToleranceSubject tolerance_subject(const Gear& gear);

}  // namespace gearwright
