// What the catalogue says, for the stubs and for whoever asks at run time.
#include <algorithm>

#include "apps/python/model.hpp"
#include "apps/python/pickles.hpp"
#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/contact_keys.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/load_keys.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/pair_keys.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/catalogue/verdict_quantities.hpp"

namespace gearwright::python {

namespace {

const char* word_of(Type type) {
  switch (type) {
    case Type::number: return "number";
    case Type::whole: return "whole";
    case Type::index: return "index";
    case Type::flag: return "flag";
    case Type::word: return "word";
    case Type::text: return "text";
    case Type::record: return "record";
    case Type::map: return "map";
  }
  return "";
}

const char* word_of(KeyKind kind) {
  switch (kind) {
    case KeyKind::number: return "number";
    case KeyKind::whole: return "whole";
    case KeyKind::boolean: return "boolean";
    case KeyKind::text: return "text";
    case KeyKind::word: return "word";
    case KeyKind::table: return "table";
    case KeyKind::any: return "any";
  }
  return "";
}

// Adds a table and those of the records in it.
void add(std::vector<const QuantityTable*>& all, const QuantityTable& table) {
  const auto same = [&](const QuantityTable* other) { return other->name == table.name; };
  if (std::any_of(all.begin(), all.end(), same)) return;
  all.push_back(&table);
  for (const QuantityInfo* info : table.list)
    if (info->of) add(all, info->of());
}

py::list said_list(const QuantityTable& table) {
  py::list list;
  for (const QuantityInfo* info : table.list) {
    py::dict one;
    one["name"] = name_of(*info);
    one["key"] = info->key;
    one["symbol"] = info->symbol;
    one["unit"] = unit_text(info->unit);
    one["words"] = info->words;
    one["meaning"] = info->meaning;
    one["type"] = word_of(info->type);
    one["list"] = info->list;
    one["always"] = info->always && !info->optional_key;
    one["of"] = info->of ? info->of().name : "";
    one["doc"] = docstring(*info);
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
    one["symbol"] = key.symbol;
    one["kind"] = word_of(key.kind);
    one["list"] = key.list.has_value();
    one["meaning"] = plain_words(key.meaning);
    list.append(one);
  }
  return list;
}

}  // namespace

std::vector<const QuantityTable*> all_tables() {
  std::vector<const QuantityTable*> all;
  for (const QuantityTable* table :
       {&gear_quantities().table(), &pair_quantities().table(), &contact_quantities().table(),
        &compensate_quantities().table(), &fit_quantities().table(), &search_quantities().table(),
        &design_quantities().table(), &rating_quantities().table(), &load_quantities().table(),
        &verdict_quantities().table(), &warning_quantities().table()})
    add(all, *table);
  return all;
}

void bind_said(py::module_& m) {
  m.def("_catalogue", [] {
    py::dict all;
    for (const QuantityTable* table : all_tables()) all[py::str(table->name)] = said_list(*table);
    return all;
  });
  m.def("_keys", [] {
    py::dict all;
    all["gear"] = keys_of(gear_keys());
    all["pair"] = keys_of(pair_keys());
    all["compensate"] = keys_of(compensate_keys());
    all["contact"] = keys_of(contact_keys());
    all["load"] = keys_of(load_keys());
    all["rating"] = keys_of(rating_keys());
    return all;
  });
}

}  // namespace gearwright::python
