// Lists the members and meshes of planetary sets, with their names.
#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {

const char* to_string(SetMember member) {
  constexpr const char* kNames[] = {"sun", "sun2", "idler", "planet", "planet2", "ring", "ring2"};
  return kNames[static_cast<std::size_t>(member)];
}

std::vector<std::string> set_member_names() {
  std::vector<std::string> names;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    names.emplace_back(to_string(static_cast<SetMember>(m)));
  return names;
}

void PerMember::set(const std::string& member, double number) {
  const std::vector<std::string> known = names();
  const auto it = std::find(known.begin(), known.end(), member);
  GW_EXPECTS(it != known.end());
  each[static_cast<std::size_t>(it - known.begin())] = number;
}

std::vector<std::string> PerMesh::names() {
  return {"sun_planet", "sun_idler", "idler_planet", "sun2_planet", "planet_ring", "planet_ring2"};
}

std::vector<SetMesh> meshes_of(const PlanetarySpec& spec) {
  using M = SetMember;
  const auto has = [&](M m) { return spec.z(m).has_value(); };
  const M second = has(M::planet2) ? M::planet2 : M::planet;
  std::vector<SetMesh> list;
  if (has(M::sun) && has(M::idler)) list.push_back({"sun_idler", M::sun, M::idler});
  if (has(M::idler)) list.push_back({"idler_planet", M::idler, M::planet});
  if (has(M::sun) && !has(M::idler)) list.push_back({"sun_planet", M::sun, M::planet});
  if (has(M::sun2)) list.push_back({"sun2_planet", M::sun2, second});
  if (has(M::ring)) list.push_back({"planet_ring", M::planet, M::ring});
  if (has(M::ring2)) list.push_back({"planet_ring2", second, M::ring2});
  return list;
}

std::optional<double> PerMesh::of(const std::string& mesh) const {
  for (const auto& [name, value] : each)
    if (name == mesh) return value;
  return all;
}

}  // namespace gearwright
