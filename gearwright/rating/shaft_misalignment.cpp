#include "gearwright/rating/shaft_misalignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

std::vector<double> shaft_deviation(const RatedPair& pair, const MeshShafts& shafts, double F_t) {
  const double b = pair.face_width;
  std::vector<double> z;
  z.reserve(kShaftPoints);
  for (int k = 0; k < kShaftPoints; ++k) z.push_back(b * (k / (kShaftPoints - 1.0) - 0.5));

  // Gear 1 turns clockwise seen from +z, so it pushes gear 2 towards −y if it drives.
  const double push = shafts.gear2_drives ? 1.0 : -1.0;
  const double F_bt = F_t * pair.gears[0].reference_diameter / pair.gears[0].base_diameter;
  // The tilting moment is T_i tan β_w sin α_wt = F_bt r_bi tan β_b tan α_wt, because
  // tan β_w = tan β_b/cos α_wt.
  const double tilt = std::tan(pair.beta_b) * std::tan(pair.alpha_wt);
  std::vector<double> f(z.size(), 0.0);
  for (const int which : {1, 2}) {
    const auto& shaft = shafts.of[static_cast<std::size_t>(which - 1)];
    if (!shaft) continue;
    const RatedGear& gear = pair.gears[pair.place(which)];
    GW_EXPECTS(!gear.internal());
    const double r_b = gear.base_diameter / 2;
    // Gear 2 has the opposite hand. In an internal pair it has the same hand but turns in the same
    // sense, with the same result.
    const double hand = which == 1 ? shafts.hand1 : -shafts.hand1;
    const ShaftLoad load{F_bt, push * hand * F_bt * r_b * tilt, -b / 2, b / 2};
    const std::vector<double> w = shaft_deflection(*shaft, load, z).w;
    const std::vector<double> twist =
        shaft_twist(*shaft, F_bt * r_b, gear.root_diameter, load.lo, load.hi, z);
    for (std::size_t k = 0; k < z.size(); ++k) f[k] += (w[k] + r_b * twist[k]) / kMmPerUm;
  }
  return f;
}

double shaft_misalignment(const RatedPair& pair, const MeshShafts& shafts, double F_t) {
  const std::vector<double> f = shaft_deviation(pair, shafts, F_t);
  const auto [least, greatest] = std::minmax_element(f.begin(), f.end());
  return *greatest - *least;
}

}  // namespace gearwright
