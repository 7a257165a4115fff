#include "gearwright/cad/brep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/cad/rack_plan.hpp"

namespace gearwright {

namespace {

using RackId = Part21Id;

struct RackNode {
  Vec3 at;
  RackId point, vertex;
};

// An edge with the direction in which a face uses it.
struct RackUse {
  RackId edge;
  bool forward;
  RackUse reversed() const { return {edge, !forward}; }
};

using RackLoop = std::vector<RackUse>;

RackLoop reversed(const RackLoop& loop) {
  RackLoop back;
  for (auto use = loop.rbegin(); use != loop.rend(); ++use) back.push_back(use->reversed());
  return back;
}

class RackShell {
 public:
  RackShell(Part21& out, const ToothedBody& body)
      : out_(out), body_(body), plan_(body), q_(plan_.slope()) {}

  Brep write() {
    const bool spur = q_ == 0.0;
    Station before = station(plan_.first());
    const Station start = before;
    RackLoop low, high;  // along the border, from the first line of constant s to the last
    std::optional<RackUse> first_line, line;
    if (spur) first_line = line = straight(before.low, before.high);
    // Number of pieces of the border in `low` and in `high` before the corner of the bar.
    std::size_t low_cut = 0, high_cut = 0;
    std::optional<RackNode> low_corner, high_corner;
    for (const RackStrip& strip : plan_.strips()) {
      const Station after = station(strip.end);
      const auto chain = [&](bool is_low, RackLoop& whole, std::size_t& cut,
                             std::optional<RackNode>& corner) {
        const double s = is_low ? plan_.low_corner() : plan_.high_corner();
        RackNode from = is_low ? before.low : before.high;
        const RackNode to = is_low ? after.low : after.high;
        RackLoop part;
        const bool inside = !spur && s > strip.begin && s < strip.end;
        if (inside) {
          const Vec2 c = is_low ? plan_.low(s) : plan_.high(s);
          const RackNode middle = node({height(strip, s), c.x(), c.y()});
          part.push_back(border(strip, from, middle));
          from = middle;
          corner = middle;
          cut = whole.size() + 1;
        }
        part.push_back(border(strip, from, to));
        whole.insert(whole.end(), part.begin(), part.end());
        if (!spur && s == strip.end) {
          corner = to;
          cut = whole.size();
        }
        return part;
      };
      const RackLoop lower = chain(true, low, low_cut, low_corner);
      const RackLoop upper = chain(false, high, high_cut, high_corner);
      RackLoop loop = lower;
      const bool closes = !spur && &strip == &plan_.strips().back();
      std::optional<RackUse> next;
      if (!closes) {
        next = straight(after.low, after.high);
        loop.push_back(*next);
      }
      for (const RackUse& use : reversed(upper)) loop.push_back(use);
      if (line) loop.push_back(line->reversed());
      add_face(loop, surface(strip), strip.name == ArcName::root_fillet ? ".F." : ".T.");
      line = next;
      before = after;
    }
    if (spur) {
      add_border_spur(start, before, *first_line, *line, low, high);
    } else {
      add_border(start.low, before.low, *low_corner, *high_corner, split(low, low_cut),
                 split(high, high_cut));
    }
    std::string shell = "CLOSED_SHELL('',";
    append_ids(shell, faces_);
    const RackId closed = out_.add(shell + ")");
    const RackId solid =
        out_.add(fmt::format("MANIFOLD_SOLID_BREP({},#{})", part21_string(body_.name), closed));
    return {solid, faces_.size(), edges_};
  }

 private:
  struct Station {
    RackNode low, high;
  };
  using Halves = std::pair<RackLoop, RackLoop>;

  static Halves split(const RackLoop& loop, std::size_t at) {
    const auto middle = loop.begin() + static_cast<std::ptrdiff_t>(at);
    return {RackLoop(loop.begin(), middle), RackLoop(middle, loop.end())};
  }

  double rho() const { return body_.rack->fillet_radius; }
  double stretch() const { return std::hypot(1.0, q_); }

  // Returns the axis of the cylinder of a fillet in the section z = 0, (x, s).
  Vec2 axis_of(const RackStrip& strip) const {
    const Vec2& root = strip.arc->begin_point;
    return {root.x() + rho(), strip.middle + (strip.lower ? -root.y() : root.y())};
  }

