#include "gearwright/rating/rating.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

constexpr double kMinutesPerHour = 60.0;
constexpr double kReversed = 0.7;  // relative root strength for bending in both directions

Factor given(double value) { return {value, "", kGivenFactor}; }

// Converts a factor at the reference number of cycles to the factor at this life.
Factor at_life(Factor f, const Life& life) {
  if (life.reference != 1.0) f.value = std::pow(f.value, life.reference);
  return f;
}

// Computes the rating. All values are in the order pinion, wheel.
struct Rater {
  const RatedPair& pair;
  const RatingInput& in;
  std::optional<std::array<Material, 2>> exchanged;
  const std::array<Material, 2>& materials;
  Rating r{};
  double pinion_speed = 0.0, velocity = 0.0;
  std::array<std::optional<double>, 2> cycles{};
  std::array<Tolerances, 2> tolerance{};  // valid if the quality is given

  Rater(const RatedPair& p, const RatingInput& i)
      : pair(p),
        in(i),
        exchanged(p.exchanged ? std::optional(turned(p, i.materials)) : std::nullopt),
        materials(exchanged ? *exchanged : i.materials) {}
  Rater(const Rater&) = delete;
  Rater& operator=(const Rater&) = delete;

  void load();
  double specific_load() const;  // F_t K_A K_γ/b, N/mm
  void dynamics();
  void distribution();
  void flank();
  std::optional<Error> root();
  void check_limits();
};

void Rater::load() {
  const RatedGear& driven_by = pair.gears[pair.place(1)];
  r.edition = in.edition;
  r.F_t = {2000 * in.torque / driven_by.reference_diameter, "ISO 6336-1, 4.2, (1)", ""};
  r.K_A = {in.application_factor, "ISO 6336-1, clause 5",
           in.application_factor == 1.0 ? kNotAsked : kGivenFactor};
  r.K_gamma = {in.mesh_load_factor, "ISO 6336-1, 4.2",
               in.mesh_load_factor != 1.0 ? kGivenFactor
               : pair.halves == 2         ? "two halves that carry equal loads"
                                          : "one mesh"};
  if (!in.speed) return;
  pinion_speed = *in.speed * std::abs(driven_by.teeth / static_cast<double>(pair.gears[0].teeth));
  velocity = std::numbers::pi * driven_by.reference_diameter * *in.speed / 60.0 / kMmPerM;
  r.v = Factor{velocity, "ISO 6336-1, 4.2", ""};
  if (!in.life_h) return;
  for (std::size_t i = 0; i < 2; ++i) {
    const double turns = std::abs(pair.gears[0].teeth / static_cast<double>(pair.gears[i].teeth));
    cycles[i] = kMinutesPerHour * *in.life_h * pinion_speed * turns;
    r.N_L[i] = Factor{*cycles[i], "ISO 6336-2, clause 10", ""};
  }
}

double Rater::specific_load() const {
  return r.F_t.value * in.application_factor * in.mesh_load_factor / pair.carrying_width();
}

void Rater::dynamics() {
  const double line = specific_load();
  const double e1 = materials[0].youngs_modulus;
  const double e2 = materials[1].youngs_modulus;
  r.stiffness = mesh_stiffness(pair, line, relative_elasticity(e1, e2), in.body);
  if (in.quality) {
    const auto grade = turned(pair, *in.quality);
    for (std::size_t i = 0; i < 2; ++i)
      tolerance[i] =
          tolerances(in.edition, grade[i], pair.gears[i], pair.normal_module, pair.alpha_t);
    r.tolerance = tolerance;
  }
  if (in.dynamic_factor) r.K_v = given(*in.dynamic_factor);
  DynamicInput d;
  d.reduced_mass = reduced_mass(pair, materials);
  d.c_gamma_alpha = r.stiffness.c_gamma_alpha.value;
  d.teeth = pair.gears[0].teeth;
  d.speed = pinion_speed;
  d.specific_load = line;
  d.c_prime = r.stiffness.c_prime.value;
  d.epsilon_gamma = pair.epsilon_gamma();
  if (in.quality) {
    const double f_pb = std::max(tolerance[0].f_pb, tolerance[1].f_pb);
    const double f_fa = std::max(tolerance[0].f_falpha, tolerance[1].f_falpha);
    d.pitch_error = f_pb - running_in(materials, f_pb, velocity);
    d.profile_error = f_fa - running_in(materials, f_fa, velocity);
    const int worst = std::max((*in.quality)[0], (*in.quality)[1]);
    if (worst <= 5) d.tip_relief = in.tip_relief.value_or(running_in_relief(materials));
  }
  const Dynamic made = dynamic_factor(d);
  r.m_red = Factor{d.reduced_mass, "ISO 6336-1, 6.5.9, (30)", ""};
  r.n_E1 = made.n_E1;
  if (in.speed) r.N = made.N;
  if (!in.dynamic_factor) r.K_v = made.K_v;
}

