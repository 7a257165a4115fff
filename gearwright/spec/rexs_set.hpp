// Finds the planetary set of a REXS model. The set has the gears, each as a member of [planetary],
// the held bodies, the inputs and the output. Internal to spec/.
//
// A body that a coupling connects to the casing is held. A body with a load is an input if the load
// defines a torque or if the shaft defines a speed. Any other body with a load is the output. If
// there is no such other body and a load of one body defines a torque, a body for which only the
// speed is defined is the output instead of an input. If no body is connected to the casing and two
// of three bodies have a load, the third body is held.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gearwright/spec/rexs_file.hpp"

namespace gearwright {

bool is_rexs_gear(const RexsComponent& component);
/// Returns the name of a component in quotation marks or, if it has no name, its type and its id.
std::string rexs_name(const RexsComponent& component);
/// z, which is negative for a ring.
///
/// Domain    a gear with `number_of_teeth`, without rexs_number_error()
int rexs_teeth(const RexsComponent& gear);

struct RexsStage {
  const RexsComponent* stage;
  std::array<const RexsComponent*, 2> gears;
};

/// A body that transmits torque to other machines.
struct RexsEnd {
  std::string body;
  const RexsComponent* load = nullptr;             ///< load on the body; if there are several, one
                                                   ///< that defines a torque
  std::optional<double> torque_Nm{}, speed_rpm{};  ///< with their signs
};

struct RexsSet {
  std::map<std::string, const RexsComponent*> gears;  ///< by member; for several copies of a
                                                      ///< planet, the first copy
  std::map<std::string, RexsStage> meshes;            ///< by the name of the mesh in [planetary]
  /// The other copies of the planets and their meshes, each with the first copy.
  std::vector<std::array<const RexsComponent*, 2>> copies;
  std::size_t planets = 0;
  /// The central bodies and the carrier, each with the ids of the shafts that turn with it.
  std::map<std::string, std::set<std::string>> bodies;
  std::vector<std::string> held;                  ///< bodies that are connected to the casing
  std::optional<std::vector<std::string>> fixed;  ///< held bodies; none if the file does not state
                                                  ///< them
  std::vector<RexsEnd> inputs;                    ///< empty if the file does not state them
  std::string output;                             ///< empty if the file does not state it
};

/// The ids of this shaft and of the shafts that turn together with it, because couplings connect
/// them. If a coupling connects one of them to the casing, the id of the casing is included.
std::set<std::string> rexs_coupled(const RexsModel& model, const std::string& shaft);

/// The load on this shaft that defines a torque, or null.
const RexsComponent* rexs_torque(const RexsModel& model, const RexsComponent& shaft);
/// True if the file defines the torque or the speed of the shaft.
bool rexs_drives(const RexsModel& model, const RexsComponent& shaft);

/// The set of a planetary stage. `stages` are its meshes.
///
/// Errors    a gear or a stage that is no part of a set of [planetary], by its name; several
///           outputs; members that are coupled with each other
Result<RexsSet> set_of_rexs(const RexsModel& model, const std::vector<RexsStage>& stages,
                            const RexsComponent& planetary_stage);

}  // namespace gearwright
