#include "gearwright/catalogue/error_keys.hpp"

#include <fmt/format.h>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

using Gears = std::array<const Gear*, 2>;

constexpr double kMaxTilt = 10;     // degrees; a larger angle is not a misalignment
constexpr double kMaxSlope = 5000;  // µm over the face width

// Sets the additional twist κ of the teeth. κ is chosen so that the helix slope deviation over the
// face width, on the reference cylinder, is f_Hβ.
void set_helix_slope(ContactErrors& e, const Gears& gears, std::size_t i, double slope_um) {
  const Gear& gear = *gears[i];
  e.helix_twist[i] = slope_um * kMmPerUm / (gear.reference_diameter / 2 * gear.spec.face_width);
}

}  // namespace

const std::array<ErrorEntry, kErrorCount>& error_entries() {
  using E = ContactErrors;
  static const std::array<ErrorEntry, kErrorCount> entries{{
      {"center_distance_mm", "ΔC", "centre distance", ErrorKind::center_distance, 0,
       [](E& e, const Gears&, double v) { e.center_distance = v; },
       "error of the centre distance; axis 2 is at a + ΔC"},
      {"crossing_deg", "Δγ", "out-of-plane shaft deviation", ErrorKind::crossing, 0,
       [](E& e, const Gears&, double v) { e.crossing = Angle::degrees(v); },
       "angle of the deviation f_Σβ, by which axis 1 turns about the centre line; > 0 if the +z "
       "end of axis 1 turns towards +y. The shaft angle increases by the same angle"},
      {"intersecting_deg", "Δδ", "in-plane shaft deviation", ErrorKind::intersecting, 0,
       [](E& e, const Gears&, double v) { e.intersecting = Angle::degrees(v); },
       "angle of the deviation f_Σδ, by which axis 1 tilts in the plane of the axes; > 0 towards "
       "+x, the side of gear 2"},
      {"axial_mm", "Δz", "axial position of gear 1", ErrorKind::axial, 0,
       [](E& e, const Gears&, double v) { e.axial = v; }, "displacement of gear 1 along +z"},
      {"helix_slope1_um", "f_Hβ1", "helix slope of gear 1", ErrorKind::helix_slope1, 1,
       [](E& e, const Gears& g, double v) { set_helix_slope(e, g, 0, v); },
       "helix slope deviation over the face width at the reference cylinder of gear 1; the section "
       "at height z is rotated by z f_Hβ/(r b), counter-clockwise seen from +z, and its shape does "
       "not change"},
      {"helix_slope2_um", "f_Hβ2", "helix slope of gear 2", ErrorKind::helix_slope2, 2,
       [](E& e, const Gears& g, double v) { set_helix_slope(e, g, 1, v); },
       "as `helix_slope1_um`, but for gear 2"},
      {"cutter_lead1_deg", "Δλ1", "lead angle of gear 1", std::nullopt, 1,
       [](E& e, const Gears&, double v) { e.cutter_lead[0] = Angle::degrees(v); },
       "error of the lead angle λ = 90° − |β| with which gear 1 is cut; the lead and the "
       "transverse section change, but the pitch radius does not [T8.14]"},
      {"cutter_lead2_deg", "Δλ2", "lead angle of gear 2", std::nullopt, 2,
       [](E& e, const Gears&, double v) { e.cutter_lead[1] = Angle::degrees(v); },
       "as `cutter_lead1_deg`, but for gear 2"},
  }};
  return entries;
}

double ErrorEntry::si() const {
  return unit() == "deg" ? kRadPerDeg : unit() == "um" ? kMmPerUm : 1.0;
}

std::string ErrorEntry::member() const {
  if (gear == 0) return std::string(name());
  return (of_cutter() ? "cutter_lead[" : "helix_twist[") + std::to_string(gear - 1) + "]";
}

std::optional<std::size_t> error_index(std::string_view key) {
  for (std::size_t i = 0; i < kErrorCount; ++i)
    if (error_entries()[i].key == key) return i;
  return std::nullopt;
}

