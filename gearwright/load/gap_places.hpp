// Finds the places where loaded teeth can touch. For every tooth pair and every slice of the face,
// this is the place at which the gap between the flanks is least.
//
//   T     angular gap field of contact [T8.1]; the place of a slice is s*(z) = argmax_s T(s, z)
//   arm   mm of normal gap per rad of gap angle [T8.3]
//                                                theory: docs/theory/12-loaded-contact.md, [T12.1]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/contact/sensitivity.hpp"
namespace gearwright {

struct GapPlace {
  double te = 0.0;                 ///< T  rad
  double arm = 0.0;                ///< mm
  std::array<double, 2> radius{};  ///< mm, distance of the place from the axis of each gear
  double curvature = 0.0;          ///< 1/R, 1/mm, curvature of the gap across the contact line
  /// The edge on which the maximum of T in the slice lies, or `line` if it lies on no edge.
  TouchKind kind = TouchKind::line;
  double s = 0.0;           ///< parameter on the patch of flank 1
  std::size_t patches = 0;  ///< index of the pair of patches
};

struct PairPlaces {
  int pair = 0;       ///< k, number of the tooth pair in the frame N
  double turn = 0.0;  ///< φ1 − k·pitch  rad, rotation of this tooth pair; increases during the mesh
  /// The place in each slice. It is absent if the flanks do not face each other in the slice.
  std::vector<std::optional<GapPlace>> at;
};

class GapSearch {
 public:
  static constexpr int kRows = 17;  ///< number of points on a profile at which the search starts
  /// `heights`, in mm, are the z coordinates of the slices on gear 1 in the frame N.
  GapSearch(const ContactPair& pair, std::vector<double> heights);
  const std::vector<double>& heights() const { return heights_; }
  /// Returns all tooth pairs whose flanks face each other in at least one slice. `rotation` is a
  /// rotation of gear 1 in the frame N.
  ///
  /// Accuracy  te is within 1e-13 rad of the greatest T over the profile. The part of flank 1 that
  ///           faces flank 2 is overlooked if it lies between two neighbouring rows
  std::vector<PairPlaces> places(double rotation);
  /// Returns ∂te/∂e at the place of a slice, rad per unit of the influence.
  ///
  /// Domain    the slice has a place; otherwise as row_slope() (contract)
  double slope(const PairPlaces& pair, std::size_t height, const Influence& influence);
  /// Returns the effect that material removed from gear `gear` has on `te` at the place of a slice.
  RemovalTurn turn(const PairPlaces& pair, std::size_t height, int gear);

 private:
  using Rows = std::array<Complex, kRows>;

  // A patch of flank 1 and a patch of flank 2. `rows` contains the points of flank 1 at every
  // height, at rotation 0.
  struct Patches {
    GapField field;
    double least_square, most_square;  // mm², range of the squared radius on gear 2
    // mm, for each row: least coordinate along the line of centres of a point that faces flank 2.
    std::array<double, kRows> least_forward;
    std::vector<Rows> rows;
  };

  std::optional<GapPlace> nearest(const Patches& patches, std::size_t height) const;
  const ContactPair& pair_;
  std::vector<double> heights_;
  std::vector<Patches> patches_;
  int farthest_pair_;
};

}  // namespace gearwright
