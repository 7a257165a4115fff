#include "gearwright/catalogue/search_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "gearwright/base/units.hpp"
#include "gearwright/design/search_space.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMaxValues = 100'000;  // greatest number of values in a list
constexpr double kMinShiftStep = 0.0025;     // with this step, a wide region has half a million
                                             // points
constexpr std::size_t kMostOverlaps = 20;
constexpr KeyList kNumbers{1, kMaxValues, true};
constexpr std::array<std::string_view, 4> kSearchRacks{"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"};

constexpr const char* kBandForm = ", or a band [least, greatest]";

std::vector<std::string_view> objective_words() {
  return {kObjectiveNames.begin(), kObjectiveNames.end()};
}

// Other names of an objective.
struct Called {
  std::string_view word, objective;
};
constexpr std::array<Called, 25> kCalled{{{"weight", "mass"},
                                          {"lightest", "mass"},
                                          {"volume", "size"},
                                          {"compactness", "size"},
                                          {"diameter", "size"},
                                          {"gear_ratio", "ratio"},
                                          {"strength", "safety"},
                                          {"overlap", "contact_ratio"},
                                          {"epsilon", "contact_ratio"},
                                          {"slip", "sliding"},
                                          {"specific_sliding", "sliding"},
                                          {"loss", "efficiency"},
                                          {"losses", "efficiency"},
                                          {"eta", "efficiency"},
                                          {"friction", "efficiency"},
                                          {"price", "cost"},
                                          {"cheapest", "cost"},
                                          {"quiet", "noise"},
                                          {"quietest", "noise"},
                                          {"vibration", "noise"},
                                          {"torque_ripple", "noise"},
                                          {"transmission_error", "noise"},
                                          {"balanced", "balance"},
                                          {"balanced_safety", "balance"},
                                          {"balanced_safeties", "balance"}}};

// The modules of ISO 54, series I and series II, in mm.
constexpr std::array kFirstModules{1.0, 1.25, 1.5,  2.0,  2.5,  3.0,  4.0,  5.0,  6.0,
                                   8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0, 50.0};
constexpr std::array kSecondModules{1.125, 1.375, 1.75, 2.25, 2.75, 3.5,  4.5,  5.5,  6.5,
                                    7.0,   9.0,   11.0, 14.0, 18.0, 22.0, 28.0, 36.0, 45.0};

// Diametral pitches in general use, 1/in.   Source: Shigley, Mechanical Engineering Design, tooth
// sizes
constexpr std::array kCoarsePitches{2.0, 2.25, 2.5, 3.0, 4.0, 6.0, 8.0, 10.0, 12.0, 16.0};
constexpr std::array kFinePitches{20.0, 24.0, 32.0,  40.0,  48.0, 64.0,
                                  80.0, 96.0, 120.0, 150.0, 200.0};

// Returns the numbers of one series or of two series, in ascending order. The name `one` selects
// the first series, `two` the second series, and `both` the two series together.
template <class First, class Second>
std::vector<double> numbers_of(std::string_view name, const First& first, std::string_view one,
                               const Second& second, std::string_view two, std::string_view both) {
  std::vector<double> numbers;
  if (name == one || name == both) numbers.assign(first.begin(), first.end());
  if (name == two || name == both) numbers.insert(numbers.end(), second.begin(), second.end());
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<double> pitch_series(std::string_view name) {
  return numbers_of(name, kCoarsePitches, "coarse", kFinePitches, "fine", "coarse+fine");
}

}  // namespace

std::vector<double> module_series(std::string_view name) {
  return numbers_of(name, kFirstModules, "ISO54-I", kSecondModules, "ISO54-II", "ISO54-I+II");
}

// A diameter or centre distance, mm, at which every series and every tolerance is defined.
constexpr double kAnyDiameter = 100.0;

std::string series_fault(const std::string& series) {
  if (series.empty() || series == kNoAllowances) return {};
  const auto ends = thickness_allowances(series, kAnyDiameter);
  return ends ? std::string() : ends.error().rule;
}

KeyRange friction_range() {
  return {.lo = 0, .hi = 1, .hi_open = true, .reason = ", usually 0.03 to 0.1"};
}

std::string_view objective_called(std::string_view word) {
  const auto row =
      std::find_if(kCalled.begin(), kCalled.end(), [&](const Called& c) { return c.word == word; });
  return row == kCalled.end() ? std::string_view() : row->objective;
}

