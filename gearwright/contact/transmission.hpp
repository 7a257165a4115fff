// Computes the transmission error TE (the rotation of gear 2 minus its nominal rotation) at each
// position, with the tooth pair that touches and the point at which it touches.
//
//   T     greatest value of the gap field (gap_field.hpp) of tooth pair 0
//   N     frame of contact_pair.hpp
//   TE(φ1) = max over pairs k of T(φ1 − k·2π/z1)                 [T8.2], docs/theory/08-contact.md
//
// Only tooth pair 0 is followed from its first to its last contact, because the other pairs repeat
// its motion with a delay of whole pitches. On convex flanks, the greatest T is followed across the
// borders of patches. On other flanks, every pair of patches is followed separately, and the
// greatest T of all pairs of patches is used. If wavy() is true, no touch is followed, and searches
// start at the crests of the waves instead.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/contact/touch.hpp"

namespace gearwright {

namespace detail {
class LaneTrack;   // contact/lane_track.hpp
class WaveCrests;  // contact/wave_crests.hpp
}  // namespace detail

/// A touch of tooth pair k. Pair 0 touches in the same way, k pitches of gear 1 earlier.
struct PairTouch {
  Touch touch;
  int fields = -1;   ///< index of the pair of patches; −1 without contact
  double phi = 0.0;  ///< rotation of gear 1 at which pair 0 has this touch, rad, in the frame N
  int pair = 0;      ///< k, number of the tooth pair in the frame N

  bool found() const { return fields >= 0; }
  double te() const { return touch.te; }
};

namespace detail {

// If several pairs have the same T within rounding, the pair nearest to the centre line is used.
constexpr double kTogether = 1e-13;  // rad

/// True if the touch `t` of pair 0 at φ has a greater T than `best`. Also true if T is equal within
/// rounding, and `t` is nearer to the centre line.
bool wins(const Touch& t, double phi, const PairTouch& best);

}  // namespace detail

class Transmission {
 public:
  /// Makes the transmission of a pair, which must outlive it. `progress` counts every position.
  explicit Transmission(const ContactPair& pair, Progress* progress = nullptr);

  /// Returns the touches at n positions over one pitch. The rotations begin at `first` and increase
  /// by pitch/n, in rad, in the frame N.
  std::vector<PairTouch> over_a_pitch(double first, int n);
  /// Returns the touch at any rotation. The search does not use other touches.
  PairTouch at(double phi);
  /// Returns the touch of tooth pair 0, even if another pair has a greater T. If wavy() is true,
  /// touches far beyond the path of contact are not found.
  PairTouch of_pair_0(double phi);
  /// Returns the touch of the tooth pair of `from`, on the same patches, at the rotation φ of pair
  /// 0. The search starts at `from`. The result is not found() if these patches do not touch at
  /// that rotation.
  PairTouch follow(const PairTouch& from, double phi);
  /// Works like follow(). On convex flanks with several patches, the touch also moves to the pair
  /// of patches on which T of this tooth pair is greatest.
  PairTouch follow_pair(const PairTouch& from, double phi);
  /// True if follow_pair() crosses the borders of patches.
  bool crosses_patches() const { return convex_ && fields_.size() > 1; }
  /// Returns all local maxima of T of tooth pair 0 on all pairs of patches. A maximum at a seam is
  /// included, even if T is greater beyond the seam.
  std::vector<PairTouch> every_of_pair_0(double phi);

  const ContactPair& pair() const { return pair_; }
  const TouchSearch& search(int fields) const { return *searches_[fields]; }
  const GapField& field(int fields) const { return *fields_[fields]; }
  /// Sets the field to the rotation of the touch, and returns the field and its derivatives at
  /// (s, z). The parameter on flank 2 is exact to rounding.
  GapJet jet_at(const PairTouch& t, double s, double z);
  /// True if T has many maxima because of form waves, and if WaveCrests can compute these maxima in
  /// closed form.
  bool wavy() const { return !crests_.empty(); }
  int farthest_pair() const { return farthest_pair_; }  ///< greatest |k| of a pair that can touch
  TouchCount count() const;
  long too_long() const { return too_long_; }  ///< number of searches that did not converge

 private:
  friend class detail::LaneTrack;
  class Track;
  PairTouch climb(const PairTouch& from, double phi);
  std::vector<int> largest_first() const;
  PairTouch first_touch(double phi);
  void follow_one(double first, int n, std::vector<PairTouch>& best);
  void follow_all(int fields, double first, int n, std::vector<PairTouch>& best);
  void over_crests(double first, int n, std::vector<PairTouch>& best);
  Touch cold(int fields, double phi);
  Touch highest_crest(int fields, double phi);
  Touch from_crest(int fields, double s, double z);

  const ContactPair& pair_;
  Progress* progress_;
  std::vector<std::unique_ptr<GapField>> fields_;
  std::vector<std::unique_ptr<TouchSearch>> searches_;
  // The crests of each field. Empty if the crests of one of the fields cannot be computed.
  std::vector<std::shared_ptr<const detail::WaveCrests>> crests_;
  bool convex_;
  // For each pair of patches on convex flanks, the pair of patches beyond each bound, or −1.
  std::vector<std::array<int, detail::kBounds>> across_;
  int farthest_pair_;
  long too_long_ = 0;
};

}  // namespace gearwright
