#include "gearwright/design/drive_search.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/design/drive_space.hpp"
#include "gearwright/drive/drive_motion.hpp"
#include "gearwright/drive/power_flow.hpp"

namespace gearwright {

namespace {

using M = SetMember;
constexpr std::size_t kCarrier = kSetMembers;  // index of the carrier, after the indices of the
                                               // members
constexpr std::size_t at(M m) { return static_cast<std::size_t>(m); }

// The speed of a body divided by the speed of the planet, as a fraction p/q. Both speeds are
// relative to the carrier.
struct Share {
  long long p, q;
};

Share share_of(const TeethOfSet& z, std::size_t body) {
  const int second = z[at(M::planet2)] > 0 ? z[at(M::planet2)] : z[at(M::planet)];
  switch (body) {
    case at(M::sun): return {-z[at(M::planet)], z[body]};
    case at(M::ring): return {z[at(M::planet)], z[body]};
    case at(M::sun2): return {-second, z[body]};
    case at(M::ring2): return {second, z[body]};
    case at(M::planet): return {1, 1};
    default: return {0, 1};  // the carrier
  }
}

struct Ends {
  std::size_t fixed, input, output;
};

// Returns i = (α_in − α_fixed)/(α_out − α_fixed), where α is the speed relative to the carrier.
// Numerator and denominator are whole numbers. They are computed from products of three numbers of
// teeth, which are exact in double. The result is 0 if there is no finite ratio.
double ratio_of(const TeethOfSet& z, const Ends& ends) {
  const Share f = share_of(z, ends.fixed), i = share_of(z, ends.input),
              o = share_of(z, ends.output);
  const long long in = (i.p * f.q - f.p * i.q) * o.q;
  const long long out = (o.p * f.q - f.p * o.q) * i.q;
  return in == 0 || out == 0 ? 0.0 : static_cast<double>(in) / static_cast<double>(out);
}

struct CentralTeeth {
  long long rider, central;  // numbers of teeth; `central` is < 0 for a ring
};

// Returns the gear of the planet that meshes with a central gear.
M rider_of(const TeethOfSet& z, M central) {
  const bool second = central == M::sun2 || central == M::ring2;
  return second && z[at(M::planet2)] > 0 ? M::planet2 : M::planet;
}

// Lists the meshes of the planets with the central gears of a set, in the order of its graph.
struct SetMeshes {
  std::array<CentralTeeth, 4> list{};
  std::array<M, 4> members{};  // the central gears
  std::size_t count = 0;

  bool are_coprime() const {
    return std::all_of(list.begin(), list.begin() + count, [](const CentralTeeth& mesh) {
      return std::gcd(mesh.rider, mesh.central) == 1;
    });
  }

  explicit SetMeshes(const TeethOfSet& z) {
    for (const M central : {M::sun, M::sun2, M::ring, M::ring2}) {
      const int teeth = z[at(central)];
      if (teeth == 0) continue;
      members[count] = central;
      list[count++] = {z[at(rider_of(z, central))], signed_teeth(central, teeth)};
    }
  }
};

// Returns N*, the gcd of (a_i b_j − a_j b_i)/gcd(a) over all pairs i, j of meshes. In mesh i, a_i
// is the number of teeth of the planet gear, and b_i that of the central gear. The relations
// between two meshes generate all integer relations, because the a_i/gcd(a) have no common divisor.
// [T13.12]
long long places_of(const SetMeshes& meshes) {
  long long common = 0, places = 0;
  for (std::size_t i = 0; i < meshes.count; ++i) common = std::gcd(common, meshes.list[i].rider);
  for (std::size_t i = 0; i < meshes.count; ++i)
    for (std::size_t j = i + 1; j < meshes.count; ++j)
      places = std::gcd(places, (meshes.list[i].rider * meshes.list[j].central -
                                 meshes.list[j].rider * meshes.list[i].central) /
                                    common);
  return places;
}

class SetSearch {
 public:
  SetSearch(const DriveSearchProblem& problem, const Ends& ends)
      : problem_(problem), ends_(ends), space_(problem) {
    const double cosine = std::cos(Angle::degrees(helix()).rad());
    transverse_ = 1.0 / cosine;
  }

