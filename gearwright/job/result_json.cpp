#include "gearwright/job/result_json.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

Json warnings_json(const std::vector<Warning>& warnings) {
  return to_json(warning_quantities().each(warnings));
}

Json titled_record(const JobSpec& spec) {
  // When the vector of an object grows, its members are copied. The vector therefore reserves space
  // for all members of an answer.
  constexpr std::size_t kMembers = 8;
  Json::object_t record;
  record.reserve(kMembers);
  if (!spec.title.empty()) record["title"] = spec.title;
  return record;
}

Json titled_record(const JobSpec& spec, const char* key, const ValueRecord& result) {
  Json record = titled_record(spec);
  record[key] = to_json(result);
  return record;
}

std::vector<ValueRecord> gear_records(const SolvedJob& job) {
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < job.gears.size(); ++i)
    records.push_back(gear_record(job.gears[i], job.halves[i]));
  return records;
}

ValueRecord pair_record(const SolvedJob& job) {
  GW_EXPECTS(job.mounted());
  return job.rack ? rack_pair_quantities().of(*job.rack) : pair_quantities().of(*job.pair);
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
  if (job.rack) j["gears"].push_back(to_json(rack_quantities().of(job.rack->rack)));
  if (job.mounted()) j["pair"] = to_json(pair_record(job));
  if (job.ends) {
    for (std::size_t i = 0; i < job.gears.size(); ++i) {
      j["gears"][i]["interval"] = interval_json(gear_limits(job, i));
    }
    if (job.pair) {
      j["pair"]["interval"] = interval_json(pair_limits(job));
    }
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
  return {{"error",
           {{"key", error.field},
            {"value", error.value},
            {"message", error.message()},
            {"kind", to_string(error.kind)}}}};
}

namespace {

// True if the values differ by more than rounding errors. A number that does not depend on the
// tolerances may still differ by rounding errors.
bool differ(double a, double b) {
  constexpr double kRounding = 1e-13;
  return std::abs(a - b) > kRounding * std::max(std::abs(a), std::abs(b));
}

// True if x lies between a and b, or outside by a rounding error.
bool encloses(double a, double b, double x) {
  // Relative tolerance, because x may equal a limit except for rounding errors.
  constexpr double kRounding = 1e-9;
  const double noise = kRounding * std::max(std::abs(a), std::abs(b));
  return x >= std::min(a, b) - noise && x <= std::max(a, b) + noise;
}

const Value* drawn_value(const ValueRecord& record, const QuantityInfo* info) {
  const Member* const m = member_for(record, info);
  return m ? &m->value : nullptr;
}

Json interval_of(const ValueRecord& lower, const ValueRecord& upper, const ValueRecord& excluded);

// Returns both limits if they differ from each other or from the excluded nominal value, and null
// otherwise. Without an excluded value, `excluded` is null.
Json interval_of(const Value& lower, const Value& upper, const Value* excluded) {
  const auto a = lower.number(), b = upper.number();
  const auto x = excluded ? excluded->number() : std::nullopt;
  if (a && b) return differ(*a, *b) || (x && !encloses(*a, *b, *x)) ? Json{*a, *b} : Json();
  if (lower.record() && upper.record()) {
    const ValueRecord* const nominal = excluded ? excluded->record() : nullptr;
    Json inner = interval_of(*lower.record(), *upper.record(), nominal ? *nominal : ValueRecord());
    return inner.empty() ? Json() : inner;
  }
  const ValueList *list = lower.list(), *other = upper.list();
  if (!list || !other || list->size() != other->size()) return {};
  const ValueList* const nominal = excluded ? excluded->list() : nullptr;
  Json values = Json::array();
  bool any = false;
  for (std::size_t i = 0; i < list->size(); ++i) {
    if ((*list)[i].record()) return {};
    const Value* const drawn = nominal && i < nominal->size() ? &(*nominal)[i] : nullptr;
    values.push_back(interval_of((*list)[i], (*other)[i], drawn));
    any = any || !values.back().is_null();
  }
  return any ? values : Json();
}

Json interval_of(const ValueRecord& lower, const ValueRecord& upper, const ValueRecord& excluded) {
  Json j = Json::object();
  for (const Member& m : lower) {
    const Member* other = member_for(upper, m.info);
    if (!other) continue;
    Json value = interval_of(m.value, other->value, drawn_value(excluded, m.info));
    if (!value.is_null()) j[m.info->key] = std::move(value);
  }
  return j;
}

// Hides the values that interval_of() omits. Returns true if any values remain.
bool keep_differing(ValueRecord& lower, ValueRecord& upper, const ValueRecord& excluded) {
  bool any = false;
  for (Member& m : lower) {
    Member* const other = member_for(upper, m.info);
    const Value* const drawn = drawn_value(excluded, m.info);
    bool kept = false;
    if (other && m.value.record() && other->value.record()) {
      ValueRecord a = *m.value.record(), b = *other->value.record();
      const ValueRecord* const nominal = drawn ? drawn->record() : nullptr;
      kept = keep_differing(a, b, nominal ? *nominal : ValueRecord());
      m.value = std::move(a);
      other->value = std::move(b);
    } else if (other) {
      kept = !interval_of(m.value, other->value, drawn).is_null();
    }
    m.shown = m.shown && kept;
    if (other) other->shown = other->shown && kept;
    any = any || m.shown;
  }
  for (Member& m : upper) m.shown = m.shown && member_for(lower, m.info);
  return any;
}

void enclose(ValueRecord& lower, ValueRecord& upper, const ValueRecord& other);

// Widens the limits of a value so that they enclose `other`.
void enclose(Value& lower, Value& upper, const Value& other) {
  if (const auto a = lower.number(), b = upper.number(), x = other.number(); a && b && x) {
    if (encloses(*a, *b, *x)) return;
    const double least = std::min(*a, *b), greatest = std::max(*a, *b);
    lower = std::min(least, *x);
    upper = std::max(greatest, *x);
  } else if (lower.record() && upper.record() && other.record()) {
    ValueRecord one = *lower.record(), two = *upper.record();
    enclose(one, two, *other.record());
    lower = std::move(one);
    upper = std::move(two);
  } else if (lower.list() && upper.list() && other.list()) {
    ValueList one = *lower.list(), two = *upper.list();
    for (std::size_t i = 0; i < std::min({one.size(), two.size(), other.list()->size()}); ++i)
      enclose(one[i], two[i], (*other.list())[i]);
    lower = std::move(one);
    upper = std::move(two);
  }
}

void enclose(ValueRecord& lower, ValueRecord& upper, const ValueRecord& other) {
  for (Member& m : lower) {
    Member* const second = member_for(upper, m.info);
    const Member* const third = member_for(other, m.info);
    if (second && third) enclose(m.value, second->value, third->value);
  }
}

}  // namespace

RecordLimits limits_of(const SolvedJob& job, const RecordAt& record) {
  RecordLimits limits{record(job.ends->lower), record(job.ends->upper)};
  if (tolerances_exclude_nominal(job)) {
    limits.excluded = record(job);
  } else {
    enclose(limits.lower, limits.upper, record(job));
  }
  for (const Arranged& corner : job.corners()) enclose(limits.lower, limits.upper, record(corner));
  return limits;
}

RecordLimits gear_limits(const SolvedJob& job, std::size_t i) {
  return limits_of(job, [i](const Arranged& at) { return gear_quantities().of(at.gears[i]); });
}

RecordLimits pair_limits(const SolvedJob& job) {
  return limits_of(job, [](const Arranged& at) { return pair_quantities().of(*at.pair); });
}

Json interval_json(const RecordLimits& limits) {
  return interval_of(limits.lower, limits.upper, limits.excluded);
}

std::vector<ValueRecord> differing(RecordLimits limits) {
  keep_differing(limits.lower, limits.upper, limits.excluded);
  return {std::move(limits.lower), std::move(limits.upper)};
}

namespace {

struct JsonWriter {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const ValueList& list) const {
    Json::array_t j;
    j.reserve(list.size());
    for (const Value& v : list) j.push_back(to_json(v));
    return j;
  }
  Json operator()(const ValueRecord& record) const {
    Json::object_t j;
    j.reserve(record.size());
    for (const Member& m : record) {
      if (m.info->doors & kJson) j[m.info->key] = to_json(m.value);
    }
    return j;
  }
  Json operator()(const ValueMap& map) const {
    Json::object_t j;
    j.reserve(map.size());
    for (const auto& [name, value] : map) j[name] = to_json(value);
    return j;
  }
  template <class T>
  Json operator()(const T& plain) const {
    return plain;
  }
};

}  // namespace

Json to_json(const Value& value) { return std::visit(JsonWriter(), value.variant()); }

Value to_value(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean: return json.get<bool>();
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned: return json.get<long long>();
    case Json::value_t::number_float: return json.get<double>();
    case Json::value_t::string: return json.get<std::string>();
    case Json::value_t::array: {
      ValueList list;
      for (const Json& j : json) list.push_back(to_value(j));
      return list;
    }
    case Json::value_t::object: {
      ValueMap map;
      for (const auto& [key, j] : json.items()) map.emplace_back(key, to_value(j));
      return map;
    }
    case Json::value_t::null:
    case Json::value_t::binary:
    case Json::value_t::discarded: return {};
  }
  return {};
}

}  // namespace gearwright
