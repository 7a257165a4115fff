// Finds overlaps and contacts beyond the flanks from the gaps between the two finished outlines.
//
//   g_f    gap of the flanks: half their play, as a rotation of gear 2     g  gap of two other arcs
//   h      arm of the common normal of these arcs about axis 2, mm
//   early  (g_f − g) h, mm along the normal; if early > 0, the arcs touch before the flanks do
//
// If g < 0, the arcs overlap by −g h even in the middle of the play. [T2.34]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/pair/collision.hpp"
#include "gearwright/pair/crossed_gap.hpp"
#include "gearwright/pair/interference.hpp"

namespace gearwright {

namespace {

// The causes are in the same order as in the documents.
constexpr std::array kCauses{
    CauseMeaning{CollisionCause::tip_bulge, "tip_bulge", "a tip that projects beyond its involute"},
    CauseMeaning{CollisionCause::tip_to_fillet, "tip_to_fillet",
                 "a part of the mating gear's tip and a root fillet"},
    CauseMeaning{CollisionCause::tip_corner, "tip_corner", "a tip corner and a flank"},
    CauseMeaning{
        CollisionCause::trochoid, "trochoid",
        "the tip corner of the pinion and the internal gear of an internal pair, at entry or exit"},
    CauseMeaning{CollisionCause::root, "root",
                 "a tip below the root circle of the mating gear; in this case, other causes and "
                 "the free rotation are not computed"},
    CauseMeaning{CollisionCause::negative_backlash, "negative_backlash",
                 "the flanks themselves, because the teeth are too thick for this centre distance"},
    CauseMeaning{CollisionCause::outline, "outline", "other parts of the outlines"},
    CauseMeaning{CollisionCause::form_circle, "form_circle",
                 "the outlines do not overlap, but the tip of the mating gear passes the form "
                 "circle; no other arc touches before the flanks"},
    CauseMeaning{CollisionCause::base_tangent, "base_tangent",
                 "the outlines do not overlap, but the tip of the mating gear passes the base "
                 "tangent point; no other arc touches before the flanks"}};

}  // namespace

std::span<const CauseMeaning> collision_causes() { return kCauses; }

const char* to_string(CollisionCause cause) {
  const auto row = std::find_if(kCauses.begin(), kCauses.end(),
                                [&](const CauseMeaning& m) { return m.cause == cause; });
  GW_ENSURES(row != kCauses.end());
  return row->text;
}

}  // namespace gearwright

