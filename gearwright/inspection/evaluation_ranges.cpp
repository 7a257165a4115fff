#include "gearwright/inspection/evaluation_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

namespace {

constexpr double kLeftOut = 0.05;  // omitted fraction of the profile at its tip, and of the face at
                                   // each end

}  // namespace

RollPlace roll_place(const Gear& gear, double diameter) {
  const double d_b = gear.reference().base_diameter;
  GW_EXPECTS(!(diameter < d_b));
  const double roll = leaf::curvature_at(diameter, d_b);
  return {diameter, roll / 2, roll / d_b};
}

std::optional<EvaluationRanges> evaluation_ranges(const Gear& gear) {
  const auto flank = usable_flank(gear);
  if (!flank) return std::nullopt;
  EvaluationRanges r{
      roll_place(gear, flank->root_end),
      roll_place(gear, std::max(gear.reference_diameter, gear.reference().base_diameter)),
      roll_place(gear, flank->tip_end),
      {},
      {}};
  const double end = r.tip_form.length - kLeftOut * (r.tip_form.length - r.root_form.length);
  r.profile = {std::min(r.root_form.length, end), std::max(r.root_form.length, end)};
  const double b = gear.spec.face_width;
  const double half = b / 2 - std::min(kLeftOut * b, gear.spec.normal_module);
  r.helix = {-half, half};
  return r;
}

std::optional<ActiveFlank> active_flank(const InvolutePair& pair, int which) {
  const Mesh<double>& m = pair.mesh;
  if (!pair.flanks_meet() || !(m.rho1_true_begin < m.rho1_true_end)) return std::nullopt;
  const double r_b = pair.gears[which - 1].base_radius();
  const auto place = [r_b](double rho) {
    return RollPlace{2 * std::hypot(r_b, rho), rho, rho / r_b};
  };
  if (which == 1) return ActiveFlank{place(m.rho1_true_begin), place(m.rho1_true_end)};
  return ActiveFlank{place(m.rho2(m.rho1_true_end)), place(m.rho2(m.rho1_true_begin))};
}

ContactPlace UsableFlank::place(double diameter) const {
  if (contains(diameter)) return ContactPlace::usable;
  if (!(side * diameter >= side * root_end)) return ContactPlace::below_flank;
  return side * diameter <= side * tip ? ContactPlace::on_tip_rounding : ContactPlace::beyond_tip;
}

std::optional<UsableFlank> usable_flank(const Gear& gear) {
  // Without a cutter, the fillet of an internal gear is not known.
  const auto root = gear.tooth ? gear.tooth->form_radius : std::optional(gear.root_diameter / 2);
  if (!gear.involute() || !gear.exists() || !root) return std::nullopt;
  const double d_b = gear.reference().base_diameter;
  const UsableFlank flank{std::max(2 * *root, d_b), std::max(2 * gear.tip_form_radius(), d_b),
                          2 * gear.actual_tip_radius(), gear.side()};
  if (!(flank.least() < flank.greatest())) return std::nullopt;
  return flank;
}

Result<UsableFlank> measurable_flank(const Gear& gear, const char* field, double value) {
  if (!gear.involute())
    return refused(field, value, "needs involute flanks, but these flanks are circular arcs");
  if (const auto flank = usable_flank(gear)) return *flank;
  return refused(field, value,
                 "there is no usable flank to measure, as the warnings of the gear explain");
}

bool straight_tools_fit(const Gear& gear) {
  return !(gear.internal() && gear.spec.helix_angle != Angle());
}

double v_circle_diameter(const Gear& gear) {
  return gear.reference_diameter +
         gear.side() * 2 * gear.spec.profile_shift * gear.spec.normal_module;
}

double usual_contact_diameter(const Gear& gear, const UsableFlank& flank) {
  const double d_v = v_circle_diameter(gear);
  return flank.contains(d_v) ? d_v : flank.middle();
}

}  // namespace gearwright
