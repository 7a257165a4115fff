// Variations from pair to pair: one toleranced number each, or the place of a bore in a circle.
//
//   x   coordinates of a member of the family, one for each number and two for each bore; 0 is the
//       pair as drawn, because every x is added to the value of the drawing
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

struct ScatterTolerance {
  std::string name;   ///< name for the user, "errors.crossing_deg"
  double unit = 1.0;  ///< one unit of the user in rad or mm; the distribution uses the user's unit
  Distribution distribution;  ///< for a bore that of both coordinates, −R to R
  std::variant<VaryingError, VaryingThickness, VaryingModification, VaryingBore> of;

  /// Coordinates of x: 2 for a bore, otherwise 1.
  int coordinates() const { return std::holds_alternative<VaryingBore>(of) ? 2 : 1; }
  /// Its coordinates from as many numbers in (0, 1), in the user's units.
  std::array<double, 2> at(std::span<const double> u) const;
};

/// A member of the family: its difference from the pair as drawn, in mm and rad.
struct Deviation {
  ContactErrors errors;               ///< of the member, including those of the drawing
  PairModifications modifications;    ///< likewise
  bool modified = false;              ///< true if they differ from those of the drawing
  std::array<double, 2> thickness{};  ///< ΔE_sn  mm
};

/// The member at x, whose coordinates are in the order of the tolerances.
///
/// Domain    as many coordinates as the tolerances have (contract)
Deviation deviation_at(const ContactSetup& setup, std::span<const ScatterTolerance> tolerances,
                       std::span<const double> x);

/// The number of coordinates of all tolerances.
int coordinates_of(std::span<const ScatterTolerance> tolerances);

/// Checks that the teeth and their modifications exist at both ends of each tolerance.
///
/// Errors    as ContactSetup::of, for the first tolerance that causes it; its name is the field
std::optional<Error> check_ends(const ContactSetup& setup,
                                std::span<const ScatterTolerance> tolerances);

}  // namespace gearwright
