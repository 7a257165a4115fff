// Computes pairs under load with as many slices as their contact permits.
//
// The contact of soft or heavily loaded teeth is wider than fair_slices() assumes. If the number of
// slices is not given, it is therefore halved until there is a solution. Flank modifications and
// errors do not change the compliance of the teeth, so the compliances are kept for further pairs
// of the same gears.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <vector>

#include "gearwright/arrange/loaded_pair.hpp"

namespace gearwright {

class SliceResolutions {
 public:
  using Contacts = std::vector<LoadedContact>;

  /// If `given` is true, the number of slices is an input and stays unchanged.
  explicit SliceResolutions(bool given) : given_(given) {}
  /// `first` is the compliance for the greatest number of slices.
  SliceResolutions(bool given, PairCompliance first) : given_(given), known_{std::move(first)} {}

  struct Solved {
    std::array<int, 2> slices;
    const PairCompliance* compliance;  ///< not null; valid as long as the resolutions
    Contacts contacts;                 ///< still too fine if the slices cannot be halved
  };
  /// Returns the contacts that `contacts_of` computes with the greatest number of slices for which
  /// all of them have a solution. The numbers of slices are those of the task, half of them, and so
  /// on. `contacts_of` receives the task with these numbers.
  ///
  /// Domain    all tasks have the same gears and the same numbers of slices
  /// Errors    those of pair_compliance()
  Result<Solved> solve(
      LoadTask task,
      const std::function<Contacts(const LoadTask&, const PairCompliance&)>& contacts_of);

 private:
  bool given_;
  // The first compliance is the finest. Each further one has half as many slices as the previous
  // one. The addresses of the elements of a deque do not change.
  std::deque<PairCompliance> known_;
};

}  // namespace gearwright
