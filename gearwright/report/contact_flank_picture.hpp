// Flanks laid flat: along the face to the right, from the root at the bottom to the tip at the top.
// On them the marking pattern, the path of the contact point with its ellipses or lines, and the
// gap between the flanks at one position.
#pragma once

#include <string>
#include <vector>

#include "gearwright/report/contact_contour.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

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

/// The two figures with the patterns.
std::string pattern_figures(const ContactReport& report);

/// The gap at the middle position, on gear 1; empty when nothing touches there.
std::string gap_figure(const ContactReport& report);

/// One small picture for each error alone, and one for all together; empty without errors.
std::string pattern_multiples(const ContactReport& report);

}  // namespace gearwright
