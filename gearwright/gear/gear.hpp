// Describes a cylindrical gear by its values on the drawing, the derived values, and the tooth as
// cut.
//
// The symbols follow ISO 21771; see gear/reference.hpp and docs/theory/00-notation.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/error.hpp"
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
  std::optional<double> tip_diameter{};              ///< d_a   mm; by default from the rack
  Rack rack{};                                  ///< if the rack has arcs, α_n and x are not used
  std::optional<RootFilletSpec> root_fillet{};  ///< a circular arc instead of the root as cut
  std::optional<TipFilletSpec> tip_fillet{};    ///< a circular arc instead of the tip as cut

  ReferenceInput<double> reference_input() const {
    return {teeth,         normal_module,      normal_pressure_angle.rad(), helix_angle.rad(),
            profile_shift, thickness_allowance};
  }
  /// Returns the rack of an involute gear.   Domain  the rack is straight (contract)
  const StraightRack& straight_rack() const;
  StraightRack& straight_rack();
};

/// The final position of a pinion cutter.
struct PinionCutting {
  int cutter_teeth;           ///< z_0
  double distance;            ///< E  mm, from the axis of the cutter to the axis of the gear
  double tip_rounding = 0.0;  ///< ρ_a0  mm, radius of the cutter's tip corners; 0 if sharp
  bool by_default = false;    ///< true if gear/pinion_cut.hpp chose the cutter
};

/// The data that only involute gears have.
struct InvoluteTeeth {
  ReferenceGeometry<double> reference;
  std::optional<double> undercut_free_profile_shift;  ///< least x_E without undercut, signed; only
                                                      ///< for a gear cut by a rack
  /// Positions along the rack's flank as in generation/circular_fillets.hpp.
  std::optional<double> undercut_l;            ///< l_F  mm; none unless a rack cuts the gear
  std::optional<double> point_c_l, point_j_l;  ///< l_C, l_J  mm, with circular fillets
};

/// The data that only gears cut by a rack of arcs have.
struct ArcTeeth {
  RackOfArcs rack;                            ///< lengths in modules
  std::optional<double> reference_thickness;  ///< s_n  mm, with the allowance
  Angle flank_begin;                          ///< τ at the root end of the flank arc. If there are
                                              ///< several flank arcs, the undercut arc is used, or
                                              ///< the lowest arc if none is undercut
  std::optional<Angle> undercut_limit;        ///< τ of the cusp of the same arc, none without a
                                              ///< cusp
};

/// A tip that projects beyond the involute of its flank (gear/finished_gear.hpp).
struct TipBulge {
  double amount;         ///< mm, along the involute's normal
  double from_diameter;  ///< mm, where the flank ends
};

struct Gear {
  Gear() = default;  ///< empty; prevents aggregate initialisation
  CylindricalSpec spec;
  std::optional<PinionCutting> cut_by;  ///< none if cut by its rack
  std::variant<InvoluteTeeth, ArcTeeth> flanks;
  double transverse_module;   ///< m_t   mm
  double reference_diameter;  ///< d     mm
  double tip_diameter;        ///< d_a   mm, of the blank
  double root_diameter;       ///< d_f   mm, negative if the rack passes through the axis
  double lead;                ///< p_z   mm, signed; 0 for a spur gear (no lead exists)
  bool undercut;  ///< true if the cutter has removed part of the flank; always false with a
                  ///< `root_fillet`
  std::optional<double> pointed_diameter;            ///< mm, diameter at which the two flanks meet
  std::optional<double> tip_tooth_thickness_normal;  ///< s_an  mm, of the finished tooth
  std::optional<TipBulge> tip_bulge;                 ///< none if the tip does not project
  std::optional<Bore> bore;             ///< bore of the body, or rim of an internal gear
  std::optional<double> gap;            ///< mm, to the other half of a double-helical gear
  std::optional<GeneratedTooth> tooth;  ///< none for an internal gear that no pinion cutter has cut
  std::vector<Warning> warnings;

