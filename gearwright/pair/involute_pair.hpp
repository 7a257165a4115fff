// A mounted pair of involute gears. The file defines the members common to all pairs, and the two
// kinds of pair, on parallel and on crossed axes. pair/mesh.hpp explains the symbols.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gearwright/pair/efficiency.hpp"
#include "gearwright/pair/mesh.hpp"
#include "gearwright/pair/mounted_gears.hpp"
#include "gearwright/pair/partners.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

/// A reason why parts of the pair collide.
struct Interference {
  WarningCode code;  ///< form_circle, base_tangent, tip_to_fillet, trochoid, root, or `overlap` if
                     ///< the cause has no code of its own. A tip that meets an undercut is not a
                     ///< collision; it causes the warning `contact_lost_to_undercut`
  int gear;          ///< the gear whose root or tip is affected
  std::variant<double, Angle> amount;  ///< mm, or an angle for trochoid; if negative, the depth of
                                       ///< the interference
  std::string message;                 ///< one sentence
  bool of_overlap = false;             ///< true if it is also an entry of `overlap`
};

/// A position of the axes at which a crossed pair has no backlash.
struct CrossedPlace {
  double center_distance;       ///< mm
  Angle shaft_angle;            ///< Σ
  Angle normal_pressure_angle;  ///< α_wn
};

/// A range of positions without backlash. α_wn increases from `lo` to `hi`.
struct CrossedPlaces {
  CrossedPlace lo, hi;
  bool limit;  ///< true if a helix angle is 90° at `hi`; no gear exists there
};

/// The line of action of the leading flanks in the housing. λ is the distance from the pitch point
/// in mm, λ = (ρ_1 − ρ_1C)/line_cosine. [T1.6], [T4.20]
struct LineOfAction {
  double across, along;  ///< dx/dλ and −dy/dλ of an external pair: sin α_n and cos α_n cos β_1; on
                         ///< parallel axes sin α_wt and cos α_wt
  double height, rise;  ///< z at the pitch point, mm, and dz/dρ_1; 0 on parallel axes
  double z_side;        ///< 1; on parallel axes σ, which is the sign of z = 0
};

/// The members that all involute pairs have, on parallel and on crossed axes.
struct InvolutePair : MountedGears {
  InvolutePair() = default;  ///< empty; prevents aggregate initialisation
  MeshInput<double> input;
  Mesh<double> mesh;
  LineOfAction line;
  std::optional<double>
      backlash_free_center_distance;  ///< for the teeth as cut (with allowances), mm
  double extended_center_distance;    ///< mm
  std::array<std::optional<double>, 2> form_clearance;  ///< c_F   mm: (d_Nf − d_Ff)/2 of each gear
  std::array<std::optional<double>, 2>
      contact_root_diameter;  ///< d_Nf  mm; none if contact extends beyond the base tangent point
  SpecificSliding<double> sliding_A, sliding_E;
  double tip_shortening;  ///< k m_n  mm, σ (a − extended centre distance). This change of the tip
                          ///< radii gives the tip clearance of the basic racks; < 0 if they shrink
  std::optional<Efficiency> efficiency;  ///< present if a coefficient of friction is given
                                         ///< and contact is continuous
  /// The findings that explain the overlap, or all findings if the outlines were not compared.
  std::vector<Interference> interference;
  bool flanks_meet() const;      ///< true if the path has a length and both gears have a
                                 ///< usable flank
  double path_length() const;    ///< g_α, or AE on crossed axes  mm; 0 without contact
  double contact_ratio() const;  ///< ε_α + ε_β, or AE/p_bn on crossed axes; 0 without contact
  double contact_ratio_true() const;  ///< contact ratio with the clipped path
  double normal_backlash() const { return mesh.backlash.normal; }  ///< j_n  mm
  StatedBacklash stated_backlash() const {
    return {normal_backlash(), mesh.rack.angles.cos_alpha, center_distance,
            gears[0].spec.normal_module};
  }
  std::array<double, 2> working_pitch_diameter() const {  ///< d_w  mm
    return {2 * mesh.rack.sides[0].pitch_radius, 2 * mesh.rack.sides[1].pitch_radius};
  }
  /// Returns the point for ρ_1 on the line of action of the leading flanks. On parallel axes, the
  /// point lies in the section z = 0. [T1.6], [T4.20]
  Point<Housing> on_line_of_action(double rho1) const;
  /// Returns the corresponding point for the trailing flanks. A half turn about the centre line
  /// moves the line of action of the leading flanks to the line of action of the trailing flanks.
  /// [T1.7]
  Point<Housing> on_trailing_line(double rho1) const;
};

