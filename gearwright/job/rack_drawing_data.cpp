#include <fmt/format.h>

#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/job/drawing_data.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

// Adds a row for a length that is not in the records of the results.
void add_rack_length(DataGroup& group, UnitSystem units, const char* words, const char* symbol,
                     double mm) {
  group.rows.push_back({words, symbol, with_minus(length_text(units, mm))});
}

// The rows indicate whether the number of teeth and the height of the body are defaults. The
// distance to the back and the dimension over a pin depend on this height.
DataGroup rack_teeth(const SolvedJob& job, const Records& r) {
  const RackGeometry& rack = job.rack->rack;
  DataGroup group{"Rack data, symbols of ISO 21771", {}};
  group.rows.push_back({"Number of teeth", "z",
                        fmt::format("{}{}", rack.teeth, rack.bar.teeth ? "" : ", default length")});
  add_module(group, r, rack.normal_module);
  const Records pinion{gear_quantities().of(job.gear(1)), r.units};
  add_data(group, pinion, "normal_pressure_angle_deg");
  add_data(group, r, "helix_angle_deg", Sign::dropped);
  const double beta = rack.helix_angle.rad();
  if (beta != 0.0) group.rows.push_back({"Hand of helix", "", beta > 0.0 ? "right" : "left"});
  add_data(group, r, "normal_pitch_mm");
  if (beta != 0.0) add_data(group, r, "transverse_pitch_mm");
  if (job.gear(1).spec.straight_rack().named)
    group.rows.push_back({"Basic rack", "", rack_name(job.spec, 1)});
  add_data(group, r, "addendum_mm");
  add_data(group, r, "dedendum_mm");
  add_rack_length(group, r.units, "Root fillet radius", "ρ_f", rack.fillet_radius);
  if (!rack.bar.height)
    group.rows.push_back(
        {"Back to datum line", "h_B", length_text(r.units, rack.height) + ", default height"});
  return group;
}

DataGroup rack_thickness(const SolvedJob& job, const Records& r) {
  DataGroup group{"Tooth thickness", {}};
  add_data(group, r, "reference_tooth_thickness_normal_mm");
  add_rack_length(group, r.units, "Thickness allowance", "E_sn",
                  job.rack->rack.bar.thickness_allowance);
  add_data(group, r, "pin_diameter_mm");
  add_data(group, r, "over_pin_mm");
  return group;
}

}  // namespace

void add_rack_mounting(DataGroup& group, const SolvedJob& job) {
  const Records pair{pair_record(job), job.spec.units()};
  group.rows.push_back(
      {"Pinion axis to datum line", "H", pair.value("center_distance_mm").value()});
  group.rows.push_back(
      {"Pinion axis to back of rack", "", pair.value("mounting_distance_mm").value()});
  add_data(group, pair, "backlash.normal_mm");
}

std::vector<DataGroup> rack_drawing_data(const SolvedJob& job,
                                         const std::string& number_of_pinion) {
  GW_EXPECTS(job.rack.has_value());
  const Records rack{rack_quantities().of(job.rack->rack), job.spec.units()};
  DataGroup pinion{"Pinion", {{"Drawing number", "", number_of_pinion}}};
  pinion.rows.push_back({"Number of teeth", "z_1", fmt::format("{}", job.gear(1).spec.teeth)});
  add_rack_mounting(pinion, job);
  return {rack_teeth(job, rack), rack_thickness(job, rack), std::move(pinion)};
}

}  // namespace gearwright
