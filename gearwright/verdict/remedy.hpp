// Finds remedies for findings. A remedy is a change of a number of a spec, and it is tried before
// it is printed.
//
// A cure is a row of a table. It contains the code of a finding, the changes in the order in which
// they are tried, and a clause that is true when the finding is removed. For a given spec, each
// change becomes a lever. A lever is a number of the spec with its present value, direction, range
// and step. For each lever, the program computes the smallest change that removes the finding and
// neither adds nor worsens another finding. If several changes succeed, the change that leaves the
// fewest findings is used. If no change succeeds for the first finding of a rack and this finding
// is red, changes that add amber findings are also accepted, and the remedy names these findings.
// If the contact lies near the end of the face, or if an edge touches, the helix slope that moves
// the contact to the middle is tried first. If no change succeeds, the remedy is only general
// advice. Remedies for safety factors are computed by rating_remedy() instead.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// The part of the spec whose number is changed: the gear of the finding, the mating gear, gear 1,
/// gear 2 or the pair.
enum class Whose { own, mate, first, second, pair };

struct Means {
  Adjustable what;
  Whose whose;
  int direction;  ///< +1 for more shift, a longer or thicker tooth, more teeth, more width or a
                  ///< greater distance; −1 for the opposite
};

struct Cure {
  WarningCode code;
  const char* then;  ///< example: "{} is not undercut"; {} stands for a gear, the rack, a contact
                     ///< ratio or a backlash
  std::vector<Means> means{};
  bool needs_contact = false;  ///< true if the finding comes from a contact analysis
};

struct Lever {
  Adjustable what;
  int gear;
  double now;                     ///< present value, in the unit of SpecChange
  int direction;                  ///< +1 or −1, the sign of the change of the value
  double span;                    ///< greatest permitted change
  int digits;                     ///< number of decimals of the values that are tried
  std::optional<double> hint{};   ///< value from a closed formula, which is tried in addition
  std::optional<double> exact{};  ///< if set, the only value that is tried

  double step() const;
  /// Returns the double that is nearest to the decimal number steps · step().
  double in_steps(double steps) const;
};

/// Returns null if the table has no cure for the finding.
const Cure* cure_of(const Finding& finding);

std::vector<Lever> levers(const Cure& cure, const Finding& finding, const Judged& judged);

/// Returns, for example, "With a profile shift of 0.54 on gear 1, the contact ratio is 1.286."
std::string remedy_words(const Cure& cure, const SpecChange& change, const Finding& finding,
                         const Judged& judged, const ChangedState& trial);

/// Returns the distinct reasons of the findings of one level, in the order of the findings.
/// Findings before index `first` are skipped.
std::vector<std::string> reasons(const std::vector<Finding>& findings, const Judged& judged,
                                 Level level, std::size_t first = 0);

/// Fills `remedy` of all findings. `change` is filled only for the findings of the worst level,
/// because the user removes these first.
///
/// Domain    the worst finding comes first
void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt);

}  // namespace gearwright::detail
