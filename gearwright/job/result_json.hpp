// Converts results to JSON. A whole result has every key, in the order of the interface. This
// header also converts single values of the catalogue, and the range of a record within tolerances.
// Internal to job/, the programs and tests.
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

Json warnings_json(const std::vector<Warning>& warnings);
/// Returns a record that begins with `title`, if the spec has a title.
Json titled_record(const JobSpec& spec);
/// Returns a record that begins with `title`, if the spec has a title, and contains the result
/// under `key`.
Json titled_record(const JobSpec& spec, const char* key, const ValueRecord& result);
/// Returns the quantities of the pair, or of the pinion with its rack.
///
/// Domain    job.mounted() (contract)
ValueRecord pair_record(const SolvedJob& job);
/// Returns a record with `drawing` (if given), `gears` and `pair` (if there is one).
Json job_record(const SolvedJob& job);
/// Returns the record of job_record() with `warnings` and `verdict`, in the units of the spec.
Json job_json(const SolvedJob& job, const Verdict& verdict);
/// Returns {arcs: [{name, points}]} with n points per arc.
///
/// Domain    the outline is not empty (contract)
Json outline_json(const Outline& outline, int n);
/// Adds the list `key` to `object`, which is the text of a JSON object. row(i) returns row i of the
/// `count` rows. Each row has a line of its own, because such a list may be long.
template <class Row>
void add_row_lines(std::string& object, const char* key, std::size_t count, const Row& row) {
  object.back() = ',';  // replaces the closing brace
  object += std::string("\n  \"") + key + "\": [";
  for (std::size_t i = 0; i < count; ++i)
    object += (i == 0 ? "\n    " : ",\n    ") + json_text(row(i));
  object += count == 0 ? "]}" : "\n  ]}";
}
/// Returns [{file, what, max_deviation_um, note}].
Json files_json(const std::vector<JobFile>& files);
Json error_json(const Error& error);
Json verdict_json(const Verdict& verdict);

// The range of a record within the tolerances, as JSON and for listings. It contains only the
// numbers that differ from each other or from the nominal value.

/// A record of the gears and the pair of one combination of toleranced numbers.
using RecordAt = std::function<ValueRecord(const Arranged&)>;

struct RecordLimits {
  ValueRecord lower, upper;
  ValueRecord excluded{};  ///< the nominal values if the tolerances exclude them, otherwise empty
};

/// Returns the limits of each number of a record within the tolerances. They are the values at the
/// lower and at the upper end. If another combination of ends or a permitted nominal value lies
/// outside them, the limits are the least and the greatest value instead.
///
/// Domain    the job has tolerances (contract)
RecordLimits limits_of(const SolvedJob& job, const RecordAt& record);
/// Return limits_of() for the quantities of the gear with index i, and for those of the pair.
RecordLimits gear_limits(const SolvedJob& job, std::size_t i);
RecordLimits pair_limits(const SolvedJob& job);

/// Returns {key: [first limit, second limit]} for the numbers that differ. In contrast to other
/// JSON results, this object also contains quantities that only the tables for users show, for
/// example the thickness allowance. An inner record is an inner object. In a list, null replaces a
/// number that does not differ. Lists of records are omitted.
Json interval_json(const RecordLimits& limits);

/// Returns gear_record() of each gear.
std::vector<ValueRecord> gear_records(const SolvedJob& job);

/// Returns both limits as records for a listing that shows only the rows that differ.
std::vector<ValueRecord> differing(RecordLimits limits);

// Converts a value of the catalogue to JSON, with the keys for JSON, and back.

/// Converts a value to JSON. Reading the JSON gives exactly the doubles of the value. An absent
/// value, NaN and infinity become null.
Json to_json(const Value& value);

/// Converts a tree of JSON to a value, for example a spec inside a result.
Value to_value(const Json& json);

// The JSON Schema (draft 2020-12) of results, made from the catalogue.

/// Returns every table of a result, each followed by the tables of its records.
std::vector<const QuantityTable*> result_tables();

/// Returns the schema of the results of all verbs with --json, and of the error for a rejected
/// spec.
Json result_schema();

}  // namespace gearwright
