// Expects a statement to violate a contract. The violation is thrown, or, in a build that stops at
// violations, it ends a child process.
#pragma once

#include <gtest/gtest.h>

#include "gearwright/base/contract.hpp"

#ifdef GEARWRIGHT_STOP_AT_VIOLATIONS
#define GW_EXPECT_VIOLATION(statement) EXPECT_DEATH(statement, "violated")
#else
#define GW_EXPECT_VIOLATION(statement) EXPECT_THROW(statement, ::gearwright::ContractViolation)
#endif
