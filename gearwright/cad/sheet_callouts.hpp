// Draws the callouts of an axial section with leaders to the section. The callouts state the runout
// of tip circle and faces, and the surface texture of flanks, bore and faces. Internal to cad/.
//
// The callouts are to the left of the section, in the corners next to the circle of the transverse
// view. At most scales, this space is empty. Coordinates are relative to the point of the axis at
// the left face.
//
//     [tip runout]──────┐
//      flank ─────────┐ ↓          ring: the runout of the tip circle is below the flank, because
//      bore ───────┐  ↓ ┌─────      the leader of the runout comes from the inside
//                  │  - │
//    - - - - - - - ↓ - -│- - axis
//       faces           │
//      [face runout]───→└─────
#pragma once

#include <optional>
#include <vector>

#include "gearwright/cad/gear_sheet.hpp"

namespace gearwright {

/// The space to the left of the section that other parts of the drawing already occupy.
struct OccupiedSpace {
  double left, lo, hi;  ///< mm, left end, lower and upper end
};

/// The axial section on paper, mm.
struct AxialSection {
  bool ring;
  double width, half;                    ///< face width, and width of the teeth at the left face
  double body;                           ///< radius of the outermost circle
  double tip, reference;                 ///< radii of tip circle and reference circle
  std::optional<double> bore;            ///< radius of the bore of an external gear
  std::vector<OccupiedSpace> on_left{};  ///< dimensions and datum
};

class Callouts {
 public:
  Callouts(AxialSection section, SurfaceRequirements required);

  /// Returns the space that each callout covers, without its leader.
  std::vector<SheetBox> boxes() const;
  /// Returns the distance that the callouts need between the centre of the transverse view and the
  /// left face.
  double distance() const;
  double top() const;    ///< greatest height of a callout above the axis
  double right() const;  ///< extent beyond the right face; 0 if no callout lies beyond this face
  /// `origin` is the point of the axis at the left face.
  void draw(Sheet& sheet, const Vec2& origin) const;

 private:
  void place_faces();
  void place_above();
  bool faces_on_left() const { return faces_.hi.x() < 0; }

  AxialSection section_;
  SurfaceRequirements required_;
  std::optional<SheetBox> flank_, bore_;  // symbols; the shelf is at the lower end
  SheetBox tip_, faces_;                  // the frames are at the lower end
};

}  // namespace gearwright
