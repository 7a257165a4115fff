// Computes closed forms over columns of numbers, for the module gearwright.closed_forms. The vector
// functions and the formulas of the engine run without the GIL.
//
// A column has a number for each row, or one number for all rows. A row outside the domain of a
// formula becomes NaN. Broadcasting, default values and names are in gearwright/closed_forms.py.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "gearwright/design/candidate.hpp"
#include "gearwright/design/trial_gear.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/closed_forms.hpp"

namespace gearwright::python {

namespace {

constexpr std::size_t kPart = 512;  // number of rows in a part, which then fits into the
                                    // processor's cache
using Column = py::array_t<double, py::array::c_style>;
template <std::size_t N>
using Columns = std::array<Column, N>;

// Returns a column of results with this number of rows. The values are not yet set.
py::array_t<double> results(std::size_t rows) {
  return py::array_t<double>(static_cast<py::ssize_t>(rows));
}

// Divides the rows into parts and calls f(in, from, n) for each part, without the GIL. A part
// consists of n rows and begins at the row `from`. `in` has one pointer for each column, to the
// n numbers of the column in this part.
template <std::size_t N, class F>
void in_parts(const Columns<N>& columns, std::size_t rows, const F& f) {
  std::array<const double*, N> all{};
  std::array<bool, N> constant{};
  for (std::size_t c = 0; c < N; ++c) {
    all[c] = columns[c].data();
    constant[c] = columns[c].size() == 1;
  }
  const py::gil_scoped_release free;
  std::array<std::array<double, kPart>, N> repeated;
  for (std::size_t c = 0; c < N; ++c)
    if (constant[c]) repeated[c].fill(*all[c]);
  for (std::size_t from = 0; from < rows; from += kPart) {
    std::array<const double*, N> in{};
    for (std::size_t c = 0; c < N; ++c) in[c] = constant[c] ? repeated[c].data() : all[c] + from;
    f(in, from, std::min(kPart, rows - from));
  }
}

// Returns the column of results that f(in, out, n) computes for each part. `out` points to the n
// results of this part.
template <std::size_t N, class F>
py::array_t<double> column_of(const Columns<N>& columns, std::size_t rows, const F& f) {
  py::array_t<double> found = results(rows);
  double* const out = found.mutable_data();
  in_parts(columns, rows,
           [&](const auto& in, std::size_t from, std::size_t n) { f(in, out + from, n); });
  return found;
}

py::array_t<double> involutes(const Columns<1>& alpha, std::size_t rows) {
  return column_of(alpha, rows, [](const auto& in, double* out, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      out[i] = std::abs(in[0][i]) < std::numbers::pi / 2 ? involute(in[0][i]) : kNoNumber;
  });
}

py::array_t<double> inverses(const Columns<1>& inv, std::size_t rows) {
  return column_of(inv, rows, [](const auto& in, double* out, std::size_t n) {
    inverse_involutes(in[0], out, n);
  });
}

py::array_t<double> backlashes(const Columns<BacklashColumns::kIn>& columns, std::size_t rows,
                               double module, double tan_alpha) {
  return column_of(columns, rows, [&](const auto& in, double* out, std::size_t n) {
    normal_backlashes({module, tan_alpha}, {in}, out, n);
  });
}

using Out = CandidateBatch::Out;

// Returns the index in CandidateBatch of the column that has this name in pair_table().
std::size_t place_of(const std::string& name) {
  for (const auto& [known, place] : {std::pair{"center_distance", Out::center_distance},
                                     {"working_pressure_angle", Out::tan_working},
                                     {"contact_ratio", Out::contact_ratio},
                                     {"contact_ratio_true", Out::contact_ratio_true},
                                     {"sliding", Out::sliding},
                                     {"tip_thickness1", Out::tip_1},
                                     {"tip_thickness2", Out::tip_2},
                                     {"tip_clearance1", Out::clearance_1},
                                     {"tip_clearance2", Out::clearance_2}})
    if (name == known) return place;
  throw py::key_error(name);
}

// Returns the columns of results with these names. Lengths are in normal modules, and angles
// are returned as their tangents.
py::tuple candidates(const Columns<CandidateBatch::kIn>& columns, std::size_t rows,
                     double tan_alpha, const std::array<double, 2>& addendum,
                     const std::array<double, 2>& dedendum, double edge_depth, bool tight,
                     bool shorten, const std::vector<std::string>& names) {
  const CandidateConstants constants{
      tan_alpha, addendum, dedendum, {edge_depth, edge_depth}, {edge_depth, edge_depth},
      tight,     shorten};
  py::tuple all(names.size());
  std::vector<std::pair<std::size_t, double*>> wanted;
  for (std::size_t w = 0; w < names.size(); ++w) {
    py::array_t<double> column = results(rows);
    wanted.emplace_back(place_of(names[w]), column.mutable_data());
    all[w] = std::move(column);
  }
  CandidateBatch batch;
  in_parts(columns, rows, [&](const auto& in, std::size_t from, std::size_t n) {
    batch.resize(n);
    for (std::size_t c = 0; c < in.size(); ++c) std::copy_n(in[c], n, batch.in[c].begin());
    evaluate(constants, batch);
    // All rows of a part are iterated together. If the residual of a row is too large after the
    // iteration, the row has no working pressure angle, and its results become NaN.
    const auto& residual = batch.out[CandidateBatch::residual];
    const auto& tan_w = batch.out[CandidateBatch::tan_working];
    for (std::size_t i = 0; i < n; ++i) {
      if (residual[i] <= kSieveDoubt * tan_w[i] * tan_w[i]) continue;
      for (auto& column : batch.out) column[i] = kNoNumber;
    }
    for (const auto& [place, out] : wanted) std::copy_n(batch.out[place].begin(), n, out + from);
  });
  return all;
}

// Returns the least and the greatest profile shift of each row. Rows with the same number of teeth
// and helix angle share one computation. The least shift of an internal gear is −∞ if the tip is
// thick enough as far as the shifts were searched.
py::tuple shift_limits(const Columns<2>& columns, std::size_t rows, double alpha_n, double addendum,
                       double edge_depth, double tip_thickness) {
  SearchProblem problem;
  problem.normal_pressure_angle = Angle::radians(alpha_n);
  problem.limits.tip_thickness = tip_thickness;
  SearchRacks& racks = problem.racks.front();
  for (const std::size_t g : {0u, 1u}) {
    racks.rack[g].addendum = addendum;
    racks.undercut_depth[g] = racks.flank_depth[g] = edge_depth;
  }
  py::array_t<double> least = results(rows), greatest = results(rows);
  double *const low = least.mutable_data(), *const high = greatest.mutable_data();
  std::map<std::pair<double, double>, std::pair<double, double>> known;
  std::pair<double, double> last_key{kNoNumber, kNoNumber}, last;
  in_parts(columns, rows, [&](const auto& in, std::size_t from, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const double z = in[0][i], beta = in[1][i];
      const std::pair key{z, beta};
      if (key != last_key) {
        const bool valid = z == std::round(z) && z != 0.0 && std::abs(z) < 1e6 &&
                           std::abs(beta) < std::numbers::pi / 2;
        const auto [at, is_new] = valid ? known.try_emplace(key) : std::pair(known.end(), false);
        if (is_new) {
          const TrialGear gear =
              trial_gear(problem, static_cast<int>(z), Angle::radians(beta), 0, 0);
          const bool none = gear.x_min > gear.x_max;
          const bool unlimited = z < 0 && gear.x_min <= -farthest_shift(gear.teeth);
          const double least = unlimited ? -std::numeric_limits<double>::infinity() : gear.x_min;
          at->second = none ? std::pair(kNoNumber, kNoNumber) : std::pair(least, gear.x_max);
        }
        last = valid ? at->second : std::pair(kNoNumber, kNoNumber);
        last_key = key;
      }
      low[from + i] = last.first;
      high[from + i] = last.second;
    }
  });
  return py::make_tuple(least, greatest);
}

}  // namespace

void bind_closed_forms(py::module_& m) {
  m.def("_real", [](const py::object& value) {
    auto numbers = real_numbers(value);
    if (!numbers) throw py::type_error("must be a real number or an array of real numbers");
    return *numbers;
  });
  m.def("_involute", &involutes);
  m.def("_inverse_involute", &inverses);
  m.def("_candidates", &candidates);
  m.def("_backlash", &backlashes);
  m.def("_shift_limits", &shift_limits);
}

}  // namespace gearwright::python
