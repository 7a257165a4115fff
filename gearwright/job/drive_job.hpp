// A spec of a drive and the drive that it describes, put together; its files.
#pragma once

#include <filesystem>
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
  std::optional<DrivePlaces> places;  ///< none if it has a rack or axes that cannot be placed
  std::optional<DriveLayout> layout;  ///< none if it has no teeth or they cannot mesh
  std::string why_no_layout;          ///< reason as a sentence; empty if there is a layout
  Verdict verdict;
};

/// The drive of a spec, with its transmission error for the spec's [errors] in every mesh.
///
/// Errors    a spec without a drive; as make_drive(), with the keys of the spec
Result<DriveJob> solve_drive(const JobSpec& spec);

/// The [errors] of a spec, as those of each mesh. Both must outlive the function.
MeshErrors mesh_errors(const JobSpec& spec, const Drive& drive);

/// The load of a rating, which [rating] or the drive gives.
///
/// Errors    `rating.…` for a load that is missing, 0 or contradictory
Result<DriveLoad> rating_load(const JobSpec& spec, const Drive& drive);

/// Rates each mesh under the load of [rating], or under the drive's own torque.
///
/// Errors    `rating.…` for a load that is missing and as material_of(); as rate_meshes()
std::optional<Error> rate_drive(const JobSpec& spec, Drive& drive);

/// The drive of a spec with its meshes rated and the verdict over both.
///
/// Errors    as solve_drive() and rate_drive()
Result<DriveJob> solve_rated_drive(const JobSpec& spec);

/// Computes the drive under its [load].
///
/// Errors    `load.…` for keys that do not apply to a drive, and for a torque that is missing or
///           contradictory; as mesh_spec() for a pair under load, with the mesh in the rule; as
///           loaded_drive()
std::optional<Error> load_drive(DriveJob& job, Progress* progress = nullptr);

/// The same drive under load if its spec has [load], with the verdict; an error is passed on.
Result<DriveJob> with_load(Result<DriveJob> solved, Progress* progress = nullptr);

/// The drive of a spec with all that it contains: its meshes rated if it has [rating], under load
/// if it has [load], and the verdict.
///
/// Errors    as solve_drive(), rate_drive() and load_drive()
Result<DriveJob> solve_whole_drive(const JobSpec& spec, Progress* progress = nullptr);

/// The required safeties of [rating]; 1 if they are absent.
WantedSafety wanted_safety(const JobSpec& spec);

/// The verdict over the drive, including safeties if it is rated.
Verdict judge(const DriveJob& job);

/// Every copy of every gear in its place, in one file's frame; copies refer to the first body with
/// their shape, and gears of one body have the same colour.
///
/// Errors    a drive that has no layout; a gear without an outline
Result<std::vector<ToothedBody>> drive_bodies(const DriveJob& job);

/// The same bodies side by side on the plane z = 0, for printing.
std::vector<ToothedBody> laid_out(std::vector<ToothedBody> bodies);

/// Files of `run` for a drive, in memory: result.json, report.html, drive.step, drive.glb,
/// drive.3mf (laid out), and the outlines of a drive with one section, drive.dxf and drive.svg.
Result<RunFiles> make_drive_files(const DriveJob& job, const std::filesystem::path& folder,
                                  const FileOptions& options);

/// Writes them as write_everything() does.
Result<RunFiles> write_drive_files(const DriveJob& job, const std::filesystem::path& folder,
                                   const FileOptions& options);

/// One file of the whole drive, as make_file(). In a 3MF file the bodies are laid out for printing.
Result<JobFile> make_drive_file(FileKind kind, const DriveJob& job,
                                const std::filesystem::path& path, const FileOptions& options);

}  // namespace gearwright
