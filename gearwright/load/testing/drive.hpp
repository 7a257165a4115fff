// Two steel gears on parallel axes, and their loaded contact for a request.
#pragma once

#include <gtest/gtest.h>

#include "gearwright/contact/contact.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright::testing {

inline constexpr double kE = 206000.0;  ///< MPa

struct Drive {
  Gear one, two;
  ContactMount mount;
  ContactPair pair() const { return ContactPair({&one, {}}, {&two, {}}, mount); }
};

inline LoadedContact run(const Drive& d, const LoadRequest& r) {
  auto c = pair_compliance(d.one, d.two, r);
  EXPECT_TRUE(c) << c.error().message();
  return loaded_contact(d.pair(), d.one, d.two, *c, r);
}

}  // namespace gearwright::testing
