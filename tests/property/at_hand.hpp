// The current case of a test. If a contract is violated, the case is printed before the test ends,
// so that the failure can be reproduced.
#pragma once

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

namespace gearwright::property {

inline std::string at_hand;  ///< the handler below may read it

extern "C" inline void print_at_hand(int) {
  std::fprintf(stderr, "at hand: %s\n", at_hand.c_str());
}

/// Prints the case when a contract is violated, whether the violation throws or aborts
/// (base/contract.hpp).
struct PrintsAtHand {
  PrintsAtHand() : old(std::signal(SIGABRT, print_at_hand)) {}
  ~PrintsAtHand() {
    if (std::uncaught_exceptions() > 0) print_at_hand(0);
    std::signal(SIGABRT, old);
  }
  void (*old)(int);
};

}  // namespace gearwright::property
