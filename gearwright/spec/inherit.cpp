#include "gearwright/spec/inherit.hpp"

#include <cmath>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

using Keys = std::vector<std::string>;

const Keys kHelices{"helix_angle_deg", "lead_angle_deg"};

// Sets a member of a table. Like the TOML reader, inserts a new member in alphabetic order, so that
// a spec that is written and read again gives the same tree.
void put_value(Json& table, const std::string& key, const Json& value) {
  Json::object_t& members = table.get_ref<Json::object_t&>();
  Json::object_t sorted;
  bool there = false;
  for (auto& [name, member] : members) {
    if (!there && name > key) sorted.emplace_back(key, value);
    there = there || name > key;
    sorted.emplace_back(name, std::move(member));
  }
  if (!there) sorted.emplace_back(key, value);
  table = std::move(sorted);
}

std::optional<double> number(const Json& table, const std::string& key) {
  const auto it = table.find(key);
  if (it == table.end() || !it->is_number()) return std::nullopt;
  return it->get<double>();
}

double helix_of(const Json& gear) {
  if (const auto beta = number(gear, "helix_angle_deg")) return std::abs(*beta);
  if (const auto lead = number(gear, "lead_angle_deg")) return 90.0 - *lead;
  return 0.0;
}

bool parallel(const Json& tree) {
  const auto pair = tree.find("pair");
  if (pair == tree.end() || !pair->is_object()) return true;
  return !pair->contains("shaft_angle_deg") || number(*pair, "shaft_angle_deg") == 0.0;
}

// Copies the helix angle with the opposite hand or, for an internal gear, with the same hand. If
// `to` gives a hand, this hand is kept. Returns true if the angle was copied.
bool hand_on_helix(const Json& from, Json& to) {
  if (has_any(to, kHelices) || !has_any(from, kHelices)) return false;
  const bool ring = number(to, "teeth").value_or(0.0) < 0.0;
  const auto hand = from.find("hand");
  const bool left = hand != from.end() && *hand == "left";
  const bool own_hand = to.contains("hand");
  if (const auto beta = number(from, "helix_angle_deg")) {
    double turned = ring || *beta == 0.0 ? *beta : -*beta;
    if (own_hand && *beta != 0.0) turned = std::abs(*beta) * (to["hand"] == "left" ? -1.0 : 1.0);
    put_value(to, "helix_angle_deg", turned);
  } else if (const auto lead = number(from, "lead_angle_deg")) {
    put_value(to, "lead_angle_deg", *lead);
    if (!own_hand && hand != from.end()) put_value(to, "hand", left == ring ? "left" : "right");
  }
  return true;
}

// Copies one quantity of gear 1 to gear 2, unless gear 2 gives this quantity. Either gear may give
// the quantity by `key` or by an alias of this key. A value in the transverse section is converted,
// because the helix angle of gear 2 may be different.
void hand_on(const Json& from, Json& to, const std::string& key) {
  const Keys ways = gear_keys().ways(key);
  if (has_any(to, ways)) return;
  for (const std::string& way : ways) {
    if (!from.contains(way)) continue;
    const KeyAlias& alias = gear_keys().find(way)->alias;
    const auto value = number(from, way);
    if (alias.transverse && value) {
      put_value(to, key, alias.value(*value, std::cos(Angle::degrees(helix_of(from)).rad())));
    } else {
      put_value(to, way, from[way]);
    }
    return;
  }
}

// Returns the accuracy grade of a gear, which is either in the table of the gear or in the table of
// its tolerances. Returns null if there is no grade.
const Json* quality_of(const Json& gear) {
  if (const auto own = gear.find("quality"); own != gear.end()) return &*own;
  const auto tolerance = gear.find("tolerance");
  if (tolerance == gear.end() || !tolerance->is_object()) return nullptr;
  const auto grade = tolerance->find("quality");
  return grade == tolerance->end() ? nullptr : &*grade;
}

