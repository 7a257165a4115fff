#include "apps/python/values.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::python {

namespace {

py::object type_of(const char* module, const char* name) {
  return py::module_::import(module).attr(name);
}

struct ToPython {
  bool by_name;       // true for an attribute, which has numbers in mm and rad, tuples and Records
  double unit = 1.0;  // for an attribute, the size of the unit of the numbers in mm or rad
  const QuantityTable* table = nullptr;  // for an attribute, the table of a record, if it is known

  py::object operator()(std::monostate) const { return py::none(); }
  py::object operator()(bool flag) const { return py::bool_(flag); }
  py::object operator()(long long whole) const { return py::int_(whole); }
  py::object operator()(double x) const {
    if (!std::isfinite(x)) return py::none();
    return py::float_(x * unit);
  }
  py::object operator()(const std::string& word) const { return py::str(word); }
  py::object operator()(const ValueList& list) const {
    py::list all;
    for (const Value& v : list) all.append(std::visit(*this, v.variant()));
    if (by_name) return py::tuple(all);
    return all;
  }
  py::object operator()(const ValueRecord& record) const {
    py::dict attributes, items;
    py::list keys;
    for (const Member& m : record) {
      const py::str key(m.info->key);
      const bool in_json = (m.info->doors & kJson) != 0;
      if (in_json) keys.append(key);
      if (in_json || by_name) items[key] = by_key(m.value);
      if (by_name) attributes[py::str(name_of(*m.info))] = python::by_name(*m.info, m.value);
    }
    if (!by_name) return items;
    if (table)
      for (const QuantityInfo* info : table->list)  // an absent quantity is None
        if (const py::str name(name_of(*info)); !attributes.contains(name))
          attributes[name] = py::none();
    return type_of("gearwright._records", "Record")(attributes, items, keys);
  }
  py::object operator()(const ValueMap& map) const {
    py::dict all;
    for (const auto& [name, value] : map) all[py::str(name)] = by_key(value);
    return all;
  }
};

Json number_of(double x, const std::string& path) {
  if (!std::isfinite(x))
    raise({path, std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf", "must be a finite number"});
  return x;
}

Json whole_of(py::handle value, const std::string& path) {
  int overflow = 0;
  const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow != 0)
    raise({path, std::string(py::str(value)), "is larger than any value of a gear"});
  return whole;
}

// Returns the letter of the kind of numpy, "f" for floating-point numbers.
std::string kind_of(py::handle value) {
  const py::object type = py::getattr(value, "dtype", py::none());
  return py::str(py::getattr(type, "kind", py::none()));
}

// True for a time or an array of times. Such values must not be passed to numpy's tolist(),
// which would convert times in ns to whole numbers.
bool is_time(py::handle value) {
  const std::string kind = kind_of(value);
  return kind == "m" || kind == "M";
}

Json mapping_of(py::handle value, const std::string& path) {
  Json tree = Json::object();
  const py::object keys =
      value.attr("keys")();  // the only method that dicts, Records and tables have in common
  for (const auto& name : keys) {
    const std::string key = py::str(name);
    const py::object member = value[name];
    if (member.is_none()) continue;  // None stands for a value that is not given
    tree[key] = tree_of(member, path.empty() ? key : path + "." + key);
  }
  return tree;
}

}  // namespace

std::string name_of(const QuantityInfo& info) {
  if (info.key == "from") return "from_";  // `from` is a keyword of Python
  if (info.unit == Unit::m_per_s) return info.key;
  const std::string_view suffix = unit_suffix(info.unit);
  const std::string_view key = info.key;
  return std::string(key.ends_with(suffix) ? key.substr(0, key.size() - suffix.size()) : key);
}

double house_unit(Unit unit) {
  for (const HouseUnit& house : kHouseUnits)
    if (house.unit == unit) return house.size;
  return 1.0;
}

namespace {

std::string text_of(const QuantityInfo& info) {
  const bool angle = info.unit == Unit::deg || info.unit == Unit::arcsec;
  const std::string unit(angle                        ? "rad"
                         : info.unit == Unit::um      ? "mm"
                         : info.unit == Unit::percent ? "as a fraction of 1"
                                                      : unit_text(info.unit));
  std::string text = info.symbol;
  if (!unit.empty()) text += (text.empty() ? "" : ", ") + unit;
  if (!text.empty()) text += ": ";
  text += info.words;
  if (!info.meaning.empty()) text += (info.words.empty() ? "" : ", ") + info.meaning;
  return text + ".";
}

}  // namespace

std::string docstring(const QuantityTable& table, const std::string& name) {
  std::string text;
  for (const QuantityInfo* info : table.list)
    if (name_of(*info) == name) text += (text.empty() ? "" : " ") + text_of(*info);
  return text;
}

py::object to_python(const Json& tree) { return by_key(to_value(tree)); }

py::object by_key(const Value& value) { return std::visit(ToPython{false}, value.variant()); }

py::object by_name(const QuantityInfo& info, const Value& value) {
  const bool any_length = !info.list.empty() && info.list[0] == 0;
  if (info.type == Type::number && any_length && value.list())
    return py::array(py::module_::import("numpy").attr("array")(
        std::visit(ToPython{false, house_unit(info.unit)}, value.variant()), "f8"));
  const QuantityTable* const table = info.of ? &info.of() : nullptr;
  return std::visit(ToPython{true, house_unit(info.unit), table}, value.variant());
}

py::object by_name(const QuantityTable& table, const Value& records) {
  return std::visit(ToPython{true, 1.0, &table}, records.variant());
}

namespace {

// Raises RecursionError if a tree contains itself.
struct Depth {
  Depth() {
    if (Py_EnterRecursiveCall(" in a spec") != 0) throw py::error_already_set();
  }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;
  ~Depth() { Py_LeaveRecursiveCall(); }
};

}  // namespace

Json tree_of(py::handle value, const std::string& path) {
  const Depth deeper;
  PyObject* const o = value.ptr();
  if (value.is_none()) return nullptr;
  if (PyBool_Check(o)) return o == Py_True;
  if (PyLong_Check(o)) return whole_of(value, path);
  if (PyFloat_Check(o)) return number_of(PyFloat_AS_DOUBLE(o), path);
  if (PyUnicode_Check(o)) return std::string(py::str(value));
  if (py::isinstance<GearValue>(value)) return value.cast<const GearValue&>().spec();
  const bool bytes = PyBytes_Check(o) || PyByteArray_Check(o);
  const bool numpy = py::hasattr(value, "tolist");
  if (numpy && !is_time(value)) {
    const py::object plain = value.attr("tolist")();
    if (!py::type::of(plain).is(py::type::of(value))) return tree_of(plain, path);
    // A long double of numpy has no other form in Python.
    if (kind_of(value) == "f") return number_of(py::float_(plain), path);
  }
  if (PyDict_Check(o) || py::hasattr(value, "keys")) return mapping_of(value, path);
  if (py::hasattr(value, "__fspath__")) return std::string(py::str(value.attr("__fspath__")()));
  if (PyIndex_Check(o) && !numpy)
    return whole_of(py::reinterpret_steal<py::object>(PyNumber_Index(o)), path);
  if (PySequence_Check(o) && !numpy && !bytes) {
    Json list = Json::array();
    for (const auto& item : value)
      list.push_back(tree_of(item, path + "[" + std::to_string(list.size()) + "]"));
    return list;
  }
  if (py::hasattr(value, "__float__") && !numpy)
    return number_of(value.attr("__float__")().cast<double>(), path);
  throw py::type_error(path + ": a spec cannot contain " + std::string(py::repr(value)));
}

bool is_path(py::handle value) {
  return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
         py::hasattr(value, "__fspath__");
}

std::filesystem::path path_of(py::handle value, const std::string& name) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(value.ptr(), &bytes) != 0)
    return std::string(py::reinterpret_steal<py::bytes>(bytes));
  const bool another_type = PyErr_ExceptionMatches(PyExc_TypeError) != 0;
  PyErr_Clear();
  const std::string shown = py::repr(value);
  if (another_type) throw py::type_error(name + ": must be the path of a file, not " + shown);
  raise({name, shown, "cannot be the name of a file"});
}

