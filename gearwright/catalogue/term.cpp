#include "gearwright/catalogue/term.hpp"

#include <algorithm>
#include <array>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

struct UnitRow {
  Unit unit;
  const char *text, *suffix;
  int digits;
};

// The rows are in the order of the enumerators.
constexpr std::array kUnitRows{UnitRow{Unit::none, "", "", 5},
                               UnitRow{Unit::mm, "mm", "_mm", 4},
                               UnitRow{Unit::um, "µm", "_um", 3},
                               UnitRow{Unit::deg, "°", "_deg", 5},
                               UnitRow{Unit::arcsec, "″", "_arcsec", 4},
                               UnitRow{Unit::per_mm, "1/mm", "_per_mm", 6},
                               UnitRow{Unit::mm_per_rad, "mm/rad", "_mm_per_rad", 4},
                               UnitRow{Unit::m_per_s, "m/s", "_m_per_s", 4},
                               UnitRow{Unit::newton, "N", "_N", 1},
                               UnitRow{Unit::newton_metre, "N m", "_Nm", 1},
                               UnitRow{Unit::kilowatt, "kW", "_kW", 2},
                               UnitRow{Unit::megapascal, "N/mm²", "_MPa", 2},
                               UnitRow{Unit::per_minute, "1/min", "_rpm", 1},
                               UnitRow{Unit::hertz, "Hz", "_hz", 3},
                               UnitRow{Unit::newton_per_mm, "N/mm", "_N_per_mm", 2},
                               UnitRow{Unit::newton_per_mm_um, "N/(mm µm)", "", 3},
                               UnitRow{Unit::newton_per_um, "N/µm", "", 3},
                               UnitRow{Unit::celsius, "°C", "_C", 1},
                               UnitRow{Unit::kg, "kg", "_kg", 6},
                               UnitRow{Unit::kg_per_mm, "kg/mm", "", 6},
                               UnitRow{Unit::modules, "", "", 5},
                               UnitRow{Unit::modules_squared, "", "", 5},
                               UnitRow{Unit::percent, "%", "", 3},
                               UnitRow{Unit::hour, "h", "_h", 0},
                               UnitRow{Unit::vickers, "HV", "_HV", 0},
                               UnitRow{Unit::kg_per_m3, "kg/m³", "_kg_per_m3", 1},
                               UnitRow{Unit::mm2_per_s, "mm²/s", "_mm2_s", 1},
                               UnitRow{Unit::m2_kelvin_per_watt, "m²K/W", "_m2K_per_W", 4},
                               UnitRow{Unit::square_metre, "m²", "_m2", 4},
                               UnitRow{Unit::inch, "in", "_in", 5},
                               UnitRow{Unit::microinch, "µin", "_uin", 2},
                               UnitRow{Unit::per_inch, "1/in", "_per_in", 5},
                               UnitRow{Unit::inch_per_rad, "in/rad", "_in_per_rad", 5},
                               UnitRow{Unit::pound, "lb", "_lb", 6}};

const UnitRow& row(Unit unit) {
  const UnitRow& r = kUnitRows[static_cast<std::size_t>(unit)];
  GW_ENSURES(r.unit == unit);
  return r;
}

