// Balls and pins in the tooth spaces of a gear: their contacts, and the dimensions over or between
// them.
//
//   D_M    diameter of ball or pin, mm         α_Kt  transverse pressure angle at its centre, rad
//   d_K    diameter of its centre, mm          d_M   diameter of the contacts, mm
//   η_b    half angle of the space on the base cylinder, rad: π/|z| ∓ … [T10.5]
//   M_d, M_r   over two balls, over one from the axis, mm
//                                              theory: docs/theory/10-inspection.md
//
// The centre of the ball lies where the involute helicoid of the flank, offset along its normal by
// the radius of the ball, meets the middle of the space.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/usable_flank.hpp"

namespace gearwright {

/// A ball that touches both flanks of a space.
struct BallSeat {
  double ball_diameter;          ///< D_M   mm
  double center_pressure_angle;  ///< α_Kt  rad
  double center_diameter;        ///< d_K   mm
  double contact_diameter;       ///< d_M   mm
  double contact_offset;  ///< mm, distance of the contacts before and behind the ball's centre
  double radial;          ///< M_r   mm, from the axis over the ball, or to its inner side in an
                          ///< internal gear
  ContactPlace place;

  bool usable() const { return place == ContactPlace::usable; }
};

/// The dimension over two pins, or between them in an internal gear.
struct PinReading {
  std::optional<double> two_free;    ///< mm, least dimension over two pins that may tilt
  std::optional<double> three;       ///< mm, two pins between parallel anvils (helical: or three)
  std::optional<double> three_pins;  ///< M_d3R mm, an anvil on two neighbours, the other on one
};

/// The ball or pin in a space of the gear, if it touches both flanks and can be measured.
///
/// Formula   inv α_Kt = D_M/(d_b cos β_b) − η_b, [T10.6]; d_K = d_b/cos α_Kt, contacts [T10.7]
/// Errors    `ball_diameter` if the ball falls between the teeth, rests on the tips or does not
///           project beyond them, with the diameters that fit
Result<BallSeat> ball_in_space(const Gear& gear, double ball_diameter);

/// The dimension over two opposite balls in one transverse plane, or between them in an internal
/// gear. [T10.8]
///
/// Domain    |z| ≥ 2 (contract): one space has no opposite one
double over_two_balls(const Gear& gear, const BallSeat& seat);

/// The dimensions over pins; none for an internal helical gear, into which a straight pin does not
/// fit.
///
/// Formula   two free pins: ε − tan² β_K sin ε = δ, [T10.9]; parallel anvils: d_K ± D_M [T10.10];
///           three pins of a spur gear with odd |z|: d_K cos² (π/2|z|) ± D_M [T10.30]
/// Domain    |z| ≥ 2 (contract)
PinReading over_pins(const Gear& gear, const BallSeat& seat);

/// The ball whose contacts are at that diameter.
///
/// Formula   α_Kt + tan² β_b tan α_Kt = ξ_M/cos² β_b + σ η_b; [T10.11]
/// Domain    contact_diameter ≥ d_b (contract)
/// None      the flanks of a space meet before that diameter
std::optional<double> ball_touching_at(const Gear& gear, double contact_diameter);

/// The transverse base tooth thickness of a gear that measures M_d over balls. [T10.12]
/// None      the balls would lie inside the base cylinder
std::optional<double> base_thickness_from_balls(const Gear& gear, double ball_diameter,
                                                double dimension);

/// The ideal ball and the standard balls and pins nearest to it.
struct BallSizes {
  double ideal;   ///< mm, touches at the usual diameter
  double metric;  ///< mm, sizes of gear measuring pins (DIN 3977)
  double inch;    ///< in, balls by 1/64, 1/32 and 1/16 in
};

/// None if no ball can be measured.
std::optional<BallSizes> ball_sizes(const Gear& gear);

}  // namespace gearwright
