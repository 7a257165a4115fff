// The quantities of a mounted pair: `pair` of a result, the table of pair data.
#pragma once

#include <optional>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A pair with what the spec says besides. One of the two pairs is there.
struct PairView {
  const Pair* involute = nullptr;
  const ArcPair* arcs = nullptr;

  bool crossed() const { return involute && involute->crossed(); }
};

const Quantities<PairView>& pair_quantities();

}  // namespace gearwright
