#include "gearwright/base/contract.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace gearwright {

void contract_failed(const char* kind, const char* condition, const char* file, int line) {
  const std::string what = std::string("defect in Gearwright, ") + kind +
                           " violated: " + condition + " (" + file + ":" + std::to_string(line) +
                           "); please report it, together with the spec";
#ifdef GEARWRIGHT_STOP_AT_VIOLATIONS
  std::fprintf(stderr, "gearwright: %s\n", what.c_str());
  std::abort();
#else
  throw ContractViolation(what);
#endif
}

}  // namespace gearwright
