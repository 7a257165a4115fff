// Reads and writes REXS files, the exchange format of gear units. A file contains components with
// attributes, and relations between components. Internal to spec/ and job/.
//
// The format follows the public schemas of REXS 1.0 to 2.0 (rexs.info). A file is XML, JSON, or a
// ZIP archive with a file in one of these formats. XML is read by Boost.PropertyTree.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct RexsComponent {
  std::string id;
  std::string type;  ///< "cylindrical_gear"
  std::string name;
  /// The attributes as text. Only plain values and lists with a single element are stored.
  std::map<std::string, std::string, std::less<>> attributes{};
  std::map<std::string, std::string, std::less<>> units{};

  /// Returns the value of an attribute, or nothing if it is absent or not a decimal number.
  std::optional<double> number(std::string_view attribute) const;
  std::optional<std::string> text(std::string_view attribute) const;
  void set(const std::string& attribute, double value, const std::string& unit);
  void flag(const std::string& attribute);  ///< sets the attribute to "true"
};

struct RexsRelation {
  std::string type;                                         ///< "stage"
  std::vector<std::pair<std::string, std::string>> refs{};  ///< role and id of a component

  /// Returns the id of the component with this role, or an empty text.
  std::string_view of(std::string_view role) const;
  bool names(std::string_view id) const;
};

struct RexsModel {
  std::string version;
  std::string application;
  std::vector<RexsComponent> components{};
  std::vector<RexsRelation> relations{};

  /// Returns the component with this id, or null if there is none.
  const RexsComponent* find(std::string_view id) const;
  std::vector<const RexsComponent*> of_type(std::string_view type) const;
  /// Returns the first component whose type is one of `types` and that shares a relation with the
  /// component `id`. The type of the relation must be one of `relations`. Returns null if there is
  /// no such component.
  const RexsComponent* related(std::string_view id,
                               std::initializer_list<std::string_view> relations,
                               std::initializer_list<std::string_view> types) const;
};

/// Returns the model of a file, without its tables and its lists of several values.
///
/// Text that begins with a brace is JSON, and other text is XML. A ZIP archive contains one such
/// file.
///
/// Errors    text that is neither XML nor JSON, with the place of the error; a root element other
///           than `model`; a version other than 1.x and 2.0; deep nesting; an archive that is
///           damaged, encrypted or too large, or that does not contain exactly one REXS file
Result<RexsModel> read_rexs(std::string_view file);

/// True if spec_of_rexs() reads this attribute of the component as a number.
bool is_rexs_number(const RexsComponent& component, std::string_view attribute);

/// Returns an error if an attribute that is read as a number is not a decimal number or has another
/// unit than REXS specifies for it, or if a number of teeth is not whole or is too large. The error
/// names the component, the attribute and the value. An attribute without a unit has its usual unit.
std::optional<Error> rexs_number_error(const RexsComponent& component);

/// Returns the ids of the components that are connected with a cylindrical stage by relations. A
/// connection through the gear unit, which contains all parts, does not count. spec_of_rexs() reads
/// numbers of these components only.
std::set<std::string, std::less<>> rexs_parts_of_stages(const RexsModel& model);

/// True if the name ends in .rexs (XML), .rexsj (JSON) or .rexsz (a ZIP archive).
bool is_rexs(const std::filesystem::path& path);

/// Returns the model as the bytes of a file with this name. Reading the file gives exactly the
/// doubles of the model.
///
/// Domain    ids that are whole numbers, and attributes that are numbers or flags
std::string rexs_bytes(const RexsModel& model, const std::filesystem::path& path);

// Converts a REXS model to a spec. One cylindrical stage becomes a pair, a planetary stage becomes
// [planetary], and a chain of such stages becomes [[stage]] tables. Internal to spec/ and job/.

struct RexsSpec {
  Json tables;
  std::vector<std::string> notes;  ///< one sentence about each part that was not read
};

/// Errors    those of rexs_number_error() for the parts of cylindrical stages; a model without
///           cylindrical stages, or with stages of another type; stages that form neither a chain
///           nor planetary sets (rexs_chain, set_of_rexs); members of a planetary set with different
///           modules or pressure angles; a stage without two gears; a gear without a number of teeth
Result<RexsSpec> spec_of_rexs(const RexsModel& model);

/// Returns the spec as TOML. Comments at its beginning name the version of the file and the parts
/// that were not read.
Result<std::string> spec_text_of_rexs(std::string_view file);

}  // namespace gearwright
