#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/cad/dxf_document.hpp"
#include "gearwright/cad/dxf_pairs.hpp"

namespace gearwright {

using namespace dxf;

void DxfEntities::begin(const char* type, const std::string& layer, const char* subclass) {
  DxfPairs(text_)
      .word(0, type)
      .handle(5, handle_++)
      .handle(330, kModel)
      .word(100, "AcDbEntity")
      .word(8, layer)
      .word(100, subclass);
}

void DxfEntities::polyline(const std::string& layer, const std::vector<Vec2>& points,
                           const std::vector<double>& bulges) {
  const bool closed = bulges.size() == points.size();
  GW_EXPECTS(closed || points.size() == bulges.size() + 1);
  begin("LWPOLYLINE", layer, "AcDbPolyline");
  DxfPairs out(text_);
  out.integer(90, static_cast<int>(points.size())).integer(70, closed ? 1 : 0).real(43, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = at(points[i]);
    out.point(10, p.x(), p.y());
    if (i < bulges.size() && bulges[i] != 0.0) out.real(42, bulges[i]);
  }
}

void DxfEntities::circle(const std::string& layer, double radius, const Vec2& center) {
  begin("CIRCLE", layer, "AcDbCircle");
  const Vec2 c = at(center);
  DxfPairs(text_).point(10, c.x(), c.y(), 0).real(40, radius);
}

void DxfEntities::line(const std::string& layer, const Vec2& a, const Vec2& b) {
  begin("LINE", layer, "AcDbLine");
  const Vec2 p = at(a), q = at(b);
  DxfPairs(text_).point(10, p.x(), p.y(), 0).point(11, q.x(), q.y(), 0);
}

void DxfEntities::triangle(const std::string& layer, const Vec2& a, const Vec2& b, const Vec2& c) {
  begin("SOLID", layer, "AcDbTrace");
  DxfPairs out(text_);
  int code = 10;
  // A SOLID has four corners, so the last corner is repeated.
  for (const Vec2* corner : {&a, &b, &c, &c}) {
    const Vec2 p = at(*corner);
    out.point(code++, p.x(), p.y(), 0);
  }
}

void DxfEntities::text(const std::string& layer, const Vec2& where, const std::string& utf8,
                       double height, double degrees) {
  has_words_ = true;
  begin("TEXT", layer, "AcDbText");
  std::string words;
  for (const char32_t code : code_points(utf8)) {
    const auto c = static_cast<std::uint32_t>(code);
    if (c >= 0x20 && c < 0x7F)
      words += static_cast<char>(c);
    else
      words += fmt::format("\\U+{:04X}", c < 0x20 || c > 0xFFFF ? 0xFFFD : c);
  }
  const Vec2 p = at(where);
  DxfPairs out(text_);
  out.point(10, p.x(), p.y(), 0).real(40, height).word(1, words);
  if (degrees != 0.0) out.real(50, degrees);
  out.word(7, kWordStyle).word(100, "AcDbText");
}

void DxfEntities::circular_spline(const std::string& layer, const Vec2& begin_point,
                                  const Vec2& end_point, double sweep) {
  // The arc is divided into pieces of at most a quarter turn. The poles of a piece are its start,
  // the intersection of the tangents at both ends, and its end. Their weights are 1, the cosine of
  // half the angle of the piece, and 1.
  const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 2 + 1e-9)));
  const double half = sweep / (2 * pieces);
  const double weight = std::cos(half);
  begin("SPLINE", layer, "AcDbSpline");
  DxfPairs out(text_);
  const int poles = 2 * pieces + 1;
  out.point(210, 0, 0, 1).integer(70, 12).integer(71, 2);  // flags 12 = 4 + 8: rational, planar
  out.integer(72, poles + 3).integer(73, poles).integer(74, 0).real(42, 1e-9).real(43, 1e-9);
  for (int i = 0; i < 3; ++i) out.real(40, 0);
  for (int i = 1; i < pieces; ++i) {
    for (int twice = 0; twice < 2; ++twice) out.real(40, static_cast<double>(i) / pieces);
  }
  for (int i = 0; i < 3; ++i) out.real(40, 1);
  for (int i = 0; i < poles; ++i) out.real(41, i % 2 == 0 ? 1 : weight);
  for (int i = 0; i < poles; ++i) {
    Vec2 p = i == 0 ? begin_point : end_point;
    if (i > 0 && i < poles - 1) {
      p = Eigen::Rotation2Dd(half * i) * begin_point;
      if (i % 2 == 1) p /= weight;
    }
    p = at(p);
    out.point(10, p.x(), p.y(), 0);
  }
}

void DxfEntities::spline(const std::string& layer, int degree, const std::vector<double>& knots,
                         const std::vector<Vec2>& poles) {
  GW_EXPECTS(knots.size() == poles.size() + static_cast<std::size_t>(degree) + 1);
  begin("SPLINE", layer, "AcDbSpline");
  DxfPairs out(text_);
  out.point(210, 0, 0, 1).integer(70, 8).integer(71, degree);  // flag 8: planar
  out.integer(72, static_cast<int>(knots.size())).integer(73, static_cast<int>(poles.size()));
  out.integer(74, 0).real(42, 1e-9).real(43, 1e-9);
  for (const double knot : knots) out.real(40, knot);
  for (const Vec2& pole : poles) {
    const Vec2 p = at(pole);
    out.point(10, p.x(), p.y(), 0);
  }
}

}  // namespace gearwright
