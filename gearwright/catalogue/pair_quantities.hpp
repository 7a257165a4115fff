// The quantities of a mounted pair: `pair` of a result, the table of pair data.
#pragma once

#include <optional>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A mounted pair. One of the two is there.
struct PairView {
  const InvolutePair* involute = nullptr;
  const ArcPair* arcs = nullptr;

  bool crossed() const { return involute && involute->crossed(); }
};

const Quantities<PairView>& pair_quantities();

}  // namespace gearwright
