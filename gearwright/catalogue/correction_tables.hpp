// Makes the tables of corrections, of proposed modifications, and of their effects, for users.
#pragma once

#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/catalogue/text_table.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

/// Returns a table with a row for each correction. A note marks each value at the end of the
/// searched range.
TextTable correction_table(std::string title, const std::vector<FoundCorrection>& corrections,
                           UnitSystem units);

/// The peak-to-peak transmission error for each combination of errors.
TextTable scenario_table(const std::vector<Scenario>& scenarios, UnitSystem units);

/// Returns a table with the amounts of each proposal and a table with its effects under load. If
/// the accuracy grades give helix slope deviations, a third table lists the effects for the less
/// favourable direction of these deviations. Of the proposals with the same spec, only the first
/// has a row. The proposal with the index `marked` has a *.
std::vector<TextTable> proposal_tables(const ProposeView& view, UnitSystem units,
                                       std::optional<std::size_t> marked);

}  // namespace gearwright
