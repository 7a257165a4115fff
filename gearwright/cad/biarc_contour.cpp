#include "gearwright/cad/biarc_contour.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gearwright/cad/biarc.hpp"
#include "gearwright/cad/drawing.hpp"

namespace gearwright {

std::vector<bool> arcs_to_fit(const Outline& outline, const Contour& contour) {
  std::vector<bool> wanted(outline.arcs.size(), false);
  for (const ContourPiece& piece : contour.pieces) {
    if (!piece.land) wanted[piece.arc] = true;
  }
  return wanted;
}

// Mirroring turns a bulge over, and so does running it backwards: pieces do one or the other.
Result<BiarcContour> biarc_contour(const Outline& outline, const Contour& contour,
                                   double tolerance_mm) {
  BiarcContour result{{}, {}, 0.0};
  std::vector<std::optional<BiarcChain>> chains(outline.arcs.size());
  const std::vector<bool> wanted = arcs_to_fit(outline, contour);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (!wanted[i]) continue;
    chains[i] = fit_biarcs(outline.arcs[i], tolerance_mm);
    const double deviation = chains[i]->deviation_mm;
    if (!(deviation <= tolerance_mm))
      return beyond_tolerance(outline.arcs[i], deviation, tolerance_mm);
    result.deviation_mm = std::max(result.deviation_mm, deviation);
  }
  for (const ContourPiece& piece : contour.pieces) {
    if (piece.land) {
      result.points.push_back(piece.begin);
      result.bulges.push_back(std::tan(piece.sweep / 4.0));
      continue;
    }
    const BiarcChain& chain = *chains[piece.arc];
    const std::vector<Vec2> here = placed(contour, piece, chain.points);
    result.points.insert(result.points.end(), here.begin(), here.end() - 1);
    const std::size_t n = chain.bulges.size();
    for (std::size_t i = 0; i < n; ++i)
      result.bulges.push_back(-chain.bulges[piece.mirrored ? i : n - 1 - i]);
  }
  return result;
}

}  // namespace gearwright
