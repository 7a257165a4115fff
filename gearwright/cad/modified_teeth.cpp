#include "gearwright/cad/modified_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/screw.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

namespace {

// If the tangents of two arcs of a flank differ by at most this angle at the joint, rad, the arcs
// form one surface.
constexpr double kSmooth = 1e-6;
// Least length of a part of a divided arc, mm. The start of a relief does not divide an arc if one
// of the parts would be shorter. A linear relief of 1 in 5 changes by 2e-7 mm over this length.
constexpr double kSameStart_mm = 1e-6;
// Step of a finite difference, as a fraction of the arc's parameter. The difference gives the slope
// of the curvature at the end of an arc.
constexpr double kCurvatureStep = 1e-3;
// Numbers of heights, and of points per arc, at which the teeth are examined.
constexpr int kExaminedRows = 33;
constexpr int kExaminedPoints = 16;

Error obstacle(const std::string& why) { return {"modifications", "", why}; }

std::optional<Error> obstacle_of(const Outline& outline) {
  const auto flank = [](const Arc& arc) { return arc.name == ArcName::flank; };
  const auto& arcs = outline.arcs;
  const auto first = std::find_if(arcs.begin(), arcs.end(), flank);
  if (first == arcs.end()) return obstacle("the teeth have no flank");
  const auto beyond = std::find_if_not(first, arcs.end(), flank);
  if (std::any_of(beyond, arcs.end(), flank))
    return obstacle("the flank consists of several pieces");
  for (auto arc = first; arc + 1 != beyond; ++arc) {
    const double turn = (arc + 1)->at(0.0).tangent_angle - arc->at(1.0).tangent_angle;
    if (std::abs(std::remainder(turn, 2 * kPi)) > kSmooth)
      return obstacle("the flank has a corner");
  }
  if (first == arcs.begin() || (first - 1)->name != ArcName::root_fillet)
    return obstacle("there is no root fillet next to the flank");
  if (beyond == arcs.end()) return obstacle("the teeth are pointed");
  if (std::abs(outline.teeth) == 1 && std::any_of(arcs.begin(), arcs.end(), round_land))
    return obstacle("a land of the single tooth spans more than half a turn");
  return std::nullopt;
}

// Returns the radii at which reliefs begin, in ascending order.
std::vector<double> starts(const std::array<std::shared_ptr<const RemovalField>, 2>& fields) {
  std::vector<double> rho;
  for (const auto& field : fields)
    for (const double u : field->kinks_u()) rho.push_back(std::exp(u));
  std::sort(rho.begin(), rho.end());
  return rho;
}

// Appends the arc. If it contains given radii, it is divided there.
void append_divided(const Arc& arc, std::vector<double> rho, std::vector<Arc>& arcs) {
  const double begin = arc.begin_point.norm(), end = arc.end_point.norm();
  if (end < begin) std::reverse(rho.begin(), rho.end());
  Arc rest = arc;
  for (const double r : rho) {
    const double last = rest.begin_point.norm();
    const double along = end < begin ? last - r : r - last;
    const double ahead = end < begin ? r - end : end - r;
    if (along < kSameStart_mm || ahead < kSameStart_mm) continue;
    const double t = end < begin ? arc.curve->parameter_at_radius(r, arc.end, arc.begin)
                                 : arc.curve->parameter_at_radius(r, arc.begin, arc.end);
    Arc part = rest;
    part.end = t;
    part.end_point = arc.curve->point(t);
    rest.begin = t;
    rest.begin_point = part.end_point;
    arcs.push_back(std::move(part));
  }
  arcs.push_back(std::move(rest));
}

}  // namespace

ModifiedSide::ModifiedSide(const Outline& outline, double twist,
                           std::shared_ptr<const RemovalField> field)
    : outline_(std::make_shared<const Outline>(outline)), twist_(twist), field_(std::move(field)) {
  const auto& arcs = outline_->arcs;
  while (arcs[first_].name != ArcName::flank) ++first_;
  last_ = first_;
  while (arcs[last_ + 1].name == ArcName::flank) ++last_;
  for (std::size_t i = 0; i < arcs.size(); ++i)
    roles_.push_back(i >= first_ && i <= last_ ? Role::flank
                     : round_land(arcs[i])     ? Role::land
                                               : Role::fade);
  has_edge_ = roles_[last_ + 1] == Role::land;
}

