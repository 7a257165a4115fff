#include "gearwright/cad/svg_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/cad/fitting.hpp"
#include "gearwright/curve/arc_length.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {
namespace {

constexpr double kMarginShare = 0.05;  // of the radius, so that the stroke is not cut off

// Writes the d attribute of a path. Only this class reverses y.
class Path {
 public:
  explicit Path(const Eigen::Isometry2d& pose) : pose_(pose) {}
  void move(const Vec2& at) {
    const Vec2 p = pose_ * at;
    add("M{} {}", p.x(), -p.y());
  }
  void line(const Vec2& at) {
    const Vec2 p = pose_ * at;
    add("L{} {}", p.x(), -p.y());
  }
  // On the screen, a counter-clockwise arc remains counter-clockwise, so the sweep flag is 0.
  void arc(double radius, double sweep, const Vec2& at) {
    const Vec2 p = pose_ * at;
    add("A{0} {0} 0 {1} 0 {2} {3}", radius, sweep > std::numbers::pi ? 1 : 0, p.x(), -p.y());
  }
  void cubic(const Vec2& at_a, const Vec2& at_b, const Vec2& at_c) {
    const Vec2 a = pose_ * at_a;
    const Vec2 b = pose_ * at_b;
    const Vec2 c = pose_ * at_c;
    add("C{} {} {} {} {} {}", a.x(), -a.y(), b.x(), -b.y(), c.x(), -c.y());
  }
  Vec2 on_screen(const Vec2& at) const { return mirrored(pose_ * at); }
  void close() { text_ += "Z\n"; }
  const std::string& text() const { return text_; }

 private:
  // rounds to 1e-10 mm
  static std::string shorter(double value) { return short_decimals(value, 10); }
  static int shorter(int value) { return value; }
  template <class... T>
  void add(const char* form, T... values) {
    text_ += fmt::format(fmt::runtime(form), shorter(values)...);
    text_ += '\n';
  }

  Eigen::Isometry2d pose_;
  std::string text_;
};

struct DrawnBody {
  std::string path;
  int segments = 0;
  double deviation = 0.0;
  double radius = 0.0;
  // box of a rack, with y reversed; none if the outline lies within a circle
  std::optional<Eigen::AlignedBox2d> box{};
};

Result<DrawnBody> draw(const ToothedBody& body, const SvgOptions& options, bool in_place) {
  const auto contour = body_contour(body);
  if (!contour) return contour.error();
  const auto fits = fit_arcs(body.outline, contour->teeth, options.tolerance_mm, fit_beziers);
  if (!fits) return fits.error();

  int segments = 0;
  Path path(in_place ? body.pose.plan() : SolidPose().plan());
  path.move(contour->teeth.pieces.front().begin);
  for (const ContourPiece& piece : contour->teeth.pieces) {
    if (piece.land && piece.sweep == 0.0) {
      path.line(piece.end);
      ++segments;
      continue;
    }
    if (piece.land) {
      path.arc(piece.begin.norm(), piece.sweep, piece.end);
      ++segments;
      continue;
    }
    const std::vector<Vec2> p = placed(contour->teeth, piece, fits->arcs[piece.arc]->points);
    for (std::size_t i = 1; i < p.size(); i += 3) path.cubic(p[i], p[i + 1], p[i + 2]);
    segments += static_cast<int>(p.size() / 3);
  }
  path.close();

  if (const auto& b = contour->bore) {
    path.move(b->points.front());
    for (std::size_t i = 0; i < b->points.size(); ++i) {
      const Vec2& to = b->points[(i + 1) % b->points.size()];
      if (b->bulges[i] == 0.0) {
        path.line(to);
      } else {
        path.arc(b->radius, 4.0 * std::atan(b->bulges[i]), to);
      }
    }
    path.close();
    segments += static_cast<int>(b->points.size());
  }

  DrawnBody drawn{path.text(), segments, fits->deviation_mm, contour->reach()};
  if (body.rack) {
    drawn.box.emplace();
    for (const ContourPiece& piece : contour->teeth.pieces)
      drawn.box->extend(path.on_screen(piece.begin));
  }
  return drawn;
}

}  // namespace

