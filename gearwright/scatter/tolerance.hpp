// What varies from pair to pair: one toleranced number each, or a bore in its circle.
//
//   x   coordinates of a member of the family, one for each number and two for each bore; all 0 is the
//       pair as drawn, because every x is added to what it has
//                                    theory: docs/theory/14-scatter.md, [T14.12]
#pragma once

#include <array>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/scatter/distribution.hpp"

namespace gearwright {

/// One of ContactErrors, in the order of docs/spec.md, [errors].
enum class VaryingError {
  center_distance,  ///< mm
  crossing,         ///< rad
  intersecting,     ///< rad
  axial,            ///< mm
  helix_slope1,     ///< mm of f_Hβ over the face
  helix_slope2,
  cutter_lead1,  ///< rad
  cutter_lead2
};

/// E_sn of a gear, mm.
struct VaryingThickness {
  int gear;
};

/// An amount of both flanks of a gear, mm.
struct VaryingModification {
  int gear;
  RemovalField::Parameter parameter;
};

/// The bore of axis 1 against that of axis 2, in a plane at one end of the bearing span: its place in
/// a circle.
struct VaryingBore {
  double span;    ///< L  mm
  double offset;  ///< c  mm, of the gear from the middle of the span, towards +z
  bool far_end;   ///< at z = +L/2, else −L/2
};

/// The pitches of a gear: an eccentricity and a random walk around it, as far apart as a share of F_pT
/// allows, with no step over f_ptT. x: that share, the phase of the eccentricity in degrees, and its
/// share of all. It changes the long period alone.   [T14.20]
struct VaryingPitch {
  int gear;
  double total, single;  ///< F_pT, f_ptT  mm, along the reference circle
};

/// A wave of the form of both flanks, of the whole height f_f. x: the number of waves, the phase in
/// degrees.   [T14.21]
struct VaryingWave {
  int gear;
  bool along_face;           ///< over the face, else over the usable profile
  std::array<int, 2> waves;  ///< least and most
  double height;             ///< f_fα or f_fβ  mm
};

struct ScatterTolerance {
  std::string name;   ///< as the user calls it, "errors.crossing_deg"
  double unit = 1.0;  ///< rad or mm of one of the user's units, in which the distribution is
  /// Of a bore that of both coordinates' ends, −R to R; of a pitch that of its share; of a wave 0 to 1.
  Distribution distribution;
  std::variant<VaryingError, VaryingThickness, VaryingModification, VaryingBore, VaryingPitch,
               VaryingWave>
      of;

  bool bore() const { return std::holds_alternative<VaryingBore>(of); }
  /// Coordinates of x: 2 of a bore and of a wave, 3 of a pitch, else 1.
  int coordinates() const;
  /// Its coordinates from as many numbers in (0, 1), in the user's units.
  std::array<double, 3> at(std::span<const double> u) const;
  /// Where a coordinate may lie: least and greatest.
  std::array<double, 2> side(int coordinate) const;
};

/// A member of the family: what is added to the pair as drawn, in mm and rad.
struct Deviation {
  ContactErrors errors;               ///< of the member, those of the drawing included
  PairModifications modifications;    ///< likewise
  bool modified = false;              ///< they are not the drawing's
  std::array<double, 2> thickness{};  ///< ΔE_sn  mm
  /// ε, rad, of each tooth of a gear, ahead in the sense of driving; empty: all pitches are alike.
  std::array<std::vector<double>, 2> pitch;

  bool uneven_pitch() const { return !pitch[0].empty() || !pitch[1].empty(); }
};

/// The member at x, whose coordinates follow each other as the tolerances do.
///
/// Domain    as many coordinates as the tolerances have (contract)
Deviation deviation_at(const ContactSetup& setup, std::span<const ScatterTolerance> tolerances,
                       std::span<const double> x);

/// Coordinates of all together.
int coordinates_of(std::span<const ScatterTolerance> tolerances);

/// The teeth and their modifications exist at both ends of each tolerance.
///
/// Errors    as ContactSetup::of, of the first tolerance that leads there; its name is the field
std::optional<Error> check_ends(const ContactSetup& setup,
                                std::span<const ScatterTolerance> tolerances);

}  // namespace gearwright
