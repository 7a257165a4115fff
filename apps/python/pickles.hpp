// Records as Python's own values, and back: what a pickle keeps of them.
//
//   record   a tuple of (table, key, value, shown), by their names in the catalogue
//   list     a list      map   a dict      nothing   None      numbers, flags and words themselves
#pragma once

#include "apps/python/values.hpp"

namespace gearwright::python {

py::object kept(const ValueRecord& record);
/// Throws    ValueError where this version's catalogue has no such quantity
ValueRecord recalled(py::handle record);

/// Every table of the catalogue that attributes and records come from, those of records in them too.
std::vector<const QuantityTable*> all_tables();

/// copy, deepcopy and pickle of a value that never changes: itself, and what `keep` and `make_again`
/// say of it.
template <class Type, class Keep, class MakeAgain>
void bind_copies(Type& type, const Keep& keep, const MakeAgain& make_again) {
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; })
      .def(py::pickle(keep, make_again));
}

}  // namespace gearwright::python
