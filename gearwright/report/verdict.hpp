// What a person wants to know first: does it work, and if not, why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/report/report.hpp"

namespace gearwright {

enum class Severity {
  problem,  ///< as specified it cannot be made or does not run
  caution,  ///< it works; somebody should look at this
  note,     ///< a default or a consequence that is good to know
};

/// By the warning's code; one that is not known is a caution. Where an undercut has taken the flank
/// away, a mating gear's tip that reaches below the flank meets nothing: a caution too.
Severity severity_of(const Warning& warning);

/// The face width from which a helical pair's contact is continuous, although in one section it is
/// not; mm, rounded up to 0.01. Nothing when the transverse contact is continuous, or there is
/// none, or no face width makes it so.
///
/// Formula   (1 − ε_α) p_bt/|tan β_b|, ε_α of the usable flanks
/// Domain    parallel axes, else nothing
std::optional<double> face_width_needed(const InvolutePair& pair);

/// One sentence in plain words, not escaped.
std::string verdict(const ReportInput& input);

}  // namespace gearwright
