// Writes the products of a STEP file and the position of each solid. The products are the tree that
// a CAD system displays. Internal to cad/.
//
// A single solid in its own frame is one product, a part. In all other cases, the file describes an
// assembly whose components are the parts, each at its pose. Both the product structure and the
// geometry contain the pose (NEXT_ASSEMBLY_USAGE_OCCURRENCE, ITEM_DEFINED_TRANSFORMATION), as the
// application protocols require. Lengths are in mm and angles in rad.
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

struct StepProtocol {
  const char* schema;   ///< schema name for the header
  const char* name;     ///< name in the definition of the protocol
  int year;             ///< year of publication
  const char* context;  ///< the subject of the protocol
};

/// Writes the products of the bodies, and the assembly if there is one. `solids` contains the solid
/// of each body.
///
/// Domain    at least one body (contract)
void add_products(Part21& out, const StepProtocol& protocol, const std::vector<ToothedBody>& bodies,
                  const std::vector<Part21Id>& solids, const std::string& assembly);

}  // namespace gearwright
