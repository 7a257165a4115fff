#include "gearwright/job/contact_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/fillet_contact.hpp"

namespace gearwright {

namespace {

constexpr int kLeastPositions = 32;  // per pitch; least number for the continuous curve

std::vector<double> spread(const std::array<double, 2>& range, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(range[0] + (range[1] - range[0]) * (static_cast<double>(i) / (n - 1)));
  return values;
}

ErrorMap make_map(const ContactSetup& setup, const ContactMapInput& m, int positions,
                  bool gear2_drives, Progress* progress) {
  const auto pair_at = [&](double x, double y) {
    ContactErrors e = with_error(setup, setup.place().errors, m.key[0], x);
    return setup.pair(with_error(setup, e, m.key[1], y), gear2_drives);
  };
  return map_of_errors(spread(m.range[0], m.points[0]), spread(m.range[1], m.points[1]), pair_at,
                       positions, 0, progress);
}

void warn_of_jam(Angle least_play, const char* touched, std::vector<Warning>& warnings) {
  constexpr Angle kTouching = Angle::radians(1e-12);  // teeth without backlash do not jam
  if (!(least_play < -kTouching)) return;
  warnings.push_back({WarningCode::jam,
                      fmt::format("The gears jam: {} in contact at once, and gear 2 would have to "
                                  "yield by {:.6f} degrees.",
                                  touched, -least_play.deg()),
                      0});
}

// Warnings that the numbers alone do not show.
void warn_about(const ContactAnswer& answer, std::vector<Warning>& warnings) {
  const auto warn = [&](WarningCode code, std::string text, int gear = 0) {
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
    warn(WarningCode::contact_below_form,
         fmt::format(
             "Contact reaches the end of the usable flank of gear {}, {:.4f} mm diameter, where "
             "the root fillet begins. The tip of the mating gear enters the fillet, and the true "
             "transmission error there is larger than the computed one.",
             i + 1, 2 * *gear.root_form_radius()),
         i + 1);
  }
  if (answer.driving.contact_lost)
    warn(WarningCode::contact_lost,
         "Contact is lost at some positions, where no tooth pair touches.");
  if (answer.min_play) warn_of_jam(*answer.min_play, "both flanks of a tooth space are", warnings);
  if (answer.driving.unfinished + answer.other.unfinished > 0) {
    warn(WarningCode::contact_search_unfinished,
         fmt::format("{} searches for a contact point did not converge; their positions use the "
                     "best point found.",
                     answer.driving.unfinished + answer.other.unfinished));
  }
}

void warn_of_fillet(const FilletContact& touch, bool other, std::vector<Warning>& warnings) {
  warnings.push_back(
      {WarningCode::fillet_contact,
       fmt::format("Under these errors the tip of gear {} meets the root fillet of gear {} {:.4g} "
                   "mm before the {}flanks do, at {:.3f}° of gear 1, on {:.4f} mm diameter: {}.",
                   3 - touch.gear, touch.gear, touch.early, other ? "non-working " : "",
                   touch.point.rotation1.deg(), touch.point.diameter[touch.gear - 1],
                   other ? "this reduces the backlash by that amount"
                         : "the transmission error there does not come from the flanks"),
       touch.gear});
}

// Gear 1 limits gear 2 from both sides. The play is the difference.
std::optional<Angle> play_between(const ContactPoint& driving, const ContactPoint& behind,
                                  bool gear2_drives) {
  if (driving.kind == TouchKind::none || behind.kind == TouchKind::none) return std::nullopt;
  return (gear2_drives ? -1.0 : 1.0) * (behind.te - driving.te);
}

// Without errors, the outlines determine it, [T2.34] and [T4.33].
void warn_about_fillets(const ContactAnswer& answer, const ContactInput& input,
                        std::vector<Warning>& warnings, Progress* progress) {
  const bool gear2_drives = input.driver == 2;
  const auto driving_outlines = answer.setup.outlines(gear2_drives);
  const auto other_outlines = answer.setup.outlines(!gear2_drives);
  if (!driving_outlines || !other_outlines) {
    warnings.push_back(
        {WarningCode::fillets_not_asked,
         "Contact of tips with root fillets under these errors was not checked. With a changed "
         "lead of the cutter, this check is available for roots cut by a rack, not for those of a "
         "pinion cutter or circular fillets."});
    return;
  }
  // All pitches are equal, and the examined positions of several pitches might have the same phase.
  const auto first_pitch = [&](std::span<const ContactPoint> positions) {
    return input.rotations.empty() ? positions.first(static_cast<std::size_t>(input.positions))
                                   : positions;
  };
  const auto driving =
      fillet_contacts(*driving_outlines, first_pitch(answer.driving.positions), progress);
  const auto other =
      fillet_contacts(*other_outlines, first_pitch(answer.other.positions), progress);
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
  // If the flanks alone jam, a warning exists already.
  const bool flanks_jam = answer.min_play && *answer.min_play < Angle();
  if (least && !flanks_jam) warn_of_jam(*least, "root fillets and flanks are", warnings);
}

}  // namespace

Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress) {
  auto made = setup_of(job);
  if (!made) return made.error();
  ContactAnswer answer{std::move(made).take(), {}, {}, {}, {}, {}, {}};
  const ContactInput& input = job.spec.contact;
  const bool gear2_drives = input.driver == 2;
  ContactRequest request{input.positions, input.pitches, input.marking};
  request.rotations = input.rotations;
  request.progress = progress;
  ContactRequest other = request;
  for (const NamedInfluence& i : influences_of(job)) request.influences.push_back(i.influence);
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
  answer.continuous_span =
      continuous_span(answer.setup.pair(gear2_drives), std::max(kLeastPositions, input.positions));
  if (input.map)
    answer.map = make_map(answer.setup, *input.map, input.positions, gear2_drives, progress);
  if (input.pattern)
    answer.pattern =
        contact_pattern(answer.setup.pair(gear2_drives), input.positions, {}, progress);
  warn_about(answer, job.warnings);
  if (job.spec.errors.any()) warn_about_fillets(answer, input, job.warnings, progress);
  return answer;
}

}  // namespace gearwright
