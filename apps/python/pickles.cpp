#include "apps/python/pickles.hpp"

#include <map>

namespace gearwright::python {

namespace {

struct Keep {
  py::object operator()(std::monostate) const { return py::none(); }
  py::object operator()(bool flag) const { return py::bool_(flag); }
  py::object operator()(long long whole) const { return py::int_(whole); }
  py::object operator()(double x) const { return py::float_(x); }
  py::object operator()(const std::string& word) const { return py::str(word); }
  py::object operator()(const ValueList& list) const {
    py::list all;
    for (const Value& v : list) all.append(std::visit(*this, v.variant()));
    return all;
  }
  py::object operator()(const ValueRecord& record) const { return kept(record); }
  py::object operator()(const ValueMap& map) const {
    py::dict all;
    for (const auto& [name, value] : map) all[py::str(name)] = std::visit(*this, value.variant());
    return all;
  }
};

const std::string& table_of(const QuantityInfo* info) {
  static const std::map<const QuantityInfo*, std::string> kTables = [] {
    std::map<const QuantityInfo*, std::string> all;
    for (const QuantityTable* table : all_tables())
      for (const QuantityInfo* s : table->list) all.emplace(s, table->name);
    return all;
  }();
  return kTables.at(info);
}

const QuantityInfo* said_of(const std::string& table, const std::string& key) {
  static const std::map<std::string, const QuantityTable*> kTables = [] {
    std::map<std::string, const QuantityTable*> all;
    for (const QuantityTable* t : all_tables()) all.emplace(t->name, t);
    return all;
  }();
  const auto at = kTables.find(table);
  const QuantityInfo* info = at == kTables.end() ? nullptr : at->second->find(key);
  if (!info)
    throw py::value_error("the pickle is of another version of gearwright: there is no quantity " +
                          key + " of " + table);
  return info;
}

Value recalled_value(py::handle value) {
  PyObject* const o = value.ptr();
  if (value.is_none()) return {};
  if (PyBool_Check(o)) return o == Py_True;
  if (PyLong_Check(o)) return value.cast<long long>();
  if (PyFloat_Check(o)) return PyFloat_AS_DOUBLE(o);
  if (PyUnicode_Check(o)) return std::string(py::str(value));
  if (PyTuple_Check(o)) return recalled(value);
  if (PyDict_Check(o)) {
    ValueMap map;
    for (const auto& [name, inner] : py::reinterpret_borrow<py::dict>(value))
      map.emplace_back(std::string(py::str(name)), recalled_value(inner));
    return map;
  }
  ValueList list;
  for (const auto& inner : value.cast<py::list>()) list.push_back(recalled_value(inner));
  return list;
}

}  // namespace

py::object kept(const ValueRecord& record) {
  py::tuple all(record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    const Member& m = record[i];
    all[i] = py::make_tuple(table_of(m.info), m.info->key, std::visit(Keep(), m.value.variant()),
                            m.shown);
  }
  return all;
}

ValueRecord recalled(py::handle record) {
  ValueRecord all;
  for (const auto& member : record.cast<py::tuple>()) {
    const auto m = member.cast<py::tuple>();
    all.push_back({said_of(m[0].cast<std::string>(), m[1].cast<std::string>()),
                   recalled_value(m[2]), m[3].cast<bool>()});
  }
  return all;
}

}  // namespace gearwright::python