  double height(const RackStrip& strip, double s) const {
    const Vec2 &a = strip.arc->begin_point, &b = strip.arc->end_point;
    if (strip.name == ArcName::root_fillet) {
      const Vec2 c = axis_of(strip);
      const double n = std::clamp((s - c.y()) / stretch(), -rho(), rho());
      return c.x() - std::sqrt((rho() - n) * (rho() + n));
    }
    if (a.y() == b.y() || a.x() == b.x()) return a.x();
    const double y = strip.lower ? strip.middle - s : s - strip.middle;
    return a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
  }

  RackNode node(const Vec3& at) {
    const RackId point = out_.point(at);
    return {at, point, out_.add(fmt::format("VERTEX_POINT('',#{})", point))};
  }

  // The strip that ends at a line of constant s determines the height at this line. At the first
  // line, the first strip determines the height.
  Station station(double s) {
    const auto& strips = plan_.strips();
    const auto strip = std::find_if(strips.begin(), strips.end() - 1,
                                    [&](const RackStrip& t) { return s <= t.end; });
    const double x = height(*strip, s);
    const Vec2 l = plan_.low(s), h = plan_.high(s);
    const RackNode low = node({x, l.x(), l.y()});
    const bool corner = q_ != 0.0 && (s == plan_.first() || s == plan_.last());
    return {low, corner ? low : node({x, h.x(), h.y()})};
  }

  RackUse edge(const RackNode& from, const RackNode& to, RackId curve, const char* sense = ".T.") {
    ++edges_;
    return {out_.add(
                fmt::format("EDGE_CURVE('',#{},#{},#{},{})", from.vertex, to.vertex, curve, sense)),
            true};
  }

  RackUse straight(const RackNode& from, const RackNode& to) {
    const RackId direction = out_.direction((to.at - from.at).normalized());
    const RackId vector = out_.add(fmt::format("VECTOR('',#{},1.)", direction));
    return edge(from, to, out_.add(fmt::format("LINE('',#{},#{})", from.point, vector)));
  }

  // Returns the part of a strip's border between two points on the same side of the bar.
  RackUse border(const RackStrip& strip, const RackNode& from, const RackNode& to) {
    if (strip.name != ArcName::root_fillet) return straight(from, to);
    const Vec2 c = axis_of(strip);
    const bool on_side = from.at.z() == to.at.z();
    // The plane z = const or y = const intersects the cylinder in an ellipse. One axis of the
    // ellipse is parallel to x.
    const double across = on_side ? stretch() * rho() : stretch() * rho() / std::abs(q_);
    const Vec3 center = on_side ? Vec3(c.x(), c.y() + q_ * from.at.z(), from.at.z())
                                : Vec3(c.x(), from.at.y(), (from.at.y() - c.y()) / q_);
    const Vec3 wide = on_side ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 down(-1, 0, 0);
    // The curve runs counter-clockwise about this axis, from −x to `wide`.
    const Vec3 about = down.cross(wide);
    const bool along = (to.at - from.at).dot(wide) > 0.0;
    const RackId origin = out_.point(center), axis = out_.direction(about),
                 reference = out_.direction(-wide);
    const RackId place = out_.placement(origin, axis, reference);
    std::string text = across == rho() ? fmt::format("CIRCLE('',#{},", place)
                                       : fmt::format("ELLIPSE('',#{},", place);
    append_real(text, across);
    if (across != rho()) {
      text += ',';
      append_real(text, rho());
    }
    return edge(from, to, out_.add(text + ")"), along ? ".T." : ".F.");
  }

  RackId plane(const Vec3& at, const Vec3& normal, const Vec3& along) {
    const RackId origin = out_.point(at), z = out_.direction(normal), x = out_.direction(along);
    return out_.add(fmt::format("PLANE('',#{})", out_.placement(origin, z, x)));
  }

