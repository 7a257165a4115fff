// Contracts: a mistake in our own code ends the work at hand where it happens.
//
// A fact about a gear (undercut, no contact) is never a contract, it is a Result (base/result.hpp).
// Contracts stay on in every build: they cost a compare, a wrong gear costs a machine.
//
// What is violated is thrown, and no room catches it: the state of the work goes with the stack.
// The doors (the program, its batch, Python, the page's engine) answer with the sentence and go on
// with the next spec. A build with GEARWRIGHT_STOP_AT_VIOLATIONS (presets `dev` and `fuzz`) aborts
// at the place instead, where a debugger or a sanitizer sees the stack.
#pragma once

#include <stdexcept>

namespace gearwright {

/// A mistake in Gearwright itself; what() names the condition and its place, and asks for a report.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws    ContractViolation
[[noreturn]] void contract_failed(const char* kind, const char* condition, const char* file,
                                  int line);

}  // namespace gearwright

#define GW_CONTRACT_(kind, condition) \
  ((condition) ? static_cast<void>(0) \
               : ::gearwright::contract_failed(kind, #condition, __FILE__, __LINE__))

/// What the caller must have made true.
#define GW_EXPECTS(condition) GW_CONTRACT_("precondition", condition)
/// What this code has made true.
#define GW_ENSURES(condition) GW_CONTRACT_("postcondition", condition)
