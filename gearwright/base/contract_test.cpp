#include "gearwright/base/contract.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "gearwright/base/parallel.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

[[maybe_unused]] void half(int n) { GW_EXPECTS(n % 2 == 0); }

TEST(ContractDeathTest, what_does_not_hold_is_a_violation) {
  half(2);
  GW_EXPECT_VIOLATION(half(3));
  GW_EXPECT_VIOLATION(GW_ENSURES(1 > 2));
}

#ifndef GEARWRIGHT_STOP_AT_VIOLATIONS
TEST(Contract, the_sentence_has_condition_and_place_and_wants_a_report) {
  try {
    half(3);
    FAIL();
  } catch (const ContractViolation& e) {
    const std::string what = e.what();
    for (const char* words : {"precondition", "n % 2 == 0", "(gearwright/base/contract_test.cpp:",
                              "please report it", "the spec"})
      EXPECT_NE(what.find(words), std::string::npos) << what;
  }
}

TEST(Contract, a_violation_on_any_thread_reaches_the_caller_and_ends_nothing_else) {
  for (const int threads : {1, 4, 0}) {
    EXPECT_THROW(parallel_for(
                     1000, [](std::size_t i) { half(i == 500 ? 1 : 2); }, threads),
                 ContractViolation);
    std::atomic<int> done = 0;
    parallel_for(
        1000, [&](std::size_t) { ++done; }, threads);
    EXPECT_EQ(done, 1000);
  }
}
#endif

}  // namespace
}  // namespace gearwright
