// The files of a job: solids, meshes and drawings of the gears, each written completely or not at
// all.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct ReportFile;  // report/report.hpp

using OnFile = std::function<void(std::string_view what)>;

/// The tolerances that a user may choose, mm. Finer ones make files that no program reads.
struct ToleranceRange {
  double least, greatest;
};
inline constexpr ToleranceRange kMeshTolerances{1e-5, 10.0}, kDrawingTolerances{1e-7, 1.0};

struct FileOptions {
  OnFile on_file;                ///< called before each file; may be empty
  Progress* progress = nullptr;  ///< reports the progress of contact and corrections
  StepSchema step_schema = StepSchema::ap242;
  double mesh_tolerance_mm = 0.005;     ///< of STL, GLB, 3MF
  double drawing_tolerance_mm = 0.001;  ///< of DXF as arcs
  bool drawing_splines = false;         ///< DXF as splines instead of arcs
  std::vector<std::string> only{};      ///< for `run`: words of kRunParts; everything if empty

  bool wants(std::string_view part) const;
};

/// Parts of `run`: kinds of files by their endings, the drawing (PDF, A4), the report, the result.
inline constexpr std::array<std::string_view, 9> kRunParts{
    "result", "report", "drawing", "step", "stl", "glb", "3mf", "dxf", "svg"};

struct JobFile {
  std::filesystem::path path;
  std::string what;                    ///< "STEP, AP242", "DXF, arcs"
  std::optional<double> deviation_mm;  ///< greatest distance to the exact surface or outline
  std::string note;                    ///< "1208 triangles", "123 faces"
  std::string bytes;                   ///< the file
};

enum class FileKind { step, stl, glb, threemf, dxf, svg };

/// The kind of a file's name ending, ".step" and so on.
std::string_view ending(FileKind kind);

/// One gear as a body, in its own frame or in the housing.
///
/// Errors    the gear's reason when it has no outline: an internal gear, a severed tooth, a root
///           through the axis
Result<ToothedBody> make_body(const SolvedJob& job, int which, bool in_place);

/// The two halves of a gear's body. The mating gears are staggered alike, so gear 2 is turned the
/// other way unless it is internal.
///
/// Errors    `double_helical.gap` of staggered halves without a gap
Result<TwoHelices> two_helices_of(const Gear& half, const Halves& halves, int which);

/// CAD errors name a member of a body, which is replaced by that of the gear. A spec has no
/// tolerance or number of faces, so those errors are about the gear.
Error of_body(Error error, const std::string& name);

/// Makes one file with these bodies, in memory, so that all errors occur before anything is
/// written. A file that has no room for modified flanks has the teeth as cut, and its note says why.
///
/// Errors    a bore that does not fit; a file that is too large to be useful
Result<JobFile> make_file(FileKind kind, const std::vector<ToothedBody>& bodies,
                          const std::filesystem::path& path, const FileOptions& options);

/// Rows of a report: contents and accuracy of the files.
std::vector<ReportFile> report_files(const std::vector<JobFile>& files);

/// Writes them, each completely or not at all.   Throws  IoError
void write_files(const std::vector<JobFile>& files);

/// Makes the folder and writes a run into it.   Throws  IoError
void write_run_into(const std::filesystem::path& folder, const std::vector<JobFile>& files,
                    const FileOptions& options);

struct RunFiles {
  std::vector<JobFile> files;
  std::string result;  ///< result.json, whether or not it is written
  Verdict verdict;
};

/// Makes the files of `run` in memory. Nothing is written; the paths are in `folder`.
Result<RunFiles> make_everything(SolvedJob& job, const std::filesystem::path& folder,
                                 const FileOptions& options);

/// Writes the files of `run` into `folder`: result.json, report.html, drawing.pdf, gear1.*,
/// gear2.*, pair.*, as far as they apply, or only the parts in `only`. Gears without an outline get
/// a warning in the job instead of files.
/// Files of an earlier run that this run does not write are removed (run_folder.hpp).
Result<RunFiles> write_everything(SolvedJob& job, const std::filesystem::path& folder,
                                  const FileOptions& options);

}  // namespace gearwright
