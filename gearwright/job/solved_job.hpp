// From a spec to gears and a pair: what is absent follows, what contradicts itself is named.
//
// The rules are those of the interface (docs/spec.md): shifts and centre distance complete each
// other, absent face widths become 10 m_n with a warning.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gearwright/pair/pair.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct JobEnds;

/// What a spec describes. With a pair its gears are the pair's.
struct SolvedJob {
  JobSpec spec;  ///< with what follows: shifts, thickness, tips
  std::vector<Gear> gears;        ///< one or two
  std::optional<Pair> pair;       ///< when the spec has two gears and the caller wanted the pair
  std::vector<Warning> warnings;  ///< of gears and pair, with the gear's number
  std::shared_ptr<const JobEnds> ends{};  ///< of its tolerances; none: it has none
  std::shared_ptr<const JobSpec> given{};  ///< the spec that solve was called with

  std::optional<Bore> bore(int which) const {
    return spec.gears[static_cast<std::size_t>(which - 1)]->bore;
  }
};

/// The same job at both ends of its tolerances. `lower`: the thinnest teeth, and with them the centre
/// distance with the most backlash; `upper`: the thickest, and the least. What is made and looked at
/// elsewhere, files and contact, is the job itself, at the mean of the allowances.
struct JobEnds {
  SolvedJob lower, upper;
};

enum class Scope {
  gears,       ///< each gear by itself; the pair is used only to find an absent profile shift
  pair,        ///< the mounted pair is wanted: gear2 must be there
  everything,  ///< the pair if there are two gears
};

/// Errors    keys with their table, "gear2.profile_shift"
Result<SolvedJob> solve(const JobSpec& spec, Scope scope);

}  // namespace gearwright
