#include "gearwright/cad/dxf.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/biarc.hpp"
#include "gearwright/cad/dxf_document.hpp"
#include "gearwright/cad/screw_spline.hpp"

namespace gearwright {
namespace {

constexpr const char* kProfile = "PROFILE";
constexpr const char* kBore = "BORE";

struct Facts {
  int segments = 0;
  double deviation_mm = 0.0;
};

Result<Facts> draw_biarcs(const Outline& outline, const Contour& contour, double tolerance,
                          DxfEntities& entities) {
  const auto polygon = biarc_contour(outline, contour, tolerance);
  if (!polygon) return polygon.error();
  entities.polyline(kProfile, polygon->points, polygon->bulges);
  return Facts{static_cast<int>(polygon->points.size()), polygon->deviation_mm};
}

Result<Facts> draw_splines(const Outline& outline, const Contour& contour, double tolerance,
                           DxfEntities& entities) {
  const auto fits = fit_arcs(outline, contour, tolerance, fit_section);
  if (!fits) return fits.error();
  for (const ContourPiece& piece : contour.pieces) {
    if (piece.land && piece.sweep == 0.0) {
      entities.line(kProfile, piece.begin, piece.end);
      continue;
    }
    if (piece.land) {
      entities.circular_spline(kProfile, piece.begin, piece.end, piece.sweep);
      continue;
    }
    const SectionSpline& fit = *fits->arcs[piece.arc];
    std::vector<double> knots = fit.basis.knots();
    if (!piece.mirrored) {  // the piece runs from tip to root, in the reverse direction of the fit
      std::reverse(knots.begin(), knots.end());
      for (double& knot : knots) knot = 1.0 - knot;
    }
    std::vector<Vec2> poles;
    for (const Complex& c : fit.poles) poles.emplace_back(c.real(), c.imag());
    entities.spline(kProfile, fit.basis.degree(), knots, placed(contour, piece, poles));
  }
  return Facts{static_cast<int>(contour.pieces.size()), fits->deviation_mm};
}

}  // namespace

Result<Drawing> dxf_drawing(const std::vector<ToothedBody>& bodies, const ContourOptions& options) {
  GW_EXPECTS(!bodies.empty());
  const bool biarcs = options.style == ContourOptions::Style::biarcs;
  const double tolerance =
      options.tolerance_mm.value_or(biarcs ? kBiarcTolerance_mm : kSplineTolerance_mm);
  GW_EXPECTS(tolerance > 0.0);
  DxfEntities entities;
  Facts facts;
  double reach = 0.0;
  for (const ToothedBody& body : bodies) {
    const auto contour = body_contour(body);
    if (!contour) return contour.error();
    if (bodies.size() > 1) entities.place(body.pose.plan());
    const auto drawn = biarcs ? draw_biarcs(body.outline, contour->teeth, tolerance, entities)
                              : draw_splines(body.outline, contour->teeth, tolerance, entities);
    if (!drawn) return drawn.error();
    facts.segments += drawn->segments;
    facts.deviation_mm = std::max(facts.deviation_mm, drawn->deviation_mm);
    if (const auto& b = contour->bore) {
      if (b->keyway) {
        entities.polyline(kBore, b->points, b->bulges);
      } else {
        entities.circle(kBore, b->radius);
      }
      facts.segments += b->keyway ? static_cast<int>(b->points.size()) : 1;
    }
    const double away = bodies.size() > 1 ? body.pose.origin().head<2>().norm() : 0.0;
    reach = std::max(reach, away + contour->reach());
  }
  return Drawing{dxf_document(entities, {{kProfile, 7}, {kBore, 5}}, reach), facts.segments,
                 facts.deviation_mm, tolerance};
}

Result<Drawing> dxf_drawing(const ToothedBody& body, const ContourOptions& options) {
  return dxf_drawing(std::vector<ToothedBody>{body}, options);
}

}  // namespace gearwright
