// The swept rack computes the result of cutting a blank by a rack cutter, as the least distance
// over all positions of the cutter. It uses no envelope formula, no contact point and no code of
// the engine.
//
//   z, m       tooth number, normal module         β, α   helix angle, normal pressure angle
//   r          reference radius z m/(2 cos β)      x m    height of the datum line above r
//   φ          roll angle: the gear turns by φ, the rack moves by r φ along the pitch line
//   (ρ, θ)     the point of the gear, polar; tooth 0 is centred on θ = 0
//   ψ = θ + φ  polar angle of the point after the gear has turned
//   h, w       the point in the frame of the cutter, normal section: height above the datum line,
//              and position along it from the middle of a space of the cutter,
//                h = ρ cos ψ − r − x m,   w = (ρ sin ψ − r φ) cos β
//   u          distance from the middle of the nearest cutter tooth, 0 … P
//   P          half a pitch of the normal section, π m/2
//
// The metric.  The teeth of a rack are cylinders along their own direction, so the spatial distance
// of a point from the cutter is the plane distance in the normal section (h, w). All distances here
// are of that kind, computed exactly from lines and circles. In the transverse section, the cutter
// is stretched by 1/cos β along the pitch line, and the plane distance there is between 1 and 1/cos
// β times ours.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace gearwright::oracle {

struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

/// The data of the cutter and the gear. Lengths with a star are in units of m, angles in rad.
struct RackNumbers {
  int teeth = 0;                       ///< z ≥ 1
  double normal_module = 1.0;          ///< m  mm
  double normal_pressure_angle = 0.0;  ///< α  rad, 0 < α < π/2
  double helix_angle = 0.0;            ///< β  rad; its sign has no effect
  double profile_shift = 0.0;          ///< x
  double addendum = 1.0;               ///< h_A*  used only by `tip_fillet_radius`
  double dedendum = 1.25;              ///< h_F*  depth of the cutter below the datum line
  double root_fillet_radius = 0.0;     ///< ρ*  the cutter's tip rounding
  double protuberance = 0.0;           ///< pr*  normal to the flank
  double protuberance_angle = 0.0;     ///< α_pr  rad, 0 ≤ α_pr < α; used only if pr* > 0
  double tip_fillet_radius = 0.0;      ///< ρ_1*  the cutter's bottom rounding
  /// Height at which the straight flank ends. If it is absent, the flank has no end for ρ_1* = 0;
  /// otherwise the bottom land lies at h_A*. If it is given without a rounding or a ramp, the
  /// bottom land lies at this height.
  std::optional<double> tool_addendum = std::nullopt;
  /// α_st  rad, α < α_st < π/2: angle of a ramp that begins at tool_addendum and replaces the
  /// bottom rounding.
  std::optional<double> semi_topping_angle = std::nullopt;
  double tip_radius = std::numeric_limits<double>::infinity();  ///< r_a  mm, the blank
};

class SweptRack {
 public:
  /// Throws    std::invalid_argument that names the value for which the cutter is impossible
  explicit SweptRack(const RackNumbers& numbers);

  const RackNumbers& numbers() const { return numbers_; }
  double reference_radius() const { return r_; }  ///< r  mm
  double base_radius() const { return r_b_; }     ///< r cos α_t  mm
  double deepest_radius() const { return r_f_; }  ///< r + m (x − h_F*)  mm, signed

  /// Signed distance from a point in the normal section of the cutter to the cutter's edge, > 0
  /// outside.
  /// Units     h, w, result mm
  /// Accuracy  a few ulp of max(|h|, P); w is first reduced by whole pitches
  double distance_to_cutter(double h, double w) const;

  /// Distance of the gear's point p from the cutter at one roll angle. `clearance` minimises it,
  /// and a plain scan needs only this.
  double gap_at(PlanePoint p, double roll) const;

  /// Minimum over all roll angles of the distance from p to the cutter. The blank has no effect.
  ///   > 0 material left, by so much     = 0 on the finished surface     < 0 cut away
  /// Units     p in mm, gear frame, transverse section; result mm in the metric of the file's head
  /// Accuracy  results ≥ 0: 1e-12 mm for ρ ≤ 500 mm, and no position can have been missed (see the
  ///           source). Results < 0: the depth of a local minimum, the deepest one of a scan. They
  ///           are never deeper than the true minimum, and never on the wrong side by more than
  ///           1e-12 mm
  double clearance(PlanePoint p) const;

 private:
  struct Segment {
    double u, h, du, dh, length;  ///< start, unit direction (zero length: any direction)
  };
  struct Arc {
    double u, h, radius;    ///< centre
    double u0, h0, u1, h1;  ///< directions of its ends, counter-clockwise in (u, h)
  };
  struct Search;

  double edge_height(double u) const;

  RackNumbers numbers_;
  double r_, r_b_, r_f_;     // mm
  double cos_beta_, shift_;  // x m in mm
  double half_pitch_;        // P
  // The values of u at which the formula of the edge h(u) changes, in ascending order: tip land,
  // tip rounding, protuberance, main flank, and then either bottom rounding and bottom land, or the
  // ramp.
  double u_land_, u_round_, u_protuberance_, u_flank_, u_bottom_;
  std::vector<Segment> segments_;
  std::vector<Arc> arcs_;            // [0] tip rounding, [1] bottom rounding if there is one
  std::vector<double> line_angles_;  // pressure angles of the straight parts
};

}  // namespace gearwright::oracle
