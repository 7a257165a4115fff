#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// Rejects the numbers of teeth of members that this kind of drive does not have.
void check_members(const TableReader& t, const DriveSearchProblem& p) {
  constexpr const char* kTeeth[] = {"sun_teeth",     "sun2_teeth", "idler_teeth", "planet_teeth",
                                    "planet2_teeth", "ring_teeth", "ring2_teeth"};
  const std::vector<SetMember> members = members_of(p);
  for (std::size_t m = 0; m < kSetMembers; ++m) {
    if (!p.teeth[m]) continue;
    if (!is_in(static_cast<SetMember>(m), members))
      t.fail(kTeeth[m], fmt::format("is not used for drives of kind \"{}\"",
                                    kDriveKindNames[static_cast<std::size_t>(p.kind)]));
  }
}

// Rejects keys that this kind of drive does not have. For a train, also rejects tables of numbers
// by member, because a train needs one number for all stages.
void check_kind(TableReader& t, const Json& search, bool train) {
  if (!train) {
    for (const char* key : {"stages", "pinion_teeth", "wheel_teeth", "center_distance_mm"})
      t.refuse(key, "is used only with kind = \"train\"");
    return;
  }
  for (const char* key :
       {"planets", "neighbour_clearance_min", "phasing", "spacing", "fixed", "input", "output"})
    t.refuse(key, "is used only for planetary sets, not for a train of pairs");
  for (const char* key :
       {"mesh_efficiency", "helix_angle_deg", "profile_shift", "thickness_allowance_mm"})
    if (search.contains(key) && !search[key].is_number())
      t.fail(key, "must be one number for all stages of a train");
  for (const char* key : {"backlash_mm", "face_width_mm"})
    if (search.contains(key) && search[key].is_object())
      t.fail(key, "must be one number or one band for all stages of a train");
}

}  // namespace

bool is_drive_search(const Json& search) { return search.is_object() && search.contains("kind"); }

Json shared_keys(const Json& search, bool train) {
  Json shared = Json::object();
  const KeyTable& own = train ? stage_keys() : planetary_keys();
  for (const auto& [key, value] : search.items())
    if (own.find(key) && key != "planets" && key != "teeth" && key != "center_distance_mm")
      shared[key] = value;
  return shared;
}

DriveSearchProblem read_drive_search(const Json& search) {
  TableReader t(drive_search_keys(), search, "search");
  DriveSearchProblem p;
  t.read(*drive_search_keys().find("kind"), p);
  check_kind(t, search, p.kind == DriveKind::train);
  t.read(p);
  t.require_all();
  check_members(t, p);
  if (p.kind != DriveKind::train) {
    PlanetarySpec set;  // with the members of this kind, without their numbers of teeth
    for (const SetMember member : members_of(p)) set.z(member) = 1;
    check_set_names(t, search, set);
  }
  t.any("material");
  t.finish();
  need_speeds(t, p.base.speeds_rpm, std::max<std::size_t>(p.base.inputs.size(), 1));
  if (p.modules.empty() && p.size_max < kInfinity)
    t.fail("size_max_mm",
           "is a length and needs normal_module_mm; without this key, all sizes are multiples of "
           "the module");
  if (p.modules.empty() && p.asks(DriveObjective::mass))
    t.fail("objective",
           "contains mass, which needs normal_module_mm, because without a module all sizes are in "
           "modules");
  for (const char* key : {"sliding_max", "overlap_ratio_min", "thickness_series", "backlash_mm",
                          "center_distance_mm"})
    if (p.modules.empty() && search.contains(key))
      t.fail(key, "needs normal_module_mm, because without a module no teeth are computed");
  if (!search.contains("spacing")) p.base.spacing = Spacing::equal;
  if (!p.modules.empty() && !search.contains("thickness_series") &&
      !search.contains("thickness_allowance_mm") && !search.contains("backlash_mm"))
    p.base.series = kUsualSeries;
  complete_ends(p);
  drive_materials({{"search", search}});  // read here only to report errors
  return p;
}

}  // namespace gearwright
