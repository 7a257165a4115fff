// What a Result holds: the test fails with the reason where there is none.
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
