// Makes planetary sets with given efficiencies, for the tests of drive/.
#pragma once

#include <string>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright::testing {

/// Returns a set with one planet and the given efficiencies of its meshes.
inline PlanetarySpec simple_set(int sun, int planet, int ring, double eta_sp, double eta_pr) {
  PlanetarySpec set;
  set.z(SetMember::sun) = sun;
  set.z(SetMember::planet) = planet;
  set.z(SetMember::ring) = ring;
  set.planets = 1;
  set.efficiency.each = {{"sun_planet", eta_sp}, {"planet_ring", eta_pr}};
  return set;
}

inline Drive made(const PlanetarySpec& set) {
  return taken(make_drive({taken(graph_of(set)), {}}));
}

/// Returns the field of the error of the graph or the drive, or "" without an error.
inline std::string error_field(const PlanetarySpec& set) {
  const auto graph = graph_of(set);
  if (!graph) return graph.error().field;
  const auto drive = make_drive({*graph, {}});
  return drive ? "" : drive.error().field;
}

}  // namespace gearwright::testing
