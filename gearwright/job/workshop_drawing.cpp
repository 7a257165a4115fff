#include "gearwright/job/workshop_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/job/drawing_data.hpp"

namespace gearwright {

namespace fs = std::filesystem;

std::optional<SheetFormat> sheet_format(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (ending == ".pdf") return SheetFormat::pdf;
  if (ending == ".svg") return SheetFormat::svg;
  if (ending == ".dxf") return SheetFormat::dxf;
  return std::nullopt;
}

namespace {

DrawingInput title_words(const SolvedJob& job) {
  DrawingInput words = job.spec.drawing;
  if (words.title.empty()) words.title = job.spec.title.empty() ? "Gear" : job.spec.title;
  return words;
}

const char* kind_of(SheetFormat format) {
  switch (format) {
    case SheetFormat::pdf: return "PDF drawing";
    case SheetFormat::svg: return "SVG drawing";
    case SheetFormat::dxf: return "DXF drawing";
  }
  contract_failed("postcondition", "known format of a drawing", __FILE__, __LINE__);
}

}  // namespace

Result<WorkshopSheets> workshop_sheets(const SolvedJob& job, const std::vector<int>& gears,
                                       SheetSize size, double tolerance_mm) {
  const DrawingInput words = title_words(job);
  WorkshopSheets all{{}, "", 0.0};
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const int which = gears[i];
    const auto body = make_body(job, which, false);
    if (!body) return body.error();
    GearSheetInput input{*body,
                         job.gear(which).reference_diameter,
                         job.gear(which).bore.has_value(),
                         drawing_data(job, which),
                         words,
                         fmt::format("{}/{}", i + 1, gears.size())};
    if (job.gears.size() > 1) input.words.title += fmt::format(", gear {}", which);
    const auto& material = job.spec.gear(which).material.name;
    if (words.material.empty() && material) input.words.material = *material;
    auto made = gear_sheet(input, size, tolerance_mm);
    if (!made) return of_body(made.error(), body->name);
    GearSheet sheet = std::move(made).take();
    all.scales += (i == 0 ? "" : ", ") + sheet.scale;
    all.deviation_mm = std::max(all.deviation_mm, sheet.deviation_mm);
    all.sheets.push_back(std::move(sheet.sheet));
  }
  return all;
}

Result<JobFile> make_workshop_drawing(const SolvedJob& job, const std::vector<int>& gears,
                                      SheetFormat format, SheetSize size, const fs::path& path,
                                      const FileOptions& options) {
  GW_EXPECTS(!gears.empty());
  if (options.on_file) options.on_file(path.filename().string());
  const auto made = workshop_sheets(job, gears, size, options.drawing_tolerance_mm);
  if (!made) return made.error();
  const DrawingInput words = title_words(job);
  const SheetWords about{words.title, words.author};
  std::string note = fmt::format("{}, scale {}", size == SheetSize::a4 ? "A4" : "A3", made->scales);
  const bool pdf = format == SheetFormat::pdf;
  const int unknown = pdf ? letters_not_in_pdf(made->sheets) : 0;
  if (unknown > 0)
    note += fmt::format(
        "; {} letters are not in the fonts of a PDF and appear as question "
        "marks",
        unknown);
  std::string bytes = pdf                          ? sheets_pdf(made->sheets, about)
                      : format == SheetFormat::svg ? sheets_svg(made->sheets, about)
                                                   : sheets_dxf(made->sheets);
  return JobFile{path, kind_of(format), made->deviation_mm, note, std::move(bytes)};
}

}  // namespace gearwright
