// Files of the source tree that tests read: golden cases, tables of oracles, documents.
//
// Only one object file contains the path of the source tree. All other objects are therefore
// identical for two copies of the tree.
#pragma once

#include <string>

namespace gearwright::testing {

/// Path of a file of the source tree: source_file("docs/accuracy.md").
std::string source_file(const std::string& path);

}  // namespace gearwright::testing
