// Result<T>: a value, or the reason why there is none.
//
// Facts about gears (no working pressure angle, an impossible tooth) are regular results. The error
// contains the information that a user needs to correct the input (base/error.hpp).
#pragma once

#include <utility>
#include <variant>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/error.hpp"

namespace gearwright {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const noexcept { return state_.index() == 0; }
  const T& value() const {
    GW_EXPECTS(state_.index() == 0);
    return std::get<0>(state_);
  }
  const Error& error() const {
    GW_EXPECTS(state_.index() == 1);
    return std::get<1>(state_);
  }
  const T& operator*() const { return value(); }
  const T* operator->() const { return &value(); }
  T take() && {
    GW_EXPECTS(state_.index() == 0);
    return std::get<0>(std::move(state_));
  }

 private:
  std::variant<T, Error> state_;
};

}  // namespace gearwright
