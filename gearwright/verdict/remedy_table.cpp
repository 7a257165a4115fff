#include "gearwright/verdict/remedy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright::detail {

namespace {

using A = Adjustable;
using C = WarningCode;
using W = Whose;

const std::vector<Means> kGearGrows{
    {A::thickness_allowance, W::own, +1}, {A::profile_shift, W::own, +1}, {A::teeth, W::own, +1}};
const std::vector<Means> kReachLess{{A::tip_diameter, W::mate, -1},
                                    {A::profile_shift, W::own, +1},
                                    {A::center_distance, W::pair, +1},
                                    {A::profile_shift, W::mate, -1}};
const std::vector<Means> kThinTip{{A::tip_diameter, W::own, -1}, {A::profile_shift, W::own, -1}};
const std::vector<Means> kOwnTipShorter{{A::tip_diameter, W::own, -1},
                                        {A::center_distance, W::pair, +1}};
const std::vector<Means> kLooser{{A::center_distance, W::pair, +1},
                                 {A::thickness_allowance, W::first, -1},
                                 {A::thickness_allowance, W::second, -1}};
const std::vector<Means> kLongerContact{
    {A::profile_shift, W::first, +1},  {A::profile_shift, W::second, +1},
    {A::tip_diameter, W::first, +1},   {A::tip_diameter, W::second, +1},
    {A::center_distance, W::pair, -1}, {A::profile_shift, W::first, -1},
    {A::profile_shift, W::second, -1}, {A::center_distance, W::pair, +1},
    {A::face_width, W::pair, +1}};

constexpr const char* kContactRatio = "the contact ratio is {:.3f}";
constexpr const char* kBacklash = "the backlash is {:.4f} mm in the normal section";

const std::vector<Cure>& cures() {
  static const std::vector<Cure> kAll{
      {C::through_axis, "{} can be cut", kGearGrows},
      {C::severed, "the teeth of {} are not cut off at their roots", kGearGrows},
      {C::no_flank,
       "{} has a usable flank",
       {{A::profile_shift, W::own, +1}, {A::tip_diameter, W::own, +1}, {A::teeth, W::own, +1}}},
      {C::no_body, "{} has a body", {{A::bore, W::own, -1}}},
      {C::no_contact, kContactRatio, kLongerContact},
      {C::contact_ratio, kContactRatio, kLongerContact},
      {C::negative_backlash, kBacklash, kLooser},
      {C::interference, "the flanks stay clear of each other", kLooser},
      {C::contact_off_flank,
       "the teeth touch on their flanks",
       {{A::center_distance, W::pair, +1}, {A::center_distance, W::pair, -1}}},
      {C::root, "the tip stays clear of the root of {}", kReachLess},
      {C::base_tangent, "contact stays on the involute of {}", kReachLess},
      {C::form_circle, "contact stays on the usable flank of {}", kReachLess},
      {C::tip_to_fillet, "the tip corner stays clear of the root fillet of {}", kReachLess},
      {C::trochoid,
       "the tips pass each other",
       {{A::tip_diameter, W::first, -1}, {A::tip_diameter, W::second, -1}}},
      {C::overlap,
       "the teeth do not overlap",
       {{A::tip_diameter, W::mate, -1},
        {A::tip_diameter, W::own, -1},
        {A::profile_shift, W::own, +1},
        {A::center_distance, W::pair, +1}}},
      {C::beyond_flank,
       "the teeth touch only on their flanks",
       {{A::tip_diameter, W::mate, -1},
        {A::tip_diameter, W::own, -1},
        {A::profile_shift, W::own, +1},
        {A::center_distance, W::pair, +1}}},
      {C::contact_lost_to_undercut, "undercut removes no part of the path of contact on {}",
       kGearGrows},
      {C::undercut, "{} is not undercut", kGearGrows},
      {C::thin_rim, "the rim of {} is thick enough", {{A::bore, W::own, -1}}},
      {C::no_tip_clearance, "the tip of {} has clearance", kOwnTipShorter},
      {C::tip_margin, "the tip clearance of {} is large enough", kOwnTipShorter},
      {C::form_margin, "the form clearance of {} is large enough", kReachLess},
      {C::fillet_margin, "the clearance to the fillet of {} is large enough", kReachLess},
      {C::pointed, "{} is not pointed", kThinTip},
      {C::thin_tip, "the tip of {} is thick enough", kThinTip},
      {C::tip_below_base,
       "the tip of {} lies outside its base circle",
       {{A::tip_diameter, W::own, -1}}},
      {C::saddle_gap,
       "the flanks stay clear of each other beside the line of action",
       {{A::lead_crowning, W::first, +1}, {A::lead_crowning, W::second, +1}}},
      {C::nearly_parallel, "the axes are parallel", {{A::helix_angle, W::second, +1}}},
      {C::face_width, "the face of {} contains the line of action", {{A::face_width, W::own, +1}}},
      {C::jam, "the gears do not jam", kLooser, true},
      {C::contact_below_form, "contact stays on the usable flank of {}", kReachLess, true},
      {C::fillet_contact, "the tips stay clear of the root fillets", kReachLess, true},
      {C::edge_contact,
       "no edge is in contact",
       {{A::lead_slope, W::first, +1},
        {A::lead_crowning, W::first, +1},
        {A::tip_diameter, W::first, -1}},
       true},
      {C::contact_place,
       "the contact lies in the middle of the face",
       {{A::lead_slope, W::first, +1}},
       true},
  };
  return kAll;
}

int gear_of(Whose whose, int own) {
  switch (whose) {
    case W::own: return own;
    case W::mate: return 3 - own;
    case W::first: return 1;
    case W::second: return 2;
    case W::pair: return 0;
  }
  return 0;
}

// Returns the smallest profile shift without undercut, or none if the gear is not undercut. The
// profile shift and the thickness allowance together determine the position of the cutter, so the
// effect of the allowance is subtracted.
std::optional<double> shift_without_undercut(const Gear& gear) {
  const auto least = gear.undercut_free_shift();
  if (!gear.undercut || !least) return std::nullopt;
  const CylindricalSpec& s = gear.spec;
  return *least -
         s.thickness_allowance / (2 * s.normal_module * std::tan(s.normal_pressure_angle.rad()));
}

// Returns the number of decimals for lengths in mm. One unit of the last decimal is about 10^−more
// modules.
int digits_for(double module, int more) {
  return std::clamp(more - static_cast<int>(std::round(std::log10(module))), 0, 9);
}

std::optional<Lever> lever_of(const Means& means, const Finding& finding, const Judged& judged) {
  int which = gear_of(means.whose, finding.gear);
  // With a rack, only the face width of the pinion can be changed.
  if (which == 0 && means.what == A::face_width && judged.gears.size() == 1) which = 1;
  // No number of the rack is changed, so the pinion is changed instead.
  if (judged.rack && means.whose == W::own && which == 2) which = 1;
  // A finding of the pair has no own gear and no mating gear.
  const bool of_pair = finding.gear == 0 && (means.whose == W::own || means.whose == W::mate);
  if (of_pair || which > static_cast<int>(judged.gears.size())) return std::nullopt;
  const auto gear = [&](int n) -> const Gear& {
    GW_EXPECTS(n >= 1 && n <= static_cast<int>(judged.gears.size()));
    return *judged.gears[n - 1];
  };
  const double m = gear(1).spec.normal_module;
  const double outward = which > 0 ? gear(which).side() : 1.0;
  const InvolutePair* p = judged.pair ? judged.pair->involute() : nullptr;
  Lever lever{means.what, which, 0.0, means.direction, 0.0, 2};
  switch (means.what) {
    case A::profile_shift:
      if (!gear(which).involute()) return std::nullopt;
      lever.now = gear(which).spec.profile_shift;
      lever.span = 1.5;
      if (means.direction > 0) lever.hint = shift_without_undercut(gear(which));
      return lever;
    case A::tip_diameter:
      lever.now = gear(which).tip_diameter;
      lever.direction *= static_cast<int>(outward);
      lever.span = 2 * m;
      if (gear(which).pointed())
        lever.span += std::abs(lever.now - 2 * gear(which).actual_tip_radius());
      lever.digits = digits_for(m, 2);
      if (p && means.direction < 0) lever.hint = tip_that_clears(*p, which);
      return lever;
    case A::thickness_allowance:
      lever.now = gear(which).spec.thickness_allowance;
      if (means.direction > 0 && lever.now >= 0.0) return std::nullopt;
      lever.span = means.direction > 0 ? -lever.now : 0.3 * m;
      lever.digits = digits_for(m, 3);
      return lever;
    case A::teeth:
      lever.now = gear(which).spec.teeth;
      lever.direction *= static_cast<int>(outward);
      lever.span = 64;
      lever.digits = 0;
      return lever;
    case A::helix_angle:
      lever.now = gear(which).spec.helix_angle.deg();
      lever.exact = -gear(1).spec.helix_angle.deg();
      return lever;
    case A::face_width: {
      const double half = which > 0 ? gear(which).spec.face_width
                                    : std::min(gear(1).spec.face_width, gear(2).spec.face_width);
      const double b = which > 0     ? gear(which).whole_face(half)
                       : judged.pair ? judged.pair->mounted().whole_face(half)
                                     : half;
      lever.now = b;
      lever.span = std::max(4 * b, 20 * m);
      lever.digits = digits_for(m, 1);
      if (which == 0 && judged.pair && judged.pair->parallel())
        lever.hint = face_width_needed(*judged.pair->parallel());
      return lever;
    }
    case A::bore:
      if (!gear(which).bore) return std::nullopt;
      // If the rim thickness is given for the rating, another bore does not change it.
      if (finding.code == C::thin_rim && judged.rating && judged.rating->input.rim[which - 1])
        return std::nullopt;
      lever.now = gear(which).bore->diameter;
      lever.direction *= static_cast<int>(outward);
      lever.span = outward > 0 ? 0.99 * lever.now : 10 * m;
      lever.digits = digits_for(m, 1);
      return lever;
    case A::lead_crowning:
    case A::lead_slope:
      if (gear(which).internal()) return std::nullopt;
      lever.span = 80;  // µm; `now` is 0, because Gear does not contain the present value
      lever.digits = 0;
      return lever;
    case A::center_distance:
      if (!(judged.pair || judged.rack) || judged.distance_sets_shifts) return std::nullopt;
      lever.span = m;
      lever.digits = digits_for(m, 3);
      if (judged.rack) {
        lever.now = judged.rack->center_distance;
        lever.hint = judged.rack->backlash_free_center_distance;
        // The range contains the backlash-free centre distance, even if this is far away.
        lever.span += std::max(0.0, lever.direction * (*lever.hint - lever.now));
        // The distance remains greater than 0.
        if (lever.direction < 0) lever.span = std::min(lever.span, 0.99 * lever.now);
        return lever;
      }
      lever.now = judged.pair->center_distance();
      lever.direction *= static_cast<int>(judged.pair->mounted().side());
      if (p) lever.hint = p->backlash_free_center_distance;
      return lever;
  }
  return std::nullopt;
}

std::string subject(const SpecChange& change) {
  const std::string of_gear = change.gear > 0 ? fmt::format(" on gear {}", change.gear)
                              : change.what == A::face_width ? std::string(" on both gears")
                                                             : std::string();
  switch (change.what) {
    case A::profile_shift: return fmt::format("a profile shift of {{}}{}", of_gear);
    case A::tip_diameter: return fmt::format("a tip diameter of {{}} mm{}", of_gear);
    case A::thickness_allowance: return fmt::format("a thickness allowance of {{}} mm{}", of_gear);
    case A::teeth: return fmt::format("{{}} teeth{}", of_gear);
    case A::helix_angle: return fmt::format("a helix angle of {{}}°{}", of_gear);
    case A::face_width: return fmt::format("a face width of {{}} mm{}", of_gear);
    case A::bore: return fmt::format("a bore of {{}} mm{}", of_gear);
    case A::lead_crowning: return fmt::format("a lead crowning of {{}} µm{}", of_gear);
    case A::lead_slope: return fmt::format("a lead slope of {{}} µm{}", of_gear);
    case A::center_distance: return "a centre distance of {} mm";
  }
  return "{}";
}

}  // namespace

