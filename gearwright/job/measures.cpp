#include "gearwright/job/measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear_field.hpp"
#include "gearwright/job/interval.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/value_json.hpp"

namespace gearwright {

namespace {

// Where nobody said: the reference diameter if there is usable flank, else the flank's middle.
double default_chord_diameter(const Gear& g) {
  const double d = g.reference_diameter;
  const double end = 2 * g.tip_form_radius();
  const auto form = g.root_form_radius();
  const double begin = form           ? 2 * *form
                       : g.internal() ? g.root_diameter
                                      : g.reference().base_diameter;
  const double lo = std::min(begin, end), hi = std::max(begin, end);
  return d >= lo && d <= hi ? d : 0.5 * (lo + hi);
}

constexpr int kMostSpans = 31;  // more are of gears with hundreds of teeth

// Measures one gear: asked for, a thing that cannot be measured is an error, else a warning.
class Measuring {
 public:
  Measuring(SolvedJob& job, int which, const std::optional<Pair>& pair)
      : job_(job),
        pair_(pair),
        which_(which),
        gear_(job.gear(which)),
        input_(job.spec.gear(which).measure) {}

  Result<MeasureView> all() {
    MeasureView m;
    if (gear_.involute()) m.reference = gear_.reference();
    if (auto error = span(m)) return *error;
    if (auto error = balls(m)) return *error;
    if (auto error = pins(m)) return *error;
    if (auto error = chord(m)) return *error;
    m.constant = constant_chord(gear_);
    m.ranges = evaluation_ranges(gear_);
    const InvolutePair* const mounted = pair_ ? pair_->involute() : nullptr;
    if (m.ranges && mounted) m.ranges->active = active_flank(*mounted, which_);
    if (auto error = tolerances(m)) return *error;
    return m;
  }

 private:
  using Fault = std::optional<Error>;

  Fault missing(bool asked, const Error& error, const char* code, const char* what) {
    const Error here = within(gear_field(which_, "measure"), error);
    if (asked) return here;
    warn(code, std::string(what) + ": " + spelled(here, job_.spec.given).message());
    return std::nullopt;
  }
  void warn(const char* code, std::string message) {
    job_.warnings.push_back({code, std::move(message), which_});
  }

  Fault span(MeasureView& m) {
    m.spans = usable_spans(gear_, kMostSpans);
    m.span = usual_span(gear_);
    if (!input_.span_teeth) {
      if (!m.span && m.reference)
        warn("no_span", "No span: the contacts of none lie on the usable flank, within the face.");
      return std::nullopt;
    }
    const auto asked = span_over(gear_, *input_.span_teeth);
    if (!asked) return within(gear_field(which_, "measure"), asked.error());
    const std::optional<Span> usual = m.span;
    m.span = *asked;
    if (asked->usable()) return std::nullopt;
    const std::string instead =
        usual ? fmt::format("; over {} teeth they do", usual->teeth) : std::string();
    if (asked->place != ContactPlace::usable) {
      warn(
          "span_off_flank",
          fmt::format("Span over {} teeth: the contacts at {} mm do not lie on the usable flank{}.",
                      asked->teeth, format_number(asked->contact_diameter), instead));
    } else {
      warn("span_off_face",
           fmt::format("Span over {} teeth: the contacts lie {} mm apart along the axis, and the "
                       "face is {} mm wide{}.",
                       asked->teeth, format_number(asked->min_face_width, gear_.spec.face_width),
                       format_number(gear_.spec.face_width), usual ? instead + " not" : ""));
    }
    return std::nullopt;
  }

  // The given diameter, or the usual one: the standard size, and the ideal where that does not fit.
  std::optional<Result<BallSeat>> seat(const std::optional<double>& given, MeasureView& m) {
    if (given) return ball_in_space(gear_, *given);
    if (!m.sizes) return std::nullopt;
    auto standard = ball_in_space(gear_, m.sizes->metric);
    if (standard && standard->usable()) return standard;
    return ball_in_space(gear_, m.sizes->ideal);
  }

  void warn_off_flank(const BallSeat& seat, const char* code, const char* what) {
    if (seat.usable()) return;
    warn(code,
         fmt::format("{} of {} mm: the contacts at {} mm do not lie on the usable flank.", what,
                     format_number(seat.ball_diameter), format_number(seat.contact_diameter)));
  }