void Rater::distribution() {
  const double mean = r.F_t.value * in.application_factor * in.mesh_load_factor * r.K_v.value /
                      pair.carrying_width();
  if (in.face_load_factor) {
    r.face.K_Hbeta = in.face_load_computed
                         ? Factor{*in.face_load_factor, "ISO 6336-1, clause 7, method B",
                                  "load along the teeth, at the worse limit of f_ma"}
                         : Factor{*in.face_load_factor, "",
                                  in.face_load_assumed ? kSearchDefault : kGivenFactor};
  } else {
    const double c = r.stiffness.c_gamma_beta.value;
    const std::array<double, 2> f_Hbeta{tolerance[0].f_Hbeta, tolerance[1].f_Hbeta};
    if (in.mounting) {
      r.face = face_load(pair, *in.mounting, materials, mean, c, f_Hbeta, velocity);
    } else {
      const double f_sh = shaft_misalignment(pair, *in.shafts, mean * pair.face_width);
      const double f_ma = in.misalignment.value_or(std::hypot(f_Hbeta[0], f_Hbeta[1]));
      r.face = face_load({f_sh, "ISO 6336-1, 7.5", "bending and torsion of the given shafts"}, f_ma,
                         materials, mean, c, f_Hbeta, velocity);
    }
  }
  const double K_Hbeta = r.face.K_Hbeta.value;
  r.K_Fbeta =
      in.face_load_factor_root ? given(*in.face_load_factor_root) : face_load_root(pair, K_Hbeta);
  r.Z_epsilon = contact_ratio_factor(pair);
  if (in.quality) {
    const double f_pb = std::max(tolerance[0].f_pb, tolerance[1].f_pb);
    const double f_fa = std::max(tolerance[0].f_falpha, tolerance[1].f_falpha);
    const double rest = std::max(f_pb, f_fa) - running_in(materials, f_pb, velocity);
    const TransverseLoad t = transverse_load(pair, r.stiffness.c_gamma_alpha.value, rest,
                                             mean * K_Hbeta, r.Z_epsilon.value);
    r.K_Halpha = t.K_Halpha;
    r.K_Falpha = t.K_Falpha;
  }
  if (in.transverse_load_factor) {
    r.K_Halpha = given(*in.transverse_load_factor);
    if (!in.quality) r.K_Falpha = r.K_Halpha;
  }
  if (in.transverse_load_factor_root) r.K_Falpha = given(*in.transverse_load_factor_root);
}

void Rater::flank() {
  Film film;
  film.sigma_Hlim = std::min(materials[0].sigma_Hlim, materials[1].sigma_Hlim);
  film.viscosity = in.viscosity;
  if (in.speed) film.velocity = velocity;
  if (in.flank_roughness) film.Rz = turned(pair, *in.flank_roughness);
  r.Z_H = zone_factor(pair);
  r.Z_B = single_contact_factors(pair);
  r.Z_E = elasticity_factor(materials);
  r.Z_beta = flank_helix_factor(pair);
  r.Z_L = lubricant_factor(film);
  r.Z_v = velocity_factor(film);
  r.Z_R = roughness_factor(pair, film);
  r.Z_W = work_hardening_factors(pair, materials, film);
  const double z = r.Z_H.value * r.Z_E.value * r.Z_epsilon.value * r.Z_beta.value;
  r.sigma_H0 = {nominal_contact_stress(pair, r.F_t.value, z), "ISO 6336-2, 5.2", ""};
  const double k =
      r.K_A.value * r.K_gamma.value * r.K_v.value * r.face.K_Hbeta.value * r.K_Halpha.value;
  for (std::size_t i = 0; i < 2; ++i) {
    const Life life = flank_life(materials[i].kind, cycles[i], in.life);
    r.Z_NT[i] = life.factor;
    r.Z_L_at_N[i] = at_life(r.Z_L, life);
    r.Z_v_at_N[i] = at_life(r.Z_v, life);
    r.Z_R_at_N[i] = at_life(r.Z_R, life);
    r.Z_W[i] = at_life(r.Z_W[i], life);
    r.Z_X[i] = {1.0, "ISO 6336-2, clause 14", "1"};
    r.sigma_H[i] = {r.Z_B[i].value * r.sigma_H0.value * std::sqrt(k), "ISO 6336-2, 5.2", ""};
    r.sigma_HG[i] = {materials[i].sigma_Hlim * r.Z_NT[i].value * r.Z_L_at_N[i].value *
                         r.Z_v_at_N[i].value * r.Z_R_at_N[i].value * r.Z_W[i].value *
                         r.Z_X[i].value,
                     "ISO 6336-2, 5.4", ""};
    r.S_H[i] = {r.sigma_HG[i].value / r.sigma_H[i].value, "ISO 6336-2, 5.1", ""};
  }
}

