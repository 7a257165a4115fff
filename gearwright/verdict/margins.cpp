#include "gearwright/verdict/margins.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "gearwright/base/units.hpp"

namespace gearwright::detail {

namespace {

struct Margin {
  WarningCode code;
  const char* what;  // example: "The form clearance at the root of gear {}"
  double modules;    // least clearance without a finding
};

constexpr Margin kForm{WarningCode::form_margin, "The form clearance at the root of gear {}",
                       kMarginForm};
constexpr Margin kFillet{
    WarningCode::fillet_margin,
    "The clearance between the root fillet of gear {} and the tip corner of the mating gear",
    kMarginFillet};
constexpr Margin kTip{WarningCode::tip_margin,
                      "The clearance between the tip of gear {} and the root of the mating gear",
                      kMarginTip};

// Returns, for example, "0.1500 mm". A length below 1 µm, which would be written as 0.0000 mm, is
// written in µm, for example as "0.021 µm". A length below 0.001 µm is a rounding error.
std::string millimetres(double mm) {
  if (kUmPerMm * mm < 0.001) return "less than 0.001 µm";
  return mm < kMmPerUm ? fmt::format("{:.2g} µm", kUmPerMm * mm) : fmt::format("{:.4f} mm", mm);
}

void judge(std::vector<Finding>& findings, const Margin& margin, int gear,
           const std::optional<double>& clearance, double module) {
  if (!clearance || *clearance < 0.0) return;  // a negative clearance has its own warning
  const double threshold = margin.modules * module;
  if (*clearance >= threshold) return;
  findings.push_back({margin.code,
                      Level::amber,
                      gear,
                      fmt::format("{} is {}, which is less than {:g} modules ({}).",
                                  fmt::format(fmt::runtime(margin.what), gear),
                                  millimetres(*clearance), margin.modules, millimetres(threshold)),
                      "",
                      {{"clearance", *clearance, true}, {"threshold", threshold, true}}});
}

// True if a warning already states that this gear has no tip clearance.
bool runs_on_root(const Pair& pair, int which) {
  const auto& warnings = pair.warnings();
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& w) {
    return w.code == WarningCode::no_tip_clearance && w.gear == which;
  });
}

}  // namespace

std::vector<Finding> margin_findings(const Pair& pair) {
  std::vector<Finding> findings;
  const double m = pair.gear(1).spec.normal_module;
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    if (!runs_on_root(pair, which))
      judge(findings, kTip, which, pair.mounted().tip_clearance[i], m);
    const InvolutePair* p = pair.involute();
    if (p == nullptr) continue;
    // The form clearance of an undercut gear is not judged, because the warnings `undercut` and
    // `contact_lost_to_undercut` already report the undercut.
    if (!p->gears[i].undercut) judge(findings, kForm, which, p->form_clearance[i], m);
    if (const ParallelPair* parallel = pair.parallel())
      judge(findings, kFillet, which, parallel->fillet_clearance[i], m);
  }
  return findings;
}

std::vector<Finding> backlash_findings(const StatedBacklash& j) {
  if (!j.none() && !j.little()) return {};
  const double recommended = j.recommended();
  const std::string there =
      j.none() ? "There is no backlash" : "The backlash is only " + millimetres(j.normal);
  return {{j.none() ? WarningCode::no_backlash : WarningCode::little_backlash,
           Level::green,
           0,
           there + "; " + recommendation(recommended) + ".",
           "",
           {{"backlash", j.normal, true}, {"threshold", recommended, true}}}};
}

std::vector<Finding> contact_findings(const PatternPlace& place) {
  std::vector<Finding> findings;
  if (place.edge_share > 0.0) {
    findings.push_back(
        {WarningCode::edge_contact,
         Level::amber,
         0,
         fmt::format("An edge is in contact during {:.0f} % of the rotation; edge contact causes "
                     "high pressure and wear.",
                     std::max(1.0, 100 * place.edge_share)),
         "",
         {{"share", place.edge_share, false}}});
  }
  if (place.mean && std::abs(*place.mean) > kCentralPlace && place.edge_share < 1.0) {
    findings.push_back(
        {WarningCode::contact_place,
         Level::amber,
         0,
         fmt::format("The contact lies near the end of the face, at {:.0f} % of half the face "
                     "width.",
                     100 * std::abs(*place.mean)),
         "",
         {{"share_of_half_face", *place.mean, false}}});
  }
  return findings;
}

