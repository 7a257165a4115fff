#include "gearwright/catalogue/spelling.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <vector>

#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright {

namespace {

struct Spelling {
  std::string path;
  const Key* key;
};

std::string joined(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : std::string(path) + "." + std::string(key);
}

void find_keys(const KeyTable& table, const std::string& path, std::string_view member,
               std::vector<Spelling>& found) {
  for (const Key& key : table.keys) {
    for (const std::string& name : key.members()) {
      const std::string here = joined(path, key.key);
      if (member == name) found.push_back({here, &key});
      if (key.tables.empty() || !member.starts_with(name)) continue;
      std::string_view rest = member.substr(name.size());
      std::string index;  // index of an element in a list, as in "arcs[2]"
      if (rest.starts_with('[')) {
        const std::size_t end = std::min(rest.find(']'), rest.size() - 1) + 1;
        index = rest.substr(0, end);
        rest.remove_prefix(end);
        if (rest.empty()) found.push_back({here + index, &key});
      }
      if (!rest.starts_with('.')) continue;
      for (const auto part : key.tables) find_keys(part(), here + index, rest.substr(1), found);
    }
  }
  // A member of one flank may also be set by the key for both flanks.
  if (&table != &modification_keys()) return;
  for (const std::string_view side : kFlankMembers)
    if (member.starts_with(side)) find_keys(table, path, member.substr(side.size()), found);
}

// Returns the first entry of `found` whose key the spec gives. If the spec gives none of these
// keys, returns the first entry whose key is in the documents.
std::optional<Spelling> chosen(const std::vector<Spelling>& found, const GivenKeys& given) {
  if (found.empty()) return std::nullopt;
  for (const Spelling& s : found)
    if (given.contains(s.path)) return s;
  for (const Spelling& s : found)
    if (s.key->in_documents) return s;
  return found.front();
}

std::optional<Spelling> spelling_of(std::string_view member, const GivenKeys& given) {
  std::vector<Spelling> found;
  find_keys(spec_keys(), "", member, found);
  return chosen(found, given);
}

// Returns the key that sets the member without conversion, such as the module. The result exists
// only if the spec gives a key whose value is converted, such as a diametral pitch.
std::optional<Spelling> own_spelling(std::string_view member, const Spelling& s) {
  const auto plain = spelling_of(member, {});
  if (!plain || !plain->key->in_documents || !s.key->in_documents || plain->path == s.path)
    return std::nullopt;
  return plain;
}

// Returns the value as it is written in the file. A word is in quotes.
std::string spelled_value(const std::string& value, const Key& key) {
  if (key.kind == KeyKind::text && !value.empty()) return "\"" + value + "\"";
  const bool word = key.kind != KeyKind::number && key.kind != KeyKind::whole && !value.empty() &&
                    value != "true" && value != "false" &&
                    std::isalpha(static_cast<unsigned char>(value.front()));
  return word ? "\"" + value + "\"" : value;
}

// Returns `path` without the leading tables that `path` and `around` have in common.
std::string_view beside(std::string_view path, std::string_view around) {
  const auto table_of = [](std::string_view text) { return text.substr(0, text.find('.')); };
  while (path.find('.') != std::string_view::npos && table_of(path) == table_of(around)) {
    path.remove_prefix(table_of(path).size() + 1);
    around.remove_prefix(std::min(table_of(around).size() + 1, around.size()));
  }
  return path;
}

// Returns the key of a member that occurs in a sentence about `owner`. If several tables have the
// member, the table nearest to `owner` is used.
std::string named(std::string_view member, const GivenKeys& given, std::string_view owner) {
  for (std::string_view around = owner; !around.empty();) {
    if (const auto s = spelling_of(joined(around, member), given))
      return std::string(beside(s->path, around));
    const std::size_t dot = around.rfind('.');
    around = dot == std::string_view::npos ? std::string_view() : around.substr(0, dot);
  }
  const auto s = spelling_of(member, given);
  if (!s) return std::string(member);
  const bool table = s->key->kind == KeyKind::table && s->key->words.empty();
  return table ? "[" + s->path + "]" : s->path;
}

// Returns the sentence with keys in place of the members in backticks.
std::string in_keys(std::string_view sentence, const GivenKeys& given, std::string_view owner) {
  std::string text;
  while (!sentence.empty()) {
    const std::size_t begin = sentence.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : sentence.find('`', begin + 1);
    if (end == std::string_view::npos) break;
    text += sentence.substr(0, begin);
    text += named(sentence.substr(begin + 1, end - begin - 1), given, owner);
    sentence.remove_prefix(end + 1);
  }
  return text += sentence;
}

// Returns the error with keys in place of members. Its numbers are in the units of the catalogue.
Error with_keys(const Error& error, const GivenKeys& given) {
  const std::size_t dot = error.field.rfind('.');
  const std::string_view owner =
      dot == std::string::npos ? std::string_view() : std::string_view(error.field).substr(0, dot);
  Error worded{error.field, error.value, in_keys(error.rule, given, owner), error.kind};
  const auto s = spelling_of(error.field, given);
  if (!s) return worded;
  worded.field = s->path;
  worded.value = spelled_value(worded.value, *s->key);
  // If a key of a rack is not in the file, its value is a default, and the message states this.
  const bool of_rack = !given.empty() && s->path.find(".rack.") != std::string::npos;
  if (of_rack && !worded.value.empty() && !given.contains(s->path))
    worded.rule =
        "this key is not given, and its default does not match the other values: " + worded.rule;
  const auto own = own_spelling(error.field, *s);
  if (!own) return worded;
  Error made = worded;
  made.field = own->path.substr(own->path.rfind('.') + 1);
  return {s->path, "", "this value gives " + made.message(), error.kind};
}

}  // namespace

SpelledMember spelled_member(std::string_view owner, std::string_view member,
                             const std::string& value) {
  auto s = spelling_of(joined(owner, member), {});
  if (!s) s = spelling_of(member, {});
  if (!s) return {joined(owner, member), value};
  return {s->path, spelled_value(value, *s->key)};
}

std::string spelled(std::string_view sentence, const GivenKeys& given, std::string_view owner) {
  return sentence_in(given.units, in_keys(sentence, given, owner));
}

Error in_units_of(const GivenKeys& given, const Error& error) {
  if (given.units == UnitSystem::mm) return error;
  // If the value of a modification is a text, the text is the name of a file with numbers in mm.
  const Key* key = modification_keys().find(error.field.substr(error.field.rfind('.') + 1));
  if (key && key->kind == KeyKind::text) return error;
  const KeyUnit* unit = metric_unit(error.field);
  Error made{key_in(given.units, error.field), error.value,
             sentence_in(given.units, error.rule, unit), error.kind};
  if (!unit || error.value.empty()) return made;
  char* end = nullptr;
  const double value = std::strtod(error.value.c_str(), &end);
  if (const auto it = given.written.find(error.field); it != given.written.end()) {
    made.value = it->second;
  } else if (*end == '\0') {
    made.value = format_number(unit->to_inch(value));
  }
  return made;
}

Error spelled(const Error& error, const GivenKeys& given) {
  return in_units_of(given, with_keys(error, given));
}

}  // namespace gearwright