// Copies the edition of the standard to which the accuracy grade belongs, if `to` gives no edition.
void hand_on_edition(const Json& from, Json& to) {
  const auto tolerance = from.find("tolerance");
  if (tolerance == from.end() || !tolerance->is_object() || !tolerance->contains("edition")) return;
  Json own = to.contains("tolerance") ? to["tolerance"] : Json::object();
  if (!own.is_object() || own.contains("edition")) return;
  put_value(own, "edition", (*tolerance)["edition"]);
  if (to.contains("tolerance")) {
    to["tolerance"] = std::move(own);
  } else {
    put_value(to, "tolerance", own);
  }
}

// Copies the gap and the stagger of the halves, but neither the groove nor the hob of gear 1.
void hand_on_halves(const Json& from, Json& to) {
  const auto halves = from.find("double_helical");
  if (halves == from.end() || !halves->is_object() || to.contains("double_helical")) return;
  Json own = Json::object();
  for (const char* key : {"gap_mm", "stagger_pitches"})
    if (halves->contains(key)) put_value(own, key, (*halves)[key]);
  put_value(to, "double_helical", own);
}

// A rack with straight flanks or with double arcs cuts both gears of a pair. The racks F and P cut
// one gear each.
bool cuts_both(const Json& rack) {
  if (rack.is_string()) return true;
  if (!rack.is_object()) return false;
  const auto kind = rack.find("kind");
  return kind == rack.end() || *kind == "straight" || *kind == "double_circular_arc";
}

}  // namespace

bool is_rack(const Json& gear) {
  if (!gear.is_object()) return false;
  const auto form = gear.find("form");
  return form != gear.end() && *form == "rack";
}

Json with_named_materials(const Json& tree) {
  if (tree.is_array()) {
    Json list = Json::array();
    for (const Json& item : tree) list.push_back(with_named_materials(item));
    return list;
  }
  if (!tree.is_object()) return tree;
  const auto named = [](const Json& node) {
    return node.is_string() ? Json{{material_keys().shorthand, node}} : node;
  };
  Json::object_t whole;
  for (const auto& [key, node] : tree.items()) {
    if (key == "drawing") {
      whole.emplace_back(key, node);  // the key `material` of [drawing] is a text for users
    } else if (key == "material" && node.is_object()) {
      Json::object_t table;  // in a planetary set, each member may have its own material
      for (const auto& [member, value] : node.items())
        table.emplace_back(member, material_keys().find(member) ? value : named(value));
      whole.emplace_back(key, std::move(table));
    } else {
      whole.emplace_back(key, key == "material" ? named(node) : with_named_materials(node));
    }
  }
  return whole;
}

Inherited inherit(const Json& tree) {
  Inherited made{tree, false};
  const auto gear = [&](const char* name) -> Json* {
    const auto it = made.tree.find(name);
    const bool mounted = it != made.tree.end() && it->is_object() && it->contains("teeth");
    return mounted && !is_rack(*it) ? &*it : nullptr;
  };
  const Json* from = gear("gear1");
  Json* to = gear("gear2");
  if (!from || !to) return made;
  if (is_unknown_gear(*to) && !has_module(*from)) return made;
  if (from->contains("material") && !to->contains("material")) {
    put_value(*to, "material", (*from)["material"]);
    made.noted.emplace_back("material");
  }
  if (quality_of(*from) && !quality_of(*to)) {
    put_value(*to, "quality", *quality_of(*from));
    made.noted.emplace_back("quality");
    hand_on_edition(*from, *to);
  }
  if (parallel(tree) && !tree.contains("fit")) {
    hand_on(*from, *to, "face_width_mm");
    hand_on_halves(*from, *to);
  }
  if (has_any(*to, {"cut_by", "basic"})) return made;
  if (parallel(tree) && !from->contains("basic")) made.helix_angle = hand_on_helix(*from, *to);
  hand_on(*from, *to, "normal_module_mm");
  hand_on(*from, *to, "normal_pressure_angle_deg");
  if (from->contains("rack") && !to->contains("rack") && cuts_both((*from)["rack"]))
    put_value(*to, "rack", (*from)["rack"]);
  return made;
}

}  // namespace gearwright
