#include "gearwright/curve/arc_name.hpp"

#include "gearwright/base/contract.hpp"

namespace gearwright {

std::string_view to_string(ArcName name) {
  switch (name) {
    case ArcName::root_land: return "root_land";
    case ArcName::root_fillet: return "root_fillet";
    case ArcName::flank: return "flank";
    case ArcName::tip_fillet: return "tip_fillet";
    case ArcName::tip_land: return "tip_land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

}  // namespace gearwright
