// What the drawings of a transverse section share: options, facts, and the bore's contour.
//
// A drawing is the section z = 0 in the gear frame, in millimetres; `body.pose` does not apply. It
// is returned as text with the numbers a program prints beside it ("320 segments, within 0.9 µm").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

struct ContourOptions {
  enum class Style {
    biarcs,   ///< true circular arcs only: one closed polyline, for laser and wire cutting
    splines,  ///< one B-spline per arc of the outline, lands as circles: for CAD
  };
  Style style = Style::biarcs;
  /// Normal distance allowed; absent: the default of the style.
  std::optional<double> tolerance_mm = std::nullopt;
};

/// A tenth of the finest tolerance of cut parts, a few µm; wire cutting machines resolve 1 µm or
/// so.
inline constexpr double kBiarcTolerance_mm = 0.001;
/// A drawing that is measured in CAD agrees in all digits that CAD shows.
inline constexpr double kSplineTolerance_mm = 1e-6;
/// A tenth of what a plotter or a browser at the greatest zoom resolves.
inline constexpr double kSvgTolerance_mm = 1e-4;

struct Drawing {
  std::string text;  ///< the file
  int segments;      ///< arcs, lines, splines and Bézier pieces of profile and bore together
  double
      deviation_mm;  ///< greatest normal distance measured between the drawing and the exact curve
  double tolerance_mm;  ///< what was allowed
};

/// The bore, or the rim of an internal gear, as a closed chain of arcs and lines,
/// counter-clockwise.
struct BoreContour {
  double radius;               ///< r  mm
  bool keyway;                 ///< false: the whole circle
  std::vector<Vec2> points;    ///< mm; two of a whole circle
  std::vector<double> bulges;  ///< tan(sweep/4); bulges[i] leads from points[i] to the next
};

/// None without a bore.
///
/// Facts     refused as make_walls refuses them (cad/walls.hpp): a bore or keyway that leaves the
///           root, an internal gear's rim that does not go round it
/// Units     inner, outer: extreme radii of the outline, mm
Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer);

/// The reason why an arc could not be drawn as closely as was asked.
Error beyond_tolerance(const Arc& arc, double deviation_mm, double tolerance_mm);

}  // namespace gearwright
