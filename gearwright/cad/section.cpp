#include "gearwright/cad/section.hpp"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

constexpr std::size_t kNodes = 16;
constexpr int kMaxPanels = 64;
// The integral has converged if its relative change is below this value. The rounding error of the
// sum over one panel is smaller, about 1e-14.
constexpr double kStandsStill = 1e-13;

struct Rule {
  std::array<double, kNodes> node;    // in [−1, 1]
  std::array<double, kNodes> weight;  // weights of the quadrature
  std::array<std::array<double, kNodes>, kNodes> derivative;
};

// The barycentric weights of Gauss nodes are (−1)^j √((1 − x_j²) w_j). The derivative matrix of the
// interpolant follows from them (Berrut, Trefethen, SIAM Review 46 (2004), Eqs. 9.4, 9.5).
Rule make_rule() {
  using Gauss = boost::math::quadrature::gauss<double, kNodes>;
  Rule rule{};
  for (std::size_t i = 0; i < kNodes / 2; ++i) {
    const double x = Gauss::abscissa()[i];
    rule.node[kNodes / 2 + i] = x;
    rule.node[kNodes / 2 - 1 - i] = -x;
    rule.weight[kNodes / 2 + i] = rule.weight[kNodes / 2 - 1 - i] = Gauss::weights()[i];
  }
  std::array<double, kNodes> bary{};
  for (std::size_t j = 0; j < kNodes; ++j) {
    bary[j] = std::sqrt((1.0 - rule.node[j] * rule.node[j]) * rule.weight[j]);
    if (j % 2 == 1) bary[j] = -bary[j];
  }
  for (std::size_t i = 0; i < kNodes; ++i) {
    double diagonal = 0.0;
    for (std::size_t j = 0; j < kNodes; ++j) {
      if (j == i) continue;
      rule.derivative[i][j] = bary[j] / bary[i] / (rule.node[i] - rule.node[j]);
      diagonal -= rule.derivative[i][j];
    }
    rule.derivative[i][i] = diagonal;
  }
  return rule;
}

// Returns ½ ∫ (x dy − y dx) over u in [u0, u1].
double panel_area(const Rule& rule, const Arc& arc, double u0, double u1) {
  std::array<Vec2, kNodes> p;
  for (std::size_t i = 0; i < kNodes; ++i) {
    p[i] = arc.point(0.5 * (u0 + u1) + 0.5 * (u1 - u0) * rule.node[i]);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes; ++i) {
    Vec2 d = Vec2::Zero();
    // The constant part p_i has no derivative and is subtracted to avoid cancellation.
    for (std::size_t j = 0; j < kNodes; ++j) d += rule.derivative[i][j] * (p[j] - p[i]);
    sum += rule.weight[i] * (p[i].x() * d.y() - p[i].y() * d.x());
  }
  return 0.5 * sum;
}

double arc_area(const Rule& rule, const Arc& arc) {
  double previous = panel_area(rule, arc, 0.0, 1.0);
  for (int panels = 2; panels <= kMaxPanels; panels *= 2) {
    double sum = 0.0;
    for (int i = 0; i < panels; ++i) {
      sum += panel_area(rule, arc, static_cast<double>(i) / panels,
                        static_cast<double>(i + 1) / panels);
    }
    const bool stands_still = std::abs(sum - previous) <= kStandsStill * std::abs(sum);
    previous = sum;
    if (stands_still) break;
  }
  return previous;
}

}  // namespace

double section_area(const Outline& outline) {
  GW_EXPECTS(outline.teeth != 0);
  GW_EXPECTS(!outline.arcs.empty());
  static const Rule rule = make_rule();
  double half = 0.0;
  // From root to tip, the half outline runs clockwise about the axis.
  for (const Arc& arc : outline.arcs) half -= arc_area(rule, arc);
  return 2.0 * std::abs(outline.teeth) * half;
}

double bore_area(const Bore& bore) {
  const double r = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  GW_EXPECTS(bore.keyway_width >= 0.0 && half < r && bore.keyway_depth >= 0.0);
  const double below = half * std::sqrt((r - half) * (r + half)) + r * r * std::asin(half / r);
  return std::numbers::pi * r * r + bore.keyway_width * (r + bore.keyway_depth) - below;
}

double metal_area(const ToothedBody& body) {
  if (body.rack) {
    // ∫ x dy over the half outline is the signed area between the outline and the datum line. The
    // area between this line and the back is a rectangle. If one end of the bar cuts off a part of
    // a tooth, an equal part is added at the other end, so every section has the same area.
    static const Rule rule = make_rule();
    double half = 0.0;
    for (const Arc& arc : body.outline.arcs) {
      const Vec2 a = arc.begin_point, b = arc.end_point;
      half += 0.5 * (a.x() * a.y() - b.x() * b.y()) - arc_area(rule, arc);
    }
    return body.outline.teeth * (2.0 * half + body.rack->pitch * body.rack->height);
  }
  const bool ring = body.ring();
  GW_EXPECTS(!ring || body.bore.has_value());
  const double outline = section_area(body.outline);
  if (!body.bore) return outline;
  return ring ? bore_area(*body.bore) - outline : outline - bore_area(*body.bore);
}

namespace {

double gear_volume(const ToothedBody& gear) {
  const double toothed = metal_area(gear) * gear.face_width;
  if (!gear.grooved()) return toothed;
  const auto& [gap, radius, stagger] = *gear.two_helices;
  const double removed = section_area(gear.outline) - std::numbers::pi * radius * radius;
  return toothed - std::abs(removed) * gap;
}

}  // namespace

double metal_volume(const ToothedBody& body) {
  const std::vector<SolidGear> gears = body.gears();
  double volume = gear_volume(body);
  for (std::size_t i = 1; i < gears.size(); ++i) {
    const double neck = gears[i].body->neck;
    const double metal = std::numbers::pi * neck * neck - (body.bore ? bore_area(*body.bore) : 0.0);
    volume += gear_volume(*gears[i].body) + metal * (gears[i].bottom() - gears[i - 1].top());
  }
  return volume;
}

}  // namespace gearwright
