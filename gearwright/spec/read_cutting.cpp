#include "gearwright/spec/read_cutting.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/spec/read_gear.hpp"

namespace gearwright {

namespace {

// Numbers that a gear, its cutter and its mating gear share: a cutter's table may leave them out.
Json with_shared_keys(const Json& cutter, const Json& gear, const Json* mate) {
  static const std::vector<std::vector<const char*>> kShared{
      {"normal_module_mm", "normal_diametral_pitch_per_in", "transverse_module_mm"},
      {"normal_pressure_angle_deg", "transverse_pressure_angle_deg"}};
  Json whole = cutter;
  for (const auto& keys : kShared) {
    const auto in = [&](const Json& table) {
      return std::any_of(keys.begin(), keys.end(),
                         [&](const char* key) { return table.contains(key); });
    };
    if (in(cutter)) continue;
    const bool own = in(gear);
    for (const char* key : keys) {
      if (own && gear.contains(key)) whole[key] = gear[key];
      if (!own && mate && mate->contains(key)) whole[key] = (*mate)[key];
    }
  }
  static const std::vector<const char*> kHelix{"helix_angle_deg", "lead_angle_deg", "hand"};
  const auto has_helix = [](const Json& table) {
    return std::any_of(kHelix.begin(), kHelix.end(),
                       [&](const char* key) { return table.contains(key); });
  };
  if (has_helix(cutter)) return whole;
  if (gear.contains("helix_angle_deg") && gear["helix_angle_deg"].is_number()) {
    const bool ring = gear.contains("teeth") && gear["teeth"].is_number() && gear["teeth"] < 0;
    whole["helix_angle_deg"] = (ring ? 1.0 : -1.0) * gear["helix_angle_deg"].get<double>();
  } else if (!has_helix(gear) && mate) {  // the cutter stands where the mating gear will
    for (const char* key : kHelix) {
      if (mate->contains(key)) whole[key] = (*mate)[key];
    }
  }
  return whole;
}

// A cutter reaches as deep as the teeth it is made for need clearance.
constexpr double kCutterAddendum = 1.25;

}  // namespace

void read_fillets(TableReader& gear, GearInput& g) {
  if (const Json* node = gear.table("root_fillet")) {
    TableReader t(root_fillet_keys(), *node, gear.name("root_fillet"));
    t.word("kind");
    RootFilletSpec fillet;
    t.read(fillet);
    t.finish();
    g.cylindrical.root_fillet = fillet;
  }
  if (const Json* node = gear.table("tip_fillet")) {
    TableReader t(tip_fillet_keys(), *node, gear.name("tip_fillet"));
    t.word("kind");
    TipFilletInput in;
    t.read(in);
    t.finish();
    g.tip_clearance = in.clearance;
    if (in.radius) g.cylindrical.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, *in.radius};
    if (in.l) g.cylindrical.tip_fillet = TipFilletSpec{TipFilletSpec::By::l, *in.l};
    if (in.corner_radius)
      g.cylindrical.tip_fillet = TipFilletSpec{TipFilletSpec::By::corner, *in.corner_radius};
    g.tip_clearance_by_rule = !in.radius && !in.l && !in.clearance && !in.corner_radius;
  }
}

void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g) {
  const auto total = gear.number("profile_shift_pair");
  const Json* by = gear.any("cut_by");
  if (!by) {
    if (total) gear.fail("profile_shift_pair", "belongs to a gear with cut_by");
    return;
  }
  CutByInput cut;
  cut.profile_shift_pair = total;
  if (by->is_string()) {
    const auto name = by->get<std::string>();
    if (name != "gear1" && name != "gear2")
      gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table with a cutter's numbers");
    cut.gear = name == "gear1" ? 1 : 2;
  } else if (by->is_object()) {
    const std::string path = gear.name("cut_by");
    for (const auto& [key, why] :
         {std::pair{"cut_by", "a cutter of its own is cut by a rack; leave this out"},
          std::pair{"profile_shift_pair", "belongs to the gear that is cut, beside cut_by"},
          std::pair{"modifications",
                    "a cutter has no flank modifications; those of the gear that it cuts stand "
                    "beside cut_by"}}) {
      if (by->contains(key)) gear.fail(std::string("cut_by.") + key, why);
    }
    GearInput cutter = read_gear(cutter_keys(), with_shared_keys(*by, node, mate), path);
    if (cutter.cylindrical.teeth < 0)
      gear.fail("cut_by.teeth", "must be positive: an internal gear cannot be a pinion cutter");
    if (!by->contains("rack")) cutter.cylindrical.straight_rack().addendum = kCutterAddendum;
    if (cutter.tip_clearance || cutter.tip_clearance_by_rule) {
      gear.fail("cut_by.tip_fillet",
                "a cutter has no mating gear to keep clear of; give corner_radius_mm, radius_mm or "
                "l_mm");
    }
    cut.cutter = std::make_shared<GearInput>(std::move(cutter));
  } else {
    gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table with a cutter's numbers");
  }
  for (const char* key : {"rack", "root_fillet", "tip_fillet", "basic", "thickness_allowance_mm"}) {
    if (gear.has(key)) {
      gear.fail(key,
                "has no place beside cut_by: the cutter and the generating centre distance "
                "decide the tooth");
    }
  }
  if (total && g.profile_shift) {
    gear.fail("profile_shift_pair",
              "and profile_shift both say how deep the cutter goes; leave one of them out");
  }
  g.cut_by = std::move(cut);
}

}  // namespace gearwright
