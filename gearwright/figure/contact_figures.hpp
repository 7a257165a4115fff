// The figures of tooth contact: transmission error, its spectrum, flanks laid flat with what touches
// them, and maps of two errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/figure/contour.hpp"
#include "gearwright/figure/figure.hpp"

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
/// it. `result` is the scene's own, or that of the non-working flanks; none where nothing touches.
std::optional<Figure> transmission_error_figure(const ContactScene& scene,
                                                const ContactResult& result);
/// Whether nothing but rounding is left of the waves.
bool waves_are_rounding(const std::vector<Angle>& waves);
/// None when contact is lost, for what does not repeat has no spectrum, and when there is no wave.
std::optional<Figure> spectrum_figure(const ContactResult& result);

/// A raster's nodes for contours; its gaps in mm.
ContourField field_of(const FlankRaster& raster);
/// The regions of a raster's field below a level, in heights along the face and diameters, mm.
std::vector<Vec2> region_below(const FlankRaster& raster, const ContourField& field, double level);

/// Share of the flank that a pattern covers at this thickness of the marking, 0 … 1.
double pattern_share(const FlankRaster& raster, double marking);

/// One path of the contact point over a flank without a break: positions in the order in which a
/// tooth runs through them, of edges or of flanks alone.
struct PathPiece {
  bool edge = false;
  std::vector<const ContactPoint*> points;
};
std::vector<PathPiece> path_on_tooth(const ContactScene& scene);

/// An empty flank laid flat: along the face to the right, the root below, the tip above, with the
/// limits of its usable part and some of the tooth beyond them.
Figure flank_frame(std::string id, std::string title, const FlankRaster& extent, bool internal,
                   std::size_t which);

/// What lies on a flank; what is null is left out.
struct FlankLayers {
  const FlankRaster* pattern = nullptr;  ///< least gap over a mesh
  const FlankRaster* gap = nullptr;      ///< at one position
  const ContactPoint* now = nullptr;     ///< that position
  bool way = true;                       ///< of the contact point, with its ellipses or lines
};
/// The flank of gear `which` (0, 1).
///
/// Domain    a pattern or a gap (contract)
Figure flank_figure(const ContactScene& scene, std::size_t which, const FlankLayers& layers);

/// A small flank of gear 1 with the marking alone.
Figure small_pattern(std::string id, std::string title, const FlankRaster& pattern, double marking);

/// Peak to peak over two errors.
struct ContactMap {
  ErrorMap map;                     ///< rad over the units below
  std::array<NamedAmount, 2> axes;  ///< of x and y: names, units and the values of the spec
  bool whole = true;                ///< false: values are missing that are not yet computed
};
/// Round levels over the map's values, arc seconds, growing; few enough to tell apart.
std::vector<double> map_levels(const ErrorMap& map);
/// Peak to peak of the transmission error over two errors, as a field of steps.
Figure error_map_figure(const ContactMap& map);

}  // namespace gearwright