ContactErrors ErrorsInput::of(const std::array<const Gear*, 2>& gears) const {
  ContactErrors errors;
  for (std::size_t i = 0; i < kErrorCount; ++i) error_entries()[i].set(errors, gears, value[i]);
  return errors;
}

const KeyTable& error_keys() {
  static const KeyTable table = [] {
    KeyTable t{
        "errors", "Errors of mounting and of the teeth; all errors act at the same time", {}};
    for (std::size_t i = 0; i < kErrorCount; ++i) {
      const ErrorEntry& e = error_entries()[i];
      KeyRange range;
      if (e.of_cutter()) {
        range = KeyRange::between(-kMaxTilt, kMaxTilt,
                                  " degrees, because the value is an error of the lead angle; the "
                                  "helix angle itself is helix_angle_deg of the gear");
      } else if (e.unit() == "deg") {
        range = KeyRange::between(-kMaxTilt, kMaxTilt,
                                  " degrees, because the value is an error of the shaft angle; the "
                                  "shaft angle itself is pair.shaft_angle_deg");
      } else if (e.unit() == "um") {
        range = KeyRange::between(-kMaxSlope, kMaxSlope,
                                  " µm; the helix angle itself is a key of the gear");
      }
      t.keys.push_back(Key::number(e.key, e.symbol, range,
                                   KeyPlace::within<ErrorsInput>([i](auto& errors) -> auto& {
                                     return errors.value[i];
                                   }),
                                   "0", e.meaning)
                           .with_fields({e.member()}));
      if (e.kind == ErrorKind::crossing) t.keys.back().also = {"misalignment", "parallelism"};
    }
    return t;
  }();
  return table;
}

namespace {

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
  if (map.key[0] == map.key[1]) return KeyFault{"y", "must not be the same error as x"};
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

template <class V>
KeyPlace request(V ContactRequest::*member) {
  return KeyPlace::inherited<ContactInput>(member);
}

}  // namespace

const KeyTable& contact_keys() {
  static const KeyTable table{
      "contact",
      "Settings of the contact computation",
      {Key::number("positions", "", KeyRange::between(4, 100'000),
                   request(&ContactRequest::positions), "64", "positions per pitch of gear 1"),
       Key::number("pitches", "", KeyRange::between(1, 10'000), request(&ContactRequest::pitches),
                   "1",
                   "number of pitches in the result; every pitch repeats the results of the first. "
                   "Positions times pitches must be at most 10⁶"),
       Key::number("marking_mm", "δ", KeyRange::above(0, 1, ", usually 0.003 to 0.01"),
                   request(&ContactRequest::marking), "0.00635",
                   "thickness of the marking compound for ellipses and pattern"),
       Key::number("driver", "", KeyRange::between(1, 2), &ContactInput::driver, "1",
                   "gear that drives; if gear 2 drives, the sense of rotation does not change, and "
                   "the trailing flanks touch"),
       Key::flag("pattern", &ContactInput::pattern, "false",
                 "if true, the result has the marking pattern of both flanks"),
       Key::number("rotation1_deg", "", KeyRange::between(-1e6, 1e6),
                   request(&ContactRequest::rotations), "",
                   "rotations of gear 1, instead of positions and pitches")
           .with_list(KeyList{1, 100'000})
           .with_fields({"rotations"}),
       Key::part("map", contact_map_keys, &ContactInput::map,
                 "map of the peak-to-peak transmission error as a function of two errors")},
      check_contact};
  return table;
}

const KeyTable& contact_map_keys() {
  static const KeyTable table{
      "contact_map",
      "Map of the peak-to-peak transmission error as a function of two errors; [errors] gives the "
      "other errors",
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
       Key::number("points", "", KeyRange::between(2, 1000), &ContactMapInput::points, "[21, 21]",
                   "numbers of values along x and along y, including the ends")
           .with_list(KeyList{2, 2})},
      check_map};
  return table;
}

}  // namespace gearwright
