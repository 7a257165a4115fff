#include "gearwright/drive/drive_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

using Bodies = std::vector<std::size_t>;

RationalMatrix mesh_rows(const DriveGraph& graph) {
  RationalMatrix rows;
  for (const DriveMesh& mesh : graph.meshes) rows.push_back(mesh_row(graph, mesh));
  return rows;
}

void add_unit_rows(RationalMatrix& rows, const Bodies& bodies, std::size_t columns) {
  for (const std::size_t body : bodies) {
    rows.emplace_back(columns);
    rows.back()[body] = 1;
  }
}

std::string names(const DriveGraph& graph, const Bodies& bodies) {
  std::vector<std::string> list;
  for (const std::size_t b : bodies) list.push_back(graph.bodies[b].name);
  return fmt::format("{}", fmt::join(list, ", "));
}

// Returns the first body that the list contains again, or none.
std::optional<std::size_t> repeated(const Bodies& bodies) {
  for (auto it = bodies.begin(); it != bodies.end(); ++it)
    if (std::find(bodies.begin(), it, *it) != it) return *it;
  return std::nullopt;
}

// Names the meshes that lock the drive, for example "a_b, c_d". If any one of these meshes is
// removed, the drive can turn.
std::string locking_meshes(const DriveGraph& graph) {
  std::vector<std::string> list;
  for (std::size_t without = 0; without < graph.meshes.size(); ++without) {
    DriveGraph less = graph;
    less.meshes.erase(less.meshes.begin() + static_cast<std::ptrdiff_t>(without));
    RationalMatrix rows = mesh_rows(less);
    add_unit_rows(rows, graph.fixed, graph.bodies.size());
    const auto rank = rank_of(rows);
    if (!rank) continue;
    add_unit_rows(rows, graph.inputs, graph.bodies.size());
    if (rank_of(rows) == *rank + graph.inputs.size()) list.push_back(graph.meshes[without].name);
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

Error too_large() {
  return {"drive.gear", "",
          "the numbers of teeth lead to ratios that need more than 127 bits; use fewer stages, or "
          "compute each stage alone"};
}

Error locked(const DriveGraph& graph) {
  // Counts the degrees of freedom of the drive without fixed bodies.
  RationalMatrix rows = mesh_rows(graph);
  const auto rank = rank_of(rows);
  if (!rank) return too_large();
  if (graph.fixed.size() > 1) {
    return {
        "drive.fixed", names(graph, graph.fixed),
        fmt::format("nothing can turn, because these fixed bodies leave no degree of freedom; "
                    "without any fixed body the drive has {} degrees of freedom. Fix fewer bodies",
                    graph.bodies.size() - *rank)};
  }
  const std::string culprits = locking_meshes(graph);
  std::string why = "nothing can turn, because no degree of freedom is left";
  if (!culprits.empty())
    why += fmt::format(
        "; the ratios of the meshes in a closed loop contradict each other. If one of the meshes "
        "{} is removed, the drive can turn",
        culprits);
  return {"drive.fixed", names(graph, graph.fixed), why};
}

Error undetermined(const DriveGraph& graph, std::size_t freedom, std::size_t inputs) {
  Bodies free;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b)
    if (!graph.bodies[b].carrier && !graph.is_fixed(b) && !graph.is_input(b) && b != graph.output)
      free.push_back(b);
  return {"drive.fixed", names(graph, graph.fixed),
          fmt::format("the speeds are not determined, because the drive has {} degrees of freedom "
                      "and {} input{}; fix {} more bodies or give the same number of additional "
                      "inputs{}",
                      freedom, inputs, inputs == 1 ? "" : "s", freedom - inputs,
                      free.empty() ? "" : fmt::format(" (free bodies: {})", names(graph, free)))};
}

Rational product_of_period(const std::vector<std::vector<Rational>>& speeds,
                           const DriveGraph& graph) {
  Rational period = 1;
  for (std::size_t b = 0; b < speeds.size(); ++b) {
    const bool moves = std::any_of(graph.gears.begin(), graph.gears.end(),
                                   [&](const DriveGear& g) { return g.body == b && g.rack; });
    if (moves || speeds[b][0].zero()) continue;
    const auto q = speeds[b][0].denominator();
    period = q ? least_common_multiple(period, Rational(*q)) : Rational::too_large();
  }
  return period;
}

}  // namespace

