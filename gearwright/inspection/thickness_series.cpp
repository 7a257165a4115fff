#include "gearwright/inspection/thickness_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// DIN 3967, table 1: names of the series, upper limits of the reference diameter, mm, and −E_sns,
// µm.
constexpr std::array<std::string_view, 11> kSeries{"a", "ab", "b", "bc", "c", "cd",
                                                   "d", "e",  "f", "g",  "h"};
constexpr std::array kSeriesDiameters{10.,   50.,   125.,  280.,  560.,  1000.,
                                      1600., 2500., 4000., 6300., 10000.};
constexpr std::array<std::array<int, 11>, 11> kAllowance{{
    {100, 85, 70, 58, 48, 40, 33, 22, 10, 5, 0},
    {135, 110, 95, 75, 65, 54, 44, 30, 14, 7, 0},
    {180, 150, 125, 105, 85, 70, 60, 40, 19, 9, 0},
    {250, 200, 170, 140, 115, 95, 80, 56, 26, 12, 0},
    {330, 280, 230, 190, 155, 130, 110, 75, 35, 17, 0},
    {450, 370, 310, 260, 210, 175, 145, 100, 48, 22, 0},
    {600, 500, 420, 340, 290, 240, 200, 135, 64, 30, 0},
    {820, 680, 560, 460, 390, 320, 270, 180, 85, 41, 0},
    {1100, 920, 760, 620, 520, 430, 360, 250, 115, 56, 0},
    {1500, 1250, 1020, 840, 700, 580, 480, 330, 155, 75, 0},
    {2000, 1650, 1350, 1150, 940, 780, 640, 450, 210, 100, 0},
}};
// Table 2: T_sn, µm, of the series 21 to 30.
constexpr int kFirstTolerance = 21;
constexpr std::array<std::array<int, 10>, 11> kTolerance{{
    {3, 5, 8, 12, 20, 30, 50, 80, 130, 200},
    {5, 8, 12, 20, 30, 50, 80, 130, 200, 300},
    {6, 10, 16, 25, 40, 60, 100, 160, 250, 400},
    {8, 12, 20, 30, 50, 80, 130, 200, 300, 500},
    {10, 16, 25, 40, 60, 100, 160, 250, 400, 600},
    {12, 20, 30, 50, 80, 130, 200, 300, 500, 800},
    {16, 25, 40, 60, 100, 160, 250, 400, 600, 1000},
    {20, 30, 50, 80, 130, 200, 300, 500, 800, 1300},
    {25, 40, 60, 100, 160, 250, 400, 600, 1000, 1600},
    {30, 50, 80, 130, 200, 300, 500, 800, 1300, 2000},
    {40, 60, 100, 160, 250, 400, 600, 1000, 1600, 2400},
}};

// ISO 286-1, table 1: upper limits of the nominal size, mm, and IT1 to IT12, µm.
constexpr std::array kSizes{3.,   6.,   10.,  18.,  30.,   50.,   80.,   120.,  180.,  250., 315.,
                            400., 500., 630., 800., 1000., 1250., 1600., 2000., 2500., 3150.};
constexpr std::array<std::array<double, 12>, 21> kGrades{{
    {0.8, 1.2, 2, 3, 4, 6, 10, 14, 25, 40, 60, 100},
    {1, 1.5, 2.5, 4, 5, 8, 12, 18, 30, 48, 75, 120},
    {1, 1.5, 2.5, 4, 6, 9, 15, 22, 36, 58, 90, 150},
    {1.2, 2, 3, 5, 8, 11, 18, 27, 43, 70, 110, 180},
    {1.5, 2.5, 4, 6, 9, 13, 21, 33, 52, 84, 130, 210},
    {1.5, 2.5, 4, 7, 11, 16, 25, 39, 62, 100, 160, 250},
    {2, 3, 5, 8, 13, 19, 30, 46, 74, 120, 190, 300},
    {2.5, 4, 6, 10, 15, 22, 35, 54, 87, 140, 220, 350},
    {3.5, 5, 8, 12, 18, 25, 40, 63, 100, 160, 250, 400},
    {4.5, 7, 10, 14, 20, 29, 46, 72, 115, 185, 290, 460},
    {6, 8, 12, 16, 23, 32, 52, 81, 130, 210, 320, 520},
    {7, 9, 13, 18, 25, 36, 57, 89, 140, 230, 360, 570},
    {8, 10, 15, 20, 27, 40, 63, 97, 155, 250, 400, 630},
    {9, 11, 16, 22, 32, 44, 70, 110, 175, 280, 440, 700},
    {10, 13, 18, 25, 36, 50, 80, 125, 200, 320, 500, 800},
    {11, 15, 21, 28, 40, 56, 90, 140, 230, 360, 560, 900},
    {13, 18, 24, 33, 47, 66, 105, 165, 260, 420, 660, 1050},
    {15, 21, 29, 39, 55, 78, 125, 195, 310, 500, 780, 1250},
    {18, 25, 35, 46, 65, 92, 150, 230, 370, 600, 920, 1500},
    {22, 30, 41, 55, 78, 110, 175, 280, 440, 700, 1100, 1750},
    {26, 36, 50, 68, 96, 135, 210, 330, 540, 860, 1350, 2100},
}};

