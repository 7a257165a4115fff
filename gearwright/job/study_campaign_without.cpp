// The version without the store cannot save a study in a folder.
#include <nlohmann/json.hpp>

#include "gearwright/job/search_campaign.hpp"
#include "gearwright/job/study_campaign.hpp"

namespace gearwright {

Result<StudyRun> run_study_campaign(const JobSpec&, const Search&, const std::vector<ListedDesign>&,
                                    const StudyOptions&, std::vector<Json>&) {
  return *refuse_folder();
}

}  // namespace gearwright
