// What a property test is about. When a contract breaks, it is printed before the program ends: the
// reproducer.
#pragma once

#include <csignal>
#include <cstdio>
#include <string>

namespace gearwright::property {

inline std::string at_hand;  ///< the handler below may read it

extern "C" inline void print_at_hand(int) {
  std::fprintf(stderr, "at hand: %s\n", at_hand.c_str());
}

struct PrintsAtHandOnAbort {
  PrintsAtHandOnAbort() : old(std::signal(SIGABRT, print_at_hand)) {}
  ~PrintsAtHandOnAbort() { std::signal(SIGABRT, old); }
  void (*old)(int);
};

}  // namespace gearwright::property
