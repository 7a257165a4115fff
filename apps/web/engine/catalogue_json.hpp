// Writes the catalogue as JSON for forms and tables. It contains every key of a spec and every
// quantity of a result. Its structure is `Catalogue` in engine.d.ts.
#pragma once

#include <string>

namespace gearwright::web {

std::string catalogue_json();

}  // namespace gearwright::web
