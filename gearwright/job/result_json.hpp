// Results as JSON: the whole result with every key in the order of the interface, single values of
// the catalogue, and the range of a record within tolerances. Internal to job/ and its tests.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/catalogue/value.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct LoadAnalysis;

Json warnings_json(const std::vector<Warning>& warnings);
/// A record that begins with `title`, if the spec has one.
Json titled_record(const JobSpec& spec);
/// A record that begins with `title`, if the spec has one, and contains the result under `key`.
Json titled_record(const JobSpec& spec, const char* key, const ValueRecord& result);
/// A record with the title and, under the key `load`, the result of the verb `load`.
Json load_json(const SolvedJob& job, const LoadAnalysis& answer);
/// The quantities of the pair, or of the pinion with its rack.   Domain: job.mounted() (contract)
ValueRecord pair_record(const SolvedJob& job);
/// A record with `drawing` (if given), `gears` and `pair` (if there is one).
Json job_record(const SolvedJob& job);
/// The record of job_record() with `warnings` and `verdict` added.
Json job_json(const SolvedJob& job, const Verdict& verdict);
/// `arcs`: [{name, points}], n points per arc.   Domain: the outline is not empty (contract)
Json outline_json(const Outline& outline, int n);
/// Adds the list `key` to `object`, which is the text of an object in JSON. Every one of the
/// `count` rows is made by row(i) and has a line of its own, because such a list may be long.
template <class Row>
void add_row_lines(std::string& object, const char* key, std::size_t count, const Row& row) {
  object.back() = ',';  // replaces the closing brace
  object += std::string("\n  \"") + key + "\": [";
  for (std::size_t i = 0; i < count; ++i)
    object += (i == 0 ? "\n    " : ",\n    ") + json_text(row(i));
  object += count == 0 ? "]}" : "\n  ]}";
}
/// [{file, what, max_deviation_um, note}]
Json files_json(const std::vector<JobFile>& files);
Json error_json(const Error& error);
Json verdict_json(const Verdict& verdict);

// The range of a record within tolerances: the numbers that differ, in JSON and for users.

/// A record of the gears and the pair of one combination of toleranced numbers.
using RecordAt = std::function<ValueRecord(const Arranged&)>;

/// The limits of each number of a record within the tolerances. They are the values at the lower
/// and at the upper end, if no other combination of ends and no nominal value lies outside
/// them. Otherwise they are the least and the greatest value.
///
/// Domain    the job has tolerances (contract)
std::array<ValueRecord, 2> limits_of(const SolvedJob& job, const RecordAt& record);
/// limits_of() for the quantities of the gear with index i, and for those of the pair.
std::array<ValueRecord, 2> gear_limits(const SolvedJob& job, std::size_t i);
std::array<ValueRecord, 2> pair_limits(const SolvedJob& job);

/// {key: [first limit, second limit]} for the numbers that differ. Unlike other JSON results, this
/// object also contains quantities that are shown only in tables for users, for example the
/// thickness allowance. The numbers of an inner record are in an inner object. In a list, null
/// replaces a number that does not differ. Lists of records are omitted.
Json interval_json(const ValueRecord& lower, const ValueRecord& upper);

/// Both limits as records for a listing. The listing shows only the rows that differ.
std::vector<ValueRecord> differing(ValueRecord lower, ValueRecord upper);

// Converts a value of the catalogue to JSON, with the keys for JSON, and back.

/// Reading the JSON gives the same doubles. An absent value, NaN and infinity become null.
Json to_json(const Value& value);

/// A tree of JSON as a value, for example a spec inside a result.
Value to_value(const Json& json);

// The JSON Schema (draft 2020-12) of results, made from the catalogue.

/// Every table of a result. Each is followed by the tables of the records that it contains.
std::vector<const QuantityTable*> result_tables();

/// The schema of the results of all verbs with --json, including the error of a rejected spec.
Json result_schema();

}  // namespace gearwright
