// Finds positions in a JSON text.
#include <algorithm>

#include "gearwright/base/printable.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// Moves through a text. The text is valid JSON up to the wanted position, so the syntax is not
// checked.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  char here() {
    blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  /// Moves past the bracket, comma or colon at this position.
  void step() { ++at_; }
  /// Moves past a string and returns the text between the quotes, with escapes unchanged.
  std::string_view quoted() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    const std::string_view inside = text_.substr(begin, at_ - begin);
    step();
    return inside;
  }
  void skip() {
    int deep = 0;
    do {
      const char c = here();
      if (c == '"') {
        quoted();
        continue;
      }
      if (c == '{' || c == '[') ++deep;
      if (c == '}' || c == ']') --deep;
      if (deep == 0 && c != '}' && c != ']') {  // skips a number or a word
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
        return;
      }
      step();
    } while (deep > 0 && at_ < text_.size());
  }

 private:
  void blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Moves to the value of the member that is named at the beginning of `path`, and removes this name
// from `path`. Sets `found` to the position of the key. If the path ends with this name and the
// name occurs twice, sets `found` to the second position. Returns false if there is no such member.
bool enter(Walk& walk, std::string_view& path, std::optional<std::size_t>& found) {
  walk.step();  // skips the brace
  bool once = false;
  while (walk.here() == '"') {
    const std::size_t at = walk.at();
    const std::string_view key = walk.quoted();
    if (walk.here() == ':') walk.step();
    walk.here();
    const bool whole =
        path.starts_with(key) &&
        (path.size() == key.size() || path[key.size()] == '.' || path[key.size()] == '[');
    if (whole) {
      found = at;
      if (path.size() > key.size()) {
        path.remove_prefix(key.size());
        return true;
      }
      if (once) break;
      once = true;
    }
    walk.skip();
    if (walk.here() == ',') walk.step();
    walk.here();
  }
  if (once) path = {};
  return once;
}

// Moves to an element of a list. `path` begins with the number of the element, for example "[2]",
// which is removed. Sets `found` to the position of the element. Returns false if there is no such
// element.
bool enter_list(Walk& walk, std::string_view& path, std::optional<std::size_t>& found) {
  const int wanted = std::atoi(path.data() + 1);
  walk.step();
  for (int i = 1; walk.here() != ']' && walk.here() != '\0'; ++i) {
    if (i == wanted) {
      found = walk.at();
      path.remove_prefix(std::min(path.find(']'), path.size() - 1) + 1);
      return true;
    }
    walk.skip();
    if (walk.here() == ',') walk.step();
  }
  return false;
}

}  // namespace

TextPlace place_at(std::string_view text, std::size_t at) {
  TextPlace place;
  for (const char c : text.substr(0, at)) {
    if (c == '\n') {
      ++place.line;
      place.column = 1;
    } else if (begins_character(c)) {
      ++place.column;
    }
  }
  return place;
}

std::optional<TextPlace> json_place(std::string_view text, std::string_view path) {
  Walk walk(text);
  std::optional<std::size_t> found;
  while (walk.here() == '{' && enter(walk, path, found)) {
    while (path.starts_with('[') && walk.here() == '[' && enter_list(walk, path, found)) {
    }
    if (!path.starts_with('.')) break;
    path.remove_prefix(1);
  }
  if (!found) return std::nullopt;
  return place_at(text, *found);
}

}  // namespace gearwright
