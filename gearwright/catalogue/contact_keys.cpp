#include "gearwright/catalogue/contact_keys.hpp"

#include <fmt/format.h>

namespace gearwright {

namespace {

using Range = KeyRange;

std::vector<std::string_view> error_words() {
  std::vector<std::string_view> words;
  for (const ErrorEntry& e : error_entries()) words.push_back(e.key);
  return words;
}

KeyPlace axis(std::size_t i) {
  return KeyPlace::within<ContactMapInput>([i](auto& map) -> auto& { return map.key[i]; });
}

KeyPlace range(std::size_t i) {
  return KeyPlace::within<ContactMapInput>([i](auto& map) -> auto& { return map.range[i]; });
}

std::optional<KeyFault> check_map(ContactMapInput& map, const KeyGiven&) {
  if (map.key[0] == map.key[1]) return KeyFault{"y", "must be an error other than x"};
  for (const std::size_t i : {0, 1}) {
    const KeyRange& allowed = error_keys().keys[map.key[i]].range;
    for (const double v : map.range[i])
      if (!allowed.contains(v))
        return KeyFault{i == 0 ? "x_range" : "y_range", allowed.sentence(v)};
  }
  return std::nullopt;
}

std::optional<KeyFault> check_contact(ContactInput& c, const KeyGiven&) {
  if (static_cast<long long>(c.positions) * c.pitches <= kMaxPositions) return std::nullopt;
  return KeyFault{"pitches",
                  fmt::format("positions times pitches must be at most {}", kMaxPositions)};
}

}  // namespace

const KeyTable& contact_keys() {
  static const KeyTable table{
      "contact",
      "Settings of the contact computation",
      {Key::number("positions", "", Range::between(4, 100'000), &ContactInput::positions, "64",
                   "positions per pitch of gear 1"),
       Key::number("pitches", "", Range::between(1, 10'000), &ContactInput::pitches, "1",
                   "number of pitches in the result, each with the results of the first pitch. "
                   "Positions times pitches must be at most 10⁶"),
       Key::number("marking_mm", "δ", Range::above(0, 1, ", usually 0.003 to 0.01"),
                   &ContactInput::marking, "0.00635",
                   "thickness of the marking compound for ellipses and pattern"),
       Key::number("driver", "", Range::between(1, 2), &ContactInput::driver, "1",
                   "gear that drives; if gear 2 drives, the sense of rotation does not change, and "
                   "the trailing flanks touch"),
       Key::flag("pattern", &ContactInput::pattern, "false",
                 "if true, the result has the marking pattern of both flanks"),
       Key::number("rotation1_deg", "", Range::between(-1e6, 1e6), &ContactInput::rotations, "",
                   "rotations of gear 1, instead of positions and pitches")
           .with_list(KeyList{1, 100'000})
           .with_fields({"rotations"}),
       Key::part("map", contact_map_keys, &ContactInput::map,
                 "map of the peak-to-peak transmission error over two errors")},
      check_contact};
  return table;
}

const KeyTable& contact_map_keys() {
  static const KeyTable table{
      "contact_map",
      "Map of the peak-to-peak transmission error over two errors; [errors] gives the other errors",
      {Key::word("x", error_words(), axis(0), kRequired, "a key of [errors], such as crossing_deg")
           .with_form("a key of `[errors]`"),
       Key::number("x_range", "", {}, range(0), kRequired,
                   "the least and the greatest value, in the unit of the key")
           .with_list(kErrorRange),
       Key::word("y", error_words(), axis(1), kRequired, "a key of [errors], different from x")
           .with_form("a key of `[errors]`"),
       Key::number("y_range", "", {}, range(1), kRequired,
                   "the least and the greatest value, in the unit of the key")
           .with_list(kErrorRange),
       Key::number("points", "", Range::between(2, 1000), &ContactMapInput::points, "[21, 21]",
                   "numbers of values along x and along y, including the ends")
           .with_list(KeyList{2, 2})},
      check_map};
  return table;
}

}  // namespace gearwright
