#include "gearwright/drive/drive_phases.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/lists.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright::detail {

namespace {

// Returns the flanks of a gear of a mesh. Seen from the other face, the gear turns in the opposite
// direction, and its right and left flanks are exchanged.
std::optional<BothFlanks> flanks_of(const DriveGear& gear, bool turned_over) {
  const BothFlanks& flanks = gear.modifications;
  if (!turned_over) return flanks;
  BothFlanks turned{flanks[1], flanks[0]};
  for (FlankModifications& flank : turned) {
    if (flank.topography) return std::nullopt;
    flank.lead_slope = -flank.lead_slope;
  }
  return turned;
}

ContactErrors turned_over(ContactErrors errors) {
  errors.intersecting = -1.0 * errors.intersecting;
  errors.axial = -errors.axial;
  return errors;
}

}  // namespace

bool first_drives(const Drive& drive, std::size_t m, double load) {
  if (drive.flow && !drive.flow->self_locking() && drive.flow->driver[m] >= 0)
    return drive.flow->driver[m] == 0;
  const DriveGear& a = drive.graph.gear(drive.graph.meshes[m], 0);
  return -a.factor() * load * turning(drive, a.body, m) > 0.0;
}

std::optional<MeshSense> sense_of(const Drive& drive, std::size_t m) {
  const DriveGraph& graph = drive.graph;
  if (graph.inputs.size() != 1 || drive.motion.freedom != 1 || !drive.motion.redundant.empty())
    return std::nullopt;
  double load = 0.0;
  if (!drive.flow || drive.flow->self_locking() || drive.flow->driver[m] < 0) {
    const auto loads = lossless_loads(graph, drive.motion, graph.inputs.front(), graph.output);
    if (loads[m].zero() || !loads[m].fits()) return std::nullopt;
    load = loads[m].value();
  }
  return MeshSense{first_drives(drive, m, load),
                   turning(drive, graph.gear(graph.meshes[m], 0).body, m) > 0.0};
}

double passing_time(double turning, int teeth, double theta, bool drives, double half) {
  return (turning < 0.0 ? -1.0 : 1.0) * std::abs(teeth) * theta + (drives ? -half : half);
}

void find_delays(const Drive& drive, std::size_t m, MeshPhase& phase) {
  const DriveGraph& graph = drive.graph;
  const PlanetSet* set = set_of(drive, m);
  if (!set) return;
  std::optional<std::size_t> central;
  for (const std::size_t other : set->group.meshes)
    if (!central && (other == m || drive.frequency_ratio(other) == drive.frequency_ratio(m)))
      for (const std::size_t g : graph.meshes[other].gears)
        if (!graph.body(graph.gears[g]).carrier) central = g;
  if (!central) return;
  const DriveGear& gear = graph.gears[*central];
  phase.sense = gear.factor() * turning(drive, gear.body, m) < 0.0 ? -1.0 : 1.0;
  phase.phases = mesh_phases(gear.teeth, set->assembly.turns);
}

namespace {

// Returns the tooth thickness of one gear of a mesh, divided by the pitch.
double share_of(const Drive& drive, std::size_t m, int side) {
  const auto& rack = drive.geometry.racks[m];
  return rack ? thickness_share(*rack) : thickness_share(*drive.geometry.involutes(m), side + 1);
}

std::optional<double> passing(const Drive& drive, std::size_t m, int side, bool first_drives) {
  const DriveMesh& mesh = drive.graph.meshes[m];
  const DriveGear& gear = drive.graph.gear(mesh, side);
  const auto theta = direction(drive, m, mesh.gears[static_cast<std::size_t>(side)]);
  if (!theta || gear.rack) return std::nullopt;
  return passing_time(turning(drive, gear.body, m), gear.teeth, *theta, first_drives == (side == 0),
                      share_of(drive, m, side) / 2);
}

// Computes the delays of all meshes that move the output. If two meshes share a gear, the delay of
// one mesh follows from the delay of the other. Returns false if the place of a planet is unknown,
// or if several meshes share a rack.
bool find_times(const Drive& drive, std::vector<MeshPhase>& phases) {
  const DriveGraph& graph = drive.graph;
  const std::size_t none = phases.size();
  for (MeshPhase& phase : phases) phase.first = none;
  for (std::size_t first = 0; first < phases.size(); ++first) {
    if (phases[first].first != none) continue;
    phases[first].first = first;
    if (phases[first].idle()) continue;
    std::vector<std::size_t> reached{first};
    for (std::size_t at = 0; at < reached.size(); ++at) {
      const std::size_t m = reached[at];
      for (std::size_t n = 0; n < phases.size(); ++n) {
        if (phases[n].first != none || phases[n].idle() ||
            graph.frame(graph.meshes[n]) != graph.frame(graph.meshes[m]))
          continue;
        for (const int i : {0, 1})
          for (const int j : {0, 1}) {
            const DriveGear& one = graph.gear(graph.meshes[m], i);
            const DriveGear& two = graph.gear(graph.meshes[n], j);
            if (one.body != two.body || one.teeth != two.teeth || phases[n].first == first)
              continue;
            const auto here = passing(drive, m, i, phases[m].first_drives);
            const auto there = passing(drive, n, j, phases[n].first_drives);
            if (!here || !there) return false;
            phases[n].time = phases[m].time + *there - *here;
            phases[n].first = first;
            reached.push_back(n);
          }
      }
    }
  }
  return true;
}

}  // namespace