double Lever::step() const { return std::pow(10.0, -digits); }

double Lever::in_steps(double steps) const {
  const double value = steps / std::pow(10.0, digits);
  return value == 0.0 ? 0.0 : value;  // avoids a minus sign before zero
}

const Cure* cure_of(const Finding& finding) {
  for (const Cure& cure : cures())
    if (finding.code == cure.code) return &cure;
  return nullptr;
}

std::vector<Lever> levers(const Cure& cure, const Finding& finding, const Judged& judged) {
  std::vector<Lever> list;
  for (const Means& means : cure.means)
    if (auto lever = lever_of(means, finding, judged)) list.push_back(*lever);
  return list;
}

std::string remedy_words(const Cure& cure, const SpecChange& change, const Finding& finding,
                         const Judged& judged, const ChangedState& trial) {
  std::string then;
  if (cure.then == kContactRatio) {
    then = fmt::format(kContactRatio, trial.contact_ratio);
  } else if (cure.then == kBacklash && finding.at.empty()) {
    then = std::abs(trial.backlash) < no_backlash(judged.gears[0]->spec.normal_module)
               ? "there is no backlash"
               : fmt::format(kBacklash, trial.backlash);
  } else if (cure.then == kBacklash) {
    then = "the backlash is positive at both ends of every tolerance";
  } else {
    const bool of_rack = judged.rack && finding.gear == 2;
    then = fmt::format(fmt::runtime(cure.then),
                       of_rack ? "the rack" : fmt::format("gear {}", finding.gear));
    const bool undercut =
        std::any_of(trial.findings.begin(), trial.findings.end(),
                    [](const Finding& f) { return f.code == WarningCode::undercut; });
    if (cure.code == WarningCode::through_axis && !undercut) then += " without undercut";
  }
  if (change.what == A::teeth && judged.pair) {
    const double mate = judged.gears[change.gear == 1 ? 1 : 0]->spec.teeth;
    const double u = std::abs(change.gear == 1 ? mate / change.value : change.value / mate);
    then += fmt::format(", and the gear ratio is {:.6g}", u);
  }
  std::string because;
  const ParallelPair* p = judged.pair ? judged.pair->parallel() : nullptr;
  if (judged.shifts_follow && p && change.what == A::center_distance) {
    because = fmt::format(
        "The centre distance of {:.6g} mm requires profile shifts with a sum of {:.4f}. The "
        "reference centre distance is {:.6g} mm. ",
        p->center_distance, p->gears[0].spec.profile_shift + p->gears[1].spec.profile_shift,
        p->reference_center_distance);
  }
  return fmt::format("{}With {}, {}.", because,
                     fmt::format(fmt::runtime(subject(change)), format_number(change.value)), then);
}

}  // namespace gearwright::detail
