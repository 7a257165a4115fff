#include "gearwright/rating/material.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

constexpr std::array<std::string_view, 11> kWords{
    "case_hardened",    "through_hardened", "normalized", "induction_hardened",
    "nitrided",         "nitrocarburized",  "cast",       "nodular",
    "nodular_ferritic", "malleable",        "plastic"};

constexpr std::array<std::string_view, 11> kLetters{"Eh",
                                                    "V",
                                                    "St",
                                                    "IF",
                                                    "NT, NV (nitr.)",
                                                    "NV (nitrocar.)",
                                                    "GG",
                                                    "GGG (perl., bai.)",
                                                    "GGG (ferr.)",
                                                    "GTS (perl.)",
                                                    "plastic"};

// The line σ = A x + B for quality MQ. x is the hardness in HB if `brinell`, otherwise in HV.
struct Line {
  MaterialKind kind;
  double flank_a, flank_b, root_a, root_b;
  double lo, hi;  // range of x
  bool brinell;
};

using K = MaterialKind;

constexpr std::array<Line, 7> kLines{{
    {K::case_hardened, 0.0, 1500.0, 0.0, 430.0, 600, 800, false},
    {K::through_hardened, 1.313, 373.0, 0.425, 187.0, 200, 390, false},  // alloyed, wrought
    {K::normalized, 1.0, 190.0, 0.455, 69.0, 110, 210, true},
    {K::induction_hardened, 0.541, 882.0, 0.138, 290.0, 500, 615, false},
    {K::nitrided, 0.0, 1250.0, 0.0, 420.0, 650, 900, false},  // nitriding steel
    {K::cast, 1.033, 132.0, 0.256, 8.0, 150, 240, true},
    {K::nodular, 1.434, 211.0, 0.350, 119.0, 175, 300, true},
}};

constexpr std::string_view kCase = "case-hardened, core at least 25 HRC";
constexpr std::string_view kTempered = "quenched and tempered";

constexpr std::array<NamedMaterial, 21> kTable{{
    {"18CrNiMo7-6", K::case_hardened, 720, 850.0, kCase},
    {"17CrNiMo6", K::case_hardened, 720, 850.0, "the older name of 18CrNiMo7-6"},
    {"16MnCr5", K::case_hardened, 720, std::nullopt, kCase},
    {"20MnCr5", K::case_hardened, 720, std::nullopt, kCase},
    {"20MnCrS5", K::case_hardened, 720, std::nullopt, kCase},
    {"20CrMo5", K::case_hardened, 720, std::nullopt, kCase},
    {"15CrNi6", K::case_hardened, 720, std::nullopt, kCase},
    {"20NiCrMo2-2", K::case_hardened, 720, std::nullopt, kCase},
    {"14NiCrMo13-4", K::case_hardened, 720, std::nullopt, kCase},
    {"34CrNiMo6", K::through_hardened, 310, std::nullopt, kTempered},
    {"42CrMo4", K::through_hardened, 290, std::nullopt, kTempered},
    {"34CrMo4", K::through_hardened, 270, std::nullopt, kTempered},
    {"30CrNiMo8", K::through_hardened, 320, std::nullopt, kTempered},
    {"C45N", K::normalized, 200, std::nullopt, "normalized"},
    {"S355", K::normalized, 170, std::nullopt, "structural steel"},
    {"42CrMo4 induction", K::induction_hardened, 560, std::nullopt, "flank and root hardened"},
    {"31CrMoV9", K::nitrided, 750, std::nullopt, "gas nitrided"},
    {"34CrAlNi7-10", K::nitrided, 850, std::nullopt, "gas nitrided"},
    {"EN-GJL-250", K::cast, 220, std::nullopt, "grey cast iron"},
    {"EN-GJS-600-3", K::nodular, 240, std::nullopt, "nodular cast iron, pearlitic"},
    {"EN-GJS-700-2", K::nodular, 270, std::nullopt, "nodular cast iron, pearlitic"},
}};

constexpr double kBrinellOfVickers = 0.95;

}  // namespace

std::optional<Material> material_of_kind(MaterialKind kind) {
  if (kind == K::plastic) return std::nullopt;
  Material m;
  m.kind = kind;
  if (kind == K::cast) {
    m.youngs_modulus = 126000.0;
    m.density = 7.3e-6;
  } else if (kind == K::nodular || kind == K::nodular_ferritic) {
    m.youngs_modulus = 173000.0;
    m.density = 7.3e-6;
  }
  return m;
}

std::span<const std::string_view> material_kind_words() { return kWords; }

std::string_view material_letters(MaterialKind kind) {
  return kLetters[static_cast<std::size_t>(kind)];
}

std::span<const NamedMaterial> named_materials() { return kTable; }

std::optional<double> at_temperature(const ByTemperature& list, double celsius) {
  if (list.empty() || celsius < list.front()[0] || celsius > list.back()[0]) return std::nullopt;
  std::size_t i = 1;
  while (i < list.size() && celsius > list[i][0]) ++i;
  if (i == list.size()) return list.back()[1];
  const auto& [t_0, v_0] = list[i - 1];
  const auto& [t_1, v_1] = list[i];
  return v_0 + (v_1 - v_0) * (celsius - t_0) / (t_1 - t_0);
}

