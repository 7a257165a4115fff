// Tolerances of ISO 1328-1 that a rating needs, from the accuracy grade.
//
//   f_pt, f_pb    single pitch deviation, and on the base circle f_pb = f_pt cos α_t
//   f_fα, f_Hβ    profile form and helix slope deviation        all in µm
//
// ISO 6336 of 2006 is used with ISO 1328-1:1995, whose formulas use the geometric mean of a range
// of module, diameter and face width. ISO 6336 of 2019 is used with ISO 1328-1:2013, which uses the
// values of the gear.
#pragma once

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

constexpr int kBestGrade = 0, kWorstGrade = 12;

struct Tolerances {
  double f_pt, f_pb, f_falpha, f_Hbeta;  ///< µm
};

/// Formula   ISO 1328-1:1995, clause 6 and annexes (grade 5 times 2^((Q − 5)/2), rounded as there);
///           ISO 1328-1:2013, clause 5
/// Domain    kBestGrade ≤ grade ≤ kWorstGrade (contract)
Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t);

}  // namespace gearwright
