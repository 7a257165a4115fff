#include "gearwright/cad/modified_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/rack_plan.hpp"

namespace gearwright {

namespace {

constexpr double kMostVertices = 2e6;  // vertices of a mesh, as in cad/mesh.cpp
constexpr double kSameStation_mm = 1e-6;

// A line of constant s, with the height x of the teeth on this line. Both ends of the line have a
// vertex of the teeth and a vertex of the back.
struct Station {
  double s, x;
  std::uint32_t low, high, back_low, back_high;  // vertex numbers
};

// A plane strip between two stations, with the exact surface normals at both stations.
struct Facet {
  double s, x;  // position and height of the end of the strip
  Vec3 normal_begin, normal_end;
};

class RackMesher {
 public:
  RackMesher(const ToothedBody& body, const MeshOptions& options)
      : body_(body), options_(options), plan_(body) {}

  std::vector<Facet> facets() const {
    std::vector<Facet> all;
    for (const RackStrip& strip : plan_.strips()) add_facets(strip, all);
    return all;
  }
  double first_height() const { return height(plan_.strips().front(), plan_.first()); }

  TriangleMesh mesh(const std::vector<Facet>& facets) {
    Station before = station(plan_.first(), first_height());
    const Vec3 back(-1, 0, 0);
    if (before.low != before.high)  // always true for a spur rack
      wall(before.high, before.low, before.back_low, before.back_high, {0, -1, 0});
    for (Facet facet : facets) {
      const double s_0 = before.s;
      facet.s = plan_.snapped(facet.s);
      if (facet.s <= s_0) continue;
      std::vector<double> cuts;
      for (const double corner : {plan_.low_corner(), plan_.high_corner()})
        if (corner > s_0 && corner < facet.s) cuts.push_back(corner);
      std::sort(cuts.begin(), cuts.end());
      cuts.push_back(facet.s);
      const double x_0 = before.x;
      Vec3 normal = facet.normal_begin;
      for (const double s : cuts) {
        const double u = (s - s_0) / (facet.s - s_0);
        const Vec3 next =
            s == facet.s ? facet.normal_end
                         : Vec3(facet.normal_begin + u * (facet.normal_end - facet.normal_begin))
                               .normalized();
        const Station after = station(s, s == facet.s ? facet.x : x_0 + u * (facet.x - x_0));
        face({before.low, after.low, after.high, before.high}, {normal, next, next, normal});
        face({before.back_low, before.back_high, after.back_high, after.back_low},
             {back, back, back, back});
        border(before.low, after.low, after.back_low, before.back_low);
        border(after.high, before.high, before.back_high, after.back_high);
        before = after;
        normal = next;
      }
    }
    if (before.low != before.high)
      wall(before.low, before.high, before.back_high, before.back_low, {0, 1, 0});
    return std::move(mesh_);
  }

 private:
  double height(const RackStrip& strip, double s) const {
    const Vec2& a = strip.arc->begin_point;
    const Vec2& b = strip.arc->end_point;
    const double y = strip.lower ? strip.middle - s : s - strip.middle;
    if (strip.name == ArcName::root_fillet) return circle(strip, y).first;
    if (a.y() == b.y()) return a.x();
    return a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
  }

  // Returns the height on the circle of the fillet, and the slope dx/dy there. y is the distance
  // from the centre line of the tooth.
  std::pair<double, double> circle(const RackStrip& strip, double y) const {
    const double rho = body_.rack->fillet_radius;
    const double n = std::clamp((y - strip.arc->begin_point.y()) * cosine_, -rho, rho);
    const double below = std::sqrt((rho - n) * (rho + n));
    return {strip.arc->begin_point.x() + rho - below, n / below * cosine_};
  }

  Vec3 normal(double dx_ds) const { return Vec3(1.0, -dx_ds, plan_.slope() * dx_ds).normalized(); }

