// Computes a pair for each row of a table of numbers. Each column of the table contains the
// values of one key of the spec. The result has one row of quantities for each row of the
// table.
#include <fmt/format.h>

#include <cmath>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/catalogue/gear_keys.hpp"

namespace gearwright::python {

namespace {

// A key whose value differs from row to row.
struct Swept {
  const Key* key;
  int gear;  ///< 1 or 2; 0 for a key of the pair
  std::string path;
  Numbers numbers;
  double unit;  ///< size of one unit of `numbers` in the unit of the key

  double at(std::size_t row) const { return numbers.data()[row] * unit; }
};

bool can_be_swept(const Key& key) {
  const bool number = key.kind == KeyKind::number || key.kind == KeyKind::whole;
  return number && !key.list && key.place.is_member();
}

const Key& key_of(const KeyTable& table, const std::string& name, const std::string& path) {
  for (const Key& key : table.keys)
    if ((key.key == name || house_key(key) == name) && can_be_swept(key)) return key;
  std::vector<std::string> may;
  for (const Key& key : table.keys)
    if (can_be_swept(key)) may.push_back(house_key(key));
  raise(
      Error{path, "",
            fmt::format("cannot be varied; keys that can be varied are {}", fmt::join(may, ", "))});
}

Swept swept(const KeyTable& table, int gear, const std::string& name, py::handle column) {
  const std::string path = (gear == 0 ? "pair." : fmt::format("gear{}.", gear)) + name;
  const Key& key = key_of(table, name, path);
  const auto numbers = real_numbers(column);
  if (!numbers || numbers->ndim() != 1)
    raise(Error{path, "", "must be a one-dimensional array or a list of real numbers"});
  const bool in_unit = key.key == name;
  return {&key, gear, path, *numbers, in_unit ? 1.0 : units_per_house(key)};
}

std::vector<Swept> swept_keys(const py::kwargs& kwargs) {
  std::vector<Swept> all;
  for (const auto& [name_of_key, column] : kwargs) {
    const std::string name = py::str(name_of_key);
    const auto [gear, member] = subject_of(name);
    if (gear == 0 || member != GearMember::none) {
      all.push_back(swept(pair_keys(), 0, name, column));
      continue;
    }
    if (!py::isinstance<py::dict>(column))
      raise(Error{name, "", "must be a dict with keys of the gear and their arrays"});
    for (const auto& [inner, numbers] : py::reinterpret_borrow<py::dict>(column))
      all.push_back(swept(gear_keys(), gear, std::string(py::str(inner)), numbers));
  }
  if (all.empty())
    raise(Error{"sweep", "",
                "needs at least one key with an array, for example center_distance=distances"});
  for (const Swept& s : all)
    if (s.numbers.size() != all.front().numbers.size())
      raise(Error{s.path, fmt::format("{} numbers", s.numbers.size()),
                  fmt::format("must have as many values as {}, that is {}", all.front().path,
                              all.front().numbers.size())});
  return all;
}

// Sets one value. If the key does not permit this value, returns the same error as for a spec file.
std::optional<Error> put(JobSpec& spec, const Swept& s, std::size_t row) {
  const double x = s.at(row);
  if (!std::isfinite(x)) return Error{s.path, fmt::format("{}", x), "must be a finite number"};
  if (s.key->range.limited() && !s.key->range.contains(x))
    return refused(s.path, x, s.key->range.sentence(x));
  const bool whole = s.key->place.kind() == KeyKind::whole;
  if (whole && x != std::round(x)) return refused(s.path, x, "must be a whole number");
  const KeyValue value = whole ? KeyValue(static_cast<int>(x)) : KeyValue(x);
  if (s.gear == 0) {
    s.key->place.put(spec.pair, value);
  } else {
    s.key->place.put(spec.gear(s.gear), value);
  }
  return std::nullopt;
}

Result<SolvedJob> solved_row(JobSpec spec, const std::vector<Swept>& keys, std::size_t row) {
  for (const Swept& s : keys)
    if (auto error = put(spec, s, row)) return *error;
  auto job = solve(spec, Scope::pair);
  if (!job) return spelled(job.error(), spec.given);
  return job;
}

// Returns the array with one more column. The column is as wide as its longest text, whose length
// is known only after the computation.
py::array with_texts(const py::array& rows, const char* name,
                     const std::vector<std::string>& texts) {
  const py::object numpy = py::module_::import("numpy");
  const py::object column = numpy.attr("array")(py::cast(texts), "U");
  py::list types = rows.dtype().attr("descr");
  types.append(py::make_tuple(name, column.attr("dtype").attr("str")));
  const py::object all = numpy.attr("empty")(texts.size(), types);
  for (const auto& field : rows.dtype().attr("names")) all[field] = rows[field];
  all[py::str(name)] = column;
  return all;
}

py::array sweep(const PairValue& pair, int threads, const py::kwargs& kwargs) {
  threads_in_range(threads);
  const std::vector<Swept> keys = swept_keys(kwargs);
  const auto rows = static_cast<std::size_t>(keys.front().numbers.size());
  StructuredArray array(pair_quantities().table());
  array.allocate(rows);
  std::vector<std::string> errors(rows);
  const auto refuse = [&](std::size_t r, std::string why) {
    array.fill(r, ValueRecord());
    errors[r] = std::move(why);
  };
  watched_rows(rows, threads, [&](std::size_t r) {
    try {
      const auto job = solved_row(pair.model->job.spec, keys, r);
      if (job) return array.fill(r, pair_quantities().of(*job->pair));
      refuse(r, job.error().message());
    } catch (const ContractViolation& e) {  // the other rows must still be computed
      refuse(r, e.what());
    }
  });
  return with_texts(array.take(), "error", errors);
}

}  // namespace

void bind_sweep(py::class_<PairValue>& pair) {
  pair.def(
      "sweep", &sweep, py::arg("threads") = 0,
      "Computes the pair once for each value of the arrays. The values replace numbers of the "
      "pair, for example in sweep(center_distance=distances) or sweep(gear1={\"profile_shift\": "
      "shifts}). Returns a structured array with a row for each value and a column for each "
      "quantity, named by its key. If a pair does not exist, its row is NaN and contains the "
      "message in `error`. The computation uses all cores and releases the GIL");
}

}  // namespace gearwright::python
