// For some broken input ("[" and a newline), toml++ 3.3 fails an assert instead of returning a
// parse error. Without asserts the same code returns a parse error, so this file is compiled
// without asserts in every build.
#ifndef NDEBUG
#define NDEBUG
#endif
#include "gearwright/spec/spec_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/rexs_file.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/spec/text_depth.hpp"

namespace gearwright {

namespace {

constexpr int kDeepest = 32;  // greatest depth of nesting; a spec has fewer than ten levels
constexpr std::size_t kLongestPath = 120;  // bytes of the path of a key in a message

Error syntax_error(const std::string& what) { return {"", "", "the spec cannot be read: " + what}; }

Error too_deep() {
  return syntax_error(fmt::format("the spec has tables nested more than {} levels deep", kDeepest));
}

Error number_too_large(const std::string& key, const std::string& number) {
  return {key, printable(number, 60),
          fmt::format("the number is too large; every number must lie between -{0} and {0}",
                      kMaxInput)};
}

// Appends a member to an object. A check for duplicates would take quadratic time. It is not
// needed, because both parsers reject a key that occurs twice.
Json& put(Json& object, std::string key, Json value) {
  return object.get_ref<Json::object_t&>().emplace_back(std::move(key), std::move(value)).second;
}

Json to_json(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    Json result = Json::object();
    for (const auto& [key, value] : *table) put(result, std::string(key.str()), to_json(value));
    return result;
  }
  if (const auto* array = node.as_array()) {
    Json result = Json::array();
    for (const toml::node& value : *array) result.push_back(to_json(value));
    return result;
  }
  if (const auto* v = node.as_integer()) return v->get();
  if (const auto* v = node.as_floating_point()) return v->get();
  if (const auto* v = node.as_boolean()) return v->get();
  if (const auto* v = node.as_string()) return v->get();
  // A date or a time is converted to a text, exactly as it is written in the spec.
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

// Builds the tree of a JSON text with bounded nesting and unique keys, as in TOML.
class TreeBuilder final : public nlohmann::json_sax<Json> {
 public:
  Json tree;
  /// Position of the syntax error that was thrown, in bytes.
  std::optional<std::size_t> error_at;

