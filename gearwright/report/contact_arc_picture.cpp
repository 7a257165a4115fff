#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/report_sections.hpp"

namespace gearwright {

namespace {

constexpr double kArcAspect = 640.0 / 460.0;
constexpr double kShown = 4.9;  // modules, width of a picture

// Returns the outline of five teeth of a rack, in the frame of the middle tooth of the convex
// gear's rack. Each point is (height towards the mating gear, position along the datum line). If
// `mate` is true, the outline is turned upside down and moved by half a pitch, which gives the rack
// of the mating gear.
std::vector<Vec2> rack_over_pitches(const Gear& gear, bool mate) {
  const double pitch = kPi * gear.spec.normal_module;
  const std::vector<Vec2> half = rack_half_tooth(gear);
  std::vector<Vec2> chain;
  for (int k = -2; k <= 2; ++k) {
    const double middle = k * pitch + (mate ? pitch / 2 : 0.0);
    for (const Vec2& p : half) chain.push_back({p.x(), middle - p.y()});
    for (auto p = half.rbegin(); p != half.rend(); ++p) chain.push_back({p->x(), middle + p->y()});
  }
  if (mate)
    for (Vec2& p : chain) p.x() = -p.x();
  return chain;
}

// Closes a chain of points to a polygon by a line at the height `depth` inside the material.
std::vector<Vec2> closed(std::vector<Vec2> chain, double depth) {
  const Vec2 first = chain.front();
  const Vec2 last = chain.back();
  chain.push_back({depth, last.y()});
  chain.push_back({depth, first.y()});
  return chain;
}

// Draws an empty figure of a plane. The middle of the figure is `up` mm above the origin.
Figure plane_of(const std::string& id, const std::string& title, const std::string& description,
                double m, double up) {
  const Vec2 middle(0.0, up), half(kShown * m / 2, kShown * m / kArcAspect / 2);
  return plane_figure(id, title, description, {middle - half, middle + half});
}

std::vector<Vec2> all_upright(std::vector<Vec2> points) {
  for (Vec2& p : points) p = upright(p);
  return points;
}

void add_material(Figure& f, const std::vector<Vec2>& chain, double depth, std::size_t gear) {
  f.area(all_upright(closed(chain, depth)), std::string("cut-solid ") + kInk[gear]);
  f.line(all_upright(chain), std::string("outline ") + kInk[gear]);
}

// Draws the radius from `center` to `at`, and the arc with this radius that extends 0.5 rad to
// either side of `at`.
void add_arc_radius(Figure& f, const Vec2& center, const Vec2& at, std::size_t gear, bool dashed) {
  const double turn = std::atan2(at.y() - center.y(), at.x() - center.x());
  const double radius = (at - center).norm();
  std::vector<Vec2> arc;
  for (int k = -24; k <= 24; ++k) {
    const double a = turn + k * 0.5 / 24;
    arc.push_back(upright(center + radius * Vec2(std::cos(a), std::sin(a))));
  }
  f.line(std::move(arc), std::string("thin dot ") + kInk[gear]);
  f.line({upright(center), upright(at)}, std::string(dashed ? "thin dash " : "thin ") + kInk[gear]);
  f.dot(upright(center), 3.4, std::string("mark ") + kInk[gear]);
}

struct Arcs {
  std::size_t convex, concave;  // indices of the two gears
  WorkingArc v, c;
};

Arcs arcs_of_contact(const ArcPair& pair, const ArcPairContact& contact, double theta) {
  const std::size_t convex = contact.convex_gear == 1 ? 0 : 1;
  Arcs best{};
  double least = 1e300;
  // Finds the convex and the concave arc that touch each other. Two arcs touch if their points at
  // the normal angle of the contact have the same height. The combination with the least difference
  // of these heights is used.
  for (const WorkingArc& v : convex_arcs(pair.gears[convex])) {
    for (const WorkingArc& c : concave_arcs(pair.gears[1 - convex])) {
      const double apart = std::abs((v.radius - c.radius) * std::sin(theta) - (v.b - c.b));
      if (apart >= least) continue;
      least = apart;
      best = {convex, 1 - convex, v, c};
    }
  }
  GW_ENSURES(least < 1e300);
  return best;
}

// Returns, for example, "■ gear 1, convex: ρ = … mm, a = … mm, b = … mm".
std::string arc_key(std::size_t gear, const char* shape, const WorkingArc& arc) {
  return fmt::format("{} {} = {} mm, {} = {} mm, {} = {} mm",
                     caption_key(kInk[gear], fmt::format("gear {}, {}:", gear + 1, shape)),
                     symbol_html("ρ"), fixed(arc.radius, 4), symbol_html("a"), fixed(arc.a, 4),
                     symbol_html("b"), fixed(arc.b, 4));
}

// Domain    the racks touch at the reference centre distance
Figure rack_figure(const ArcPair& pair, const ArcPairContact& contact) {
  const double theta = contact.nominal_theta->rad();
  const Arcs arcs = arcs_of_contact(pair, contact, theta);
  const double m = pair.gears[0].spec.normal_module;
  // Points (height, position along the datum line) in the frame of the convex tooth. The origin is
  // in the middle of this tooth, on the datum line.
  const Vec2 M(arcs.v.radius * std::sin(theta) - arcs.v.b,
               arcs.v.radius * std::cos(theta) - arcs.v.a);
  const Vec2 O_v(-arcs.v.b, -arcs.v.a);
  const Vec2 O_c(-arcs.c.b, -arcs.c.a);
  Figure f = plane_of("racks", "The racks in the normal section",
                      "Both racks in one normal section with their arcs, centres, radii and the "
                      "angle of the common normal to the pitch line.",
                      m, 0.05 * m);
  f.x.lo += 0.12 * m;
  f.x.hi += 0.12 * m;
  f.caption = fmt::format(
      ", with coincident pitch lines (dash-dotted). The arcs touch at M, where the angle of the "
      "normal to the pitch line is {} = {}°. The centres O lie {} beyond the middle of the tooth, "
      "seen from M, and {} below the pitch line.<br>{}<br>{}",
      symbol_html("θ_0"), fixed(theta * kDegPerRad, 3), symbol_html("a"), symbol_html("b"),
      arc_key(arcs.convex, "convex", arcs.v), arc_key(arcs.concave, "concave", arcs.c));
  const double deep = 3.0 * m;
  add_material(f, rack_over_pitches(pair.gears[arcs.convex], false), -deep, arcs.convex);
  add_material(f, rack_over_pitches(pair.gears[arcs.concave], true), deep, arcs.concave);
  f.line({{-4 * m, 0}, {4 * m, 0}}, "thin dashdot");
  f.line({{0, -deep}, {0, deep}}, "thin dashdot");
  add_arc_radius(f, O_c, M, arcs.concave, true);
  add_arc_radius(f, O_v, M, arcs.convex, false);
  const Vec2 n = (M - O_v).normalized();
  f.line({upright(M), upright(M + 1.1 * m * n)}, "action-line");
  // The angle θ_0 between the common normal and the pitch line is drawn where they cross.
  const Vec2 foot = M - n * (M.x() / n.x());
  const double around = 0.62 * m;
  std::vector<Vec2> angle;
  for (int k = 0; k <= 16; ++k) {
    const double a = theta * k / 16;
    angle.push_back(upright(foot + around * Vec2(std::sin(a), std::cos(a))));
  }
  f.line(std::move(angle), "one");
  f.text(upright(foot + around * Vec2(std::sin(theta / 2), std::cos(theta / 2))), symbol_svg("θ_0"),
         Anchor::start, "halo", {5, 5});
  f.dot(upright(M), 4.2, "mark action-dot");
  f.text(upright(M), "M", Anchor::middle, "letter halo", {2, -12});
  for (const auto& [center, gear, up] :
       {std::tuple(O_v, arcs.convex, true), std::tuple(O_c, arcs.concave, false)}) {
    const std::string number = std::to_string(gear + 1);
    f.text(upright(center), symbol_svg("O_" + number), Anchor::end,
           std::string("letter halo ") + kInk[gear], {-8, up ? -5.0 : 17.0});
    f.text(upright(center + 0.3 * (M - center)), symbol_svg("ρ_" + number), Anchor::middle,
           std::string("halo ") + kInk[gear], {0.0, up ? -12.0 : 24.0});
  }
  return f;
}

Figure teeth_figure(const ArcPair& pair, const ArcPairContact& contact) {
  const double m = pair.gears[0].spec.normal_module;
  Figure f = plane_of("arc-teeth", "Section of the teeth at the contact point",
                      "Section of both gears in the plane normal to the tooth at the contact "
                      "point, with the common normal.",
                      m, 0.0);
  f.caption = fmt::format(
      ", in the plane normal to the tooth. The gears are mounted without errors, and the normal "
      "angle of the racks at the contact is {}°.",
      fixed(contact.at.theta.deg(), 3));
  f.keys = {{"g1", "gear 1, below"}, {"g2", "gear 2, above"}, {"action", "common normal"}};
  const double deep = 4.0 * m;
  for (const std::size_t i : {1u, 0u})
    add_material(f, normal_section(pair, contact, i, 2), i == 0 ? -deep : deep, i);
  const NormalPlane plane = normal_plane(pair, contact);
  const Vec2 n =
      Vec2(contact.at.normal.x(), contact.at.normal.dot(plane.across)).normalized() * 1.4 * m;
  f.line({upright(-n), upright(n)}, "action-line");
  f.dot({0, 0}, 4.2, "mark action-dot");
  return f;
}

}  // namespace

std::vector<Vec2> rack_half_tooth(const Gear& gear) {
  GW_EXPECTS(gear.arc_cutter() != nullptr);
  const RackOfArcs& rack = *gear.arc_cutter();
  const double m = gear.spec.normal_module;
  const double thinner = gear.spec.thickness_allowance / 2;
  std::vector<Vec2> points{{-rack.dedendum * m, kPi * m / 2}};
  for (const RackArc& arc : rack.arcs) {
    constexpr int kSteps = 32;
    for (int k = 0; k <= kSteps; ++k) {
      const double tau = arc.begin.rad() + k * (arc.end.rad() - arc.begin.rad()) / kSteps;
      const Vec2 p = m * point_at(arc, Angle::radians(tau)) + Vec2(0.0, thinner);
      const Vec2 last = points.back();
      if (p.x() > rack.addendum * m) {
        const double t = (rack.addendum * m - last.x()) / (p.x() - last.x());
        points.push_back(last + t * (p - last));
        points.push_back({rack.addendum * m, 0.0});
        return points;
      }
      points.push_back({p.x(), std::max(0.0, p.y())});
    }
  }
  points.push_back({points.back().x(), 0.0});
  return points;
}

NormalPlane normal_plane(const ArcPair& pair, const ArcPairContact& contact) {
  // The tooth traces of the rack are inclined by the helix angle to one side or to the other. The
  // correct trace lies in the flank, so it is perpendicular to the normal.
  const double beta = pair.gears[0].spec.helix_angle.rad();
  const Vec3& n = contact.at.normal;
  Vec3 best(0, std::sin(beta), std::cos(beta));
  const Vec3 other(0, -std::sin(beta), std::cos(beta));
  if (std::abs(other.dot(n)) < std::abs(best.dot(n))) best = other;
  // The common normal points out of gear 1, to the right in the picture.
  if (best.cross(Vec3(1, 0, 0)).dot(n) < 0.0) best = -best;
  return {contact.at.point, best.cross(Vec3(1, 0, 0)), best};
}

std::vector<Vec2> normal_section(const ArcPair& pair, const ArcPairContact& contact, std::size_t i,
                                 int teeth) {
  const Gear& gear = pair.gears[i];
  const NormalPlane plane = normal_plane(pair, contact);
  const Vec3 axis(i == 0 ? 0.0 : pair.center_distance, 0.0, 0.0);
  const double facing = i == 0 ? 0.0 : kPi;
  const double pitch = 2 * kPi / std::abs(gear.spec.teeth);
  const double start = angles_at_contact(pair, contact)[i];
  const double nearest = std::round((facing - start) / pitch);
  std::vector<Vec2> tooth;  // from space to space, by increasing polar angle
  std::vector<Vec2> half;
  for (const Arc& arc : gear.tooth->outline.arcs)
    for (const Vec2& p : chords(arc, 1e-4 * gear.spec.normal_module)) half.push_back(p);
  for (const Vec2& p : half) tooth.push_back({p.x(), -p.y()});
  tooth.insert(tooth.end(), half.rbegin(), half.rend());
  std::vector<Vec2> section;
  for (int k = -teeth; k <= teeth; ++k) {
    const double turned = start + (nearest + k) * pitch;
    for (const Vec2& p : tooth) {
      const double radius = p.norm();
      const double polar = turned + std::atan2(p.y(), p.x());
      // The helix of the points r intersects the plane where (r − p)·t = 0. Here p is the origin of
      // the plane, and t is its normal. Newton's method starts in the transverse section of the
      // contact point.
      double z = plane.origin.z();
      Vec3 r;
      for (int step = 0; step < 50; ++step) {
        const double a = polar + gear.twist() * (z - plane.origin.z());
        r = axis + Vec3(radius * std::cos(a), radius * std::sin(a), z);
        const double off = (r - plane.origin).dot(plane.along);
        const double slope = gear.twist() * radius *
                                 (-std::sin(a) * plane.along.x() + std::cos(a) * plane.along.y()) +
                             plane.along.z();
        if (std::abs(off) < 1e-12 * radius) break;
        z -= off / slope;
      }
      section.push_back({r.x() - plane.origin.x(), (r - plane.origin).dot(plane.across)});
    }
  }
  return section;
}

std::vector<Figure> arc_contact_figures(const ArcPair& pair) {
  if (pair.contacts.empty()) return {};
  const ArcPairContact& contact = pair.first_contact();
  std::vector<Figure> figures;
  if (contact.nominal_theta) figures.push_back(rack_figure(pair, contact));
  figures.push_back(teeth_figure(pair, contact));
  return figures;
}

}  // namespace gearwright
