// Implements campaign.hpp for a build without the store, which cannot save chunks in a folder.
#include <nlohmann/json.hpp>

#include "gearwright/job/scatter_study.hpp"
#include "gearwright/job/search_files.hpp"

namespace gearwright {

std::optional<Error> refuse_folder() {
  return Error{"--out", "",
               "this build has neither SQLite nor Parquet and cannot write the folder of a search; "
               "leave out --out and use --json, or use the installed program",
               FailureKind::option};
}

std::optional<Error> refuse_other_search(const std::filesystem::path&, const JobSpec&) {
  return std::nullopt;
}

Result<SearchRun> run_campaign(const JobSpec&, const Search&, std::int64_t, const SearchOptions&) {
  return *refuse_folder();
}

std::vector<std::filesystem::path> write_search_files(const JobSpec&, const Search&,
                                                      const SearchRun&,
                                                      const std::filesystem::path&,
                                                      std::optional<std::size_t>,
                                                      const FindSource&) {
  return {};
}

Result<StudyRun> run_study_campaign(const JobSpec&, const Search&, const std::vector<ListedDesign>&,
                                    const StudyOptions&, std::vector<Json>&) {
  return *refuse_folder();
}

}  // namespace gearwright
