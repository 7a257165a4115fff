// The asserts of toml++ are switched off, because they fail on some broken input (see
// spec_text.cpp).
#ifndef NDEBUG
#define NDEBUG
#endif
#include "gearwright/spec/spec_text.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// Sets the value at the path in the tree and makes missing tables. If the value is null, removes
// the key. Returns false if a part of the path is not a table.
bool set_in(Json& tree, const std::vector<std::string>& parts, const Json& value) {
  Json* node = &tree;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    if (!node->contains(parts[i])) {
      if (value.is_null()) return true;
      (*node)[parts[i]] = Json::object();
    }
    node = &(*node)[parts[i]];
    if (!node->is_object()) return false;
  }
  if (value.is_null()) {
    node->erase(parts.back());
  } else {
    (*node)[parts.back()] = value;
  }
  return true;
}

bool same(const Json& a, const Json& b) {  // ignores the order of members
  return nlohmann::json(a) == nlohmann::json(b);
}

bool has_null(const Json& value) {
  if (!value.is_structured()) return value.is_null();
  return std::any_of(value.begin(), value.end(), has_null);
}

class Editor {
 public:
  explicit Editor(std::string_view text) : text_(text), root_(toml::parse(text)) {
    for (std::size_t i = 0; i <= text.size(); ++i)
      if (i == 0 || text[i - 1] == '\n') lines_.push_back(i);
  }

  std::string text() && { return std::move(text_); }

  void set(const std::vector<std::string>& parts, const std::string& value) {
    const auto [table, depth] = deepest(parts);
    if (depth + 1 == parts.size()) {
      if (const toml::node* node = table->get(parts.back())) {
        const auto [from, to] = range(node->source());
        text_.replace(from, to - from, value);
      } else {
        insert(*table, parts.back() + " = " + value, depth == 0);
      }
      return;
    }
    if (table->is_inline() && depth > 0) {
      std::string nested = parts.back() + " = " + value;
      for (std::size_t i = parts.size() - 1; i-- > depth;) {
        std::string outer = parts[i];
        outer += " = { " + nested + " }";
        nested = std::move(outer);
      }
      insert(*table, nested, false);
      return;
    }
    std::string name;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) name += (i == 0 ? "" : ".") + parts[i];
    if (!text_.empty() && text_.back() != '\n') text_ += '\n';
    text_ += (text_.empty() ? "[" : "\n[") + name + "]\n" + parts.back() + " = " + value + "\n";
  }

  void take_out(const std::vector<std::string>& parts) {
    const auto [table, depth] = deepest(parts);
    if (depth + 1 != parts.size()) return;
    const toml::node* node = table->get(parts.back());
    if (!node) return;
    const toml::table* inner = node->as_table();
    if (inner && !inner->is_inline()) {
      take_out_table(*inner);
      return;
    }
    const toml::key* key = nullptr;
    for (const auto& [k, v] : *table)
      if (&v == node) key = &k;
    std::size_t from = offset(key->source().begin);
    std::size_t to = range(node->source()).second;
    if (table->is_inline() && depth > 0) {
      // Also removes one comma, so that the list of elements stays valid. It is the comma after the
      // element or, for the last element, the comma before it.
      const std::size_t next = text_.find_first_not_of(" \t", to);
      if (next != std::string::npos && text_[next] == ',') {
        to = text_.find_first_not_of(" \t", next + 1);
      } else if (const std::size_t before = text_.find_last_not_of(" \t", from - 1);
                 text_[before] == ',') {
        from = before;
      }
    } else {
      from = lines_[line_of(from)];
      to = text_.find('\n', to);
      to = to == std::string::npos ? text_.size() : to + 1;
    }
    text_.erase(from, to - from);
  }

 private:
  struct Found {
    const toml::table* table;
    std::size_t depth;  // number of parts of the path that lead to the table
  };

  Found deepest(const std::vector<std::string>& parts) const {
    Found found{&root_, 0};
    while (found.depth + 1 < parts.size()) {
      const toml::node* node = found.table->get(parts[found.depth]);
      if (!node) break;
      found = {node->as_table(), found.depth + 1};
    }
    return found;
  }

  // Columns count characters, not bytes.
  std::size_t offset(const toml::source_position& at) const {
    std::size_t i = lines_[std::min<std::size_t>(at.line, lines_.size()) - 1];
    for (toml::source_index column = 1; column < at.column && i < text_.size(); ++column) {
      ++i;
      while (i < text_.size() && !begins_character(text_[i])) ++i;
    }
    return i;
  }
  std::pair<std::size_t, std::size_t> range(const toml::source_region& region) const {
    return {offset(region.begin), offset(region.end)};
  }
  std::size_t line_of(std::size_t at) const {
    return static_cast<std::size_t>(std::upper_bound(lines_.begin(), lines_.end(), at) -
                                    lines_.begin()) -
           1;
  }

  // Inserts "key = value" at the end of a table.
  void insert(const toml::table& table, const std::string& line, bool root) {
    if (table.is_inline() && !root) {
      const std::size_t brace = range(table.source()).second - 1;
      std::size_t last = text_.find_last_not_of(" \t", brace - 1);
      const bool empty = text_[last] == '{';
      text_.replace(last + 1, brace - last - 1, (empty ? " " : ", ") + line + " ");
      return;
    }
    std::size_t at = 0;
    bool after = !root;
    if (!root) at = offset(table.source().begin);
    for (const auto& [key, node] : table) {
      const toml::table* inner = node.as_table();
      if (inner && !inner->is_inline()) continue;
      at = std::max(at, range(node.source()).second);
      after = true;
    }
    if (after) {
      at = text_.find('\n', at);
      if (at == std::string::npos) {
        text_ += '\n';
        at = text_.size();
      } else {
        ++at;
      }
    }
    text_.insert(at, line + "\n");
  }

  // Collects the lines of the headings of all tables in `table`, including those in inner tables.
  void headers(const toml::table& table, std::vector<std::size_t>& lines) const {
    for (const auto& [key, node] : table) {
      const toml::table* inner = node.as_table();
      if (!inner || inner->is_inline()) continue;
      lines.push_back(line_of(offset(inner->source().begin)));
      headers(*inner, lines);
    }
  }

  void take_out_table(const toml::table& table) {
    std::vector<std::size_t> all, ours{line_of(offset(table.source().begin))};
    headers(root_, all);
    headers(table, ours);
    std::sort(all.begin(), all.end());
    std::sort(ours.rbegin(), ours.rend());
    for (const std::size_t line : ours) {
      const auto next = std::upper_bound(all.begin(), all.end(), line);
      const std::size_t from = lines_[line];
      const std::size_t to = next == all.end() ? text_.size() : lines_[*next];
      text_.erase(from, to - from);
    }
  }

  std::string text_;
  toml::table root_;
  std::vector<std::size_t> lines_;  // beginning of each line
};

