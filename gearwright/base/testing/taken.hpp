// Returns the value of a Result. If there is none, the test fails with the reason.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "gearwright/base/result.hpp"

namespace gearwright::testing {

template <class T>
T taken(Result<T> result) {
  EXPECT_TRUE(result) << result.error().message();
  return std::move(result).take();
}

}  // namespace gearwright::testing
