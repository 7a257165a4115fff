// The result of contact() outlives the pair. It equals the result for a ContactPair made directly.
#include "gearwright/contact/pair_contact.hpp"

#include <fmt/format.h>

#include <type_traits>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using namespace literals;

// An aggregate would accept values for only some of its members and set the others to 0.
static_assert(!std::is_constructible_v<Contact, ContactResult>);
static_assert(!std::is_constructible_v<ContactResult, std::vector<ContactPoint>>);

FlankModifications crowned() {
  FlankModifications m;
  m.lead_crowning = 0.005;
  return m;
}

Result<Contact> of_a_pair_that_is_gone(const ContactErrors& errors, const ContactOptions& options) {
  const testing::SamplePair p = testing::involutes(20, 41, 15);
  const auto pair = mount(p.gears[0], p.gears[1], {.center_distance = p.place.center_distance});
  if (!pair) return pair.error();
  return contact(*pair, errors, options);
}

TEST(PairContact, equals_a_pair_by_hand_and_outlives_its_own) {
  const ContactErrors errors{.center_distance = 0.02, .crossing = Angle::radians(2e-4)};
  ContactOptions options;
  options.modifications[0] = on_both_flanks(crowned());
  const auto owned = of_a_pair_that_is_gone(errors, options);
  ASSERT_TRUE(owned) << owned.error().message();
  testing::SamplePair by_hand = testing::involutes(20, 41, 15);
  by_hand.modify(1, crowned());
  by_hand.place.errors = errors;
  EXPECT_EQ(owned->peak_to_peak, analyse_contact(by_hand.pair(), {}).peak_to_peak);
  EXPECT_EQ(transmission_error(*owned->pair, 32), transmission_error(by_hand.pair(), 32));
}

// The backlash j_t on the working pitch cylinders is the pitch minus both tooth thicknesses. The
// play of gear 2, found by turning its flanks, is j_t/r_w2. jams() compares the product j_t cos β_w
// · r cos β/(r_w cos β_w) with its limit. It does not compare j_bn = j_t cos α_wt cos β_b.
TEST(PairContact, a_jam_is_judged_in_the_normal_section) {
  for (const auto& [z2, helix_deg] :
       {std::pair{41, 0.0}, {41, 15.0}, {41, 30.0}, {-61, 0.0}, {-61, 15.0}}) {
    testing::SamplePair p = testing::involutes(20, z2, helix_deg);
    const double side = side_of(z2), teeth_2 = std::abs(z2);
    const double beta = helix_deg * std::numbers::pi / 180;
    const double alpha_t = std::atan(std::tan(std::numbers::pi / 9) / std::cos(beta));
    const double r_1 = 20 / std::cos(beta), r_2 = teeth_2 / std::cos(beta);
    p.place.center_distance += side * 0.7;
    const double a = p.place.center_distance;
    const double r_w1 = a * 20 / std::abs(20 + z2), r_w2 = a * teeth_2 / std::abs(20 + z2);
    const double alpha_wt = std::acos((r_2 + side * r_1) * std::cos(alpha_t) / a);
    const auto inv = [](double angle) { return std::tan(angle) - angle; };
    const auto thickness = [&](double r_w, double z, double sigma) {
      return r_w * (std::numbers::pi / z + 2 * sigma * (inv(alpha_t) - inv(alpha_wt)));
    };
    const double j_t = 2 * std::numbers::pi * r_w1 / 20 - thickness(r_w1, 20, 1.0) -
                       thickness(r_w2, teeth_2, side);
    const auto driving = analyse_contact(p.pair(), {});
    p.place.gear2_drives = true;
    const auto other = analyse_contact(p.pair(), {});
    const double play = least_play(driving, other, false)->rad();
    EXPECT_NEAR(play, j_t / r_w2, 1e-10);
    const double beta_w = std::atan(std::tan(beta) * r_w2 / r_2);
    const double j_n = j_t * std::cos(beta_w);
    const double cosine_wn = std::cos(std::atan(std::tan(alpha_wt) * std::cos(beta_w)));
    const double judged = play * r_2 * std::cos(beta);
    EXPECT_NEAR(judged, j_n * cosine_wn / std::cos(std::numbers::pi / 9), 1e-9);
    const auto pair =
        testing::taken(mount_as<ParallelPair>(p.gears[0], p.gears[1], {.center_distance = a}));
    EXPECT_NEAR(pair.mesh.backlash.normal, j_n, 1e-9);
    EXPECT_NEAR(pair.mesh.backlash.normal_base, j_n * cosine_wn, 1e-9);
    const double limit = -no_backlash(p.gears[1].spec.normal_module) / (r_2 * std::cos(beta));
    EXPECT_TRUE(jams(Angle::radians(limit * 1.001), p.gears[1]));
    EXPECT_FALSE(jams(Angle::radians(limit * 0.999), p.gears[1]));
  }
}

