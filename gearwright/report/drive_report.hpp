// Writes one HTML page about a whole drive: verdict, scheme, sections of the drive with the control
// that turns the gears, power, phases, and finally each mesh as a pair of gears.
//
// The page depends only on its input. The laws of report_html() hold for this page too.
#pragma once

#include <string>
#include <vector>

#include "gearwright/drive/drive_layout.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

struct DriveReportInput {
  std::string title;  ///< if empty, a title is made from the tooth numbers
  const Drive* drive = nullptr;
  const DrivePlaces* places = nullptr;  ///< null if the axes cannot be placed; there is no scheme
  const DriveLayout* layout = nullptr;  ///< null if the drive cannot be assembled
  std::string why_no_layout;            ///< if `layout` is null, the reason, as a sentence
  Verdict verdict;
  std::vector<ReportFile> files;
  std::string spec_text;              ///< the spec, verbatim; left out if empty
  UnitSystem units = UnitSystem::mm;  ///< units of tables and sentences
  std::string version;                ///< version of the program
};

/// The page, UTF-8.   Domain  a drive (contract)
std::string drive_report_html(const DriveReportInput& input);

}  // namespace gearwright
