// Makes the data tables of workshop drawings. Internal to job/.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/cad/gear_sheet.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// Determines whether the sign of a helix angle or lead is written. A drawing gives the hand
/// instead of the sign.
enum class Sign { kept, dropped };

/// A record, and the same record at the lower and at the upper end of its tolerances.
struct Records {
  ValueRecord nominal;
  UnitSystem units;
  std::vector<ValueRecord> ends{};  ///< values at both tolerance ends; empty without tolerances

  /// Returns the text of the member with this path. If one of its values at the two tolerance ends
  /// is not printed like the nominal value, the text contains these limits instead of the nominal
  /// value. Returns none if the member has no value.
  std::optional<std::string> value(std::string_view path, Sign sign = Sign::kept) const;
  /// True if a value of the member with this path at a tolerance end is not printed like the
  /// nominal value.
  bool has_limits(std::string_view path) const;

 private:
  std::optional<std::string> between(const QuantityInfo& info, std::string_view path) const;
};

/// Adds a row for the member with this path, with its label and its symbol. Does nothing if the
/// member has no value.
void add_data(DataGroup& group, const Records& records, std::string_view path,
              Sign sign = Sign::kept);

/// Adds the row of the module or, in inch, of the diametral pitch.
void add_module(DataGroup& group, const Records& records, double normal_module);

/// Returns the name of the standard basic rack of a gear in the spec, for example "AGMA-20". The
/// default is "ISO 53-A".
std::string rack_name(const JobSpec& spec, int which);

/// Adds the distances of the rack from the axis of its pinion, and the backlash.
///
/// Domain    the job has a rack (contract)
void add_rack_mounting(DataGroup& group, const SolvedJob& job);

/// Returns the tables of a gear. If the spec does not give a value that a drawing needs, its row is
/// blank, so that the workshop can fill it in. Examples are the limits of the tip diameter, the
/// tolerance of the tooth thickness and the flank tolerance class.
std::vector<DataGroup> gear_drawing_data(const SolvedJob& job, int which,
                                         const std::string& number_of_mate);

/// Returns the tables of the rack.
///
/// Domain    the job has a rack (contract)
std::vector<DataGroup> rack_drawing_data(const SolvedJob& job, const std::string& number_of_pinion);

}  // namespace gearwright