  void add_facets(const RackStrip& strip, std::vector<Facet>& all) const {
    const double side = strip.lower ? -1.0 : 1.0;
    if (strip.name != ArcName::root_fillet) {
      const Vec2 way = strip.arc->end_point - strip.arc->begin_point;
      const Vec3 n = normal(side * way.x() / way.y());
      all.push_back({strip.end, height(strip, strip.end), n, n});
      return;
    }
    const double rho = body_.rack->fillet_radius;
    const auto angle_at = [&](double s) {
      const double y = strip.lower ? strip.middle - s : s - strip.middle;
      return std::asin(std::clamp((y - strip.arc->begin_point.y()) * cosine_ / rho, -1.0, 1.0));
    };
    const double from = angle_at(strip.begin), to = angle_at(strip.end);
    const double chord = 2 * std::acos(std::max(0.0, 1 - options_.chord_tolerance_mm / rho));
    const double most = std::min(chord, options_.facet_turn_max.rad());
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / most)));
    const auto normal_at = [&](double turn) { return normal(side * std::tan(turn) * cosine_); };
    for (int i = 1; i <= n; ++i) {
      const double t_0 = from + (to - from) * (i - 1) / n, t_1 = from + (to - from) * i / n;
      const double y = strip.arc->begin_point.y() + rho * std::sin(t_1) / cosine_;
      const double s = i == n ? strip.end : strip.middle + side * y;
      all.push_back({s, height(strip, s), normal_at(t_0), normal_at(t_1)});
    }
  }

  std::uint32_t vertex(const Vec3& p) {
    mesh_.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  Station station(double s, double x) {
    const Vec2 low = plan_.low(s), high = plan_.high(s);
    const double back = -body_.rack->height;
    Station made{s, x, 0, 0, 0, 0};
    made.high = made.low = vertex({x, low.x(), low.y()});
    made.back_high = made.back_low = vertex({back, low.x(), low.y()});
    if ((low - high).norm() > kSameStation_mm) {
      made.high = vertex({x, high.x(), high.y()});
      made.back_high = vertex({back, high.x(), high.y()});
    }
    return made;
  }

  // Adds a wall below the border. Its outward normal is ±z on a side of the bar, and ±y on an end.
  void border(std::uint32_t a, std::uint32_t b, std::uint32_t back_b, std::uint32_t back_a) {
    const Vec3 &p = mesh_.vertices[a], &q = mesh_.vertices[b];
    const bool side = p.z() == q.z() && std::abs(p.z()) == plan_.width() / 2;
    const Vec3 out = side ? Vec3(0, 0, p.z() < 0 ? -1 : 1) : Vec3(0, p.y() < 0 ? -1 : 1, 0);
    wall(a, b, back_b, back_a, out);
  }

  void wall(std::uint32_t a, std::uint32_t b, std::uint32_t back_b, std::uint32_t back_a,
            const Vec3& out) {
    face({b, a, back_a, back_b}, {out, out, out, out});
  }

  // Adds a quadrilateral that is counter-clockwise seen from outside. If two corners coincide, the
  // function adds a triangle.
  void face(const std::array<std::uint32_t, 4>& corners, const std::array<Vec3, 4>& normals) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < 4; ++i)
      if (corners[i] != corners[(i + 1) % 4]) kept.push_back(i);
    if (kept.size() < 3) return;
    const auto shade = static_cast<std::uint32_t>(mesh_.shaded_vertices.size());
    for (const std::size_t i : kept) {
      mesh_.shaded_vertices.push_back(corners[i]);
      mesh_.normals.push_back(normals[i]);
    }
    for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
      mesh_.triangles.push_back({corners[kept[0]], corners[kept[i]], corners[kept[i + 1]]});
      mesh_.shaded_triangles.push_back({shade, shade + static_cast<std::uint32_t>(i),
                                        shade + static_cast<std::uint32_t>(i) + 1});
    }
  }

  const ToothedBody& body_;
  const MeshOptions& options_;
  RackPlan plan_;
  double cosine_ = 1 / std::hypot(1.0, body_.rack->slope);
  TriangleMesh mesh_;
};

}  // namespace

Result<TriangleMesh> tessellate_rack(const ToothedBody& body, const MeshOptions& options) {
  RackMesher mesher(body, options);
  const std::vector<Facet> facets = mesher.facets();
  if (4.0 * static_cast<double>(facets.size()) > kMostVertices) {
    return Error{
        "chord_tolerance_mm", fmt::format("{}", options.chord_tolerance_mm),
        fmt::format("the mesh would have more than {:.0e} vertices; increase the tolerance "
                    "or give the rack fewer teeth",
                    kMostVertices)};
  }
  return mesher.mesh(facets);
}

}  // namespace gearwright
