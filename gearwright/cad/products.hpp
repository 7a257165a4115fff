// Products of a STEP file: the tree in a CAD system, and the position of each solid.
// Internal to cad/.
//
// A single solid in its own frame is one product, a part. Otherwise there is an assembly, whose
// components are the parts, each placed by its pose: product structure and geometry both contain
// the pose, as the application protocols require (NEXT_ASSEMBLY_USAGE_OCCURRENCE,
// ITEM_DEFINED_TRANSFORMATION). Every representation has a context of its own, all with the same
// units: mm, rad.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/cad/part21.hpp"

namespace gearwright {

/// The application protocol that a file follows.
struct StepProtocol {
  const char* schema;   ///< for the header
  const char* name;     ///< of the protocol's definition
  int year;             ///< of its publication
  const char* context;  ///< what it is about
};

struct StepPart {
  std::string name;
  Eigen::Isometry3d pose;  ///< mm
  Part21Id solid;
  std::optional<std::size_t> colour{};   ///< of part_colour(); none: by its place
  std::optional<std::size_t> same_as{};  ///< an earlier part that it is another copy of
};

/// Domain    at least one part (contract)
void add_products(Part21& out, const StepProtocol& protocol, const std::vector<StepPart>& parts,
                  const std::string& assembly);

}  // namespace gearwright
