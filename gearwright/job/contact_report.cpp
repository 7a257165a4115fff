#include "gearwright/job/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/continuous.hpp"

namespace gearwright {

namespace {

// A line contact is narrow in the direction of the profile and long in the direction of the face
// width. The cells of this raster have similar proportions. For modules of a few mm, the gap then
// changes by some hundredths of a µm from node to node and from position to position. This makes
// the border of a pattern almost smooth.
constexpr RasterSize kLines{97, 41};
constexpr RasterSize kPoints{65, 81};
constexpr RasterSize kSmall{17, 33};
constexpr RasterSize kGap{65, 129};
constexpr int kFinePositions = 128;
constexpr int kSmallPositions = 80;
constexpr int kMaxPositions = 1024;  // sufficient for the printed decimals of the transmission
                                     // error

// Returns, for example, "tip relief 15 µm from 64.5 mm, helix crowning 8 µm". The text is empty if
// there are no modifications.
std::string words_of(const FlankModifications& m) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  const auto um = [](double mm) { return fmt::format("{:.6g} µm", kUmPerMm * mm); };
  // Reliefs come first, as on a drawing.
  for (const ModificationEntry& e : modification_entries()) {
    if (!e.relief || !e.placed(m)) continue;
    const Relief& r = m.*(e.relief);
    add(fmt::format("{} {} {} {:.8g} mm{}", e.words, um(r.amount), e.reach_words, *r.reach,
                    r.shape == ReliefShape::parabolic ? ", parabolic" : ""));
  }
  for (const ModificationEntry& e : modification_entries()) {
    if (!e.relief && e.amount_of(m) != 0.0) add(fmt::format("{} {}", e.words, um(e.amount_of(m))));
  }
  if (m.topography) add("topography from a file");
  return text;
}

std::vector<std::string> modifications_of(const SolvedJob& job) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!job.completed.gears[i]) continue;
    const auto& flanks = job.completed.gears[i]->modifications;
    const std::string right = words_of(flanks[0]);
    const std::string left = words_of(flanks[1]);
    if (right == left) {
      if (!right.empty()) list.push_back(fmt::format("gear {}: {}", i + 1, right));
      continue;
    }
    for (const auto& [side, words] : {std::pair("right", right), std::pair("left", left)})
      if (!words.empty()) list.push_back(fmt::format("gear {}, {} flank: {}", i + 1, side, words));
  }
  return list;
}

// Returns the position with contact that is nearest to the middle of the pitch.
std::optional<ContactPoint> middle_of(const std::vector<ContactPoint>& points) {
  std::optional<ContactPoint> best;
  for (const ContactPoint& p : points) {
    if (p.kind == TouchKind::none) continue;
    if (!best || abs(p.rotation1) < abs(best->rotation1)) best = p;
  }
  return best;
}

// True if this error is possible. For some gears, a change of lead is possible only with one sign.
bool can_be(const ContactSetup& setup, std::size_t index, double value) {
  const ErrorEntry& e = error_entries()[index];
  return !e.of_cutter() || !check_cutter_lead(setup.gear(e.gear), e.gear, Angle::degrees(value));
}

// The errors under which a pattern of the report is computed. There is a pattern without errors,
// one for each single error, and one for all errors of the spec together.
struct Under {
  std::string name;
  ContactErrors errors;
  bool as_specified;
};

std::vector<Under> each_error(const SolvedJob& job, const ContactSetup& setup) {
  const auto& value = job.spec.errors.value;
  const auto count = std::count_if(value.begin(), value.end(), [](double v) { return v != 0.0; });
  if (count == 0) return {};
  std::vector<Under> list{{"no error", {}, false}};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (value[i] == 0.0) continue;
    for (const double v : {value[i], -value[i]}) {
      if (v == value[i] && count == 1) continue;  // a single error equals all errors together
      if (!can_be(setup, i, v)) continue;
      const NamedAmount n = named_error(i, v);
      list.push_back({n.name + " " + words_of(n), with_error(setup, {}, i, v), false});
    }
  }
  list.push_back({"as specified", setup.place().errors, true});
  return list;
}

