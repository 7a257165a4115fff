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

struct ScatterTolerance {
  std::string name;   ///< as the user calls it, "errors.crossing_deg"
  double unit = 1.0;  ///< rad or mm of one of the user's units, in which the distribution is
  Distribution distribution;  ///< of a bore that of both coordinates' ends, −R to R
  std::variant<VaryingError, VaryingThickness, VaryingModification, VaryingBore> of;

  /// Coordinates of x: 2 of a bore, else 1.
  int coordinates() const { return std::holds_alternative<VaryingBore>(of) ? 2 : 1; }
  /// Its coordinates from as many numbers in (0, 1), in the user's units.
  std::array<double, 2> at(std::span<const double> u) const;
};

/// A member of the family: what is added to the pair as drawn, in mm and rad.
struct Deviation {
  ContactErrors errors;               ///< of the member, those of the drawing included
  PairModifications modifications;    ///< likewise
  bool modified = false;              ///< they are not the drawing's
  std::array<double, 2> thickness{};  ///< ΔE_sn  mm
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