  bool internal() const { return spec.teeth < 0; }
  double side() const { return side_of(spec.teeth); }  ///< σ  +1 external, −1 internal
  /// True if the left flanks of this gear touch the mating gear. On an external gear, they
  /// touch if gear 2 of the pair drives. On an internal gear, they touch if gear 1 drives.
  bool left_flank_works(bool gear2_drives) const { return gear2_drives == (side() > 0.0); }
  const InvoluteTeeth* involute() const { return std::get_if<InvoluteTeeth>(&flanks); }
  const ArcTeeth* arcs() const { return std::get_if<ArcTeeth>(&flanks); }
  /// Returns the straight rack that cuts the teeth, or null for circular arcs and for a pinion
  /// cutter.
  const StraightRack* straight_cutter() const;
  /// Returns the rack of circular arcs that cuts the teeth, or null for an involute gear.
  const RackOfArcs* arc_cutter() const { return arcs() ? &arcs()->rack : nullptr; }
  /// Returns the least x_E without undercut, or none for circular arcs and for a pinion cutter.
  std::optional<double> undercut_free_shift() const;
  /// Returns the reference geometry.   Domain  an involute gear (contract), also for base_radius()
  const ReferenceGeometry<double>& reference() const;
  double base_radius() const { return reference().base_diameter / 2; }
  bool exists() const { return !tooth || (!tooth->through_axis && !tooth->severed); }
  /// Returns the error of a gear whose teeth do not exist. The error names the thickness allowance
  /// if a straight rack cuts the gear and the gear has teeth without the allowance. Otherwise, it
  /// names the profile shift or the rack of circular arcs.
  ///
  /// Domain    !exists() (contract)
  Error why_not() const;
  /// Returns d_Ff/2, the radius at which the usable flank starts, or none without a tooth or a
  /// usable flank.
  std::optional<double> root_form_radius() const;
  /// True if the two flanks of a tooth meet before the tip.
  bool pointed() const;
  /// Returns d_Fa/2, the radius at which the usable flank ends, or the tip radius of a tooth
  /// without a usable flank. For an internal gear without a tooth, this is the tip radius, or the
  /// base radius if the tip lies inside the base circle.
  double tip_form_radius() const;
  /// Returns the radius at which the finished tooth ends. The blank, the bottom land of the cutter
  /// or the point of the tooth determines it.
  double actual_tip_radius() const;
  /// Returns the whole face width, mm, of a gear whose teeth are `face` mm wide. For a
  /// double-helical gear it includes both halves and the gap.
  double whole_face(double face) const { return gap ? 2.0 * face + *gap : face; }
  double twist() const;  ///< 2π/p_z [T1.2]  rad/mm, signed, 0 for a spur gear
};

/// Checks the limits of a spec and returns the error of the first member that is out of bounds, if
/// any. make_gear() also calls this function.
std::optional<Error> check_limits(const CylindricalSpec& spec);
/// Makes the gear from its closed-form data and generates the tooth.
///
/// Errors    the member of CylindricalSpec ("teeth", "normal_module", "rack.dedendum", …).
///           Undercut, pointed and severed teeth are not errors but data and warnings
Result<Gear> make_gear(const CylindricalSpec& spec);
/// Returns the message of the warning `undercut`. The message ends with `remedy`, for example "a
/// profile shift of at least 0.3044 avoids undercut."
///
/// Domain    the gear has a tooth (contract)
std::string undercut_message(const Gear& gear, std::string_view remedy);

// Names of the members of gear 1 and gear 2 in errors, such as "gear1.teeth".

inline std::string gear_field(int which) { return "gear" + std::to_string(which); }

inline std::string gear_field(int which, std::string_view member) {
  return gear_field(which) + "." + std::string(member);
}

inline Error of_gear(int which, Error error) { return within(gear_field(which), std::move(error)); }

}  // namespace gearwright
