// The data of one or two gears on a drawing. arrange() computes absent values from given values.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/compliance/shaft.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/gear/double_helical.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/pair/shift.hpp"
#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

// The material of a gear as given on a drawing, and the complete material that results.

/// The given data. If the table of materials contains `name`, the row of this name provides the
/// missing values.
struct MaterialInput {
  std::optional<std::string> name;
  std::optional<MaterialKind> kind;
  std::optional<double> youngs_modulus;    ///< E        N/mm²
  std::optional<double> poisson_ratio;     ///< ν
  std::optional<double> density;           ///< ρ        kg/m³
  std::optional<double> sigma_Hlim;        ///< σ_Hlim   N/mm²
  std::optional<double> sigma_Flim;        ///< σ_Flim   N/mm²
  std::optional<double> surface_hardness;  ///< HV
  std::optional<double> yield_strength;    ///< R_e      N/mm²
  std::vector<double> temperatures;        ///< °C, at which the lists of a plastic apply
  ByTemperature sigma_Hlim_by, sigma_Flim_by, youngs_modulus_by;
};

/// Returns the material of `owner`, for example "gear1.material". Given values replace the values
/// in the table of materials.
///
/// Errors    `owner` or a member of it if a strength is unknown, if the hardness is outside the
///           range of the named material, if values by temperature are given for a metal, if the
///           standard does not cover the material, or if E of a plastic is unknown
Result<Material> material_of(const MaterialInput& given, const std::string& owner,
                             RatingEdition edition);

/// Returns Young's modulus E of the given material, N/mm². If E is not given, the function returns
/// the value of the named material. If no name is given, or the table does not contain the name, it
/// returns the value of the given `kind` of material. If `kind` is also absent, it returns the
/// value of steel.
///
/// Errors    `youngs_modulus` of `owner` for a plastic without a given number
Result<double> youngs_modulus_of(const MaterialInput& given, const std::string& owner);

/// Returns the density of the given material, kg/mm³. The strength of the material need not be
/// known. The density is unknown if the material is a plastic without a given density, or if
/// neither `kind` nor the name of a material in the table is given.
std::optional<double> density_of(const MaterialInput& given);

struct GearInput;

using Ends = std::array<double, 2>;

/// The pinion cutter of a gear, and the sum of profile shifts that gives the depth of the cut.
struct CutByInput {
  int gear = 0;                              ///< 1 or 2 if gear 1 or 2 of the spec is the cutter,
                                             ///< otherwise 0
  std::shared_ptr<const GearInput> cutter;   ///< a cutter given by its own data
  std::optional<double> profile_shift_pair;  ///< e: sum of the profile shifts of cutter and gear
  std::optional<double> module;              ///< mm; redundant, because the cutter determines it
  std::optional<Angle> pressure_angle;       ///< α_n; redundant, because the cutter determines it
};

struct MeasureInput {
  std::optional<int> span_teeth{};         ///< k
  std::optional<double> ball_diameter{};   ///< D_M  mm
  std::optional<double> pin_diameter{};    ///< D_M  mm
  std::optional<double> chord_diameter{};  ///< d_y  mm, at which the jaws touch
};

/// The accuracy grade of the flanks, the tolerances of tooth thickness and tip diameter, and
/// the runout of the blank. The tolerance of the tooth thickness is given by a series or a
/// measurement.
struct ToleranceInput {
  std::optional<int> quality;                           ///< A, the ISO 1328 grade
  FlankTolerances edition = FlankTolerances::iso_2013;  ///< edition of ISO 1328-1
  std::optional<std::string> series;                    ///< series of DIN 3967, for example "cd25"
  std::optional<Ends> span;                             ///< W_k  mm, least and greatest
  std::optional<Ends> over_balls;                       ///< M_d  mm, least and greatest
  /// Lower and upper deviation A_da of d_a, mm. The upper deviation gives the longer tooth of an
  /// external gear and the shorter tooth of an internal gear.
  std::optional<Ends> tip_deviations;
  std::optional<std::string> tip_fit;  ///< fit of ISO 286, for example "h9"
  /// Circular runout of the tip circle and of both faces relative to the axis, µm, used on drawings
  /// only.
  std::optional<double> tip_runout_um, face_runout_um;

  bool says_thickness() const { return series || span || over_balls; }
};

