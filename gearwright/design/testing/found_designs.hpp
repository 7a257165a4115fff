// The counts of a complete search, and every design that it found.
#pragma once

#include <tuple>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright::testing::search {

struct Found {
  SearchCounts counts;
  std::vector<DesignRow> rows;
};
inline Found whole(const Search& search) {
  Found f;
  f.counts = search.range(0, *search.space().size(), f.rows);
  return f;
}

/// Module in mm, z1, z2.
using Design = std::tuple<double, int, int>;
inline Design design_of(const DesignRow& row) {
  return {row.trial.module, row.trial.z1, row.trial.z2};
}

}  // namespace gearwright::testing::search
