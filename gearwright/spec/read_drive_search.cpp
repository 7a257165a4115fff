
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// Rejects numbers of teeth of members that drives of this kind do not have.
void check_members(TableReader& t, const DriveSearchProblem& p) {
  constexpr const char* kTeeth[] = {"sun_teeth",     "sun2_teeth", "idler_teeth", "planet_teeth",
                                    "planet2_teeth", "ring_teeth", "ring2_teeth"};
  const std::string kind(kDriveKindNames[static_cast<std::size_t>(p.kind)]);
  const std::vector<SetMember> members = members_of(p);
  for (std::size_t m = 0; m < kSetMembers; ++m) {
    if (!p.teeth[m]) continue;
    if (std::find(members.begin(), members.end(), static_cast<SetMember>(m)) == members.end())
      t.fail(kTeeth[m], fmt::format("is not used for drives of kind \"{}\"", kind));
  }
  const bool train = p.kind == DriveKind::train;
  for (const char* key : {"stages", "pinion_teeth", "wheel_teeth"})
    if (!train) t.refuse(key, "is used only with kind = \"train\"");
  for (const char* key :
       {"planets", "neighbour_clearance_min", "phasing", "spacing", "fixed", "input", "output"})
    if (train) t.refuse(key, "is used only for planetary sets, not for a train of pairs");
}

std::array<double, 2> read_width_band(const TableReader& t, const Json& band) {
  const bool numbers = band.size() == 2 && band[0].is_number() && band[1].is_number();
  if (!numbers || !(band[0].get<double>() > 0.0 && band[0] <= band[1]))
    t.fail("face_width_mm",
           "must be a number, a table of numbers by member, or a band of two positive numbers in "
           "rising order, for example [20, 60]");
  return {band[0].get<double>(), band[1].get<double>()};
}

}  // namespace

bool is_drive_search(const Json& search) { return search.is_object() && search.contains("kind"); }

Json shared_keys(const Json& search, bool train) {
  Json shared = Json::object();
  const KeyTable& own = train ? stage_keys() : planetary_keys();
  for (const auto& [key, value] : search.items())
    if (own.find(key) && key != "planets" && key != "teeth") shared[key] = value;
  return shared;
}

DriveSearchProblem read_drive_search(const Json& given) {
  Json search = given;
  if (const auto module = search.find("normal_module_mm");
      module != search.end() && module->is_string())
    if (const auto series = module_series(module->get<std::string>()); !series.empty())
      *module = series;
  TableReader t(drive_search_keys(), search, "search");
  DriveSearchProblem p;
  t.read(p);
  t.require_all();
  check_members(t, p);
  for (const Key& key : drive_search_keys().keys)
    if (!key.place) t.any(std::string(key.key));
  t.finish();
  if (p.modules.empty() && p.size_max < kInfinity)
    t.fail("size_max_mm",
           "needs normal_module_mm, because without a module all sizes are in modules");
  if (p.modules.empty() && t.given("sliding_max"))
    t.fail("sliding_max", "needs normal_module_mm, because without a module no teeth are computed");
  for (const char* key : {"thickness_series", "backlash_mm"})
    if (p.modules.empty() && search.contains(key))
      t.fail(key, "needs normal_module_mm, because without a module no teeth are computed");
  if (p.kind == DriveKind::train) {
    for (const char* key :
         {"mesh_efficiency", "helix_angle_deg", "profile_shift", "thickness_allowance_mm"})
      if (search.contains(key) && !search[key].is_number())
        t.fail(key, "must be one number for all stages of a train");
    for (const char* key : {"backlash_mm", "face_width_mm"})
      if (search.contains(key) && search[key].is_object())
        t.fail(key, "must be one number or one band for all stages of a train");
  }
  Json set = shared_keys(search, false);
  set["planet"] = 20;
  set.erase("normal_module_mm");
  if (const auto band = set.find("face_width_mm"); band != set.end() && band->is_array()) {
    p.face_width = read_width_band(t, *band);
    set.erase("face_width_mm");
  }
  p.base = read_set(set, "search");
  if (!search.contains("spacing")) p.base.spacing = Spacing::equal;
  if (!p.modules.empty() && !search.contains("thickness_series") &&
      !search.contains("thickness_allowance_mm") && !search.contains("backlash_mm"))
    p.base.series = kUsualSeries;
  complete_ends(p);
  drive_materials({{"search", given}});  // read here only to report errors
  return p;
}

}  // namespace gearwright