std::optional<Limits> limits_of(MaterialKind kind, double hardness_HV) {
  const auto line =
      std::find_if(kLines.begin(), kLines.end(), [&](const Line& l) { return l.kind == kind; });
  if (line == kLines.end()) return std::nullopt;
  const double x = line->brinell ? kBrinellOfVickers * hardness_HV : hardness_HV;
  if (x < line->lo || x > line->hi) return std::nullopt;
  return Limits{line->flank_a * x + line->flank_b, line->root_a * x + line->root_b};
}

std::optional<Material> material_named(std::string_view name, std::optional<double> hardness_HV) {
  const auto row = std::find_if(kTable.begin(), kTable.end(),
                                [&](const NamedMaterial& m) { return m.name == name; });
  if (row == kTable.end()) return std::nullopt;
  Material m = *material_of_kind(row->kind);
  m.name = std::string(name);
  m.hardness_HV = hardness_HV.value_or(row->hardness_HV);
  m.yield_strength = row->yield_strength;
  m.from_table = true;
  const auto limits = limits_of(m.kind, *m.hardness_HV);
  if (!limits) return std::nullopt;
  m.sigma_Hlim = limits->sigma_Hlim;
  m.sigma_Flim = limits->sigma_Flim;
  return m;
}

namespace {

struct Knot {
  double cycles, value;
};

constexpr double kLast = 1e10;

// Interpolates the life factor between the knots, linearly in log N and log σ. The last knot is at
// the reference number of cycles. `at_last` is the life factor at 10¹⁰ cycles.
Life on_lines(std::span<const Knot> knots, std::optional<double> cycles, double at_last,
              const char* formula) {
  const Knot& first = knots.front();
  const Knot& reference = knots.back();
  if (!cycles)
    return {{1.0, formula, "the reference number of cycles, because no life is given"}, 1.0};
  const double n = *cycles;
  if (n <= first.cycles) return {{first.value, formula, "static stress"}, 0.0};
  const auto between = [n](const Knot& a, const Knot& b) {
    const double share = std::log(n / a.cycles) / std::log(b.cycles / a.cycles);
    return a.value * std::pow(b.value / a.value, share);
  };
  if (n >= kLast) return {{at_last, formula, "10¹⁰ cycles and more"}, 1.0};
  if (n >= reference.cycles)
    return {{between(reference, {kLast, at_last}), formula, "long life, up to 10¹⁰ cycles"}, 1.0};
  std::size_t i = 1;
  while (n > knots[i].cycles) ++i;
  return {{between(knots[i - 1], knots[i]), formula, "limited life"},
          std::log(n / first.cycles) / std::log(reference.cycles / first.cycles)};
}

constexpr std::array kPitting{Knot{1e5, 1.6}, Knot{5e7, 1.0}};
constexpr std::array kSomePitting{Knot{6e5, 1.6}, Knot{1e7, 1.3}, Knot{1e9, 1.0}};
constexpr std::array kNitridedFlank{Knot{1e5, 1.3}, Knot{2e6, 1.0}};
constexpr std::array kNitrocarburizedFlank{Knot{1e5, 1.1}, Knot{2e6, 1.0}};

constexpr std::array kTemperedRoot{Knot{1e4, 2.5}, Knot{3e6, 1.0}};
constexpr std::array kHardenedRoot{Knot{1e3, 2.5}, Knot{3e6, 1.0}};
constexpr std::array kNitridedRoot{Knot{1e3, 1.6}, Knot{3e6, 1.0}};
constexpr std::array kNitrocarburizedRoot{Knot{1e3, 1.1}, Knot{3e6, 1.0}};

}  // namespace

Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice) {
  constexpr const char* formula = "ISO 6336-2, clause 10";
  const auto life = [&](std::span<const Knot> knots) {
    return on_lines(knots, cycles, choice.at_10_10, formula);
  };
  switch (kind) {
    case K::cast:
    case K::nodular_ferritic:
    case K::nitrided: return life(kNitridedFlank);
    case K::nitrocarburized: return life(kNitrocarburizedFlank);
    default: return choice.limited_pitting ? life(kSomePitting) : life(kPitting);
  }
}

Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice) {
  constexpr const char* formula = "ISO 6336-3, clause 12";
  const auto life = [&](std::span<const Knot> knots) {
    return on_lines(knots, cycles, choice.at_10_10, formula);
  };
  switch (kind) {
    case K::case_hardened:
    case K::induction_hardened: return life(kHardenedRoot);
    case K::cast:
    case K::nodular_ferritic:
    case K::nitrided: return life(kNitridedRoot);
    case K::nitrocarburized: return life(kNitrocarburizedRoot);
    default: return life(kTemperedRoot);
  }
}

}  // namespace gearwright
