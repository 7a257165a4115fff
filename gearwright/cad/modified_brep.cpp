#include "gearwright/cad/brep.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/brep_shell.hpp"
#include "gearwright/cad/screw.hpp"

namespace gearwright {

namespace {

using brep::Corner, brep::Corners, brep::Edge, brep::Edges, brep::Id, brep::Ids, brep::Rims,
    brep::Side;

// A wall of tooth 0, which is an arc of one side or a land. The order is counter-clockwise.
struct ToothWall {
  std::optional<std::size_t> arc;  // none for a land
  bool left;                       // true on the left side, where the poles run from tip to root
  Wall land;                       // for a land, its circle
};

class ModifiedWriter {
 public:
  ModifiedWriter(brep::ShellWriter& shell, const ModifiedTeeth& teeth, const Band& band,
                 const ModifiedFit& fit)
      : shell_(shell),
        fit_(fit),
        band_(band),
        turn_(sincos_of(band.angle(band.middle))),
        copies_(std::abs(teeth.outline().teeth)),
        walls_(tooth_walls(teeth)) {}

  Rims add_teeth(Side side, const brep::Rim* base) {
    const std::size_t n = walls_.size() * static_cast<std::size_t>(copies_);
    Corners below = base ? base->corners : corners_at(0);
    Edges floor = base ? base->edges : level_edges_at(0, below);
    Rims rims{{below, floor}, {}};
    // chain[i] collects the upright edges at the start of wall i. It contains one edge for each
    // layer above the last plane z = const.
    std::vector<Edges> chain(n);
    std::size_t plane = 0;
    Edges plane_floor = floor;
    for (std::size_t l = 0; l + 1 < fit_.levels.size(); ++l) {
      Corners above = corners_at(l + 1);
      Edges ceiling = level_edges_at(l + 1, above);
      const Edges uprights = uprights_in(l, below, above);
      for (std::size_t i = 0; i < n; ++i) {
        chain[i].push_back(uprights[i]);
        if (!wall(i).arc) continue;
        const Edge& right = uprights[(i + 1) % n];
        const Id around =
            shell_.face_bound({&floor[i], 1}, {&right, 1}, {&ceiling[i], 1}, {&uprights[i], 1});
        const Id spline = shell_.spline_between(
            {floor[i], right, ceiling[i], uprights[i]}, knots_u(i), fit_.along_v[l],
            [&](std::size_t a, std::size_t b) { return pole(i, l, a, b); });
        shell_.add_face({around}, spline, side);
      }
      if (!fit_.levels[l + 1].kink) {
        const double middle = band_.angle(0.5 * (z_at(plane) + z_at(l + 1)));
        for (std::size_t i = 0; i < n; ++i) {
          if (wall(i).arc) continue;
          const Id around = shell_.face_bound({&plane_floor[i], 1}, chain[(i + 1) % n],
                                              {&ceiling[i], 1}, chain[i]);
          const Id round = shell_.cylinder(land(i), middle);
          shell_.add_face({around}, round, side);
        }
        for (Edges& edges : chain) edges.clear();
        plane = l + 1;
        plane_floor = ceiling;
      }
      below = std::move(above);
      floor = std::move(ceiling);
    }
    rims.top = {std::move(below), std::move(floor)};
    return rims;
  }

 private:
  static std::vector<ToothWall> tooth_walls(const ModifiedTeeth& teeth) {
    const ModifiedSide &right = teeth.side(false), &left = teeth.side(true);
    const auto& arcs = teeth.outline().arcs;
    const double pitch = 2 * kPi / std::abs(teeth.outline().teeth);
    const auto circle = [](double radius, double from, double to) {
      return Wall{WallShape::circle, 0.0, 0.0, nullptr, {}, radius, from, to};
    };
    std::vector<ToothWall> walls;
    const auto faces = [&](bool is_left) {
      for (std::size_t i = 0; i < arcs.size(); ++i) {
        const std::size_t arc = is_left ? arcs.size() - 1 - i : i;
        if (right.role(arc) != ModifiedSide::Role::land) walls.push_back({arc, is_left, {}});
      }
    };
    faces(false);
    if (right.role(arcs.size() - 1) == ModifiedSide::Role::land) {
      const auto edge = [](const ModifiedSide& side) {
        const Vec3 p = side.point(side.outline().arcs.size() - 1, 0.0, side.plane(0.0));
        return std::atan2(p.y(), p.x());
      };
      walls.push_back(
          {{}, false, circle(arcs.back().begin_point.norm(), -edge(right), edge(left))});
    }
    faces(true);
    if (right.role(0) == ModifiedSide::Role::land) {
      const Vec2& p = arcs.front().end_point;
      const double to = std::atan2(p.y(), p.x());
      walls.push_back({{}, true, circle(p.norm(), to, pitch - to)});
    }
    return walls;
  }