namespace {

// Returns the number rounded down to three significant digits.
double rounded_down(double x) {
  const double step = std::pow(10.0, std::floor(std::log10(x)) - 2);
  return std::floor(x / step) * step;
}

}  // namespace

std::string rating_remedy(const PairRating& rating) {
  const RatedPair& pair = rating.pair;
  // A computed K_Hβ applies only to the face width and to the torque for which it was computed, so
  // no other face width or torque can be recommended.
  const bool fixed = rating.input.face_load_computed;
  const auto face = fixed
                        ? std::nullopt
                        : face_width_of_safety(pair, rating.input, rating.wanted,
                                               kMostFaceModules * pair.normal_module, rating.steps);
  const auto steel = steel_of_safety(pair, rating.input, rating.wanted, rating.steps);
  std::string text;
  if (face && *face > pair.face_width) {
    const double more = pair.halves * (*face - pair.face_width);
    const int digits = more < 1.0 ? 1 : 0;
    const double step = digits == 1 ? 10.0 : 1.0;
    text = fmt::format("{:.{}f} mm more face width", std::ceil(more * step) / step, digits);
  }
  if (steel) text += (text.empty() ? "The steel " : ", or the steel ") + *steel;
  if (!text.empty()) return text + " would be sufficient.";
  if (fixed) return "No other steel in the list would be sufficient on its own.";
  text = fmt::format(
      "No face width of up to {:g} modules and no other steel in the list would be sufficient "
      "on its own.",
      kMostFaceModules);
  if (rating.spectrum) return text;
  const auto torque = torque_of_safety(pair, rating.input, rating.wanted);
  // Rounding down ensures that the printed torque is permissible.
  if (torque)
    text += fmt::format(" The greatest permissible torque on gear 1 is {:g} N m.",
                        rounded_down(*torque));
  return text;
}

std::vector<Finding> rating_findings(const PairRating& rating) {
  std::vector<Finding> findings;
  const Rating& r = rating.rating;
  const auto judge = [&](WarningCode code, std::string_view what, int gear, double safety,
                         double wanted) {
    if (safety >= wanted) return;
    const std::string less =
        safety < 1.0 ? "less than 1" : fmt::format("less than the required {:g}", wanted);
    findings.push_back(
        {code,
         safety < 1.0 ? Level::red : Level::amber,
         gear,
         fmt::format("The safety factor of gear {} against {} is {:.2f}, which is {}.", gear, what,
                     safety, less),
         "",
         {{"safety", safety, false}, {"wanted", wanted, false}}});
  };
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    if (!rating.spectrum) {
      judge(WarningCode::root_safety, "root breakage", which, r.S_F[i].value, rating.wanted.root);
      judge(WarningCode::flank_safety, "pitting", which, r.S_H[i].value, rating.wanted.flank);
      continue;
    }
    // By ISO 6336-6, the spectrum replaces the single load, K_A and the life. With a spectrum, the
    // single load has no given life and thus life factors of 1, so its safety factors apply to an
    // unlimited life and are not judged.
    judge(WarningCode::spectrum_safety, "root breakage under the load spectrum", which,
          rating.spectrum->S_F[i], rating.wanted.root);
    judge(WarningCode::spectrum_safety, "pitting under the load spectrum", which,
          rating.spectrum->S_H[i], rating.wanted.flank);
  }
  // The findings are sorted by the ratio of the safety factor to its required value, the lowest
  // ratio first.
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return a.values.front().value / a.values.back().value <
           b.values.front().value / b.values.back().value;
  });
  return findings;
}

}  // namespace gearwright::detail
