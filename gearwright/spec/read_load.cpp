#include "gearwright/spec/read_load.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace gearwright {

namespace {

LoadProbeInput read_probe(const Json& node, const std::string& path) {
  TableReader t(load_probe_keys(), node, path);
  LoadProbeInput p;
  t.read(p);
  if (const auto z = t.numbers("z_mm")) {
    if (!((*z)[0] < (*z)[1]))
      t.fail("z_mm", "must grow: where the load begins, then where it ends");
    p.z = {(*z)[0], (*z)[1]};
  }
  p.read_z = t.numbers("read_z_mm").value_or(std::vector<double>());
  if (!p.read_z.empty() && !p.z)
    t.fail("read_z_mm", "needs z_mm: over a wide gear the displacement is the same everywhere");
  t.finish();
  return p;
}

}  // namespace

LoadInput read_load(const Json& node) {
  TableReader t(load_keys(), node, "load");
  LoadInput l;
  l.given = true;
  t.read(l);
  for (const double m : t.numbers("torque_Nm").value_or(std::vector<double>())) {
    t.check("torque_Nm", m);
    l.torques.push_back(m);
  }
  for (const double r : t.numbers("rotation1_deg").value_or(std::vector<double>())) {
    t.check("rotation1_deg", r);
    l.rotations.push_back(Angle::degrees(r));
  }
  if (const Json* probes = t.any("probe")) {
    const bool list = probes->is_array() && !probes->empty() && probes->size() <= kMostProbes;
    if (!list)
      t.fail("probe",
             fmt::format("must be a list of tables, [[load.probe]], 1 to {} of them", kMostProbes));
    for (std::size_t i = 0; i < probes->size(); ++i) {
      const Json& item = (*probes)[i];
      if (!item.is_object()) t.fail("probe", shown(item) + " is no table");
      l.probes.push_back(read_probe(item, fmt::format("load.probe[{}]", i)));
    }
  }
  t.finish();
  return l;
}

}  // namespace gearwright
