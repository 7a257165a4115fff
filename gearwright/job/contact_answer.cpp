#include "gearwright/job/contact_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/modification_keys.hpp"
#include "gearwright/contact/fillet_contact.hpp"
#include "gearwright/contact/pair_contact.hpp"
#include "gearwright/contact/recut.hpp"
#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

bool any_modification(const GearInput& gear) {
  for (const FlankModifications& m : gear.modifications) {
    if (m.topography) return true;
    for (const ModificationEntry& e : modification_entries())
      if (e.relief ? e.placed(m) : e.amount_of(m) != 0.0) return true;
  }
  return false;
}

// Tips that pass each other, or why else no tooth finds another.
std::string why_nothing_touches(const ContactSetup& setup, const ContactErrors& errors) {
  const double r1 = setup.gear(1).actual_tip_radius();
  const double r2 = setup.gear(2).actual_tip_radius();
  const double a = setup.place().center_distance + errors.center_distance;
  if (!setup.gear(2).internal() && a >= r1 + r2) {
    return fmt::format(
        "the axes stand {:.6g} mm apart and the tip radii reach {:.6g} mm: the teeth pass each "
        "other; reduce `errors.center_distance` or `pair.center_distance`",
        a, r1 + r2);
  }
  return fmt::format(
      "at no position does a flank of gear 1 lie inside one of gear 2 (centre distance {:.6g} mm, "
      "tip radii {:.6g} and {:.6g} mm): smaller errors, or faces that overlap, would help",
      a, r1, r2);
}

}  // namespace

Error nothing_touches(const ContactSetup& setup) {
  return {"errors", "", "nothing touches; " + why_nothing_touches(setup, setup.place().errors)};
}

Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors) {
  return {"compensate.range", name, "nothing touches there; " + why_nothing_touches(setup, errors)};
}

ContactErrors ContactSetup::with_error(ContactErrors e, std::size_t index, double value) const {
  error_entries()[index].set(e, {gears_[0].get(), gears_[1].get()}, value);
  return e;
}

const RemovalField* ContactSetup::removal(int gear, bool left) const {
  return removal_[gear - 1][left ? 1 : 0].get();
}

ContactPair ContactSetup::pair(const ContactErrors& errors, bool gear2_drives) const {
  ContactMount place = place_;
  place.errors = errors;
  place.gear2_drives = gear2_drives;
  return at(place);
}

ContactPair ContactSetup::at(const ContactMount& place) const {
  const auto of = [&](int i) {
    return ContactGear{gears_[i].get(), {removal_[i][0].get(), removal_[i][1].get()}};
  };
  return ContactPair(of(0), of(1), place);
}

std::optional<ContactPair> ContactSetup::outlines(bool gear2_drives) const {
  for (int i = 0; i < 2; ++i) {
    const double delta_lambda = place_.errors.cutter_lead[i].rad();
    if (delta_lambda != 0.0 && !recut_outline(*gears_[i], delta_lambda)) return std::nullopt;
  }
  ContactMount place = place_;
  place.gear2_drives = gear2_drives;
  place.fillets = true;
  return at(place);
}

std::optional<int> ContactSetup::convex_gear() const {
  for (int i = 0; i < 2; ++i) {
    const auto* arc = std::get_if<ArcRack>(&gears_[i]->spec.rack);
    if (!arc) return std::nullopt;
    if (arc->cutter == ArcRack::Cutter::F) return i + 1;
  }
  return std::nullopt;
}

Result<ContactSetup> ContactSetup::changed(const SetupChange& change) const {
  ContactSetup setup = *this;
  for (int i = 0; i < 2; ++i) {
    setup.place_.errors.cutter_lead[i] += change.cutter_lead[i];
    const SetupChange::Flank& f = change.flank[i];
    if (f.lead_slope == 0.0 && f.lead_crowning == 0.0 && f.profile_slope == 0.0 &&
        f.profile_crowning == 0.0)
      continue;
    // The flanks that touch: right ones of external gears when gear 1 drives.
    const bool left = change.left != (i == 1 && gears_[1]->internal());
    for (int side = 0; side < 2; ++side) {
      FlankModifications& m = setup.modifications_[i][side];
      m.lead_crowning += f.lead_crowning;
      m.profile_crowning += f.profile_crowning;
      if (left == (side == 1)) {
        m.lead_slope += f.lead_slope;
        m.profile_slope += f.profile_slope;
      }
      auto field = make_removal_field(m, flank_extent(*gears_[i]));
      if (!field) return of_flank(i + 1, side, field.error());
      setup.removal_[i][side] = std::make_shared<const RemovalField>(std::move(field).take());
    }
  }
  if (change.tool_setting != 0.0) {
    const auto which = convex_gear();
    GW_EXPECTS(which.has_value());
    CylindricalSpec spec = gears_[*which - 1]->spec;
    auto* rack = std::get_if<ArcRack>(&spec.rack);
    GW_EXPECTS(rack != nullptr);
    rack->center_b += change.tool_setting / spec.normal_module;
    rack->pressure_angle.reset();  // a check of the drawing's setting
    auto gear = make_gear(spec);
    if (!gear) return of_gear(*which, gear.error());
    if (!gear->exists() || !gear->root_form_radius())
      return Error{"compensate.corrections", "tool_setting_mm",
                   "this tool setting leaves no tooth"};
    setup.gears_[*which - 1] = std::make_shared<const Gear>(std::move(gear).take());
  }
  return setup;
}

