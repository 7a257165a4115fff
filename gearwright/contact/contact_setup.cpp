#include "gearwright/contact/contact_setup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/contact/recut.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

bool any_modification(const FlankModifications& m) {
  for (const ModificationMember& one : kModifications)
    if (one.amount_of(m) != 0.0 || (one.relief && one.placed(m))) return true;
  return m.topography || m.profile_wave.waves > 0 || m.helix_wave.waves > 0;
}

// The reason why no teeth touch, such as tips that do not reach each other, with a remedy.
std::string why_nothing_touches(const ContactSetup& setup, const ContactErrors& errors) {
  const double r1 = setup.gear(1).actual_tip_radius();
  const double r2 = setup.gear(2).actual_tip_radius();
  const double a = setup.place().center_distance + errors.center_distance;
  const double side = setup.gear(2).side();
  const double apart = side * (a - r2) - r1;  // distance between the tip circles, mm
  const bool exact = errors == ContactErrors();
  const std::string closer = side < 0.0 ? "a greater centre distance" : "a smaller centre distance";
  if (apart >= 0.0) {
    return fmt::format(
        "the axes are {:.6g} mm apart and the tip radii are {:.6g} mm and {:.6g} mm, so the tip "
        "circles are {:.6g} mm apart and the teeth do not reach each other; {}",
        a, r1, r2, apart,
        exact ? closer + " would help"
              : "change `errors.center_distance` or `pair.center_distance`");
  }
  return fmt::format(
      "no flank of gear 1 lies opposite a flank of gear 2 at any position (centre distance "
      "{:.6g} mm, tip radii {:.6g} mm and {:.6g} mm); {} or faces that overlap would help",
      a, r1, r2, exact ? closer : "smaller errors");
}

}  // namespace

Error nothing_touches(const ContactSetup& setup) {
  const ContactMount& place = setup.place();
  const bool exact = place.errors == ContactErrors();
  return {exact ? "pair.center_distance" : "errors",
          exact ? format_number(place.center_distance) : "",
          "no teeth touch, because " + why_nothing_touches(setup, place.errors),
          FailureKind::nothing_touches};
}

Error nothing_touches_under(const ContactSetup& setup, const std::string& name,
                            const ContactErrors& errors) {
  return {"compensate.range", name,
          "no teeth touch under these errors, because " + why_nothing_touches(setup, errors)};
}

bool any_modification(const BothFlanks& flanks) {
  return any_modification(flanks[0]) || any_modification(flanks[1]);
}

bool without_contact(const Error& error) {
  return error.kind == FailureKind::nothing_touches || error.kind == FailureKind::no_flank;
}

Result<SetupGear> SetupGear::of(const Gear& gear, int which, Angle cutter_lead) {
  if (!gear.root_form_radius())
    return Error{
        gear_field(which), "",
        "has no usable flank; the command `gearwright gear` prints a warning with the reason",
        FailureKind::no_flank};
  if (auto error = check_cutter_lead(gear, which, cutter_lead)) return *error;
  return SetupGear{std::make_shared<const Gear>(gear)};
}

std::optional<Error> SetupGear::modify(int which, const BothFlanks& flanks, bool wanted) {
  if (!wanted && !removal[0] && !any_modification(flanks)) return std::nullopt;
  auto made = removal_of(*gear, flanks);
  if (!made) return of_gear(which, made.error());
  removal = std::move(made).take();
  return std::nullopt;
}

const RemovalField* ContactSetup::removal(int gear, bool left) const {
  return gears_[gear - 1].removal[left ? 1 : 0].get();
}

ContactPair ContactSetup::pair(const ContactErrors& errors, bool gear2_drives) const {
  ContactMount place = place_;
  place.errors = errors;
  place.gear2_drives = gear2_drives;
  return at(place);
}

std::shared_ptr<const ContactPair> ContactSetup::shared_pair(const ContactErrors& errors,
                                                             bool gear2_drives) const {
  struct Held {
    ContactSetup setup;
    ContactPair pair;
  };
  const auto held = std::make_shared<const Held>(Held{*this, pair(errors, gear2_drives)});
  return {held, &held->pair};
}

ContactPair ContactSetup::at(const ContactMount& place) const {
  return ContactPair(gears_[0].flanks(), gears_[1].flanks(), place);
}

std::optional<ContactPair> ContactSetup::outlines(bool gear2_drives) const {
  for (int i = 0; i < 2; ++i) {
    const double delta_lambda = place_.errors.cutter_lead[i].rad();
    if (delta_lambda != 0.0 && !recut_outline(gear(i + 1), delta_lambda)) return std::nullopt;
  }
  ContactMount place = place_;
  place.gear2_drives = gear2_drives;
  place.fillets = true;
  return at(place);
}

std::optional<int> ContactSetup::convex_gear() const {
  for (int i = 0; i < 2; ++i) {
    const auto* arc = std::get_if<ArcRack>(&gear(i + 1).spec.rack);
    if (!arc) return std::nullopt;
    if (arc->cutter == ArcRack::Cutter::F) return i + 1;
  }
  return std::nullopt;
}

