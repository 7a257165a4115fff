#include "gearwright/rating/root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

constexpr double kRoughest = 40.0;  // µm, upper limit of Rz in clause 14.3 of ISO 6336-3

double rack_fillet(const RootTool& tool) { return tool.fillet; }

// Returns ρ_fPv*, the tip rounding of the rack equivalent to a pinion cutter. [ISO 6336-3, 6.2]
double virtual_fillet(const RootTool& tool) {
  if (tool.cutter_teeth == 0) return tool.fillet;
  const double reach = tool.cutter_shift + tool.dedendum - tool.fillet;
  return tool.fillet +
         std::pow(std::max(0.0, reach), 1.95) / (3.156 * std::pow(1.036, tool.cutter_teeth));
}

// The 30° tangent of an external gear and the 60° tangent of an internal gear.
struct RootTangent {
  double T;              // angle in H [T11.27]
  double start;          // of the search for θ, π/2 − T
  double chord, height;  // factors of (G/cos θ − ρ) in s_Fn and h_F, 2 sin T and 2 cos T
  double (*fillet)(const RootTool&);  // ρ_fP* or ρ_fPv*
};

// Clause 9 gives Y_B = rise ln(at/s) if s < thick, with the rim thickness s relative to `unit`.
struct RimRule {
  double (*unit)(double normal_module, double tooth_height);
  double least, thick, rise, at;
  const char *words_of_least, *thick_branch, *thin_branch;
};

struct RootRules {
  RootTangent tangent;
  RimRule rim;
};
constexpr RootRules kExternalRoot{
    {kPi / 3, kPi / 6, std::numbers::sqrt3, 1.0, rack_fillet},
    {[](double, double h) { return h; }, 0.5, 1.2, 1.6, 2.242, "half the tooth height",
     "external, s_R/h ≥ 1.2", "external, s_R/h < 1.2"}};
constexpr RootRules kInternalRoot{
    {kPi / 6, kPi / 3, 1.0, std::numbers::sqrt3, virtual_fillet},
    {[](double m, double) { return m; }, 1.75, 3.5, 1.15, 8.324, "1.75 modules",
     "internal, s_R/m_n ≥ 3.5", "internal, s_R/m_n < 3.5"}};

const RootRules& root_rules(double side) { return side > 0.0 ? kExternalRoot : kInternalRoot; }

// Solves θ = 2 G tan θ/z_n − H by Newton's method.
std::optional<double> tangent_angle(double G, double z_n, double H, double start) {
  constexpr int kMost = 60;
  constexpr double kSame = 1e-14;
  double theta = start;
  for (int i = 0; i < kMost; ++i) {
    const double c = std::cos(theta);
    const double f = theta - 2 * G / z_n * std::tan(theta) + H;
    const double slope = 1 - 2 * G / (z_n * c * c);
    const double step = f / slope;
    theta -= step;
    if (!std::isfinite(theta) || std::abs(theta) >= kPi / 2) return std::nullopt;
    if (std::abs(step) <= kSame) return theta;
  }
  return std::nullopt;
}

}  // namespace

std::optional<CriticalSection> critical_section(const RatedPair& pair, const RatedGear& gear,
                                                LoadPoint at) {
  const RootTangent& tangent = root_rules(gear.side()).tangent;
  const double m = pair.normal_module;
  const double z_n = gear.virtual_teeth;
  const double x = gear.generating_shift;
  const double sin_a = std::sin(pair.alpha_n);
  const double cos_a = std::cos(pair.alpha_n);
  const double tan_a = std::tan(pair.alpha_n);
  const double fillet = tangent.fillet(gear.tool);
  const double E = kPi / 4 - gear.tool.dedendum * tan_a + gear.tool.protuberance / cos_a -
                   (1 - sin_a) * fillet / cos_a;
  const double G = fillet - gear.tool.dedendum + x;
  const double H = 2 / z_n * (kPi / 2 - E) - tangent.T;
  const auto theta = tangent_angle(G, z_n, H, tangent.start);
  if (!theta) return std::nullopt;
  const double c = std::cos(*theta);
  const double arm = G / c - fillet;
  CriticalSection s{};
  s.theta = *theta;
  s.s_Fn = m * (z_n * std::sin(tangent.T - *theta) + tangent.chord * arm);
  s.rho_F = m * (fillet + 2 * G * G / (c * (std::abs(z_n) * c * c - 2 * G)));
  // If `at` is LoadPoint::tip, the load acts at the tip. Otherwise it acts at the outer point
  // of single pair contact, ε_αn − 1 base pitches from the tip along the line of action.
  const double side = gear.side();
  const double d_n = m * z_n;
  const double d_bn = d_n * cos_a;
  const double d_an = d_n + side * (gear.tip_diameter - gear.reference_diameter);
  const double shared = at == LoadPoint::tip ? 0.0 : std::max(0.0, pair.epsilon_alpha_n() - 1);
  const double back = side * kPi * m * cos_a * shared;
  const double roll = std::sqrt(std::max(0.0, d_an * d_an - d_bn * d_bn)) / 2 - back;
  s.d_en = side * 2 * std::hypot(roll, d_bn / 2);
  const double alpha_en = std::acos(std::clamp(d_bn / s.d_en, -1.0, 1.0));
  const double gamma =
      (kPi / 2 + 2 * x * tan_a) / z_n + involute(pair.alpha_n) - involute(alpha_en);
  s.alpha_Fen = alpha_en - gamma;
  s.h_F = m / 2 *
          ((std::cos(gamma) - std::sin(gamma) * std::tan(s.alpha_Fen)) * s.d_en / m -
           z_n * std::cos(tangent.T - *theta) - tangent.height * arm);
  s.q_s = s.s_Fn / (2 * s.rho_F);
  if (!(s.s_Fn > 0.0) || !(s.rho_F > 0.0) || !(s.h_F > 0.0)) return std::nullopt;
  return s;
}

