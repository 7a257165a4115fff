#include "gearwright/cad/drive_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// Depth of a neck below the roots of its gears, in modules. It is also the depth of the groove of a
// double-helical gear.
constexpr double kNeckDepth = 0.25;
// kNeckWall is the least wall thickness between a neck and its bore, and kNeckClearance is the
// least distance between a neck and another gear, both in modules.
constexpr double kNeckWall = 0.5, kNeckClearance = 0.25;
// Least length of a neck, mm. The surfaces of a shorter neck would be slivers.
constexpr double kNeckLength_mm = 1e-3;

Result<ToothedBody> shape_of(const Drive& drive, std::size_t g) {
  const DriveGear& named = drive.graph.gears[g];
  if (named.rack) {
    auto made = rack_body(rack_pair_of(drive, g)->rack, named.name);
    if (!made) return within(named.name, made.error());
    return made;
  }
  const Gear& gear = *drive.geometry.gears[g];
  if (!gear.tooth || !gear.exists())
    return Error{"", "",
                 fmt::format("{} has no outline: {}", named.name,
                             gear.tooth ? gear.warnings.back().message
                                        : std::string("no default cutter can generate the gear"))};
  std::optional<Halves> halves;
  if (named.double_helical) {
    auto both = halves_of(gear, *named.double_helical);
    if (!both) return within(named.name, both.error());
    halves = std::move(both).take();
  }
  auto made = body_as_made(gear, named.name, halves, 1, named.modifications);
  if (!made) return within(named.name, made.error());
  return made;
}

// Returns the greatest distance from the axis or, for a rack, from the middle of the rack, mm.
double reach(const ToothedBody& body) {
  if (body.rack) return std::max(body.rack->height, body.outline.teeth * body.rack->pitch / 2.0);
  double radius = body.bore ? body.bore->diameter / 2 : 0.0;
  for (const Arc& arc : body.outline.arcs)
    radius = std::max({radius, arc.begin_point.norm(), arc.end_point.norm()});
  return radius;
}

class Workpieces {
 public:
  Workpieces(const Drive& drive, const DriveLayout& layout, std::vector<ToothedBody> shapes)
      : drive_(drive), layout_(layout), graph_(drive.graph), shapes_(std::move(shapes)) {}

  std::vector<ToothedBody> all() {
    std::vector<Chain> chains;
    for (std::size_t b = 0; b < graph_.bodies.size(); ++b)
      for (Chain& chain : chains_on(b)) chains.push_back(std::move(chain));
    const auto first = [](const Chain& chain) {
      return *std::min_element(chain.gears.begin(), chain.gears.end());
    };
    std::sort(chains.begin(), chains.end(),
              [&](const Chain& a, const Chain& b) { return first(a) < first(b); });
    for (const Chain& chain : chains) add(chain);
    return std::move(made_);
  }

 private:
  // The gears of one solid from bottom to top, and the radii of the necks between them. If the
  // lowest gear is not joined to the gear below, `separate` contains the reason.
  struct Chain {
    std::vector<std::size_t> gears;
    std::vector<double> necks;
    std::string separate;
  };

  const PlacedGear& placed(std::size_t gear, int copy) const {
    return *std::find_if(layout_.gears.begin(), layout_.gears.end(),
                         [&](const PlacedGear& p) { return p.gear == gear && p.copy == copy; });
  }
  double module_of(std::size_t gear) const { return graph_.gears[gear].spec->normal_module; }
  double end(std::size_t gear, double side) const {
    return placed(gear, 0).height + side * shapes_[gear].face_width / 2.0;
  }

  std::vector<Chain> chains_on(std::size_t body) const {
    std::vector<std::size_t> gears;
    for (std::size_t g = 0; g < graph_.gears.size(); ++g)
      if (graph_.gears[g].body == body) gears.push_back(g);
    std::stable_sort(gears.begin(), gears.end(), [&](std::size_t a, std::size_t b) {
      return placed(a, 0).height < placed(b, 0).height;
    });
    std::vector<Chain> chains;
    for (const std::size_t g : gears) {
      std::string why;
      if (!chains.empty()) {
        const std::size_t below = chains.back().gears.back();
        const Result<double> neck = neck_radius(below, g);
        if (neck) {
          chains.back().gears.push_back(g);
          chains.back().necks.push_back(*neck);
          continue;
        }
        why = fmt::format("{} is not joined to {}, because {}", graph_.gears[g].name,
                          graph_.gears[below].name, neck.error().rule);
      }
      chains.push_back({{g}, {}, why});
    }
    return chains;
  }

