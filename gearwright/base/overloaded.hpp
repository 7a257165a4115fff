// Combines several lambdas into one function object for std::visit, one lambda for each alternative
// of a variant.
#pragma once

namespace gearwright {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace gearwright
