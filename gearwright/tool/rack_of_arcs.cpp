#include "gearwright/tool/rack_of_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// Two arcs are tangent at their joint if their normals differ by at most this angle.
constexpr double kSameNormal = 1e-6;  // rad
constexpr double kAbove90 = 1e-15;    // rounding error of 90°, relative to 90°
constexpr double kOverlap = 1e-12;    // rounding error of y at the tip, relative to half the pitch

Error bad_arc(std::size_t i, std::string rule) {
  return {fmt::format("rack.arcs[{}]", i + 1), "", std::move(rule)};
}

std::optional<Error> check_arc(const RackArc& arc, std::size_t i) {
  for (const double v : {arc.center_height, arc.center_offset, arc.radius}) {
    if (!(std::abs(v) <= kMaxModules))
      return bad_arc(i, fmt::format("lengths must be at most {} modules", kMaxModules));
  }
  for (const Angle tau : {arc.begin, arc.end}) {
    if (!(tau.rad() > 0.0 && tau.rad() <= kHalfPi * (1 + kAbove90)))
      return bad_arc(i,
                     fmt::format("normal angles must be greater than 0° and at most 90°, not {}°",
                                 format_number(tau.deg(), 90.0)));
  }
  if (arc.radius != 0.0 && (arc.radius > 0.0) != (arc.end.rad() > arc.begin.rad())) {
    return bad_arc(
        i, fmt::format("from {}° to {}° the arc turns back towards the axis of the gear, but an "
                       "edge must rise from the tip of the cutter; the normal angle must increase "
                       "along an arc with a radius > 0 and decrease along an arc with a radius < 0",
                       format_number(arc.begin.deg(), arc.end.deg()),
                       format_number(arc.end.deg(), arc.begin.deg())));
  }
  if (arc.radius == 0.0 && !(arc.end.rad() < arc.begin.rad()))
    return bad_arc(i, "the normal angle must decrease at a corner (an arc with radius 0)");
  return std::nullopt;
}

// Returns the chain of arcs, with corners inserted. Each arc is moved so that it begins where the
// previous arc ends.
Result<std::vector<RackArc>> joined(const RackOfArcs& rack) {
  std::vector<RackArc> chain;
  for (std::size_t i = 0; i < rack.arcs.size(); ++i) {
    RackArc arc = rack.arcs[i];
    if (auto error = check_arc(arc, i)) return *error;
    const Vec2 begin = point_at(arc, arc.begin);
    if (chain.empty()) {
      if (std::abs(begin.x() + rack.dedendum) > kSameRackPoint) {
        return bad_arc(i, fmt::format("begins {} modules below the datum line, but must begin at "
                                      "the tip of the cutter, which is {} modules below the datum "
                                      "line (the dedendum)",
                                      format_number(-begin.x(), rack.dedendum),
                                      format_number(rack.dedendum, -begin.x())));
      }
      arc.center_height -= begin.x() + rack.dedendum;
      if (arc.begin.rad() < kHalfPi - kSameNormal)
        chain.push_back({ArcName::root_fillet, -rack.dedendum, begin.y(), 0.0,
                         Angle::radians(kHalfPi), arc.begin, false});
      chain.push_back(arc);
      continue;
    }
    const Vec2 end = point_at(chain.back(), chain.back().end);
    const Vec2 gap = end - begin;
    if (!(gap.norm() <= kSameRackPoint)) {
      return bad_arc(i, fmt::format("begins at ({}, {}), which is {} modules from the end of the "
                                    "previous arc; an arc must begin where the previous arc ends",
                                    format_number(begin.x()), format_number(begin.y()),
                                    format_number(gap.norm())));
    }
    arc.center_height += gap.x();
    arc.center_offset += gap.y();
    const Angle before = chain.back().end;
    if (before.rad() > arc.begin.rad() + kSameNormal)
      chain.push_back({chain.back().cuts, end.x(), end.y(), 0.0, before, arc.begin, false});
    chain.push_back(arc);
  }
  return chain;
}

// If a shift by `thinner` (modules) makes the two sides cross, the last arc is shortened to the
// point where they meet.
void end_in_the_middle(RackArc& arc, double thinner) {
  const double c = -(arc.center_offset + thinner) / arc.radius;
  const bool crossed = point_at(arc, arc.end).y() + thinner < 0.0;
  const bool before = point_at(arc, arc.begin).y() + thinner > 0.0;
  if (thinner < 0.0 && arc.radius != 0.0 && crossed && before)
    arc.end = Angle::radians(std::acos(c));
}

}  // namespace

