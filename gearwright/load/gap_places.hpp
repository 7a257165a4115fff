// Possible contact positions of loaded teeth: for every tooth pair and every slice of the face, the
// position at which the flanks are nearest, and their gap.
//
//   T     angular gap field of contact [T8.1]; the place of a slice is s*(z) = argmax_s T(s, z)
//   arm   mm of normal gap per rad of gap angle [T8.3]
//                                                theory: docs/theory/12-loaded-contact.md, [T12.1]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/contact/removal_turn.hpp"
#include "gearwright/contact/sensitivity.hpp"

namespace gearwright {

struct GapPlace {
  double te = 0.0;                   ///< T  rad
  double arm = 0.0;                  ///< mm
  std::array<double, 2> radius{};    ///< mm on each gear
  double curvature = 0.0;            ///< 1/R across the line, 1/mm
  TouchKind kind = TouchKind::line;  ///< or the edge at which the slice's maximum lies
  double s = 0.0;                    ///< on the patch of flank 1
  std::size_t patches = 0;           ///< index of the two patches
};

/// The slices of one tooth pair; none if the flanks do not face each other there.
struct PairPlaces {
  int pair = 0;       ///< k in N
  double turn = 0.0;  ///< own rotation, φ1 − k·pitch: the greater, the nearer to its exit
  std::vector<std::optional<GapPlace>> at;
};

/// Searches the place with the least gap for each tooth pair and slice.
class GapSearch {
 public:
  static constexpr int kRows = 17;  ///< of a flank, at which the search starts
  /// `heights` are those of the slices, mm, of gear 1 in N.
  GapSearch(const ContactPair& pair, std::vector<double> heights);
  const std::vector<double>& heights() const { return heights_; }
  /// All tooth pairs that face each other anywhere at the heights, at a rotation in N.
  ///
  /// Accuracy  te within 1e-13 rad of the greatest over the profile. A part of flank 1 inside flank 2
  ///           that lies between two neighbouring rows is not found
  std::vector<PairPlaces> places(double rotation);
  /// ∂te/∂e of the place of a slice, which must exist, rad per unit of the influence.
  ///
  /// Domain    as row_slope() (contract)
  double slope(const PairPlaces& pair, std::size_t height, const Influence& influence);
  /// The effect on te of material removed there from a gear.
  RemovalTurn turn(const PairPlaces& pair, std::size_t height, int gear);

 private:
  using Rows = std::array<Complex, kRows>;

  // Two patches that may touch, with the rows of the first one at every height, at rotation 0.
  struct Patches {
    GapField field;
    double least_square, most_square;         // mm², of radii on gear 2
    std::array<double, kRows> least_forward;  // mm, the part of a row along the line of centres
    std::vector<Rows> rows;
  };

  std::optional<GapPlace> nearest(const Patches& patches, std::size_t height) const;
  const ContactPair& pair_;
  std::vector<double> heights_;
  std::vector<Patches> patches_;
  int farthest_pair_;
};

}  // namespace gearwright
