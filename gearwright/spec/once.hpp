// One quantity said by several keys of a spec: it may be said twice if the two agree.
//
// Internal to spec/: complaints are SpecErrors of the table.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

constexpr double kSameInput = 1e-9;  ///< two ways of saying one thing may differ by rounding

/// Each reader gives the value in the first one's unit.
class Once {
 public:
  Once(TableReader& table, std::string what) : table_(table), what_(std::move(what)) {}
  void offer(const std::string& key, std::optional<double> value) {
    keys_ += (keys_.empty() ? "" : ", ") + key;
    if (!value) return;
    if (value_ && std::abs(*value - *value_) > kSameInput * std::abs(*value_)) {
      table_.fail(key, fmt::format("contradicts {}: both say the {}, leave one out", key_, what_));
    }
    if (!value_) {
      value_ = value;
      key_ = key;
    }
  }
  std::optional<double> value() const { return value_; }
  /// The table is refused without it.
  void require() const {
    if (!value_)
      table_.lacks(keys_.substr(0, keys_.find(',')),
                   fmt::format("is missing; the {} is needed, {} = 2 for example, by one of: {}",
                               what_, keys_.substr(0, keys_.find(',')), keys_));
  }

 private:
  TableReader& table_;
  std::string what_;
  std::string keys_;
  std::string key_;
  std::optional<double> value_;
};

}  // namespace gearwright
