// Lists the functions and types of the extension module gearwright._core.
#include <pybind11/pybind11.h>

#include "apps/python/model.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"

namespace py = pybind11;
using namespace gearwright::python;

PYBIND11_MODULE(_core, m) {
  m.doc() = "The engine behind the package gearwright; import gearwright instead";
  m.attr("__version__") = gearwright::kVersion;
  py::register_exception<gearwright::IoError>(m, "FileError", PyExc_OSError);
  py::register_exception<gearwright::ContractViolation>(m, "ContractViolation", PyExc_RuntimeError);
  auto [gear, pair] = bind_gears(m);
  auto contact = bind_answers(m, pair);
  bind_mountings(m, pair);
  bind_sweep(pair);
  bind_files(gear, pair);
  bind_pictures(m, gear, pair, contact);
  bind_search(m);
  bind_closed_forms(m);
  bind_catalogue(m);
}