  const DriveSpace& space() const { return space_; }

  void visit(int planet, DriveSearchResult& result) const {
    space_.visit(planet, [&](const TeethOfSet& z) { consider(z, result); });
  }

 private:
  double helix() const {
    const PerMember& helix = problem_.base.helix_deg;
    return helix.each[0].value_or(helix.all.value_or(0.0));
  }

  void consider(const TeethOfSet& z, DriveSearchResult& result) const {
    const SetMeshes meshes(z);
    if (problem_.coprime && !meshes.are_coprime()) return;
    const int kinds = problem_.planets[1] - problem_.planets[0] + 1;
    result.tested += kinds;
    const auto reject = [&](DriveLimit limit, int n) {
      result.rejected[static_cast<std::size_t>(limit)] += n;
    };
    const double ratio = ratio_of(z, ends_);
    if (ratio == 0.0 || !(ratio >= problem_.ratio[0] && ratio <= problem_.ratio[1]))
      return reject(DriveLimit::ratio, kinds);
    const long long places = places_of(meshes);
    for (int n = problem_.planets[0]; n <= problem_.planets[1]; ++n) {
      const auto step = spacing(n, places);
      if (!step) {
        reject(DriveLimit::assembly, 1);
        continue;
      }
      const double clearance = n == 1 ? kInfinity : clearance_of(z, meshes, *step);
      if (clearance < problem_.neighbour_clearance) {
        reject(DriveLimit::neighbours, 1);
        continue;
      }
      if (!phased(meshes, n, places)) {
        reject(DriveLimit::phasing, 1);
        continue;
      }
      result.found.push_back(
          {z, {}, n, 1.0, ratio, places, clearance, size_of(z, meshes), 0.0, 0.0});
    }
  }

  // Returns the smallest angle between neighbouring planets, in turns. The result is absent if the
  // planets cannot be assembled.
  std::optional<double> spacing(int n, long long places) const {
    const bool divides = places % n == 0;  // places = 0 means that every position is possible
    if (divides && (problem_.base.spacing != Spacing::opposite || n % 2 == 0)) return 1.0 / n;
    switch (problem_.base.spacing) {
      case Spacing::equal: return std::nullopt;
      case Spacing::opposite:
        if (n % 2 != 0 || places % 2 != 0) return std::nullopt;
        break;
      case Spacing::equal_clocked:
        return problem_.kind == DriveKind::wolfrom || problem_.kind == DriveKind::planetary
                   ? std::nullopt
                   : std::optional(1.0 / n);
      case Spacing::nearest: break;
    }
    if (places < n) return std::nullopt;
    return static_cast<double>(places / n) / static_cast<double>(places);
  }

  // Returns the clearance between the planet gears at the centre distance of the first mesh. If the
  // second planet gear has another centre distance without shifts, its profile shifts must correct
  // this distance. These shifts are computed only when the drive is made, so the second gear is not
  // checked here.
  double clearance_of(const TeethOfSet& z, const SetMeshes& meshes, double step) const {
    const double a = distance(meshes.list[0]);
    double tip = z[at(M::planet)] * transverse_ + 2.0;
    for (std::size_t m = 0; m < meshes.count; ++m)
      if (distance(meshes.list[m]) == a)
        tip = std::max(tip, static_cast<double>(meshes.list[m].rider) * transverse_ + 2.0);
    return 2 * a * std::sin(std::numbers::pi * step) - tip;
  }

  double distance(const CentralTeeth& mesh) const {  // modules
    return static_cast<double>(std::abs(mesh.rider + mesh.central)) * transverse_ / 2;
  }

