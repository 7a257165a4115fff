// Computes a pair with errors of mounting. One set of errors is given as a table or a row of
// numbers, and many sets are given as an array.
#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright::python {

namespace {

// Converts a row of numbers in mm and rad to a table [errors]. The numbers are in the order of
// gearwright.ERRORS.
Json errors_of_row(py::handle row, UnitSystem units) {
  const auto numbers = real_numbers(row);
  const py::ssize_t n = numbers ? numbers->size() : 0;
  if (!numbers || numbers->ndim() != 1 || (n != 6 && n != 8))
    raise(Error{"errors", std::string(py::repr(row)),
                "must be a dict with keys of [errors], or 6 or 8 numbers in the order of "
                "gearwright.ERRORS"});
  Json errors = Json::object();
  for (py::ssize_t i = 0; i < n; ++i) {
    const ErrorEntry& e = error_entries()[static_cast<std::size_t>(i)];
    const std::string key = fmt::format("errors[{}]", i);
    const KeyUnit* const length = units == UnitSystem::inch ? metric_unit(e.key) : nullptr;
    const double x = numbers->at(i) / e.si();
    errors[key_in(units, e.key)] = tree_of(py::float_(length ? length->to_inch(x) : x), key);
  }
  return errors;
}

Json errors_tree(const py::object& errors, UnitSystem units) {
  if (PyMapping_Check(errors.ptr()) && py::hasattr(errors, "keys"))
    return with_keys(tree_of(errors, "errors"), {&error_keys()}, units, "errors");
  return errors_of_row(errors, units);
}

// A column of an array of errors, which is looked up once for all rows.
struct ErrorColumn {
  std::string_view key;
  double si;
  const KeyRange* range;
  int cutter_of;  // the gear whose cutter has the error, or 0
};

std::vector<ErrorColumn> error_columns(std::size_t count) {
  std::vector<ErrorColumn> columns;
  for (std::size_t i = 0; i < count; ++i) {
    const ErrorEntry& e = error_entries()[i];
    const KeyRange& range = error_keys().find(e.key)->range;
    columns.push_back({e.key, e.si(), &range, e.of_cutter() ? e.gear : 0});
  }
  return columns;
}

// Checks many rows of errors for a pair. Every number must be finite and within the range of its
// key.
void check_rows(const Numbers& rows, const std::vector<ErrorColumn>& columns,
                const ContactSetup& setup) {
  const auto numbers = rows.unchecked<2>();
  for (py::ssize_t r = 0; r < rows.shape(0); ++r) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto& [key, si, range, cutter_of] = columns[i];
      const auto where = [r, name = key] { return fmt::format("errors[{}].{}", r, name); };
      const double x = numbers(r, static_cast<py::ssize_t>(i)) / si;
      if (!std::isfinite(x)) raise(Error{where(), fmt::format("{}", x), "must be a finite number"});
      if (!range->contains(x)) raise(refused(where(), x, range->sentence(x)));
      if (cutter_of == 0) continue;
      if (auto error = check_cutter_lead(setup.gear(cutter_of), cutter_of, Angle::degrees(x)))
        raise(Error{where(), error->value, error->rule});
    }
  }
}

py::array_t<double> transmission_errors(const PairValue& pair, const py::object& errors,
                                        int positions, const py::object& modifications,
                                        int threads) {
  const auto given_rows = real_numbers(errors);
  if (!given_rows || given_rows->ndim() != 2 ||
      (given_rows->shape(1) != 6 && given_rows->shape(1) != 8)) {
    std::string shape = "not an array of real numbers";
    if (given_rows) shape = std::string(py::str(given_rows->attr("shape")));
    raise(Error{"errors", shape,
                "must be an array of shape (n, 6) or (n, 8) in mm and rad, with the columns of "
                "gearwright.ERRORS"});
  }
  const Numbers& rows = *given_rows;
  const KeyRange& range = contact_keys().find("positions")->range;
  if (!range.contains(positions)) raise(refused("positions", positions, range.sentence(positions)));
  threads_in_range(threads);
  const ModelPtr model =
      with_two_gears(asked_model(pair, py::none(), modifications, contact_keys(), "contact", {}));
  const auto made = setup_of(model->job);
  if (!made) raise(made.error(), *model);
  const ContactSetup& setup = *made;
  const auto n = static_cast<std::size_t>(rows.shape(0));
  const std::vector<ErrorColumn> columns = error_columns(static_cast<std::size_t>(rows.shape(1)));
  check_rows(rows, columns, setup);
  std::vector<double> te(n * static_cast<std::size_t>(positions));
  const double* const given = rows.data();
  const bool gear2_drives = model->job.spec.contact.driver == 2;
  watched_rows(n, threads, [&](std::size_t r) {
    ContactErrors e = setup.place().errors;
    for (std::size_t i = 0; i < columns.size(); ++i)
      e = with_error(setup, e, i, given[r * columns.size() + i] / columns[i].si);
    const auto curve = transmission_error(setup.pair(e, gear2_drives), positions);
    std::copy(curve.begin(), curve.end(),
              te.begin() + static_cast<std::ptrdiff_t>(r * curve.size()));
  });
  return array_of(std::move(te), {static_cast<py::ssize_t>(n), positions});
}

}  // namespace

ModelPtr asked_model(const PairValue& pair, const py::object& errors,
                     const py::object& modifications, const KeyTable& table,
                     const std::string& name, const py::kwargs& keys) {
  if (errors.is_none() && modifications.is_none() && keys.empty()) return pair.model;
  Json spec = pair.model->spec;
  const UnitSystem units = units_of(spec);
  if (!errors.is_none()) spec["errors"] = errors_tree(errors, units);
  if (!modifications.is_none()) {
    const Json tree = tree_of(modifications, "modifications");
    for (const auto& [gear, given] : tree.items()) {
      if (gear != "gear1" && gear != "gear2")
        raise(Error{"modifications." + gear, "",
                    "must be gear1 or gear2, each with a dict of the modifications of this gear"});
      spec[gear]["modifications"] =
          with_keys(given, {&modification_keys()}, units, gear + ".modifications");
    }
  }
  set_keys(spec, name, with_keys(tree_of(keys, name), {&table}, units, name));
  return make_model(std::move(spec), pair.model->folder, Scope::pair);
}

void bind_mountings(py::module_& m, py::class_<PairValue>& pair) {
  pair.def("transmission_error", &transmission_errors, py::arg("errors"), py::arg("positions") = 64,
           py::arg("modifications") = py::none(), py::arg("threads") = 0,
           "Returns the transmission errors of n mountings as an array (n, positions) in rad, over "
           "one pitch that starts half a pitch before the centre line. errors is an array in mm "
           "and rad with the first 6 or all 8 columns of gearwright.ERRORS. The result is NaN "
           "where contact is lost. The computation uses all cores and releases the GIL");
  py::list names;
  for (const ErrorEntry& e : error_entries()) names.append(std::string(e.name()));
  m.attr("ERRORS") = py::tuple(names);
}

}  // namespace gearwright::python
