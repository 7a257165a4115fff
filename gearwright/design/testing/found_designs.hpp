// The counts of a complete search, every design that it found, and a load for its designs.
#pragma once

#include <tuple>
#include <vector>

#include "gearwright/design/search.hpp"
#include "gearwright/rating/testing/sample_pairs.hpp"

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

/// The designs of a search, each at one point of its region.
inline std::vector<DesignRow> points_of(const SearchProblem& problem) {
  const Search search(problem);
  std::vector<DesignRow> rows;
  search.range(0, *search.space().size(), rows, {.detail = RegionDetail::point});
  return rows;
}

/// A load of case-hardened gears, with the torque in N m on gear 1.
inline SearchRating load(double torque) {
  SearchRating rating;
  rating.input.torque = torque;
  rating.input.speed = 1480;
  rating.input.life_h = 20000;
  rating.input.viscosity = 220;
  rating.input.quality = {6, 7};
  rating.input.flank_roughness = {4, 5};
  rating.input.face_load_factor = 1.2;
  rating.input.materials = {case_hardened(), case_hardened()};
  return rating;
}

/// Module in mm, z1, z2.
using Design = std::tuple<double, int, int>;
inline Design design_of(const DesignRow& row) {
  return {row.trial.module, row.trial.z1, row.trial.z2};
}

}  // namespace gearwright::testing::search