  const ToothWall& wall(std::size_t i) const { return walls_[i % walls_.size()]; }
  SinCos tooth(std::size_t i) const {
    return sincos_turn(static_cast<long long>(i / walls_.size()), copies_);
  }
  Wall land(std::size_t i) const {
    Wall circle = wall(i).land;
    const double angle = 2 * kPi * static_cast<double>(i / walls_.size()) / copies_;
    circle.begin_angle += angle;
    circle.end_angle += angle;
    return circle;
  }

  std::size_t poles_u(std::size_t i, std::size_t layer) const { return poles(i, layer).size(); }
  const std::vector<std::vector<Vec3>>& poles(std::size_t i, std::size_t layer) const {
    const ToothWall& w = wall(i);
    return fit_.faces[w.left ? 1 : 0][layer][*w.arc].poles;
  }
  // Returns pole (a, b) of a face. a counts along the loop, and b counts upwards.
  Vec3 pole(std::size_t i, std::size_t layer, std::size_t a, std::size_t b) const {
    const auto& rows = poles(i, layer);
    Vec3 p = rows[wall(i).left ? rows.size() - 1 - a : a][b];
    if (!wall(i).left) p.y() = -p.y();
    p = turned_about_axis(turned_about_axis(p, tooth(i)), turn_);
    return {p.x(), p.y(), p.z() + band_.middle};
  }
  double z_at(std::size_t level) const { return fit_.levels[level].z + band_.middle; }
  double angle_at(std::size_t level) const { return band_.angle(z_at(level)); }
  WallKnots knots_u(std::size_t i) const {
    const ToothWall& w = wall(i);
    const WallKnots& knots = fit_.along_u[w.left ? 1 : 0][*w.arc];
    return w.left ? backward(knots) : knots;
  }

  // Returns pole b of the upright edge at the start of wall i. If wall i is a land, this edge is
  // also the end of the previous wall.
  Vec3 upright_pole(std::size_t i, std::size_t layer, std::size_t b) const {
    if (wall(i).arc) return pole(i, layer, 0, b);
    return pole(i - 1, layer, poles_u(i - 1, layer) - 1, b);
  }

  Corners corners_at(std::size_t level) {
    const std::size_t layer = level == 0 ? 0 : level - 1;
    const std::size_t b = level == 0 ? 0 : poles(0, layer).front().size() - 1;
    Corners all;
    for (std::size_t i = 0; i < walls_.size() * static_cast<std::size_t>(copies_); ++i)
      all.push_back(shell_.corner(upright_pole(i, layer, b)));
    return all;
  }

  Edges level_edges_at(std::size_t level, const Corners& at) {
    const std::size_t layer = level == 0 ? 0 : level - 1;
    const ToothLevel& here = fit_.levels[level];
    Edges all;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Corner &from = at[i], &to = at[(i + 1) % at.size()];
      if (!wall(i).arc) {
        if (here.kink) {
          all.push_back({});
        } else {
          const Id curve = shell_.circle(land(i), angle_at(level), z_at(level));
          all.push_back(shell_.edge(from, to, curve, {}));
        }
        continue;
      }
      const std::size_t b = level == 0 ? 0 : poles(i, layer).front().size() - 1;
      all.push_back(shell_.spline_edge(from, to, poles_u(i, layer), knots_u(i),
                                       [&](std::size_t a) { return pole(i, layer, a, b); }));
    }
    return all;
  }

  Edges uprights_in(std::size_t layer, const Corners& below, const Corners& above) {
    Edges all;
    for (std::size_t i = 0; i < below.size(); ++i) {
      all.push_back(shell_.spline_edge(below[i], above[i], poles(0, layer).front().size(),
                                       fit_.along_v[layer],
                                       [&](std::size_t b) { return upright_pole(i, layer, b); }));
    }
    return all;
  }

  brep::ShellWriter& shell_;
  const ModifiedFit& fit_;
  Band band_;  // band in the frame of the solid
  SinCos turn_;
  int copies_;
  std::vector<ToothWall> walls_;
};

}  // namespace

brep::Rims brep::add_modified_teeth(ShellWriter& shell, const ModifiedTeeth& teeth,
                                    const Band& band, const ModifiedFit& fit, Side side,
                                    const Rim* base) {
  return ModifiedWriter(shell, teeth, band, fit).add_teeth(side, base);
}

}  // namespace gearwright
