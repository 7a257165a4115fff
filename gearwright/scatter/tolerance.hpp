// Describes variations from pair to pair. A toleranced number, the position of a bore, pitches, or
// form waves of the flanks can vary.
//
//   x   coordinates of a member of the family, one to three for each tolerance. They describe the
//       deviation from the drawing, and x = 0 is the nominal pair
//                                    theory: docs/theory/14-scatter.md, [T14.12]
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/scatter/distribution.hpp"

namespace gearwright {

/// The errors of mounting and of the teeth that can vary, in the order of docs/spec.md, [errors].
enum class VaryingError {
  center_distance,  ///< mm
  crossing,         ///< rad
  intersecting,     ///< rad
  axial,            ///< mm
  helix_slope1,     ///< f_Hβ over the face, mm
  helix_slope2,
  cutter_lead1,  ///< rad
  cutter_lead2
};

/// The tooth thickness of a gear, as its deviation E_sn, mm.
struct VaryingThickness {
  int gear;
};

/// The amount of a modification of both flanks of a gear, mm.
struct VaryingModification {
  int gear;
  Modification parameter;
};

/// The position of the bore of axis 1 relative to the bore of axis 2, in the plane at one end of
/// the bearing span. The position varies within a circle.
struct VaryingBore {
  double span;    ///< L  mm
  double offset;  ///< c  mm, z of the gear relative to the middle of the span
  bool far_end;   ///< true for the plane at z = +L/2, false for −L/2
};

/// The pitches of a gear, as the sum of an eccentricity and a random walk. The range of the sum is
/// at most a share of F_pT, and no step from tooth to tooth exceeds f_ptT. The coordinates x are
/// this share, the phase of the eccentricity in degrees, and the part of the sum that is due to the
/// eccentricity. Pitches affect only the quantity long_period.   [T14.20]
struct VaryingPitch {
  int gear;
  double total, single;  ///< F_pT, f_ptT  mm, along the reference circle
};

/// A wave of the full height f_f, which is a form deviation of both flanks. The coordinates x are
/// the wave count and the phase in degrees.   [T14.21]
struct VaryingWave {
  int gear;
  bool along_face;           ///< true if over the face, false if over the usable profile
  std::array<int, 2> waves;  ///< least and greatest number of waves
  double height;             ///< f_fα or f_fβ  mm, from crest to trough
};

struct ScatterTolerance {
  std::string name;   ///< name for the user, for example "errors.crossing_deg"
  double unit = 1.0;  ///< the user's unit, in rad or mm; the distribution is in the user's unit
  /// The distribution of the toleranced number. For a bore, each coordinate has this distribution
  /// over −R to R. For pitches, the share has this distribution. For a wave, it is not used.
  Distribution distribution;
  std::variant<VaryingError, VaryingThickness, VaryingModification, VaryingBore, VaryingPitch,
               VaryingWave>
      of;
  std::string source{};  ///< key or table of the spec that gives the range

  /// Returns ", f_fα of the grade" or ", f_fβ of the grade" for a wave, because the grade
  /// determines the height of a wave. Returns an empty text for any other tolerance.
  const char* of_grade() const;
  bool bore() const { return std::holds_alternative<VaryingBore>(of); }
  /// True if the tolerance changes the position or the shape of the flanks, and therefore the peak
  /// to peak. Tooth thickness and pitches do not change the peak to peak.
  bool moves_flanks() const {
    return !std::holds_alternative<VaryingThickness>(of) &&
           !std::holds_alternative<VaryingPitch>(of);
  }
  /// Returns the number of coordinates: 2 for a bore or a wave, 3 for pitches, otherwise 1.
  int coordinates() const;
  /// Returns the coordinates of x in the user's units. `u` has a value in (0, 1) for each of them.
  std::array<double, 3> at(std::span<const double> u) const;
  /// Returns the least and the greatest value of this coordinate of x, in the user's unit.
  std::array<double, 2> side(int coordinate) const;
  /// True if this coordinate has a normal score, by which it can be correlated. A phase has no
  /// score. A wave count has a score if its least and greatest values differ.
  bool has_score(int coordinate) const;
};

/// A member of the family, described by its errors, modifications and deviations in mm and rad.
struct Deviation {
  ContactErrors errors;               ///< nominal errors plus deviations of the member
  PairModifications modifications;    ///< nominal modifications plus deviations of the member
  bool modified = false;              ///< true if `modifications` differ from the nominal values
  std::array<double, 2> thickness{};  ///< ΔE_sn of each gear, mm, relative to the nominal gear
  /// ε of each tooth of a gear, rad, > 0 if the tooth is ahead; empty for equal pitches.
  std::array<std::vector<double>, 2> pitch;

  bool uneven_pitch() const { return !pitch[0].empty() || !pitch[1].empty(); }
};

/// Returns the member at x, whose coordinates are in the order of the tolerances.
///
/// Domain    x has one value for each coordinate of the tolerances (contract)
Deviation deviation_at(const ContactSetup& setup, std::span<const ScatterTolerance> tolerances,
                       std::span<const double> x);

int coordinates_of(std::span<const ScatterTolerance> tolerances);
/// Returns the names of the coordinates for the user. A single coordinate has the name of its
/// tolerance, for example "errors.crossing_deg". Several coordinates have endings, for example
/// "bearings.bore_a.x_mm".
std::vector<std::string> coordinate_names(std::span<const ScatterTolerance> tolerances);

/// Checks that the teeth and their modifications exist at both ends of each tolerance.
///
/// Errors    as ContactSetup::of, for the first tolerance with an invalid end, or for a varying
///           wave if the gear already has a wave in the same direction; the field of the error is
///           the name of this tolerance
std::optional<Error> check_ends(const ContactSetup& setup,
                                std::span<const ScatterTolerance> tolerances);

/// The flank deviations that a grade of ISO 1328-1 allows, mm. f_H limits the slope deviation over
/// an evaluation range, and f_f limits the form deviation from the line with this slope.
struct GradedFlank {
  double profile_slope;              ///< ± f_Hα, converted from L_α to the whole usable flank
  double helix_slope;                ///< ± f_Hβ, converted from L_β to the whole face
  double profile_form, helix_form;   ///< f_fα, f_fβ
  double total_pitch, single_pitch;  ///< F_p, f_pt
  double helix_total;                ///< F_β
};

/// Returns the deviations that the grade `quality` of an edition of the standard allows for a gear.
///
/// Formula   [T14.23], with the values of flank_tolerances()
/// Domain    a grade of the edition (contract)
/// None      for circular-arc teeth, which the standard does not cover, or if the gear has no
///           evaluation range
std::optional<GradedFlank> graded_flank(const Gear& gear, FlankTolerances edition, int quality);

/// Limits of the deviations of parallel axes according to ISO/TR 10064-3, rad. Each limit applies
/// in both directions. ISO/TR 10064-3 gives the limits as lengths in proportion to the bearing
/// span, so the angles do not depend on the span.
///
/// Formula   [T14.23]
struct GradedAxes {
  double crossing, intersecting;
};
GradedAxes graded_axes(double greater_helix_total, double face_width);

}  // namespace gearwright