std::optional<std::filesystem::path> path_or_none(py::handle value, const std::string& name) {
  if (value.is_none()) return std::nullopt;
  return path_of(value, name);
}

int threads_in_range(int threads) {
  constexpr int kMostThreads = 1024;  // as in the verbs `batch` and `search`
  if (threads < 0 || threads > kMostThreads)
    raise(refused("threads", threads,
                  "must lie between 1 and " + std::to_string(kMostThreads) +
                      ", or 0 for all cores of the machine"));
  return threads;
}

void raise(const Error& error) {
  const py::object type = type_of("gearwright._errors", "SpecError");
  PyErr_SetObject(
      type.ptr(),
      type(error.field, error.value, error.rule, error.message(), to_string(error.kind)).ptr());
  throw py::error_already_set();
}

void raise_of_gear(Error error) {
  const std::string_view gear = "gear1.";
  for (std::string* text : {&error.field, &error.rule})
    for (std::size_t at = text->find(gear); at != std::string::npos; at = text->find(gear, at))
      text->erase(at, gear.size());
  const std::string_view table = "in [gear1]";
  if (const std::size_t at = error.rule.find(table); at != std::string::npos)
    error.rule.replace(at, table.size(), "of a gear");
  raise(error);
}

}  // namespace gearwright::python
