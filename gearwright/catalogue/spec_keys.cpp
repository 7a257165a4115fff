#include "gearwright/catalogue/spec_keys.hpp"

#include <set>

#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"

namespace gearwright {

namespace {

Key table_key(std::string_view key, const KeyTable& (*table)(), KeyPlace place,
              std::string_view meaning) {
  Key k = Key::part(key, table, std::move(place), meaning);
  k.in_documents = true;
  return k;
}

Key stage_key() {
  return {.key = "stage",
          .kind = KeyKind::table,
          .list = KeyList{.most = 100, .must = "must be a list of tables, [[stage]]"},
          .tables = {stage_keys},
          .meaning = "the stages of a train, for the verb `drive`"};
}

Key gear_2_key() {
  Key k = table_key("gear2", gear_keys, {}, "the second gear, or a rack if `form` = \"rack\"");
  k.tables.push_back(rack_bar_keys);
  k.also = {"wheel"};
  return k;
}

Key search_key() {
  Key k = table_key("search", search_keys, {}, "inputs of a search for pairs or drives");
  k.tables.push_back(drive_search_keys);
  return k;
}

}  // namespace

const KeyTable& spec_keys() {
  static const KeyTable table{
      "spec",
      "One gear, a pair of gears, a drive or a search; lengths are in mm and angles in degrees, as "
      "the keys show",
      {Key::text("title", &SpecTables::title, "", "title of listings and of the report"),
       Key::word("units", {"mm", "inch"}, KeyPlace::unused(), "\"mm\"",
                 "unit of the lengths in the spec and in the results; see Units"),
       table_key("drawing", drawing_keys, &SpecTables::drawing,
                 "the title block of the report and of drawings"),
       table_key("gear1", gear_keys, {}, "the first gear; in an internal pair, the pinion")
           .with_also({"gear", "pinion"}),
       gear_2_key(),
       table_key("pair", pair_keys,
                 KeyPlace::within<SpecTables>([](auto& tables) -> auto& { return tables.pair; }),
                 "mounting of the two gears"),
       table_key("errors", error_keys, &SpecTables::errors, "errors of mounting and of the teeth"),
       table_key("contact", contact_keys, &SpecTables::contact,
                 "settings of the contact computation"),
       table_key("compensate", compensate_keys, &SpecTables::compensate,
                 "corrections that the verb `compensate` can make"),
       table_key("scatter", scatter_keys, {}, "tolerances and options of the verb `scatter`"),
       table_key("load", load_keys, &SpecTables::load,
                 "torques and resolution for the verb `load`"),
       table_key("rating", rating_keys, &SpecTables::rating,
                 "load, life, accuracy and mounting for the verb `rate`"),
       table_key("fit", fit_keys, &SpecTables::fit, "settings of the verb `fit`"), search_key(),
       table_key("planetary", planetary_keys, {}, "a planetary set, for the verb `drive`"),
       stage_key(),
       table_key("drive", drive_keys, {}, "a drive as a graph, for the verb `drive`")}};
  return table;
}

std::vector<const KeyTable*> all_key_tables() {
  std::vector<const KeyTable*> list{&spec_keys()};
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (const Key& key : list[i]->keys) {
      for (const auto table : key.tables) {
        add_once(list, &table());
      }
    }
  }
  return list;
}

bool is_spec_key(std::string_view path) {
  const auto last = [](std::string_view p) {
    p = p.substr(p.rfind('.') + 1);  // npos + 1 is 0
    return p.substr(0, p.find('['));
  };
  static const std::set<std::string_view> all = [&] {
    std::set<std::string_view> names;
    for (const KeyTable* table : all_key_tables())
      for (const Key& key : table->keys) {
        names.insert(key.key);
        for (const std::string_view word : key.words) names.insert(last(word));
      }
    return names;
  }();
  return all.contains(last(path));
}

}  // namespace gearwright
