#include "gearwright/job/contact_answer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/fillet_contact.hpp"
#include "gearwright/contact/halves.hpp"

namespace gearwright {

namespace {

template <class Curve>
ErrorMap make_map(const ContactMapInput& m, const Curve& te_at, Progress* progress) {
  const auto& [x, y] = m.range;
  return map_of_errors(evenly_spaced(x[0], x[1], m.points[0]),
                       evenly_spaced(y[0], y[1], m.points[1]), te_at, 0, progress);
}

ContactErrors errors_at(const ContactSetup& setup, const ContactMapInput& m, double x, double y) {
  const ContactErrors e = with_error(setup, setup.place().errors, m.key[0], x);
  return with_error(setup, e, m.key[1], y);
}

void warn_of_fillet(const FilletContact& touch, const ContactSetup& setup, bool other,
                    std::vector<Warning>& warnings) {
  const auto modified = [&](bool left) {
    const RemovalField* removal = setup.removal(touch.gear, left);
    return removal && !removal->none();
  };
  const char* as_cut = modified(false) || modified(true)
                           ? " This result is for the fillet as cut. In CAD files, the fillet "
                             "follows the modified flank, which can remove this contact."
                           : "";
  warnings.push_back(
      {WarningCode::fillet_contact,
       fmt::format("Under these errors, the tip of gear {0} and the root fillet of gear {1} touch "
                   "when the {3}flanks are still {2:.4g} mm apart. {6}. The contact is at the "
                   "rotation {4:.3f}° of gear 1 and on a diameter of {5:.4f} mm.{7}",
                   3 - touch.gear, touch.gear, touch.early, other ? "non-working " : "",
                   touch.point.rotation1.deg(), touch.point.diameter[touch.gear - 1],
                   other ? "The backlash is reduced by this distance of the flanks"
                         : "The flanks do not determine the transmission error at this position",
                   as_cut),
       touch.gear});
}

// If the flanks of an internal pair overlap by more than this fraction of a pitch, the gears jam
// even if the fillets do not touch. The fillets are then not examined, because many teeth overlap
// and the computation can take half a minute.
constexpr double kDeepOverlap = 0.05;

// Adds a warning if, under the errors, a tip meets a root fillet before the flanks touch. Without
// errors, the comparison of the outlines finds such a contact, [T2.34] and [T4.33].
void warn_about_fillets(const ContactAnswer& answer, const ContactInput& input,
                        std::vector<Warning>& warnings, Progress* progress) {
  const Gear& gear_2 = answer.setup->gear(2);
  const double pitch = 2 * std::numbers::pi / std::abs(gear_2.spec.teeth);
  if (gear_2.internal() && answer.min_play && answer.min_play->rad() < -kDeepOverlap * pitch)
    return;
  const bool gear2_drives = input.driver == 2;
  const auto driving_outlines = answer.setup->outlines(gear2_drives);
  const auto other_outlines = answer.setup->outlines(!gear2_drives);
  if (!driving_outlines || !other_outlines) {
    warnings.push_back(
        {WarningCode::fillets_not_asked,
         "Contact of tips with root fillets under these errors was not checked. If the lead of the "
         "cutter is changed, this check is available only for roots cut by a rack, not for roots "
         "cut by a pinion cutter or for circular fillets."});
    return;
  }
  // If the positions are equally spaced, only those of the first pitch are examined, because the
  // contact repeats in every pitch.
  const auto first_pitch = [&](std::span<const ContactPoint> positions) {
    return input.rotations.empty() ? positions.first(static_cast<std::size_t>(input.positions))
                                   : positions;
  };
  const auto driving =
      fillet_contacts(*driving_outlines, first_pitch(answer.driving.positions), progress);
  const auto other =
      fillet_contacts(*other_outlines, first_pitch(answer.other.positions), progress);
  if (driving.earliest) warn_of_fillet(*driving.earliest, *answer.setup, false, warnings);
  if (other.earliest) warn_of_fillet(*other.earliest, *answer.setup, true, warnings);
  if (!driving.earliest && !other.earliest) return;
  std::optional<Angle> least;
  for (std::size_t i = 0, j = 0; i < driving.asked.size() && j < other.asked.size();) {
    if (driving.asked[i] == other.asked[j]) {
      const auto play = play_between(driving.whole[i], other.whole[j], gear2_drives);
      if (play) least = std::min(least.value_or(*play), *play);
    }
    driving.asked[i] < other.asked[j] ? ++i : ++j;
  }
  // If the flanks jam, the pair already has a warning.
  const bool flanks_jam = answer.min_play && *answer.min_play < Angle();
  if (least && !flanks_jam)
    warn_of_jam(*least, answer.setup->gear(2), {}, "root fillets and flanks are", warnings);
}

// Returns the contact of the working and of the non-working flanks at the positions of the input.
// Derivatives are computed only for the working flanks.
template <class MeshOf>
auto both_flanks(const SolvedJob& job, const MeshOf& mesh, Progress* progress) {
  const ContactInput& input = job.spec.contact;
  ContactRequest request = input;
  request.progress = progress;
  ContactRequest other = request;
  for (const NamedInfluence& i : influences_of(job)) request.influences.push_back(i.influence);
  const bool gear2_drives = input.driver == 2;
  return std::array{analyse_contact(mesh(gear2_drives), request),
                    analyse_contact(mesh(!gear2_drives), other)};
}

// Returns the answer for the pair in `setup`. `found` is the contact of its working and of its
// non-working flanks. The map and the pattern are computed if `input` requests them.
Result<ContactAnswer> answer_of(const SolvedJob& job, ContactSetup setup,
                                std::array<ContactResult, 2> found, const ContactInput& input,
                                std::vector<Warning>& warnings, Progress* progress) {
  ContactAnswer answer{{}, std::move(setup)};
  const bool gear2_drives = input.driver == 2;
  answer.driving = std::move(found[0]);
  answer.other = std::move(found[1]);
  if (!any_contact(answer.driving)) return nothing_touches(*answer.setup);
  answer.min_play = least_play(answer.driving, answer.other, gear2_drives);
  answer.continuous_span = continuous_span(answer.setup->pair(gear2_drives), input.positions);
  if (input.map) {
    const auto te_at = [&](double x, double y) {
      const ContactErrors errors = errors_at(*answer.setup, *input.map, x, y);
      return transmission_error(answer.setup->pair(errors, gear2_drives), input.positions);
    };
    answer.map = make_map(*input.map, te_at, progress);
  }
  if (input.pattern)
    answer.pattern =
        contact_pattern(answer.setup->pair(gear2_drives), input.positions, {}, progress);
  warn_of_contact(answer.driving, answer.other, answer.min_play,
                  {&answer.setup->gear(1), &answer.setup->gear(2)}, warnings);
  if (job.spec.errors.any()) warn_about_fillets(answer, input, warnings, progress);
  return answer;
}

// Returns the error for a pinion and a rack that touch at no position.
Error no_touch_of_rack(const RackPair& rack, const ContactErrors& errors) {
  const bool exact = errors == ContactErrors();
  const double distance = rack.center_distance + errors.center_distance;
  const double tip = rack.pinion.actual_tip_radius(), addendum = rack.rack.addendum;
  const std::string why =
      distance >= tip + addendum
          ? fmt::format(
                "the datum line of the rack is {:.6g} mm from the axis of the pinion, but "
                "the tip radius of {:.6g} mm and the addendum of {:.6g} mm reach only "
                "{:.6g} mm",
                distance, tip, addendum, tip + addendum)
          : "no flank of the pinion lies opposite a flank of the rack at any position";
  return {exact ? "pair.center_distance" : "errors",
          exact ? format_number(rack.center_distance) : "",
          fmt::format("no teeth touch, because {}; {} or an overlap of the faces would help", why,
                      exact ? "a smaller centre distance" : "smaller errors"),
          FailureKind::nothing_touches};
}

Result<ContactAnswer> answer_of_rack(SolvedJob& job, Progress* progress) {
  const ContactInput& input = job.spec.contact;
  if (input.map) return Error{"contact.map", "", "needs two gears, but gear 2 is a rack"};
  auto contacts = contact(*job.rack, errors_of(job), rack_options(job, progress));
  if (!contacts) return contacts.error();
  RackContact found = std::move(contacts).take();
  if (!any_contact(found)) return no_touch_of_rack(*job.rack, errors_of(job));
  ContactAnswer answer{};
  if (input.pattern) answer.pattern = contact_pattern(*found.pair, input.positions, {}, progress);
  answer.min_play = found.min_play;
  answer.continuous_span = found.continuous_span;
  answer.other = std::move(found.non_working);
  answer.driving = std::move(found);
  warn_of_contact(answer.driving, answer.other, answer.min_play, {&job.gears.front()},
                  job.warnings);
  return answer;
}

Result<ContactAnswer> answer_of_halves(SolvedJob& job, const HalvesSetup& setup,
                                       Progress* progress) {
  ContactInput input = job.spec.contact;
  const bool drives_2 = input.driver == 2;
  const auto map = std::exchange(input.map, std::nullopt);
  const ContactSetup& half = setup.half(false);
  const ContactErrors& errors = half.place().errors;
  const std::array pairs{setup.pair(errors, false), setup.pair(errors, true)};
  auto [driving, other] = both_flanks(
      job, [&](bool gear2_drives) -> const HalvesMesh& { return pairs[gear2_drives].mesh; },
      progress);
  ContactAnswer whole{{}, half};
  whole.on_halves = driving.on_halves();
  auto first = answer_of(job, half, {std::move(driving.half[0]), std::move(other.half[0])}, input,
                         job.warnings, progress);
  if (!first) return first.error();
  std::vector<Warning> of_second;
  auto image = answer_of(job, setup.half(true), {std::move(driving.image), std::move(other.image)},
                         input, of_second, progress);
  if (!image) return image.error();
  add_new(std::move(of_second), job.warnings, kSecondHalf);
  ContactAnswer second = std::move(image).take();
  second.driving = std::move(driving.half[1]);
  second.other = std::move(other.half[1]);
  if (second.pattern)
    for (FlankRaster& raster : *second.pattern) raster = in_mirror(raster);
  whole.driving = std::move(driving.whole);
  whole.float_axial = std::move(driving.float_axial);
  whole.other = std::move(other.whole);
  whole.min_play = least_play(whole.driving, whole.other, drives_2);
  whole.continuous_span = continuous_span(pairs[drives_2].mesh, input.positions);
  if (map) {
    const auto te_at = [&](double x, double y) {
      const HalvesPair at = setup.pair(errors_at(half, *map, x, y), drives_2);
      return transmission_error(at.mesh, input.positions);
    };
    whole.map = make_map(*map, te_at, progress);
  }
  whole.halves = {std::move(first).take(), std::move(second)};
  return whole;
}

}  // namespace

ContactOptions rack_options(const SolvedJob& job, Progress* progress) {
  const ContactInput& input = job.spec.contact;
  ContactOptions options;
  options.modifications[0] = job.completed.gear(1).modifications;
  options.gear2_drives = input.driver == 2;
  options.request = input;
  for (const NamedInfluence& i : influences_of(job))
    options.request.influences.push_back(i.influence);
  options.request.progress = progress;
  return options;
}

Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress) {
  const auto analysed = [&]() -> Result<ContactAnswer> {
    if (job.rack) return answer_of_rack(job, progress);
    auto setup = setup_of(job, errors_of(job));
    if (!setup) return setup.error();
    if (job.halves[0])
      return answer_of_halves(job, {*setup, job.halves[0]->given.stagger_pitches}, progress);
    auto found = both_flanks(
        job, [&](bool gear2_drives) { return setup->pair(gear2_drives); }, progress);
    return answer_of(job, std::move(setup).take(), std::move(found), job.spec.contact, job.warnings,
                     progress);
  };
  auto made = analysed();
  if (!made) return made;
  ContactAnswer answer = std::move(made).take();
  const ContactInput& input = job.spec.contact;
  const auto add_names = [&](ContactView& view) {
    view.marking = input.marking;
    for (const NamedInfluence& i : influences_of(job)) view.slopes.push_back(i);
  };
  add_names(answer);
  for (ContactView& half : answer.halves) add_names(half);
  for (const std::size_t i : {0, 1})
    if (input.map) answer.map_axes[i] = error_entries()[input.map->key[i]].key;
  return answer;
}