  Fault balls(MeasureView& m) {
    m.sizes = ball_sizes(gear_);
    const auto found = seat(input_.ball_diameter, m);
    if (!found) {
      if (m.reference)
        warn("no_balls", "No dimension over balls: none rests on the usable flanks.");
      return std::nullopt;
    }
    if (!*found)
      return missing(input_.ball_diameter.has_value(), found->error(), "no_balls",
                     "No dimension over balls");
    const BallSeat& seat = **found;
    m.balls = BallView{seat, over_two_balls(gear_, seat)};
    warn_off_flank(seat, "ball_off_flank", "Balls");
    return std::nullopt;
  }

  Fault pins(MeasureView& m) {
    const bool asked = input_.pin_diameter.has_value();
    if (asked && gear_.internal() && gear_.spec.helix_angle.rad() != 0.0)
      return refused(gear_field(which_, "measure.pin_diameter"), *input_.pin_diameter,
                     "a straight pin does not go into the spaces of an internal helical gear; "
                     "measure between balls");
    auto found = asked ? std::optional(ball_in_space(gear_, *input_.pin_diameter)) : std::nullopt;
    if (found && !*found) {
      Error error = found->error();
      error.field = "pin_diameter";
      return within(gear_field(which_, "measure"), error);
    }
    if (!found && !m.balls) return std::nullopt;
    const BallSeat& seat = found ? **found : m.balls->seat;
    m.pins = PinView{seat, over_pins(gear_, seat)};
    if (asked) warn_off_flank(seat, "pin_off_flank", "Pins");
    return std::nullopt;
  }

  Fault chord(MeasureView& m) {
    const bool asked = input_.chord_diameter.has_value();
    if (!gear_.involute())
      return missing(asked,
                     Error{"chord_diameter", "",
                           "chords are measured on involute flanks; these are circular arcs"},
                     "no_chord", "No chordal thickness");
    const double d = input_.chord_diameter.value_or(default_chord_diameter(gear_));
    const auto chord = chordal_thickness(gear_, d);
    if (!chord) return missing(asked, chord.error(), "no_chord", "No chordal thickness");
    m.chord = ChordView{d, *chord};
    const ToothArc<double> arc = tooth_arc(gear_, d);
    const double s_t = arc.half_angle * d;
    m.thickness =
        ThicknessView{d, s_t, s_t * std::cos(arc.helix_angle), arc.half_angle, arc.helix_angle};
    return std::nullopt;
  }

  Fault tolerances(MeasureView& m) {
    const ToleranceInput& asked = job_.spec.gear(which_).tolerance;
    if (!asked.quality) return std::nullopt;
    if (!has_class(asked.edition, *asked.quality)) {
      const bool in_gear = job_.spec.given.contains(gear_field(which_, "quality"));
      return refused(gear_field(which_, in_gear ? "quality" : "tolerance.quality"), *asked.quality,
                     "ISO 1328-1:2013 has the classes 1 to 11; the edition of 1995 has 0 to 12");
    }
    ToleranceSubject subject = tolerance_subject(gear_);
    const InvolutePair* const mounted = pair_ && !pair_->crossed() ? pair_->involute() : nullptr;
    if (mounted && mounted->flanks_meet()) subject.contact_ratio = mounted->contact_ratio();
    m.tolerances = flank_tolerances(asked.edition, *asked.quality, subject);
    if (!in_range(asked.edition, subject))
      warn("tolerances_out_of_range",
           "The gear lies outside the sizes for which ISO 1328-1 says its tolerances: the formulas "
           "are used all the same.");
    if (mounted) set_axes(*m.tolerances);
    return std::nullopt;
  }

  // The axes of the pair, by the coarser of both gears; the mating gear without a grade has this one's.
  void set_axes(FlankToleranceValues& t) {
    const auto& mounting = job_.spec.rating.input.mounting;
    const auto span = job_.spec.pair.bearing_span ? job_.spec.pair.bearing_span
                      : mounting                  ? std::optional(mounting->bearing_span)
                                                  : std::nullopt;
    if (!span) return;
    const int mate = 3 - which_;
    const ToleranceInput& asked = job_.spec.gear(mate).tolerance;
    double coarser = t.helix_total;
    if (asked.quality && has_class(asked.edition, *asked.quality)) {
      const ToleranceSubject other = tolerance_subject(job_.gear(mate));
      coarser =
          std::max(coarser, flank_tolerances(asked.edition, *asked.quality, other).helix_total);
    }
    const double face = std::min(gear_.spec.face_width, job_.gear(mate).spec.face_width);
    set_axis_tolerances(t, coarser, face, *span);
  }

