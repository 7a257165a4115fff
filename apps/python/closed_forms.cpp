// Closed forms over columns of numbers: lanes and leaf formulas of the engine, row by row, without the GIL.
//
// Rows outside a formula's domain are NaN. Broadcasting, defaults and names: gearwright/closed_forms.py.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "gearwright/design/candidate.hpp"
#include "gearwright/design/trial_gear.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/mesh.hpp"

namespace gearwright::python {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
using Column = py::array_t<double, py::array::c_style>;

// A result of as many rows, made by f of each without the GIL.
template <class F>
py::array_t<double> each(std::size_t rows, const F& f) {
  std::vector<double> out(rows);
  {
    const py::gil_scoped_release free;
    for (std::size_t i = 0; i < rows; ++i) out[i] = f(i);
  }
  return array_of(std::move(out), {static_cast<py::ssize_t>(rows)});
}

std::size_t rows_of(const Column& column) { return static_cast<std::size_t>(column.size()); }

py::array_t<double> involutes(const Column& alpha) {
  const double* const a = alpha.data();
  return each(rows_of(alpha), [a](std::size_t i) {
    return std::abs(a[i]) < std::numbers::pi / 2 ? involute(a[i]) : kNothing;
  });
}

py::array_t<double> inverse_involutes(const Column& inv) {
  constexpr double kMost = 1e12;  // the domain of inverse_involute
  const double* const y = inv.data();
  return each(rows_of(inv), [y](std::size_t i) {
    return std::abs(y[i]) <= kMost ? inverse_involute(y[i]) : kNothing;
  });
}

// Columns of CandidateBatch, in normal modules; rows are done in parts that stay near the processor.
py::tuple candidates(const std::array<Column, CandidateBatch::kIn>& columns, double tan_alpha,
                     const std::array<double, 2>& addendum, const std::array<double, 2>& dedendum,
                     double edge_depth, bool tight, bool shorten, const std::vector<int>& wanted) {
  constexpr std::size_t kPart = 2048;
  CandidateConstants constants{
      tan_alpha, addendum, dedendum, {edge_depth, edge_depth}, {edge_depth, edge_depth},
      tight,     shorten};
  const std::size_t rows = rows_of(columns[0]);
  std::vector<std::vector<double>> out(wanted.size(), std::vector<double>(rows));
  {
    std::array<const double*, CandidateBatch::kIn> in{};
    for (std::size_t c = 0; c < in.size(); ++c) in[c] = columns[c].data();
    const py::gil_scoped_release free;
    CandidateBatch batch;
    for (std::size_t from = 0; from < rows; from += kPart) {
      const std::size_t n = std::min(kPart, rows - from);
      batch.resize(n);
      for (std::size_t c = 0; c < in.size(); ++c) std::copy_n(in[c] + from, n, batch.in[c].begin());
      evaluate(constants, batch);
      // Lanes stand still together: the residual says where there is no working angle.
      const auto& residual = batch.out[CandidateBatch::residual];
      const auto& tan_w = batch.out[CandidateBatch::tan_working];
      for (std::size_t i = 0; i < n; ++i) {
        if (residual[i] <= kSieveDoubt * tan_w[i] * tan_w[i]) continue;
        for (auto& column : batch.out) column[i] = kNothing;
      }
      for (std::size_t w = 0; w < wanted.size(); ++w)
        std::copy_n(batch.out[static_cast<std::size_t>(wanted[w])].begin(), n,
                    out[w].begin() + static_cast<std::ptrdiff_t>(from));
    }
  }
  py::tuple all(wanted.size());
  for (std::size_t w = 0; w < wanted.size(); ++w)
    all[w] = array_of(std::move(out[w]), {static_cast<py::ssize_t>(rows)});
  return all;
}

// Normal backlash at a centre distance; NaN where there is no working angle.
py::array_t<double> backlashes(const Column& z1, const Column& z2, const Column& x1,
                               const Column& x2, const Column& helix, const Column& allowance1,
                               const Column& allowance2, const Column& distance, double module,
                               double alpha_n) {
  const std::array<const double*, 2> z{z1.data(), z2.data()}, x{x1.data(), x2.data()},
      e{allowance1.data(), allowance2.data()};
  const double *const beta = helix.data(), *const a = distance.data();
  return each(rows_of(z1), [&](std::size_t i) {
    BasePair<double> gears;
    for (const std::size_t g : {0u, 1u}) {
      const double teeth = z[g][i];
      const bool whole = teeth == std::round(teeth) && teeth != 0.0 && std::abs(teeth) < 1e6;
      if (!whole || !(std::abs(beta[i]) < std::numbers::pi / 2)) return kNothing;
      const double hand = g == 0 || z[1][i] < 0.0 ? 1.0 : -1.0;
      gears[g] = base_gear(static_cast<int>(teeth),
                           reference_geometry<double>({static_cast<int>(teeth), module, alpha_n,
                                                       hand * beta[i], x[g][i], e[g][i]}));
    }
    const double sum = base_radius_sum(gears);
    if (!(sum > 0.0) || !(a[i] > sum)) return kNothing;
    const RackAngles<double> angles = angles_at_parallel_distance(gears, a[i]);
    const CommonRack<double> rack = common_rack(gears, angles);
    MeshInput<double> in{gears, {}, {}, {}, a[i], {}};
    Mesh<double> mesh{};
    mesh.sigma = side_of(gears);
    mesh.rack = rack;
    return detail::backlash_of(in, mesh).normal;
  });
}

// Least and greatest profile shift of each gear, once for each tooth number and helix.
py::tuple shift_limits(const Column& teeth, const Column& helix, double alpha_n, double addendum,
                       double edge_depth, double tip_thickness) {
  SearchProblem problem;
  problem.normal_pressure_angle = Angle::radians(alpha_n);
  problem.limits.tip_thickness = tip_thickness;
  SearchRacks& racks = problem.racks.front();
  for (const std::size_t g : {0u, 1u}) {
    racks.rack[g].addendum = addendum;
    racks.undercut_depth[g] = racks.flank_depth[g] = edge_depth;
  }
  const double *const z = teeth.data(), *const beta = helix.data();
  const std::size_t rows = rows_of(teeth);
  std::vector<double> least(rows), greatest(rows);
  {
    const py::gil_scoped_release free;
    std::map<std::pair<double, double>, std::pair<double, double>> known;
    std::pair<double, double> last_key{kNothing, kNothing}, last;
    for (std::size_t i = 0; i < rows; ++i) {
      const std::pair key{z[i], beta[i]};
      if (key != last_key) {
        const bool valid = z[i] == std::round(z[i]) && z[i] != 0.0 && std::abs(z[i]) < 1e6 &&
                           std::abs(beta[i]) < std::numbers::pi / 2;
        const auto [at, is_new] = valid ? known.try_emplace(key) : std::pair(known.end(), false);
        if (is_new) {
          const TrialGear gear =
              trial_gear(problem, static_cast<int>(z[i]), Angle::radians(beta[i]), 0, 0);
          const bool none = gear.x_min > gear.x_max;
          at->second = none ? std::pair(kNothing, kNothing) : std::pair(gear.x_min, gear.x_max);
        }
        last = valid ? at->second : std::pair(kNothing, kNothing);
        last_key = key;
      }
      least[i] = last.first;
      greatest[i] = last.second;
    }
  }
  const auto n = static_cast<py::ssize_t>(rows);
  return py::make_tuple(array_of(std::move(least), {n}), array_of(std::move(greatest), {n}));
}

}  // namespace

void bind_closed_forms(py::module_& m) {
  m.def("_involute", &involutes);
  m.def("_inverse_involute", &inverse_involutes);
  m.def("_candidates", &candidates);
  m.def("_backlash", &backlashes);
  m.def("_shift_limits", &shift_limits);
  using Out = CandidateBatch::Out;
  py::dict columns;
  for (const auto& [name, place] : {std::pair{"center_distance", Out::center_distance},
                                    {"tan_working", Out::tan_working},
                                    {"contact_ratio", Out::contact_ratio},
                                    {"contact_ratio_true", Out::contact_ratio_true},
                                    {"sliding", Out::sliding},
                                    {"tip_thickness1", Out::tip_1},
                                    {"tip_thickness2", Out::tip_2},
                                    {"tip_clearance1", Out::clearance_1},
                                    {"tip_clearance2", Out::clearance_2}})
    columns[name] = static_cast<int>(place);
  m.attr("_CANDIDATE_COLUMNS") = columns;
}

}  // namespace gearwright::python
