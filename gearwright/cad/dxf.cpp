#include "gearwright/cad/dxf.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/biarc_contour.hpp"
#include "gearwright/cad/contour.hpp"
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
  entities.closed_polyline(kProfile, polygon->points, polygon->bulges);
  return Facts{static_cast<int>(polygon->points.size()), polygon->deviation_mm};
}

Result<Facts> draw_splines(const Outline& outline, const Contour& contour, double tolerance,
                           DxfEntities& entities) {
  struct Fit {
    int degree;
    std::vector<double> knots;
    std::vector<double> knots_backwards;
    std::vector<Vec2> poles;
  };
  Facts facts;
  std::vector<Fit> fits(outline.arcs.size());
  const std::vector<bool> wanted = arcs_to_fit(outline, contour);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!wanted[i]) continue;
    const Arc& arc = outline.arcs[i];
    const auto complex = [](const Vec2& p) { return Complex(p.x(), p.y()); };
    const SectionSpline spline =
        fit_section(arc, complex(arc.begin_point), complex(arc.end_point), tolerance);
    if (!(spline.deviation_mm <= tolerance)) {
      return beyond_tolerance(arc, spline.deviation_mm, tolerance);
    }
    facts.deviation_mm = std::max(facts.deviation_mm, spline.deviation_mm);
    Fit& fit = fits[i];
    fit.degree = spline.basis.degree();
    fit.knots = spline.basis.knots();
    for (std::size_t k = fit.knots.size(); k-- > 0;) {
      fit.knots_backwards.push_back(1.0 - fit.knots[k]);
    }
    for (const Complex& c : spline.poles) fit.poles.emplace_back(c.real(), c.imag());
  }
  for (const ContourPiece& piece : contour.pieces) {
    if (piece.land) {
      entities.circular_spline(kProfile, piece.begin, piece.end, piece.sweep);
      continue;
    }
    const Fit& fit = fits[piece.arc];
    entities.spline(kProfile, fit.degree, piece.mirrored ? fit.knots : fit.knots_backwards,
                    placed(contour, piece, fit.poles));
  }
  facts.segments = static_cast<int>(contour.pieces.size());
  return facts;
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
    const auto contour = closed_contour(body.outline);
    if (!contour) return contour.error();
    const auto bore = bore_contour(body, contour->inner_radius, contour->outer_radius);
    if (!bore) return bore.error();
    if (bodies.size() > 1) entities.place(body.pose);
    const auto drawn = biarcs ? draw_biarcs(body.outline, *contour, tolerance, entities)
                              : draw_splines(body.outline, *contour, tolerance, entities);
    if (!drawn) return drawn.error();
    facts.segments += drawn->segments;
    facts.deviation_mm = std::max(facts.deviation_mm, drawn->deviation_mm);
    double radius = contour->outer_radius;
    if (const auto& b = *bore) {
      if (b->keyway) {
        entities.closed_polyline(kBore, b->points, b->bulges);
      } else {
        entities.circle(kBore, b->radius);
      }
      facts.segments += b->keyway ? static_cast<int>(b->points.size()) : 1;
      radius = std::max(radius, b->radius);
    }
    const double away = bodies.size() > 1 ? body.pose.translation().head<2>().norm() : 0.0;
    reach = std::max(reach, away + radius);
  }
  return Drawing{dxf_document(entities, {{kProfile, 7}, {kBore, 5}}, reach), facts.segments,
                 facts.deviation_mm, tolerance};
}

Result<Drawing> dxf_drawing(const ToothedBody& body, const ContourOptions& options) {
  return dxf_drawing(std::vector<ToothedBody>{body}, options);
}

}  // namespace gearwright
