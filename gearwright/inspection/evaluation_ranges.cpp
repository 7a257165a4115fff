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
  const double r_b = pair.gears[static_cast<std::size_t>(which - 1)].base_radius();
  const auto place = [r_b](double rho) {
    return RollPlace{2 * std::hypot(r_b, rho), rho, rho / r_b};
  };
  if (which == 1) return ActiveFlank{place(m.rho1_true_begin), place(m.rho1_true_end)};
  return ActiveFlank{place(m.rho2(m.rho1_true_end)), place(m.rho2(m.rho1_true_begin))};
}

}  // namespace gearwright
