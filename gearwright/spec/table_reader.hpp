// Reads one table of a spec by the catalogue: typed values within their ranges, complaints that name
// the key, unknown keys at the end.
//
// A key that the catalogue has not, or one of it that nobody read, is a mistake of ours and breaks a
// contract: table and reader cannot drift apart.
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

  /// Every key that has a place goes there; absent ones leave what is there.
  template <class T>
  void read(T& input) {
    for (const Key& key : keys_.keys) {
      if (!key.place) continue;
      if (const auto value = plain(key)) key.place.put(input, *value);
    }
  }

  bool has(const std::string& key);
  std::optional<double> number(const std::string& key);  ///< finite, within its range
  std::optional<bool> boolean(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<std::string> word(const std::string& key);
  /// Of a key with a list: as many finite numbers as it may have, whose range is not looked at.
  std::optional<std::vector<double>> numbers(const std::string& key);
  const Json* table(const std::string& key);  ///< a sub-table, or null
  const Json* any(const std::string& key);    ///< a value of whatever type, or null

  /// The key's range, of one of its numbers.
  void check(const std::string& key, double value) const;
  /// Complains if the key is absent; a misspelt one is named before one that is missing by it.
  void require(const std::string& key);
  /// Something is missing that several keys could say; finish() complains.
  void lacks(const std::string& key, const std::string& why) {
    lacking_.push_back({name(key), "", why});
  }
  /// A key that has no place here: refused in plain words when present.
  void refuse(const std::string& key, const std::string& why);
  /// Complains about a key that the table has not, naming the nearest one; about one that is
  /// missing, by itself or beside another; about two that exclude each other.
  void finish() const;
  void refuse_unknown() const;  ///< the first of these alone

  const KeyTable& keys() const { return keys_; }
  const std::string& name() const { return path_; }  ///< of the table
  std::string name(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  [[noreturn]] void fail(const std::string& key, const std::string& why) const;

 private:
  const Key& entry(const std::string& key) const;
  const Json* find(const std::string& key);
  std::optional<KeyValue> plain(const Key& key);
  std::optional<int> whole(const std::string& key);
  bool given(std::string_view key) const;
  /// Whatever the table must have and lacks.
  [[noreturn]] void fail_missing() const;

  const KeyTable& keys_;
  const Json& node_;
  std::string path_;
  std::set<std::string, std::less<>> asked_;
  std::vector<Error> lacking_;
};

/// A value as a person wrote it, cut to a length that fits a sentence.
std::string shown(const Json& value);

}  // namespace gearwright
