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
#include "gearwright/design/search_problem.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/spec/compensate_input.hpp"
#include "gearwright/spec/contact_input.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

struct GearInput;

/// [gearN] cut_by: the pinion cutter, and how deep it goes.
struct CutByInput {
  int gear = 0;                             ///< 1 or 2: that gear, finished; 0: a cutter of its own
  std::shared_ptr<const GearInput> cutter;  ///< [gearN.cut_by]
  std::optional<double> profile_shift_pair;  ///< e: shift of the cutter and of the gear together
  std::optional<double> module,
      pressure_angle;  ///< mm, degrees; given though they are the cutter's
};

/// [gear1], [gear2]: the gear's numbers; `cylindrical.profile_shift` is used once `profile_shift`
/// is known.
struct GearInput {
  CylindricalSpec cylindrical;
  std::optional<double> profile_shift;    ///< x
  bool helix_given = false;               ///< else 0 for a gear, and an unknown for `fit`
  bool face_width_given = false;          ///< else 10 m_n, and a warning says so
  std::optional<BaseGear<double>> basic;  ///< [gearN.basic], as given; module, helix, shift follow
  std::optional<CutByInput> cut_by;       ///< none: cut by its rack
  std::optional<double> tip_clearance;    ///< [gearN.tip_fillet] clearance_mm, to the mate's root
  bool tip_clearance_by_rule = false;     ///< [gearN.tip_fillet] without a number: 0.2 m_n + 0.05
  std::optional<double> chord_diameter;   ///< [gearN.measure] chord_diameter_mm
  std::vector<std::string> not_read;      ///< sub-tables of verbs that are not in this version
  std::optional<Bore> bore;
  std::array<FlankModifications, 2> modifications;  ///< right flank, left flank
};

/// [pair]
struct PairInput {
  std::optional<double> center_distance;  ///< a  mm
  Mounting mounting = Mounting::tight;
  bool shorten_tips = false;  ///< tips cut back by k m_n, where no tip diameter is given
  std::optional<double> shaft_angle_deg;       ///< Σ, signed
  std::optional<double> friction_coefficient;  ///< μ
};

/// [fit]
struct FitInput {
  std::optional<double> normal_pressure_angle_deg;  ///< α_wn of the designs wanted
  bool few_teeth = false;  ///< a pinion with circular fillets and the wheel it cuts
  std::optional<double> min_tip_land, min_gap, clearance, backlash;  ///< mm, of few_teeth
  std::optional<double> contact_ratio;                                   ///< total, of few_teeth
};

struct JobSpec {
  std::string text;  ///< the spec as read, for the report
  std::string tree;  ///< the same as a tree of tables, in JSON
  std::string title;
  std::array<std::optional<GearInput>, 2> gears;  ///< without the first only beside a search
  PairInput pair;
  FitInput fit;
  ErrorsInput errors;
  ContactInput contact;
  CompensateInput compensate;
  std::optional<SearchProblem> search;
  bool shaft_angle_found = false;     ///< not given: it followed from the centre distance
  std::vector<std::string> not_read;  ///< tables and keys of verbs that are not in this version
};

enum class SpecFormat { toml, json };

/// Reads a spec from text. File names in it start at `folder`; empty: the working directory.
///
/// Throws    IoError when a file that it names is there and cannot be read
/// Errors    the key with its table ("gear1.normal_module_mm"), its value, what is allowed; syntax
///           errors with line and column; unknown keys with the nearest known one
Result<JobSpec> read_spec(std::string_view text, SpecFormat format,
                          const std::filesystem::path& folder = {});

/// Reads a spec file; JSON when its name ends in .json. File names in it start at its folder, those
/// of a pipe at the working directory.
///
/// Throws    IoError when the file cannot be read
/// Errors    as read_spec; files over kMaxSpec bytes are refused unread
Result<JobSpec> read_spec_file(const std::filesystem::path& path);

constexpr std::size_t kMaxSpec = 4 << 20;  ///< bytes: no drawing has that many numbers

}  // namespace gearwright
