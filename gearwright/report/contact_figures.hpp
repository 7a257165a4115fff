// The pictures of tooth contact: transmission error, flanks laid flat with what touches them, maps of
// two errors, and circular-arc teeth where they touch. Each figure is HTML.
//
//   ρ, a, b   radius of an arc and place of its centre, mm, as in pair/arc_contact.hpp
//   ψ_c       angle of the common normal to the pitch line, where the racks touch
//                                              theory: docs/theory/07-circular-arc.md, 7.1, 7.4
#pragma once

#include <string>
#include <vector>

#include "gearwright/report/contact_contour.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// A run of positions of one tooth pair, of edges or of flanks alone.
struct TeRun {
  int pair = 0;  ///< k
  bool edge = false;
  std::vector<double> rotation, te;  ///< rad; ends are shared with the neighbouring runs
};

/// The curve in runs, over one pitch as it is; positions without contact end a run. Where a tooth
/// pair hands over to the next, both curves are prolonged to where they cross, but not beyond the
/// greatest and the least value computed.
std::vector<TeRun> te_runs(const std::vector<ContactPoint>& positions);

/// Transmission error over the rotation of gear 1, with the tooth pairs and kinds of contact that make
/// it; of the non-working flanks a shorter caption.
std::string te_figure(const ContactReport& report, bool other_flanks);
/// Whether nothing but rounding is left of the waves.
bool waves_are_rounding(const std::vector<Angle>& waves);
/// Empty when contact is lost, for what does not repeat has no spectrum, and when there is no wave.
std::string te_spectrum_figure(const ContactReport& report);

/// A raster's nodes for contours; its gaps in mm.
ContourField field_of(const FlankRaster& raster);

/// Share of the flank that a pattern covers at this thickness of the marking, 0 … 1.
double pattern_share(const FlankRaster& raster, double marking);

/// One way of the contact point over a flank without a break: positions in the order in which a
/// tooth runs through them, of edges or of flanks alone.
struct PathPiece {
  bool edge = false;
  std::vector<const ContactPoint*> points;
};
std::vector<PathPiece> path_on_tooth(const ContactReport& report);

/// Both flanks with the marking pattern and the path of the contact point with its ellipses or lines.
std::string pattern_figures(const ContactReport& report);

/// The gap at the middle position, on gear 1; empty when nothing touches there.
std::string gap_figure(const ContactReport& report);

/// One small picture for each error alone, and one for all together; empty without errors.
std::string pattern_multiples(const ContactReport& report);

/// Round levels over the map's values, arc seconds, growing; few enough to tell apart.
std::vector<double> map_levels(const ErrorMap& map);

/// Peak to peak of the transmission error over two errors, as a field of steps.
///
/// Domain    a map (contract)
std::string map_figure(const ContactReport& report);

/// Half a tooth of the gear's rack in its normal section, from the middle of the space to the
/// middle of the tooth: (height over the datum line, distance from the middle of the tooth), mm,
/// cut off at the addendum, thinner by the allowance.
///
/// Domain    a gear with arcs (contract)
std::vector<Vec2> rack_half_tooth(const Gear& gear);

/// The plane across a tooth: x towards axis 2, y across the tooth, both from the contact point.
struct NormalPlane {
  Vec3 origin, across, along;  ///< `along` is normal to the plane
};
NormalPlane normal_plane(const ArcPair& pair, const ArcPairContact& contact);

/// Where gear i's flanks and roots cut that plane, one after the other over `teeth` teeth on both
/// sides of the one nearest; mm in the plane. Gears turned as at the contact.
std::vector<Vec2> normal_section(const ArcPair& pair, const ArcPairContact& contact, std::size_t i,
                                 int teeth);

/// The two racks that cut circular-arc teeth, in one normal section, and the teeth themselves in the
/// plane across the tooth through the contact point; empty when the arcs do not touch.
std::string arc_contact_figures(const ArcPair& pair);

}  // namespace gearwright
