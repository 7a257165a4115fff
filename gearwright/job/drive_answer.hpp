// Makes the answers of the verb `drive`, of the rating of drives and of the search for drives. Also
// makes the specs of found drives and of single meshes. Internal to job/ and the programs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Returns tables for users. They show the whole drive, the results under load, the bodies, the
/// meshes, the forces, the profile shifts, and the planets of each set with their phases.
std::string drive_listing(const Drive& drive, UnitSystem units);

/// Returns the answer of the verb `drive`. If the spec has [load], the answer includes the drive
/// under load.
///
/// Errors    the errors of solve_drive() and load_drive()
Result<Answer> answer_drive(const JobSpec& spec, Progress* progress = nullptr);

/// Returns the answer of the verb `rate` for a drive. Each mesh is rated according to ISO 6336.
///
/// Errors    the errors of solve_drive() and load_drive(); `rating.…` for the errors of
///           rate_meshes() and material_of()
Result<Answer> answer_drive_rating(const JobSpec& spec, Progress* progress = nullptr);

inline constexpr std::size_t kDefaultDrives = kRankedDrives;

bool searches_drives(const JobSpec& spec);

/// Returns the numbers of teeth of a candidate, for example "sun 19, planet 17, ring 56". If the
/// stages of a train have different modules, the text also gives the modules: "19:58 (m 1.5), 20:66
/// (m 2.5)".
std::string teeth_text(const DriveCandidate& c);

/// Makes a spec for the verb `drive` from a candidate of the search. The spec contains the
/// candidate's numbers, the keys of [search] that apply to all candidates, and the other tables of
/// `spec`. If [search] has no torque, the drive has the torque and the speed of [rating].
///
/// Law       the drive of this spec equals drive_of() for the candidate
Json drive_spec(const JobSpec& spec, const DriveSearchProblem& problem, const DriveCandidate& c);

/// Returns the best drives of the search, each computed by the verb `drive`. Answer::specs contains
/// the spec of each drive.
///
/// Domain    a spec with a search for drives (contract)
/// Errors    the errors of search_drives(), with the keys of the spec; `search.stages` if there are
///           too many trains; `search.normal_module_mm` if drives are rated without a module;
///           `….density_kg_per_m3` if the mass of a plastic gear is required; the errors of
///           drive_designs()
Result<Answer> answer_drive_search(const JobSpec& spec, std::size_t top = kDefaultDrives,
                                   int threads = 0, Progress* progress = nullptr);

// Makes a separate spec of a mesh of a drive. Every verb for pairs can then be used with the mesh.

struct MeshSpec {
  Json tables;
  std::vector<std::string> notes;  ///< sentences about the origin of the spec, faults of the drive,
                                   ///< and omitted tables
};

/// Returns the spec of a mesh. It contains the two gears at their centre distance, with the shifts
/// and tip diameters that they have in the drive. If the mesh carries load, the spec also contains
/// the torque, the speed relative to the carrier, the driving gear and the rating, as far as they
/// are known. The tables for errors, contact, drawing and scatter are copied from the drive, except
/// scatter for double-helical gears. If one gear is a rack, the rack is gear 2, and the spec
/// contains no load. If gear 1 turns counter-clockwise in the drive, errors and modifications are
/// those seen from the other face, because gear 1 of a pair turns clockwise.
///
/// Laws      the pair of this spec has the same numbers as the mesh in the drive
/// Domain    expanded = expanded_spec() of the drive (contract)
MeshSpec mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh);

/// Reads the tables of mesh_spec() without [rating], [scatter] and [drawing]. The contact and the
/// load do not depend on these tables.
///
/// Errors    the errors of read_spec_tree()
Result<JobSpec> job_of_mesh(const Drive& drive, std::size_t mesh, Json tables);

/// Returns the error with the name of the mesh in its rule.
Error of_mesh(const Drive& drive, std::size_t mesh, Error error);

}  // namespace gearwright
