// The table of the eight errors of mounting and cutting. An entry has a key, a symbol, words and a
// member of ContactErrors. The keys of [errors] are made from this table.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/contact/contact.hpp"

namespace gearwright {

constexpr std::size_t kErrorCount = 8;

/// An error. The section [errors] of docs/spec.md describes the signs of all errors and the order
/// in which they are applied.
struct ErrorEntry {
  std::string_view key;           ///< "crossing_deg"
  std::string_view symbol;        ///< Δγ
  std::string_view words;         ///< "out-of-plane shaft deviation"
  std::optional<ErrorKind> kind;  ///< kind of derivative; empty if the contact analysis has no
                                  ///< derivative for this error
  int gear;                       ///< 1 or 2 for an error of a gear, 0 for an error of mounting
  /// Sets the error to a value in the unit of the key.
  void (*set)(ContactErrors&, const std::array<const Gear*, 2>&, double);
  std::string_view meaning;

  std::string_view unit() const { return key_unit(key); }  ///< "deg"
  double si() const;                                       ///< factor from the unit of the key to
                                                           ///< rad or mm
  /// The key without its unit, for example "crossing" for crossing_deg.
  std::string_view name() const { return without_unit(key); }
  bool of_cutter() const { return gear != 0 && unit() == "deg"; }
  std::string member() const;  ///< member of ContactErrors, "cutter_lead[0]"
};

const std::array<ErrorEntry, kErrorCount>& error_entries();
/// Returns the index of a key in error_entries, or none if there is no such error.
std::optional<std::size_t> error_index(std::string_view key);

/// [errors]: a value for each entry of error_entries, in the unit of its key.
struct ErrorsInput {
  std::array<double, kErrorCount> value{};
  bool given = false;

  bool any() const {
    return std::any_of(value.begin(), value.end(), [](double e) { return e != 0.0; });
  }
  /// Returns all errors for these gears. For a rack, the caller passes the pinion as gear 2.
  ContactErrors of(const std::array<const Gear*, 2>& gears) const;
};

inline constexpr KeyList kErrorRange{
    .least = 2,
    .most = 2,
    .order = {true, "must be in rising order, first the least value, then the greatest"}};

const KeyTable& error_keys();

// The keys of [contact] and [contact.map]: the resolution of the contact analysis of a pair.

/// [contact.map]: a map of the peak-to-peak transmission error as a function of two errors.
struct ContactMapInput {
  std::array<std::size_t, 2> key{};              ///< indices of the errors x and y in error_entries
  std::array<std::array<double, 2>, 2> range{};  ///< lower and upper end for x and y
  std::array<int, 2> points{21, 21};
};

struct ContactInput : ContactRequest {
  bool given = false;
  int driver = 1;
  bool pattern = false;  ///< true if the result includes the raster of both flanks
  std::optional<ContactMapInput> map;
};

constexpr int kMaxPositions = 1'000'000;  ///< limit for positions times pitches

const KeyTable& contact_keys();
const KeyTable& contact_map_keys();

}  // namespace gearwright
