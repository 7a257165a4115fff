#include "gearwright/arrange/measured_gear.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

// Returns the default measuring diameter. It is the reference diameter if this diameter lies on the
// usable flank, or if there is no usable flank. Otherwise, it is the diameter in the middle of the
// flank.
double default_chord_diameter(const Gear& g) {
  const double d = g.reference_diameter;
  const auto flank = usable_flank(g);
  return !flank || flank->contains(d) ? d : flank->middle();
}

constexpr int kMostSpans = 31;  // a gear with more usable spans has hundreds of teeth

// Measures a gear with all tools. If a given tool does not fit, the result is an error. If a
// default tool does not fit, there is only a warning.
class Measuring {
 public:
  Measuring(const Arranged& arranged, const MeasureRequest& request, std::vector<Warning>& warnings)
      : arranged_(arranged),
        request_(request),
        warnings_(warnings),
        which_(request.which),
        gear_(arranged.gear(request.which)),
        input_(request.tools) {}

  Result<GearMeasures> all() {
    GearMeasures m;
    if (gear_.involute()) m.reference = gear_.reference();
    if (auto error = span(m)) return *error;
    if (auto error = balls(m)) return *error;
    if (auto error = pins(m)) return *error;
    if (auto error = chord(m)) return *error;
    m.constant = constant_chord(gear_);
    m.ranges = evaluation_ranges(gear_);
    const InvolutePair* const mounted = request_.pair ? request_.pair->involute() : nullptr;
    if (m.ranges && mounted) m.ranges->active = active_flank(*mounted, which_);
    if (auto error = tolerances(m)) return *error;
    return m;
  }

 private:
  using Fault = std::optional<Error>;

  Fault missing(bool asked, const Error& error, WarningCode code, const char* what) {
    const Error here = within(gear_field(which_, "measure"), error);
    if (asked) return here;
    warn(code, fmt::format("{}: {}", what, request_.words ? request_.words(here) : here.message()));
    return std::nullopt;
  }
  void warn(WarningCode code, std::string message) {
    warnings_.push_back({code, std::move(message), which_});
  }

  Fault span(GearMeasures& m) {
    m.spans = usable_spans(gear_, kMostSpans);
    m.span = usual_span(gear_);
    if (!input_.span_teeth) {
      if (!m.span && m.reference)
        warn(WarningCode::no_span,
             std::string("No span can be measured, because ") +
                 (straight_tools_fit(gear_)
                      ? "for every number of spanned teeth the contacts are not on the usable "
                        "flank or not on the face"
                      : kNoPlaneAnvils) +
                 ".");
      note_narrow_face(m);
      return std::nullopt;
    }
    const auto asked = span_over(gear_, *input_.span_teeth);
    if (!asked) return within(gear_field(which_, "measure"), asked.error());
    const std::optional<Span> usual = m.span;
    m.span = *asked;
    if (asked->usable()) {
      note_narrow_face(m);
      return std::nullopt;
    }
    const std::string instead =
        usual ? fmt::format("; over {} teeth, the contacts lie on the usable flank", usual->teeth)
              : std::string();
    if (asked->place != ContactPlace::usable) {
      warn(WarningCode::span_off_flank,
           fmt::format("In a span over {} teeth, the contacts lie on a diameter of {} mm, which is "
                       "not on the usable flank{}.",
                       asked->teeth, format_number(asked->contact_diameter), instead));
    } else {
      warn(
          WarningCode::span_off_face,
          fmt::format(
              "In a span over {} teeth, the contacts lie {} mm apart along the axis, which is "
              "more than the face width of {} mm{}.",
              asked->teeth, format_number(asked->min_face_width, gear_.spec.face_width),
              format_number(gear_.spec.face_width),
              usual ? fmt::format("; over {} teeth, the contacts lie within the face", usual->teeth)
                    : ""));
    }
    return std::nullopt;
  }