double root_face_width(const RatedPair& pair, const RatedGear& gear) {
  return std::min(gear.face_width, pair.face_width + 2 * pair.normal_module);
}

Factor form_factor(RatingEdition edition, const RatedPair& pair, const CriticalSection& s) {
  const double m = pair.normal_module;
  const double chord = s.s_Fn / m;
  const double y = 6 * s.h_F / m * std::cos(s.alpha_Fen) / (chord * chord * std::cos(pair.alpha_n));
  constexpr const char* formula = "ISO 6336-3, clause 6";
  if (edition == RatingEdition::iso_2006) return {y, formula, ""};
  const double b = pair.epsilon_beta;
  const double e = pair.epsilon_alpha_n();
  if (pair.spur())
    return {e >= 2.0 ? 0.7 * y : y, formula, e >= 2.0 ? "f_ε = 0.7: ε_αn ≥ 2" : "f_ε = 1: spur"};
  if (b >= 1.0) return {y / std::sqrt(e), formula, "f_ε = ε_αn^−0.5: ε_β ≥ 1"};
  if (e < 2.0)
    return {y * std::sqrt(1 - b + b / e), formula, "f_ε = √(1 − ε_β + ε_β/ε_αn): ε_β < 1"};
  return {y * std::sqrt((1 - b) / 2 + b / e), formula,
          "f_ε = √((1 − ε_β)/2 + ε_β/ε_αn): ε_β < 1, ε_αn ≥ 2"};
}

Factor stress_correction_factor(const CriticalSection& s) {
  const double L = s.s_Fn / s.h_F;
  return {(1.2 + 0.13 * L) * std::pow(s.q_s, 1 / (1.21 + 2.3 / L)), "ISO 6336-3, clause 7",
          s.q_s >= 1.0 && s.q_s < 8.0 ? "1 ≤ q_s < 8" : "q_s outside 1 … 8"};
}

Factor root_helix_factor(RatingEdition edition, const RatedPair& pair) {
  const double overlap = std::min(1.0, pair.epsilon_beta);
  const double beta = std::min(30.0, pair.beta / kRadPerDeg);
  double y = 1 - overlap * beta / 120;
  if (edition == RatingEdition::iso_2019) {
    const double c = std::cos(beta * kRadPerDeg);
    y /= c * c * c;
  }
  return {y, "ISO 6336-3, clause 8",
          pair.spur()               ? "spur"
          : pair.epsilon_beta > 1.0 ? "ε_β > 1, so 1 is used"
                                    : "ε_β ≤ 1"};
}

LeastRim least_rim(double side, double normal_module, double tooth_height) {
  const RimRule& rule = root_rules(side).rim;
  return {rule.least * rule.unit(normal_module, tooth_height), rule.words_of_least};
}

Factor rim_factor(const RatedGear& gear, double normal_module, std::optional<double> rim) {
  constexpr const char* formula = "ISO 6336-3, clause 9";
  if (!rim) return {1.0, formula, "thick rim, because no rim is given"};
  const RimRule& rule = root_rules(gear.side()).rim;
  const double s = *rim / rule.unit(normal_module, gear.tooth_height);
  if (s >= rule.thick) return {1.0, formula, rule.thick_branch};
  return {rule.rise * std::log(rule.at / s), formula, rule.thin_branch};
}

Factor deep_tooth_factor(const RatedPair& pair, std::optional<int> grade) {
  constexpr const char* formula = "ISO 6336-3, clause 10";
  const double e = pair.epsilon_alpha_n();
  if (e <= 2.05) return {1.0, formula, "ε_αn ≤ 2.05"};
  if (!grade) return {1.0, formula, "no accuracy grade is given"};
  if (*grade > 4) return {1.0, formula, "coarser than grade 4"};
  if (e > 2.5) return {0.7, formula, "grade 4 or better, ε_αn > 2.5"};
  return {2.366 - 0.666 * e, formula, "grade 4 or better, 2.05 < ε_αn ≤ 2.5"};
}

