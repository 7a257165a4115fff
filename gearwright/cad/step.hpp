// STEP (ISO 10303-242): toothed bodies as exact solids, for CAD systems.
//
// One named solid per body. Tip land, root land and bore are true cylinders, everything else is a
// B-spline within kSectionTarget_mm of the screw surface (cad/screw_spline.hpp), and neighbouring
// faces share their edges. One body in its own frame is written as a part; several bodies, or one
// with a pose, as an assembly of parts placed by their poses. This header shows no type of the CAD
// kernel; the library that implements it is built only where the kernel is installed.
//
//   Laws  (1) same bodies, same file name, same bytes: the header's time is fixed
//         (2) hand and pose change neither the number of faces nor the volume
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// One arc of the half tooth and the face that it became.
struct StepFace {
  ArcName name;
  std::size_t body;  ///< index into the bodies
  int degree_u;      ///< along the outline; 0 where the face is a true cylinder
  int poles_u;
  int degree_v;  ///< along the axis; 1 for spur gears, 0 for a true cylinder
  int poles_v;
  double
      max_deviation_mm;  ///< normal distance to the exact screw surface, between the fit's points
};

struct StepReport {
  std::vector<StepFace> faces;    ///< root to tip of one half tooth, body by body
  double max_deviation_mm = 0.0;  ///< greatest of all faces
  double volume_mm3 = 0.0;        ///< exact: section area times face width, all bodies
  std::size_t face_count = 0;     ///< of all solids
  std::size_t edge_count = 0;     ///< each shared edge once
  bool checked = false;  ///< the CAD kernel's own check has passed every solid; false: not asked,
                         ///< beyond kStepCheckedFaces its time grows with their square
};

inline constexpr std::size_t kStepCheckedFaces = 1000;  ///< of one solid
inline constexpr std::size_t kMaxStepFaces =
    10'000;  ///< of one solid: 30 MB of text, 0.8 GB on the way

struct StepDocument {
  std::string text;
  StepReport report;
};

/// The text of a STEP file; `file_name` is what its header calls it.
///
/// Throws    IoError where the CAD kernel gives up (memory)
/// Units     mm
/// Domain    at least one body, face widths > 0 (contract)
/// Facts     those of make_walls (cad/walls.hpp); more than kMaxStepFaces faces; a solid that
///           fails the CAD kernel's check
/// Accuracy  max_deviation_mm ≤ 1e-4 (kSectionMax_mm), 2e-5 aimed at; edges and vertices 1e-7 mm
Result<StepDocument> step_document(const std::vector<ToothedBody>& bodies,
                                   const std::string& file_name);

/// Writes that text to `path`, whole or not at all.
///
/// Throws    IoError naming the path, where the file cannot be written
Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path);

}  // namespace gearwright
