// Outline, mesh, files and place of gears.
#pragma once

#include "apps/python/model.hpp"

namespace gearwright::python {

void bind_files(py::class_<GearValue>& gear, py::class_<PairValue>& pair);

}  // namespace gearwright::python
