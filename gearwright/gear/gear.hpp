// A cylindrical gear: its values on the drawing, the derived values, and the tooth as cut.
//
// Symbols of ISO 21771; see gear/reference.hpp and docs/theory/00-notation.md.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/gear/warning.hpp"
#include "gearwright/generation/generate.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

struct CylindricalSpec {
  int teeth = 0;                                     ///< z     negative if internal
  double normal_module = 0.0;                        ///< m_n   mm
  Angle normal_pressure_angle = Angle::degrees(20);  ///< α_n
  Angle helix_angle = Angle::degrees(0);             ///< β     > 0 right hand
  double profile_shift = 0.0;                        ///< x
  double thickness_allowance = 0.0;                  ///< E_sn  mm, < 0 thins the tooth
  double face_width = 0.0;                           ///< b     mm
  std::optional<double> tip_diameter{};              ///< d_a   mm; else from the rack
  Rack rack{};                                       ///< with arcs the gear has no α_n and no x
  std::optional<RootFilletSpec> root_fillet{};       ///< a circular arc instead of the root as cut
  std::optional<TipFilletSpec> tip_fillet{};         ///< a circular arc instead of the tip as cut

  /// The rack of an involute gear.   Domain: it is straight (contract)
  const StraightRack& straight_rack() const;
  StraightRack& straight_rack();
};

/// The final position of a pinion cutter.
struct PinionCutting {
  int cutter_teeth;           ///< z_0
  double distance;            ///< E  mm
  double tip_rounding = 0.0;  ///< ρ_a0  mm, of the cutter's tip corners; 0 if sharp
  bool by_default = false;    ///< true if gear/ring_cutter.hpp chose the cutter
};

/// The data of involute gears only.
struct InvoluteTeeth {
  ReferenceGeometry<double> reference;
  std::optional<double> undercut_free_profile_shift;  ///< least x_E without undercut, signed; only
                                                      ///< of a rack
  std::optional<double> undercut_l;                   ///< l_F  mm, signed; none if internal
  std::optional<double> point_c_l, point_j_l;         ///< l_C, l_J  mm, with circular fillets
};

/// The corresponding data of a gear cut by a rack of arcs.
struct ArcTeeth {
  RackOfArcs rack;                            ///< its edge, in modules
  std::optional<double> reference_thickness;  ///< s_n  mm, with the allowance
  Angle flank_begin;                          ///< τ at the root end of the flank's arc; of several
                                              ///< arcs, the undercut one or else the lowest
  std::optional<Angle> undercut_limit;        ///< τ of that arc's cusp; none if it has no cusp
};

/// The projection of a tip beyond the involute (gear/tip_bulge.hpp).
struct TipBulge {
  double amount;         ///< mm, along the involute's normal
  double from_diameter;  ///< mm, where the flank ends
};

struct Gear {
  Gear() = default;  ///< empty, and not an aggregate; make_gear() makes a gear from a spec
  CylindricalSpec spec;
  std::optional<PinionCutting> cut_by;  ///< none if cut by its rack
  std::variant<InvoluteTeeth, ArcTeeth> flanks;
  double transverse_module;   ///< m_t   mm
  double reference_diameter;  ///< d     mm
  double tip_diameter;        ///< d_a   mm, of the blank
  double root_diameter;       ///< d_f   mm, negative if the rack passes through the axis
  double lead;                ///< p_z   mm, signed; 0 for a spur gear (no lead exists)
  bool undercut;  ///< the cutter removed part of the flank; false with a circular root fillet
  std::optional<double> pointed_diameter;            ///< where the two flanks meet, mm
  std::optional<double> tip_tooth_thickness_normal;  ///< s_an  mm, of the finished tooth
  std::optional<TipBulge> tip_bulge;                 ///< none if the tip does not project
  std::optional<Bore> bore;   ///< of the body (internal: rim); independent of the teeth
  std::optional<double> gap;  ///< mm, between the halves of a double-helical gear; this is one half
  std::optional<GeneratedTooth> tooth;  ///< none for an internal gear that no pinion cutter has cut
  std::vector<Warning> warnings;

  bool internal() const { return spec.teeth < 0; }
  double side() const { return side_of(spec.teeth); }  ///< σ  +1 external, −1 internal
  const InvoluteTeeth* involute() const { return std::get_if<InvoluteTeeth>(&flanks); }
  const ArcTeeth* arcs() const { return std::get_if<ArcTeeth>(&flanks); }
  /// Domain  an involute gear (contract), here and for the base radius
  const ReferenceGeometry<double>& reference() const;
  double base_radius() const { return reference().base_diameter / 2; }
  bool exists() const { return !tooth || (!tooth->through_axis && !tooth->severed); }
  /// d_Ff/2, where the usable flank starts; none for an internal gear or when no flank is left.
  std::optional<double> root_form_radius() const;
  /// Two flanks meet before the tip: a pointed tooth, or an internal gear's that thins to nothing
  /// inward.
  bool pointed() const;
  /// d_Fa/2, its end; for an internal gear the tip, or the base circle if the tip lies inside it.
  double tip_form_radius() const;
  /// The radius at which the finished tooth ends: blank, cutter's bottom, or its point.
  double actual_tip_radius() const;
  /// The face width, mm, of a gear whose teeth are `face` mm wide: that, or of a double-helical gear
  /// both halves and the gap.
  double whole_face(double face) const { return gap ? 2.0 * face + *gap : face; }
  double twist() const;  ///< 2π/p_z [T1.2]  rad/mm, signed, 0 for a spur gear
};

/// Checks the limits of a spec and returns the first member out of bounds, or nothing. make_gear
/// calls it too.
std::optional<Error> check_limits(const CylindricalSpec& spec);

/// Makes the gear: closed-form data, then the tooth by generation.
///
/// Errors    the member of CylindricalSpec ("teeth", "normal_module", "rack.dedendum", …).
///           Undercut, pointed, severed teeth are data and warnings.
Result<Gear> make_gear(const CylindricalSpec& spec);

}  // namespace gearwright
