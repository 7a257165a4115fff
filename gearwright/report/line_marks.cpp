#include "gearwright/report/line_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kAside = 15.0;  // px from the line to the middle of a letter

// Lengths as fractions of the width of a plot.
constexpr double kLetterRoom = 0.04;  // distance between two letters
constexpr double kCharacter = 0.0155;
constexpr double kLetterHeight = 0.054;

constexpr double kTouchingLines = 0.003;  // share of the width; nearer lines count as touching
constexpr double kFar = 3.2;  // path lengths; line_ends() omits points farther from the path

std::vector<PathMark> marks_of(const CrossedPair& pair, bool leading) {
  const Mesh<double>& m = pair.mesh;
  const char* end = leading ? "mark action-dot" : "mark trailing-dot";
  std::vector<PathMark> marks{
      {leading ? "A" : "A′", m.rho1_A, end},
      {leading ? "E" : "E′", m.rho1_E, end},
      {leading ? "T_1" : "T_1′", 0.0, "mark hollow"},
      {leading ? "T_2" : "T_2′", m.sigma * m.base_tangent_distance, "mark hollow"}};
  if (leading) marks.push_back({"C", m.rho1_C, "mark pitch-dot"});
  return marks;
}

// Returns the side of a line on which the letter of the point p is drawn. In general, this side
// faces away from the other line. If the distance between the lines is at most `touching`, the
// letters of the leading line are above it, and the letters of the trailing line are below it.
Vec2 letter_side(const Vec2& p, const Vec2& along, const Vec2& other_from, const Vec2& other_along,
                 double touching, bool leading) {
  const Vec2 across(-along.y(), along.x());
  const Vec2 other_across(-other_along.y(), other_along.x());
  const double away = (p - other_from).dot(other_across);
  const double side = std::abs(away) > touching ? away * other_across.dot(across)
                                                : (leading ? 1.0 : -1.0) * across.y();
  return side < 0.0 ? Vec2(-across) : across;
}

}  // namespace

std::vector<PathMark> path_marks(const Mesh<double>& m, double last) {
  std::vector<PathMark> marks{
      {"A", m.rho1_A}, {"B", m.rho1_B}, {"C", m.rho1_C}, {"D", m.rho1_D}, {"E", m.rho1_E}};
  std::erase_if(marks, [&](const PathMark& k) { return k.rho1 < m.rho1_A || k.rho1 > last; });
  return marks;
}

void add_letters(Figure& f, const std::vector<LetterAt>& letters) {
  const double wide = f.x.hi - f.x.lo, tall = f.y.hi - f.y.lo;
  const double bend = f.y.hi, edge = bend + 0.02 * tall;
  f.y.hi += kLetterHeight / f.tall * tall;
  f.x.lo -= kLetterRoom / 2 * wide;
  f.x.hi += kLetterRoom / 2 * wide;
  std::vector<double> wanted;
  std::size_t longest = 0;
  for (const LetterAt& l : letters) {
    wanted.push_back(l.at.x());
    longest = std::max(longest, without_tags(l.letter).size());
  }
  const double room = std::max(kLetterRoom, kCharacter * static_cast<double>(longest)) * wide;
  const double inset = 0.5 * (room - kLetterRoom * wide);
  const std::vector<double> placed = spread(wanted, room, f.x.lo + inset, f.x.hi - inset);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const LetterAt& l = letters[i];
    f.line({{placed[i], edge}, {wanted[i], bend - 0.05 * tall}, l.at}, l.line_style);
    f.text({placed[i], kInfinity}, l.letter, Anchor::middle, l.style, {0.0, 16.0});
  }
}

std::vector<double> line_ends(const CrossedPair& pair) {
  const Mesh<double>& m = pair.mesh;
  std::vector<double> ends{m.rho1_A, m.rho1_E};
  for (const double rho1 : {0.0, m.sigma * m.base_tangent_distance, m.rho1_C}) {
    const double away = std::min(std::abs(rho1 - m.rho1_A), std::abs(rho1 - m.rho1_E));
    if (away < kFar * std::abs(m.path_length)) ends.push_back(rho1);
  }
  return ends;
}

void add_lines_of_action(Figure& f, const CrossedPair& pair,
                         const std::function<Vec2(const Point<Housing>&)>& on, Lines lines) {
  const Mesh<double>& m = pair.mesh;
  const std::array<double, 5> ends{m.rho1_A, m.rho1_E, 0.0, m.sigma * m.base_tangent_distance,
                                   m.rho1_C};
  const auto [from, to] = std::minmax_element(ends.begin(), ends.end());
  const auto on_line = [&](bool leading, double rho1) {
    return on(leading ? pair.on_line_of_action(rho1) : pair.on_trailing_line(rho1));
  };
  for (const bool leading : {false, true}) {
    if (!leading && lines == Lines::leading) continue;
    const auto at = [&](double rho1) { return on_line(leading, rho1); };
    const std::string style = leading ? "action" : "trailing";
    f.line({at(*from), at(*to)}, style + "-line");
    if (pair.flanks_meet()) {
      f.line({at(m.rho1_A), at(m.rho1_E)}, style + " reached");
      if (m.rho1_true_begin < m.rho1_true_end)
        f.line({at(m.rho1_true_begin), at(m.rho1_true_end)}, style);
    }
    const Vec2 along = (at(*to) - at(*from)).normalized();
    const Vec2 other_from = on_line(!leading, *from);
    const Vec2 other_along = (on_line(!leading, *to) - other_from).normalized();
    for (const PathMark& mark : marks_of(pair, leading)) {
      const Vec2 p = at(mark.rho1);
      const Vec2 side = letter_side(p, along, other_from, other_along,
                                    kTouchingLines * (f.x.hi - f.x.lo), leading);
      f.point(p, 3.4, mark.style, symbol_svg(mark.letter), kAside * Vec2(side.x(), -side.y()));
    }
  }
}

std::string line_key() {
  return caption_key("action", "leading line A–E") + " " +
         caption_key("trailing", "trailing line A′–E′") +
         " Contact starts at A, at the tip of gear 2, and ends at E, at the tip of gear 1. C is "
         "the pitch point of gear 1, and T are the base tangent points.";
}

}  // namespace gearwright