namespace gearwright::detail {

namespace {

// Greatest rounding error of the gap between outlines that touch by construction.
constexpr double kTouching = 6e-10;  // relative to the module
double touching(const MountedGears& p) { return kTouching * p.gears[0].spec.normal_module; }

std::string words(ArcName name) {
  std::string text(to_string(name));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string part(const OutlineTouch& touch, int gear) {
  const OutlinePlace& place = touch.places[gear - 1];
  const bool tip_corner = place.corner && place.arc == ArcName::flank;
  return fmt::format("{} of gear {}", tip_corner ? std::string("tip corner") : words(place.arc),
                     gear);
}

// Returns the gear that touches with an arc of this name, or 0 if neither gear does.
int gear_with(const OutlineTouch& touch, ArcName arc) {
  for (int i : {0, 1}) {
    if (touch.places[static_cast<std::size_t>(i)].arc == arc) return i + 1;
  }
  return 0;
}

struct Cause {
  CollisionCause what;
  int gear;
};

Cause cause_of(const MountedGears& p, const OutlineTouch& touch) {
  if (const int gear = gear_with(touch, ArcName::root_fillet))
    return {CollisionCause::tip_to_fillet, gear};
  if (const int gear = gear_with(touch, ArcName::tip_fillet);
      gear > 0 && p.gears[gear - 1].tip_bulge)
    return {CollisionCause::tip_bulge, gear};
  // The tip corner of a pinion can cut into a tooth of an internal gear when the corner enters or
  // leaves the tooth space.
  if (touch.places[0].corner)
    return p.gears[1].internal() ? Cause{CollisionCause::trochoid, 2}
                                 : Cause{CollisionCause::tip_corner, 2};
  if (touch.places[1].corner) return {CollisionCause::tip_corner, 1};
  return {CollisionCause::outline, 0};
}

// Returns the sentence of a message about a tip that projects beyond the involute. It is empty if
// the collision has another cause.
std::string bulge(const MountedGears& p, const Cause& cause) {
  if (cause.what != CollisionCause::tip_bulge) return "";
  const Gear& gear = p.gears[cause.gear - 1];
  return fmt::format(
      " The tip of gear {} projects beyond its involute above a diameter of {:.4f} mm.", cause.gear,
      gear.tip_bulge->from_diameter);
}

std::string at(const OutlineTouch& touch) {
  return fmt::format("at {:.3f}° of gear 1", Angle::radians(touch.rotation_1).deg());
}

// Example: "0.0195 mm", or "0.074 µm" for a length below 1 µm.
std::string length_text(double mm) {
  return mm < kMmPerUm ? fmt::format("{:.2g} µm", kUmPerMm * mm) : fmt::format("{:.4g} mm", mm);
}

Collision overlapping(const MountedGears& p, const OutlineTouch& touch) {
  const Cause cause = cause_of(p, touch);
  const double depth = -touch.gap * touch.arm;
  return {cause.what, cause.gear, depth, touch,
          fmt::format("The {} and the {} overlap by {}, {}.{}", part(touch, 1), part(touch, 2),
                      length_text(depth), at(touch), bulge(p, cause))};
}

Collision beyond(const MountedGears& p, const OutlineTouch& touch, double early) {
  const Cause cause = cause_of(p, touch);
  return {
      cause.what, cause.gear, early, touch,
      fmt::format("The {0} and the {1} touch {3}, when the flanks are still {2} apart. In this "
                  "position, the ratio is not constant.{4}",
                  part(touch, 1), part(touch, 2), length_text(early), at(touch), bulge(p, cause))};
}

// Returns the collision of a tip that extends below the root circle of the mating gear. Its depth
// is greatest on the centre line. In a crossed internal pair, the depth is greatest at an end of a
// face, and the result has no position.
Collision in_root(const MountedGears& p, int tip) {
  const std::size_t i = tip - 1;
  const double depth = -p.tip_clearance[i];
  OutlineTouch touch;
  touch.gap = 0.0;
  const double r = p.gears[i].actual_tip_radius();
  touch.point = tip == 1 ? Vec2(p.side() * r, 0.0) : Vec2(p.center_distance - r, 0.0);
  touch.rotation_1 = tip == 1 ? 0.0 : std::numbers::pi / p.gears[0].spec.teeth;
  touch.places[i] = {ArcName::tip_land, false};
  touch.places[1 - i] = {ArcName::root_land, false};
  return {CollisionCause::root, 3 - tip, depth,
          p.crossed_inside() ? std::nullopt : std::optional(touch),
          fmt::format("The tip of gear {} cuts {:.4g} mm into the root of gear {}.", tip, depth,
                      3 - tip)};
}

Collision too_thick(double normal_play, const std::optional<OutlineTouch>& touch) {
  const double depth = -normal_play / 2;
  return {CollisionCause::negative_backlash, 0, depth, touch,
          fmt::format("The flanks overlap by {:.4g} mm on either side, because the teeth are too "
                      "thick for this centre distance.",
                      depth)};
}

bool flank_on_flank(const OutlineTouch& touch) {
  return touch.places[0].arc == ArcName::flank && touch.places[1].arc == ArcName::flank;
}

void deepest_first(std::vector<Collision>& collisions) {
  std::stable_sort(collisions.begin(), collisions.end(),
                   [](const Collision& a, const Collision& b) { return a.depth > b.depth; });
}

// True if one of the collisions confirms the finding.
bool borne_out(const Interference& named, const std::vector<Collision>& collisions) {
  return std::any_of(collisions.begin(), collisions.end(), [&](const Collision& s) {
    if (named.code == WarningCode::trochoid) return s.cause == CollisionCause::trochoid;
    return (s.cause == CollisionCause::tip_to_fillet || s.cause == CollisionCause::tip_corner) &&
           s.gear == named.gear;
  });
}

bool is_of_a_circle(const Interference& named) {
  return named.code == WarningCode::form_circle || named.code == WarningCode::base_tangent;
}

// Matches the overlaps with the findings of interference.hpp. If no finding explains an overlap, a
// finding is added. If a finding explains no overlap, it is removed. A removed finding that is
// based on a circle becomes a contact beyond the flank.
void explain(InvolutePair& p) {
  std::vector<Interference> named = std::exchange(p.interference, {});
  const auto explained = [&](const Collision& s, const std::vector<Interference>& by) {
    return std::any_of(by.begin(), by.end(),
                       [&](const Interference& i) { return borne_out(i, {s}); });
  };
  std::vector<Interference> only_beyond;
  for (Interference& i : named) {
    if (borne_out(i, *p.overlap)) {
      p.interference.push_back(std::move(i));
    } else if (is_of_a_circle(i)) {
      only_beyond.push_back(std::move(i));
    }
  }
  for (const Collision& s : *p.overlap) {
    if (s.cause == CollisionCause::negative_backlash || explained(s, p.interference)) continue;
    const auto code = s.cause == CollisionCause::tip_to_fillet ? WarningCode::tip_to_fillet
                                                               : WarningCode::overlap;
    p.interference.push_back({code, s.gear, -s.depth, s.message, true});
  }
  // If a finding based on a circle and a collision of the outlines have the same cause, only the
  // collision is reported.
  std::vector<Collision>& collisions = p.beyond_flank;
  for (Interference& i : only_beyond) {
    if (borne_out(i, collisions)) continue;
    const auto circle = i.code == WarningCode::form_circle ? CollisionCause::form_circle
                                                           : CollisionCause::base_tangent;
    collisions.push_back({circle, i.gear, -std::get<double>(i.amount), std::nullopt, i.message});
  }
  deepest_first(collisions);
}

// Returns the touches whose gap may be smaller than the gap of the flanks. On parallel axes, the
// result also contains the touches of a flank with a flank.
std::vector<OutlineTouch> touches_of(const CrossedPair& p, double) { return crossed_gaps(p); }
std::vector<OutlineTouch> touches_of(const MountedGears& p, double half_play) {
  std::vector<OutlineTouch> touches;
  const OutlineGap gap = outline_gap(p.gears[0].tooth->outline, p.gears[1].tooth->outline,
                                     p.center_distance, half_play);
  for (const auto& row : gap.touches) {
    for (const auto& touch : row) {
      if (touch) touches.push_back(*touch);
    }
  }
  return touches;
}

// Depth to which the flanks overlap beside the line of action, mm. To second order, the depth grows
// with the square of the distance from the contact, and at the distance b/2 it equals the needed
// lead crowning. The contact lies up to f'/2 from the middle of the face, so every point of the
// face is within (b + f')/2 of the contact. Higher orders add less than half of this depth.
double saddle_depth(const CrossedPair& p) {
  constexpr double kHigherOrders = 1.5;
  double depth = 0.0;
  for (std::size_t i : {0U, 1U}) {
    const double off = std::min(1.0, p.face_widths.both_flanks[i] / p.input.face_width[i]);
    depth = std::max(depth, p.needed_crowning[i].value_or(0.0) * (1 + off) * (1 + off));
  }
  return kHigherOrders * depth;
}

template <class Kind>
void collide(Kind& p, double half_play, double normal_play, double saddle) {
  const double close = touching(p);
  p.overlap.emplace();
  for (int tip : {1, 2}) {
    if (p.tip_clearance[tip - 1] < -close) p.overlap->push_back(in_root(p, tip));
  }
  if (!p.overlap->empty()) return;
  double least = half_play;
  const bool too_thick_teeth = -normal_play / 2 > close;
  constexpr bool flanks_compared = !std::is_same_v<Kind, CrossedPair>;
  if (too_thick_teeth && !flanks_compared)
    p.overlap->push_back(too_thick(normal_play, std::nullopt));
  for (const OutlineTouch& touch : touches_of(p, half_play)) {
    const double early = (half_play - touch.gap) * touch.arm;
    // In a crossed internal pair, the flanks overlap beside the line of action by up to
    // saddle_depth(), so a tip may overlap the mating flank by as much. This overlap is not counted
    // as a collision, because sufficient lead crowning removes it; note_saddle() checks the
    // crowning.
    const bool of_fillet = gear_with(touch, ArcName::root_fillet) > 0;
    if (early <= (of_fillet ? close : close + saddle)) {
      if (flanks_compared && flank_on_flank(touch) && too_thick_teeth)
        p.overlap->push_back(too_thick(normal_play, touch));
      continue;
    }
    least = std::min(least, touch.gap);
    if (touch.gap * touch.arm < -close) {
      p.overlap->push_back(overlapping(p, touch));
    } else {
      p.beyond_flank.push_back(beyond(p, touch, early));
    }
  }
  p.free_play = Angle::radians(2 * least);
  deepest_first(*p.overlap);
  deepest_first(p.beyond_flank);
}

template <class Kind>
void collide_and_explain(Kind& p, double saddle) {
  if (!p.gears[0].tooth || !p.gears[1].tooth) return;
  collide(p, p.mesh.backlash.rotation[1] / 2, p.mesh.backlash.normal_base, saddle);
  // If a tip extends below a root circle, the outlines are not compared, and all findings remain.
  if (p.free_play) explain(p);
  // If the flanks overlap beside the line of action, the actual free play is less than the computed
  // value. The computed value is therefore removed.
  if (saddle > 0.0) p.free_play.reset();
}

}  // namespace

void find_collisions(MountedGears& p, double half_play, double normal_play) {
  collide(p, half_play, normal_play, 0.0);
}
void find_overlap(ParallelPair& p) { collide_and_explain(p, 0.0); }
void find_overlap(CrossedPair& p) { collide_and_explain(p, saddle_depth(p)); }

}  // namespace gearwright::detail
