// Contracts: a mistake in our own code stops the program where it happens.
//
// A fact about a gear (undercut, no contact) is never a contract, it is a Result (base/result.hpp).
// Contracts stay on in every build: they cost a compare, a wrong gear costs a machine.
#pragma once

namespace gearwright {

/// Prints `kind: condition` with its place to stderr and aborts.
[[noreturn]] void contract_failed(const char* kind, const char* condition, const char* file,
                                  int line) noexcept;

}  // namespace gearwright

#define GW_CONTRACT_(kind, condition) \
  ((condition) ? static_cast<void>(0) \
               : ::gearwright::contract_failed(kind, #condition, __FILE__, __LINE__))

/// What the caller must have made true.
#define GW_EXPECTS(condition) GW_CONTRACT_("precondition", condition)
/// What this code has made true.
#define GW_ENSURES(condition) GW_CONTRACT_("postcondition", condition)
