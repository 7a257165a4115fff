// Describes a gear for CAD files. A gear has one outline, which a screw motion moves along the
// face, and an optional bore.
//
//   τ    twist, rad/mm: 2π/lead, signed, > 0 right hand, 0 spur
//   b    face width, mm; the body fills −b/2 ≤ z ≤ b/2, and the outline is its section at z = 0
//
// The section at the height z is the section z = 0 turned by τz. Tip, root and bore are cylinders.
//
// A double-helical gear has two screw motions with opposite twist, one for z > 0 and one for z < 0
// (`TwoHelices`). The section at the height z is the outline turned by τ|z|, so both halves of a
// tooth point to the apex in the middle plane. If there is a gap between the halves, it is a groove
// around the axis.
//
// Several external gears on one axis are one solid if plain cylinders join them (`above`).
//
// A rack is a bar with straight teeth, between two ends that are perpendicular to y (`RackBlock`).
// The section at the height z is the section z = 0 with the teeth shifted by z tan β along y.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// The data that make an outline a rack. The frame is that of pair/rack_pair.hpp, in which x is the
/// height above the datum line. The length of the bar is the pitch times the number of teeth. The
/// origin is in the middle of this length.
struct RackBlock {
  double pitch;          ///< p_t    mm, along y
  double height;         ///< mm, from the back to the datum line
  double slope;          ///< tan β  of the teeth, > 0 right hand
  double fillet_radius;  ///< ρ_f    mm, in the normal section

  /// y of the middle of tooth k of n at z = 0, mm.
  double middle_of(int k, int n) const { return (k - (n - 1) / 2.0) * pitch; }
};

/// The data of a double-helical gear. The half at z > 0 has the twist of the body.
struct TwoHelices {
  double gap = 0.0;            ///< mm, between the halves
  double groove_radius = 0.0;  ///< mm, radius of the gear within the gap; unused without a gap
  double stagger = 0.0;        ///< rad, rotation of the half at z < 0; 0 if there is no gap
};

/// One screw motion of a body, for the heights z from middle − width/2 to middle + width/2.
struct Band {
  double twist;   ///< rad/mm
  double width;   ///< mm
  double middle;  ///< mm
  double turn;    ///< rad, rotation at z = 0; the plane z = 0 may lie outside the band

  double angle(double z) const { return twist * z + turn; }
};

struct SolidFrame {};  ///< the frame of a solid; for a gear, its own frame
/// The frame of a file. For gears in place, it is the frame of the housing. For solids that
/// laid_out() places side by side for printing, z = 0 is the plane on which they lie.
struct AssemblyFrame {};
using SolidPose = Pose<AssemblyFrame, SolidFrame>;

/// Returns the pose of a gear of a pair in a file whose frame is the housing of the pair.
template <class GearFrame>
SolidPose in_assembly(const Pose<Housing, GearFrame>& pose) {
  return SolidPose(pose.isometry());
}

class ModifiedTeeth;
struct ToothedBody;

/// A gear of a solid, in the frame of the solid.
struct SolidGear {
  const ToothedBody* body;
  double height = 0.0;  ///< mm, z of the middle of the face
  double turn = 0.0;    ///< rad, rotation about z

  std::vector<Band> bands() const;  ///< screw motions of the gear in the frame of the solid
  double bottom() const;            ///< z of the lower end face, mm
  double top() const;               ///< z of the upper end face, mm
};

struct ToothedBody {
  std::string name;         ///< "gear1", the name in the tree of a CAD system
  Outline outline;          ///< half a tooth; the gear consists of |outline.teeth| copies
  double twist = 0.0;       ///< τ  rad/mm
  double face_width = 0.0;  ///< b  mm
  std::optional<Bore> bore;
  SolidPose pose{};
  std::optional<std::size_t> colour{};      ///< for part_colour(); by default the index of the body
  std::optional<std::size_t> same_as{};     ///< an earlier body of the file with the same shape; if
                                            ///< set, that shape is used
  std::optional<RackBlock> rack{};          ///< set for a rack, which has no bore and no twist
  std::optional<TwoHelices> two_helices{};  ///< set for a double-helical gear
  /// The teeth with flank modifications, made by modify(). Null if the teeth are as cut. Drawings
  /// always show the outline as cut.
  std::shared_ptr<const ModifiedTeeth> modified{};
  std::string unmodified{};  ///< the reason why modifications are omitted; empty if none is omitted

