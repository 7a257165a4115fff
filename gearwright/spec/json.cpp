#include "gearwright/spec/json.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/contract.hpp"

namespace gearwright {

int json_depth(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '{' || c == '[')) {
      deepest = std::max(deepest, ++depth);
    } else if (!quoted && (c == '}' || c == ']')) {
      --depth;
    }
  }
  return deepest;
}

Json parse_json(std::string_view text) { return Json::parse(text); }

std::string json_text(const Json& tree, int indent) {
  return tree.dump(indent, ' ', false, Json::error_handler_t::replace);
}

namespace {

bool bare(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

// Returns the text in quotes. The escapes of JSON are also valid in TOML, except for the surrogate
// pairs of characters beyond U+FFFF. Therefore, only control characters, quotation marks and
// backslashes are escaped. DEL is also escaped, because TOML does not allow it.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
    out += c == '\x7F' ? std::string("\\u007f") : std::string(1, c);
  return out;
}

std::string key_text(const std::string& key) { return bare(key) ? key : quoted(key); }

}  // namespace

std::string toml_value(const Json& v) {
  if (v.is_number_float()) {
    const double x = v.get<double>();
    GW_EXPECTS(std::isfinite(x));
    const std::string text = fmt::format("{}", x);
    // A float without a point or exponent gets a point, because TOML would read it as an integer.
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  if (v.is_string()) return quoted(v.get<std::string>());
  if (v.is_array()) {
    std::string text;
    for (const Json& item : v) text += (text.empty() ? "" : ", ") + toml_value(item);
    return "[" + text + "]";
  }
  if (v.is_object()) {
    std::string text;
    for (const auto& [key, item] : v.items())
      text += (text.empty() ? "" : ", ") + key_text(key) + " = " + toml_value(item);
    return "{ " + text + " }";
  }
  GW_EXPECTS(v.is_boolean() || v.is_number_integer());
  return json_text(v);
}

namespace {

bool tables(const Json& v) {
  return v.is_array() && !v.empty() &&
         std::all_of(v.begin(), v.end(), [](const Json& item) { return item.is_object(); });
}

// Writes a table. Plain values are written first, because a value after the heading of an inner
// table would belong to the inner table.
void write_table(const Json& table, const std::string& path, std::string& out) {
  for (const auto& [key, value] : table.items()) {
    if (!value.is_object() && !tables(value))
      out += key_text(key) + " = " + toml_value(value) + "\n";
  }
  for (const auto& [key, value] : table.items()) {
    if (!value.is_object() && !tables(value)) continue;
    const std::string name = path.empty() ? key_text(key) : path + "." + key_text(key);
    const std::string heading = value.is_object() ? "[" + name + "]" : "[[" + name + "]]";
    for (const Json& item : value.is_object() ? Json::array({value}) : value) {
      out += (out.empty() ? "" : "\n") + heading + "\n";
      write_table(item, name, out);
    }
  }
}

}  // namespace

std::string toml_text(const Json& tree) {
  GW_EXPECTS(tree.is_object());
  std::string out;
  write_table(tree, "", out);
  return out;
}

std::string toml_comment(const std::vector<std::string>& sentences) {
  constexpr std::size_t kWidth = 78;  // 80 columns of a terminal, minus "# "
  std::string text, line;
  for (const std::string& sentence : sentences) {
    for (std::size_t at = 0; at < sentence.size();) {
      const std::size_t end = std::min(sentence.find_first_of(" \n", at), sentence.size());
      const std::string word = sentence.substr(at, end - at);
      if (!line.empty() && line.size() + 1 + word.size() > kWidth) {
        text += "# " + line + "\n";
        line.clear();
      }
      line += (line.empty() ? "" : " ") + word;
      at = end + 1;
    }
    text += "# " + line + "\n";
    line.clear();
  }
  return text;
}

}  // namespace gearwright