  double size_of(const TeethOfSet& z, const SetMeshes& meshes) const {  // modules
    constexpr double kRootDepth = 1.25;  // dedendum of the basic rack, modules
    const int rings = std::max(z[at(M::ring)], z[at(M::ring2)]);
    const int planets = std::max(z[at(M::planet)], z[at(M::planet2)]);
    const double outer = 2 * distance(meshes.list[0]) + planets * transverse_ + 2.0;
    const double ring = rings > 0 ? rings * transverse_ + 2 * kRootDepth : 0.0;
    const int suns = std::max(z[at(M::sun)], z[at(M::sun2)]);
    return std::max({outer, ring, suns > 0 ? suns * transverse_ + 2.0 : 0.0});
  }

  bool phased(const SetMeshes& meshes, int n, long long places) const {
    if (problem_.phasing.empty()) return true;
    std::vector<Rational> turns;
    const bool equal = places % n == 0 || problem_.base.spacing == Spacing::equal_clocked;
    for (long long i = 0; i < n; ++i)
      turns.push_back(equal ? Rational::of(i, n)
                            : Rational::of((2 * i * places + n) / (2 * n), places));
    const auto phases = mesh_phases(static_cast<int>(meshes.list[0].central), turns);
    const PhasingClass kind = phasing(phases, turns, 1).kind;
    return is_in(kind, problem_.phasing);
  }

