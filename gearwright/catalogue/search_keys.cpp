#include "gearwright/catalogue/search_keys.hpp"

#include <algorithm>
#include <array>

#include "gearwright/design/search_space.hpp"

namespace gearwright {

namespace {

using Range = KeyRange;
using P = SearchProblem;

constexpr std::size_t kMaxValues = 100'000;  // of one list
constexpr double kMinShiftStep = 0.0025;     // half a million points of a wide region
constexpr KeyList kBand{1, 2, true};
constexpr KeyList kNumbers{1, kMaxValues, true};

constexpr const char* kBandForm = ", or a band [least, greatest]";

std::vector<std::string_view> objective_words() {
  return {kObjectiveNames.begin(), kObjectiveNames.end()};
}

// What people call an objective.
struct Called {
  std::string_view word, objective;
};
constexpr std::array<Called, 11> kCalled{{{"weight", "mass"},
                                          {"lightest", "mass"},
                                          {"volume", "size"},
                                          {"compactness", "size"},
                                          {"diameter", "size"},
                                          {"gear_ratio", "ratio"},
                                          {"strength", "safety"},
                                          {"overlap", "contact_ratio"},
                                          {"epsilon", "contact_ratio"},
                                          {"slip", "sliding"},
                                          {"specific_sliding", "sliding"}}};

// A number among the limits.
template <class F>
KeyPlace limit(F reach) {
  return KeyPlace::within<P>([reach](auto& p) -> auto& { return reach(p.limits); });
}

std::vector<Key> trial_keys() {
  return {
      {.key = "ratio",
       .symbol = "u",
       .list = kBand,
       .form = std::string("z2/z1, one number") + kBandForm,
       .required = true,
       .meaning = "the band of z2/z1, [1.9, 2.1]; z2 ≥ z1; negative for internal pairs, "
                  "[-5, -4]"},
      {.key = "pinion_teeth",
       .symbol = "z1",
       .kind = KeyKind::whole,
       .range = Range::between(3, kMaxSearchTeeth),
       .list = kBand,
       .form = std::string("z1, a whole number") + kBandForm,
       .required = true,
       .meaning = "the band of z1, [12, 40]; wheels have at most 20 000 teeth",
       .also = {"teeth", "z"}},
      {.key = "modules_mm",
       .symbol = "m_n",
       .words = {"ISO54-I", "ISO54-I+II", "ISO54-II"},
       .range = Range::between(1e-3, 1e3, " mm"),
       .list = kNumbers,
       .form = "\"ISO54-I\", \"ISO54-I+II\", \"ISO54-II\", a number or a list of numbers in mm",
       .required = true,
       .meaning = "normal modules",
       .fields = {"modules"}},
      {.key = "center_distance_mm",
       .symbol = "a",
       .range = Range::positive(),
       .list = kBand,
       .form = std::string("a distance in mm") + kBandForm,
       .fallback = "free",
       .meaning = "centre distance; one number: exactly that"},
      {.key = "helix_angle_deg",
       .symbol = "β",
       .range = Range::inside(-89, 89),
       .list = kBand,
       .form = std::string("an angle") + kBandForm,
       .fallback = "that of `[gear1]`, else 0; crossed: half the shaft angle",
       .meaning = "helix angle of gear 1; a band's end belongs to it",
       .fields = {"helix"}},
      {.key = "helix_step_deg",
       .range = Range::positive(),
       .needs = {"helix_angle_deg"},
       .fallback = "1",
       .meaning = "step of a band of helix angles",
       .fields = {"helix"}},
      {.key = "helix_angles_deg",
       .range = Range::inside(-89, 89),
       .list = kNumbers,
       .form = "a list of angles",
       .excludes = {"helix_angle_deg"},
       .meaning = "a list of helix angles instead",
       .fields = {"helix"}},
      {.key = "shaft_angle_deg",
       .symbol = "Σ",
       .range = Range::inside(-178, 178),
       .fallback = "0",
       .meaning = "shaft angle of crossed axes, 0.1 to 178 of either sign, or 0: parallel axes; "
                  "gear 2 has β2 = Σ − β1"},
      {.key = "racks",
       .kind = KeyKind::word,
       .words = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"},
       .list = KeyList{1, 4},
       .form = "a list of names, [\"ISO53-A\", \"ISO53-C\"]",
       .fallback = "those of `[gear1]`, `[gear2]`; else α_n 20°, h_aP* 1, h_fP* 1.25",
       .meaning = "racks to try, each for both gears"}};
}

std::vector<Key> limit_keys() {
  return {
      {.key = "profile_shift",
       .symbol = "x",
       .list = KeyList{1, 2},
       .form = std::string("floor and ceiling of x") + kBandForm,
       .fallback = "those two alone",
       .meaning = "floor and ceiling of x1 and x2, beside undercut and tip thickness",
       .fields = {"limits.min_shift", "limits.max_shift"}},
      {.key = "undercut_depth",
       .symbol = "h_F",
       .range = Range::between(0, 3),
       .fallback = "of the rack if one is given, h_fP* − ρ_fP*(1 − sin α_n), else 1",
       .meaning = "depth of the rack's straight edge in modules: 1 for a rounded tip, 1.25 for a "
                  "sharp one",
       .fields = {"racks.undercut_depth"}},
      {.key = "undercut_margin",
       .range = Range::between(-5, 5),
       .place = limit([](auto& l) -> auto& { return l.undercut_margin; }),
       .fallback = "0",
       .meaning = "x ≥ the undercut limit plus this",
       .fields = {"limits.undercut_margin"}},
      {.key = "tip_thickness_min",
       .symbol = "s_an",
       .range = Range::between(0, 1.5),
       .place = limit([](auto& l) -> auto& { return l.tip_thickness; }),
       .fallback = "0.2",
       .meaning = "least normal tip thickness, in modules",
       .fields = {"limits.tip_thickness"}},
      {.key = "contact_ratio_min",
       .symbol = "ε_α",
       .range = Range::between(0, 10),
       .place = limit([](auto& l) -> auto& { return l.contact_ratio; }),
       .fallback = "1.2",
       .meaning = "least transverse contact ratio, of Eq. 10 and of the path clipped to the "
                  "usable flanks; crossed: of AE",
       .fields = {"limits.contact_ratio"}},
      {.key = "overlap_ratio_min",
       .symbol = "ε_β",
       .range = Range::between(0, 1000),
       .place = limit([](auto& l) -> auto& { return l.overlap_ratio; }),
       .fallback = "none",
       .meaning = "least overlap ratio, with the face width",
       .fields = {"limits.overlap_ratio"}},
      {.key = "sliding_max",
       .symbol = "|ζ|",
       .range = Range::between(0, 1000),
       .place = limit([](auto& l) -> auto& { return l.sliding; }),
       .fallback = "none",
       .meaning = "greatest specific sliding at A and E, parallel axes",
       .fields = {"limits.sliding"}},
      {.key = "tip_clearance_min",
       .symbol = "c",
       .range = Range::between(-1, 1),
       .place = limit([](auto& l) -> auto& { return l.tip_clearance; }),
       .fallback = "0.02; none with `interference = \"flag\"`",
       .meaning = "least tip clearance, in modules",
       .fields = {"limits.tip_clearance"}},
      {.key = "form_clearance_min",
       .symbol = "c_F",
       .range = Range::between(0, 1),
       .place = limit([](auto& l) -> auto& { return l.form_clearance; }),
       .fallback = "0.02; 0 with `interference = \"flag\"`",
       .meaning =
           "how far a tip stays from the start of the mating gear's flank, along the line of "
           "action, in modules [T9.9]",
       .fields = {"limits.form_clearance"}},
      {.key = "interference",
       .kind = KeyKind::word,
       .words = {"exclude", "flag"},
       .fallback = "\"exclude\"",
       .meaning =
           "`\"exclude\"`: a tip may not pass the start of the mating gear's flank [T9.9]; "
           "shifts with a tip inside its own reference circle are then left out; `\"flag\"`: "
           "designs that interfere are listed too, and each says so",
       .fields = {"limits.avoid_interference"}},
      {.key = "avoid_interference",
       .kind = KeyKind::boolean,
       .fallback = "that of `interference`",
       .meaning = "the same as a switch: true is `\"exclude\"`, false `\"flag\"`",
       .fields = {"limits.avoid_interference"}},
      {.key = "safety_flank_min",
       .symbol = "S_Hmin",
       .range = Range::positive(),
       .place = limit([](auto& l) -> auto& { return l.safety_flank; }),
       .fallback = "of `[rating]`, where designs are rated; else none",
       .meaning = "least safety against pitting of both gears, by `[rating]` and "
                  "`[gearN.material]` as `rate` has it, at the shifts of the design",
       .fields = {"limits.safety_flank"},
       .also = {"sh_min", "safety_flank"}},
      {.key = "safety_root_min",
       .symbol = "S_Fmin",
       .range = Range::positive(),
       .place = limit([](auto& l) -> auto& { return l.safety_root; }),
       .fallback = "of `[rating]`, where designs are rated; else none",
       .meaning = "least safety against root breakage, the same",
       .fields = {"limits.safety_root"},
       .also = {"sf_min", "safety_root"}},
      {.key = "coprime",
       .kind = KeyKind::boolean,
       .place = &P::coprime,
       .fallback = "false",
       .meaning = "hunting teeth: only z1, z2 without a common factor; others are not counted"}};
}

std::vector<Key> design_keys() {
  return {{.key = "mounting",
           .kind = KeyKind::word,
           .words = {"extended", "tight"},
           .fallback = "\"extended\"; of internal pairs \"tight\"",
           .meaning = "`\"extended\"`, a = a_d + m_n Σx; or `\"tight\"`, free of backlash"},
          {.key = "shorten_tips",
           .kind = KeyKind::boolean,
           .place = &P::shorten_tips,
           .fallback = "false",
           .meaning = "tips cut back by what tight centres take from the clearance"},
          {.key = "face_width_mm",
           .symbol = "b",
           .range = Range::positive(),
           .place = &P::face_width,
           .fallback = "of `[gear1]`, else 10 m_n",
           .meaning = "face width of both gears"},
          {.key = "face_width_modules",
           .symbol = "b/m_n",
           .range = Range::between(0.1, 1000),
           .place = &P::face_modules,
           .excludes = {"face_width_mm"},
           .fallback = "10",
           .meaning = "face width of both gears in modules, where it is not given in mm",
           .fields = {"face_modules"}},
          {.key = "lambda",
           .symbol = "λ",
           .range = Range::between(-10, 10),
           .place = &P::lambda,
           .fallback = "0.625",
           .meaning = "λ of the line of Eq. 11 [T2.18a] on which a design's shifts are chosen; a "
                      "internal gear's pinion takes all"},
          {.key = "objective",
           .kind = KeyKind::word,
           .words = objective_words(),
           .list = KeyList{1, kObjectiveNames.size(), true},
           .fallback = "\"contact_ratio\"",
           .meaning = "what is better: `contact_ratio` (greatest effective), `ratio` (nearest to "
                      "`target_ratio`), `size` (least m²(z1² + z2²)), `shift` (least |Σx|), `area` "
                      "(largest region), `sliding` (least |ζ|), `formula_contact_ratio` (greatest "
                      "by Eq. 10), `mass` (least), `safety` (the greatest least of S_H and S_F, "
                      "over those wanted; needs `[rating]`); or a list of them: a Pareto front",
           .fields = {"objectives"}},
          {.key = "target_ratio",
           .place = &P::target_ratio,
           .fallback = "the middle of the band",
           .meaning = "target of the objective `ratio`"},
          {.key = "shift_step",
           .range = Range::between(kMinShiftStep, 1),
           .place = &P::shift_step,
           .fallback = "none",
           .meaning = "step of a grid of shifts whose feasible points are wanted too, in "
                      "`points.parquet`"}};
}

}  // namespace

const KeyTable& search_keys() {
  static const KeyTable table = [] {
    KeyTable t{"search", "What a design search is asked", {}};
    for (const auto& keys : {trial_keys(), limit_keys(), design_keys()})
      t.keys.insert(t.keys.end(), keys.begin(), keys.end());
    return t;
  }();
  return table;
}

std::string_view objective_called(std::string_view word) {
  const auto row =
      std::find_if(kCalled.begin(), kCalled.end(), [&](const Called& c) { return c.word == word; });
  return row == kCalled.end() ? std::string_view() : row->objective;
}

}  // namespace gearwright
