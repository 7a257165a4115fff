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

/// Specific sliding ζ of gear 1 and of gear 2, each at A and at E.
using SlidingAtEnds = std::array<std::array<std::optional<double>, 2>, 2>;
/// The entry `specific_sliding`: a record for programs, a row for people at A and at E. `get` gives
/// a SlidingAtEnds, or none.
template <class S, class G>
void add_sliding(Quantities<S>& q, const char* meaning, G get) {
  q.template record<two_gears>("specific_sliding", meaning, [get](const S& s) {
     const std::optional<SlidingAtEnds> z = get(s);
     return z ? Value(two_gears().of({(*z)[0], (*z)[1]})) : Value();
   }).doors(kJson);
  const auto row = [&](const char* key, std::size_t end) {
    q.term(key, "per gear",
           [get, end](const S& s) {
             const std::optional<SlidingAtEnds> found = get(s);
             return found ? Value(std::array{(*found)[0][end], (*found)[1][end]}) : Value();
           })
        .per_gear()
        .doors(kPeople)
        .expected([get](const S& s) { return std::optional<SlidingAtEnds>(get(s)).has_value(); });
  };
  row("specific_sliding_at_A", 0);
  row("specific_sliding_at_E", 1);
}

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

/// CrossedPair::needed_crowning, µm.
std::array<std::optional<double>, 2> needed_crowning_um(const CrossedPair& pair);

const Quantities<ParallelPair>& needed_face_quantities();
const Quantities<InvolutePair>& sliding_velocity_quantities();
const Quantities<Efficiency>& efficiency_quantities();
const Quantities<InternalMargins>& internal_quantities();

/// The helix angle of gear i on its working pitch cylinder, and the transverse angle there of the rack's
/// normal angle at the first contact, rad.
double working_helix(const ArcPair& pair, std::size_t i);
double working_transverse(const ArcPair& pair, std::size_t i);

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
std::vector<ArcContactView> arc_contacts_of(const ArcPair& pair);

}  // namespace gearwright
