// Tolerances of ISO 1328-1 that a rating requires, from the accuracy grade.
//
//   f_pt, f_pb    single pitch deviation, µm; on the base circle f_pb = f_pt cos α_t
//   f_fα, f_Hβ    profile form and helix slope deviation, µm
//
// ISO 6336 of 2006 is used with ISO 1328-1:1995, and ISO 6336 of 2019 with ISO 1328-1:2013.
#pragma once

#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

constexpr int kBestGrade = 0, kWorstGrade = 12;

struct Tolerances {
  double f_pt, f_pb, f_falpha, f_Hbeta;  ///< µm
};

/// The edition of ISO 1328-1 that an edition of ISO 6336 uses.
FlankTolerances tolerance_edition(RatingEdition edition);

/// The tolerances of a gear.
///
/// Formula   flank_tolerances() for tolerance_edition()
/// Domain    has_class() (contract)
Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t);

}  // namespace gearwright
