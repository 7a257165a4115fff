// Conversion of values between Python and C++: trees of specs, values of the catalogue, errors.
//
//   by key    "tip_diameter_mm", in the unit of the key, as in JSON
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

/// Returns the key without its unit if the key has a form in mm and rad: "tip_diameter" for
/// tip_diameter_mm, "transmission_error" for transmission_error_arcsec. Other keys are unchanged.
std::string name_of(const QuantityInfo& info);
/// Value of one unit of the key in mm or rad.
double house_unit(Unit unit);
/// "m_n, mm: normal module, as in the spec", the text that help() prints for an attribute.
std::string docstring(const QuantityInfo& info);

/// Converts to the form of JSON: null is None, lists are lists, records are dicts by key.
py::object by_key(const Value& value);
py::object to_python(const Json& tree);
/// Converts to an attribute: numbers in mm and rad, lists are tuples, records are Records.
py::object by_name(const QuantityInfo& info, const Value& value);
py::object by_name(const Value& without_unit);

/// Converts to a tree of dicts, lists, numbers and texts. It also accepts numpy's numbers and
/// arrays, paths and Gears. `path` is the name used in errors.   Throws  SpecError for a number
/// that is not finite, TypeError for a type that a spec cannot contain
Json tree_of(py::handle value, const std::string& path);

/// A text, bytes or a path object.
bool is_path(py::handle value);
/// Returns the path of a file or folder. `name` is used in errors.   Throws  SpecError, TypeError
std::filesystem::path path_of(py::handle value, const std::string& name);
std::optional<std::filesystem::path> path_or_none(py::handle value, const std::string& name);
/// The number of threads; 0 means as many as the machine has.   Throws   SpecError
int threads_in_range(int threads);

/// Raises gearwright.SpecError.
[[noreturn]] void raise(const Error& error);
/// The same for a single gear, with "teeth" instead of "gear1.teeth".
[[noreturn]] void raise_of_gear(Error error);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).take();
}

/// Defines copy, deepcopy and pickle of an immutable value. A copy is the value itself, and a
/// pickle uses `keep` and `make_again`.
template <class Type, class Keep, class MakeAgain>
void bind_copies(Type& type, const Keep& keep, const MakeAgain& make_again) {
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; })
      .def(py::pickle(keep, make_again));
}

}  // namespace gearwright::python
