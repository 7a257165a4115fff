// Computes the contact of every mesh of a drive under errors of mounting, on the working flanks and
// on the non-working flanks.
#include "gearwright/contact/halves.hpp"
#include "gearwright/drive/drive_error.hpp"
#include "gearwright/drive/drive_phases.hpp"

namespace gearwright {

namespace {

// Returns the contact of a mesh on the flanks that work if gear 2 drives (`gear2_drives` is true)
// or if gear 1 drives. If the pair is not double-helical, only `whole` is set. Returns none if the
// flanks cannot be computed.
std::optional<HalvesContact> contact_of(const Drive& drive, std::size_t m,
                                        const ContactErrors& errors, const detail::MeshPhase& phase,
                                        bool gear2_drives) {
  const ContactRequest request{.positions = kErrorPositions};
  if (drive.geometry.racks[m]) {
    detail::MeshPhase driven = phase;
    driven.first_drives = !gear2_drives;
    const auto pair = detail::rack_contact(drive, m, errors, driven);
    if (!pair) return std::nullopt;
    return HalvesContact{.whole = analyse_contact(*pair, request)};
  }
  const auto setup = detail::mesh_contact(drive, m, errors, phase.turned);
  if (!setup) return std::nullopt;
  if (!setup->gear(1).gap)
    return HalvesContact{.whole = analyse_contact(setup->pair(gear2_drives), request)};
  const HalvesSetup halves(*setup, 0.0, phase.turned ? -1.0 : 1.0);
  const HalvesPair pair = halves.pair(setup->place().errors, gear2_drives);
  return analyse_contact(pair.mesh, request);
}

}  // namespace

std::vector<std::optional<MeshContact>> mesh_contacts(const Drive& drive,
                                                      const MeshErrors& errors) {
  std::vector<std::optional<MeshContact>> all(drive.graph.meshes.size());
  if (drive.motion.freedom != 1 || !drive.motion.redundant.empty()) return all;
  const auto phases = detail::phases_of(drive);
  for (std::size_t m = 0; phases && m < all.size(); ++m) {
    if (!transverse_base_backlash(drive.geometry, m)) continue;
    const bool gear2_drives = !(*phases)[m].first_drives;
    auto driving = contact_of(drive, m, errors(m), (*phases)[m], gear2_drives);
    auto other = contact_of(drive, m, errors(m), (*phases)[m], !gear2_drives);
    if (!driving || !other) continue;
    const auto play = least_play(driving->whole, other->whole, gear2_drives);
    all[m] = MeshContact{driving->whole, other->whole, play, driving->on_halves()};
  }
  return all;
}

}  // namespace gearwright
