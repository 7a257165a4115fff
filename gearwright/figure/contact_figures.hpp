// Makes the figures of tooth contact.
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

/// Successive positions at which the same tooth pair is in contact. The contact is either always at
/// an edge or always within the flanks.
struct TeRun {
  int pair = 0;  ///< k, number of the tooth pair
  bool edge = false;
  std::vector<double> rotation, te;  ///< rad; neighbouring runs share their ends
};

/// Divides the curve of successive positions into runs. A position without contact ends a run.
/// Where the next tooth pair takes over, the curves of both pairs are extended to their
/// intersection, or halfway if they do not intersect between the two positions. The value there is
/// limited to the range of the computed values.
std::vector<TeRun> te_runs(const std::vector<ContactPoint>& positions);

/// Draws the transmission error over the rotation of gear 1, with the tooth pairs and kinds of
/// contact. `result` is scene.driving, or the result of the non-working flanks. There is no figure
/// if no position has contact.
std::optional<Figure> transmission_error_figure(const ContactScene& scene,
                                                const ContactResult& result);
/// Returns true if all harmonics are rounding errors.
bool waves_are_rounding(const std::vector<Angle>& waves);
/// Draws the harmonics of the transmission error. There is no figure if all harmonics are rounding
/// errors. If contact is lost, the curve is not periodic, so there are no harmonics and no figure.
std::optional<Figure> spectrum_figure(const ContactResult& result);

/// Returns the gaps of a raster, mm, as a field for contours.
ContourField field_of(const FlankRaster& raster);
/// Returns the regions of a raster in which the field is below a level. The points are (axial
/// position, diameter), mm, with kNewPiece between two loops.
std::vector<Vec2> region_below(const FlankRaster& raster, const ContourField& field, double level);
/// Returns the range of step i of a map as text, for example "10 µm to 20 µm". Step 0 is the lowest
/// step. The text is empty if the map has only one step.
std::string step_words(const std::vector<double>& levels, std::size_t i, std::string_view unit);
/// Adds the values of a raster to a figure. The figure shows shaded steps between the levels, and
/// the values themselves are stored in Figure::grid. If `above` is given, values at or below
/// `above` are not shaded.
void add_map(Figure& f, const FlankRaster& raster, const std::vector<double>& levels,
             std::string words, std::string unit, std::optional<double> above = {});

/// Returns the share of the flank, 0 … 1, that a pattern covers at this thickness of the marking
/// compound.
double pattern_share(const FlankRaster& raster, double marking);

/// A continuous piece of the path of the contact point over a flank. The points are in the
/// order in which a tooth passes them. Either all points are contacts at edges, or all are
/// contacts of the flanks.
struct PathPiece {
  bool edge = false;
  std::vector<const ContactPoint*> points;
};
std::vector<PathPiece> path_on_tooth(const ContactScene& scene);

/// Removes the names of the tip and root diameters beside the plot of flank_frame(), because the key
/// of shades has the same place.
void remove_diameters(Figure& figure);

/// Draws an empty developed flank. The face runs from left to right, the root is at the bottom and
/// the tip is at the top. The figure shows the limits of the usable flank and a little of the tooth
/// beyond these limits. `side` is the side σ of the gear.
Figure flank_frame(std::string id, std::string title, const FlankRaster& extent, double side,
                   std::size_t which);

/// The layers drawn on a flank. A null layer is omitted.
struct FlankLayers {
  const FlankRaster* pattern = nullptr;  ///< least gap during a mesh
  const FlankRaster* gap = nullptr;      ///< gap at one position
  const ContactPoint* now = nullptr;     ///< contact at the position of `gap`
  bool way = true;  ///< true to draw the path of the contact point, with contact ellipses or
                    ///< contact lines
};
/// Draws the flank of gear `which` (0, 1).
///
/// Domain    a pattern or a gap (contract)
Figure flank_figure(const ContactScene& scene, std::size_t which, const FlankLayers& layers);

/// Draws a small flank of gear 1 that shows only the marking.
Figure small_pattern(std::string id, std::string title, const FlankRaster& pattern, double marking);

/// Peak-to-peak transmission error as a function of two errors of mounting.
struct ContactMap {
  ErrorMap map;                     ///< rad, over two errors in the units of `axes`
  std::array<NamedAmount, 2> axes;  ///< x and y: names, units and the values of the spec
  bool whole = true;                ///< false if some values have not yet been computed
};
/// Returns the levels of the contour lines, arc seconds, in ascending order. They are round numbers
/// within the range of the map, and few enough to be distinguished.
std::vector<double> map_levels(const ErrorMap& map);
Figure error_map_figure(const ContactMap& map);

}  // namespace gearwright
