// Implements design/candidate.hpp without Google Highway. It replaces candidate_simd.cpp.
#include "gearwright/design/candidate.hpp"

namespace gearwright {

void evaluate(const CandidateConstants& constants, CandidateBatch& batch) {
  evaluate_scalar(constants, batch);
}
void sieve(const SieveConstants& constants, SieveBatch& batch) { sieve_scalar(constants, batch); }
std::string lanes_name() { return "scalar"; }
std::size_t lanes() { return 1; }

}  // namespace gearwright