  // Returns the radius of the cylinder between two gears of a body. The cylinder lies below the
  // roots of both gears and clears all other gears at its height. The necks of all copies of the
  // body have the same radius. The error is the reason why the gears are separate solids.
  Result<double> neck_radius(std::size_t below, std::size_t above) const {
    const ToothedBody &a = shapes_[below], &b = shapes_[above];
    const auto separate = [](const char* why) { return Error{"", "", why}; };
    if (a.rack || b.rack || a.ring() || b.ring()) return separate("only external gears are joined");
    const auto bore = [](const ToothedBody& body) { return body.bore.value_or(Bore{0.0}); };
    if (bore(a).diameter != bore(b).diameter || bore(a).keyway_width != bore(b).keyway_width ||
        bore(a).keyway_depth != bore(b).keyway_depth)
      return separate("their bores differ");
    const double low = end(below, 1.0), high = end(above, -1.0);
    if (high - low < kNeckLength_mm) return separate("there is no gap between their faces");
    const std::size_t body = graph_.gears[below].body;
    double radius = reach(a);
    for (const std::size_t g : {below, above}) {
      const double root = shapes_[g].outline.arcs.front().begin_point.norm();
      radius = std::min({radius, shapes_[g].limit_within(root), root - kNeckDepth * module_of(g)});
    }
    for (const PlacedGear& other : layout_.gears) {
      if (end(other.gear, 1.0) <= low || end(other.gear, -1.0) >= high) continue;
      const ToothedBody& shape = shapes_[other.gear];
      for (int copy = 0; copy < graph_.bodies[body].count; ++copy) {
        if (graph_.gears[other.gear].body == body && other.copy == copy) continue;
        radius = std::min(radius, room(shape, other, placed(below, copy).axis) -
                                      kNeckClearance * module_of(below));
      }
    }
    const double hole = a.bore ? bore_reach(*a.bore) : 0.0;
    if (radius < hole + kNeckWall * std::min(module_of(below), module_of(above)))
      return separate("there is no room for a shaft between them");
    return radius;
  }

  // Returns the greatest possible radius of a cylinder about `axis` beside or inside another gear,
  // mm. Inside a hollow gear on the same axis, this is the radius of the bore.
  double room(const ToothedBody& shape, const PlacedGear& other, const Vec2& axis) const {
    constexpr double kSameAxis_mm = 1e-6;
    const Vec2 away = axis - other.axis;
    if (shape.rack) {
      const Vec2 normal(std::cos(other.angle), std::sin(other.angle));
      return std::abs(away.dot(normal)) - shape.outline.arcs.back().end_point.x();
    }
    const double tip = shape.outline.arcs.back().end_point.norm();
    if (shape.ring()) return tip - away.norm();
    if (away.norm() < kSameAxis_mm) return shape.bore ? shape.bore->diameter / 2.0 : 0.0;
    return away.norm() - tip;
  }

  // True if the copies of a planet are clocked, which means that the angle between the gears of a
  // copy differs from copy to copy.
  bool clocked(std::size_t body) const {
    return std::any_of(drive_.sets.begin(), drive_.sets.end(), [&](const PlanetSet& set) {
      const auto& riders = set.group.riders;
      return !set.assembly.clocking.empty() && is_in(body, riders);
    });
  }

  SolidPose pose_of(std::size_t gear, int copy) const {
    const PlacedGear& at = placed(gear, copy);
    return {Vec3(at.axis.x(), at.axis.y(), at.height), about_z(at.angle)};
  }

