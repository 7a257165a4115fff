#include "gearwright/base/contract.hpp"

#include <cstdio>
#include <cstdlib>

namespace gearwright {

void contract_failed(const char* kind, const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "gearwright: %s violated: %s (%s:%d)\n", kind, condition, file, line);
  std::abort();
}

}  // namespace gearwright