Result<ContactSetup> ContactSetup::changed(const SetupChange& change) const {
  ContactSetup setup = *this;
  for (int i = 0; i < 2; ++i) {
    setup.place_.errors.cutter_lead[i] += change.cutter_lead[i];
    const ModificationAmounts& by = change.flank[i];
    if (by == ModificationAmounts{}) continue;
    const bool left = gear(i + 1).left_flank_works(change.left);
    for (int side = 0; side < 2; ++side) {
      FlankModifications& m = setup.modifications_[i][side];
      for (const ModificationMember& one : kModifications)
        if (!is_slope(one.kind) || left == (side == 1)) one.amount_of(m) += by[one.kind];
    }
    if (auto error = setup.gears_[i].modify(i + 1, setup.modifications_[i], true)) return *error;
  }
  if (change.tool_setting != 0.0) {
    const auto which = convex_gear();
    GW_EXPECTS(which.has_value());
    CylindricalSpec spec = gear(*which).spec;
    auto* rack = std::get_if<ArcRack>(&spec.rack);
    GW_EXPECTS(rack != nullptr);
    rack->center_b += change.tool_setting / spec.normal_module;
    // The pressure angle is a check value, which is valid for the nominal tool setting only.
    rack->pressure_angle.reset();
    auto gear = make_gear(spec);
    if (!gear) return of_gear(*which, gear.error());
    if (!gear->exists() || !gear->root_form_radius())
      return Error{"compensate.corrections", "tool_setting_mm",
                   "no tooth is left after this tool setting"};
    setup.gears_[*which - 1].gear = std::make_shared<const Gear>(std::move(gear).take());
  }
  return setup;
}

Result<ContactSetup> ContactSetup::of(const Pair& pair, const ContactErrors& errors,
                                      const PairModifications& modifications,
                                      std::array<bool, 2> fields) {
  ContactSetup setup;
  setup.place_.center_distance = pair.center_distance();
  setup.place_.axis_angle = pair.mounted().axis_angle();
  setup.place_.errors = errors;
  setup.modifications_ = modifications;
  for (int i = 0; i < 2; ++i) {
    auto gear = SetupGear::of(pair.gear(i + 1), i + 1, errors.cutter_lead[i]);
    if (!gear) return gear.error();
    setup.gears_[i] = std::move(gear).take();
  }
  if (auto error = setup.make_fields(fields)) return *error;
  return setup;
}

std::optional<Error> ContactSetup::make_fields(std::array<bool, 2> wanted) {
  for (int i = 0; i < 2; ++i)
    if (auto error = gears_[i].modify(i + 1, modifications_[i], wanted[i])) return error;
  return std::nullopt;
}

Result<ContactSetup> ContactSetup::with_modifications(
    const PairModifications& modifications) const {
  ContactSetup setup = *this;
  setup.modifications_ = modifications;
  if (auto error = setup.make_fields({})) return *error;
  return setup;
}

ContactSetup ContactSetup::with_fields(std::array<bool, 2> wanted) const {
  ContactSetup setup = *this;
  const auto error = setup.make_fields(wanted);
  GW_EXPECTS(!error);
  return setup;
}

ContactSetup ContactSetup::half_at(const std::array<double, 2>& middle, bool below) const {
  ContactSetup setup = *this;
  setup.place_.middle = middle;
  if (below) setup.place_.errors = mirrored(place_.errors);
  return setup;
}

std::optional<Error> check_cutter_lead(const Gear& gear, int which, Angle change) {
  if (change == Angle()) return std::nullopt;
  const double delta = change.deg();
  const std::string field = fmt::format("errors.cutter_lead[{}]", which - 1);
  if (gear.twist() == 0.0)
    return refused(
        field, delta,
        "cannot be used for a spur gear, because it has no lead; give the gear a helix angle");
  if (gear.cut_by)
    return refused(
        field, delta,
        fmt::format("cannot be used for a gear cut by a pinion cutter, because the guide of the "
                    "cutter determines the lead; give `errors.helix_twist[{}]` to change the lead",
                    which - 1));
  const double lambda = 90.0 - std::abs(gear.spec.helix_angle.deg()) + delta;
  if (lambda > kMinLead.deg() && lambda < kMaxLead.deg()) return std::nullopt;
  return refused(
      field, delta,
      fmt::format("makes the lead angle {} degrees; the lead angle must lie between {} and {}, the "
                  "ends excluded",
                  format_number(lambda, kMaxLead.deg()), kMinLead.deg(), kMaxLead.deg()));
}

Result<FlankRemoval> removal_of(const Gear& gear, const BothFlanks& flanks) {
  FlankRemoval removal;
  for (const std::size_t side : {0, 1}) {
    auto field = make_removal_field(flanks[side], flank_extent(gear));
    if (!field)
      return within(side == 0 ? "modifications.right" : "modifications.left", field.error());
    removal[side] = std::make_shared<const RemovalField>(std::move(field).take());
  }
  return removal;
}

FlankExtent flank_extent(const Gear& gear) {
  return {gear.involute() ? gear.base_radius() : 0.0, gear.root_form_radius().value(),
          gear.tip_form_radius(), gear.spec.face_width};
}

}  // namespace gearwright
