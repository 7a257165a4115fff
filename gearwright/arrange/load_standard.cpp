#include "gearwright/arrange/load_standard.hpp"

#include <algorithm>

#include "gearwright/rating/elasticity.hpp"
#include "gearwright/rating/root.hpp"
#include "gearwright/rating/stiffness.hpp"

namespace gearwright {

namespace {

constexpr double kFullLineLoad = 100;  // N/mm; for smaller line loads, the standard reduces the
                                       // stiffness

// σ_F0 of gears 1 and 2 under a tangential force of 1 N.
std::optional<std::array<double, 2>> nominal_per_newton(const RatedPair& pair) {
  constexpr RatingEdition kEdition = RatingEdition::iso_2006;
  std::array<double, 2> list{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto section = critical_section(pair, pair.gears[i]);
    if (!section) return std::nullopt;
    list[i] = form_factor(kEdition, pair, *section).value *
              stress_correction_factor(*section).value * root_helix_factor(kEdition, pair).value /
              (root_face_width(pair, pair.gears[i]) * pair.normal_module);
  }
  return turned(pair, list);
}

}  // namespace

std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer) {
  if (answer.contact->regime == LoadRegime::point) return {};
  const auto rated = rated_pair(*arranged.pair, {});
  if (!rated) return {};
  const auto& [one, two] = answer.compliance->bodies;
  const double elasticity = relative_elasticity(one.youngs_modulus, two.youngs_modulus);
  const RatedGear& first = rated->gears[rated->place(1)];
  const auto nominal = nominal_per_newton(*rated);
  std::vector<LoadStandard> list;
  for (const LoadedTorque& t : answer.contact->torques) {
    const double force = 2 * t.torque / first.reference_diameter;
    LoadStandard s;
    const auto under = [&](double line_load) {
      return mesh_stiffness(*rated, line_load, elasticity, std::nullopt).c_gamma_alpha.value;
    };
    s.stiffness = under(force / rated->face_width);
    s.low_load = std::max(1.0, under(kFullLineLoad) / s.stiffness);
    if (nominal) s.root_stress = {force * (*nominal)[0], force * (*nominal)[1]};
    list.push_back(s);
  }
  return list;
}

}  // namespace gearwright