  // Adds a note if the face width is less than measuring practice requires for the span. In
  // this case, the anvils rest on too little of the helical flank.
  void note_narrow_face(const GearMeasures& m) {
    const double b = gear_.spec.face_width;
    if (!m.span || m.span->min_face_width == 0.0 || practical_face_width(gear_, *m.span) <= b)
      return;
    std::optional<Span> enough;
    for (const Span& s : m.spans)
      if (s.teeth < m.span->teeth && practical_face_width(gear_, s) <= b) enough = s;
    warn(WarningCode::span_off_face,
         fmt::format(
             "In a span over {} teeth, the contacts overlap the face by only {:.3f} mm. Measuring "
             "practice requires a face width of {:.2f} mm, but the face width is {} mm.{}",
             m.span->teeth, b - m.span->min_face_width, practical_face_width(gear_, *m.span),
             format_number(b),
             enough ? fmt::format(" For a span over {} teeth, a face width of {:.2f} mm is "
                                  "sufficient.",
                                  enough->teeth, practical_face_width(gear_, *enough))
                    : " Measure over balls."));
  }

  // Returns the seat of a ball with the given diameter. If no diameter is given, the ball has the
  // standard size, or the ideal size if no ball of a standard size fits.
  std::optional<Result<BallSeat>> seat(const std::optional<double>& given, GearMeasures& m) {
    if (given) return ball_in_space(gear_, *given);
    if (!m.sizes) return std::nullopt;
    auto standard = ball_in_space(gear_, m.sizes->metric);
    if (standard && standard->usable()) return standard;
    return ball_in_space(gear_, m.sizes->ideal);
  }

  void warn_off_flank(const BallSeat& seat, WarningCode code, const char* what) {
    if (seat.usable()) return;
    warn(code,
         fmt::format(
             "The contacts of {} of {} mm lie on a diameter of {} mm, which is not on the usable "
             "flank.",
             what, format_number(seat.ball_diameter), format_number(seat.contact_diameter)));
  }

  Fault balls(GearMeasures& m) {
    m.sizes = ball_sizes(gear_);
    const auto found = seat(input_.ball_diameter, m);
    if (!found) {
      if (m.reference)
        warn(WarningCode::no_balls,
             "There is no dimension over balls, because no ball touches the usable flanks.");
      return std::nullopt;
    }
    if (!*found && input_.ball_diameter)
      return within(gear_field(which_, "measure"), found->error());
    if (!*found) {
      warn(
          WarningCode::no_balls,
          fmt::format("There is no dimension over balls, because no ball of a standard size can be "
                      "measured, and a ball of {} mm {}.",
                      format_number(m.sizes->ideal), found->error().rule));
      return std::nullopt;
    }
    const BallSeat& seat = **found;
    m.balls = BallMeasure{seat, over_two_balls(gear_, seat)};
    warn_off_flank(seat, WarningCode::ball_off_flank, "balls");
    return std::nullopt;
  }

  Fault pins(GearMeasures& m) {
    const bool asked = input_.pin_diameter.has_value();
    if (asked && !straight_tools_fit(gear_))
      return refused(gear_field(which_, "measure.pin_diameter"), *input_.pin_diameter,
                     "a straight pin does not fit into the tooth spaces of an internal helical "
                     "gear; measure between balls");
    auto found = asked ? std::optional(ball_in_space(gear_, *input_.pin_diameter)) : std::nullopt;
    if (found && !*found) {
      Error error = found->error();
      error.field = "pin_diameter";
      return within(gear_field(which_, "measure"), error);
    }
    if (!found && !m.balls) return std::nullopt;
    const BallSeat& seat = found ? **found : m.balls->seat;
    m.pins = PinMeasure{seat, over_pins(gear_, seat)};
    if (asked) warn_off_flank(seat, WarningCode::pin_off_flank, "pins");
    const double b = gear_.spec.face_width;
    if (const auto& needed = m.pins->reading.two_free_face; needed && *needed > b)
      warn(WarningCode::pin_off_flank,
           fmt::format("The dimension over two pins of {} mm cannot be measured with pins that may "
                       "tilt, because the contacts need a face width of {} mm, but the face width "
                       "is {} mm. Measure over balls, or between parallel anvils.",
                       format_number(seat.ball_diameter), format_number(*needed, b),
                       format_number(b)));
    return std::nullopt;
  }

