// Converts the tables of the catalogue to Python objects, from which the type stubs are made.
#include <array>

#include "apps/python/model.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright::python {

namespace {

// The names of Type and of KeyKind, in the order of their enumerators.
constexpr std::array kTypes{"number", "whole", "index", "flag", "word", "text", "record", "map"};
constexpr std::array kKinds{"number", "whole",   "boolean", "text",
                            "word",   "by_name", "table",   "any"};

py::list quantity_list(const QuantityTable& table) {
  py::list list;
  for (const QuantityInfo* info : table.list) {
    py::dict one;
    one["name"] = name_of(*info);
    one["key"] = info->key;
    one["unit"] = unit_text(info->unit);
    one["type"] = kTypes[static_cast<std::size_t>(info->type)];
    one["list"] = info->list;
    one["always"] = info->always && !info->optional_key;
    one["of"] = info->of ? info->of().name : "";
    one["doc"] = docstring(table, name_of(*info));
    list.append(one);
  }
  return list;
}

py::list keys_of(const KeyTable& table) {
  py::list list;
  for (const Key& key : table.keys) {
    py::dict one;
    one["key"] = key.key;
    one["name"] = house_key(key);
    one["in_inch"] = key_in(UnitSystem::inch, key.key);
    one["kind"] = kKinds[static_cast<std::size_t>(key.kind)];
    one["list"] = key.list.has_value();
    list.append(one);
  }
  return list;
}

}  // namespace

void bind_catalogue(py::module_& m) {
  m.def("_catalogue", [] {
    py::dict all;
    for (const QuantityTable* table : result_tables())
      if (!all.contains(table->name)) all[py::str(table->name)] = quantity_list(*table);
    return all;
  });
  m.def("_keys", [] {
    py::dict all;
    for (const KeyTable* table : all_key_tables())
      all[py::str(std::string(table->name))] = keys_of(*table);
    return all;
  });
  m.def("_units", [] {
    py::dict sizes;
    for (const HouseUnit& house : kHouseUnits)
      sizes[py::str(std::string(unit_suffix(house.unit)))] = house.size;
    return sizes;
  });
}

}  // namespace gearwright::python