Result<ContactSetup> ContactSetup::of(const SolvedJob& job) {
  ContactSetup setup;
  GW_EXPECTS(job.pair.has_value());
  setup.place_.center_distance = job.pair->center_distance();
  setup.place_.shaft_angle = job.pair->shaft_angle();
  for (const int i : {0, 1}) setup.gears_[i] = std::make_shared<const Gear>(job.pair->gear(i + 1));
  for (std::size_t i = 0; i < kErrorCount; ++i)
    setup.place_.errors = setup.with_error(setup.place_.errors, i, job.spec.errors.value[i]);
  for (int i = 0; i < 2; ++i) {
    const Gear& gear = setup.gear(i + 1);
    const auto form = gear.root_form_radius();
    if (!form) {
      return Error{gear_field(i + 1), "",
                   "has no usable flank to touch with; see its warnings (gearwright gear)"};
    }
    if (auto error = check_cutter_lead(gear, i + 1, setup.place_.errors.cutter_lead[i]))
      return *error;
    const GearInput& input = *job.spec.gears[i];
    setup.modifications_[i] = input.modifications;
    if (!any_modification(input)) continue;
    for (int side = 0; side < 2; ++side) {
      auto field = make_removal_field(input.modifications[side], flank_extent(gear));
      if (!field) return of_flank(i + 1, side, field.error());
      setup.removal_[i][side] = std::make_shared<const RemovalField>(std::move(field).take());
    }
  }
  for (const ErrorEntry& e : error_entries()) {
    if (e.kind)
      setup.influences_.push_back(
          {fmt::format("{}_per_{}", e.name(), e.unit()), e.si(), {*e.kind}});
  }
  for (int i = 0; i < 2; ++i) {
    const GearInput& input = *job.spec.gears[i];
    if (!any_modification(input)) continue;
    for (const ModificationEntry& m : modification_entries()) {
      if (!m.placed(input.modifications[0]) && !m.placed(input.modifications[1])) continue;
      setup.influences_.push_back({fmt::format("gear{}_{}_per_um", i + 1, m.name),
                                   kMmPerUm,
                                   {ErrorKind::center_distance, i + 1, m.parameter}});
    }
  }
  return setup;
}