// Each pattern is a separate task, so the result does not depend on the number of threads.
void make_patterns(ContactReport& r, const SolvedJob& job, const ContactSetup& setup) {
  const std::vector<Under> list = each_error(job, setup);
  r.under.resize(list.size());
  const int positions = std::min(r.positions, kMaxPositions);
  const bool of_points = !job.pair->parallel();
  const auto make = [&](std::size_t i) {
    if (i == 0) {
      r.patterns =
          contact_pattern(setup.pair(r.gear2_drives), kFinePositions, of_points ? kPoints : kLines);
      return;
    }
    const Under& u = list[i - 1];
    const ContactPair pair = setup.pair(u.errors, r.gear2_drives);
    auto span = continuous_span(pair, positions);
    if (!span) span = sampled_peak_to_peak(transmission_error(pair, positions));
    r.under[i - 1] = {u.name, contact_pattern(pair, kSmallPositions, kSmall)[0], span,
                      u.as_specified};
  };
  parallel_for(list.size() + 1, make);
}

ContactReport report_of(const FlankContact& flanks, const RasterSize& size) {
  ContactReport r;
  static_cast<ContactScene&>(r) = flanks;
  r.patterns = flanks.pattern(kFinePositions, size);
  r.middle = middle_of(r.driving.positions);
  if (r.middle) r.middle_gap = flanks.gap(*r.middle, kGap);
  return r;
}

// True if the positions of the answer are equally spaced over one pitch, as the report requires. If
// they are not, the contact is computed again for the report.
bool fits_report(const ContactInput& input) {
  return input.rotations.empty() && input.pitches == 1;
}

Result<ContactReport> report_of_halves(const SolvedJob& job, const ContactAnswer& given) {
  const ContactInput& input = job.spec.contact;
  std::optional<ContactAnswer> over_pitch;
  if (!fits_report(input)) {
    SolvedJob again = job;  // a copy, because the warnings of `job` have already been reported
    again.spec.contact.map.reset();
    again.spec.contact.rotations.clear();
    again.spec.contact.pitches = 1;
    auto made = answer_contact(again);
    if (!made) return made.error();
    over_pitch = std::move(made).take();
  }
  const ContactAnswer& answer = over_pitch ? *over_pitch : given;
  auto setup = setup_of(job, errors_of(job));
  if (!setup) return setup.error();
  const HalvesSetup halves(*setup, job.halves[0]->given.stagger_pitches);
  const bool gear2_drives = input.driver == 2;
  const HalvesPair pair = halves.pair(setup->place().errors, gear2_drives);
  const std::array<const Gear*, 2> gears = job.flanked_gears();
  ContactReport r;
  static_cast<ContactScene&>(r) =
      contact_scene(gears, *pair.half[0], input.marking, answer.driving);
  r.other = answer.other;
  r.span[1] =
      continuous_span(halves.pair(setup->place().errors, !gear2_drives).mesh, input.positions);
  r.min_play = given.min_play;
  for (const FlankContact& half : flanks_of(gears, pair, input.marking,
                                            {&answer.halves[0].driving, &answer.halves[1].driving}))
    r.halves.push_back(report_of(half, job.pair->parallel() ? kLines : kPoints));
  return r;
}

// Adds the facts that the report states beside its pictures.
void add_assumptions(ContactReport& r, const SolvedJob& job, const ContactAnswer& answer) {
  for (std::size_t i = 0; i < kErrorCount; ++i)
    if (job.spec.errors.value[i] != 0.0)
      r.errors.push_back(named_error(i, job.spec.errors.value[i]));
  r.modifications = modifications_of(job);
  r.span[0] = answer.continuous_span;
  if (answer.map) {
    const auto& key = job.spec.contact.map->key;
    const auto& value = job.spec.errors.value;
    r.map = ContactMap{*answer.map,
                       {named_error(key[0], value[key[0]]), named_error(key[1], value[key[1]])}};
  }
  if (job.pair) r.arc_pair = job.pair->arcs();
}

ContactReport report_of(const SolvedJob& job, const ContactAnswer& answer) {
  const ContactInput& input = job.spec.contact;
  const bool gear2_drives = input.driver == 2;
  const ContactPair pair = answer.setup->pair(gear2_drives);
  ContactReport r;
  static_cast<ContactScene&>(r) =
      contact_scene(job.flanked_gears(), pair, input.marking, answer.driving);
  r.positions = input.positions;
  r.other = answer.other;
  if (!fits_report(input)) {
    const ContactRequest pitch{input.positions, 1, input.marking};
    r.driving = analyse_contact(pair, pitch);
    r.other = analyse_contact(answer.setup->pair(!gear2_drives), pitch);
  }
  r.span[1] = continuous_span(answer.setup->pair(!gear2_drives), input.positions);
  r.min_play = answer.min_play;
  make_patterns(r, job, *answer.setup);
  r.middle = middle_of(r.driving.positions);
  if (r.middle) r.middle_gap = gap_map(pair, r.middle->rotation1, r.middle->pair, kGap);
  return r;
}

