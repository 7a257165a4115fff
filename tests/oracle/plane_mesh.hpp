// The triangles that tests/oracle/plane_teeth.hpp uses.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <map>
#include <vector>

#include "tests/oracle/plane_teeth.hpp"

namespace gearwright::oracle {

struct PlaneTooth {
  std::vector<double> place;    ///< positions along the outline: ends and middles of the sides of
                                ///< triangles
  std::vector<int> node;        ///< nodes at these positions, on the side y > 0
  std::size_t root_nodes = 0;   ///< number of these nodes that are not on the flank
  double loaded = -1.0;         ///< position of the load; < 0 if there is none
  std::complex<double> normal;  ///< normal into the tooth at the load

  int middle() const { return node[std::find(place.begin(), place.end(), loaded) - place.begin()]; }
};

struct PlaneMesh {
  std::vector<std::complex<double>> nodes;
  /// The corners of each triangle, counter-clockwise, followed by the middles of its sides,
  /// beginning with the first side.
  std::vector<std::array<int, 6>> triangles;
  std::vector<int> held;
  std::map<int, PlaneTooth> teeth;  ///< the teeth with their outline
};

PlaneMesh plane_mesh(const PlaneGear& gear, const std::vector<PlaneLoad>& loads, double fineness);

}  // namespace gearwright::oracle