// The rows are sorted by key.
constexpr std::array kTerms{
    Term{"S_F", "safety against root breakage", "S_F"},
    Term{"S_H", "safety against pitting", "S_H"},
    Term{"approach_contact_ratio", "approach contact ratio"},
    Term{"area", "area of the feasible region"},
    Term{"backlash_free_center_distance_mm", "backlash-free centre distance"},
    Term{"backlash_mm", "backlash in the normal section", "j_n"},
    Term{"center_diameter_mm", "diameter of the centres", "d_K"},
    Term{"center_distance_mm", "centre distance", "a"},
    Term{"circumferential_mm", "circumferential backlash", "j_wt"},
    Term{"contact", "position of the contacts", "", Type::word},
    Term{"contact_diameter_mm", "diameter of the contacts", "d_M"},
    Term{"contact_lost", "contact lost", "", Type::flag},
    Term{"contact_offset_mm", "axial distance of the contacts from the centre"},
    Term{"contact_ratio", "total contact ratio", "ε_γ"},
    Term{"contact_ratio_true", "effective total contact ratio"},
    Term{"continuous_peak_to_peak_arcsec",
         "transmission error, peak to peak of the continuous curve"},
    Term{"continuous_peak_to_peak_um", "transmission error, peak to peak of the continuous curve"},
    Term{"diameter_mm", "diameters"},
    Term{"edge_carries", "an edge carries load", "", Type::flag},
    Term{"efficiency", "efficiency", "η"},
    Term{"efficiency_backward", "efficiency, output driving", "η"},
    Term{"efficiency_driving", "efficiency with this gear driving", "η"},
    Term{"equal", "equal pitch", "", Type::flag},
    Term{"face_load_factor", "face load factor", "K_Hβ"},
    Term{"face_width_mm", "face width", "b"},
    Term{"frequency_ratio", "teeth per turn of the input"},
    Term{"gap_curvature_per_mm", "curvatures of the gap", "k_1, k_2"},
    Term{"gear", "gear", "", Type::whole},
    Term{"gear1", "gear 1"},
    Term{"gear2", "gear 2"},
    Term{"gear_ratio", "gear ratio", "u"},
    Term{"generating_profile_shift", "generating profile shift coefficient", "x_E"},
    Term{"harmonics_arcsec", "harmonics"},
    Term{"harmonics_um", "harmonics"},
    Term{"height_mm", "heights"},
    Term{"helix_angle_deg", "helix angle", "β"},
    Term{"kind", "kind of contact", "", Type::word},
    Term{"marking_mm", "thickness of the marking compound", "δ"},
    Term{"max_pressure_MPa", "greatest pressure", "p_max"},
    Term{"module_mm", "normal module", "m_n"},
    Term{"neighbour_clearance_mm", "clearance of neighbouring planets", "c"},
    Term{"normal", "normal"},
    Term{"normal_base_mm", "normal backlash, shortest distance of the flanks", "j_bn"},
    Term{"normal_base_pitch_mm", "normal base pitch", "p_bn"},
    Term{"normal_diametral_pitch_per_in", "normal diametral pitch", "P_nd"},
    Term{"normal_mm", "backlash in the normal section", "j_n"},
    Term{"normal_module_mm", "normal module", "m_n"},
    Term{"normal_pressure_angle_deg", "normal pressure angle", "α_n"},
    Term{"overlap_ratio", "overlap ratio", "ε_β"},
    Term{"pareto", "Pareto front", "", Type::index},
    Term{"peak_to_peak_arcsec", "transmission error, peak to peak"},
    Term{"peak_to_peak_um", "transmission error, peak to peak"},
    Term{"pitch_line_velocity_m_per_s", "pitch line velocity", "v_t"},
    Term{"point_mm", "point"},
    Term{"positions", "possible positions per turn", "N*", Type::whole},
    Term{"power_kW", "power", "P"},
    Term{"profile_shift", "profile shift coefficient", "x"},
    Term{"rack", "rack", "", Type::whole},
    Term{"ratio", "ratio", "i"},
    Term{"ratio_exact", "exact ratio", "i", Type::whole},
    Term{"recess_contact_ratio", "recess contact ratio"},
    Term{"reference_diameter_mm", "reference diameter", "d"},
    Term{"reference_tooth_thickness_normal_mm", "normal tooth thickness", "s_n"},
    Term{"replicates", "replicates", "R", Type::whole},
    Term{"root_diameter_mm", "root diameter", "d_f"},
    Term{"rotation1_deg", "rotation of gear 1", "φ_1"},
    Term{"samples", "samples of each replicate", "n", Type::whole},
    Term{"shaft_angle_deg", "shaft angle", "Σ"},
    Term{"specific_sliding_at_A", "specific sliding at A", "ζ"},
    Term{"specific_sliding_at_E", "specific sliding at E", "ζ"},
    Term{"speed_rpm", "speed", "n"},
    Term{"teeth", "number of teeth", "z", Type::whole},
    Term{"tested", "tested", "", Type::index},
    Term{"thickness_allowance_mm", "thickness allowance", "E_sn"},
    Term{"tip_clearance_mm", "tip clearance", "c"},
    Term{"tip_diameter_mm", "tip diameter", "d_a"},
    Term{"tool", "number of teeth, or diameter of the balls", "k, D_M"},
    Term{"torque_Nm", "torque", "T_1"},
    Term{"transmission_error_arcsec", "transmission error", "TE"},
    Term{"transmission_error_um", "transmission error", "TE"},
    Term{"transverse_base_pitch_mm", "transverse base pitch", "p_bt"},
    Term{"transverse_contact_ratio", "transverse contact ratio", "ε_α"},
    Term{"transverse_contact_ratio_true", "effective transverse contact ratio"},
    Term{"working_normal_pressure_angle_deg", "working normal pressure angle", "α_wn"},
    Term{"working_transverse_pressure_angle_deg", "working transverse pressure angle", "α_wt"}};

}  // namespace

std::string_view unit_text(Unit unit) { return row(unit).text; }
std::string_view unit_suffix(Unit unit) { return row(unit).suffix; }
int unit_digits(Unit unit) { return row(unit).digits; }

Unit unit_of(std::string_view key) {
  Unit found = Unit::none;
  for (const UnitRow& r : kUnitRows)
    // The longest suffix is used, because "_N_per_mm" also ends with "_per_mm" and "_mm".
    if (key.ends_with(r.suffix) && unit_suffix(found).size() < std::string_view(r.suffix).size())
      found = r.unit;
  return found;
}

std::span<const Term> terms() { return kTerms; }

const Term& term_of(std::string_view key) {
  const auto term =
      std::find_if(kTerms.begin(), kTerms.end(), [&](const Term& t) { return t.key == key; });
  GW_EXPECTS(term != kTerms.end());
  return *term;
}

}  // namespace gearwright
