#include "gearwright/scatter/tolerance.hpp"

#include <cmath>

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/scatter/uneven_teeth.hpp"

namespace gearwright {

namespace {

void add_error(Deviation& d, const ContactSetup& setup, VaryingError error, double by) {
  ContactErrors& e = d.errors;
  const auto twist = [&](int which) {
    const Gear& gear = setup.gear(which);
    return by / (gear.reference_diameter / 2 * gear.spec.face_width);
  };
  switch (error) {
    case VaryingError::center_distance: e.center_distance += by; break;
    case VaryingError::crossing: e.crossing += Angle::radians(by); break;
    case VaryingError::intersecting: e.intersecting += Angle::radians(by); break;
    case VaryingError::axial: e.axial += by; break;
    case VaryingError::helix_slope1: e.helix_twist[0] += twist(1); break;
    case VaryingError::helix_slope2: e.helix_twist[1] += twist(2); break;
    case VaryingError::cutter_lead1: e.cutter_lead[0] += Angle::radians(by); break;
    case VaryingError::cutter_lead2: e.cutter_lead[1] += Angle::radians(by); break;
  }
}

// Adds the effect of one bore, with the other bore in its nominal position. [T14.12]
void add_bore(ContactErrors& e, const VaryingBore& bore, double x, double y) {
  const double sign = bore.far_end ? 1.0 : -1.0;
  const double in_plane = sign * x / bore.span;
  e.intersecting += Angle::radians(in_plane);
  e.crossing += Angle::radians(sign * y / bore.span);
  e.center_distance -= 0.5 * x + bore.offset * in_plane;
}

FormWave& wave_of(FlankModifications& flank, const VaryingWave& w) {
  return w.along_face ? flank.helix_wave : flank.profile_wave;
}

void add(Deviation& d, const ContactSetup& setup, const ScatterTolerance& tolerance,
         std::span<const double> x) {
  const double by = tolerance.unit * x[0];
  std::visit(
      Overloaded{[&](VaryingError error) { add_error(d, setup, error, by); },
                 [&](VaryingThickness t) { d.thickness[t.gear - 1] += by; },
                 [&](VaryingModification m) {
                   if (by == 0.0) return;
                   d.modified = true;
                   for (auto& flank : d.modifications[m.gear - 1])
                     member_of(m.parameter).amount_of(flank) += by;
                 },
                 [&](const VaryingBore& b) { add_bore(d.errors, b, by, tolerance.unit * x[1]); },
                 [&](const VaryingPitch& p) {
                   d.pitch[p.gear - 1] =
                       uneven_pitch(setup.gear(p.gear), p, by, x[1] * kRadPerDeg, x[2]);
                 },
                 [&](const VaryingWave& w) {
                   d.modified = true;
                   for (auto& flank : d.modifications[w.gear - 1])
                     wave_of(flank, w) = {static_cast<int>(std::lround(x[0])), x[1] * kRadPerDeg,
                                          tolerance.unit * w.height};
                 }},
      tolerance.of);
}

Deviation as_drawn(const ContactSetup& setup) {
  return {setup.place().errors, setup.modifications(), false, {}, {}};
}

}  // namespace

const char* ScatterTolerance::of_grade() const {
  const auto* wave = std::get_if<VaryingWave>(&of);
  return !wave ? "" : wave->along_face ? ", f_fβ of the grade" : ", f_fα of the grade";
}

int ScatterTolerance::coordinates() const {
  if (std::holds_alternative<VaryingPitch>(of)) return 3;
  return bore() || std::holds_alternative<VaryingWave>(of) ? 2 : 1;
}

std::array<double, 3> ScatterTolerance::at(std::span<const double> u) const {
  if (bore()) {
    const auto [x, y] = in_disc(distribution.greatest(), u[0], u[1]);
    return {x, y, 0.0};
  }
  if (std::holds_alternative<VaryingPitch>(of)) return {distribution.at(u[0]), 360.0 * u[1], u[2]};
  if (const auto* w = std::get_if<VaryingWave>(&of)) {
    const double choices = w->waves[1] - w->waves[0] + 1;
    return {w->waves[0] + std::floor(choices * u[0]), 360.0 * u[1], 0.0};
  }
  return {distribution.at(u[0]), 0.0, 0.0};
}

std::array<double, 2> ScatterTolerance::side(int coordinate) const {
  if (const auto* w = std::get_if<VaryingWave>(&of); w && coordinate == 0)
    return {static_cast<double>(w->waves[0]), static_cast<double>(w->waves[1])};
  if (bore() || coordinate == 0) return {distribution.least(), distribution.greatest()};
  const bool share = std::holds_alternative<VaryingPitch>(of) && coordinate == 2;
  return {0.0, share ? 1.0 : 360.0};
}

bool ScatterTolerance::has_score(int coordinate) const {
  if (const auto* w = std::get_if<VaryingWave>(&of))
    return coordinate == 0 && w->waves[0] < w->waves[1];
  return !(std::holds_alternative<VaryingPitch>(of) && coordinate == 1);
}

int coordinates_of(std::span<const ScatterTolerance> tolerances) {
  int sum = 0;
  for (const ScatterTolerance& t : tolerances) sum += t.coordinates();
  return sum;
}

std::vector<std::string> coordinate_names(std::span<const ScatterTolerance> tolerances) {
  std::vector<std::string> names;
  for (const ScatterTolerance& t : tolerances) {
    std::vector<const char*> endings{""};
    if (t.bore()) endings = {".x_mm", ".y_mm"};
    if (std::holds_alternative<VaryingPitch>(t.of))
      endings = {".share", ".phase_deg", ".eccentric"};
    if (std::holds_alternative<VaryingWave>(t.of)) endings = {".waves", ".phase_deg"};
    for (const char* ending : endings) names.push_back(t.name + ending);
  }
  return names;
}

Deviation deviation_at(const ContactSetup& setup, std::span<const ScatterTolerance> tolerances,
                       std::span<const double> x) {
  GW_EXPECTS(static_cast<int>(x.size()) == coordinates_of(tolerances));
  Deviation d = as_drawn(setup);
  std::size_t at = 0;
  for (const ScatterTolerance& t : tolerances) {
    add(d, setup, t, x.subspan(at));
    at += static_cast<std::size_t>(t.coordinates());
  }
  return d;
}

std::optional<Error> check_ends(const ContactSetup& setup,
                                std::span<const ScatterTolerance> tolerances) {
  const auto refuse = [](const ScatterTolerance& tolerance, double end, const Error& error) {
    return Error{tolerance.name, format_number(end),
                 "this end of the range leads to " + error.quoted()};
  };
  for (const ScatterTolerance& t : tolerances) {
    if (const auto* w = std::get_if<VaryingWave>(&t.of))
      for (FlankModifications flank : setup.modifications()[static_cast<std::size_t>(w->gear - 1)])
        if (wave_of(flank, *w).waves > 0)
          return Error{t.name, "",
                       "cannot vary, because a flank can have only one wave in this direction, and "
                       "the modifications of the gear already contain one; leave out either this "
                       "tolerance or that wave"};
    for (const double end : t.side(0)) {
      Deviation d = as_drawn(setup);
      add(d, setup, t, std::array{end, 0.0, 0.0});
      for (const int which : {1, 2}) {
        const Angle lead = d.errors.cutter_lead[which - 1];
        if (auto error = check_cutter_lead(setup.gear(which), which, lead))
          return refuse(t, end, *error);
      }
      if (!d.modified) continue;
      const auto made = setup.with_modifications(d.modifications);
      if (!made) return refuse(t, end, made.error());
    }
  }
  return std::nullopt;
}

std::optional<GradedFlank> graded_flank(const Gear& gear, FlankTolerances edition, int quality) {
  GW_EXPECTS(has_class(edition, quality));
  const auto ranges = evaluation_ranges(gear);
  if (!ranges) return std::nullopt;
  const FlankToleranceValues t = flank_tolerances(edition, quality, tolerance_subject(gear));
  const double profile = std::abs((ranges->tip_form.length - ranges->root_form.length) /
                                  (ranges->profile[1] - ranges->profile[0]));
  const double helix = std::abs(gear.spec.face_width / (ranges->helix[1] - ranges->helix[0]));
  return GradedFlank{kMmPerUm * t.profile_slope * profile,
                     kMmPerUm * t.helix_slope * helix,
                     kMmPerUm * t.profile_form,
                     kMmPerUm * t.helix_form,
                     kMmPerUm * t.cumulative_pitch,
                     kMmPerUm * t.single_pitch,
                     kMmPerUm * t.helix_total};
}

GradedAxes graded_axes(double greater_helix_total, double face_width) {
  return {0.5 * greater_helix_total / face_width, greater_helix_total / face_width};
}

}  // namespace gearwright