// The moved flank must still reach the tip cylinder, so the arc is continued beyond its end. The
// continuation has the curvature at the end and the slope of this curvature. Its error grows with
// the fourth power of the distance from the end.
ModifiedSide::Place ModifiedSide::nominal(std::size_t arc, double u) const {
  const Arc& a = outline_->arcs[arc];
  const auto place = [&](const Vec2& p, double angle) {
    const Vec3 n = screw_normal(p, section_normal(outline_->side(), angle), twist_);
    return Place{p, n, std::log(p.norm())};
  };
  if (u <= 1.0) return place(a.point(u), a.at(u).tangent_angle);
  const CurvePoint end = a.at(1.0), before = a.at(1.0 - kCurvatureStep);
  const double step = (end.point - before.point).norm();
  const double s = (u - 1.0) / kCurvatureStep * step;
  const double k = end.curvature, k1 = (k - before.curvature) / step;
  const double x = s - k * k * s * s * s / 6, y = k * s * s / 2 + k1 * s * s * s / 6;
  return place(a.end_point + turned({x, y}, end.tangent_angle),
               end.tangent_angle + k * s + k1 * s * s / 2);
}

double ModifiedSide::zeta_at(const ToothLevel& level, const Place& at) const {
  if (level.kink || twist_ == 0.0) return level.z;
  // The iteration is ζ = z + c n_z. Each step multiplies the error by the slope of c, which is at
  // most 1 in 5.
  double zeta = level.z;
  for (int i = 0; i < 40; ++i) {
    const double next = level.z + removed(at, zeta) * at.n.z();
    const bool same = std::abs(next - zeta) < 1e-15 * (1 + std::abs(level.z));
    zeta = next;
    if (same) break;
  }
  return zeta;
}

double ModifiedSide::zeta_in(const Row& row, const Place& at) const {
  if (row.v == 0.0) return zeta_at(row.low, at);
  if (row.v == 1.0) return zeta_at(row.high, at);
  return (1 - row.v) * zeta_at(row.low, at) + row.v * zeta_at(row.high, at);
}

Vec3 ModifiedSide::flank(std::size_t arc, double u, const Row& row) const {
  const Place at = nominal(arc, u);
  const double zeta = zeta_in(row, at), c = removed(at, zeta);
  const Vec2 xy = turned(at.p - c * at.n.head<2>(), twist_ * zeta);
  return {xy.x(), xy.y(), zeta - c * at.n.z()};
}

// Returns the u at which |M| equals the tip radius, by the secant method. The iteration starts at
// the end of the nominal flank.
double ModifiedSide::edge_of(const Row& row) const {
  const double radius = outline_->arcs[last_].end_point.norm();
  const auto beyond = [&](double u) { return flank(last_, u, row).head<2>().norm() - radius; };
  double a = 1.0, b = 1.0 - kCurvatureStep;
  double f_a = beyond(a), f_b = beyond(b);
  for (int i = 0; i < 40 && f_a != 0.0 && f_a != f_b; ++i) {
    const double next = a - f_a * (a - b) / (f_a - f_b);
    b = std::exchange(a, next);
    f_b = std::exchange(f_a, beyond(a));
    if (std::abs(a - b) < 1e-15) break;
  }
  return a;
}

ModifiedSide::Row ModifiedSide::row(const ToothLevel& low, const ToothLevel& high, double v) const {
  Row row{low, high, v, low.z + v * (high.z - low.z), 1.0, {Vec2::Zero(), Vec2::Zero()}, {}};
  if (v == 1.0) row.z = high.z;
  if (has_edge_) row.edge = edge_of(row);
  for (const bool tip : {false, true}) {
    const Vec3 end = tip ? flank(last_, row.edge, row) : flank(first_, 0.0, row);
    const Arc& arc = outline_->arcs[tip ? last_ : first_];
    row.shift[tip] =
        turned(end.head<2>(), -twist_ * end.z()) - (tip ? arc.end_point : arc.begin_point);
    row.end_z[tip] = end.z();
  }
  return row;
}