std::optional<Error> Rater::root() {
  const double k = r.K_A.value * r.K_gamma.value * r.K_v.value * r.K_Fbeta.value * r.K_Falpha.value;
  const auto rim = turned(pair, in.rim);
  for (std::size_t i = 0; i < 2; ++i) {
    const RatedGear& g = pair.gears[i];
    const Material& m = materials[i];
    const auto section = critical_section(pair, g);
    if (!section) {
      return Error{gear_field(pair.place(1) == i ? 1 : 2, "rack"), "",
                   "has a root without a tangent at 30° (for an internal gear at 60°), so the "
                   "standard has no form factor"};
    }
    r.section[i] = *section;
    const Life life = root_life(m.kind, cycles[i], in.life);
    std::optional<double> Rz;
    if (in.root_roughness) Rz = turned(pair, *in.root_roughness)[i];
    std::optional<int> grade;
    if (in.quality) grade = std::max((*in.quality)[0], (*in.quality)[1]);
    r.Y_F[i] = form_factor(in.edition, pair, *section);
    r.Y_S[i] = stress_correction_factor(*section);
    r.Y_beta[i] = root_helix_factor(in.edition, pair);
    r.Y_B[i] = rim_factor(g, pair.normal_module, rim[i]);
    r.Y_DT[i] = deep_tooth_factor(pair, grade);
    r.Y_ST[i] = {2.0, "ISO 6336-3, clause 5", "of the reference test gears"};
    r.Y_M[i] = {in.reversed ? kReversed : 1.0, "ISO 6336-3, annex B",
                in.reversed ? "bending in both directions" : "bending in one direction"};
    r.Y_NT[i] = life.factor;
    r.Y_delta_relT[i] = at_life(notch_sensitivity_factor(m, *section), life);
    r.Y_R_relT[i] = at_life(surface_factor(m, Rz), life);
    r.Y_X[i] = at_life(root_size_factor(m, pair.normal_module), life);
    const double b = pair.halves * root_face_width(pair, g);
    r.sigma_F0[i] = {r.F_t.value / (b * pair.normal_module) * r.Y_F[i].value * r.Y_S[i].value *
                         r.Y_beta[i].value * r.Y_B[i].value * r.Y_DT[i].value,
                     "ISO 6336-3, 5.2", ""};
    r.sigma_F[i] = {r.sigma_F0[i].value * k, "ISO 6336-3, 5.2", ""};
    r.sigma_FG[i] = {m.sigma_Flim * r.Y_ST[i].value * r.Y_M[i].value * r.Y_NT[i].value *
                         r.Y_delta_relT[i].value * r.Y_R_relT[i].value * r.Y_X[i].value,
                     "ISO 6336-3, 5.3", ""};
    r.S_F[i] = {r.sigma_FG[i].value / r.sigma_F[i].value, "ISO 6336-3, 5.1", ""};
  }
  return std::nullopt;
}

void Rater::check_limits() {
  const auto say = [&](bool bad, WarningCode code, const std::string& text, int gear = 0) {
    if (bad) r.limits.push_back({code, text, gear});
  };
  say(!(pair.epsilon_alpha > 1.0 && pair.epsilon_alpha < 2.5), WarningCode::rating_contact_ratio,
      "ISO 6336 applies to transverse contact ratios between 1 and 2.5, but the ratio of this pair "
      "is outside this range.");
  say(pair.beta > 30 * kRadPerDeg, WarningCode::rating_helix_angle,
      "ISO 6336 is confirmed up to a helix angle of 30°, but the helix angle of this pair is "
      "greater.");
  say(pair.alpha_n < 15 * kRadPerDeg || pair.alpha_n > 25 * kRadPerDeg,
      WarningCode::rating_pressure_angle,
      "ISO 6336 is confirmed for normal pressure angles of 15° to 25°, but the pressure angle of "
      "this pair is outside this range.");
  say(!r.stiffness.in_range, WarningCode::rating_stiffness,
      "The formula of the tooth stiffness c' applies to x1 ≥ x2 and −0.5 ≤ x1 + x2 ≤ 2, but the "
      "profile shifts of this pair are outside this range.");
  if (r.N) {
    const double N_S = resonance_begin(specific_load());
    say(r.N->value > N_S && r.N->value <= 1.15 && !in.dynamic_factor, WarningCode::rating_resonance,
        fmt::format("The pinion runs in the main resonance of the mesh, N_S = {:.2f} < N = {:.2f} "
                    "≤ 1.15; ISO 6336-1 requires a detailed analysis in this range.",
                    N_S, r.N->value));
  }
  say(!r.face.offset_in_range, WarningCode::rating_mounting,
      "The offset s of the pinion is greater than the standard allows for this arrangement of the "
      "bearings.");
  for (const int which : {1, 2}) {
    const std::size_t i = pair.place(which);
    const double q = r.section[i].q_s;
    say(!(q >= 1.0 && q < 8.0), WarningCode::rating_notch,
        "The stress correction factor Y_S applies to 1 ≤ q_s < 8, but this root fillet is outside "
        "this range.",
        which);
    const auto rim = in.rim[which - 1];
    const RatedGear& g = pair.gears[i];
    say(rim && *rim <= least_rim(g.side(), pair.normal_module, g.tooth_height).thickness,
        WarningCode::thin_rim, "The rim is thinner than the rim thickness factor Y_B allows.",
        which);
  }
}

