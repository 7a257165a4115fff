// The straight-sided rack of ISO 53 and similar racks with other numbers.
//
//   m_n     normal module, mm                 α_n     normal pressure angle, rad
//   h_aP*, h_fP*, ρ_fP*  addendum, dedendum and tip rounding in modules (ISO 53, ISO 21771)
//                              theory: docs/theory/03-rack-and-generation.md, [T3.1]…[T3.6]
#pragma once

#include <optional>
#include <string_view>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

struct StraightRack {
  double addendum = 1.0;             ///< h_aP*  addendum of the gear tooth above the datum line
  double dedendum = 1.25;            ///< h_fP*  depth of the cutter below the datum line
  double root_fillet_radius = 0.38;  ///< ρ_fP*  radius of the cutter's tip rounding
  double tip_fillet_radius = 0.0;    ///< ρ_1*   radius of the cutter's bottom rounding
  std::optional<double> tool_addendum{};  ///< height of the flank's end above the datum line
  std::optional<Angle>
      semi_topping_angle{};   ///< pressure angle of a ramp that replaces the bottom rounding
  double protuberance = 0.0;  ///< pr_P*  height above the straight flank, perpendicular to it
  Angle protuberance_angle = Angle::degrees(10);  ///< α_pr   angle of the straight line of the
                                                  ///< protuberance
  bool named =
      false;  ///< true for a rack of a standard; if its tip rounding does not fit, the full radius
              ///< replaces it
};

/// Returns the rack with the name "ISO53-A" … "ISO53-D", or none for other names.
/// Source    ISO 53:1998, table 2
std::optional<StraightRack> iso53_rack(std::string_view name);

/// Returns the full radius, which is the greatest ρ_fP* that fits. With this radius, the roundings
/// of both sides meet in the middle of the tip. [T3.2]
double full_radius(const StraightRack& rack, Angle normal_pressure_angle);

struct StraightRackEdge {
  CutterEdge edge;
  bool became_full_radius =
      false;  ///< true if the radius of a named rack did not fit and was replaced
};

/// Returns the edge of a rack, in mm.
///
/// Errors    the member of `rack`, such as `rack.dedendum`, with its value and the allowed range;
///           `normal_pressure_angle` if the tooth of the cutter of a named rack becomes pointed
Result<StraightRackEdge> make_edge(const StraightRack& rack, double normal_module,
                                   Angle normal_pressure_angle);

// The basic racks of North American practice, whose names include the pressure angle.
//
//   AGMA-20, AGMA-25   full depth      ANSI B6.1-1968 (AGMA 201.02)
//   AGMA-14.5          full depth      ASA B6.1-1932, for gears in service
//   AGMA-stub          stub, 20°       ASA B6.1-1932
//
// Lengths are in 1/P, which is a module. The tip rounding is 0.3 for AGMA-20 and AGMA-25, 4/3 of
// the clearance for AGMA-14.5 and 3/2 of the clearance for AGMA-stub.

struct AgmaRack {
  std::string_view name;
  StraightRack rack;
  Angle normal_pressure_angle;  ///< α_n
};

const AgmaRack* agma_rack(std::string_view name);

}  // namespace gearwright