TEST(PairContact, RequestsWithoutPositionsAreErrors) {
  const auto field = [](const ContactRequest& request) {
    const auto found = of_a_pair_that_is_gone({}, {.request = request});
    return found ? std::string() : found.error().field;
  };
  EXPECT_EQ(field({.positions = 1}), "contact.positions");
  EXPECT_EQ(field({.pitches = 0}), "contact.pitches");
  EXPECT_EQ(field({.marking = 0.0}), "contact.marking");
  EXPECT_EQ(field({.positions = 2}), "");
}

// The message states the gap between the tip circles.
TEST(PairContact, tips_out_of_reach_are_named) {
  for (const auto& [z2, off, gap] : {std::tuple{41, 5.0, 1.0}, {-61, -5.0, 1.0}}) {
    const testing::SamplePair p = testing::involutes(20, z2, 0);
    const auto pair = mount(p.gears[0], p.gears[1], {.center_distance = p.place.center_distance});
    ASSERT_TRUE(pair);
    const auto setup = ContactSetup::of(*pair, {.center_distance = off}, {});
    ASSERT_TRUE(setup);
    const std::string text = nothing_touches(*setup).message();
    EXPECT_NE(text.find(fmt::format("tip circles are {} mm apart", gap)), std::string::npos)
        << text;
    EXPECT_NE(text.find("errors.center_distance"), std::string::npos) << text;
  }
}

// Without errors, the centre distance is the cause.
TEST(PairContact, tips_out_of_reach_without_errors_name_the_distance) {
  const testing::SamplePair p = testing::involutes(20, 41, 0);
  const auto pair =
      mount(p.gears[0], p.gears[1], {.center_distance = p.place.center_distance + 5.0});
  ASSERT_TRUE(pair);
  const auto setup = ContactSetup::of(*pair, {}, {});
  ASSERT_TRUE(setup);
  const Error error = nothing_touches(*setup);
  EXPECT_EQ(error.field, "pair.center_distance");
  EXPECT_EQ(error.value, format_number(p.place.center_distance + 5.0));
  EXPECT_NE(error.rule.find("tip circles are 1 mm apart"), std::string::npos) << error.rule;
  EXPECT_NE(error.rule.find("a smaller centre distance would help"), std::string::npos);
}

TEST(PairContact, asks_for_a_lead_that_can_change) {
  const testing::SamplePair p = testing::involutes(20, 41, 0);
  const auto pair = mount(p.gears[0], p.gears[1], {.center_distance = p.place.center_distance});
  ASSERT_TRUE(pair);
  EXPECT_FALSE(contact(*pair, {.cutter_lead = {0.1_deg, 0_deg}}));
  EXPECT_FALSE(contact(*pair, {.cutter_lead = {0_deg, 0.1_deg}}));
}

TEST(PairContact, derives_by_a_modification_that_is_not_there) {
  ContactOptions options;
  options.request.influences = {{ErrorKind::center_distance, 1, Modification::lead_crowning}};
  const auto owned = of_a_pair_that_is_gone({}, options);
  ASSERT_TRUE(owned);
  ASSERT_EQ(owned->sensitivities.size(), 1u);
}

}  // namespace
}  // namespace gearwright
