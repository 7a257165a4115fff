#include "gearwright/rating/plastic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

namespace {

constexpr const char* kTemperature = "VDI 2736-2, tooth temperature";
constexpr const char* kRootStress = "VDI 2736-2, root";
constexpr const char* kFlankStress = "VDI 2736-2, flank";

bool plastic(const Material& m) { return m.kind == MaterialKind::plastic; }

// k_ϑ of flank and root, K (m/s)^0.75 mm^1.75/W.
struct HeatTransfer {
  double flank, root;
};
HeatTransfer heat_transfer(const std::array<Material, 2>& materials) {
  return plastic(materials[0]) && plastic(materials[1]) ? HeatTransfer{9000, 2148}
                                                        : HeatTransfer{6300, 895};
}

// Returns the number, 1 or 2, that the spec gives to the gear RatedPair::gears[place].
int gear_at(const RatedPair& pair, std::size_t place) { return pair.place(1) == place ? 1 : 2; }
// Interpolates `list` at the temperature `celsius`. If the list is empty, returns `number`.
Result<double> value_at(const RatedPair& pair, std::size_t place, const ByTemperature& list,
                        double number, double celsius, const char* what) {
  if (list.empty()) return number;
  if (const auto value = at_temperature(list, celsius)) return *value;
  Error error = refused(gear_field(gear_at(pair, place), "material.temperatures"), celsius,
                        {list.front()[0], list.back()[0]},
                        "the values of this plastic are given only from {} to {} °C");
  // The computed temperature is not the value of the key.
  error.rule =
      fmt::format("the temperature of the {} is {} °C, but {}", what, error.value, error.rule);
  error.value.clear();
  return error;
}

Factor given_or_one(const std::optional<double>& factor) {
  return factor ? Factor{*factor, "", kGivenFactor}
                : Factor{1.0, "VDI 2736-2",
                         "not given, so 1 is used; the guideline gives 1 to 1.25 for the product "
                         "of the load factors"};
}

// Marks as absent the factors of ISO 6336 that the guideline does not contain.
void leave_out(Rating& r) {
  Stiffness& s = r.stiffness;
  for (Factor* f : {&s.c_th, &s.c_prime, &s.c_gamma_alpha, &s.c_gamma_beta, &r.Z_L, &r.Z_v, &r.Z_R})
    *f = kNoFactor;
  for (FactorPair* f : {&r.Z_B, &r.Z_NT, &r.Z_L_at_N, &r.Z_v_at_N, &r.Z_R_at_N, &r.Z_W, &r.Z_X,
                        &r.Y_B, &r.Y_DT, &r.Y_M, &r.Y_NT, &r.Y_delta_relT, &r.Y_R_relT, &r.Y_X})
    *f = {kNoFactor, kNoFactor};
}

const char* strength_branch(const Material& m, const ByTemperature& list) {
  if (!plastic(m))
    return "reference strength of ISO 6336, for a metal gear with a plastic mating gear";
  return list.empty() ? "as given, for this life and temperature" : "as given, at its temperature";
}

// Returns the temperatures of the teeth, as given or computed.
//
// Formula   [T11.43]; power in W, pitch line velocity in m/s
// Domain    either both tooth temperatures are given, or the ambient temperature and the
//           coefficient of friction (contract)
ToothTemperatures tooth_temperatures(const RatedPair& pair, const PlasticInput& input,
                                     const std::array<Material, 2>& materials, double power,
                                     double velocity) {
  GW_EXPECTS((input.flank_temperature && input.root_temperature) ||
             (input.ambient_temperature && input.friction));
  const HeatTransfer k = heat_transfer(materials);
  const double housing = input.housing_area ? input.housing_resistance / *input.housing_area : 0.0;
  const double width = pair.carrying_width();
  const auto warm = [&](const std::optional<std::array<double, 2>>& given, double k_theta) {
    if (given) {
      const auto t = turned(pair, *given);
      return FactorPair{Factor{t[0], "", kGivenFactor}, Factor{t[1], "", kGivenFactor}};
    }
    FactorPair t{kNoFactor, kNoFactor};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!plastic(materials[i])) continue;
      const double teeth =
          k_theta / (width * pair.gears[i].teeth * std::pow(velocity * pair.normal_module, 0.75));
      t[i] = {*input.ambient_temperature + power * *input.friction * tooth_loss(pair) *
                                               (teeth + housing) * std::pow(input.duty, 0.64),
              kTemperature, housing > 0.0 ? "with the housing" : "open"};
    }
    return t;
  };
  return {warm(input.flank_temperature, input.flank_heat_transfer.value_or(k.flank)),
          warm(input.root_temperature, input.root_heat_transfer.value_or(k.root))};
}

}  // namespace

