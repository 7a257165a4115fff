#include "gearwright/job/result_json.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/drawing_quantities.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/catalogue/rack_pair_quantities.hpp"
#include "gearwright/catalogue/verdict_quantities.hpp"
#include "gearwright/job/interval.hpp"
#include "gearwright/job/value_json.hpp"
#include "gearwright/spec/unit_tree.hpp"

namespace gearwright {

Json warnings_json(const std::vector<Warning>& warnings) {
  return to_json(warning_quantities().each(warnings));
}

Json titled_record(const JobSpec& spec) {
  Json record = Json::object();
  if (!spec.title.empty()) record["title"] = spec.title;
  return record;
}

Json titled_record(const JobSpec& spec, const char* key, const ValueRecord& result) {
  Json record = titled_record(spec);
  record[key] = to_json(result);
  return record;
}

Json job_record(const SolvedJob& job) {
  Json j = titled_record(job.spec);
  if (job.spec.drawing.given()) j["drawing"] = to_json(drawing_quantities().of(job.spec.drawing));
  j["gears"] = Json::array();
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    Json gear = to_json(gear_record(job.gears[i], job.halves[i]));
    if (job.halves[i]) gear.update(to_json(double_helical_quantities().of(*job.halves[i])));
    j["gears"].push_back(std::move(gear));
  }
  if (job.rack) {
    j["gears"].push_back(to_json(rack_quantities().of(job.rack->rack)));
    j["pair"] = to_json(rack_pair_quantities().of(*job.rack));
  }
  if (job.pair) j["pair"] = to_json(pair_quantities().of(*job.pair));
  if (job.ends) {
    const auto& [lower, upper] = *job.ends;
    for (std::size_t i = 0; i < job.gears.size(); ++i)
      j["gears"][i]["interval"] =
          interval_json(gear_quantities().of(lower.gears[i]), gear_quantities().of(upper.gears[i]));
    if (job.pair)
      j["pair"]["interval"] =
          interval_json(pair_quantities().of(*lower.pair), pair_quantities().of(*upper.pair));
  }
  return j;
}

Json job_json(const SolvedJob& job, const Verdict& verdict) {
  Json j = job_record(job);
  j["warnings"] = warnings_json(job.warnings);
  j["verdict"] = verdict_json(verdict);
  return in_units(job.spec.units(), j);
}

Json verdict_json(const Verdict& verdict) { return to_json(verdict_quantities().of(verdict)); }

Json outline_json(const Outline& outline, int n) {
  GW_EXPECTS(!outline.arcs.empty());
  ValueList arcs;
  for (const Arc& arc : outline.arcs) arcs.push_back(outline_quantities().of({&arc, n}));
  return {{"arcs", to_json(arcs)}};
}

Json files_json(const std::vector<JobFile>& files) {
  ValueList list;
  for (const JobFile& f : files)
    list.push_back(
        file_quantities().of({f.path.filename().string(), f.what, f.note, f.deviation_mm}));
  return to_json(list);
}

Json error_json(const Error& error) {
  return {{"error", {{"key", error.field}, {"value", error.value}, {"message", error.message()}}}};
}

}  // namespace gearwright
