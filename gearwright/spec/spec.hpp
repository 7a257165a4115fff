// Reads a spec file, which describes a gear or a pair as on a drawing, in TOML or JSON.
//
// Lengths are in mm, or in inch if the spec gives units = "inch". Angles are in degrees. The name
// of a key contains its unit. After reading, all lengths are in mm. Absent keys are also absent in
// the structs. job/solved_job.hpp computes the values that follow from the spec.
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
#include "gearwright/spec/missing_for.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

struct IdentifyProblem;  // inspection/identify.hpp
struct DriveInput;       // drive/drive.hpp
struct SpecTree;         // spec/parse_spec.hpp

struct JobSpec : SpecTables {
  std::string text;  ///< the text of the spec, for the report; JSON text if it was read from a tree
  /// The spec as a tree of tables, with the values that are copied from gear 1 to gear 2. Null if
  /// the spec was not read.
  std::shared_ptr<const SpecTree> tree;
  std::filesystem::path folder;             ///< file names in the spec are relative to it
  GivenKeys given;                          ///< the paths of the keys in the text
  std::shared_ptr<const DriveInput> drive;  ///< null if the spec has no drive
  std::optional<SearchProblem> search;
  /// The readings in [gearN.measured]. An unknown gear has readings but is not in `gears`.
  std::array<std::shared_ptr<const IdentifyProblem>, 2> measured;
  std::vector<std::string> inherited;  ///< keys of gear 2 copied from gear 1: material, quality

  UnitSystem units() const { return given.units; }  ///< units of the text and of answers
};

/// Reads a spec from text. File names are relative to `folder`, or to the working directory if
/// `folder` is empty. All missing inputs are reported as one error. They are the inputs that every
/// spec needs and the inputs that this `use` needs.
///
/// Throws    IoError if a named file exists and cannot be read
/// Errors    the key with its table ("gear1.normal_module_mm") as the field, its value, and the
///           permitted values; syntax errors with line and column; an unknown key with the nearest
///           known key
Result<JobSpec> read_spec(std::string_view text, SpecFormat format,
                          const std::filesystem::path& folder = {},
                          SpecUse use = SpecUse::geometry);

Result<JobSpec> read_spec(const SpecText& text, SpecUse use = SpecUse::geometry);

/// Returns the error of a spec in inch for a feature whose results are only in mm. For a spec in
/// mm, returns nothing.
std::optional<Error> only_in_mm(const JobSpec& spec, std::string_view feature);

/// Reads the text of the file with read_spec_text(), then the spec.
Result<JobSpec> read_spec_file(const std::filesystem::path& path);

}  // namespace gearwright
