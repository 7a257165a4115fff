// Computes the surfaces of teeth with flank modifications. Internal to cad/.
//
//   c(u, ζ)   material removed along the normal, mm, at the nominal point with the radius e^u mm
//             and the height ζ (gear/modifications.hpp)
//   M(a, ζ)   R(τζ) p(a) + ζ k − c n, the modified flank [T10.27]; R rotation about z, p(a) point
//             of the outline, k unit vector along z, n normal of the flank
//   ζ, z      heights of the nominal and of the moved point, mm; z = ζ − c n_z
//   w         weight of a fade, from 1 at the form diameter to 0 at the root or the tip
//
// A side is the half of a tooth that contains one flank, in the frame of the half outline (y > 0).
// The lower half, which contains the right flank, is mirrored together with its twist. The flank
// moves by c along its normal. The edge of the flank on the tip land is the line where the moved
// flank meets the tip cylinder. The root fillet, and a tip fillet or chamfer, follow the end of the
// flank. They move by w times the displacement of this end. Because w is a smooth step function of
// the radius, these parts still join the root land and the tip land as cut. Lands are cylinders.
//
// Rows   A row is a curve across the half tooth, from root to tip, in a layer between two levels. A
//        level is a plane z = const, or the image of ζ = const where an end relief begins. On a
//        helical flank, this image is not a plane, because the normal along which the flank moves
//        is inclined to z.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/gear/modifications.hpp"

namespace gearwright {

/// A level of the body. If `kink` is false, it is the plane at the height z. If `kink` is true, it
/// is the line of the nominal flank at the height z after the modification has moved this line.
struct ToothLevel {
  double z;
  bool kink = false;
};

class ModifiedSide {
 public:
  enum class Role {
    land,   ///< remains as cut
    fade,   ///< follows the end of the flank
    flank,  ///< moved by c along the normal
  };

  /// A row at the parameter v of the layer between two levels.
  struct Row {
    ToothLevel low, high;
    double v;                   ///< 0 at the lower level, 1 at the upper one
    double z;                   ///< mm, height of the row on the lands
    double edge;                ///< u of the last flank arc at the tip cylinder; 1 without an edge
    std::array<Vec2, 2> shift;  ///< mm, displacements of both ends of the flank, turned back by the
                                ///< twist
    std::array<double, 2> end_z;  ///< mm, heights of these ends
  };

  /// Domain    an outline made by ModifiedTeeth
  ModifiedSide(const Outline& outline, double twist, std::shared_ptr<const RemovalField> field);

  Row row(const ToothLevel& low, const ToothLevel& high, double v) const;
  Row plane(double z) const { return row({z}, {z}, 0.0); }

  /// Returns the point at the parameter u in [0, 1] of an arc, mm, in the frame of the side.
  Vec3 point(std::size_t arc, double u, const Row& row) const;

  Role role(std::size_t arc) const { return roles_[arc]; }
  std::size_t first_flank() const { return first_; }
  std::size_t last_flank() const { return last_; }
  const Outline& outline() const { return *outline_; }
  const RemovalField& field() const { return *field_; }
  double twist() const { return twist_; }

 private:
  // A point of the outline with the normal of the screw surface at this point.
  struct Place {
    Vec2 p;
    Vec3 n;
    double u;  // ln |p|
  };
  Place nominal(std::size_t arc, double u) const;
  double removed(const Place& at, double zeta) const { return field_->at(at.u, zeta).c; }
  double zeta_at(const ToothLevel& level, const Place& at) const;
  double zeta_in(const Row& row, const Place& at) const;
  Vec3 flank(std::size_t arc, double u, const Row& row) const;
  double edge_of(const Row& row) const;
  double weight(std::size_t arc, double rho) const;

  std::shared_ptr<const Outline> outline_;
  double twist_;
  std::shared_ptr<const RemovalField> field_;
  std::vector<Role> roles_;           // per arc
  std::size_t first_ = 0, last_ = 0;  // first and last flank arc
  bool has_edge_ = false;             // true if the last flank arc ends on a tip land
};

/// Both sides of the teeth of a body. For a double-helical gear, the teeth are those of the half at
/// z > 0, and the origin of their frame is in the middle of this half. The other half is the mirror
/// image.
class ModifiedTeeth {
 public:
  /// Makes the teeth of a body from the fields of removed material of their right and left flanks.
  ///
  /// Errors    `modifications`, with the reason why these teeth cannot be made: pointed teeth,
  ///           flanks in pieces, no root fillet, flanks that would cross
  static Result<ModifiedTeeth> of(
      const ToothedBody& body, const std::array<std::shared_ptr<const RemovalField>, 2>& removal);

  /// Returns the outline as cut. Its flank is divided at each start of a relief of either side.
  const Outline& outline() const { return right_.outline(); }
  const ModifiedSide& side(bool left) const { return left ? left_ : right_; }
  /// Returns the heights at which an end relief of either side begins, mm, in ascending order.
  std::vector<double> kinks_z() const;

  /// Returns the volume removed from all teeth over the face width of the frame, mm³.
  ///
  /// Accuracy  1e-6 of the volume of the body; the polygons that replace the outlines change the
  ///           removed volume by 5e-5 of its value
  double removed_volume(double face_width) const;

 private:
  ModifiedTeeth(ModifiedSide right, ModifiedSide left)
      : right_(std::move(right)), left_(std::move(left)) {}

  ModifiedSide right_, left_;
};

}  // namespace gearwright