Result<Drawing> svg_drawing(const std::vector<ToothedBody>& bodies, const SvgOptions& options) {
  GW_EXPECTS(!bodies.empty());
  GW_EXPECTS(options.tolerance_mm > 0.0);
  const bool in_place = bodies.size() > 1;
  Drawing drawing{{}, 0, 0.0, options.tolerance_mm};
  std::string paths;
  Eigen::AlignedBox2d box;  // with y reversed, as on the screen
  double margin = 0.0;
  for (const ToothedBody& body : bodies) {
    const auto drawn = draw(body, options, in_place);
    if (!drawn) return drawn.error();
    drawing.segments += drawn->segments;
    drawing.deviation_mm = std::max(drawing.deviation_mm, drawn->deviation);
    const Vec2 center = in_place ? mirrored(body.pose.origin().head<2>()) : Vec2(Vec2::Zero());
    margin = std::max(margin, kMarginShare * drawn->radius);
    if (drawn->box) {
      box.extend(*drawn->box);
    } else {
      box.extend(center - Vec2::Constant(drawn->radius));
      box.extend(center + Vec2::Constant(drawn->radius));
    }
    paths += fmt::format(
        "<path fill=\"#dfe3e8\" fill-rule=\"evenodd\" stroke=\"#1b2733\" stroke-width=\"{:.4f}\" "
        "stroke-linejoin=\"round\" d=\"\n{}\"/>\n",
        0.002 * (1.0 + kMarginShare) * drawn->radius, drawn->path);
  }
  std::string title = bodies.front().name;
  for (std::size_t i = 1; i < bodies.size(); ++i) title += ", " + bodies[i].name;
  const Vec2 corner = box.min() - Vec2::Constant(margin);
  const Vec2 size = box.sizes() + Vec2::Constant(2 * margin);
  drawing.text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6f}mm\" height=\"{1:.6f}mm\" "
      "viewBox=\"{2:.6f} {3:.6f} {0:.6f} {1:.6f}\">\n"
      "<title>{4}</title>\n{5}</svg>\n",
      size.x(), size.y(), corner.x(), corner.y(), escaped(title), paths);
  return drawing;
}

Result<Drawing> svg_drawing(const ToothedBody& body, const SvgOptions& options) {
  return svg_drawing(std::vector<ToothedBody>{body}, options);
}

namespace {

constexpr int kLooks = 16;
constexpr int kVerify = 64;

// The exact curve as a function of x, the relative arc length.
class ByLength {
 public:
  explicit ByLength(const Arc& arc) : arc_(arc), by_length_(*arc.curve, arc.begin, arc.end) {}

  CurvePoint at(double x) const {
    const double t = by_length_.parameter(x * by_length_.length());
    CurvePoint w = arc_.at((t - arc_.begin) / (arc_.end - arc_.begin));
    if (x == 0.0) w.point = arc_.begin_point;
    if (x == 1.0) w.point = arc_.end_point;
    return w;
  }
  double length() const { return by_length_.length(); }

 private:
  const Arc& arc_;
  ArcLength by_length_;
};

using Cubic = std::array<Vec2, 4>;

Cubic cubic_between(const ByLength& curve, double x0, double x1) {
  const CurvePoint a = curve.at(x0);
  const CurvePoint b = curve.at(x1);
  const auto handle = [&](const CurvePoint& w) {
    const double third = (x1 - x0) * curve.length() / 3.0;
    return Vec2(third * std::cos(w.tangent_angle), third * std::sin(w.tangent_angle));
  };
  return {a.point, a.point + handle(a), b.point - handle(b), b.point};
}

double deviation(const ByLength& curve, const Cubic& c, double x0, double x1, int looks) {
  double worst = 0.0;
  for (int k = 0; k < looks; ++k) {
    const double v = (k + 0.5) / looks;
    const double w = 1.0 - v;
    const Vec2 p =
        w * w * w * c[0] + 3 * v * w * w * c[1] + 3 * v * v * w * c[2] + v * v * v * c[3];
    worst = std::max(worst, osculating_distance(curve.at(x0 + (x1 - x0) * v), p));
  }
  return worst;
}

BezierChain chain_of(const Arc& arc, const ByLength& curve, double tolerance) {
  constexpr StepLimits kLimits{1.0 / 4096, 1.0 / 64};
  BezierChain chain{{arc.begin_point}, 0.0};
  double x0 = 0.0;
  double step = 1.0;
  while (x0 < 1.0) {
    const double x1 = longest_step(x0, 1.0, step, kLimits, [&](double x) {
      return deviation(curve, cubic_between(curve, x0, x), x0, x, kLooks) <= tolerance;
    });
    const Cubic cubic = cubic_between(curve, x0, x1);
    chain.points.insert(chain.points.end(), cubic.begin() + 1, cubic.end());
    chain.deviation_mm = std::max(chain.deviation_mm, deviation(curve, cubic, x0, x1, kVerify));
    step = x1 - x0;
    x0 = x1;
  }
  return chain;
}

}  // namespace

BezierChain fit_beziers(const Arc& arc, double tolerance_mm) {
  GW_EXPECTS(tolerance_mm > 0.0);
  // If the error along a piece has one maximum, 16 samples give this maximum within 1 %. The final
  // verification covers all other cases.
  const ByLength curve(arc);
  BezierChain chain = chain_of(arc, curve, 0.98 * tolerance_mm);
  if (chain.deviation_mm > tolerance_mm && chain.deviation_mm < 2.0 * tolerance_mm) {
    chain = chain_of(arc, curve, 0.5 * tolerance_mm);
  }
  return chain;
}

}  // namespace gearwright
