// Computes the points at which teeth with form waves can touch, in closed form. T has a local
// maximum for each crest, so a search of the whole flank would need hundreds of evaluations.
//
//   T, D     gap field (gap_field.hpp), and the part of flank 1 opposite flank 2 (touch.hpp)
//   ridge    for each height z, the point of the profile at which T is greatest, with this T
//   x, y     point of flank 1: s and z, scaled to −1 … 1 over the part that lies opposite flank 2
//   φ        rotation of gear 1 at which the smooth flanks have their ridge at (x, y)
//   L        √(ρ² − r_b²), mm, distance of a point of an involute from its base circle along its
//            normal; the phase of a wave over the profile is proportional to L
//                                    theory: docs/theory/08-contact.md, [T8.28]
//
// On involutes with parallel axes, three quantities are quadratic functions of x and y up to a
// small fraction of a micron: φ, T of the smooth flanks, and the opposite point of flank 2. These
// functions are interpolated from nine exact ridges. The waves are added in closed form, with one
// Newton step along the profile.
//
// Internal to contact/.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/contact_pair.hpp"

namespace gearwright::detail {

class WaveCrests {
 public:
  /// Returns none if there is no wave, or if the quadratic functions are not valid. They are valid
  /// under four conditions. The flanks are involutes without topography, and the axes are parallel.
  /// All exact ridges can be computed. The error half way between the ridges is at most a hundredth
  /// of the amplitude of the waves.
  static std::optional<WaveCrests> of(const ContactPair& pair, const FlankPatch& one,
                                      const FlankPatch& two);

  /// A local maximum of the ridge.
  struct Crest {
    double te;    ///< T  rad, as estimated
    double s, z;  ///< on flank 1
  };
  /// Returns the crests of tooth pair 0 at a rotation, in order of z. Crests whose T is below
  /// `least` may be missing. There are no crests far beyond the path of contact.
  ///
  /// Accuracy  T is accurate to margin()
  std::vector<Crest> at(double phi, double least) const;
  /// Returns the accuracy of the estimated T, rad. If the estimated T of a crest is lower than that
  /// of another crest by more than this margin, the crest is not the highest.
  double margin() const { return margin_; }
  /// True if the patches never lie opposite each other.
  bool apart() const { return z_lo_ >= z_hi_; }
  double s2() const { return s2_; }  ///< parameter of flank 2 at which searches can start

 private:
  struct Quadratic {
    std::array<double, 3> c{};  // [power of x]
    double at(double x) const { return c[0] + x * (c[1] + x * c[2]); }
  };
  // A function that is quadratic in x and in y, interpolated from its values at −1, 0 and 1.
  struct Biquadratic {
    std::array<std::array<double, 3>, 3> c{};  // [power of y][power of x]
    Quadratic along_x(double y) const;
  };
  struct Ridge {  // a point of a ridge, computed exactly
    double phi, te, roll2, bend, roll2_s, roll2_ss;
  };
  struct Node {
    double te = 0.0, s = 0.0, z = 0.0;
    double aside = 0.0;   // distance in s from the smooth ridge
    double inside = 0.0;  // distance in s from the smooth ridge to the nearest end of D; > 0 in D
    bool outside = true;  // true if D is empty here, or if T cannot reach `least`
  };
  using Ridges = std::array<std::array<Ridge, 3>, 3>;  // [y + 1][x + 1]
  // The path of contact: its range of s on flank 1, and φ as a linear function of s and z.
  struct Path {
    double from = 0.0, to = 0.0;      // range of s
    double phi = 0.0;                 // rotation in the middle of the range, at z_mid_
    double phi_s = 0.0, phi_z = 0.0;  // derivatives of φ
  };
  bool make(const ContactPair& pair);
  // Returns the path of contact of a pair whose only error is one of the centre distance. Returns
  // none if this path is empty. If the patches lie so far apart that they never touch, apart() also
  // becomes true.
  std::optional<Path> nominal_path(const ContactPair& pair);
  void set_middle(const Path& path);
  // Moves the ends of the path to the exact ridges opposite the ends of flank 2. Returns false if a
  // ridge cannot be computed, or if the path is empty.
  bool adjust(GapField& field, Path& path);
  // Returns the exact ridge of the smooth flanks at a point, or none if the search does not
  // converge.
  std::optional<Ridge> solve(GapField& field, double s, double z, double phi) const;
  std::optional<Ridge> ridge_at(GapField& field, const Path& path, double x, double y) const;
  std::optional<Ridges> ridges_on(GapField& field, const Path& path) const;
  static Biquadratic interpolate(const Ridges& ridges, double Ridge::*value);
  // Sets the range of φ in which the flanks touch, extended beyond both ends.
  void set_rotations(const Ridges& ridges, const Path& path);
  // Sets the amplitudes and phases of the waves, and the heights z at which T is examined.
  void set_waves(const Ridges& ridges, const Path& path);
  // Checks the quadratic functions half way between the ridges, where their error is greatest.
  bool accurate(GapField& field, const Path& path) const;
  Node node(double phi, double z, double along_face, double least) const;
  double along_face(double z) const;  // angle by which waves over the face reduce T at z, rad

  WaveCrests(const FlankPatch& one, const FlankPatch& two) : one_(one), two_(two) {}

  FlankPatch one_, two_;
  double s_mid_ = 0.0, s_half_ = 1.0;  // middle and half range of s, for x
  double z_mid_ = 0.0, z_half_ = 1.0;  // middle and half range of z, for y
  double z_lo_ = 0.0, z_hi_ = 0.0, z_shift_ = 0.0;
  double phi_lo_ = 0.0, phi_hi_ = 0.0;
  double roll2_lo_ = 0.0, roll2_hi_ = 0.0;
  double roll1_ = 0.0, roll1_per_s_ = 0.0;  // L of flank 1 at s_mid_, and its slope
  double s2_ = 0.0, arm_ = 1.0, margin_ = 0.0;
  double across_ = 0.0, along_ = 0.0;  // amplitudes over the profile and over the face, rad
  bool steep_ = false;                 // true if T may have several maxima over the profile
  double branch_ = 0.0;                // greatest change of `aside` between two nodes of one crest
  struct Wave {
    double height = 0.0;  // amplitude, rad
    double rate = 0.0;    // change of phase, rad per mm of L
  };
  std::array<Wave, 2> wave_;  // over the profile of each flank
  struct Section {
    double z, along_face;
  };
  std::vector<Section> sections_;
  Biquadratic phi_, te_, roll2_, bend_, roll2_s_, roll2_ss_;
};

}  // namespace gearwright::detail
