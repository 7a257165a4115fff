// Reads one table of a spec by the catalogue: values within their ranges go to the places of their
// keys, sub-tables and lists of tables into their structs. An error names the key.
//
// A key that the catalogue does not have, or one of it that was not read, is a mistake of this
// program and breaks a contract: table and reader cannot drift apart.
//
// Internal to spec/: throws SpecError, which read_spec turns into a Result.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gearwright/base/printable.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct SpecError {
  Error error;
  std::vector<Error> missing{};  ///< its parts, where that is what it is about
};

class TableReader {
 public:
  /// `path` is the table's dotted name, empty for the file itself.
  TableReader(const KeyTable& keys, const Json& node, std::string path);

  /// Every key that has a place goes there, tables after plain values; absent ones leave what is
  /// there.
  void read(KeyTarget input);
  /// One key, which has a place.
  void read(const Key& key, KeyTarget input);
  /// All of it: read(), finish(), and the rule of the table.
  void read_whole(KeyTarget input);

  bool has(const std::string& key);
  std::optional<double> number(const std::string& key);  ///< finite, within its range
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> word(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  /// Of a key with a list: as many finite numbers as it may have, whose range is not checked.
  std::optional<std::vector<double>> raw_numbers(const std::string& key);
  /// The same within their range, in their order, whole where they must be.
  std::optional<std::vector<double>> numbers(const std::string& key);
  const Json* table(const std::string& key);  ///< a sub-table, or null
  const Json* any(const std::string& key);    ///< a value of whatever type, or null
  /// In the unit of `key`, by it and its aliases, all of which must agree; `what`: "module".
  std::optional<double> one_of(const std::string& key, const std::string& what, double cos_beta);

  /// The key's range, of one of its numbers.
  void check(const std::string& key, double value) const;
  /// Fails if a required key is absent; a misspelt one is named first.
  void require_all() const;
  /// The key and its aliases are missing; finish() fails.
  void lacks_one_of(const std::string& key, const std::string& what);
  /// A key that has no place here: refused in plain words when present.
  void refuse(const std::string& key, const std::string& why);
  /// Fails because of a key that the table does not have, naming the nearest one; of one that is
  /// missing, by itself or beside another; of two that exclude each other.
  void finish() const;
  void refuse_unknown() const;  ///< the first of these alone

  const KeyTable& keys() const { return keys_; }
  const std::string& name() const { return path_; }  ///< of the table
  std::string name(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[noreturn]] void fail(const std::string& key, const std::string& why) const;
  /// The key is missing; `rest` continues that sentence.
  [[noreturn]] void fail_absent(const std::string& key, std::string_view rest) const;

  bool given(std::string_view key) const;

 private:
  const Key& entry(const std::string& key) const;
  const Json* find(const std::string& key);
  std::optional<KeyValue> value(const Key& key);
  std::optional<int> whole(const std::string& key);
  std::optional<std::vector<int>> words(const Key& key);
  void read_tables(const Key& key, KeyTarget input);
  /// Whatever the table must have and lacks.
  [[noreturn]] void fail_missing() const;

  const KeyTable& keys_;
  const Json& node_;
  std::string path_;
  std::set<std::string, std::less<>> used_;
  std::vector<Error> lacking_;
};

template <class T>
T read_table(const KeyTable& keys, const Json& node, const std::string& path) {
  T input{};
  TableReader(keys, node, path).read_whole(input);
  return input;
}

constexpr double kSameInput = 1e-9;  ///< two ways to give one number may differ by rounding

bool has_any(const Json& table, const std::vector<std::string>& keys);

/// A value as a person wrote it, cut to a length that fits a sentence.
std::string shown(const Json& value);

}  // namespace gearwright
