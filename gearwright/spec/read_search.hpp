// Reads the table [search] of a spec, for pairs or for drives. Some inputs of a search are in other
// tables. The pressure angle is in [gear1] or [gear2]. The rack, the helix angle and the face width
// are also there, unless [search] gives them. The load is in [rating]. These inputs and the table
// [scatter] are also read here.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include <array>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/scatter_keys.hpp"
#include "gearwright/design/drive_search.hpp"
#include "gearwright/design/search_problem.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// `search`, `gear_1` and `gear_2` are the tables as given. The tables of the gears may be null.
/// The default step of face widths depends on the units of the spec.
SearchProblem read_search(const Json& search, const Json* gear_1, const Json* gear_2,
                          UnitSystem units);

/// Usual face widths, as multiples of the reference diameter of the pinion. A wider pinion bends
/// and twists so much that only a part of its face carries load. Narrower gears are rare in
/// reducers.
inline constexpr std::array kUsualFace{0.2, 1.0};

/// Returns the default step of face widths within a band, in mm. It is 1 mm or 0.05 in, so that the
/// widths are round numbers in the units of the spec.
constexpr double default_face_step(UnitSystem units) {
  return units == UnitSystem::mm ? 1.0 : 0.05 * kMmPerInch;
}

/// If the axes of the search are crossed, throws the error of a key that needs parallel axes.
void require_parallel(const TableReader& t, const SearchProblem& problem, const std::string& key,
                      const char* why);

// Reads the inputs of a search that are outside its own table. If [search] requires safety, the
// inputs of the rating are read from [rating] and the materials. If the search checks its designs
// as drawings, tolerances are read and default limits exclude impractical designs.

/// The default face load factor of a search. A search has no shafts from which the factor could be
/// computed. The value is the median of the factors by ISO 6336-1 for designs found by searches
/// (docs/decisions.md).
inline constexpr double kSearchFaceLoad = 1.4;

/// Adds the default `face_load_factor` to the table [rating] of a search, if the table has neither
/// this key nor [rating.mounting]. The key `face_load_factor_assumed` marks the default, also in
/// the specs of the designs. A rating by VDI 2736 and the rating of a complete pair have no
/// default.
void lend_face_load(Json& tree);

/// True if the face load factor of a rated search is kSearchFaceLoad because the spec has none.
bool has_default_face_load(const JobSpec& spec);

/// True if the search needs a rating, either for a required safety or for an objective such as
/// noise. The objectives mass and cost need a rating only if [rating] is given.
bool wants_rating(const SearchProblem& problem, const RatingTable& rating);

/// Adds the densities of the materials to the problem, and the inputs of a rating if the search
/// needs one. If [search] itself is incomplete, only the missing inputs of the rating are reported.
void read_search_rating(const Json& tree, JobSpec& spec);

/// The default series of thickness allowances for a search.
inline constexpr const char* kUsualSeries = "cd25";

/// Sets up a search so that each design is judged as on a drawing, with tolerances of the tooth
/// thickness and of the centre distance. Designs have nominal teeth and are not drawn in four kinds
/// of searches:
///   (1) searches on crossed axes
///   (2) searches on a grid of profile shifts
///   (3) searches that also list designs with interference
///   (4) searches with the key `mounting`, without tolerances and without a band of face widths
/// `search` is the table [search]. read_search_rating() must be called before.
void read_search_drawing(const Json& search, SearchProblem& problem);

// Reads a [search] for drives, which is a table [search] with the key `kind`.

bool is_drive_search(const Json& search);

DriveSearchProblem read_drive_search(const Json& search);

/// Returns the keys of [search] that are copied to [planetary], or to every stage of a train.
Json shared_keys(const Json& search, bool train);

// Reads [scatter], which contains groups of inputs and toleranced numbers. Each toleranced number
// is a list of two numbers or a table.

ScatterInput read_scatter(const Json& table);

}  // namespace gearwright
