// The catalogue as JSON, for forms and tables: every key of a spec, every quantity of a result. The
// shape: `Catalogue` of engine.d.ts.
#pragma once

#include <string>

namespace gearwright::web {

std::string catalogue_json();

}  // namespace gearwright::web