std::optional<Error> ends_error(const DriveGraph& graph) {
  for (const bool fixed : {true, false}) {
    const Bodies& list = fixed ? graph.fixed : graph.inputs;
    if (const auto twice = repeated(list))
      return Error{fixed ? "drive.fixed" : "drive.input", names(graph, list),
                   fmt::format("contains {} twice", graph.bodies[*twice].name)};
  }
  for (const std::size_t in : graph.inputs) {
    if (graph.is_fixed(in))
      return Error{"drive.input", graph.bodies[in].name,
                   "the input is a fixed body; choose another input or another fixed body"};
    if (in == graph.output)
      return Error{"drive.output", graph.bodies[in].name,
                   "input and output are the same body; choose another output"};
  }
  if (graph.is_fixed(graph.output))
    return Error{"drive.output", graph.bodies[graph.output].name,
                 "the output is a fixed body; choose another output or another fixed body"};
  return std::nullopt;
}

double DriveMotion::speed(std::size_t body, const std::vector<double>& inputs) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < inputs.size(); ++k) sum += speeds[body][k].value() * inputs[k];
  return sum;
}

std::vector<Rational> mesh_row(const DriveGraph& graph, const DriveMesh& mesh) {
  std::vector<Rational> row(graph.bodies.size());
  const DriveGear& a = graph.gear(mesh, 0);
  const DriveGear& b = graph.gear(mesh, 1);
  row[a.body] = row[a.body] + Rational(a.factor());
  row[b.body] = row[b.body] + Rational(b.factor());
  if (const auto frame = graph.frame(mesh))
    row[*frame] = row[*frame] - Rational(a.factor() + b.factor());
  return row;
}

Result<DriveMotion> drive_motion(const DriveGraph& graph) {
  GW_EXPECTS(!graph.inputs.empty());
  if (auto error = ends_error(graph)) return *error;
  const std::size_t n = graph.bodies.size();
  const std::size_t inputs = graph.inputs.size();
  RationalMatrix rows = mesh_rows(graph);
  const RationalMatrix kernel = left_kernel(rows);
  add_unit_rows(rows, graph.fixed, n);
  const auto rank = rank_of(rows);
  if (!rank) return too_large();
  const std::size_t freedom = n - *rank;
  if (freedom == 0) return locked(graph);
  if (freedom > inputs) return undetermined(graph, freedom, inputs);
  if (freedom < inputs)
    return Error{"drive.input", names(graph, graph.inputs),
                 fmt::format("there are {} inputs and only {} degree{} of freedom, so their speeds "
                             "would contradict each other; leave out {} of the inputs",
                             inputs, freedom, freedom == 1 ? "" : "s", inputs - freedom)};

  // Solves for ω of every body, once for each input. Each input has its own right-hand side, which
  // is an additional column of the matrix.
  add_unit_rows(rows, graph.inputs, n);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].resize(n + inputs);
    if (r + inputs >= rows.size()) rows[r][n + (r + inputs - rows.size())] = 1;
  }
  const auto pivots = reduce_rows(rows, n);
  if (pivots.size() < n) {
    return Error{
        "drive.input", names(graph, graph.inputs),
        inputs == 1
            ? "the input cannot rotate in this drive; choose another input or another fixed body"
            : "the speeds of the inputs depend on each other; choose other inputs"};
  }
  DriveMotion motion;
  motion.freedom = static_cast<int>(freedom);
  for (std::size_t b = 0; b < n; ++b)
    motion.speeds.emplace_back(rows[b].begin() + static_cast<std::ptrdiff_t>(n), rows[b].end());
  for (const auto& list : motion.speeds)
    for (const Rational& w : list)
      if (!w.fits()) return too_large();
  for (std::size_t m = 0; m < graph.meshes.size(); ++m)
    if (std::any_of(kernel.begin(), kernel.end(), [&](const auto& y) { return !y[m].zero(); }))
      motion.redundant.push_back(m);
  const auto& out = motion.speeds[graph.output];
  if (std::all_of(out.begin(), out.end(), [](const Rational& w) { return w.zero(); }))
    return Error{
        "drive.output", graph.bodies[graph.output].name,
        "the output does not rotate when the input does, so the ratio would be infinite; change "
        "the number of teeth of a gear before the output, or choose another output"};
  if (inputs == 1) {
    motion.ratio = Rational(1) / out[0];
    motion.period = product_of_period(motion.speeds, graph);
  }
  return motion;
}

}  // namespace gearwright
