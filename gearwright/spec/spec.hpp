// The spec file: a gear or a pair as on a drawing, in TOML or JSON.
//
// Lengths in mm and angles in degrees, said in the key. Absent keys are absent here too: what
// follows from what is decided in job/solved_job.hpp, in one place.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/design/search_problem.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/spec/missing_for.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

struct IdentifyProblem;  // inspection/identify.hpp
struct DriveInput;       // drive/drive.hpp
struct SpecTree;         // spec/parse_spec.hpp

struct JobSpec : SpecTables {
  std::string text;  ///< the spec as read, for the report; of a tree its JSON
  /// The same as a tree of tables, with what gear 2 has from gear 1; null in a spec that was not read.
  std::shared_ptr<const SpecTree> tree;
  GivenKeys given;                          ///< the paths of the keys in the text
  std::shared_ptr<const DriveInput> drive;  ///< null: the spec has no drive
  std::optional<RackBar> rack;              ///< gear 2 is a rack, and `gears` has the pinion alone
  DoubleHelicals double_helical;            ///< of gears, whose face width is then the whole one
  std::optional<SearchProblem> search;
  /// [gearN.measured]: of a gear, or of one that is not known and has no place in `gears`.
  std::array<std::shared_ptr<const IdentifyProblem>, 2> measured;
  std::vector<std::string> inherited;  ///< keys of gear 2 that are gear 1's: material, quality
};

/// Reads a spec from text. File names in it start at `folder`; empty: the working directory. What it
/// lacks, in itself and for `use`, is one error.
///
/// Throws    IoError when a file that it names is there and cannot be read
/// Errors    the key with its table ("gear1.normal_module_mm") for a field, its value, what is
///           allowed; syntax errors with line and column; unknown keys with the nearest known one
Result<JobSpec> read_spec(std::string_view text, SpecFormat format,
                          const std::filesystem::path& folder = {},
                          SpecUse use = SpecUse::geometry);

Result<JobSpec> read_spec(const SpecText& text, SpecUse use = SpecUse::geometry);

/// Both at once: read_spec_text() and what it says.
Result<JobSpec> read_spec_file(const std::filesystem::path& path);

}  // namespace gearwright