Vec2 point_at(const RackArc& arc, Angle tau) {
  return {arc.center_height + arc.radius * std::sin(tau.rad()),
          arc.center_offset + arc.radius * std::cos(tau.rad())};
}

RackArc tip_rounding(double height, double offset, double radius, Angle end) {
  return {ArcName::root_fillet, height, offset, -radius, Angle::radians(kHalfPi), end, false};
}

double reach(const RackOfArcs& rack) {
  GW_EXPECTS(!rack.arcs.empty());
  return point_at(rack.arcs.back(), rack.arcs.back().end).x();
}

std::optional<double> half_thickness_on_datum(const RackOfArcs& rack) {
  for (const RackArc& arc : rack.arcs) {
    if (point_at(arc, arc.begin).x() > 0.0 || point_at(arc, arc.end).x() < 0.0) continue;
    if (arc.radius == 0.0) return arc.center_offset;
    const double s = -arc.center_height / arc.radius;
    return arc.center_offset + arc.radius * std::sqrt((1.0 - s) * (1.0 + s));
  }
  return std::nullopt;
}

Result<CutterEdge> make_edge(const RackOfArcs& rack, double m, double thickness_allowance) {
  GW_EXPECTS(m > 0.0);
  if (!(std::abs(rack.addendum) <= kMaxModules))
    return refused("rack.addendum", rack.addendum, {-kMaxModules, kMaxModules},
                   "must lie between {} and {} modules");
  if (!(std::abs(rack.dedendum) <= kMaxModules && rack.dedendum > -rack.addendum)) {
    return refused(
        "rack.dedendum", rack.dedendum,
        fmt::format("must be greater than {}, the negative of the addendum, and at most {}",
                    format_number(0.0 - rack.addendum), kMaxModules));
  }
  if (rack.arcs.empty())
    return Error{"rack.arcs", "", "is empty; an edge needs at least one arc that cuts the flank"};
  auto joined_arcs = joined(rack);
  if (!joined_arcs) return joined_arcs.error();
  std::vector<RackArc> chain = std::move(joined_arcs).take();
  const bool any_flank = std::any_of(chain.begin(), chain.end(), [](const RackArc& arc) {
    return arc.cuts == ArcName::flank && arc.radius != 0.0;
  });
  if (!any_flank) return Error{"rack.arcs", "", "none of these arcs cuts the flank"};

  const double thinner = thickness_allowance / 2;
  end_in_the_middle(chain.back(), thinner / m);
  CutterEdge edge{};
  edge.tip_depth = rack.dedendum * m;
  const Vec2 first = point_at(chain.front(), chain.front().begin);
  edge.tip_land_end = first.y() * m + thinner;
  if (first.y() * m + thinner > kHalfPi * m * (1 + kOverlap)) {
    return refused(
        "rack.dedendum", rack.dedendum,
        fmt::format("the two sides of the tip of the cutter overlap by {} modules at this depth",
                    format_number(2 * (first.y() + thinner / m - kHalfPi))));
  }
  std::optional<double> flank_begin;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const RackArc& arc = chain[i];
    const Vec2 begin = point_at(arc, arc.begin);
    const Vec2 end = point_at(arc, arc.end);
    if (end.y() * m + thinner < -kSameRackPoint * m) {
      return refused(
          "rack.addendum", rack.addendum,
          fmt::format("the two sides of the tooth space of the cutter overlap by {} modules at the "
                      "height {}",
                      format_number(-2 * (end.y() + thinner / m)), format_number(end.x())));
    }
    if (arc.cuts == ArcName::flank && arc.radius != 0.0) {
      if (!flank_begin) flank_begin = begin.x() * m;
      edge.flank_end_height = end.x() * m;
    }
    const bool smooth = i == 0 || std::abs(chain[i - 1].end.rad() - arc.begin.rad()) <= kSameNormal;
    const Vec2 center(arc.center_height * m, arc.center_offset * m + thinner);
    edge.arcs.push_back({arc.cuts, EdgeCircle{center, arc.radius * m, arc.begin, arc.end}, smooth});
  }
  edge.flank_begin_depth = -*flank_begin;
  edge.bottom_height = point_at(chain.back(), chain.back().end).x() * m;
  if (!(rack.addendum * m <= edge.bottom_height)) {
    return refused(
        "rack.addendum", rack.addendum, {edge.bottom_height / m},
        "the arcs end {} modules above the datum line; the addendum must not exceed this height");
  }
  return edge;
}

}  // namespace gearwright