  /// The other gears of the solid, from bottom to top, each with its own `height` and `turn`.
  ///
  /// Domain    external gears with the same bore, whose own `above` is empty, and with a
  ///           distance between the end faces
  std::vector<ToothedBody> above{};
  double height = 0.0;     ///< z of the middle of the face of a gear in `above`, mm
  double turn = 0.0;       ///< rotation of a gear in `above` about z, rad
  double neck = 0.0;       ///< radius of the cylinder below a gear in `above`, mm
  std::string separate{};  ///< the reason why the gear is not joined to another gear of its body

  bool ring() const { return outline.teeth < 0; }
  bool grooved() const { return two_helices && two_helices->gap > 0.0; }

  /// Returns this body and the gears above it, from bottom to top.
  std::vector<SolidGear> gears() const;

  /// Returns the screw motions of the teeth, from bottom to top. A double-helical gear has two, and
  /// any other gear has one.
  std::vector<Band> bands() const;

  /// Returns the limits for the bore or the rim. `root` is the radius of the roots, mm.
  HoleLimits hole_limits(double root) const {
    return {ring(), root, grooved() ? std::optional(two_helices->groove_radius) : std::nullopt};
  }

  /// Returns the radius that limits a bore or a rim, mm. It is the radius of the groove or, if
  /// there is no groove, `root`.
  double limit_within(double root) const { return grooved() ? two_helices->groove_radius : root; }
};

/// Colours that distinguish gears in contact in every viewer. The values are linear RGB. They
/// differ clearly in lightness as well as in hue. The colours are steel, bronze, blue, green and,
/// for larger drives, ochre, purple, teal and dark grey.
inline constexpr std::array<std::array<double, 3>, 8> kPartColours{{{0.45, 0.49, 0.53},
                                                                    {0.55, 0.34, 0.14},
                                                                    {0.12, 0.26, 0.48},
                                                                    {0.2, 0.42, 0.24},
                                                                    {0.62, 0.5, 0.1},
                                                                    {0.34, 0.12, 0.34},
                                                                    {0.1, 0.4, 0.42},
                                                                    {0.12, 0.13, 0.15}}};

/// Returns the colour of the part with this index. The colours repeat after the last one.
constexpr const std::array<double, 3>& part_colour(std::size_t index) {
  return kPartColours[index % kPartColours.size()];
}

/// Returns an error of the key `teeth` with the reason `why`.
inline Error not_a_body(int teeth, const std::string& why) {
  return {"teeth", std::to_string(teeth),
          "the outline does not enclose a body, because " + why +
              "; more teeth or a greater profile shift would help"};
}

/// Returns the gear in its own frame. The pose of the gear in a pair is
/// `in_assembly(pair.pose_1())` or `in_assembly(pair.pose_2())`.
///
/// Errors    `cut_by` for an internal gear without a pinion cutter; `teeth` for a gear whose tooth
///           cannot exist (severed by undercut, or with a root beyond the axis)
Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore = {});

/// Applies the modifications of the right and the left flank to the body of a gear. If the teeth
/// cannot be made with these modifications, they remain as cut and `unmodified` contains the
/// reason.
///
/// Errors    `modifications.right.…`, `modifications.left.…`, errors of make_removal_field
std::optional<Error> modify(ToothedBody& body, const Gear& gear, const BothFlanks& flanks);

/// Returns the rack in its own frame (pair/rack_pair.hpp). The pose of the rack is
/// `in_assembly(rack_pair.pose_2())`.
///
/// Domain    the back lies below the roots (contract), as for every rack from mount_rack()
/// Errors    errors of rack_outline()
Result<ToothedBody> rack_body(const RackGeometry& rack, const std::string& name);

}  // namespace gearwright
