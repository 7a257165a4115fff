// Reads one table of a spec with the catalogue. Each value is checked against its range and stored
// in the struct member of its key (KeyPlace). Sub-tables and lists of tables are stored in structs.
// An error names the key.
//
// The reader violates a contract if it reads a key that is not in the catalogue, or if it leaves a
// key of the catalogue unread. This ensures that catalogue and reader agree.
//
// Internal to spec/. The functions throw SpecError, which read_spec converts to a Result.
#pragma once

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/printable.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct SpecError {
  Error error;
  std::vector<Error> missing{};  ///< if inputs are missing, one error for each of them
};

bool has_any(const Json& table, const std::vector<std::string>& keys);

class TableReader {
 public:
  /// `path` is the dotted name of the table. It is empty for the file itself.
  TableReader(const KeyTable& keys, const Json& node, std::string path);

  /// Reads every key that has a KeyPlace, plain values first and then tables. Absent keys leave the
  /// members unchanged.
  void read(KeyTarget input);
  /// Reads one key, which must have a KeyPlace.
  void read(const Key& key, KeyTarget input);
  /// Reads the whole table: read(), finish(), and the rule of the table.
  void read_whole(KeyTarget input);

  bool has(const std::string& key);
  std::optional<double> number(const std::string& key);  ///< finite, within its range
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> word(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  /// Returns the list of finite numbers of a key, or the numbers of a series that is given by its
  /// name. The length of the list, the range of the numbers and their order are checked.
  std::optional<std::vector<double>> numbers(const std::string& key);
  const Json* table(const std::string& key);  ///< a sub-table, or null
  /// Returns the tables of a list of tables with their paths, or none if the key is absent.
  std::vector<std::pair<std::string, const Json*>> tables(const std::string& key);
  const Json* any(const std::string& key);  ///< a value of any type, or null
  /// True if the table contains the key or one of its aliases.
  bool given_in_any_way(const std::string& key) const { return has_any(node_, keys_.ways(key)); }
  /// Sets the helix angle with which transverse values are converted. The default is 0.
  void use_helix(Angle beta) { cos_beta_ = std::cos(beta.rad()); }

  void check(const std::string& key, double value) const;
  /// Returns a finite number within the key's range. `part` is the name of the number within the
  /// value of the key, for example "sun" in bore_mm = { sun = 200 }. `part` is empty if the value
  /// is a single number.
  double checked(const std::string& key, const Json& value, const std::string& part = "") const;
  /// Fails if a required key is absent. If the table also contains an unknown key, the error is
  /// about the unknown key, because this key may be the misspelled required key.
  void require_all() const;
  /// Records that neither the key nor one of its aliases is given, so that finish() fails. `what`
  /// is the name of the quantity for the error.
  void lacks_one_of(const std::string& key, const std::string& what);
  /// Rejects a key that is not allowed here, with the reason.
  void refuse(const std::string& key, const std::string& why);
  /// Fails if a key is unknown, if a required key is missing, if a key lacks another key that it
  /// needs, or if two keys exclude each other. The error for an unknown key names the nearest known
  /// key.
  void finish() const;
  void refuse_unknown() const;  ///< checks only for an unknown key

  const KeyTable& keys() const { return keys_; }
  const std::string& name() const { return path_; }
  std::string name(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[noreturn]] void fail(const std::string& key, const std::string& why) const;
  /// Fails because the key is missing. `rest` continues the sentence "is missing".
  [[noreturn]] void fail_absent(const std::string& key, std::string_view rest) const;

  bool given(std::string_view key) const;

 private:
  const Key& entry(const std::string& key) const;
  const Json* find(const std::string& key);
  std::optional<KeyValue> value(const Key& key);
  /// Returns the value in the unit of `key`, from the key or its aliases. If several of these keys
  /// are given, their values must agree.
  std::optional<double> number_in_any_way(const Key& key);
  std::optional<int> whole(const std::string& key);
  std::optional<std::vector<int>> words(const Key& key);
  std::optional<std::vector<std::string>> texts(const Key& key);
  std::optional<KeyValue> by_name(const Key& key);
  std::vector<double> listed_numbers(const Key& key, const Json& node) const;
  void read_ends(const Key& key, KeyTarget input);
  void read_tables(const Key& key, KeyTarget input);
  /// Fails with one error for all required keys that are missing.
  [[noreturn]] void fail_missing() const;

  const KeyTable& keys_;
  const Json& node_;
  std::string path_;
  double cos_beta_ = 1.0;
  std::set<std::string, std::less<>> used_;
  std::vector<Error> lacking_;
};

template <class T>
T read_table(const KeyTable& keys, const Json& node, const std::string& path) {
  T input{};
  TableReader(keys, node, path).read_whole(input);
  return input;
}

constexpr double kSameInput = 1e-9;  ///< greatest relative difference of two values of one input

/// Returns a value as the user wrote it, cut to a length that fits a message.
std::string shown(const Json& value);

}  // namespace gearwright
