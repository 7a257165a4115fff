// Contracts end the current task where a defect in our own code is found.
//
// A fact about a gear (undercut, no contact) is a Result (base/result.hpp), never a contract.
// Contracts are checked in every build, because a comparison costs less than a wrong gear.
//
// A violation is thrown as an exception. No library code catches it, so the state of the task is
// discarded with the stack. The interfaces (the program, its batch mode, Python and the web page)
// report the message and continue with the next spec. A build with GEARWRIGHT_STOP_AT_VIOLATIONS
// (presets `dev` and `fuzz`) aborts instead, so that a debugger or a sanitizer shows the stack.
#pragma once

#include <stdexcept>

namespace gearwright {

/// A defect in Gearwright. what() contains the condition, its file and line, and a request to
/// report the defect.
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

/// A precondition, which the caller must satisfy.
#define GW_EXPECTS(condition) GW_CONTRACT_("precondition", condition)
/// A postcondition or invariant of this code.
#define GW_ENSURES(condition) GW_CONTRACT_("postcondition", condition)
