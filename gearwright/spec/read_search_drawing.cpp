#include "gearwright/spec/read_search_drawing.hpp"

#include <array>

#include "gearwright/arrange/design_drawing.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

namespace {

constexpr const char* kNoAllowances = "none";
constexpr const char* kUsualSeries = "cd25";

// Face widths in reference diameters of the pinion: the shaft of a wider pinion bends and
// twists too much for its whole face to carry, and narrower gears are rare in reducers.
constexpr std::array kUsualFace{0.2, 1.0};

// A gear and a centre distance that every table covers: only the names are checked here.
constexpr double kAnyDiameter = 100.0;

void check_names(const TableReader& t, const SearchAllowances& allowances) {
  if (!allowances.series.empty())
    if (const auto ends = thickness_allowances(allowances.series, kAnyDiameter); !ends)
      t.fail("thickness_series", ends.error().rule);
  if (const auto& tolerance = allowances.distance_tolerance)
    if (const auto half = js_deviation(*tolerance, kAnyDiameter); !half)
      t.fail("center_distance_tolerance", half.error().rule);
}

// The first of the keys that the table has.
std::string given_of(const TableReader& t, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (t.given(key)) return key;
  return {};
}

void check_faces(const TableReader& t, const SearchProblem& p) {
  if (!p.sizes_faces()) return;
  const std::string key =
      given_of(t, {"face_width_mm", "face_width_modules", "face_width_diameters"});
  if (p.crossed())
    t.fail(key, "must be one width on crossed axes, where a search does not choose it");
  if (p.shift_step) t.fail(key, "must be one width beside shift_step, whose points are not rated");
  if (!p.limits.safety_flank && !p.limits.safety_root && !p.limits.overlap_ratio)
    t.fail(key,
           "is a band, of which each design takes the least width that holds; give "
           "safety_flank_min, safety_root_min or overlap_ratio_min too, or one width");
}

}  // namespace

void read_search_drawing(const Json& search, SearchProblem& p) {
  const TableReader t(search_keys(), search, "search");
  const bool wide = p.face_width || p.face_modules || p.face_diameters;
  const bool safe = p.limits.safety_flank || p.limits.safety_root;
  if (safe && !wide && !p.crossed() && !p.shift_step) p.face_diameters = kUsualFace;
  SearchAllowances& allowances = p.allowances;
  const bool no_allowances = allowances.series == kNoAllowances;
  if (no_allowances) allowances.series.clear();
  check_names(t, allowances);
  check_faces(t, p);
  const std::string tolerance =
      given_of(t, {"thickness_series", "backlash_mm", "center_distance_tolerance"});
  const bool toleranced = allowances.thin_teeth() || allowances.distance_tolerance;
  if (toleranced && p.crossed())
    t.fail(tolerance, "is not available on crossed axes; give it to the pair that --take writes");
  if (toleranced && p.shift_step)
    t.fail(tolerance, "cannot be combined with shift_step, whose points are not drawn");
  if (toleranced && !p.limits.avoid_interference)
    t.fail(tolerance, "needs interference = \"exclude\", because only designs that run are drawn");
  const bool wanted = toleranced || no_allowances || p.sizes_faces();
  const bool drawn = wanted && !p.crossed() && !p.shift_step && p.limits.avoid_interference;
  if (drawn && !t.given("mounting")) p.mounting = Mounting::tight;
  if (p.shorten_tips && (p.mounting != Mounting::tight || p.crossed())) {
    t.fail("shorten_tips",
           "needs mounting = \"tight\" on parallel axes, because the extended centre distance "
           "keeps the full clearance");
  }
  if (!drawn) return;
  const bool backlash_is_made = allowances.thin_teeth() || p.mounting == Mounting::extended;
  if (!backlash_is_made && !no_allowances) allowances.series = kUsualSeries;
  SearchLimits& limits = p.limits;
  if (!t.given("profile_shift")) {
    limits.min_shift = -kDrawnShift;
    limits.max_shift = kDrawnShift;
  }
  if (!t.given("sliding_max")) limits.sliding = kDrawnSliding;
  if (!t.given("tip_clearance_min")) limits.tip_clearance = kMarginTip;
  p.draw = judge_drawing;
}

}  // namespace gearwright
