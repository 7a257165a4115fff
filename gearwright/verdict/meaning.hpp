// What a warning means for who has to decide: how bad it is, why, and what would help.
#pragma once

#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

enum class Severity {
  note,     ///< a default or a consequence that is good to know
  caution,  ///< it works; somebody should look at this
  problem,  ///< as specified it cannot be made or does not run
};

struct Meaning {
  Severity severity;
  const char* reason;  ///< of a problem: completes "does not run as specified: …"; else empty
  const char* remedy;  ///< one sentence, may be empty
  bool told = false;   ///< the warning's own message says what would help
};

/// By the warning's code; one that is not known is a caution. Where an undercut has taken the flank
/// away, a mating gear's tip that reaches below the flank meets nothing: a caution too.
Meaning meaning_of(const Warning& warning);

inline Severity severity_of(const Warning& warning) { return meaning_of(warning).severity; }

}  // namespace gearwright