/// The input for one gear. If no profile shift is given, arrange() writes the computed shift to
/// `cylindrical.profile_shift`.
struct GearInput {
  CylindricalSpec cylindrical;
  bool shift_given = false;       ///< if false, the profile shift is computed
  bool helix_given = false;       ///< if false, the helix angle is 0, except that the verb `fit`
                                  ///< computes it
  bool hand_given = false;        ///< true if the hand is given as a word, not as a sign
  bool transverse_given = false;  ///< true if module or pressure angle is given in the transverse
                                  ///< section
  bool face_width_given = false;  ///< if false, the face width is 10 m_n, with a warning
  bool rack_given = false;        ///< if false, the rack is ISO53-A
  std::optional<BaseGear<double>> basic;  ///< base cylinder; determines module, helix angle and
                                          ///< shift
  std::optional<CutByInput> cut_by;       ///< none if the gear is cut by its rack
  std::optional<double> tip_clearance;    ///< mm, from a tip fillet to the root of the mating gear
  bool tip_clearance_by_rule = false;     ///< true if this clearance is 0.2 m_n + 0.05 mm
  std::optional<Ends> allowance_ends;     ///< E_sni, E_sns  mm; the nominal gear uses their mean
  MeasureInput measure;
  ToleranceInput tolerance;
  std::optional<Bore> bore;
  std::optional<DoubleHelical> double_helical;
  MaterialInput material;
  std::optional<Shaft> shaft;
  BothFlanks modifications;  ///< right flank, left flank

  /// Returns the input for a gear with a complete spec. Only the face width may be absent, which is
  /// indicated by the value 0. To have the profile shift computed by arrange(), the caller sets
  /// `shift_given` to false in the returned input.
  static GearInput of(const CylindricalSpec& spec) {
    GearInput gear;
    gear.cylindrical = spec;
    gear.shift_given = true;
    gear.helix_given = true;
    gear.face_width_given = spec.face_width > 0;
    gear.rack_given = true;
    return gear;
  }

  void give_shift(double x) {
    cylindrical.profile_shift = x;
    shift_given = true;
  }
  std::optional<double> given_shift() const {
    return shift_given ? std::optional(cylindrical.profile_shift) : std::nullopt;
  }

  void complete_face_width() {
    if (!face_width_given) cylindrical.face_width = 10 * cylindrical.normal_module;
  }
};

struct PairInput {
  std::optional<double> center_distance;  ///< a  mm
  std::optional<Angle> shaft_angle;       ///< Σ, signed
  Mounting mounting = Mounting::tight;
  bool choose_profile_shifts = true;  ///< true to compute absent shifts from the centre distance
  bool shorten_tips = false;          ///< true to shorten tips by k m_n if no tip diameter is given
  std::optional<double> friction_coefficient;  ///< μ
  std::optional<double> speed_rpm;             ///< n_1  1/min
  // The backlash that thinning of the teeth must produce, in one of three forms.
  std::optional<double> backlash;                  ///< j_n  mm, normal
  std::optional<double> backlash_circumferential;  ///< j_t  mm, at gear 1's working pitch circle
  std::optional<Angle> backlash_angle;             ///< rotation of gear 1 while gear 2 is held
  std::optional<Ends> backlash_ends;               ///< j_n  mm, least and greatest
  double backlash_split = 0.5;                     ///< share of the thinning on gear 1
  std::optional<Ends> distance_deviations;         ///< lower, upper deviation of the centre
                                                   ///< distance, mm
  std::optional<std::string> distance_tolerance;   ///< tolerance of ISO 286, "JS7"
  std::optional<double> bearing_span;              ///< L  mm, for the tolerances of the axes

  /// True if the teeth must be thinned for a given backlash.
  bool wants_backlash() const { return backlash || backlash_circumferential || backlash_angle; }
};

struct GivenPair {
  std::array<std::optional<GearInput>, 2> gears;  ///< a single gear is gears[0]
  std::optional<RackBar> rack;  ///< set if gear 2 is a rack; `gears` then contains only the pinion
  PairInput pair;
  bool shaft_angle_found = false;  ///< true if the shaft angle is computed from the centre distance
  std::vector<Warning> notes;      ///< about the input; arrange() adds them to the warnings

  /// Returns gear 1 or 2, or null if this gear is not given.
  GearInput* find(int which) {
    auto& gear = gears[which - 1];
    return gear ? &*gear : nullptr;
  }
  const GearInput* find(int which) const { return const_cast<GivenPair&>(*this).find(which); }
  bool has(int which) const { return find(which) != nullptr; }
  /// Returns gear 1 or 2.   Domain  this gear is given (contract)
  GearInput& gear(int which) {
    GW_EXPECTS(has(which));
    return *find(which);
  }
  const GearInput& gear(int which) const { return const_cast<GivenPair&>(*this).gear(which); }
};

/// True if the gear has circular-arc teeth, because its own rack or the rack of its cutter
/// consists of arcs.
bool has_arcs(const GearInput& gear);

bool has_arcs(const GivenPair& given);

/// Rejects inputs that have no meaning for circular-arc teeth. Such inputs are a pinion cutter with
/// such teeth, tip shortening that follows from profile shifts, and crossed axes.
std::optional<Error> check_arcs(const GivenPair& given);

}  // namespace gearwright