  const DriveSearchProblem& problem_;
  Ends ends_;
  DriveSpace space_;
  double transverse_ = 1.0;
};

// Returns the fixed, input and output members. If the problem does not give a member, the default
// of the set is used.
Result<Ends> ends_of(const DriveSearchProblem& problem) {
  DriveCandidate any;
  for (const M m : members_of(problem))
    any.teeth[at(m)] = is_ring(m) ? 60 + static_cast<int>(at(m)) : 20;
  const auto graph = graph_of(set_of(problem, any));
  if (!graph) return graph.error();
  const auto body = [&](std::size_t b) {
    for (std::size_t m = 0; m < kSetMembers; ++m)
      if (graph->bodies[b].name == to_string(static_cast<M>(m))) return m;
    return kCarrier;
  };
  const auto single = [&](const std::vector<std::size_t>& list, const char* field) {
    return list.size() == 1 ? std::optional<Error>()
                            : Error{field, std::to_string(list.size()),
                                    "must be a single body, because a search finds drives with one "
                                    "degree of freedom only"};
  };
  if (auto error = single(graph->fixed, "drive.fixed")) return *error;
  if (auto error = single(graph->inputs, "drive.input")) return *error;
  if (auto error = ends_error(*graph)) {
    std::vector<std::string> defaults;
    const auto add_default = [&](bool given, const char* key, std::size_t b) {
      if (!given) defaults.push_back(fmt::format("`{}` = \"{}\"", key, graph->bodies[b].name));
    };
    add_default(problem.base.fixed.has_value(), "fixed", graph->fixed[0]);
    add_default(!problem.base.inputs.empty(), "input", graph->inputs[0]);
    add_default(!problem.base.output.empty(), "output", graph->output);
    if (!defaults.empty())
      error->rule += fmt::format(". The defaults are {}", enumerated(defaults));
    return *error;
  }
  return Ends{body(graph->fixed[0]), body(graph->inputs[0]), body(graph->output)};
}

void find_efficiency(const DriveSearchProblem& problem, DriveCandidate& candidate) {
  PlanetarySpec set = set_of(problem, candidate);
  set.normal_module.reset();  // without a module, only speeds and powers are computed
  const auto graph = graph_of(set);
  if (!graph) return;
  const auto motion = drive_motion(*graph);
  if (!motion || !motion->redundant.empty()) return;
  std::vector<double> speeds;
  std::vector<MeshEfficiency> losses;
  for (std::size_t b = 0; b < graph->bodies.size(); ++b)
    speeds.push_back(motion->speeds[b][0].value());
  for (const DriveMesh& mesh : graph->meshes) {
    const double eta = mesh.efficiency.value_or(estimated_efficiency(
        graph->gear(mesh, 0).teeth, graph->gear(mesh, 1).teeth, problem.base.friction));
    losses.push_back({eta, eta});
  }
  if (const auto flow = power_flow(*graph, speeds, losses)) candidate.efficiency = flow->efficiency;
  if (!problem.asks(DriveObjective::efficiency_backward)) return;
  DriveGraph turned = *graph;
  std::swap(turned.inputs.front(), turned.output);
  const double out = speeds[graph->output];
  for (double& w : speeds) w /= out;
  if (const auto flow = power_flow(turned, speeds, losses))
    candidate.efficiency_backward = flow->efficiency;
}

void search_sets(const DriveSearchProblem& problem, const Ends& ends, int threads,
                 DriveSearchResult& result) {
  const SetSearch search(problem, ends);
  const TeethBand band = search.space().first_band();
  std::vector<DriveSearchResult> parts(static_cast<std::size_t>(band[1] - band[0] + 1));
  parallel_for(
      parts.size(), [&](std::size_t k) { search.visit(band[0] + static_cast<int>(k), parts[k]); },
      threads);
  for (DriveSearchResult& part : parts) {
    result.tested += part.tested;
    for (std::size_t i = 0; i < part.rejected.size(); ++i) result.rejected[i] += part.rejected[i];
    result.found.insert(result.found.end(), part.found.begin(), part.found.end());
  }
  if (!problem.asks(DriveObjective::efficiency) &&
      !problem.asks(DriveObjective::efficiency_backward))
    return;
  parallel_for(
      result.found.size(), [&](std::size_t k) { find_efficiency(problem, result.found[k]); },
      threads);
}

// Replaces every candidate by one candidate for each module, and converts the size from modules to
// mm. A candidate whose size exceeds the limit is rejected.
void give_modules(const DriveSearchProblem& problem, DriveSearchResult& result) {
  std::vector<double> modules = problem.modules;
  if (modules.empty()) return;
  if (problem.center_distance) return give_stage_modules(problem, result);
  if (problem.module_per_stage) modules.resize(1);
  const auto count = static_cast<std::int64_t>(modules.size());
  result.tested *= count;
  for (std::int64_t& n : result.rejected) n *= count;
  std::vector<DriveCandidate> each;
  each.reserve(result.found.size() * modules.size());
  for (const DriveCandidate& one : result.found)
    for (const double m : modules) {
      if (one.size * m > problem.size_max) {
        ++result.rejected[static_cast<std::size_t>(DriveLimit::size)];
        continue;
      }
      each.push_back(one);
      each.back().module = m;
      each.back().size *= m;
      if (problem.module_per_stage) each.back().stage_modules.assign(one.stages.size(), m);
      each.back().mass = estimated_mass(problem, each.back());
    }
  result.found = std::move(each);
}

double cosine_of_helix(const DriveSearchProblem& problem) {
  const PerMember& helix = problem.base.helix_deg;
  return std::cos(Angle::degrees(helix.each[0].value_or(helix.all.value_or(0.0))).rad());
}

}  // namespace

bool DriveSearchProblem::asks(DriveObjective objective) const {
  return is_in(objective, objectives);
}

std::vector<SetMember> members_of(const DriveSearchProblem& problem) {
  const auto given = [&](M m) { return problem.teeth[at(m)].has_value(); };
  std::vector<M> list;
  switch (problem.kind) {
    case DriveKind::planetary: return {M::sun, M::planet, M::ring};
    case DriveKind::stepped: return {M::sun, M::planet, M::planet2, M::ring2};
    case DriveKind::two_suns: return {M::sun, M::sun2, M::planet, M::planet2};
    case DriveKind::wolfrom:
      if (given(M::sun)) list.push_back(M::sun);
      list.push_back(M::planet);
      if (given(M::planet2)) list.push_back(M::planet2);
      list.push_back(M::ring);
      list.push_back(M::ring2);
      return list;
    case DriveKind::train: break;
  }
  return list;
}

TeethBand teeth_band(const DriveSearchProblem& problem, SetMember member) {
  if (const auto& own = problem.teeth[at(member)]) return *own;
  return is_ring(member) ? TeethBand{30, 150} : TeethBand{12, 60};
}

void complete_ends(DriveSearchProblem& problem) {
  PlanetarySpec& set = problem.base;
  const bool suns = problem.kind == DriveKind::two_suns;
  if (!suns && problem.kind != DriveKind::wolfrom) return;
  const std::string first = suns ? "sun" : "ring", second = suns ? "sun2" : "ring2";
  const bool sun_drives = !suns && problem.teeth[at(M::sun)].has_value();
  if (!set.fixed) set.fixed = {{set.output == first ? second : first}};
  if (set.inputs.empty()) set.inputs = {sun_drives ? "sun" : "carrier"};
  if (set.output.empty())
    set.output = set.fixed == std::vector<std::string>{second} ? first : second;
}

PlanetarySpec set_of(const DriveSearchProblem& problem, const DriveCandidate& candidate) {
  PlanetarySpec set = problem.base;
  for (std::size_t m = 0; m < kSetMembers; ++m) {
    set.teeth[m].reset();
    if (candidate.teeth[m] > 0) set.teeth[m] = candidate.teeth[m];
  }
  set.planets = candidate.planets;
  if (!problem.modules.empty()) set.normal_module = candidate.module;
  return set;
}

DriveCandidate widest(const DriveSearchProblem& problem, DriveCandidate candidate) {
  if (!problem.face_width) return candidate;
  const auto greatest = [&](double module, long long z1, long long z2) {
    const double diameter =
        module * static_cast<double>(std::min(z1, z2)) / cosine_of_helix(problem);
    return std::min((*problem.face_width)[1], problem.face_diameters * diameter);
  };
  candidate.face_widths.clear();
  for (std::size_t k = 0; k < candidate.stages.size(); ++k)
    candidate.face_widths.push_back(
        greatest(candidate.stage_module(k), candidate.stages[k][0], candidate.stages[k][1]));
  const SetMeshes meshes(candidate.teeth);
  for (std::size_t m = 0; m < meshes.count; ++m)
    candidate.face_widths.push_back(
        greatest(candidate.module, meshes.list[m].rider, std::abs(meshes.list[m].central)));
  return candidate;
}

PerMember member_face_widths(const DriveCandidate& candidate) {
  PerMember widths;
  const SetMeshes meshes(candidate.teeth);
  for (std::size_t m = 0; m < meshes.count && m < candidate.face_widths.size(); ++m) {
    const double width = candidate.face_widths[m];
    widths.each[at(meshes.members[m])] = width;
    auto& rider = widths.each[at(rider_of(candidate.teeth, meshes.members[m]))];
    rider = std::max(rider.value_or(0.0), width);
  }
  // A planet gear that meshes with two suns or with two rings is as wide as both together.
  if (candidate.teeth[at(M::planet2)] == 0)
    for (const auto& [one, two] : {std::pair{M::sun, M::sun2}, std::pair{M::ring, M::ring2}})
      if (const auto& a = widths.each[at(one)], &b = widths.each[at(two)]; a && b)
        widths.each[at(M::planet)] = *a + *b + kBetweenFaces * candidate.module;
  return widths;
}

Result<DriveSearchResult> search_drives(const DriveSearchProblem& problem, int threads) {
  GW_EXPECTS(!problem.center_distance ||
             (problem.kind == DriveKind::train && !problem.module_per_stage));
  DriveSearchResult result;
  if (problem.kind == DriveKind::train) {
    search_trains(problem, result);
    if (!result.is_complete) return result;
  } else {
    for (const M m : members_of(problem))
      GW_EXPECTS(teeth_band(problem, m)[0] >= 1 && teeth_band(problem, m)[1] <= kMostDriveTeeth);
    const auto ends = ends_of(problem);
    if (!ends) return ends.error();
    search_sets(problem, *ends, threads, result);
  }
  if (problem.asks(DriveObjective::noise)) estimate_noise(problem, result.found, threads);
  give_modules(problem, result);
  sort_by_objective<DriveCandidate>(
      problem, result.found, [](const auto& c) -> const auto& { return c; });
  return result;
}

}  // namespace gearwright
