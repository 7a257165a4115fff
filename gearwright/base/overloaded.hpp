// Combines lambdas, one for each alternative of a variant, into one function object for std::visit.
#pragma once

namespace gearwright {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace gearwright
