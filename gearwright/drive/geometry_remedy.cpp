#include "gearwright/drive/geometry_remedy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// The greatest differences from the nominal values that are tried. Teeth of usual height do not
// permit greater differences.
constexpr int kMostTeeth = 40;
constexpr double kMostDistance = 10.0;  // m_n

// True for a mesh of two gears whose tooth data are known.
bool meshes_teeth(const DriveGraph& graph, const DriveMesh& mesh) {
  return graph.gear(mesh, 0).spec && graph.gear(mesh, 1).spec && !graph.gear(mesh, 1).rack;
}

bool no_problem(const std::vector<Warning>& warnings) {
  return std::none_of(warnings.begin(), warnings.end(),
                      [](const Warning& w) { return severity_of(w) == Severity::problem; });
}

bool is_possible(const DriveGraph& graph) {
  const DriveGeometry made = drive_geometry(graph);
  if (!made.faults.empty()) return false;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m)
    if (meshes_teeth(graph, graph.meshes[m]) &&
        !(made.touches(m) && no_problem(made.pairs[m]->warnings())))
      return false;
  return true;
}

// Returns the index (0 or 1) of the planet in a mesh of a planet with a central gear. Returns none
// for any other mesh.
std::optional<int> planet_of(const DriveGraph& graph, std::size_t mesh) {
  const auto rides = [&](int which) {
    return graph.body(graph.gear(graph.meshes[mesh], which)).carrier.has_value();
  };
  if (rides(0) == rides(1)) return std::nullopt;
  return rides(0) ? 0 : 1;
}

std::vector<std::size_t> with_same_distance(const DriveGraph& graph, std::size_t mesh) {
  for (const auto& meshes : distance_classes(graph))
    if (is_in(mesh, meshes)) return meshes;
  return {};
}

}  // namespace

std::vector<std::vector<std::size_t>> distance_classes(const DriveGraph& graph) {
  std::vector<std::vector<std::size_t>> classes;
  std::vector<std::optional<std::size_t>> planet;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    const std::size_t a = graph.gear(graph.meshes[m], 0).body;
    const std::size_t b = graph.gear(graph.meshes[m], 1).body;
    const bool rides_a = graph.bodies[a].carrier.has_value();
    const bool rides_b = graph.bodies[b].carrier.has_value();
    std::optional<std::size_t> rider;
    if (rides_a != rides_b) rider = rides_a ? a : b;
    std::size_t k = 0;
    while (k < classes.size() && !(rider && planet[k] == rider)) ++k;
    if (k == classes.size()) {
      classes.emplace_back();
      planet.push_back(rider);
    }
    classes[k].push_back(m);
  }
  return classes;
}

std::optional<std::array<double, 2>> possible_distances(const DriveGraph& graph, std::size_t mesh) {
  DriveGraph tried = graph;
  const auto meshes = with_same_distance(graph, mesh);
  for (const std::size_t m : meshes) tried.meshes[m].center_distance.reset();
  const auto natural = drive_geometry(tried).distance[mesh];
  const auto possible = [&](double a) {
    tried.meshes[meshes.front()].center_distance = a;
    return is_possible(tried);
  };
  if (!natural || !possible(*natural)) return std::nullopt;
  const double module = graph.gear(graph.meshes[mesh], 0).spec->normal_module;
  std::array<double, 2> range{};
  for (const int side : {0, 1}) {
    double step = (side == 0 ? -0.025 : 0.025) * module, good = *natural;
    while (std::abs(good - *natural) < kMostDistance * module && possible(good + step))
      good += step;
    for (int i = 0; i < 5; ++i) {  // 0.025 m_n/2⁵ < m_n/1000
      step /= 2;
      if (possible(good + step)) good += step;
    }
    range[static_cast<std::size_t>(side)] = good;
  }
  return range;
}

std::optional<PossibleTeeth> possible_teeth(const DriveGraph& graph, std::size_t mesh) {
  const auto planet = planet_of(graph, mesh);
  const auto distance = drive_geometry(graph).distance[mesh];
  if (!planet || !distance) return std::nullopt;
  const std::size_t gear = graph.meshes[mesh].gears[static_cast<std::size_t>(1 - *planet)];
  const DriveGear& rider = graph.gear(graph.meshes[mesh], *planet);
  const int sign = side_of<int>(graph.gears[gear].teeth);
  const double sum =
      2 * *distance * std::cos(rider.spec->helix_angle.rad()) / rider.spec->normal_module;
  const int nominal = static_cast<int>(std::lround(sum)) - sign * rider.teeth;
  const auto possible = [&](int z) {
    if (z < 1 || std::abs(z - nominal) > kMostTeeth) return false;
    DriveGraph tried = graph;
    tried.meshes[with_same_distance(graph, mesh).front()].center_distance = distance;
    tried.gears[gear].teeth = sign * z;
    return is_possible(tried);
  };
  for (const int first : {nominal, nominal + 1, nominal - 1}) {
    if (!possible(first)) continue;
    PossibleTeeth found{gear, first, first, nominal};
    while (possible(found.least - 1)) --found.least;
    while (possible(found.greatest + 1)) ++found.greatest;
    return found;
  }
  return std::nullopt;
}

