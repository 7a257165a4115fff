// Computes the drive of a spec, with its rating, its verdict and its files. Internal to job/, the
// programs and tests.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/drive/drive_error.hpp"
#include "gearwright/drive/drive_layout.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct DriveJob {
  JobSpec spec;
  Drive drive;
  std::optional<DrivePlaces> places;  ///< none if an axis cannot be placed
  std::optional<DriveLayout> layout;  ///< none if drive_layout() fails
  std::string why_no_layout;          ///< the reason as a sentence; empty if there is a layout
  Error layout_error;                 ///< the reason as an error with a key of the spec
  Verdict verdict;
};

/// Computes the drive of a spec, including the transmission error of every mesh under [errors].
///
/// Errors    a spec without a drive; the errors of make_drive() and halves_of(), with the keys of
///           the spec; errors of a rack that check_rack_errors() rejects
Result<DriveJob> solve_drive(const JobSpec& spec);

/// Returns the [errors] of a spec for each mesh. `spec` and `drive` must outlive the result.
MeshErrors mesh_errors(const JobSpec& spec, const Drive& drive);

/// Returns an error of `field` if `torque`, in N m, differs from the torque on the input of the
/// drive. None if the drive has no torque.
std::optional<Error> other_torque(const char* field, double torque, const Drive& drive);

/// Returns an error if the torque or the speed of [rating] contradicts that of the drive.
std::optional<Error> contradictory_load(const JobSpec& spec, const Drive& drive);

/// Returns the load for a rating. The load is given in [rating] or results from the drive.
///
/// Errors    `rating.…` for a load that is missing, 0 or contradictory, and for a mesh load factor
///           K_γ that cannot be computed or that names no mesh of several planets
Result<DriveLoad> rating_load(const JobSpec& spec, const Drive& drive);

/// Returns a function that rates each mesh of a drive, under the load of [rating] or the torque of
/// the drive. The materials of the spec are read only once. `spec` must outlive the function.
///
/// Errors    `rating.…` for a missing load; the errors of material_of() and rate_meshes()
std::function<std::optional<Error>(Drive&)> drive_rater(const JobSpec& spec);

/// Errors    `load.…` for keys that do not apply to a drive, and for a torque that is missing or
///           contradictory; the errors of solve() and load_task() for the pair of a mesh, with the
///           name of the mesh in the rule; the errors of check_load() and loaded_drive()
std::optional<Error> load_drive(DriveJob& job, Progress* progress);

/// Analyses the contact of each mesh in the same way as the verb `contact` analyses the pair that
/// --take prints.
///
/// Law       Drive::analyses contains, bit for bit, the contact of the spec of mesh_spec()
/// Errors    the errors of solve_mesh() and answer_contact(), with the name of the mesh in the rule,
///           unless the cause is that no teeth touch
std::optional<Error> analyse_drive_contact(DriveJob& job, Progress* progress);

/// Determines whether an optional result is computed. With `if_given`, the rating is computed if
/// the spec has [rating], and the contact if the spec has [errors] or [contact].
enum class Wanted { no, if_given, yes };
struct DriveParts {
  Wanted rating = Wanted::if_given, contact = Wanted::if_given;
};

/// Computes the drive of a spec, the optional results that `parts` selects, and the verdict on all
/// results. If the spec has [load], the drive under load is also computed.
///
/// Errors    the errors of solve_drive(), drive_rater(), load_drive() and analyse_drive_contact()
Result<DriveJob> solve_whole_drive(const JobSpec& spec, const DriveParts& parts = {},
                                   Progress* progress = nullptr);

/// Returns the required safety factors of [rating]. If they are absent, they are 1.
Safeties wanted_safety(const JobSpec& spec);

/// Returns the verdict on the drive, including the safety factors if the drive is rated.
Verdict judge(const DriveJob& job);

/// Errors    a drive without a layout, with the reason; the errors of drive_solids()
Result<std::vector<ToothedBody>> drive_bodies(const DriveJob& job);

/// Returns the first solid that has this name or contains a gear with this name, on the plane z = 0
/// for printing.
///
/// Errors    as drive_bodies(); the option `gear` if there is no such gear
Result<std::vector<ToothedBody>> drive_part(const DriveJob& job, const std::string& name);

/// Makes one file of these solids with make_file(). In a 3MF file, the bodies are laid out for
/// printing.
///
/// Errors    `drive` if an outline is requested and the gears lie in several planes; the errors of
///           make_file()
Result<JobFile> make_drive_file(FileKind kind, const DriveJob& job,
                                const std::vector<ToothedBody>& bodies,
                                const std::filesystem::path& path, const FileOptions& options);

/// Makes the files of `run` for a drive in memory. They are result.json, report.html, drive.step,
/// drive.glb and drive.3mf, which is laid out for printing. If all gears lie in one plane, the
/// function also makes the outlines drive.dxf and drive.svg. If FileOptions::only is not empty,
/// only these parts are made, which may include drive.stl.
Result<RunFiles> make_drive_files(const DriveJob& job, const std::filesystem::path& folder,
                                  const FileOptions& options);

/// Writes the files of make_drive_files(), in the same way as write_everything().
Result<RunFiles> write_drive_files(const DriveJob& job, const std::filesystem::path& folder,
                                   const FileOptions& options);

}  // namespace gearwright
