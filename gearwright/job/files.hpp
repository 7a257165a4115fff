// Makes the files of a job, which are solids, meshes and drawings of the gears. Each file is
// written completely or not at all. Internal to job/, the programs and tests.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct ReportFile;  // report/report.hpp

using OnFile = std::function<void(std::string_view what)>;

/// The tolerances that a user may choose, mm. With a finer tolerance, a file would be too large for
/// any program to read.
struct ToleranceRange {
  double least, greatest;
};
inline constexpr ToleranceRange kMeshTolerances{1e-5, 10.0}, kDrawingTolerances{1e-7, 1.0};

struct FileOptions {
  OnFile on_file;                ///< called before each file; may be empty
  Progress* progress = nullptr;  ///< receives the progress of the computations; may be null
  StepSchema step_schema = StepSchema::ap242;
  double mesh_tolerance_mm = 0.005;     ///< tolerance for STL, GLB and 3MF
  double drawing_tolerance_mm = 0.001;  ///< tolerance for DXF with arcs and workshop drawings
  bool drawing_splines = false;         ///< DXF as splines instead of arcs
  std::optional<SheetSize> sheet{};     ///< size of the workshop drawing; if absent, the scale
                                        ///< determines it
  std::vector<std::string> only{};      ///< for `run`, the parts to write (kRunParts); if empty,
                                        ///< all

  bool wants(std::string_view part) const;
};

/// The parts of `run`: the result, the report, the drawing (PDF), and other kinds of files,
/// which are named by their extension.
inline constexpr std::array<std::string_view, 9> kRunParts{
    "result", "report", "drawing", "step", "stl", "glb", "3mf", "dxf", "svg"};

struct JobFile {
  std::filesystem::path path;
  std::string what;                    ///< "STEP, AP242", "DXF, arcs"
  std::optional<double> deviation_mm;  ///< greatest distance to the exact surface or outline
  std::string note;                    ///< "1208 triangles", "123 faces"
  std::string bytes;                   ///< the file

  /// Returns the deviation as it is printed, µm. The result is at least 0.001 µm, because a smaller
  /// deviation is only a rounding error.
  double printed_deviation_um() const { return std::max(0.001, *deviation_mm * kUmPerMm); }
};

enum class FileKind { step, stl, glb, threemf, dxf, svg };

/// Returns the extension of file names of this kind, for example ".step".
std::string_view ending(FileKind kind);

/// Returns the pose of a gear or of the rack in the housing. If the gears are not mounted, the pose
/// is the identity.
SolidPose pose_of(const SolvedJob& job, int which);

/// Returns one gear, or the rack, as a body in its own frame.
///
/// Errors    the reason why the gear has no outline, for example a severed tooth; `gearN.cut_by`
///           for an internal gear without a cutter; the errors of body_as_made(). A rack has no
///           errors
Result<ToothedBody> make_body(const SolvedJob& job, int which);

/// Converts an error of cad/ about a body to an error about the gear. If the error is about teeth,
/// bore or keyway, its member is kept. Any other error concerns a value that is not in the spec,
/// for example a tolerance or a number of faces. The new error then names the whole gear.
Error of_body(Error error, const std::string& name);

/// Makes one file with these bodies, in memory. All errors therefore occur before anything is
/// written. If the file cannot be made with the modified flanks, it contains the teeth as cut, and
/// its note gives the reason.
///
/// Domain    at least one body (contract)
/// Errors    a bore that does not fit; a file that is too large to be useful; `pair.shaft_angle`
///           for the outlines of gears on crossed axes
Result<JobFile> make_file(FileKind kind, const std::vector<ToothedBody>& bodies,
                          const std::filesystem::path& path, const FileOptions& options);

std::vector<ReportFile> report_files(const std::vector<JobFile>& files);

/// Makes result.json of a record, in these units.
JobFile result_file(const std::filesystem::path& folder, UnitSystem units, const Json& result);

/// Writes the files, each completely or not at all.
///
/// Throws    IoError
void write_files(const std::vector<JobFile>& files);

/// Makes the folder and writes the files of a run into it. Files of an earlier run are removed if
/// they are unchanged and if this run does not write them. All other files are kept.
///
/// Throws    IoError
void write_run_into(const std::filesystem::path& folder, const std::vector<JobFile>& files,
                    const FileOptions& options);

struct RunFiles {
  std::vector<JobFile> files;
  Json result;  ///< the record in result.json, even if it is not written
  Verdict verdict;
};

/// Makes the files of `run` in memory. Nothing is written yet, but the paths of the files are
/// already those in `folder`.
Result<RunFiles> make_everything(SolvedJob& job, const std::filesystem::path& folder,
                                 const FileOptions& options);

/// Writes the files of the job into `folder`. These are result.json, report.html, drawing.pdf,
/// gear1.*, gear2.* and pair.*, if the job has them. If FileOptions::only is not empty, only these
/// parts are written. A gear without an outline has no files, and the job gets a warning.
Result<RunFiles> write_everything(SolvedJob& job, const std::filesystem::path& folder,
                                  const FileOptions& options);

}  // namespace gearwright
