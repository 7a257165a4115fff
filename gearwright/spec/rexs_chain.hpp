// The chain of the stages of a REXS model. A link is a cylindrical stage of two gears on fixed axes,
// or a planetary set. A link drives the next one by a shaft, or by shafts that couplings connect.
// Internal to spec/.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gearwright/spec/rexs_set.hpp"

namespace gearwright {

/// A body of a link that can transmit torque to another link or to another machine.
struct RexsTerminal {
  std::string body;             ///< "gear1", "gear2", or a body of the set
  std::set<std::string> parts;  ///< ids of its shafts
};

struct RexsLink {
  std::optional<RexsSet> set;  ///< none for a pair of gears
  RexsStage pair{};            ///< after rexs_chain(), gear 1 drives
  std::vector<RexsTerminal> terminals;
  std::string input, output;       ///< bodies, set by rexs_chain()
  std::vector<std::string> fixed;  ///< held bodies of a set, set by rexs_chain()
};

/// The links of a model. If one gear of a cylindrical stage is on a planet shaft, the cylindrical
/// stage belongs to the planetary stage of this shaft. If the model has one planetary stage and no
/// planet shafts, all cylindrical stages belong to the planetary stage.
///
/// Errors    those of set_of_rexs()
Result<std::vector<RexsLink>> rexs_links(const RexsModel& model,
                                         const std::vector<RexsStage>& stages);

/// The links in their order from input to output. The chain starts at a shaft with a given torque
/// or speed. Without such a shaft, it starts at the first shaft with a single link. If this link is
/// a planetary set, the shaft must be that of the sun. The output of a set is the body that drives
/// the next link or has a load. If no body of a set is connected to the casing, the body that is
/// neither input nor output is held.
///
/// Errors    links that form no chain; a chain that is driven by a shaft between two links; a set
///           without a single output
Result<std::vector<RexsLink>> rexs_chain(const RexsModel& model, std::vector<RexsLink> links);

}  // namespace gearwright
