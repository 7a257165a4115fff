#include "gearwright/catalogue/error_keys.hpp"

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

using Gears = std::array<const Gear*, 2>;

constexpr double kMaxTilt = 10;     // degrees; a larger angle is not a misalignment
constexpr double kMaxSlope = 5000;  // µm over the face width

// Sets the twist κ for a slope f_Hβ over the face width, on the reference cylinder.
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
       "f_Σβ as an angle by which axis 1 turns about the centre line and the shaft angle "
       "increases; > 0 towards +y"},
      {"intersecting_deg", "Δδ", "in-plane shaft deviation", ErrorKind::intersecting, 0,
       [](E& e, const Gears&, double v) { e.intersecting = Angle::degrees(v); },
       "f_Σδ as an angle by which axis 1 tilts in the plane of the axes; > 0 towards +x, that is "
       "towards gear 2"},
      {"axial_mm", "Δz", "axial position of gear 1", ErrorKind::axial, 0,
       [](E& e, const Gears&, double v) { e.axial = v; }, "gear 1 moves along +z"},
      {"helix_slope1_um", "f_Hβ1", "helix slope of gear 1", ErrorKind::helix_slope1, 1,
       [](E& e, const Gears& g, double v) { set_helix_slope(e, g, 0, v); },
       "deviation over the face width at the reference cylinder of gear 1; the section at height z "
       "is rotated by z f_Hβ/(r b), counter-clockwise seen from +z, and its shape does not change"},
      {"helix_slope2_um", "f_Hβ2", "helix slope of gear 2", ErrorKind::helix_slope2, 2,
       [](E& e, const Gears& g, double v) { set_helix_slope(e, g, 1, v); }, "as for gear 1"},
      {"cutter_lead1_deg", "Δλ1", "lead angle of gear 1", std::nullopt, 1,
       [](E& e, const Gears&, double v) { e.cutter_lead[0] = Angle::degrees(v); },
       "error of the lead angle λ = 90° − |β| with which gear 1 is cut; the lead and the "
       "transverse section change, but the pitch radius does not [T8.14]"},
      {"cutter_lead2_deg", "Δλ2", "lead angle of gear 2", std::nullopt, 2,
       [](E& e, const Gears&, double v) { e.cutter_lead[1] = Angle::degrees(v); }, "as for gear 1"},
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

const KeyTable& error_keys() {
  static const KeyTable table = [] {
    KeyTable t{"errors", "Errors of mounting and of the teeth, which act together", {}};
    for (std::size_t i = 0; i < kErrorCount; ++i) {
      const ErrorEntry& e = error_entries()[i];
      KeyRange range;
      if (e.unit() == "deg") {
        range = KeyRange::between(-kMaxTilt, kMaxTilt,
                                  " degrees, because it is an error of the shaft angle; the shaft "
                                  "angle itself is pair.shaft_angle_deg");
      } else if (e.unit() == "um") {
        range = KeyRange::between(-kMaxSlope, kMaxSlope,
                                  " micrometres; the helix angle itself is a key of the gear");
      }
      t.keys.push_back(Key::number(e.key, e.symbol, range,
                                   KeyPlace::within<ErrorsInput>([i](auto& errors) -> auto& {
                                     return errors.value[i];
                                   }),
                                   "0", e.meaning)
                           .with_fields({e.member()}));
    }
    return t;
  }();
  return table;
}

}  // namespace gearwright
