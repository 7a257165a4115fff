#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"
#include "gearwright/report/search_figures.hpp"
#include "gearwright/report/search_words.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 84, 18, 40, 400, 54};
constexpr double kFree = 0.06;  // of an axis, left free at both ends

enum class Along { objective, distance, ratio };

// A quantity along an axis.
struct Quantity {
  std::string words;  // SVG text content
  std::string plain;
  Along along;
  bool greater;  // of objectives: greater is better
};

struct Dot {
  Vec2 value;
  const DesignRow* row;
  bool front;
};

Quantity quantity_of(Objective objective) {
  const ObjectiveWords w = words_of(objective);
  std::string words = escaped(w.name);
  if (!w.symbol.empty()) words += " " + symbol_svg(w.symbol);
  if (!w.unit.empty()) words += fmt::format(", {}", w.unit);
  words += w.greater ? " (greater is better)" : " (less is better)";
  return {words, std::string(w.name), Along::objective, w.greater};
}

std::string title_of(const DesignRow& row, const Vec2& value) {
  return fmt::format("{}: x1 = {}, x2 = {}; {:.6g}, {:.6g}", design_name(row.trial),
                     fixed(row.shift[0], 4), fixed(row.shift[1], 4), value.x(), value.y());
}

// What one objective is shown over: the centre distance, or the ratio where the distance is given.
Quantity across_one_objective(const SearchProblem& problem) {
  const auto& band = problem.center_distance;
  if (band && (*band)[0] == (*band)[1])
    return {"gear ratio " + symbol_svg("u"), "gear ratio", Along::ratio, false};
  return {"centre distance " + symbol_svg("a") + ", mm", "centre distance", Along::distance, false};
}

std::vector<Dot> dots_of(const SearchProblem& problem, const SearchAnswer& answer, Along across) {
  const bool plane = across == Along::objective;
  std::vector<bool> front(answer.designs.size(), false);
  for (const std::size_t i : answer.pareto) front[i] = true;
  std::vector<Dot> dots;
  for (std::size_t i = 0; i < answer.designs.size(); ++i) {
    if (i >= kMaxDots && !front[i]) continue;
    const DesignRow& row = answer.designs[i];
    const auto first = value_of(problem, row, problem.objectives[0]);
    const auto second =
        plane ? value_of(problem, row, problem.objectives[1])
              : std::optional(across == Along::ratio ? row.ratio : row.center_distance);
    if (!first || !second) continue;
    // Of one objective the value is upright.
    dots.push_back({plane ? Vec2(*first, *second) : Vec2(*second, *first), &row, front[i]});
  }
  return dots;
}

// A linear axis, or a logarithmic one for what spans more than a power of ten or so.
struct Scale {
  Axis axis;
  bool log;
  double operator()(double v) const { return axis(log ? std::log10(v) : v); }
};

constexpr double kWideSpan = 15.0;  // greatest over least value: a linear axis would crowd one end

constexpr double kOneValue = 1e-6;  // relative: values as near are one, and get room around them
constexpr double kRoomOfOne = 0.01;

Scale scale_of(double lo, double hi, double from, double to) {
  const double size = std::max({std::abs(lo), std::abs(hi), 1e-3});
  if (hi - lo < kOneValue * size) {
    lo -= kRoomOfOne * size;
    hi += kRoomOfOne * size;
  }
  const bool log = lo > 0.0 && hi > kWideSpan * lo;
  const auto wide = log ? widened(std::log10(lo), std::log10(hi), kFree) : widened(lo, hi, kFree);
  return {{wide[0], wide[1], from, to}, log};
}

// Round values of a logarithmic axis: powers of ten, and where few of them fit 2 and 5 times those.
std::vector<double> log_ticks(const Axis& axis) {
  std::vector<double> values;
  for (const bool fine : {false, true}) {
    values.clear();
    for (double k = std::floor(axis.lo); k <= axis.hi; k += 1.0) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double at = k + std::log10(factor);
        if ((fine || factor == 1.0) && at >= axis.lo && at <= axis.hi)
          values.push_back(factor * std::pow(10.0, k));
      }
    }
    if (values.size() >= 4) break;
  }
  return values;
}

std::string tick_words(double v) {
  return v >= 1.0 ? counted(static_cast<std::int64_t>(std::llround(v))) : fmt::format("{:g}", v);
}

