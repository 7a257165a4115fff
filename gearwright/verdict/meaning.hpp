// What a finding means for the user who has to decide: how bad it is, and why.
//
// One table holds a row for each code of a warning and of a margin. It stands in the order of how bad
// they are, the worst first: of two findings of one level the one whose row stands higher is named first.
#pragma once

#include <string_view>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

enum class Severity {
  note,     ///< a default or a consequence that is good to know
  caution,  ///< it works; the user should look at this
  problem,  ///< as specified it cannot be made or does not run
};

struct Meaning {
  Severity severity;
  const char* reason;  ///< a clause, "the gears jam"; empty for a note
  const char*
      advice;  ///< what to write otherwise in the spec, where no number would help; may be empty
  int rank;    ///< the row's place in the table; 0 is the worst
};

/// By the code and the gear (0: the pair) of a finding; a code without a row is a caution.
Meaning meaning_of(std::string_view code, int gear);
inline Meaning meaning_of(const Warning& warning) { return meaning_of(warning.code, warning.gear); }

inline Severity severity_of(const Warning& warning) { return meaning_of(warning).severity; }

}  // namespace gearwright
