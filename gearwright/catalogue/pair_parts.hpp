// The records inside a pair's record: places, lines, backlash, contacts of arcs.
// Internal to catalogue/.
#pragma once

#include <array>

#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/pair/pair_backlash.hpp"

namespace gearwright {

constexpr const char* kMounting = "Mounting";
constexpr const char* kContact = "Contact";
constexpr const char* kBacklash = "Backlash";
constexpr const char* kClearances = "Clearances";
constexpr const char* kFace = "Face width";
constexpr const char* kMargins = "Internal pair: margins against interference";

/// `gear1` and `gear2`, two numbers each.
const Quantities<std::array<Value, 2>>& two_gears();

const Quantities<CrossedPlace>& place_quantities();
const Quantities<CrossedPlaces>& places_quantities();

/// The line of action of any pair; lines as their two ends.
struct LineView {
  double length;
  std::array<Vec3, 2> leading, trailing;
};
const Quantities<LineView>& line_quantities();
std::optional<LineView> line_of(const Pair& pair);

/// The points A to E of an involute pair's path.
const Quantities<InvolutePair>& path_quantities();

const Quantities<PairBacklash>& backlash_quantities();

const Quantities<InvolutePair>& needed_face_quantities();
const Quantities<InvolutePair>& sliding_velocity_quantities();
const Quantities<Efficiency>& efficiency_quantities();
const Quantities<InvolutePair>& internal_quantities();

/// One entry of `interference`.
struct InterferenceView {
  WarningCode code;
  int gear;
  std::optional<double> amount;
  std::string message;
};
const Quantities<InterferenceView>& interference_quantities();
std::vector<InterferenceView> interference_of(const Pair& pair);

/// An entry of `overlap` or of `beyond_flank`.
const Quantities<Collision>& collision_quantities();

/// A contact of circular arcs and its pair.
struct ArcContactView {
  const ArcPair* pair;
  const ArcPairContact* contact;
};
const Quantities<ArcContactView>& arc_contact_quantities();
std::vector<ArcContactView> arc_contacts_of(const Pair& pair);

}  // namespace gearwright
