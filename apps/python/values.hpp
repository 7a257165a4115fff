// Converts values between Python and C++: trees of specs, values of the catalogue, and errors.
//
//   by key    "tip_diameter_mm", in the unit of the key, as in JSON
//   by name   "tip_diameter", an attribute in mm and rad
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
/// The size of one unit of the key in mm or rad.
double house_unit(Unit unit);
/// The text that help() prints for an attribute: "m_n, mm: normal module, as in the spec".
std::string docstring(const QuantityInfo& info);

/// Converts to the form of JSON. Null becomes None, lists become lists, and records become dicts by key.
py::object by_key(const Value& value);
py::object to_python(const Json& tree);
/// Converts to an attribute. Numbers are in mm and rad, lists become tuples, and records become Records.
py::object by_name(const QuantityInfo& info, const Value& value);
py::object by_name(const Value& without_unit);

/// Converts a Python value to a tree of a spec. Accepted are dicts, lists, numbers and texts, and also numpy's
/// numbers and arrays, paths and Gears. `path` is the name used in errors.   Throws  SpecError for a number
/// that is not finite, TypeError for a type that a spec cannot contain
Json tree_of(py::handle value, const std::string& path);

/// True for a text, bytes or a path object.
bool is_path(py::handle value);
/// Returns the path of a file or folder. Errors use `name`.   Throws  SpecError, TypeError
std::filesystem::path path_of(py::handle value, const std::string& name);
std::optional<std::filesystem::path> path_or_none(py::handle value, const std::string& name);
/// Checks and returns a number of threads. 0 means as many as the machine has.   Throws   SpecError
int threads_in_range(int threads);

/// Raises gearwright.SpecError.
[[noreturn]] void raise(const Error& error);
/// Raises gearwright.SpecError for a single gear, with "teeth" instead of "gear1.teeth".
[[noreturn]] void raise_of_gear(Error error);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).take();
}

/// Defines copy, deepcopy and pickle of an immutable value. A copy is the value itself. Pickling calls `keep`,
/// and unpickling calls `make_again`.
template <class Type, class Keep, class MakeAgain>
void bind_copies(Type& type, const Keep& keep, const MakeAgain& make_again) {
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; })
      .def(py::pickle(keep, make_again));
}

}  // namespace gearwright::python
