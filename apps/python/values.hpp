// Values between Python and the house: trees of specs, values of the catalogue, errors.
//
//   by key    "tip_diameter_mm", the unit that the key names: what JSON has
//   by name   "tip_diameter", mm and rad: an attribute
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::python {

namespace py = pybind11;

/// The key without a unit that has a place in mm and rad: "tip_diameter" of tip_diameter_mm,
/// "transmission_error" of transmission_error_arcsec; others stay.
std::string name_of(const QuantityInfo& info);
/// What one unit of the key is in mm or rad.
double house_unit(Unit unit);
/// "m_n, mm: normal module, as in the spec": what help() prints of an attribute.
std::string docstring(const QuantityInfo& info);

/// As JSON has it: null is None, lists are lists, records are dicts by key.
py::object by_key(const Value& value);
py::object to_python(const Json& tree);
/// As an attribute: numbers in mm and rad, lists are tuples, records are Records.
py::object by_name(const QuantityInfo& info, const Value& value);
py::object by_name(const Value& without_unit);

/// A tree of dicts, lists, numbers and texts; numpy's numbers and arrays, paths and Gears too. `path` names
/// it in errors.   Throws  SpecError for what is not finite, TypeError for what has no place in a spec
Json tree_of(py::handle value, const std::string& path);

/// A text, bytes or a path object.
bool is_path(py::handle value);
/// The path of a file or folder; `name` names it in errors.   Throws  SpecError, TypeError
std::filesystem::path path_of(py::handle value, const std::string& name);
std::optional<std::filesystem::path> path_or_none(py::handle value, const std::string& name);
/// So many threads, 0: as many as the machine has.   Throws  SpecError
int threads_in_range(int threads);

/// Raises gearwright.SpecError.
[[noreturn]] void raise(const Error& error);
/// The same of a gear by itself: "teeth", not "gear1.teeth".
[[noreturn]] void raise_of_gear(Error error);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).take();
}

/// copy, deepcopy and pickle of a value that never changes: itself, and what `keep` and `make_again` make of it.
template <class Type, class Keep, class MakeAgain>
void bind_copies(Type& type, const Keep& keep, const MakeAgain& make_again) {
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; })
      .def(py::pickle(keep, make_again));
}

}  // namespace gearwright::python