bool any_contact(const ContactResult& result) {
  return std::any_of(result.positions.begin(), result.positions.end(),
                     [](const ContactPoint& p) { return p.kind != TouchKind::none; });
}

ContactErrors errors_of(const SolvedJob& job) {
  if (!job.mounted()) return {};
  // An error of the rack's teeth is rejected later. The pinion may therefore take the place of the
  // rack in this call.
  return job.spec.errors.of({&job.gears.front(), &job.gears.back()});
}

Result<ContactSetup> setup_of(const SolvedJob& job) {
  if (auto error = one_helix_error(job)) return *error;
  return setup_of(job, errors_of(job));
}

ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value) {
  error_entries()[index].set(errors, setup.gears(), value);
  return errors;
}

std::vector<NamedInfluence> influences_of(const SolvedJob& job) {
  std::vector<NamedInfluence> list;
  const auto gears = static_cast<int>(job.gears.size());  // without a rack
  for (const ErrorEntry& e : error_entries()) {
    if (e.kind && e.gear <= gears)
      list.push_back({{fmt::format("{}_per_{}", e.name(), e.unit()), e.si()}, {*e.kind}});
  }
  for (int which = 1; which <= gears; ++which) {
    const auto& flanks = job.completed.gear(which).modifications;
    if (!any_modification(flanks)) continue;
    for (const ModificationEntry& m : modification_entries()) {
      if (!m.placed(flanks[0]) && !m.placed(flanks[1])) continue;
      list.push_back({{fmt::format("gear{}_{}_per_um", which, m.name), kMmPerUm},
                      {ErrorKind::center_distance, which, m.kind}});
    }
  }
  return list;
}

}  // namespace gearwright