Result<Rating> rate_by_iso(const RatedPair& pair, const RatingInput& input) {
  Rater rater(pair, input);
  rater.load();
  rater.dynamics();
  rater.distribution();
  rater.flank();
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::isfinite(rater.r.Z_B[i].value)) continue;
    return Error{
        gear_field(pair.place(1) == i ? 1 : 2, "profile_shift"), "",
        "lets single pair contact reach a base circle, where the radius of curvature is 0 "
        "and the contact stress has no limit; a greater profile shift of the undercut gear "
        "would help"};
  }
  if (auto error = rater.root()) return *error;
  rater.check_limits();
  return std::move(rater.r);
}

std::optional<Error> two_halves_error(const RatedPair& pair, const RatingInput& in) {
  if (pair.halves == 1 || in.face_load_factor || !(in.mounting || in.shafts)) return std::nullopt;
  return Error{in.mounting ? "rating.mounting" : gear_field(in.shafts->of[0] ? 1 : 2, "shaft"), "",
               "determines the face load factor of single-helical gears only; for double-helical "
               "gears give rating.face_load_factor"};
}

// Returns the error of an absent torque or material. Interfaces check both before rate().
std::optional<Error> torque_or_strength_error(const RatingInput& in) {
  if (!(in.torque > 0.0))
    return refused("rating.torque", in.torque, "must be > 0 N m, the torque on gear 1");
  for (const int which : {1, 2}) {
    if (!in.materials[which - 1].has_strengths())
      return absent_input(
          gear_field(which, "material"),
          "; a rating needs sigma_Hlim and sigma_Flim > 0 N/mm². Set both in the materials of the "
          "rating, or take a material with strengths from material_named()");
  }
  return std::nullopt;
}

}  // namespace

Result<Rating> rate(const RatedPair& pair, const RatingInput& input) {
  if (auto error = torque_or_strength_error(input)) return *error;
  if (auto error = two_halves_error(pair, input)) return *error;
  if (auto error = missing_input(input, pair.halves)) return *error;
  auto made = input.edition == RatingEdition::vdi_2736 ? rate_plastic(pair, input)
                                                       : rate_by_iso(pair, input);
  if (!made || !pair.exchanged) return made;
  Rating r = std::move(made).take();
  for (FactorPair* list :
       {&r.Z_B,      &r.Z_NT,     &r.Z_L_at_N, &r.Z_v_at_N, &r.Z_R_at_N,     &r.Z_W,      &r.Z_X,
        &r.sigma_H,  &r.sigma_HG, &r.S_H,      &r.Y_F,      &r.Y_S,          &r.Y_beta,   &r.Y_B,
        &r.Y_DT,     &r.Y_ST,     &r.Y_M,      &r.Y_NT,     &r.Y_delta_relT, &r.Y_R_relT, &r.Y_X,
        &r.sigma_F0, &r.sigma_F,  &r.sigma_FG, &r.S_F})
    std::swap((*list)[0], (*list)[1]);
  std::swap(r.section[0], r.section[1]);
  std::swap(r.N_L[0], r.N_L[1]);
  if (r.tolerance) std::swap((*r.tolerance)[0], (*r.tolerance)[1]);
  if (r.temperature) {
    std::swap(r.temperature->flank[0], r.temperature->flank[1]);
    std::swap(r.temperature->root[0], r.temperature->root[1]);
  }
  return r;
}

}  // namespace gearwright
