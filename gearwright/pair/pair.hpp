// A pair of cylindrical gears mounted in a housing on parallel axes.
//
// Gear 1 drives, turning clockwise seen from +z; at rest tooth 0 of gear 1 and space 0 of gear 2
// stand on the centre line at the mesh. Housing frame: kinematics/pose.hpp. Symbols:
// pair/parallel_mesh.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/pair/parallel_mesh.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

enum class PairKind { parallel_external, parallel_internal };

/// Two parts of the pair that get in each other's way, or a flank used where it is none.
struct Interference {
  std::string code;     ///< form_circle, base_tangent, tip_to_fillet, trochoid, trimming, root
                        ///< (past an undercut nothing strikes: a warning `contact_lost` instead)
  int gear;             ///< the gear whose root or tip suffers
  double amount;        ///< mm, or rad for trochoid and trimming; < 0: by so much
  std::string message;  ///< one sentence
};

struct Pair {
  PairKind kind;
  std::array<Gear, 2> gears;
  ParallelMeshInput<double> input;
  ParallelMesh<double> mesh;
  double center_distance;            ///< a     mm
  double reference_center_distance;  ///< a_d   mm
  std::optional<double>
      backlash_free_center_distance;    ///< of the teeth as cut (with allowances), mm
  double extended_center_distance;      ///< mm
  std::array<double, 2> tip_clearance;  ///< c     mm: tip 1 to root 2, tip 2 to root 1
  std::array<std::optional<double>, 2> form_clearance;  ///< c_F   mm: (d_Nf − d_Ff)/2 of each gear
  std::array<std::optional<double>, 2>
      contact_root_diameter;  ///< d_Nf  mm; none beyond the base tangent
  std::array<std::optional<double>, 2> fillet_clearance;  ///< mm: mate's tip corner to root fillet
  std::optional<double> involute_margin;                  ///< internal: ρ_1A − ρ_F1, mm
  std::optional<double> trochoid_margin;                  ///< internal: angle, rad
  std::optional<double> trimming_margin;  ///< internal: angle, rad (radial assembly)
  SpecificSliding<double> sliding_A, sliding_E;
  double tip_shortening;  ///< k m_n  mm, ≤ 0: restores the clearance of the racks at this distance
  std::vector<Interference> interference;
  std::vector<Warning> warnings;

  double gear_ratio() const;   ///< z2/z1, negative for internal pairs
  bool flanks_meet() const;    ///< the path has a length, and both gears have a flank on it
  double path_length() const;  ///< g_α  mm; 0: no contact
  double transverse_contact_ratio()
      const;                          ///< ε_α, tip form circle to tip form circle; 0: no contact
  double contact_ratio() const;       ///< ε_α + ε_β; 0 without transverse contact
  double contact_ratio_true() const;  ///< the same with the clipped path
  /// The point of the leading line of action with curvature radius ρ_1, section z = 0.       [T1.6]
  Point<Housing> on_line_of_action(double rho1) const;
  /// Its image under the half turn about the centre line: the trailing line.
  Point<Housing> on_trailing_line(double rho1) const;
  /// Gear frames in the housing at rotation 0.
  Pose<Housing, Gear1> pose_1() const;
  Pose<Housing, Gear2> pose_2() const;
};

/// The two gears as parallel_mesh takes them, `a` mm apart; common face: the narrower one.
ParallelMeshInput<double> mesh_input(const Gear& gear_1, const Gear& gear_2, double a);

struct PairSpec {
  double center_distance;  ///< a  mm
};

/// Mounts two gears on parallel axes. Gears that do not exist (severed, through the axis) make no
/// pair; everything else that is wrong with a mesh is data.
///
/// Errors    `helix_angle_deg` when the base helices do not match, `normal_module_mm` when the base
///           pitches do not, `teeth` for impossible internal pairs, `pair.center_distance_mm`
Result<Pair> mount_parallel(Gear gear_1, Gear gear_2, const PairSpec& spec);

/// Least distance between the path of the mate's tip corner and the root fillet of gear `which` (1,
/// 2), mm, < 0: so deep the corner cuts into the fillet. The flanks of that side touch meanwhile.
///
/// Formula   [T2.26]; the path is exact, the foot point solved to rounding
/// Domain    none for the fillet of a ring
std::optional<double> fillet_clearance(const Pair& pair, int which);

}  // namespace gearwright