namespace {

// Makes a key for a limit. The limit is a least value, a greatest value or a margin.
template <class V>
Key limit(std::string_view key, std::string_view symbol, KeyRange range, V SearchLimits::*member,
          std::string_view fallback, std::string_view meaning) {
  const bool end = key.ends_with("_min") || key.ends_with("_max");
  const std::string field = "limits." + std::string(key.substr(0, key.size() - (end ? 4 : 0)));
  return Key::number(key, symbol, std::move(range), {&SearchProblem::limits, member}, fallback,
                     meaning)
      .with_fields({field});
}

std::string set_shaft_angle(SearchProblem& problem, double sigma_deg) {
  if (sigma_deg == 0.0) return "";
  if (!(std::abs(sigma_deg) >= 0.1))
    return "must be 0 (parallel axes) or between 0.1 and 178, with either sign";
  problem.shaft_angle = Angle::degrees(sigma_deg);
  return "";
}

void set_shifts(SearchProblem& problem, const std::array<double, 2>& band) {
  problem.limits.min_shift = band[0];
  problem.limits.max_shift = band[1];
}

// Sets the modules in ascending order. No module may occur twice.
std::string set_modules(SearchProblem& problem, const std::vector<double>& modules) {
  problem.modules = modules;
  std::sort(problem.modules.begin(), problem.modules.end());
  const auto twice = std::adjacent_find(problem.modules.begin(), problem.modules.end());
  return twice == problem.modules.end() ? "" : fmt::format("contains {} twice", *twice);
}

std::string set_pitches(SearchProblem& problem, const std::vector<double>& pitches) {
  const std::string fault = set_modules(problem, pitches);
  problem.by_pitch = true;
  for (double& p : problem.modules) p = kMmPerInch / p;
  std::reverse(problem.modules.begin(), problem.modules.end());
  return fault;
}

void set_racks(SearchProblem& problem, const std::vector<std::size_t>& racks) {
  problem.racks.clear();
  for (const std::size_t rack : racks) {
    const StraightRack iso53 = *iso53_rack(kSearchRacks[rack]);
    problem.racks.push_back({.rack = {iso53, iso53}});
  }
}

std::string set_series(SearchProblem& problem, const std::string& series) {
  problem.allowances.series = series;
  return series_fault(series);
}

std::string set_distance_tolerance(SearchProblem& problem, const std::string& tolerance) {
  problem.allowances.distance_tolerance = tolerance;
  const auto half = js_deviation(tolerance, kAnyDiameter);
  return half ? std::string() : half.error().rule;
}

std::vector<Key> trial_keys() {
  return {
      Key::number("ratio", "u", {}, &SearchProblem::ratio, kRequired,
                  "band of z2/z1 with z2 ≥ z1, for example [1.9, 2.1]; negative for internal "
                  "pairs, for example [-5, -4]")
          .with_list(kBand)
          .with_form(std::string("a number, z2/z1") + kBandForm),
      Key::number("pinion_teeth", "z1", KeyRange::between(3, kMaxSearchTeeth),
                  &SearchProblem::pinion_teeth, "[12, 40]",
                  "band of z1; wheels with at most 20 000 teeth are possible")
          .with_list(kBand)
          .with_form(std::string("a whole number, z1") + kBandForm)
          .with_also({"teeth", "z"}),
      {.key = "modules_mm",
       .symbol = "m_n",
       .words = {"ISO54-I", "ISO54-I+II", "ISO54-II"},
       .range = KeyRange::between(1e-3, 1e3, " mm"),
       .list = KeyList{.most = kMaxValues, .single = true, .series = module_series},
       .form = "\"ISO54-I\", \"ISO54-I+II\", \"ISO54-II\", a number or a list of numbers in mm",
       .place = KeyPlace::by<SearchProblem, std::vector<double>>(set_modules),
       .fallback = "`\"ISO54-I\"`",
       .meaning = "normal modules",
       .fields = {"modules"}},
      {.key = "diametral_pitches_per_in",
       .symbol = "P_nd",
       .words = {"coarse", "fine", "coarse+fine"},
       .range = KeyRange::between(kMmPerInch / 1e3, kMmPerInch * 1e3, " per inch"),
       .list = KeyList{.most = kMaxValues, .single = true, .series = pitch_series},
       .form = "\"coarse\", \"fine\", \"coarse+fine\", a number or a list of numbers in 1/in",
       .place = KeyPlace::by<SearchProblem, std::vector<double>>(set_pitches),
       .excludes = {"modules_mm"},
       .meaning =
           "normal diametral pitches, instead of `modules_mm`; the coarse series is 2 to 16, "
           "and the fine series 20 to 200",
       .fields = {"pitches"}},
      Key::positive("center_distance_mm", "a", &SearchProblem::center_distance, "free",
                    "centre distance; a single number is the exact centre distance")
          .with_list(kBand)
          .with_form(std::string("a distance in mm") + kBandForm),
      Key::number(
          "helix_angle_deg", "β", KeyRange::inside(-89, 89), {},
          "helix angle of `[gear1]`; if it is absent, [5, 30] with `overlap_ratio`, half the "
          "shaft angle for crossed axes, and otherwise 0",
          "helix angle of gear 1, or a closed band of helix angles")
          .with_list(kBand)
          .with_form(std::string("an angle") + kBandForm)
          .with_fields({"helix"}),
      Key::positive("helix_step_deg", "", {}, "1", "step of a band of helix angles")
          .with_needs({"helix_angle_deg"})
          .with_fields({"helix"}),
      Key::number("helix_angles_deg", "", KeyRange::inside(-89, 89), {}, "",
                  "list of helix angles, instead of `helix_angle_deg` and `helix_step_deg`")
          .with_list(kNumbers)
          .with_form("a list of angles")
          .with_excludes({"helix_angle_deg"})
          .with_fields({"helix"}),
      Key::number("overlap_ratio", "ε_β", KeyRange::between(1, 20), {}, "",
                  "whole overlap ratio, or a list of whole overlap ratios. Each face width gets "
                  "the helix angle with this overlap ratio, rounded up to 0.01°, so that the "
                  "overlap ratio is at least the whole number and, from 5° on, exceeds it by at "
                  "most 0.2 %. Angles outside of `helix_angle_deg` (default: [5, 30]) and angles "
                  "below 1° are not "
                  "tried. All widths of a band of face widths are tried")
          .with_list({.most = kMostOverlaps, .single = true})
          .with_form("a whole number, or a list of whole numbers")
          .with_excludes({"helix_step_deg", "face_width_diameters"},
                         "determines the helix angles itself, for face widths that do not depend "
                         "on the number of teeth; leave out helix_step_deg and "
                         "face_width_diameters")
          .with_fields({"choices"}),
      Key::number("shaft_angle_deg", "Σ", KeyRange::inside(-178, 178),
                  KeyPlace::by<SearchProblem, double>(set_shaft_angle), "0",
                  "shaft angle of crossed axes, 0.1 to 178 with either sign, or 0 for parallel "
                  "axes; the helix angle of gear 2 is β2 = Σ − β1"),
      Key::word("racks", {kSearchRacks.begin(), kSearchRacks.end()},
                KeyPlace::by<SearchProblem, std::vector<std::size_t>>(set_racks),
                "the racks of `[gear1]` and `[gear2]`; if no rack is given, α_n = 20°, h_aP* = 1, "
                "h_fP* = 1.25",
                "racks to try, each for both gears")
          .with_list(KeyList{.most = kSearchRacks.size(), .noun = "rack"})
          .with_form("a list of names, [\"ISO53-A\", \"ISO53-C\"]")};
}

std::vector<Key> limit_keys() {
  return {
      Key::number("profile_shift", "x", {},
                  KeyPlace::by<SearchProblem, std::array<double, 2>>(set_shifts),
                  "[-1, 1] for drawn designs; otherwise only undercut and tip thickness limit the "
                  "profile shifts",
                  "lower and upper limit of x1 and x2, in addition to undercut and tip thickness")
          .with_list({.most = 2,
                      .order = kBand.order,
                      .must = "must be a band [lower limit, upper limit], because a search "
                              "determines the profile shifts"})
          .with_form(std::string("limits of the profile shift") + kBandForm)
          .with_fields({"limits.min_shift", "limits.max_shift"}),
      Key::number("undercut_depth", "h_F", KeyRange::between(0, 3),
                  KeyPlace::by<SearchProblem, double>([](SearchProblem& p, double depth) {
                    p.racks.front().undercut_depth = {depth, depth};
                  }),
                  "h_fP* − ρ_fP*(1 − sin α_n) of the given rack, or 1 if no rack is given",
                  "depth of the straight edge of the rack in modules, for example 1 for a rounded "
                  "tip and 1.25 for a sharp tip")
          .with_fields({"racks.undercut_depth"}),
      limit("undercut_margin", "", KeyRange::between(-5, 5), &SearchLimits::undercut_margin, "0",
            "least difference between a profile shift and its undercut limit"),
      limit("tip_thickness_min", "s_an", KeyRange::between(0, 1.5), &SearchLimits::tip_thickness,
            "0.2", "least normal tip thickness, in modules"),
      limit("contact_ratio_min", "ε_α", KeyRange::between(0, 10), &SearchLimits::contact_ratio,
            "1.2",
            "least transverse contact ratio, both by Eq. 10 and for the part of the path on the "
            "usable flanks; for crossed axes, least AE/p_bn"),
      limit("overlap_ratio_min", "ε_β", KeyRange::between(0, 1000), &SearchLimits::overlap_ratio,
            "none", "least overlap ratio"),
      limit("sliding_max", "|ζ|", KeyRange::between(0, 1000), &SearchLimits::sliding,
            "3 for drawn designs; other designs have no limit",
            "greatest specific sliding at A and E; only for parallel axes"),
      limit("tip_clearance_min", "c", KeyRange::between(-1, 1), &SearchLimits::tip_clearance,
            "0.1 for drawn designs, 0.02 for other designs; there is no limit if `interference = "
            "\"flag\"`",
            "least tip clearance, in modules"),
      limit("form_clearance_min", "c_F", KeyRange::between(0, 1), &SearchLimits::form_clearance,
            "0.02, but 0 with `interference = \"flag\"`",
            "least distance along the line of action from a tip to the start of the mating flank, "
            "in modules [T9.9]"),
      Key::word("interference", {"exclude", "flag"},
                KeyPlace::by<SearchProblem, std::size_t>([](SearchProblem& p, std::size_t word) {
                  p.limits.avoid_interference = word == 0;
                }),
                "\"exclude\"",
                "`\"exclude\"` excludes designs in which a tip passes the start of the flank of "
                "the mating gear [T9.9], and profile shifts that put the tip circle of a gear "
                "inside its reference circle; `\"flag\"` lists and marks designs with interference")
          .with_fields({"limits.avoid_interference"}),
      Key::flag(
          "avoid_interference", {}, "value of `interference`",
          "another form of `interference`; true means `\"exclude\"`, and false means `\"flag\"`")
          .with_fields({"limits.avoid_interference"}),
      limit("safety_flank_min", "S_Hmin", KeyRange::positive(), &SearchLimits::safety_flank,
            "value of `[rating]` if designs are rated; other designs have no limit",
            "least permitted safety against pitting of both gears at the profile shifts of the "
            "design, "
            "computed as in `rate` with `[rating]` and `[gearN.material]`")
          .with_also({"sh", "sh_min", "safety_flank"}),
      limit("safety_root_min", "S_Fmin", KeyRange::positive(), &SearchLimits::safety_root,
            "value of `[rating]` if designs are rated; other designs have no limit",
            "least permitted safety against root breakage of both gears")
          .with_also({"sf", "sf_min", "safety_root"}),
      Key::flag("coprime", &SearchProblem::coprime, "false",
                "if true, only tooth numbers without a common factor (hunting tooth) are allowed")};
}

std::vector<Key> design_keys() {
  return {
      Key::word("mounting", {"extended", "tight"},
                KeyPlace::by<SearchProblem, std::size_t>([](SearchProblem& p, std::size_t word) {
                  p.mounting = word == 0 ? Mounting::extended : Mounting::tight;
                }),
                "\"tight\" for internal pairs and for drawn designs, otherwise \"extended\"",
                "kind of the centre distance; `\"extended\"` is a = a_d + m_n Σx, and `\"tight\"` "
                "is free of backlash. If this key is given without tolerances and without a band "
                "of face widths, designs have nominal teeth and are not drawn"),
      Key::flag("shorten_tips", &SearchProblem::shorten_tips, "false",
                "if true, tips are shortened by the amount by which a backlash-free centre "
                "distance reduces the tip clearance"),
      Key::positive("face_width_mm", "b", &SearchProblem::face_width,
                    "value of `[gear1]`, otherwise 10 m_n",
                    "face width of both gears; within a band, each design takes the least width "
                    "with the required safeties and overlap ratio")
          .with_list(kBand)
          .with_form(std::string("a width in mm") + kBandForm),
      Key::number("face_width_modules", "b/m_n", KeyRange::between(0.1, 1000),
                  &SearchProblem::face_modules, "10 if no other face width is given",
                  "face width in modules")
          .with_list(kBand)
          .with_form(std::string("a number") + kBandForm)
          .with_fields({"face_modules"}),
      Key::number("face_width_diameters", "b/d_1", KeyRange::between(0.01, 100),
                  &SearchProblem::face_diameters,
                  "[0.2, 1] if a safety is required and no other face width is given; in all other "
                  "cases, there is no limit",
                  "face width as a multiple of the reference diameter of the pinion")
          .with_list(kBand)
          .with_form(std::string("a number") + kBandForm)
          .with_fields({"face_diameters"}),
      Key::positive("face_width_step_mm", "", &SearchProblem::face_step, "1",
                    "step of the face width; face widths within a band are multiples of this step. "
                    "In a spec in inch, the default is 0.05 inch")
          .with_fields({"face_step"}),
      Key::text("thickness_series", KeyPlace::by<SearchProblem, std::string>(set_series),
                "\"cd25\" for drawn designs with `mounting = \"tight\"`",
                "thickness allowances of both gears by DIN 3967, for example `\"cd25\"`; "
                "`\"none\"` gives nominal teeth")
          .with_fields({"allowances.series"}),
      Key::number("backlash_mm", "j_n", KeyRange::not_negative(),
                  {&SearchProblem::allowances, &SearchAllowances::backlash},
                  "backlash by `thickness_series`",
                  "least and greatest backlash of every design in the normal section, j_bn/cos "
                  "α_wn; the teeth are thinned to give this backlash")
          .with_list(kBand)
          .with_form("a backlash in mm, or a band [least, greatest]")
          .with_excludes({"thickness_series"})
          .with_fields({"allowances.backlash"}),
      Key::text("center_distance_tolerance",
                KeyPlace::by<SearchProblem, std::string>(set_distance_tolerance), "none",
                "tolerance of the centre distance by ISO 286, for example `\"JS7\"`")
          .with_fields({"allowances.distance_tolerance"}),
      Key::number("lambda", "λ", KeyRange::between(-10, 10), &SearchProblem::lambda, "0.625",
                  "λ of the line of Eq. 11 [T2.18a] on which the profile shifts of a design are "
                  "chosen; for internal pairs the pinion has the whole profile shift"),
      Key::word("objective", objective_words(), &SearchProblem::objectives, "\"contact_ratio\"",
                "criterion of the ranking: `contact_ratio` (greatest effective contact ratio), "
                "`ratio` (nearest to `target_ratio`), `size` (least m²(z1² + z2²)), `shift` (least "
                "|Σx|), `area` (largest region), `sliding` (least |ζ|), `formula_contact_ratio` "
                "(greatest contact ratio by Eq. 10), `mass` (least mass), `safety` (greatest "
                "value of the lower of the ratios of S_H and S_F to their required values; needs "
                "`[rating]`), `efficiency` (greatest efficiency with gear 1 driving), `balance` "
                "(load reserves of flanks and roots nearest to each other; needs `[rating]`), "
                "`cost` (least mass times (b/d_1)^`cost_exponent`) or `noise` (least estimated "
                "transmission error under load; needs `[rating]`); a list of criteria gives a "
                "Pareto front")
          .with_list({.most = kObjectiveNames.size(),
                      .single = true,
                      .noun = "objective",
                      .meant = objective_called})
          .with_fields({"objectives"}),
      Key::number("loaded_designs", "", KeyRange::between(0, 1000), &SearchProblem::loaded_designs,
                  "10",
                  "for `objective` = `noise`, number of designs whose loaded transmission error is "
                  "computed as by `load`, which takes about 3 s for each design. They are the best "
                  "designs according to the estimate. If `noise` is the first criterion, they are "
                  "then sorted by the computed values")
          .with_needs({"objective"}),
      Key::number("target_ratio", "", {}, &SearchProblem::target_ratio,
                  "the middle of the band `ratio`", "target of the objective `ratio`"),
      Key::number("friction_coefficient", "μ", friction_range(), &SearchProblem::friction,
                  "0.05 for the objective `efficiency`; for other objectives, the efficiency is "
                  "computed only if the key is given",
                  "coefficient of friction of the flanks, for the efficiency")
          .with_also({"friction"}),
      Key::number(
          "cost_exponent", "e", KeyRange::between(0, 3), &SearchProblem::cost_exponent, "0.5",
          "exponent e of the factor (b/d_1)^e by which the objective `cost` multiplies the mass; b "
          "is the face width, and d_1 is the reference diameter of the pinion; 0 gives the mass"),
      Key::number("shift_step", "", KeyRange::between(kMinShiftStep, 1), &SearchProblem::shift_step,
                  "none",
                  "step of a grid of profile shifts; the feasible points of the grid are written "
                  "to `points.parquet`")};
}

}  // namespace

const KeyTable& search_keys() {
  static const KeyTable table = [] {
    KeyTable t{"search", "Inputs of a design search", {}};
    for (const auto& keys : {trial_keys(), limit_keys(), design_keys()})
      t.keys.insert(t.keys.end(), keys.begin(), keys.end());
    return t;
  }();
  return table;
}

}  // namespace gearwright
