// Writes toothed bodies as exact solids into a STEP file (ISO 10303-242), for CAD systems.
//
// One named, coloured solid is written per body. Tip land, root land and bore are true cylinders.
// Every other face of the teeth of a gear is a B-spline. Its deviation from the screw surface has
// the target kSectionTarget_mm and the limit kSectionMax_mm (cad/screw_spline.hpp), and
// neighbouring faces share their edges. Modified flanks, and the fillets next to them, are
// B-splines within the same limits (cad/modified_fit.hpp). A single body
// in its own frame is a part. Several bodies, or a body with a pose, are an assembly of parts at
// their poses.
//
//   Laws  (1) the same bodies and file name give the same bytes, because the header's time is fixed
//         (2) the hand of the helix and the pose change neither the number of faces nor the volume
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// The application protocol of the file. Solids, names, colours and assemblies are the same in both
/// protocols. ap242 has replaced ap214. Older systems may need ap214.
enum class StepSchema { ap242, ap214 };

/// Returns the name of the protocol, for example "AP242".
const char* to_string(StepSchema schema);

struct StepOptions {
  StepSchema schema = StepSchema::ap242;
};

/// One arc of the half tooth and the face that represents it.
struct StepFace {
  ArcName name;
  std::size_t body;  ///< index into the bodies
  int degree_u;      ///< along the outline; 0 if the face is a true cylinder or plane
  int poles_u;
  int degree_v;  ///< along the axis; 1 for spur gears, 0 for a true cylinder
  int poles_v;
  /// Greatest normal distance to the exact surface, measured between the points of the fit. For
  /// modified flanks, the value is an upper bound of this distance.
  double max_deviation_mm;
};

struct StepReport {
  std::vector<StepFace> faces;    ///< faces of one half tooth from root to tip, body by body
  double max_deviation_mm = 0.0;  ///< greatest deviation of all faces
  /// Volume of all bodies. It is metal_volume() (cad/section.hpp) minus the volume removed by
  /// modifications. The error of the removed volume is 1e-6 of the volume of the body.
  double volume_mm3 = 0.0;
  std::size_t face_count = 0;  ///< faces of all solids; a shared shape counts once
  std::size_t edge_count = 0;  ///< edges of all solids; each shared edge counts once
};

inline constexpr std::size_t kMaxStepFaces = 10'000;  ///< limit for the teeth of one gear, or for a
                                                      ///< rack; corresponds to 30 MB of text

struct StepDocument {
  std::string text;
  StepReport report;
};

/// Returns the text of a STEP file. `file_name` is the name in its header (UTF-8, without folders).
///
/// Units     mm
/// Domain    at least one body, face widths > 0 (contract)
/// Errors    those of make_walls (cad/walls.hpp) and of fit_modified (cad/modified_fit.hpp); more
///           than kMaxStepFaces faces of one gear or of a rack
/// Accuracy  max_deviation_mm ≤ 1e-4 (kSectionMax_mm), with a target of 2e-5; points, edges and
///           faces agree within 1e-7 mm (kBrepUncertainty_mm), as the file states; a reader obtains
///           exactly the same reals
Result<StepDocument> step_document(const std::vector<ToothedBody>& bodies,
                                   const std::string& file_name, const StepOptions& options = {});

/// Writes the text of step_document to `path`. If an error occurs, no partial file remains.
///
/// Throws    IoError with the path if the file cannot be written
Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path, const StepOptions& options = {});

}  // namespace gearwright
