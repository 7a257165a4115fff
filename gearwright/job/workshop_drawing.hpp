// Makes the workshop drawings of a job as PDF, SVG or DXF, with one sheet for each gear or rack.
// Internal to job/, the programs and tests.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/job/files.hpp"

namespace gearwright {

enum class SheetFormat { pdf, svg, dxf };

/// Returns the format for the extension of a file name, in upper or lower case. Returns none for
/// other extensions.
std::optional<SheetFormat> sheet_format(const std::filesystem::path& path);

struct WorkshopSheets {
  std::vector<Sheet> sheets;
  SheetSize size;
  std::string scales;   ///< "1:1, 1:2"
  double deviation_mm;  ///< greatest deviation of the drawn outlines from the exact ones
};

/// Returns the mass of a body of the job, kg, or none if its material has no density.
std::optional<double> mass_of(const SolvedJob& job, int which, const ToothedBody& body);

/// Makes one sheet for each gear or rack of the job whose number (1 or 2) is in `gears`.
/// `tolerance_mm` is the greatest deviation of the drawn outlines. If no size is given, the sheets
/// have the size A4. If a scale on A4 would be smaller than 1:2, and A3 enlarges the smallest
/// scale, all sheets have the size A3 instead.
///
/// Errors    the errors of make_body(), gear_sheet() and rack_sheet()
Result<WorkshopSheets> workshop_sheets(const SolvedJob& job, const std::vector<int>& gears,
                                       std::optional<SheetSize> size, double tolerance_mm);

/// Makes the file of workshop_sheets(), with the size and the tolerance of the options.
///
/// Domain    at least one gear (contract)
Result<JobFile> make_workshop_drawing(const SolvedJob& job, const std::vector<int>& gears,
                                      SheetFormat format, const std::filesystem::path& path,
                                      const FileOptions& options);

}  // namespace gearwright
