// Definitions shared by all drawings of a transverse section. A drawing of one body shows the
// section z = 0 in the gear frame, in millimetres. `body.pose` has no effect on such a drawing.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/bore_loop.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {

struct ContourOptions {
  enum class Style {
    biarcs,   ///< true circular arcs in one closed polyline, for laser and wire cutting
    splines,  ///< one B-spline per arc of the outline and exact circular arcs for lands, for CAD
  };
  Style style = Style::biarcs;
  /// Permitted normal distance from the exact curve. If it is absent, the default of the drawing
  /// style applies.
  std::optional<double> tolerance_mm = std::nullopt;
};

/// Wire cutting machines resolve about 1 µm. The finest tolerances of cut parts are a few µm.
inline constexpr double kBiarcTolerance_mm = 0.001;
/// With this tolerance, dimensions measured in a CAD system are correct in all displayed digits.
inline constexpr double kSplineTolerance_mm = 1e-6;
/// This tolerance is a tenth of the resolution of a plotter, and of a browser at the greatest zoom.
inline constexpr double kSvgTolerance_mm = 1e-4;

struct Drawing {
  std::string text;     ///< text of the file
  int segments;         ///< number of arcs, lines, splines and Bézier pieces of profile and bore
  double deviation_mm;  ///< greatest normal distance measured from the exact curve
  double tolerance_mm;  ///< permitted distance
};

struct BodyContour {
  Contour teeth;
  std::optional<BoreContour> bore;

  double reach() const {
    return bore ? std::max(teeth.outer_radius, bore->radius) : teeth.outer_radius;
  }
};

/// Errors    those of closed_contour and bore_contour
Result<BodyContour> body_contour(const ToothedBody& body);

Error beyond_tolerance(const Arc& arc, double deviation_mm, double tolerance_mm);

/// A fit for each arc of the outline that is not a land. All teeth share these fits.
template <class Fit>
struct ArcFits {
  std::vector<std::optional<Fit>> arcs;  ///< same index as Outline::arcs
  double deviation_mm = 0.0;             ///< greatest deviation of all fits
};

/// Fits each arc with `fit(arc, tolerance)`. The type `Fit` must have a member `deviation_mm`.
///
/// Errors    `tolerance_mm` if an arc cannot be fitted within this tolerance
template <class Fit>
Result<ArcFits<Fit>> fit_arcs(const Outline& outline, const Contour& contour, double tolerance_mm,
                              Fit (*fit)(const Arc&, double)) {
  std::vector<bool> wanted(outline.arcs.size(), false);
  for (const ContourPiece& piece : contour.pieces) {
    if (!piece.land) wanted[piece.arc] = true;
  }
  ArcFits<Fit> fits{std::vector<std::optional<Fit>>(wanted.size())};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i]) continue;
    fits.arcs[i] = fit(outline.arcs[i], tolerance_mm);
    const double deviation = fits.arcs[i]->deviation_mm;
    if (!(deviation <= tolerance_mm))
      return beyond_tolerance(outline.arcs[i], deviation, tolerance_mm);
    fits.deviation_mm = std::max(fits.deviation_mm, deviation);
  }
  return fits;
}

}  // namespace gearwright
