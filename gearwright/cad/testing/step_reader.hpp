// Reads STEP files with an independent reader, OCCT. Only tests with names of the form
// step*_test.cpp include this file. They are built into a separate program, step_tests, because
// only this program links OCCT.
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <string>
#include <vector>

namespace gearwright::testing {

struct ReadStep {
  int refusals = 0;                ///< number of instances that the reader rejects
  int free_shapes = 0;             ///< number of roots of the product structure
  TopoDS_Shape shape;              ///< shape of the first root
  std::vector<std::string> names;  ///< names of that root and then of its components, UTF-8
  std::vector<std::array<double, 3>> colours;  ///< colours of the parts, linear RGB
  std::vector<TopoDS_Solid> solids;            ///< each at its position
};

ReadStep read_step(const std::string& text);

/// Returns the volume by adaptive integration with a relative accuracy of 1e-10. The result is
/// negative if the solid is inside out.
double volume(const TopoDS_Shape& shape);

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

}  // namespace gearwright::testing