// The path `parts` may lead into a material that is only a name, for example material = "16MnCr5".
// In this case, returns the path of the material and a table that contains this name.
std::optional<std::pair<std::string, Json>> named_material_of(
    const Json& tree, const std::vector<std::string>& parts) {
  const Json* node = &tree;
  std::string path;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const auto next = node->is_object() ? node->find(parts[i]) : node->end();
    if (!node->is_object() || next == node->end()) return std::nullopt;
    path += (path.empty() ? "" : ".") + parts[i];
    if (next->is_string() && parts[i] == "material")
      return std::pair(path, Json{{material_keys().shorthand, *next}});
    node = &*next;
  }
  return std::nullopt;
}

}  // namespace

Result<std::string> with_key(std::string_view toml, std::string_view path, std::string_view value) {
  const auto names = split(path, '.');
  const std::vector<std::string> parts(names.begin(), names.end());
  const bool blank = toml.find_first_not_of(" \t\r\n") == std::string_view::npos;
  const auto before = blank ? Result<Json>(Json::object()) : parse_spec(toml, SpecFormat::toml);
  if (!before) return before.error();
  Json wished;
  try {
    if (json_depth(value) > 32) return Error{std::string(path), "", "has too many nested levels"};
    wished = parse_json(value);
  } catch (const nlohmann::json::exception&) {
    return Error{std::string(path), std::string(value), "is not a JSON value"};
  }
  if (wished.is_structured() && has_null(wished))
    return Error{std::string(path), "null", "is not a value of a spec; leave out the key"};
  if (const auto named = named_material_of(*before, parts)) {
    if (wished.is_null() && parts.back() != material_keys().shorthand) return std::string(toml);
    const auto whole = with_key(toml, named->first, json_text(named->second));
    return whole ? with_key(*whole, path, value) : whole;
  }
  Json wanted = *before;
  if (!set_in(wanted, parts, wished))
    return Error{std::string(path), "",
                 "cannot be set, because a part of this path is a value and not a table"};
  if (same(wanted, *before)) return std::string(toml);
  Editor editor(toml);
  if (wished.is_null()) {
    editor.take_out(parts);
  } else {
    editor.set(parts, toml_value(wished));
  }
  std::string text = std::move(editor).text();
  // Some rare forms, such as a table with a dotted name, cannot be edited in place. For such a
  // form, the whole text is written anew, without the comments.
  const bool none = text.find_first_not_of(" \t\r\n") == std::string::npos;
  const auto after = none ? Result<Json>(Json::object()) : parse_spec(text, SpecFormat::toml);
  if (!after || !same(*after, wanted)) return toml_text(wanted);
  return text;
}

}  // namespace gearwright