constexpr int kMaxGrade = 12;

// Magnitudes, µm, of the negative fundamental deviations of ISO 286-1, table 3. kDeviationP
// contains the values of P for grades above IT7 and the first sizes of kSizes. kDeviationN is the
// value of N for grades above IT8 and sizes up to 3 mm. For greater sizes, the deviation of N is 0.
constexpr std::array kDeviationP{6., 12., 15., 18., 22., 26., 32., 37.};
constexpr double kDeviationN = 4.0;

// Returns the index of the first border that is not less than the value, or the number of borders
// if all borders are less.
template <std::size_t n>
std::size_t row_of(const std::array<double, n>& borders, double value) {
  return static_cast<std::size_t>(std::lower_bound(borders.begin(), borders.end(), value) -
                                  borders.begin());
}

// Returns the number of a grade of ISO 286, or 0 if the text is not a grade.
int grade_of(std::string_view text) {
  const std::int64_t grade = whole_number(text).value_or(0);
  return grade > 0 && grade <= kMaxGrade ? static_cast<int>(grade) : 0;
}

// Returns the standard tolerance of a grade for a nominal size, mm, or none beyond the table.
std::optional<double> tolerance_grade(int grade, double size) {
  const std::size_t row = row_of(kSizes, size);
  if (row == kSizes.size()) return std::nullopt;
  return kGrades[row][static_cast<std::size_t>(grade - 1)] / kUmPerMm;
}

}  // namespace

Result<std::array<double, 2>> thickness_allowances(std::string_view series,
                                                   double reference_diameter) {
  const std::size_t digits = std::min(series.find_first_of("0123456789"), series.size());
  const auto* const name = std::find(kSeries.begin(), kSeries.end(), series.substr(0, digits));
  const auto number = whole_number(series.substr(digits));
  const std::int64_t column = number.value_or(0) - kFirstTolerance;
  if (name == kSeries.end() || column < 0 || column >= 10) {
    return Error{"series", std::string(series),
                 "must be a series of DIN 3967 (a, ab, b, bc, c, cd, d, e, f, g or h) with a "
                 "tolerance series from 21 to 30, for example cd25"};
  }
  const std::size_t row = row_of(kSeriesDiameters, reference_diameter);
  if (row == kSeriesDiameters.size())
    return Error{"series", std::string(series),
                 fmt::format("DIN 3967 covers reference diameters of at most 10000 mm, but the "
                             "reference diameter of this gear is {} mm",
                             format_number(reference_diameter))};
  const double upper = -kAllowance[row][static_cast<std::size_t>(name - kSeries.begin())];
  const double tolerance = kTolerance[row][static_cast<std::size_t>(column)];
  return std::array{(upper - tolerance) / kUmPerMm, upper / kUmPerMm};
}

Result<double> js_deviation(std::string_view tolerance, double center_distance) {
  const bool js = tolerance.starts_with("JS") || tolerance.starts_with("js");
  const int grade = js ? grade_of(tolerance.substr(2)) : 0;
  if (grade == 0)
    return Error{"distance_tolerance", std::string(tolerance), "must be JS1 to JS12 of ISO 286"};
  const auto it = tolerance_grade(grade, center_distance);
  if (!it)
    return refused("center_distance", center_distance,
                   "is outside the range of ISO 286, which ends at 3150 mm");
  return *it / 2;
}