// Only the flank of the pinion is drawn.
Result<ContactReport> report_of_rack(const SolvedJob& job, const ContactAnswer& answer) {
  ContactOptions options = rack_options(job, nullptr);
  options.request.rotations.clear();
  options.request.pitches = 1;
  options.request.influences.clear();
  const auto pair = contact_pair(*job.rack, errors_of(job), options);
  if (!pair) return pair.error();
  const bool fits = fits_report(job.spec.contact);
  ContactReport r =
      report_of({contact_scene(job.flanked_gears(), **pair, job.spec.contact.marking,
                               fits ? answer.driving : analyse_contact(**pair, options.request)),
                 *pair},
                kLines);
  r.min_play = answer.min_play;
  options.gear2_drives = !options.gear2_drives;
  const auto other = contact_pair(*job.rack, errors_of(job), options);
  if (!other) return other.error();
  r.other = fits ? answer.other : analyse_contact(**other, options.request);
  r.span[1] = continuous_span(**other, options.request.positions);
  return r;
}

}  // namespace

std::array<FlankRaster, 2> FlankContact::pattern(int positions, const RasterSize& size) const {
  std::array<FlankRaster, 2> both = contact_pattern(*pair, positions, size);
  if (below)
    for (FlankRaster& raster : both) raster = in_mirror(raster);
  return both;
}

FlankRaster FlankContact::gap(const ContactPoint& at, const RasterSize& size) const {
  FlankRaster raster = gap_map(*pair, at.rotation1 + behind, at.pair, size);
  return below ? in_mirror(raster) : raster;
}

std::vector<FlankContact> flanks_of(const std::array<const Gear*, 2>& gears, const HalvesPair& pair,
                                    double marking,
                                    const std::array<const ContactResult*, 2>& results) {
  std::vector<FlankContact> flanks;
  for (const std::size_t i : {0, 1}) {
    if (i == 1 && pair.mesh.alike()) break;
    flanks.push_back({contact_scene(gears, *pair.half[i], marking, *results[i]), pair.half[i]});
  }
  if (flanks.size() == 1) return flanks;
  FlankContact& second = flanks.back();
  second.below = true;
  second.behind = pair.mesh.behind();
  second.part = "-2";
  mirror_axes(second);
  return flanks;
}

NamedAmount named_error(std::size_t index, double value) {
  const ErrorEntry& e = error_entries()[index];
  return {std::string(e.words), value, std::string(unit_text(unit_of(e.key)))};
}

bool wants_contact(const SolvedJob& job) {
  if (!job.mounted()) return false;
  // Circular arcs touch at points. Such a pair is chosen for its contact ellipse and its pattern,
  // so both are always reported.
  return job.spec.errors.given || job.spec.contact.given || !modifications_of(job).empty() ||
         (job.pair && job.pair->arcs());
}

Result<std::optional<ContactPart>> contact_part(SolvedJob& job, Progress* progress) {
  if (!wants_contact(job)) return std::optional<ContactPart>();
  auto made = answer_contact(job, progress);
  if (!made) {
    // If the teeth of the nominal pair do not touch, no single number of the spec is wrong. The
    // warning therefore omits the key and the value of the error.
    if (!without_contact(made.error())) return made.error();
    const Error why = spelled(made.error(), job.spec.given);
    const bool whole_pair = made.error().kind == FailureKind::nothing_touches;
    const std::string reason = whole_pair ? why.rule : why.message();
    job.warnings.push_back(
        {WarningCode::no_contact, "The contact analysis cannot be computed: " + reason + ".", 0});
    return std::optional<ContactPart>();
  }
  ContactAnswer answer = std::move(made).take();
  auto pictures = job.halves[0] ? report_of_halves(job, answer)
                  : job.rack    ? report_of_rack(job, answer)
                                : Result(report_of(job, answer));
  if (!pictures) return pictures.error();
  ContactReport report = std::move(pictures).take();
  add_assumptions(report, job, answer);
  if (!any_contact(report.driving)) {
    job.warnings.push_back(
        {WarningCode::no_contact,
         "There is no contact analysis, because no teeth touch at any position of a pitch.", 0});
    return std::optional<ContactPart>();
  }
  return std::optional(ContactPart{std::move(answer), std::move(report)});
}

}  // namespace gearwright