std::optional<std::complex<double>> place_of(const Drive& drive, const PlanetSet& set,
                                             std::size_t body) {
  const auto& riders = set.group.riders;
  const auto at = std::find(riders.begin(), riders.end(), body);
  if (at == riders.end()) return 0.0;
  std::optional<GeometryFault> fault;
  const auto places = rider_places(drive.graph, set.group, drive.geometry.distance, fault);
  if (!places) return std::nullopt;
  const RiderPlace& place = (*places)[static_cast<std::size_t>(at - riders.begin())];
  return std::polar(place.distance, place.angle);
}

std::optional<double> direction(const Drive& drive, std::size_t m, std::size_t gear) {
  const DriveMesh& mesh = drive.graph.meshes[m];
  const DriveGear& a = drive.graph.gear(mesh, 0);
  const DriveGear& b = drive.graph.gear(mesh, 1);
  double theta = mesh.direction.value_or(Angle()).rad();
  if (const PlanetSet* set = set_of(drive, m)) {
    const auto one = place_of(drive, *set, a.body), two = place_of(drive, *set, b.body);
    if (!one || !two) return std::nullopt;
    theta = std::arg(*two - *one);
  }
  const bool towards_b = gear == mesh.gears[0] && (b.teeth > 0 || b.rack);
  return theta / kTurn + (towards_b ? 0.0 : 0.5);
}

double turning(const Drive& drive, std::size_t body, std::size_t mesh) {
  const auto frame = drive.graph.frame(drive.graph.meshes[mesh]);
  const auto& speeds = drive.motion.speeds;
  return (speeds[body][0] - (frame ? speeds[*frame][0] : Rational())).value();
}

const PlanetSet* set_of(const Drive& drive, std::size_t mesh) {
  for (const PlanetSet& set : drive.sets)
    if (is_in(mesh, set.group.meshes)) return &set;
  return nullptr;
}

std::optional<std::vector<MeshPhase>> phases_of(const Drive& drive) {
  const DriveGraph& graph = drive.graph;
  const auto to_output = lossless_loads(graph, drive.motion, graph.output, graph.inputs.front());
  const auto to_input = lossless_loads(graph, drive.motion, graph.inputs.front(), graph.output);
  std::vector<MeshPhase> phases(graph.meshes.size());
  for (std::size_t m = 0; m < phases.size(); ++m) {
    MeshPhase& phase = phases[m];
    const bool teeth = drive.geometry.racks[m] || drive.geometry.involutes(m);
    if (!teeth && to_output[m].zero()) continue;
    if (!teeth || !to_output[m].fits() || !to_input[m].fits()) return std::nullopt;
    const Gear& first = *drive.geometry.gears[graph.meshes[m].gears[0]];
    phase.first_drives = first_drives(drive, m, to_input[m].value());
    phase.turned = turning(drive, graph.gear(graph.meshes[m], 0).body, m) > 0.0;
    phase.weight = std::abs(to_output[m].value()) * kTurn / first.reference().base_pitch_transverse;
    const double share = share_of(drive, m, 0) / 2;
    phase.event = phase.first_drives ? -share : share;
    find_delays(drive, m, phase);
  }
  if (!find_times(drive, phases)) return std::nullopt;
  return phases;
}

std::optional<ContactSetup> mesh_contact(const Drive& drive, std::size_t mesh,
                                         const ContactErrors& errors, bool turned) {
  const DriveMesh& m = drive.graph.meshes[mesh];
  const auto one = flanks_of(drive.graph.gear(m, 0), turned);
  const auto two = flanks_of(drive.graph.gear(m, 1), turned);
  if (!one || !two) return std::nullopt;
  auto setup = ContactSetup::of(*drive.geometry.pairs[mesh], turned ? turned_over(errors) : errors,
                                {*one, *two});
  if (!setup) return std::nullopt;
  return std::move(setup).take();
}

std::shared_ptr<const ContactPair> rack_contact(const Drive& drive, std::size_t mesh,
                                                const ContactErrors& errors,
                                                const MeshPhase& phase) {
  const auto flanks = flanks_of(drive.graph.gear(drive.graph.meshes[mesh], 0), phase.turned);
  if (!flanks) return nullptr;
  ContactOptions options;
  options.modifications[0] = *flanks;
  options.gear2_drives = !phase.first_drives;
  auto pair = contact_pair(*drive.geometry.racks[mesh], phase.turned ? turned_over(errors) : errors,
                           options);
  return pair ? std::move(pair).take() : nullptr;
}

}  // namespace gearwright::detail
