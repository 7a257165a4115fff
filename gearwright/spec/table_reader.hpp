// Reads one table of a spec: typed values, complaints that name the key, unknown keys at the end.
//
// Internal to spec/: throws SpecError, which read_spec turns into a Result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct SpecError {
  Error error;
};

class TableReader {
 public:
  /// `path` is the table's dotted name, empty for the file itself.
  TableReader(const Json& node, std::string path);

  bool has(const std::string& key);
  std::optional<double> number(const std::string& key);    ///< finite
  std::optional<double> positive(const std::string& key);  ///< finite and > 0
  std::optional<int> integer(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<std::string> one_of(const std::string& key,
                                    const std::vector<std::string>& allowed);
  const Json* table(const std::string& key);  ///< a sub-table, or null
  const Json* any(const std::string& key);    ///< a value of whatever type, or null

  /// A key of the interface that this version cannot honour: refused in plain words when present.
  void refuse(const std::string& key, const std::string& why);
  /// Complains about the first key that nobody asked for, naming the nearest known one.
  void finish() const;

  std::string name(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[noreturn]] void fail(const std::string& key, const std::string& why) const;

 private:
  const Json* find(const std::string& key);
  const Json& node_;
  std::string path_;
  std::vector<std::string> known_;
};

/// Text that may stand in a sentence: control characters escaped, cut at a character after `most`
/// bytes.
std::string printable(const std::string& text, std::size_t most);

/// The word of `known` with the least edit distance to `word`; empty when `known` is.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace gearwright