double tooth_loss(const RatedPair& pair) {
  const double pitch = std::numbers::pi * pair.gears[0].base_diameter / pair.gears[0].teeth;
  double squares = 0.0, sum = 0.0;
  for (const RatedGear& g : pair.gears) {
    const double tip = std::sqrt(
        std::max(0.0, g.tip_diameter * g.tip_diameter - g.base_diameter * g.base_diameter));
    const double part = (tip - g.base_diameter * std::tan(pair.alpha_wt)) / 2 / pitch;
    squares += part * part;
    sum += part;
  }
  return std::numbers::pi * (pair.u + 1) / (pair.gears[0].teeth * pair.u * std::cos(pair.beta_b)) *
         (1 - sum + squares);
}

std::vector<Error> missing_plastic_inputs(const RatingInput& in) {
  if (!plastic(in.materials[0]) && !plastic(in.materials[1])) {
    return {Error{"rating.edition", std::string(name(in.edition)),
                  "rates plastics, but neither gear is made of plastic; give `kind` = \"plastic\" "
                  "in [gearN.material], or give an edition of ISO 6336"}};
  }
  const PlasticInput& p = in.plastic;
  if (p.flank_temperature && p.root_temperature) return {};
  std::vector<Error> missing;
  if (!p.ambient_temperature || !p.friction) {
    missing.push_back(absent_input(
        p.ambient_temperature ? "rating.plastic.friction" : "rating.plastic.ambient_temperature",
        "; the strength of a plastic depends on the temperature of the teeth. Give "
        "`flank_temperature` and `root_temperature`, or give `ambient_temperature` and `friction`, "
        "for example 23 and 0.2"));
  }
  if (!in.speed)
    missing.push_back(absent_input("rating.speed",
                                   "; the temperature of the teeth depends on the speed. Give the "
                                   "speed, for example `speed` = 1500"));
  return missing;
}

