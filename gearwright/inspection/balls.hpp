// Computes the contacts of balls and pins in the tooth spaces of a gear, and the dimensions over or
// between balls and pins.
//
//   D_M    diameter of ball or pin, mm
//   α_Kt   transverse pressure angle at the centre of the ball, rad
//   d_K    diameter of the circle through the centre of the ball, mm
//   d_M    diameter of the contacts, mm
//   η_b    half angle of the space on the base cylinder, rad [T10.5]
//   β_K    helix angle at d_K, rad             δ     π/|z| if |z| is odd, otherwise 0
//   ε      angle by which two free pins at their least distance deviate from opposite positions,
//          rad
//   M_d    dimension over two balls, mm        M_r   dimension from the gear axis over one ball, mm
//                                              theory: docs/theory/10-inspection.md
//
// The centre of the ball lies in the middle of the space. It also lies on the surface that is
// parallel to the flank at a distance of one ball radius.
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"

namespace gearwright {

struct BallSeat {
  double ball_diameter;          ///< D_M   mm
  double center_pressure_angle;  ///< α_Kt  rad
  double center_diameter;        ///< d_K   mm
  double contact_diameter;       ///< d_M   mm
  double contact_offset;         ///< mm, axial distance of the contacts from the centre of the ball
  double radial;  ///< M_r   mm, from the axis to the outer side of the ball (internal gear:
                  ///< to its inner side)
  ContactPlace place;

  bool usable() const { return place == ContactPlace::usable; }
};

/// The dimensions over pins or, for an internal gear, between pins.
struct PinReading {
  std::optional<double> two_free;    ///< mm, least dimension over two pins that can tilt, on a face
                                     ///< of any width
  std::optional<double> three;       ///< mm, dimension between parallel anvils over two pins, or
                                     ///< over three pins of a helical gear
  std::optional<double> three_pins;  ///< M_d3R mm, with one anvil on two neighbouring pins
  std::optional<double> two_free_face;  ///< mm, least face width that includes all contacts of two
                                        ///< pins that can tilt
};

/// Returns the ball or pin in a space of the gear, if it touches both flanks and can be measured. A
/// ball whose contacts lie below the usable flank or on the tip rounding is also returned, but is
/// not usable().
///
/// Formula   inv α_Kt = D_M/(d_b cos β_b) − η_b, [T10.6]; d_K = d_b/cos α_Kt, contacts [T10.7]
/// Errors    `ball_diameter` if the gear has no usable involute flank or fewer than two teeth, or
///           if the ball is too small or too large for the space, rests on the tips, touches the
///           root or does not project beyond the tips. The message gives the diameters that fit
/// Domain    ball_diameter > 0 (contract)
Result<BallSeat> ball_in_space(const Gear& gear, double ball_diameter);

/// Returns the dimension over two opposite balls in one transverse plane or, for an internal gear,
/// between these balls. [T10.8]
///
/// Domain    |z| ≥ 2 (contract)
double over_two_balls(const Gear& gear, const BallSeat& seat);
/// Returns the dimensions over pins, or none for an internal helical gear, in which a straight pin
/// does not fit.
///
/// Formula   two free pins: ε − tan² β_K sin ε = δ, [T10.9], face [T10.35]; parallel anvils on a
///           helical gear: d_K + D_M [T10.10]; on a spur gear: as over_two_balls(); three pins of a
///           spur gear with odd |z|: d_K cos² (π/2|z|) ± D_M [T10.30]
/// Domain    |z| ≥ 2 (contract)
PinReading over_pins(const Gear& gear, const BallSeat& seat);

/// Returns the diameter of the ball whose contacts are at `contact_diameter`, mm.
///
/// Formula   α_Kt + tan² β_b tan α_Kt = ξ_M/cos² β_b + σ η_b; [T10.11]
/// Domain    contact_diameter ≥ d_b (contract)
/// None      if the spaces have no width at this diameter, or if no ball touches both flanks there
std::optional<double> ball_touching_at(const Gear& gear, double contact_diameter);
/// Returns the transverse base tooth thickness, mm, for the dimension M_d over two balls. [T10.12]
///
/// None      if the centres of the balls would lie inside the base cylinder
std::optional<double> base_thickness_from_balls(const Gear& gear, double ball_diameter,
                                                double dimension);

struct BallSizes {
  double ideal;   ///< mm, with contacts at usual_contact_diameter()
  double metric;  ///< mm, the nearest size (DIN 3977) that can be measured; if there is none, the
                  ///< nearest size
  double inch;    ///< inch, a ball size in steps of 1/64, 1/32 or 1/16 inch
};
/// Returns the ball sizes of a gear. Returns none if no ball touches the usable flank, or if the
/// gear has fewer than two teeth.
std::optional<BallSizes> ball_sizes(const Gear& gear);

}  // namespace gearwright