double ModifiedSide::weight(std::size_t arc, double rho) const {
  const bool tip = arc > last_;
  const auto& arcs = outline_->arcs;
  std::size_t end = arc;  // the last arc of the fade; it meets a land or the centre line
  if (tip) {
    while (end + 1 < arcs.size() && role(end + 1) == Role::fade) ++end;
  } else {
    while (end > 0 && role(end - 1) == Role::fade) --end;
  }
  const double zero = (tip ? arcs[end].end_point : arcs[end].begin_point).norm();
  const double one = (tip ? arcs[last_].end_point : arcs[first_].begin_point).norm();
  const double x = one == zero ? 1.0 : std::clamp((rho - zero) / (one - zero), 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

Vec3 ModifiedSide::point(std::size_t arc, double u, const Row& row) const {
  const Arc& a = outline_->arcs[arc];
  switch (role(arc)) {
    case Role::flank: return flank(arc, arc == last_ ? u * row.edge : u, row);
    case Role::fade: {
      const std::size_t tip = arc > last_ ? 1 : 0;
      const Vec2 p = a.point(u);
      const bool joint = tip == 1 ? arc == last_ + 1 && u == 0.0 : arc + 1 == first_ && u == 1.0;
      const double w = joint ? 1.0 : weight(arc, p.norm());
      const double z = w * row.end_z[tip] + (1 - w) * row.z;
      const Vec2 xy = turned(p + w * row.shift[tip], twist_ * z);
      return {xy.x(), xy.y(), z};
    }
    case Role::land: break;
  }
  Vec2 p = a.point(u);
  double z = row.z;
  if (arc == last_ + 1 && has_edge_) {
    // The tip land runs from the edge of the flank to the centre line of the tooth.
    const Vec2 edge = outline_->arcs[last_].end_point + row.shift[1];
    const double angle = std::atan2(edge.y(), edge.x()) * (1 - u);
    p = a.begin_point.norm() * Vec2(std::cos(angle), std::sin(angle));
    z = (1 - u) * row.end_z[1] + u * row.z;
  }
  const Vec2 xy = turned(p, twist_ * z);
  return {xy.x(), xy.y(), z};
}

std::vector<double> ModifiedTeeth::kinks_z() const {
  std::vector<double> all = right_.field().kinks_z();
  all.insert(all.end(), left_.field().kinks_z().begin(), left_.field().kinks_z().end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Result<ModifiedTeeth> ModifiedTeeth::of(
    const ToothedBody& body, const std::array<std::shared_ptr<const RemovalField>, 2>& removal) {
  const Outline tidy = tidied(body.outline);
  if (auto error = obstacle_of(tidy)) return *error;
  Outline divided{body.outline.teeth, {}};
  for (const Arc& arc : tidy.arcs) {
    if (arc.name == ArcName::flank) {
      append_divided(arc, starts(removal), divided.arcs);
    } else {
      divided.arcs.push_back(arc);
    }
  }
  const ModifiedTeeth teeth{ModifiedSide(divided, -body.twist, removal[0]),
                            ModifiedSide(divided, body.twist, removal[1])};
  const double half = body.bands().back().width / 2;
  for (const bool left : {false, true}) {
    const ModifiedSide& side = teeth.side(left);
    for (int i = 0; i < kExaminedRows; ++i) {
      const ModifiedSide::Row row = side.plane(half * (2.0 * i / (kExaminedRows - 1) - 1));
      for (std::size_t arc = 0; arc < divided.arcs.size(); ++arc) {
        if (side.role(arc) == ModifiedSide::Role::land) continue;
        Vec2 before = side.point(arc, 0.0, row).head<2>();
        for (int k = 1; k <= kExaminedPoints; ++k) {
          const double u = static_cast<double>(k) / kExaminedPoints;
          const Vec2 after = side.point(arc, u, row).head<2>();
          const double along =
              divided.arcs[arc].at(u - 0.5 / kExaminedPoints).tangent_angle + side.twist() * row.z;
          const Vec2 step = after - before;
          if (!(step.x() * std::cos(along) + step.y() * std::sin(along) > 0.0))
            return obstacle("the modification folds the surface beside the flank");
          const Vec2 back = turned(after, -side.twist() * row.z);
          const bool middle = arc + 1 == divided.arcs.size() && k == kExaminedPoints;
          if (!middle && !(back.y() > 0.0))
            return obstacle("the modified flanks of a tooth would cross each other");
          before = after;
        }
      }
    }
  }
  return teeth;
}

double ModifiedTeeth::removed_volume(double face_width) const {
  // Intervals of Simpson's rule along the face, and intervals of the polygon of an arc.
  constexpr int kRows = 400, kPoints = 100;
  double sum = 0.0;
  for (const bool left : {false, true}) {
    const ModifiedSide& s = side(left);
    for (int i = 0; i <= kRows; ++i) {
      const ModifiedSide::Row row = s.plane(face_width * (static_cast<double>(i) / kRows - 0.5));
      // Twice the area between the outline as cut and the modified outline, both taken as polygons.
      double area = 0.0;
      Vec2 cut_before, moved_before;
      bool begun = false;
      const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
      for (std::size_t arc = 0; arc < outline().arcs.size(); ++arc) {
        for (int k = 0; k <= kPoints; ++k) {
          const double u = static_cast<double>(k) / kPoints;
          const Vec2 cut = outline().arcs[arc].point(u);
          const Vec2 moved = turned(s.point(arc, u, row).head<2>(), -s.twist() * row.z);
          if (begun) {
            area += cross(moved - cut_before, cut - moved_before);
          }
          cut_before = cut;
          moved_before = moved;
          begun = true;
        }
      }
      const int weight = i == 0 || i == kRows ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * area / 2;
    }
  }
  return outline().side() * std::abs(outline().teeth) * sum * face_width / kRows / 3;
}

}  // namespace gearwright
