// Computes a pair for each row of a table of numbers. Each column of the table contains the
// values of one key of the spec. The result has one row of quantities for each row of the
// table.
//
// Each row is read as a whole spec, as Pair.replace() reads it, so that the rules between several
// keys apply. Reading takes less than a third of the time of a row.
#include <fmt/format.h>

#include <cmath>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::python {

namespace {

// A key whose value differs from row to row.
struct Swept {
  const Key* key;
  std::string table;  ///< "pair", "gear1" or "gear2"
  std::string name;   ///< the key in the spec, whose lengths may be in inch
  std::string path;   ///< the name of the key as the caller gives it, after the table
  Numbers numbers;
  double unit;  ///< size of one unit of `numbers` in the unit of the key
  const KeyUnit*
      inch;  ///< the unit of the spec, if `numbers` are converted to inch; otherwise null
};

bool can_be_swept(const Key& key) {
  const bool number = key.kind == KeyKind::number || key.kind == KeyKind::whole;
  return number && (!key.list || key.list->single);
}

const Key& key_of(const KeyTable& table, const std::string& name, const std::string& path) {
  const Key* const key = key_of_name(table, name);
  if (key && can_be_swept(*key)) return *key;
  std::vector<std::string> may;
  for (const Key& other : table.keys)
    if (can_be_swept(other)) may.push_back(house_key(other));
  raise(
      Error{path, "",
            fmt::format("cannot be varied; keys that can be varied are {}", fmt::join(may, ", "))});
}

Swept swept(const KeyTable& keys, const std::string& table, const std::string& name,
            py::handle column, UnitSystem units) {
  const std::string path = table + "." + name;
  const bool in_inch = units == UnitSystem::inch;
  const Key& key = key_of(keys, in_inch ? metric_key(name) : name, path);
  const auto numbers = real_numbers(column);
  if (!numbers || numbers->ndim() != 1)
    raise(Error{path, "", "must be a one-dimensional array or a list of real numbers"});
  const bool with_unit = name == key.key || name == key_in(units, key.key);
  if (with_unit) return {&key, table, name, path, *numbers, 1.0, nullptr};
  return {&key,
          table,
          key_in(units, key.key),
          path,
          *numbers,
          units_per_house(key),
          in_inch ? metric_unit(key.key) : nullptr};
}

std::vector<Swept> swept_keys(const py::kwargs& kwargs, UnitSystem units) {
  std::vector<Swept> all;
  for (const auto& [name_of_key, column] : kwargs) {
    const std::string name = py::str(name_of_key);
    const auto [gear, member] = subject_of(name);
    if (gear == 0 || member != GearMember::none) {
      all.push_back(swept(pair_keys(), "pair", name, column, units));
      continue;
    }
    if (!py::isinstance<py::dict>(column))
      raise(Error{name, "", "must be a dict with keys of the gear and their arrays"});
    for (const auto& [inner, numbers] : py::reinterpret_borrow<py::dict>(column))
      all.push_back(swept(gear_keys(), name, std::string(py::str(inner)), numbers, units));
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

// Sets one value in the spec. Its range is checked when the spec is read.
std::optional<Error> put(Json& spec, const Swept& s, std::size_t row) {
  const double given = s.numbers.data()[row];
  if (!std::isfinite(given))
    return Error{s.path, fmt::format("{}", given), "must be a finite number"};
  double x = given * s.unit;
  if (auto error = missing_unit(*s.key, s.path, given, x)) return error;
  if (s.inch) x = s.inch->to_inch(x);
  const bool whole = s.key->kind == KeyKind::whole && x == std::round(x) && std::abs(x) < 1e15;
  spec[s.table][s.name] = whole ? Json(static_cast<long long>(x)) : Json(x);
  return std::nullopt;
}

Result<SolvedJob> solved_row(const Model& model, const std::vector<Swept>& keys, std::size_t row) {
  Json tree = model.spec;
  for (const Swept& s : keys)
    if (auto error = put(tree, s, row)) return *error;
  const auto spec = read_spec_tree(tree, model.folder);
  if (!spec) return spec.error();
  auto job = solve(*spec, Scope::pair);
  if (!job) return spelled(job.error(), spec->given);
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
  const ModelPtr model = with_two_gears(pair.model);
  const std::vector<Swept> keys = swept_keys(kwargs, units_of(model->spec));
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
      const auto job = solved_row(*model, keys, r);
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
      "message that replace() raises in `error`. The computation uses all cores and releases the "
      "GIL");
}

}  // namespace gearwright::python
