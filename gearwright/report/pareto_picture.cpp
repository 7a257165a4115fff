#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/designs.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/search_figures.hpp"
#include "gearwright/report/search_table.hpp"

namespace gearwright {

namespace {

enum class Along { objective, distance, ratio };

// A quantity of the designs that is shown along an axis.
struct PlotAxis : DesignAxis {
  Along along = Along::objective;
};

struct Dot {
  Vec2 value;
  const DesignRow* row;
  bool front;
};

PlotAxis quantity_of(Objective objective) {
  const ObjectiveWords w = words_of(objective);
  return {
      {{.words = std::string(w.name), .unit = std::string(w.unit), .symbol = std::string(w.symbol)},
       seeks_greatest(objective) ? Better::greater : Better::smaller}};
}

std::string title_of(const DesignRow& row) {
  return fmt::format("{}: x1 = {}, x2 = {}", design_name(row.trial), fixed(row.shift[0], 4),
                     fixed(row.shift[1], 4));
}

// Returns the quantity on the second axis if there is a single objective. It is the centre
// distance, or the ratio if the centre distance is given.
PlotAxis across_one_objective(const SearchProblem& problem) {
  const auto& band = problem.center_distance;
  if (band && (*band)[0] == (*band)[1])
    return {{{.words = "gear ratio", .unit = {}, .symbol = "u"}}, Along::ratio};
  return {{{.words = "centre distance", .unit = "mm", .symbol = "a"}}, Along::distance};
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
    // If there is a single objective, it is shown on the vertical axis.
    dots.push_back({plane ? Vec2(*first, *second) : Vec2(*second, *first), &row, front[i]});
  }
  return dots;
}

}  // namespace

std::string pareto_figure(const SearchProblem& problem, const SearchAnswer& answer,
                          UnitSystem units) {
  const bool plane = problem.objectives.size() > 1;
  const PlotAxis objective = quantity_of(problem.objectives[0]);
  PlotAxis across = plane ? objective : across_one_objective(problem);
  std::vector<Dot> dots = dots_of(problem, answer, across.along);
  if (dots.empty()) return {};
  PlotAxis upright = plane ? quantity_of(problem.objectives[1]) : objective;
  const TextUnit x(units, across.axis.unit), y(units, upright.axis.unit);
  for (Dot& d : dots) d.value = {x(d.value.x()), y(d.value.y())};
  across.axis.unit = x.text();
  upright.axis.unit = y.text();

  const bool unranked =
      std::any_of(dots.begin(), dots.end(), [](const Dot& d) { return !d.row->balanced; });
  // Dots of the front cover all other dots, and the best design covers the front.
  std::vector<DesignDot> drawn;
  for (const bool front : {false, true}) {
    for (auto d = dots.rbegin(); d != dots.rend(); ++d) {
      if (d->front != front) continue;
      const char* style = !d->row->balanced ? "dot-middle" : front ? "dot-front" : "dot-design";
      drawn.push_back({d->value, style, title_of(*d->row)});
    }
  }
  Figure f = designs_figure(across, upright, drawn);
  f.caption =
      ", with one dot for each design. Point at a dot to see module, teeth and profile shifts. ";
  if (!plane && dots.front().row == &answer.designs.front())
    f.dot(dots.front().value, 7.0, "design-ring");

  if (plane) {
    f.caption +=
        problem.objectives.size() == 2
            ? "The line joins the Pareto front, the designs that no other design dominates. "
            : "Filled dots are the Pareto front over all objectives. The staircase joins the "
              "designs that no other design dominates in these two objectives. ";
  } else {
    f.caption += "The ring marks the best design. ";
  }
  if (unranked)
    f.caption +=
        "Hollow dots are designs whose teeth cannot be made about equally strong within the "
        "limits. They have the last ranks. ";
  if (dots.size() < static_cast<std::size_t>(answer.counts.feasible))
    f.caption += fmt::format("The picture shows {} of {} feasible designs. ",
                             counted(std::int64_t(dots.size())), counted(answer.counts.feasible));
  return figure_html(f);
}

}  // namespace gearwright
