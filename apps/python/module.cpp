// Lists the functions and types of the extension module gearwright._core.
#include <pybind11/pybind11.h>

#include <cstring>
#include <exception>

#include "apps/python/model.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"

namespace py = pybind11;
using namespace gearwright::python;

namespace {

// FileError is an OSError with errno, strerror and filename, if the system gave them.
void bind_file_error(py::module_& m) {
  static const py::handle file_error =  // never destroyed, because the interpreter may end before
      (new py::exception<gearwright::IoError>(m, "FileError", PyExc_OSError))->ptr();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const gearwright::IoError& e) {
      const py::object made = e.code() == 0 ? file_error(e.what())
                                            : file_error(e.code(), std::strerror(e.code()),
                                                         py::cast(e.path().string()));
      PyErr_SetObject(file_error.ptr(), made.ptr());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The engine behind the package gearwright; import gearwright instead";
  m.attr("__version__") = gearwright::kVersion;
  bind_file_error(m);
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
