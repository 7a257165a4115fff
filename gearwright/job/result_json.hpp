// The result as JSON with every key in the order of the interface. Internal to job/ and its tests.
#pragma once

#include "gearwright/job/files.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

Json warnings_json(const std::vector<Warning>& warnings);
/// A record that begins with `title`, if the spec has one.
Json titled_record(const JobSpec& spec);
/// The record of titled_record() with one result under its key.
Json titled_record(const JobSpec& spec, const char* key, const ValueRecord& result);
/// A record with `drawing` (if given), `gears` and `pair` (if there is one).
Json job_record(const SolvedJob& job);
/// The record of job_record() with `warnings` and `verdict` added.
Json job_json(const SolvedJob& job, const Verdict& verdict);
/// `arcs`: [{name, points}], n points per arc.   Domain: the outline is not empty (contract)
Json outline_json(const Outline& outline, int n);
/// [{file, what, max_deviation_um, note}]
Json files_json(const std::vector<JobFile>& files);
Json error_json(const Error& error);
Json verdict_json(const Verdict& verdict);

}  // namespace gearwright
