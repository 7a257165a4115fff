// The result of contact() outlives the pair. It equals the result for a ContactPair that is made
// directly.
#include "gearwright/contact/pair_contact.hpp"

#include <type_traits>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using namespace literals;

// If the type were an aggregate, C++20 would accept values for only some of its members and set the
// others to 0.
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
