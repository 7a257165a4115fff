// Possible contact positions of loaded teeth: for every tooth pair and every slice of the face, the
// position at which the flanks are nearest, and their gap.
//
//   T     angular gap field of contact [T8.1]; the place of a slice is s*(z) = argmax_s T(s, z)
//   arm   mm of normal gap per rad of gap angle [T8.3]
//                                                theory: docs/theory/12-loaded-contact.md, [T12.1]
#pragma once

#include <optional>
#include <vector>

#include "gearwright/contact/contact_point.hpp"

namespace gearwright {

struct GapPlace {
  double te = 0.0;                   ///< T  rad
  double arm = 0.0;                  ///< mm
  std::array<double, 2> radius{};    ///< mm on each gear
  double curvature = 0.0;            ///< 1/R across the line, 1/mm
  TouchKind kind = TouchKind::line;  ///< or the edge at which the slice's maximum lies
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
  explicit GapSearch(const ContactPair& pair);
  /// All tooth pairs that face each other anywhere at these heights (mm, of gear 1 in N), at a
  /// rotation in N.
  std::vector<PairPlaces> places(double rotation, const std::vector<double>& heights);

 private:
  std::optional<GapPlace> nearest(const GapField& field, double z) const;
  const ContactPair& pair_;
  std::vector<GapField> fields_;
  int farthest_pair_;
};

}  // namespace gearwright