void draw_axes(Svg& svg, const Scale& x, const Scale& y, const std::string& words) {
  const double middle = (x.axis.from + x.axis.to) / 2;
  if (y.log) {
    for (const double v : log_ticks(y.axis)) {
      svg.line({x.axis.from, y(v)}, {x.axis.to, y(v)}, "grid");
      svg.text({x.axis.from - 6, y(v) + 4}, tick_words(v), Anchor::end, "tick");
    }
    svg.line({x.axis.from, y.axis.from}, {x.axis.to, y.axis.from}, "axis");
  } else {
    draw_rows(svg, x.axis, y.axis, 7);
  }
  const double top = y.axis.to, bottom = y.axis.from;
  if (!x.log) return draw_foot(svg, x.axis, top, bottom, 6, words);
  for (const double v : log_ticks(x.axis)) {
    svg.line({x(v), top}, {x(v), bottom + 4}, "grid");
    svg.text({x(v), bottom + 17}, tick_words(v), Anchor::middle, "tick");
  }
  svg.text({middle, bottom + 36}, words, Anchor::middle, "tick");
}

}  // namespace

std::vector<Vec2> staircase(const std::vector<Vec2>& points, const std::array<bool, 2>& greater) {
  // As costs: less is better.
  const Vec2 sign(greater[0] ? -1.0 : 1.0, greater[1] ? -1.0 : 1.0);
  std::vector<Vec2> costs;
  for (const Vec2& p : points) costs.push_back(p.cwiseProduct(sign));
  std::sort(costs.begin(), costs.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vec2> corners;
  for (const Vec2& c : costs) {
    if (corners.empty()) {
      corners.push_back(c);
    } else if (c.y() < corners.back().y()) {
      corners.push_back({c.x(), corners.back().y()});
      corners.push_back(c);
    }
  }
  for (Vec2& c : corners) c = c.cwiseProduct(sign);
  return corners;
}

std::string pareto_figure(const SearchProblem& problem, const SearchAnswer& answer) {
  const bool plane = problem.objectives.size() > 1;
  const Quantity objective = quantity_of(problem.objectives[0]);
  const Quantity across = plane ? objective : across_one_objective(problem);
  const std::vector<Dot> dots = dots_of(problem, answer, across.along);
  if (dots.empty()) return {};
  const Quantity upright = plane ? quantity_of(problem.objectives[1]) : objective;

  Bounds box;
  bool unranked = false;
  for (const Dot& d : dots) {
    box.cover(d.value);
    unranked = unranked || !d.row->balanced;
  }
  const Scale x = scale_of(box.lo.x(), box.hi.x(), kArea.left, kArea.width - kArea.right);
  const Scale y = scale_of(box.lo.y(), box.hi.y(), kArea.bottom(), kArea.top);
  const auto px = [&](const Vec2& v) { return Vec2(x(v.x()), y(v.y())); };

  const std::string name = fmt::format("Designs by {} and {}", across.plain, upright.plain);
  Svg svg("designs-plot", kArea.width, kArea.height(), name,
          fmt::format("{} designs as dots; to the right the {}, upright the {}.", dots.size(),
                      across.plain, upright.plain));
  svg.text({12, 22}, upright.words, Anchor::start, "panel");
  draw_axes(svg, x, y, across.words);

  if (plane) {
    std::vector<Vec2> front;
    for (const Dot& d : dots)
      if (d.front) front.push_back(d.value);
    std::vector<Vec2> corners;
    for (const Vec2& v : staircase(front, {across.greater, upright.greater}))
      corners.push_back(px(v));
    if (corners.size() > 1) svg.polyline(corners, "staircase");
  }
  // The front on top, the best on top of that.
  const auto draw = [&](bool front) {
    for (auto d = dots.rbegin(); d != dots.rend(); ++d) {
      if (d->front != front) continue;
      const char* style = !d->row->balanced ? "dot-middle" : front ? "dot-front" : "dot-design";
      svg.dot(px(d->value), front ? 4.5 : 3.2, style, title_of(*d->row, d->value));
    }
  };
  draw(false);
  draw(true);
  if (!plane && dots.front().row == &answer.designs.front())
    svg.dot(px(dots.front().value), 7.0, "design-ring");

  std::string words;
  if (plane) {
    words += problem.objectives.size() == 2
                 ? "Joined: the Pareto front, designs that none betters in both. "
                 : "Filled: the Pareto front over all objectives; the staircase joins those that "
                   "none betters in these two. ";
  } else {
    words += "Ringed: the best. ";
  }
  if (unranked)
    words +=
        "Hollow: designs whose teeth cannot be made about equally strong within the limits; they "
        "come last. ";
  if (dots.size() < static_cast<std::size_t>(answer.counts.feasible))
    words += fmt::format("Shown are {} of {} feasible designs. ",
                         counted(std::int64_t(dots.size())), counted(answer.counts.feasible));
  return captioned(svg.str(),
                   fmt::format("<strong>{}</strong>, a dot each: rest the pointer on one "
                               "for its module, teeth and shifts. {}",
                               name, words));
}

}  // namespace gearwright