Result<std::array<double, 2>> hole_deviations(std::string_view fit, double size) {
  const std::size_t digits = std::min(fit.find_first_of("0123456789"), fit.size());
  const std::string_view zone = fit.substr(0, digits);
  const int grade = grade_of(fit.substr(digits));
  const bool keyway = fit == "N9" || fit == "P9";
  if (!keyway && (grade == 0 || (zone != "H" && zone != "JS")))
    return Error{"fit", std::string(fit), "must be H1 to H12, JS1 to JS12, N9 or P9 of ISO 286"};
  const auto it = tolerance_grade(grade, size);
  const std::size_t row = row_of(kSizes, size);
  if (!it || (keyway && row >= kDeviationP.size()))
    return refused("size", size,
                   keyway ? "N9 and P9 are fits of keyways, which are at most 120 mm wide"
                          : "is outside the range of ISO 286, which ends at 3150 mm");
  if (zone == "H") return std::array{0.0, *it};
  if (zone == "JS") return std::array{-*it / 2, *it / 2};
  const double upper = -(zone == "P" ? kDeviationP[row] : row == 0 ? kDeviationN : 0.0) / kUmPerMm;
  return std::array{upper - *it, upper};
}

Result<std::array<double, 2>> tip_deviations(std::string_view fit, double tip_diameter,
                                             double side) {
  // The letters of the two permitted tolerance zones, and words for the message.
  using Words = std::array<std::string_view, 4>;
  const auto [one_sided, symmetric, gear, tip] =
      side > 0.0 ? Words{"h", "js", "external", "shaft"} : Words{"H", "JS", "internal", "hole"};
  const std::string_view zone =
      fit.substr(0, std::min(fit.find_first_of("0123456789"), fit.size()));
  const bool known = zone == one_sided || zone == symmetric;
  const std::string_view grade = fit.substr(zone.size());
  if (!known || grade_of(grade) == 0)
    return Error{"tolerance.tip_fit", std::string(fit),
                 fmt::format("must be {0}1 to {0}12 or {1}1 to {1}12 of ISO 286, for example {0}9, "
                             "because the tip of an {2} gear is a {3}",
                             one_sided, symmetric, gear, tip)};
  const auto hole =
      hole_deviations((zone.size() == 1 ? "H" : "JS") + std::string(grade), tip_diameter);
  if (!hole) return Error{"tip_diameter", hole.error().value, hole.error().rule};
  const auto [lower, upper] = std::minmax({-side * (*hole)[0], -side * (*hole)[1]});
  return std::array{lower + 0.0, upper + 0.0};  // −0 becomes 0
}

std::optional<HubKeyway> hub_keyway(double bore) {
  // The greatest bore of each row, the width of its key and the depth in the hub, mm.
  struct Row {
    double most;
    HubKeyway keyway;
  };
  constexpr std::array<Row, 24> kRows{
      {{8, {2, 1.0}},     {10, {3, 1.4}},    {12, {4, 1.8}},    {17, {5, 2.3}},
       {22, {6, 2.8}},    {30, {8, 3.3}},    {38, {10, 3.3}},   {44, {12, 3.3}},
       {50, {14, 3.8}},   {58, {16, 4.3}},   {65, {18, 4.4}},   {75, {20, 4.9}},
       {85, {22, 5.4}},   {95, {25, 5.4}},   {110, {28, 6.4}},  {130, {32, 7.4}},
       {150, {36, 8.4}},  {170, {40, 9.4}},  {200, {45, 10.4}}, {230, {50, 11.4}},
       {260, {56, 12.4}}, {290, {63, 12.4}}, {330, {70, 14.4}}, {380, {80, 15.4}}}};
  static_assert(kRows.back().most == kKeyedBores[1]);
  if (!(bore >= kKeyedBores[0] && bore <= kKeyedBores[1])) return std::nullopt;
  return std::find_if(kRows.begin(), kRows.end(), [&](const Row& row) { return bore <= row.most; })
      ->keyway;
}

double keyway_depth_deviation(double width) {
  constexpr double kNarrow = 6.0, kMedium = 32.0;  // widths of keys 6 x 6 and 32 x 18, mm
  return width <= kNarrow ? 0.1 : width <= kMedium ? 0.2 : 0.3;
}

}  // namespace gearwright
