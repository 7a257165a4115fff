// Makes the tables of corrections, of proposed modifications, and of their effects, for users.
#pragma once

#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/catalogue/text_table.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

/// Returns a table with a row for each correction. For each correction whose value is at the end of
/// the searched range, the table has a note.
TextTable correction_table(std::string title, const std::vector<FoundCorrection>& corrections,
                           UnitSystem units);

/// The peak-to-peak transmission error for each combination of errors.
TextTable scenario_table(const std::vector<Scenario>& scenarios, UnitSystem units);

/// Returns two tables. The first contains the amounts of the proposals, and the second their
/// effects under load. If the accuracy grades give helix slope deviations, a third table contains
/// the effects for the less favourable direction of these deviations. If several proposals have the
/// same spec, only the first of them has a row. A * marks the row of the proposal with the index
/// `marked`.
std::vector<TextTable> proposal_tables(const ProposeView& view, UnitSystem units,
                                       std::optional<std::size_t> marked);

}  // namespace gearwright
