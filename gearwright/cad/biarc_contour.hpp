// The closed outline of the whole gear in true circular arcs: one chain of points and bulges.
#pragma once

#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {

struct BiarcContour {
  std::vector<Vec2> points;    ///< mm, counter-clockwise
  std::vector<double> bulges;  ///< tan(sweep/4); bulges[i] leads from points[i] to the next, the
                               ///< last one to the first
  double deviation_mm;         ///< greatest normal distance measured from the exact outline
};

/// Arcs of the outline that make pieces of other kind than lands.
std::vector<bool> arcs_to_fit(const Outline& outline, const Contour& contour);

/// Lands are one arc each, the other pieces the biarcs of their arc, fitted once for all teeth.
///
/// Facts     `tolerance_mm`: an arc that does not meet it
/// Domain    tolerance_mm > 0 (contract)
Result<BiarcContour> biarc_contour(const Outline& outline, const Contour& contour,
                                   double tolerance_mm);

}  // namespace gearwright
