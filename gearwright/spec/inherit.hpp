// Copies values from gear 1 to gear 2 if the table of gear 2 omits them. These values are the
// module, the pressure angle, the rack, the face width, the gap and stagger of a double-helical
// gear, the material, the accuracy grade with its edition, and the helix angle. Gear 2 gets the
// opposite hand of helix, or the same hand if it is an internal gear. A material that is only a
// name becomes a table.
//
// Internal to spec/ and the programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/spec/json.hpp"

namespace gearwright {

struct Inherited {
  Json tree;                 ///< the spec, in which gear 2 has all its keys
  bool helix_angle = false;  ///< true if the helix angle of gear 2 is a copy; such an angle counts
                             ///< as not given
  std::vector<std::string> noted{};  ///< copied keys that are not dimensions: material, quality
};

/// True if the table describes a rack, that is, contains form = "rack".
bool is_rack(const Json& gear);
/// The reason for rejecting a key of a gear in the table of a rack.
inline constexpr std::string_view kNotOfRack =
    "does not apply to a rack, which has the basic rack, the module and the helix angle of its "
    "pinion";

/// Returns the spec in which every material that is only a name, for example material = "16MnCr5",
/// is replaced by a table [material] with this name.
Json with_named_materials(const Json& tree);

/// Copies values from gear 1 to gear 2, if both tables give a number of teeth and gear 2 is not a
/// rack. If gear 2 has `cut_by` or [basic], helix angle, module, pressure angle and rack are not
/// copied. The helix angle is not copied if the axes cross at a given angle or if gear 1 has
/// [basic]. Face width, gap and stagger are not copied if the axes cross at a given angle or if the
/// spec has [fit]. A rack of arcs is not copied if it can cut only one gear of a pair. If gear 2 is
/// unknown and gear 1 has no module, nothing is copied.
Inherited inherit(const Json& tree);

}  // namespace gearwright
