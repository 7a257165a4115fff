// The records inside the record of a pair: points, lines, backlash and contacts of circular arcs.
// Internal to catalogue/.
#pragma once

#include <array>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

constexpr const char* kMounting = "Mounting";
constexpr const char* kContact = "Contact";
constexpr const char* kBacklash = "Backlash";
constexpr const char* kClearances = "Clearances";
constexpr const char* kFace = "Face width";
constexpr const char* kMargins = "Internal pair: margins against interference";

/// A record with `gear1` and `gear2`, each a list of two numbers or of two lengths.
const Quantities<std::array<Value, 2>>& two_gears();
const Quantities<std::array<Value, 2>>& two_gears_mm();

/// Specific sliding ζ of gear 1 and of gear 2, each at A and at E.
using SlidingAtEnds = std::array<std::array<std::optional<double>, 2>, 2>;
/// Adds the entry `specific_sliding`. Programs get a record, and users get two rows, one for A and
/// one for E. `q` contains the quantities of a pair, or of a part of a pair. `get` returns the
/// SlidingAtEnds of the pair.
template <class Q, class G>
void add_sliding(Q& q, const char* meaning, G get) {
  q.template record<two_gears>("specific_sliding", meaning, [get](const auto& s) {
     const SlidingAtEnds z = get(s);
     return Value(two_gears().of({z[0], z[1]}));
   }).doors(kJson);
  const auto row = [&](const char* key, std::size_t end) {
    q.term(key, "per gear",
           [get, end](const auto& s) {
             const SlidingAtEnds z = get(s);
             return Value(std::array{z[0][end], z[1][end]});
           })
        .per_gear()
        .doors(kPeople)
        .expected();
  };
  row("specific_sliding_at_A", 0);
  row("specific_sliding_at_E", 1);
}

const Quantities<Efficiency>& efficiency_quantities();
/// Adds the entry `efficiency`. Programs get a record, and users get one row. `get` returns a
/// pointer to the Efficiency, or null.
template <class S>
void add_efficiency(Quantities<S>& q, const Efficiency* (*get)(const S&)) {
  auto of_efficiency = q.part(get);
  of_efficiency
      .template record<efficiency_quantities>(
          "efficiency",
          "efficiency with flank friction only [T4.27]; all tooth pairs in contact are assumed to "
          "carry equal parts of a constant normal force; null without `friction_coefficient`, or "
          "if `contact_ratio_true` is less than 1",
          std::identity{})
      .doors(kJson);
  of_efficiency
      .term("efficiency_driving", "per gear",
            [](const Efficiency& e) {
              return std::array{e.gear1_drives, e.gear2_drives};
            })
      .unit(Unit::percent)
      .per_gear()
      .otherwise("self-locking")
      .doors(kPeople);
}

const Quantities<CrossedPlace>& place_quantities();
const Quantities<CrossedPlaces>& places_quantities();

/// The path of contact of any pair: its length, and its two ends for the leading flanks and for the
/// trailing flanks.
struct LineView {
  double length;
  std::array<Vec3, 2> leading, trailing;
};
const Quantities<LineView>& line_quantities();
std::optional<LineView> line_of(const Pair& pair);

/// The points A to E of the path of contact of an involute pair.
const Quantities<InvolutePair>& path_quantities();

const Quantities<PairBacklash>& backlash_quantities();

/// CrossedPair::needed_crowning in µm.
std::array<std::optional<double>, 2> needed_crowning_um(const CrossedPair& pair);

const Quantities<ParallelPair>& needed_face_quantities();
const Quantities<InvolutePair>& sliding_velocity_quantities();
const Quantities<InternalMargins>& internal_quantities();

/// working_helix() returns the helix angle of gear i on its working pitch cylinder, rad.
/// working_transverse() returns the transverse pressure angle on this cylinder, rad, which follows
/// from the normal angle of the rack at the first contact.
double working_helix(const ArcPair& pair, std::size_t i);
double working_transverse(const ArcPair& pair, std::size_t i);

struct InterferenceView {
  WarningCode code;
  int gear;
  std::optional<double> amount;
  std::string message;
};
const Quantities<InterferenceView>& interference_quantities();
std::vector<InterferenceView> interference_of(const Pair& pair);

/// The quantities of an entry of `overlap` or `beyond_flank`.
const Quantities<Collision>& collision_quantities();

struct ArcContactView {
  const ArcPair* pair;
  const ArcPairContact* contact;
};
const Quantities<ArcContactView>& arc_contact_quantities();
std::vector<ArcContactView> arc_contacts_of(const ArcPair& pair);

}  // namespace gearwright