  RackId surface(const RackStrip& strip) {
    const Vec3 tooth = Vec3(0, q_, 1).normalized();
    if (strip.name == ArcName::root_fillet) {
      const Vec2 c = axis_of(strip);
      const RackId origin = out_.point({c.x(), c.y(), 0}), axis = out_.direction(tooth),
                   away = out_.direction({1, 0, 0});
      std::string text =
          fmt::format("CYLINDRICAL_SURFACE('',#{},", out_.placement(origin, axis, away));
      append_real(text, rho());
      return out_.add(text + ")");
    }
    const Vec2 way = strip.arc->end_point - strip.arc->begin_point;
    const double slope = (strip.lower ? -1 : 1) * way.x() / way.y();
    const double s = strip.middle + (strip.lower ? -1 : 1) * strip.arc->begin_point.y();
    return plane({strip.arc->begin_point.x(), s, 0}, Vec3(1, -slope, q_ * slope).normalized(),
                 tooth);
  }

  void add_face(const RackLoop& loop, RackId surface, const char* sense = ".T.") {
    std::vector<RackId> uses;
    for (const RackUse& use : loop)
      uses.push_back(out_.add(
          fmt::format("ORIENTED_EDGE('',*,*,#{},{})", use.edge, use.forward ? ".T." : ".F.")));
    std::string text = "EDGE_LOOP('',";
    append_ids(text, uses);
    const RackId closed = out_.add(text + ")");
    const RackId bound = out_.add(fmt::format("FACE_OUTER_BOUND('',#{},.T.)", closed));
    faces_.push_back(
        out_.add(fmt::format("ADVANCED_FACE('',(#{}),#{},{})", bound, surface, sense)));
  }

  // An upright edge of the bar, with its lower end.
  struct Foot {
    RackNode at;
    RackUse down;  // runs from the teeth down to the back
  };
  Foot foot(const RackNode& top) {
    const RackNode at = node({-body_.rack->height, top.at.y(), top.at.z()});
    return {at, straight(top, at)};
  }
  // Adds the wall below `top`, which is a part of the border. `top` begins above `a`, ends above
  // `b`, and has the metal on its left. Returns the lower edge of the wall.
  RackUse add_wall(const RackLoop& top, const Foot& a, const Foot& b, const Vec3& normal) {
    const RackUse floor = straight(a.at, b.at);
    RackLoop loop = reversed(top);
    loop.push_back(a.down);
    loop.push_back(floor);
    loop.push_back(b.down.reversed());
    add_face(loop, plane(a.at.at, normal, (b.at.at - a.at.at).normalized()));
    return floor;
  }
  void add_back(const RackLoop& counter_clockwise) {
    add_face(reversed(counter_clockwise),
             plane({-body_.rack->height, 0, 0}, {-1, 0, 0}, {0, 0, 1}));
  }

  void add_border_spur(const Station& start, const Station& end, const RackUse& first,
                       const RackUse& last, const RackLoop& low, const RackLoop& high) {
    const Foot a = foot(start.low), b = foot(end.low), c = foot(end.high), d = foot(start.high);
    add_back({add_wall(low, a, b, {0, 0, -1}), add_wall({last}, b, c, {0, 1, 0}),
              add_wall(reversed(high), c, d, {0, 0, 1}),
              add_wall({first.reversed()}, d, a, {0, -1, 0})});
  }

  // Adds the walls below the border of the teeth, and the back. The border runs along the low chain
  // and returns along the high chain, which is counter-clockwise seen from above the teeth.
  void add_border(const RackNode& start, const RackNode& end, const RackNode& low_corner,
                  const RackNode& high_corner, const Halves& low, const Halves& high) {
    const Foot a = foot(start), b = foot(low_corner), c = foot(end), d = foot(high_corner);
    const Vec3 y(0, 1, 0), z(0, 0, 1);
    const bool up = q_ > 0.0;  // if true, the low chain starts along the end y = −l/2
    add_back({add_wall(low.first, a, b, up ? -y : -z), add_wall(low.second, b, c, up ? -z : y),
              add_wall(reversed(high.second), c, d, up ? y : z),
              add_wall(reversed(high.first), d, a, up ? z : -y)});
  }

  Part21& out_;
  const ToothedBody& body_;
  RackPlan plan_;
  double q_;
  std::vector<RackId> faces_;
  std::size_t edges_ = 0;
};

}  // namespace

std::size_t rack_face_count(const ToothedBody& body) { return RackPlan(body).strips().size() + 5; }

Brep add_rack_brep(Part21& out, const ToothedBody& body) { return RackShell(out, body).write(); }

}  // namespace gearwright