  bool null() override { return add(nullptr); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(std::int64_t v) override { return add(v); }
  bool number_unsigned(std::uint64_t v) override { return add(v); }
  bool number_float(double v, const std::string&) override { return add(v); }
  bool string(std::string& v) override { return add(std::move(v)); }
  bool binary(nlohmann::json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    if (!open_.back().keys.insert(name).second)
      throw SpecError{{printable(object_path() + name, kLongestPath), "",
                       "occurs twice in one table; leave out one of the two"}};
    open_.back().key = name;
    return true;
  }
  bool parse_error(std::size_t read, const std::string& token,
                   const nlohmann::json::exception& error) override {
    constexpr int kOverflow = 406;  // json.exception.out_of_range.406
    if (error.id == kOverflow) throw SpecError{number_too_large(value_path(), token)};
    error_at = read - std::min<std::size_t>(read, 1);  // `read` includes the rejected character
    // Messages of the library begin with "[json.exception.parse_error.101] ".
    const std::string what = error.what();
    const std::size_t at = what.find("] ");
    throw SpecError{
        syntax_error(printable(at == std::string::npos ? what : what.substr(at + 2), 200))};
  }

 private:
  struct Open {
    Json* node;
    std::set<std::string> keys{};
    std::string key{};
  };

  // Returns the path of the value that is being read, "gear1.teeth" or "stage[2].teeth[1]".
  std::string value_path() const {
    const Open& o = open_.back();
    return printable(
        object_path() + (o.node->is_array() ? fmt::format("[{}]", o.node->size() + 1) : o.key),
        kLongestPath);
  }

  // Returns the path of the innermost open object, with a point at its end, "gear1.rack.".
  std::string object_path() const {
    std::string text;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Open& o = open_[i];
      text += o.node->is_object() ? o.key : fmt::format("[{}]", o.node->size());
      if (open_[i + 1].node->is_object()) text += '.';
    }
    return text;
  }
  Json* place(Json value) {
    if (open_.empty()) {
      tree = std::move(value);
      return &tree;
    }
    Open& o = open_.back();
    if (o.node->is_object()) return &put(*o.node, o.key, std::move(value));
    o.node->push_back(std::move(value));
    return &o.node->back();
  }
  bool add(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json value) {
    Json* node = place(std::move(value));
    open_.push_back({node});
    if (open_.size() > static_cast<std::size_t>(kDeepest)) throw SpecError{too_deep()};
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<Open> open_;
};

// Returns the first line of a TOML text that is nested too deeply for the parser, or none. A line of
// numbers contains many dots, so the limit is greater than kDeepest.
std::optional<int> deep_line(std::string_view text) { return deep_toml_line(text, 8 * kDeepest); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Two runs of digits in a line. The first run ends immediately before the position `before`, and
// the second run begins at the position `after`. Each run may be empty.
struct Digits {
  std::string_view before, after;
};
Digits digits_at(std::string_view line, std::size_t before, std::size_t after) {
  std::size_t begin = before, end = after;
  while (begin > 0 && is_digit(line[begin - 1])) --begin;
  while (end < line.size() && is_digit(line[end])) ++end;
  return {line.substr(begin, before - begin), line.substr(after, end - after)};
}

std::string_view line_at(std::string_view text, unsigned number) {
  for (unsigned line = 1; line < number; ++line) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find_first_of("\r\n"));
}

// Returns the path of the key whose value the parser reads at `at`, which are the names in the
// nearest header above, in the line and in its open inline tables.
std::string path_at(std::string_view text, const toml::source_position& at) {
  std::string path;
  std::map<std::string, int, std::less<>> lists;  // number of headers [[name]] so far
  std::string_view rest = text;
  for (unsigned n = 1; n <= at.line; ++n) {
    const std::string_view header = trimmed(rest.substr(0, rest.find_first_of("\r\n")));
    rest.remove_prefix(std::min(rest.size(), rest.find('\n')));
    if (!rest.empty()) rest.remove_prefix(1);
    if (!header.starts_with('[')) continue;
    path = trimmed(header.substr(0, header.find(']')), " \t[");
    if (header.starts_with("[[")) path += fmt::format("[{}]", ++lists[path]);
  }
  std::vector<std::string> names{""};
  std::string_view line = line_at(text, at.line).substr(0, at.column);
  for (std::size_t begin = 0, i = 0; i < line.size(); ++i) {
    if (line[i] == '=') names.back() = trimmed(line.substr(begin, i - begin), " \t\"'");
    if (line[i] == '{') names.emplace_back();
    if (line[i] == '}' && names.size() > 1) names.pop_back();
    if (line[i] == '=' || line[i] == '{' || line[i] == ',') begin = i + 1;
  }
  for (const std::string& name : names)
    if (!name.empty()) path += (path.empty() ? "" : ".") + name;
  return path;
}

// Returns the error if the parser rejected a number because it is too large. The description then
// contains the number in quotes.
std::optional<Error> large_number(std::string_view text, const toml::parse_error& error) {
  const std::string_view what = error.description();
  const std::size_t begin = what.find('\'');
  const std::size_t end = begin == what.npos ? begin : what.find('\'', begin + 1);
  if (end == what.npos) return std::nullopt;
  const std::string number(what.substr(begin + 1, end - begin - 1));
  char* rest = nullptr;
  const double value = std::strtod(number.c_str(), &rest);
  const bool of_number = !number.empty() && rest == number.c_str() + number.size();
  if (!of_number || !(std::abs(value) > kMaxInput)) return std::nullopt;
  return number_too_large(path_at(text, error.source().begin), number);
}

// Returns a hint if the line of the parser error contains a usual slip: "2,5", "1/2", ".5", "2.5
// mm", text without quotes, or "[gear 1]". `at_comma` is true if the parser rejected a comma.
std::string slip_hint(std::string_view text, const toml::source_position& at, bool at_comma) {
  std::string_view line = line_at(text, at.line);
  line = line.substr(0, line.find('#'));
  if (text.find('\r') != text.npos && text.find('\n') == text.npos)
    return "; the lines end with CR only; save the file with LF or CR LF at the ends of lines";
  // U+2212 and U+2013, which look like the minus sign of ASCII.
  if (line.find("\xE2\x88\x92") != line.npos || line.find("\xE2\x80\x93") != line.npos)
    return "; write the minus sign as -, the hyphen of the keyboard";
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (!(line[i] == '/' || (line[i] == ',' && at_comma)) || !is_digit(line[i - 1]) ||
        !is_digit(line[i + 1]))
      continue;
    const Digits two = digits_at(line, i, i + 1);
    if (line[i] == ',')
      return fmt::format("; use a point as the decimal mark, {}.{}", two.before, two.after);
    const double below = std::strtod(std::string(two.after).c_str(), nullptr);
    if (below > 0.0)
      return fmt::format("; write a fraction as a decimal number, {}",
                         std::strtod(std::string(two.before).c_str(), nullptr) / below);
  }
  if (line.starts_with("[") && line.find(' ') != line.npos)
    return "; the name of a table has no spaces, for example [gear1]";
  const std::size_t equals = line.find('=');
  if (equals == line.npos) return "";
  const std::size_t first = line.find_first_not_of(" \t[", equals + 1);
  if (first == line.npos) return "";
  const std::string_view value = line.substr(first);
  if (value.front() == '.' && value.size() > 1 && is_digit(value[1]))
    return fmt::format("; a number needs a digit before the point, 0{}",
                       value.substr(0, 1 + digits_at(value, 0, 1).after.size()));
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (letter(value.front()))
    return fmt::format("; a text needs quotes, \"{}\"",
                       value.substr(0, value.find_first_of(" \t,]")));
  const std::size_t unit = value.find_first_not_of("+-.0123456789 ");
  if (is_digit(value.front()) && unit != value.npos && (letter(value[unit]) || value[unit] == '"'))
    return "; give the number without a unit, because the key contains the unit";
  return "";
}

TextPlace place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

// Returns the key of `table` with which `path` begins. If `path` begins with several keys, returns
// the longest of them.
const toml::key* first_key(const toml::table& table, std::string_view path) {
  const toml::key* longest = nullptr;
  for (const auto& [key, value] : table) {
    const std::string_view name = key.str().empty() ? "\"\"" : key.str();
    const bool whole =
        path.starts_with(name) &&
        (path.size() == name.size() || path[name.size()] == '.' || path[name.size()] == '[');
    if (whole && (!longest || name.size() > longest->str().size())) longest = &key;
  }
  return longest;
}

std::optional<TextPlace> toml_place(const toml::table& root, std::string_view path) {
  std::optional<TextPlace> place;
  const toml::table* table = &root;
  while (table) {
    const toml::key* key = first_key(*table, path);
    if (!key) return place;
    place = place_of(key->source());
    const toml::node* node = table->get(key->str());
    path.remove_prefix(key->str().size());
    while (path.starts_with('[') && node->as_array()) {
      const std::size_t end = path.find(']');
      const auto index = static_cast<std::size_t>(std::atoi(path.data() + 1)) - 1;
      node = node->as_array()->get(index);
      if (!node || end == std::string_view::npos) return place;
      place = place_of(node->source());
      path.remove_prefix(end + 1);
    }
    if (!path.starts_with('.')) return place;
    path.remove_prefix(1);
    table = node->as_table();
  }
  return place;
}

// Returns the nesting depth of tables and lists. The count stops at `most`.
int depth_of(const Json& tree, int most) {
  int deepest = 0;
  if (!tree.is_structured() || most == 0) return 0;
  for (const Json& inner : tree) deepest = std::max(deepest, depth_of(inner, most - 1));
  return deepest + 1;
}

}  // namespace

std::optional<Error> check_tree(const Json& tree) {
  if (!tree.is_object())
    return syntax_error("a JSON spec must be an object, for example {\"gear1\": {...}}");
  if (depth_of(tree, kDeepest + 1) > kDeepest) return too_deep();
  return std::nullopt;
}

Result<Json> parse_spec(std::string_view text, SpecFormat format) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return syntax_error(
        "the spec is empty; at least [gear1] with teeth and normal_module_mm is needed");
  try {
    if (format == SpecFormat::json) {
      TreeBuilder builder;
      Json::sax_parse(text.begin(), text.end(), &builder);
      if (auto error = check_tree(builder.tree)) return *error;
      return std::move(builder.tree);
    }
    if (const auto line = deep_line(text))
      return syntax_error(
          fmt::format("line {} has tables nested more than {} levels deep", *line, kDeepest));
    return to_json(toml::parse(text));
  } catch (const SpecError& e) {
    return e.error;
  } catch (const toml::parse_error& e) {
    if (auto error = large_number(text, e)) return *error;
    const auto& at = e.source().begin;
    return syntax_error(
        fmt::format("line {}, column {}: {}{}", at.line, at.column, e.description(),
                    slip_hint(text, at, e.description().find("','") != std::string_view::npos)));
  }
}