/// Margins of an internal pair against three kinds of interference. A margin is empty if this kind
/// of interference sets no limit.
struct InternalMargins {
  std::optional<double> involute;  ///< ρ_1A − ρ_F1  mm
  std::optional<Angle> trochoid;
  std::optional<Angle> trimming;  ///< margin for radial assembly
};

struct ParallelPair : InvolutePair {
  ParallelPair() = default;  ///< empty; prevents aggregate initialisation, as in InvolutePair
  std::array<std::optional<double>, 2> fillet_clearance;  ///< mm: mating tip corner to root fillet
  std::optional<InternalMargins> margins;                 ///< only for internal pairs
  /// ε_α of the path from one tip form circle to the other; 0 without contact.
  double transverse_contact_ratio() const { return flanks_meet() ? mesh.path_ratio : 0.0; }
};

struct CrossedPair : InvolutePair {
  CrossedPair() = default;
  FaceWidths<double> face_widths{};
  std::optional<CrossedPlace> min_distance;          ///< position with the least centre distance,
                                                     ///< for the teeth as cut
  std::optional<CrossedPlaces> contact_ratio_range;  ///< positions with AE ≥ p_bn; only for
                                                     ///< external pairs
  /// For each gear, the lead crowning, mm, that is necessary if only this gear is crowned. None for
  /// external pairs, or if crowning only this gear is not sufficient. See pair/saddle_gap.hpp
  std::array<std::optional<double>, 2> needed_crowning{};
};

/// Returns the input of mesh_of() for the two gears at this position.
MeshInput<double> mesh_input(const Gear& gear_1, const Gear& gear_2, const PairPlace& place);

/// Returns the backlash-free position at which limiting_gear() has the transverse angle α. [T4.14]
CrossedPlace crossed_place(const BasePair<double>& gears, double alpha);

/// Returns the positions at which the contact ratio of a crossed external pair is at least 1.
/// Returns none if there are no such positions, and for internal pairs. For internal pairs, the
/// distance of the base tangent points is not a convex function, so there may be several ranges.
/// [T4.23]
std::optional<CrossedPlaces> contact_ratio_range(const MeshInput<double>& input);

/// Returns the position of two involute gears. Values that are absent in `spec` are computed.
///
/// Domain    both are involute gears (contract)
/// Errors    as check_partners and complete_place; `gearN.profile_shift` or
///           `gearN.thickness_allowance` if a gear does not exist, because the cutter cuts off its
///           teeth or passes through its axis
Result<PairPlace> involute_place(const Gear& gear_1, const Gear& gear_2, const PairSpec& spec);

/// Mounts two involute gears. Faults of the mesh, such as interference, do not cause an error but
/// are part of the result.
///
/// Domain    a position from involute_place(); it has no shaft angle for mount_parallel() and has a
///           shaft angle for mount_crossed() (contract)
/// Errors    `pair.center_distance` if there is no working pressure angle on parallel axes, or if
///           the distance is outside the limits of a crossed pair; `pair.shaft_angle` if a crossed
///           internal pair is impossible at every distance
Result<ParallelPair> mount_parallel(Gear gear_1, Gear gear_2, const PairPlace& place,
                                    std::optional<double> friction);
Result<CrossedPair> mount_crossed(Gear gear_1, Gear gear_2, const PairPlace& place,
                                  std::optional<double> friction);

/// Returns the least distance between the root fillet of gear `which` (1, 2) and the path of the
/// mating gear's tip corner, mm. If the distance is < 0, its magnitude is the depth to which the
/// corner cuts into the fillet. On the path, the flanks on the side of this fillet are in contact.
///
/// Formula   [T2.26]; the path is exact, and the foot point is exact to rounding
/// None      if the gear is an internal gear without a cutter, or if no corner reaches the depth of
///           the fillet
std::optional<double> fillet_clearance(const ParallelPair& pair, int which);

}  // namespace gearwright