  void add(const Chain& chain) {
    const std::size_t first = made_.size(), body = graph_.gears[chain.gears.front()].body;
    const DriveBody& named = graph_.bodies[body];
    const auto whole = std::count_if(graph_.gears.begin(), graph_.gears.end(),
                                     [&](const DriveGear& g) { return g.body == body; });
    const bool joined = chain.gears.size() > 1;
    const bool all = joined && chain.gears.size() == static_cast<std::size_t>(whole);
    const std::string& name = all ? named.name : graph_.gears[chain.gears.front()].name;
    for (int copy = 0; copy < named.count; ++copy) {
      ToothedBody solid = shapes_[chain.gears.front()];
      solid.pose = pose_of(chain.gears.front(), copy);
      solid.name = named.count > 1 ? fmt::format("{} {}", name, copy + 1) : name;
      solid.colour = body;
      solid.separate = chain.separate;
      for (std::size_t i = 1; i < chain.gears.size(); ++i) {
        ToothedBody gear = shapes_[chain.gears[i]];
        const auto on_solid = solid.pose.inverse() * pose_of(chain.gears[i], copy);
        gear.height = on_solid.origin().z();
        gear.turn = on_solid.turn();
        gear.neck = chain.necks[i - 1];
        solid.above.push_back(std::move(gear));
      }
      if (copy > 0 && !(joined && clocked(body))) solid.same_as = first;
      made_.push_back(std::move(solid));
    }
  }

  const Drive& drive_;
  const DriveLayout& layout_;
  const DriveGraph& graph_;
  std::vector<ToothedBody> shapes_;  // shape of each gear
  std::vector<ToothedBody> made_;
};

}  // namespace

Result<ToothedBody> body_as_made(const Gear& gear, const std::string& name,
                                 const std::optional<Halves>& halves, int which,
                                 const BothFlanks& modifications) {
  ToothedBody body = gear_body(gear, name, body_bore(gear)).value();
  if (halves) {
    const auto& [gap, stagger, groove, hob, lead, length] = halves->given;
    if (stagger != 0.0 && gap == 0.0) {
      return refused("double_helical.gap", gap,
                     "must be greater than 0 for files of staggered halves, because these halves "
                     "do not meet in the middle plane");
    }
    const double turn = 2.0 * kPi * stagger / gear.spec.teeth;
    body.face_width = halves->face_width;
    body.two_helices =
        TwoHelices{gap, halves->groove_diameter.value_or(0.0) / 2.0, which == 1 ? turn : -turn};
  }
  if (auto error = modify(body, gear, modifications)) return *error;
  return body;
}

Result<std::vector<ToothedBody>> drive_solids(const Drive& drive, const DriveLayout& layout) {
  std::vector<ToothedBody> shapes;
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
    auto made = shape_of(drive, g);
    if (!made) return made.error();
    shapes.push_back(std::move(made).take());
  }
  return Workpieces(drive, layout, std::move(shapes)).all();
}

std::vector<ToothedBody> laid_out(std::vector<ToothedBody> bodies) {
  constexpr double kBetween = 5.0;  // mm
  const auto size_of = [](const ToothedBody& body) {
    double radius = 0.0;
    for (const SolidGear& gear : body.gears()) radius = std::max(radius, reach(*gear.body));
    return 2 * radius + kBetween;
  };
  double area = 0.0, widest = 0.0;
  for (const ToothedBody& body : bodies) {
    const double size = size_of(body);
    area += size * size;
    widest = std::max(widest, size);
  }
  // Length of a row of solids, mm. With this length, the occupied area is nearly square.
  const double row = std::max(widest, 1.1 * std::sqrt(area));
  double x = 0.0, y = 0.0, tall = 0.0;
  for (ToothedBody& body : bodies) {
    const double size = size_of(body);
    if (x > 0.0 && x + size > row) {
      x = 0.0;
      y += tall;
      tall = 0.0;
    }
    const std::vector<SolidGear> gears = body.gears();
    const bool over = reach(*gears.back().body) > reach(*gears.front().body);
    const double way = over ? -1.0 : 1.0;
    body.pose = {
        Vec3(x + size / 2, y + size / 2, over ? gears.back().top() : -gears.front().bottom()),
        Mat3(Vec3(1.0, way, way).asDiagonal())};
    x += size;
    tall = std::max(tall, size);
  }
  return bodies;
}

}  // namespace gearwright