std::optional<TextPlace> place_of_key(const SpecText& text, std::string_view key) {
  if (text.format == SpecFormat::json) {
    TreeBuilder builder;
    try {
      Json::sax_parse(text.text.begin(), text.text.end(), &builder);
    } catch (const SpecError&) {
      if (builder.error_at) return place_at(text.text, *builder.error_at);
    }
    return key.empty() ? std::nullopt : json_place(text.text, key);
  }
  if (const auto line = deep_line(text.text)) return TextPlace{*line, 1};
  try {
    const toml::table tables = toml::parse(text.text);
    return key.empty() ? std::nullopt : toml_place(tables, key);
  } catch (const toml::parse_error& e) {
    return place_of(e.source());
  }
}

Result<SpecText> read_spec_text(const std::filesystem::path& path) {
  const bool pipe = path == "-";
  const std::string name = pipe ? "standard input" : path.string();
  std::error_code error;
  if (!pipe && std::filesystem::is_directory(path, error))
    throw IoError("cannot read", path, EISDIR, "it is a folder");
  std::ifstream file;
  if (!pipe) file.open(path, std::ios::binary);
  if (!pipe && !file) throw IoError("cannot read", path, errno);
  std::istream& in = pipe ? std::cin : file;
  SpecText read{name, {}};
  std::array<char, 16384> part;
  while (in && read.text.size() <= kMaxSpec) {
    in.read(part.data(), part.size());
    read.text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw IoError("cannot read", name, errno);
  if (read.text.size() > kMaxSpec) {
    return syntax_error(
        fmt::format("{} has more than {} bytes, the limit for a spec", name, kMaxSpec));
  }
  // Editors on Windows offer UTF-16 as "Unicode". Such a file begins with the byte order mark
  // U+FEFF, or with a character of ASCII, one byte of which is 0.
  const bool half_empty = read.text.size() > 1 && (read.text[0] == '\0') != (read.text[1] == '\0');
  if (read.text.starts_with("\xFF\xFE") || read.text.starts_with("\xFE\xFF") || half_empty)
    return syntax_error(name + " is UTF-16 text; save it as UTF-8");
  const bool in_folder = !pipe && std::filesystem::is_regular_file(path, error);
  if (in_folder) read.folder = path.parent_path();
  if (is_rexs(path)) {
    auto made = spec_text_of_rexs(read.text);
    if (!made) return syntax_error(fmt::format("{}: {}", name, made.error().rule));
    read.text = std::move(made).take();
    return read;
  }
  const std::size_t mark = read.text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // U+FEFF in UTF-8
  const std::size_t first = read.text.find_first_not_of(" \t\r\n", mark);
  const bool brace = first != std::string::npos && read.text[first] == '{';
  if (in_folder ? path.extension() == ".json" : brace || path.extension() == ".json")
    read.format = SpecFormat::json;
  return read;
}

}  // namespace gearwright