Factor notch_sensitivity_factor(const Material& material, const CriticalSection& s) {
  constexpr const char* formula = "ISO 6336-3, 13.3";
  struct Layer {
    double strength, thickness;  // N/mm², mm
  };
  using K = MaterialKind;
  double rho = 0.0030;
  const char* branch = "hardened: ρ' = 0.0030 mm";
  const auto on_line = [&](const auto& line) {
    const double re =
        std::clamp(*material.yield_strength, line.front().strength, line.back().strength);
    std::size_t i = 1;
    while (i + 1 < line.size() && re > line[i].strength) ++i;
    const double share = (re - line[i - 1].strength) / (line[i].strength - line[i - 1].strength);
    // The layer thickness varies over powers of ten, so its logarithm is interpolated linearly.
    return line[i - 1].thickness * std::pow(line[i].thickness / line[i - 1].thickness, share);
  };
  constexpr std::array kTempered{Layer{500, 0.0281}, Layer{600, 0.0194}, Layer{800, 0.0064},
                                 Layer{1000, 0.0014}};
  constexpr std::array kSoft{Layer{300, 0.0833}, Layer{400, 0.0445}};
  switch (material.kind) {
    case K::case_hardened:
    case K::induction_hardened: break;
    case K::nitrided:
    case K::nitrocarburized:
      rho = 0.1005;
      branch = "nitrided: ρ' = 0.1005 mm";
      break;
    case K::cast:
      rho = 0.3124;
      branch = "grey cast iron: ρ' = 0.3124 mm";
      break;
    case K::nodular_ferritic:
      rho = 0.3095;
      branch = "ferritic nodular iron: ρ' = 0.3095 mm";
      break;
    case K::normalized:
      if (!material.yield_strength) return {1.0, formula, "1, because no yield strength is given"};
      rho = on_line(kSoft);
      branch = "ρ' by yield strength, 300 … 400 N/mm²";
      break;
    default:
      if (!material.yield_strength) return {1.0, formula, "1, because no yield strength is given"};
      rho = on_line(kTempered);
      branch = "ρ' by yield strength, 500 … 1000 N/mm²";
  }
  const double x = (1 + 2 * s.q_s) / 5;
  constexpr double kTest = 1.2;  // q_sT = 2.5
  return {(1 + std::sqrt(rho * x)) / (1 + std::sqrt(rho * kTest)), formula, branch};
}

Factor surface_factor(const Material& material, std::optional<double> Rz) {
  constexpr const char* formula = "ISO 6336-3, 14.3";
  if (!Rz) return {1.0, formula, kNotAsked};
  // The factor is `fine` below 1 µm and c − k (Rz + 1)^n above.
  struct Curve {
    double fine, c, k, n;
    std::array<const char*, 3> branches;  // below 1 µm, up to 40 µm, above 40 µm
  };
  static constexpr Curve kNormalized{
      1.07,
      5.306,
      4.203,
      0.01,
      {"normalized, Rz < 1 µm", "normalized", "normalized, Rz > 40 µm, so 40 µm is used"}};
  static constexpr Curve kCastOrNitrided{1.025,
                                         4.299,
                                         3.259,
                                         0.0058,
                                         {"cast or nitrided, Rz < 1 µm", "cast or nitrided",
                                          "cast or nitrided, Rz > 40 µm, so 40 µm is used"}};
  static constexpr Curve kHard{1.12,
                               1.674,
                               0.529,
                               0.1,
                               {"hardened or tempered, Rz < 1 µm", "hardened or tempered",
                                "hardened or tempered, Rz > 40 µm, so 40 µm is used"}};
  using K = MaterialKind;
  const auto curve = [&]() -> const Curve& {
    switch (material.kind) {
      case K::normalized: return kNormalized;
      case K::cast:
      case K::nodular_ferritic:
      case K::nitrided:
      case K::nitrocarburized: return kCastOrNitrided;
      default: return kHard;
    }
  }();
  if (*Rz < 1.0) return {curve.fine, formula, curve.branches[0]};
  return {curve.c - curve.k * std::pow(std::min(*Rz, kRoughest) + 1, curve.n), formula,
          curve.branches[*Rz > kRoughest ? 2 : 1]};
}

Factor root_size_factor(const Material& material, double normal_module) {
  constexpr const char* formula = "ISO 6336-3, clause 15";
  using K = MaterialKind;
  const double m = normal_module;
  if (m <= 5.0) return {1.0, formula, "m_n ≤ 5\u00a0mm"};
  switch (material.kind) {
    case K::cast:
    case K::nodular_ferritic: return {1.075 - 0.015 * std::min(m, 25.0), formula, "cast iron"};
    case K::case_hardened:
    case K::induction_hardened:
    case K::nitrided:
    case K::nitrocarburized: return {1.05 - 0.01 * std::min(m, 25.0), formula, "surface-hardened"};
    default: return {1.03 - 0.006 * std::min(m, 30.0), formula, "tempered or normalized"};
  }
}

}  // namespace gearwright
