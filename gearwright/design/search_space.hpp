// Enumerates the trials of a search. The numbers of the trials are 0 … size − 1. Any trial can be
// computed from its number, with the same result on every machine.
//
//   order     rack, helix, module, z1, z2; z2 changes fastest. If the problem contains choices of
//             module and helix angle, the choices replace helix and module
//   z2        numbers of teeth whose ratio lies in the band, ends included, with a tolerance of
//             1e-12
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Greatest number of teeth of a wheel. It is limited, because a search stores a TrialGear with its
/// shift limits for each number of teeth in the band.
inline constexpr int kMaxSearchTeeth = 20'000;

class SearchSpace {
 public:
  /// Domain    a problem as read from a spec; wheels with at most kMaxSearchTeeth teeth (contract)
  explicit SearchSpace(const SearchProblem& problem);
  /// Returns the number of trials, including trials in which z1 and z2 have a common factor. The
  /// result is absent if it exceeds 9·10^18.
  std::optional<std::int64_t> size() const { return size_; }
  double approximate_size() const;

  /// Domain    0 ≤ index < size (contract)
  Trial trial(std::int64_t index) const;

  /// Calls f(trial) for the trials in [from, to). The calls end when f returns false. If the
  /// numbers of teeth must be coprime, trials with a common factor are omitted. If a helix angle
  /// was chosen for a face width, trials with this width outside of the band of b/d_1 are omitted.
  template <class F>
  void each(std::int64_t from, std::int64_t to, const F& f) const {
    if (from >= to) return;
    for (Cursor c = at(from); c.index < to; next(c)) {
      if (problem_->coprime && !coprime(c.z1, c.z2)) continue;
      const Trial trial = trial_of(c);
      if (trial.face_width && problem_->face_diameters && !is_in_band(trial)) continue;
      if (!f(trial)) return;
    }
  }

  /// Returns the least and the greatest z2 of all pairs, with signs, or {0, 0} if there is no pair.
  std::array<int, 2> wheels() const { return wheels_; }

 private:
  struct Cursor {
    std::int64_t index;
    std::size_t rack, choice, pinion;
    int z1, z2;
    HelixChoice values;  ///< the values of `choice`
  };
  Cursor at(std::int64_t index) const;
  void next(Cursor& c) const;
  Trial trial_of(const Cursor& c) const;
  double choices() const;  ///< number of combinations of module and helix angle
  HelixChoice choice(std::size_t number) const;
  static bool coprime(int a, int b);
  /// True if the width for which the helix angle was chosen is in the band of b/d_1.
  ///
  /// Domain    the width and the band exist (contract)
  bool is_in_band(const Trial& trial) const;

  const SearchProblem* problem_;
  std::size_t choices_ = 0;  ///< choices(), if the trials can be counted
  struct Wheels {
    int z1, first, last;  ///< first and last z2
  };
  std::vector<Wheels> pinions_;              ///< pinions that have at least one wheel
  std::vector<std::int64_t> before_pinion_;  ///< for each pinion, the number of trials with a
                                             ///< smaller z1 and one given module
  std::int64_t per_module_ = 0;
  std::optional<std::int64_t> size_;
  std::array<int, 2> wheels_{};
};

/// Returns the first and the last z2 for a given z1. If the first exceeds the last, there is no z2.
std::array<int, 2> wheels_of(const SearchProblem& problem, int z1);

}  // namespace gearwright