  Fault chord(GearMeasures& m) {
    const bool asked = input_.chord_diameter.has_value();
    if (!m.reference)
      return missing(
          asked,
          Error{"chord_diameter", "", "needs involute flanks, but these flanks are circular arcs"},
          WarningCode::no_chord, "There is no chordal thickness");
    const double d = input_.chord_diameter.value_or(default_chord_diameter(gear_));
    const auto chord = chordal_thickness(gear_, d);
    if (!chord)
      return missing(asked, chord.error(), WarningCode::no_chord, "There is no chordal thickness");
    m.chord = ChordMeasure{d, *chord};
    const ToothArc<double> arc = tooth_arc(gear_, d);
    const double s_t = arc.half_angle * d;
    m.thickness =
        ThicknessAt{d, s_t, s_t * std::cos(arc.helix_angle), arc.half_angle, arc.helix_angle};
    return std::nullopt;
  }

  Fault tolerances(GearMeasures& m) {
    const ToleranceInput& asked = arranged_.completed.gear(which_).tolerance;
    if (!asked.quality) return std::nullopt;
    if (!has_class(asked.edition, *asked.quality)) {
      return refused(gear_field(which_, "tolerance.quality"), *asked.quality, kClassesOfEditions);
    }
    ToleranceSubject subject = tolerance_subject(gear_);
    const ParallelPair* const mounted = request_.pair ? request_.pair->parallel() : nullptr;
    if (mounted && mounted->flanks_meet()) subject.contact_ratio = mounted->contact_ratio();
    m.tolerances = flank_tolerances(asked.edition, *asked.quality, subject);
    if (const std::string beyond = beyond_range(asked.edition, subject); !beyond.empty())
      warn(WarningCode::tolerances_out_of_range,
           "The gear lies outside the range of sizes of ISO 1328-1, because the " + beyond +
               ". The formulas of the standard are used nevertheless.");
    if (mounted) set_axes(*m.tolerances);
    return std::nullopt;
  }

  // Sets the tolerances of the axes of the pair. The tolerances are computed from the greater of
  // the helix tolerances of both gears. If the mating gear has no grade, the helix tolerance of
  // this gear is used.
  void set_axes(FlankToleranceValues& t) {
    if (!request_.bearing_span) return;
    const int mate = 3 - which_;
    const ToleranceInput& asked = arranged_.completed.gear(mate).tolerance;
    double coarser = t.helix_total;
    if (asked.quality && has_class(asked.edition, *asked.quality)) {
      const ToleranceSubject other = tolerance_subject(arranged_.gear(mate));
      coarser =
          std::max(coarser, flank_tolerances(asked.edition, *asked.quality, other).helix_total);
    }
    const double face = std::min(gear_.spec.face_width, arranged_.gear(mate).spec.face_width);
    set_axis_tolerances(t, coarser, face, *request_.bearing_span);
  }

  const Arranged& arranged_;
  const MeasureRequest& request_;
  std::vector<Warning>& warnings_;
  int which_;
  const Gear& gear_;
  const MeasureInput& input_;
};

}  // namespace

Result<GearMeasures> measure(const Arranged& arranged, const MeasureRequest& request,
                             std::vector<Warning>& warnings) {
  return Measuring(arranged, request, warnings).all();
}

Result<GearMeasures> measure(const Gear& gear, const MeasureInput& tools) {
  Arranged alone{GivenPair()};
  alone.completed.gears[0].emplace();
  alone.gears.push_back(gear);
  std::vector<Warning> warnings;
  return measure(alone, {.tools = tools}, warnings);
}

ToleranceSubject tolerance_subject(const Gear& gear) {
  const CylindricalSpec& s = gear.spec;
  return {
      gear.reference_diameter,
      s.normal_module,
      s.face_width,
      std::abs(s.teeth),
      s.helix_angle.rad(),
      gear.involute() ? std::optional(gear.reference().transverse_pressure_angle) : std::nullopt,
      {}};
}

}  // namespace gearwright
