// Converts values between Python and C++: trees of specs, values of the catalogue, and errors.
//
//   by key    "tip_diameter_mm", in the unit of the key, as in JSON
//   by name   "tip_diameter", as an attribute in mm or rad
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "gearwright/base/error.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::python {

namespace py = pybind11;

/// A unit of lengths or angles that keys name.
struct HouseUnit {
  Unit unit;
  double size;       ///< in mm or rad
  double per_house;  ///< number of units in one mm or rad; 1/size may differ in the last bit
};
inline constexpr std::array kHouseUnits{
    HouseUnit{Unit::mm, 1.0, 1.0}, HouseUnit{Unit::deg, kRadPerDeg, kDegPerRad},
    HouseUnit{Unit::um, kMmPerUm, kUmPerMm}, HouseUnit{Unit::arcsec, kRadPerArcsec, kArcsecPerRad}};

/// Returns the name of the attribute for a key. If the key has a unit that is converted to mm or
/// rad, the name is the key without its unit, for example "tip_diameter" for tip_diameter_mm and
/// "transmission_error" for transmission_error_arcsec. Otherwise it is the key itself, or "from_"
/// for the key "from".
std::string name_of(const QuantityInfo& info);
/// Returns the size of one unit in mm or rad; 1 if the unit is neither a length nor an angle.
double house_unit(Unit unit);
/// Returns the text that help() prints for the attribute `name`, for example "m_n, mm: normal
/// module, as in the spec". If several keys of the table have this name, the text describes each of
/// these keys.
std::string docstring(const QuantityTable& table, const std::string& name);

/// Converts a value to the form that it has in JSON. Null becomes None, lists become lists, and
/// records become dicts by key.
py::object by_key(const Value& value);
py::object to_python(const Json& tree);
/// Converts a value to an attribute. Numbers are in mm and rad. Lists of numbers whose length is
/// not fixed become arrays, other lists become tuples, and records become Records.
py::object by_name(const QuantityInfo& info, const Value& value);
/// Converts a record of this table, or a list of such records. An absent quantity is None.
py::object by_name(const QuantityTable& table, const Value& records);

/// Converts a Python value to a tree of a spec. Dicts, lists, texts, paths, Gears, arrays of numpy,
/// and numbers of Python or numpy are accepted. `path` is the name of the value in error messages.
///
/// Throws    SpecError if a number is not finite or too large, TypeError if a spec cannot contain a
///           value of this type
Json tree_of(py::handle value, const std::string& path);

/// True for a text, bytes or a path object.
bool is_path(py::handle value);
/// Returns the path of a file or folder. `name` is the name of the argument in error
/// messages.   Throws  SpecError, TypeError
std::filesystem::path path_of(py::handle value, const std::string& name);
std::optional<std::filesystem::path> path_or_none(py::handle value, const std::string& name);
/// Checks and returns a number of threads; 0 means all cores.   Throws SpecError
int threads_in_range(int threads);

/// Raises gearwright.SpecError.
[[noreturn]] void raise(const Error& error);
/// Raises gearwright.SpecError for a single gear. The keys in the error do not begin with "gear1".
/// For example, a key is "teeth" instead of "gear1.teeth".
[[noreturn]] void raise_of_gear(Error error);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(result).take();
}

/// Makes access to an object without a value an error. Type.__new__(Type) makes such an object,
/// whose value pybind11 would otherwise allocate without a constructor at the first access.
template <class Type>
void need_value(Type&) {
  py::detail::get_type_info(typeid(typename Type::type))->operator_new = [](std::size_t) -> void* {
    throw py::type_error("the object was made by __new__ alone and has no value");
  };
}

/// Defines copy, deepcopy and pickle for an immutable type. A copy is the value itself. Pickling
/// calls `keep`, and unpickling calls `make_again`.
template <class Type, class Keep, class MakeAgain>
void bind_copies(Type& type, const Keep& keep, const MakeAgain& make_again) {
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; })
      .def(py::pickle(keep, make_again));
  need_value(type);
}

}  // namespace gearwright::python