  SolvedJob& job_;
  const std::optional<Pair>& pair_;
  int which_;
  const Gear& gear_;
  const MeasureInput& input_;
};

// The gears as mounted, where they can be; measuring asks for no pair.
std::optional<Pair> mounted(const SolvedJob& job) {
  if (job.pair || job.gears.size() < 2) return job.pair;
  const auto arranged = arrange(job.completed, Scope::pair);
  return arranged ? arranged->pair : std::nullopt;
}

}  // namespace

Result<std::vector<MeasureView>> measure_gears(SolvedJob& job) {
  std::vector<MeasureView> measures;
  const std::optional<Pair> pair = mounted(job);
  for (int which = 1; which <= static_cast<int>(job.gears.size()); ++which) {
    auto measured = Measuring(job, which, pair).all();
    if (!measured) return measured.error();
    measures.push_back(std::move(measured).take());
  }
  return measures;
}

ToleranceSubject tolerance_subject(const Gear& gear) {
  const CylindricalSpec& s = gear.spec;
  return {gear.reference_diameter,
          s.normal_module,
          s.face_width,
          std::abs(s.teeth),
          s.helix_angle.rad(),
          of_involute(gear, &ReferenceGeometry<double>::transverse_pressure_angle),
          {}};
}

std::vector<ValueRecord> measure_records(const SolvedJob& job) {
  std::vector<ValueRecord> records;
  SolvedJob copy = job;  // its warnings are those of the verb
  for (int which = 1; which <= static_cast<int>(job.gears.size()); ++which) {
    const auto measured = Measuring(copy, which, job.pair).all();
    records.push_back(measured ? measure_quantities().of(*measured) : ValueRecord());
  }
  return records;
}

namespace {

// The gear at one end of its tolerances, under the same tools.
ValueRecord measured_at(const Arranged& end, const JobSpec& spec, std::size_t i,
                        const MeasureView& nominal) {
  SolvedJob job{end, spec};
  MeasureInput& input = job.spec.gears[i]->measure;
  if (nominal.span) input.span_teeth = nominal.span->teeth;
  if (nominal.balls) input.ball_diameter = nominal.balls->seat.ball_diameter;
  if (nominal.pins) input.pin_diameter = nominal.pins->seat.ball_diameter;
  if (nominal.chord) input.chord_diameter = nominal.chord->diameter;
  if (!nominal.pins || !nominal.pins->reading.two_free) input.pin_diameter.reset();
  const auto measured = Measuring(job, static_cast<int>(i) + 1, end.pair).all();
  if (!measured) return {};
  MeasureView view = *measured;
  view.sizes = nominal.sizes;  // balls are bought once
  return measure_quantities().of(view);
}

}  // namespace

std::vector<std::vector<ValueRecord>> measure_end_records(const SolvedJob& job) {
  std::vector<std::vector<ValueRecord>> records;
  SolvedJob copy = job;
  for (std::size_t i = 0; job.ends && i < job.gears.size(); ++i) {
    const auto nominal = Measuring(copy, static_cast<int>(i) + 1, job.pair).all();
    records.push_back(nominal ? differing(measured_at(job.ends->lower, job.spec, i, *nominal),
                                          measured_at(job.ends->upper, job.spec, i, *nominal))
                              : std::vector<ValueRecord>());
  }
  return records;
}

Json measures_json(const SolvedJob& job, const std::vector<MeasureView>& measures,
                   const Verdict& verdict) {
  Json j = job_json(job, verdict);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    Json& measure = j["gears"][i]["measure"];
    measure = to_json(measure_quantities().of(measures[i]));
    if (!job.ends) continue;
    measure["interval"] = interval_json(measured_at(job.ends->lower, job.spec, i, measures[i]),
                                        measured_at(job.ends->upper, job.spec, i, measures[i]));
  }
  return j;
}

std::string measure_listing(const SolvedJob& job, const std::vector<MeasureView>& measures) {
  std::vector<ValueRecord> records;
  for (const MeasureView& m : measures) records.push_back(measure_quantities().of(m));
  const QuantityTable& table = measure_quantities().table();
  std::string text = quantity_listing(table, records, gear_columns(records.size()));
  for (std::size_t i = 0; job.ends && i < measures.size(); ++i)
    text += interval_listing(job, i, table, measured_at(job.ends->lower, job.spec, i, measures[i]),
                             measured_at(job.ends->upper, job.spec, i, measures[i]));
  return text;
}

}  // namespace gearwright
