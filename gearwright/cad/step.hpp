// STEP (ISO 10303-242): toothed bodies as exact solids, for CAD systems.
//
// One named, coloured solid per body. Tip land, root land and bore are true cylinders, everything else
// is a B-spline within kSectionTarget_mm of the screw surface (cad/screw_spline.hpp), and neighbouring
// faces share their edges. Flanks with modifications, and the fillets beside them, are B-splines within
// the same limits (cad/modified_fit.hpp). A single body in its own frame is written as a part. Several
// bodies, or a body with a pose, are written as an assembly of parts placed by their poses. No CAD kernel
// is needed: both the surfaces and the text (cad/part21.hpp) are computed here.
//
//   Laws  (1) the same bodies and file name give the same bytes, because the header's time is fixed
//         (2) hand and pose change neither the number of faces nor the volume
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// The application protocol of the file. Solids, names, colours and assemblies are the same in
/// both. ap242 has replaced ap214, which is kept for older systems.
enum class StepSchema { ap242, ap214 };

/// "AP242"
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
  double
      max_deviation_mm;  ///< normal distance to the exact surface, measured between the points of
                         ///< the fit; for modified flanks an upper bound of the distance
};

struct StepReport {
  std::vector<StepFace> faces;    ///< root to tip of one half tooth, body by body
  double max_deviation_mm = 0.0;  ///< greatest of all faces
  double volume_mm3 = 0.0;        ///< of all bodies: exact section area times face width, minus
                                  ///< the volume of modifications, to 1e-6 of the body
  std::size_t face_count = 0;     ///< of all solids, each shape once
  std::size_t edge_count = 0;     ///< each shared edge once
};

inline constexpr std::size_t kMaxStepFaces = 10'000;  ///< of one solid: 30 MB of text

struct StepDocument {
  std::string text;
  StepReport report;
};

/// Returns the text of a STEP file. `file_name` is the name in its header (UTF-8, without folders).
///
/// Units     mm
/// Domain    at least one body, face widths > 0 (contract)
/// Errors    those of make_walls (cad/walls.hpp); more than kMaxStepFaces faces
/// Accuracy  max_deviation_mm ≤ 1e-4 (kSectionMax_mm), with the target 2e-5; points, edges and
///           faces agree within 1e-7 mm (kBrepUncertainty_mm), which the file states; reals read
///           back to the bit
Result<StepDocument> step_document(const std::vector<ToothedBody>& bodies,
                                   const std::string& file_name, const StepOptions& options = {});

/// Writes the text of step_document to `path`. If an error occurs, no partial file remains.
///
/// Throws    IoError with the path if the file cannot be written
Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path, const StepOptions& options = {});

}  // namespace gearwright
