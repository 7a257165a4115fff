// A study whose finished rows stay in a folder, so that it can be resumed and shared.
//
// Internal to job/. A build without the store uses study_campaign_without.cpp.
#pragma once

#include "gearwright/job/scatter_study.hpp"

namespace gearwright {

/// Computes the missing rows of this process in options.out. If no row is missing afterwards, the
/// run contains all rows, without a ranking.
///
/// Throws    IoError, WorkStopped
/// Errors    "--out" if the folder belongs to another study; the errors of study_row()
Result<StudyRun> run_study_campaign(const JobSpec& spec, const Search& search,
                                    const std::vector<ListedDesign>& list,
                                    const StudyOptions& options, std::vector<Json>& rows);

}  // namespace gearwright