Result<Rating> rate_plastic(const RatedPair& pair, const RatingInput& in) {
  if (pair.gears[1].internal()) {
    return Error{"rating.edition", std::string(name(in.edition)),
                 "covers external pairs only, but gear 2 is internal"};
  }
  const auto materials = turned(pair, in.materials);
  const RatedGear& driven_by = pair.gears[pair.place(1)];
  Rating r;
  leave_out(r);
  r.edition = in.edition;
  r.F_t = {2000 * in.torque / driven_by.reference_diameter, kRootStress, ""};
  r.K_A = {in.application_factor, kRootStress,
           in.application_factor == 1.0 ? kNotAsked : kGivenFactor};
  r.K_gamma = {in.mesh_load_factor, kRootStress,
               in.mesh_load_factor == 1.0 ? "one mesh" : kGivenFactor};
  double power = 0.0, velocity = 0.0;
  if (in.speed) {
    const double omega = radians_per_second(*in.speed);
    power = in.torque * omega;
    velocity = omega * driven_by.reference_diameter / 2 / kMmPerM;
    r.v = Factor{velocity, kTemperature, ""};
  }
  r.K_v = given_or_one(in.dynamic_factor);
  r.face.K_Hbeta = given_or_one(in.face_load_factor);
  r.K_Halpha = given_or_one(in.transverse_load_factor);
  r.K_Fbeta = in.face_load_factor_root ? given_or_one(in.face_load_factor_root) : r.face.K_Hbeta;
  r.K_Falpha =
      in.transverse_load_factor_root ? given_or_one(in.transverse_load_factor_root) : r.K_Halpha;
  r.temperature = tooth_temperatures(pair, in.plastic, materials, power, velocity);

  // The flank is rated with the modulus of elasticity at its temperature.
  std::array<Material, 2> warm = materials;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto E = value_at(pair, i, materials[i].youngs_modulus_by, materials[i].youngs_modulus,
                            r.temperature->flank[i].value, "flank");
    if (!E) return E.error();
    warm[i].youngs_modulus = *E;
  }
  r.Z_H = zone_factor(pair);
  r.Z_E = elasticity_factor(warm);
  r.Z_epsilon = contact_ratio_factor(pair);
  r.Z_beta = {std::sqrt(std::cos(pair.beta)), "DIN 3990-2, 6", "√cos β"};
  const double z = r.Z_H.value * r.Z_E.value * r.Z_epsilon.value * r.Z_beta.value;
  r.sigma_H0 = {nominal_contact_stress(pair, r.F_t.value, z), kFlankStress, ""};
  const double k = r.K_A.value * r.K_gamma.value * r.K_v.value;
  const double k_H = k * r.face.K_Hbeta.value * r.K_Halpha.value;
  const double k_F = k * r.K_Fbeta.value * r.K_Falpha.value;
  r.Y_epsilon = Factor{0.25 + 0.75 / pair.epsilon_alpha_n(), kRootStress, "0.25 + 0.75/ε_αn"};
  for (std::size_t i = 0; i < 2; ++i) {
    const RatedGear& g = pair.gears[i];
    const Material& m = materials[i];
    const auto flank =
        value_at(pair, i, m.sigma_Hlim_by, m.sigma_Hlim, r.temperature->flank[i].value, "flank");
    if (!flank) return flank.error();
    const auto root =
        value_at(pair, i, m.sigma_Flim_by, m.sigma_Flim, r.temperature->root[i].value, "root");
    if (!root) return root.error();
    r.sigma_H[i] = {r.sigma_H0.value * std::sqrt(k_H), kFlankStress, ""};
    r.sigma_HG[i] = {*flank, kFlankStress, strength_branch(m, m.sigma_Hlim_by)};
    r.S_H[i] = {r.sigma_HG[i].value / r.sigma_H[i].value, kFlankStress, ""};

    const auto section = critical_section(pair, g, LoadPoint::tip);
    if (!section) {
      return Error{gear_field(gear_at(pair, i), "rack"), "",
                   "has a root without a tangent at 30°, so there is no form factor"};
    }
    r.section[i] = *section;
    r.Y_F[i] = form_factor(RatingEdition::iso_2006, pair, *section);
    r.Y_F[i].branch = "Y_Fa, for the load at the tip";
    r.Y_S[i] = stress_correction_factor(*section);
    r.Y_beta[i] = root_helix_factor(RatingEdition::iso_2006, pair);
    r.Y_ST[i] = {2.0, kRootStress, ""};
    r.sigma_F0[i] = {r.F_t.value / (pair.carrying_width() * pair.normal_module) * r.Y_F[i].value *
                         r.Y_S[i].value * r.Y_epsilon->value * r.Y_beta[i].value,
                     kRootStress, ""};
    r.sigma_F[i] = {r.sigma_F0[i].value * k_F, kRootStress, ""};
    r.sigma_FG[i] = {r.Y_ST[i].value * *root, kRootStress, strength_branch(m, m.sigma_Flim_by)};
    r.S_F[i] = {r.sigma_FG[i].value / r.sigma_F[i].value, kRootStress, ""};
  }
  r.limits.push_back({WarningCode::rating_plastic,
                      "VDI 2736 also covers wear, deformation and peak loads of plastic teeth, but "
                      "the rating does not."});
  return r;
}

}  // namespace gearwright