namespace {

// Returns the changes with which the mesh and the whole drive are possible, as a sentence. The text
// is empty if no such change is found.
std::string changes_for(const DriveGraph& graph, std::size_t m) {
  const auto same = with_same_distance(graph, m);
  const bool given = std::any_of(same.begin(), same.end(), [&](std::size_t k) {
    return graph.meshes[k].center_distance.has_value();
  });
  if (const auto range = given ? possible_distances(graph, m) : std::nullopt)
    return fmt::format("A centre distance from {:.3f} mm to {:.3f} mm is possible.",
                       rounded_up((*range)[0], 3), rounded_down((*range)[1], 3));
  const auto teeth = possible_teeth(graph, m);
  if (!teeth) return {};
  const std::string& name = graph.gears[teeth->gear].name;
  std::string text = fmt::format("{} = {}", name, teeth->least);
  if (teeth->greatest > teeth->least) text += fmt::format(" to {}", teeth->greatest);
  text += " is possible.";
  // If a planet with a single gear meshes with a sun and this ring, the text also names the usual
  // number of teeth of the ring. Without profile shifts, this number is z_r = z_s + 2 z_p.
  for (const std::size_t k : same) {
    const auto planet = planet_of(graph, k);
    if (k == m || !planet || graph.gears[teeth->gear].teeth > 0) continue;
    const DriveGear& rider = graph.gear(graph.meshes[k], *planet);
    const DriveGear& sun = graph.gear(graph.meshes[k], 1 - *planet);
    const bool same_rider = &rider == &graph.gear(graph.meshes[m], *planet_of(graph, m));
    if (same_rider && sun.teeth > 0)
      text = fmt::format("{} must be close to {} + 2 {} = {}; {}", name, sun.name, rider.name,
                         sun.teeth + 2 * rider.teeth, text);
  }
  return text;
}

}  // namespace

void add_remedy(const DriveGraph& graph, DriveGeometry& made) {
  std::size_t m = 0;
  while (m < graph.meshes.size() && (!meshes_teeth(graph, graph.meshes[m]) || made.touches(m))) ++m;
  if (m == graph.meshes.size()) return;
  const std::string changes = changes_for(graph, m);
  if (changes.empty()) return;
  if (made.faults.empty())
    made.faults.push_back(
        {GeometryFault::Kind::no_pair,
         fmt::format("The teeth of the mesh {} do not touch at a centre distance of {:.4f} mm.",
                     graph.meshes[m].name, *made.distance[m])});
  made.faults.front().message += " " + changes;
}

namespace {

DriveGeometry with_backlash_of(DriveGraph given, std::size_t m, double backlash) {
  given.meshes[m].backlash = backlash;
  return drive_geometry(with_backlash(given));
}

// Returns, for example, "At most 3.371 mm is possible." The bisection begins at the backlash of the
// mesh with unchanged teeth. The text is empty if the other meshes make even this backlash
// impossible.
std::string possible_backlash(const DriveGraph& given, std::size_t m, double natural) {
  const auto possible = [&](double backlash) {
    return with_backlash_of(given, m, backlash).touches(m);
  };
  if (!possible(natural)) return {};
  double good = natural, bad = *given.meshes[m].backlash;
  const bool greatest = bad > natural;
  for (int i = 0; i < 20; ++i) (possible((good + bad) / 2) ? good : bad) = (good + bad) / 2;
  return fmt::format(" At {} {:.3f} mm is possible.", greatest ? "most" : "least",
                     greatest ? rounded_down(good, 3) : rounded_up(good, 3));
}

}  // namespace

bool blame_backlash(const DriveGraph& given, const DriveGraph& thinned, DriveGeometry& made) {
  struct Blame {
    std::size_t mesh;
    std::string limit;
  };
  std::vector<Blame> blamed;
  std::optional<DriveGeometry> uncut;  // with the given thickness allowances
  for (std::size_t m = 0; m < given.meshes.size(); ++m) {
    if (!given.meshes[m].backlash || made.touches(m)) continue;
    if (!uncut) uncut = drive_geometry(given);
    const auto natural = uncut->stated_backlash(m);
    if (natural && uncut->touches(m))
      blamed.push_back({m, possible_backlash(given, m, natural->normal)});
  }
  // If another backlash is possible for a mesh, this mesh is the reason. If there is no such mesh,
  // all meshes in `blamed` are the reason.
  const auto has_limit = [](const Blame& blame) { return !blame.limit.empty(); };
  if (std::any_of(blamed.begin(), blamed.end(), has_limit))
    std::erase_if(blamed, [&](const Blame& blame) { return !has_limit(blame); });
  // If a fault occurs only with the thinned teeth, the thinning causes it. Such a fault is removed,
  // because the fault of the mesh already explains it.
  if (!blamed.empty())
    std::erase_if(made.faults,
                  [&](const GeometryFault& fault) { return !is_in(fault, uncut->faults); });
  for (const auto& [m, limit] : blamed) {
    const DriveMesh& mesh = thinned.meshes[m];
    const DriveGear &a = thinned.gear(mesh, 0), &b = thinned.gear(mesh, 1);
    made.faults.push_back(
        {GeometryFault::Kind::no_pair,
         fmt::format("The mesh {} cannot have a {}backlash of {:g} mm. This backlash would need "
                     "thickness allowances of {} mm for {} and {} mm for {}, with which the teeth "
                     "do not mesh.{}",
                     mesh.name, mesh.backlash_is_mean ? "mean " : "", *mesh.backlash,
                     format_number(a.thickness_allowance()), a.name,
                     format_number(b.thickness_allowance()), b.name, limit)});
  }
  return !blamed.empty();
}

}  // namespace gearwright
