// STEP files as a foreign reader, OCCT, sees them. Only the tests named step*_test.cpp include this;
// they are a program of their own, step_tests, which alone links OCCT.
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <string>
#include <vector>

namespace gearwright::testing {

struct ReadStep {
  int refusals = 0;                ///< instances that the reader finds wrong
  int free_shapes = 0;             ///< roots of the product structure
  TopoDS_Shape shape;              ///< the first of them
  std::vector<std::string> names;  ///< of that root, then of its components' parts; UTF-8
  std::vector<std::array<double, 3>> colours;  ///< of the parts, linear RGB
  std::vector<TopoDS_Solid> solids;            ///< in place
};

ReadStep read_step(const std::string& text);

/// Volume by adaptive integration, 1e-10 of itself; negative inside out.
double volume(const TopoDS_Shape& shape);

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

}  // namespace gearwright::testing
