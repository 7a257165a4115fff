// The limit that an error message names: six digits if the value is far from it, and more if the
// value is close.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace gearwright {

/// The number that follows `words` in a sentence.
inline double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  EXPECT_NE(at, std::string::npos) << words << " in: " << text;
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
}

/// Tests that an error message names the right limit, and returns the limit within 1e-12 relative.
///
/// `refusal(x)` returns the message that rejects x, or an empty text if x is allowed. For x =
/// `beyond`, the limit in the message is correct to six digits. If x is only 1e-9 beyond the limit,
/// the message must contain more digits.
inline double named_limit(const std::function<std::string(double)>& refusal, double beyond,
                          const std::string& words) {
  const double limit = number_after(refusal(beyond), words);
  const double out = beyond > limit ? 1.0 : -1.0;
  const double scale = std::abs(limit);
  double allowed = limit - out * 1e-9 * scale;  // the limit itself may be excluded
  EXPECT_EQ(refusal(allowed), "");
  double refused = limit + out * 2e-5 * scale;
  EXPECT_NE(refusal(refused), "") << limit << " is not the limit";
  while (std::abs(refused - allowed) > 1e-12 * scale) {
    const double middle = (allowed + refused) / 2;
    (refusal(middle).empty() ? allowed : refused) = middle;
  }
  EXPECT_NEAR(number_after(refusal(allowed + out * 1e-9 * scale), words), allowed, 2e-8 * scale);
  return allowed;
}

}  // namespace gearwright