namespace {

std::vector<double> spread(const std::array<double, 2>& range, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(range[0] + (range[1] - range[0]) * (static_cast<double>(i) / (n - 1)));
  return values;
}

ErrorMap make_map(const ContactSetup& setup, const ContactMapInput& m, int positions,
                  bool gear2_drives, Headway* headway) {
  const auto pair_at = [&](double x, double y) {
    ContactErrors e = setup.with_error(setup.place().errors, m.key[0], x);
    return setup.pair(setup.with_error(e, m.key[1], y), gear2_drives);
  };
  return map_of_errors(spread(m.range[0], m.points[0]), spread(m.range[1], m.points[1]), pair_at,
                       positions, 0, headway);
}

void warn_of_jam(Angle least_play, const char* touched, std::vector<Warning>& warnings) {
  constexpr Angle kTouching = Angle::radians(1e-12);  // teeth without backlash do not jam
  if (!(least_play < -kTouching)) return;
  warnings.push_back({"jam",
                      fmt::format("The gears jam: {} touched at once, gear 2 would have to give "
                                  "way by {:.6f} degrees.",
                                  touched, -least_play.deg()),
                      0});
}

// What the answer says that the numbers alone do not.
void warn_about(const ContactAnswer& answer, std::vector<Warning>& warnings) {
  const auto warn = [&](const char* code, std::string text, int gear = 0) {
    warnings.push_back({code, std::move(text), gear});
  };
  std::array<bool, 2> below{};
  for (const ContactPoint& p : answer.driving.positions) {
    below[0] = below[0] || p.kind == TouchKind::form1;
    below[1] = below[1] || p.kind == TouchKind::form2;
  }
  for (int i = 0; i < 2; ++i) {
    const Gear& gear = answer.setup.gear(i + 1);
    if (!below[i] || gear.undercut) continue;
    warn("contact_below_form",
         fmt::format(
             "Contact reaches the end of gear {}'s usable flank, {:.4f} mm diameter, where "
             "the tooth goes on as a root fillet: the mating gear's tip works into it, and the "
             "transmission error there is less than the true one.",
             i + 1, 2 * *gear.root_form_radius()),
         i + 1);
  }
  if (answer.driving.contact_lost)
    warn("contact_lost", "Contact is lost at some positions: no tooth pair touches there.");
  if (answer.min_play) warn_of_jam(*answer.min_play, "both flanks of a tooth space are", warnings);
  if (answer.driving.unfinished + answer.other.unfinished > 0) {
    warn("contact_search_unfinished",
         fmt::format("{} searches for a contact point did not end; their positions took the next "
                     "best one.",
                     answer.driving.unfinished + answer.other.unfinished));
  }
}

void warn_of_fillet(const FilletContact& touch, bool other, std::vector<Warning>& warnings) {
  warnings.push_back(
      {"fillet_contact",
       fmt::format("Under these errors the tip of gear {} meets the root fillet of gear {} {:.4g} "
                   "mm before the {}flanks do, at {:.3f}° of gear 1, on {:.4f} mm diameter: {}.",
                   3 - touch.gear, touch.gear, touch.early, other ? "non-working " : "",
                   touch.point.rotation1.deg(), touch.point.diameter[touch.gear - 1],
                   other ? "it takes that much of the play"
                         : "the transmission error is not that of the flanks there"),
       touch.gear});
}

// Gear 1 keeps gear 2 ahead of one angle and behind the other: what lies between.
std::optional<Angle> play_between(const ContactPoint& driving, const ContactPoint& behind,
                                  bool gear2_drives) {
  if (driving.kind == TouchKind::none || behind.kind == TouchKind::none) return std::nullopt;
  return (gear2_drives ? -1.0 : 1.0) * (behind.te - driving.te);
}

// Without errors the two outlines say it, [T2.34] and [T4.33].
void warn_about_fillets(const ContactAnswer& answer, const ContactInput& input,
                        std::vector<Warning>& warnings, Headway* headway) {
  const bool gear2_drives = input.driver == 2;
  const auto driving_outlines = answer.setup.outlines(gear2_drives);
  const auto other_outlines = answer.setup.outlines(!gear2_drives);
  if (!driving_outlines || !other_outlines) {
    warnings.push_back(
        {"fillets_not_asked",
         "Whether a tip meets a root fillet under these errors was not looked at: with a changed "
         "lead of the cutter that is done for roots that a rack cuts, not for those of a pinion "
         "cutter or circular fillets."});
    return;
  }
  // A pitch is like the other; of several at once those that are looked at might be of one phase.
  const auto first_pitch = [&](std::span<const ContactPoint> positions) {
    return input.rotations.empty() ? positions.first(static_cast<std::size_t>(input.positions))
                                   : positions;
  };
  const auto driving =
      fillet_contacts(*driving_outlines, first_pitch(answer.driving.positions), headway);
  const auto other = fillet_contacts(*other_outlines, first_pitch(answer.other.positions), headway);
  if (driving.earliest) warn_of_fillet(*driving.earliest, false, warnings);
  if (other.earliest) warn_of_fillet(*other.earliest, true, warnings);
  if (!driving.earliest && !other.earliest) return;
  std::optional<Angle> least;
  for (std::size_t i = 0, j = 0; i < driving.asked.size() && j < other.asked.size();) {
    if (driving.asked[i] == other.asked[j]) {
      const auto play = play_between(driving.whole[i], other.whole[j], gear2_drives);
      if (play) least = std::min(least.value_or(*play), *play);
    }
    driving.asked[i] < other.asked[j] ? ++i : ++j;
  }
  // Where the flanks alone jam that has been said.
  const bool flanks_jam = answer.min_play && *answer.min_play < Angle();
  if (least && !flanks_jam) warn_of_jam(*least, "root fillets and flanks are", warnings);
}

}  // namespace

Result<ContactAnswer> answer_contact(SolvedJob& job, Headway* headway) {
  auto made = ContactSetup::of(job);
  if (!made) return made.error();
  ContactAnswer answer{std::move(made).take(), {}, {}, std::nullopt, std::nullopt, std::nullopt};
  const ContactInput& input = job.spec.contact;
  const bool gear2_drives = input.driver == 2;
  ContactRequest request{input.positions, input.pitches, input.marking};
  request.rotations = input.rotations;
  request.headway = headway;
  ContactRequest other = request;
  for (const NamedInfluence& i : answer.setup.influences())
    request.influences.push_back(i.influence);
  answer.driving = analyse_contact(answer.setup.pair(gear2_drives), request);
  answer.other = analyse_contact(answer.setup.pair(!gear2_drives), other);
  const auto touches = [](const ContactPoint& p) { return p.kind != TouchKind::none; };
  const auto& positions = answer.driving.positions;
  if (std::none_of(positions.begin(), positions.end(), touches))
    return nothing_touches(answer.setup);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto play = play_between(positions[i], answer.other.positions[i], gear2_drives);
    if (play) answer.min_play = std::min(answer.min_play.value_or(*play), *play);
  }
  if (input.map)
    answer.map = make_map(answer.setup, *input.map, input.positions, gear2_drives, headway);
  if (input.pattern)
    answer.pattern = contact_pattern(answer.setup.pair(gear2_drives), input.positions, {}, headway);
  warn_about(answer, job.warnings);
  if (job.spec.errors.any()) warn_about_fillets(answer, input, job.warnings, headway);
  return answer;
}

}  // namespace gearwright
