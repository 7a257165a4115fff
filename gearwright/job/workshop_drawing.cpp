#include "gearwright/job/workshop_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/cad/rack_sheet.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/job/drawing_data.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

DrawingInput title_words(const SolvedJob& job) {
  DrawingInput words = job.spec.drawing;
  if (words.title.empty()) words.title = job.spec.title.empty() ? "Gear" : job.spec.title;
  return words;
}

// Returns the textures of the surfaces. `flank` is the texture of the flanks if [drawing] gives
// none. For a surface that still has no texture, the texture of the title block applies, and the
// result is none. If the title block also gives no texture, the symbol of the surface is blank.
SurfaceRequirements textures(const DrawingInput& words, const std::string& flank) {
  const auto texture = [&](const std::string& own) {
    return own.empty() && !words.surface_texture.empty() ? std::nullopt : std::optional(own);
  };
  return {texture(words.flank_roughness.empty() ? flank : words.flank_roughness),
          texture(words.face_roughness), texture(words.bore_roughness), "", ""};
}

// If [drawing] has no texture of the flanks, but [rating] gives their Rz, this Rz is the texture.
SurfaceRequirements surfaces(const SolvedJob& job, int which) {
  std::string flank;
  const UnitSystem units = job.spec.units();
  if (const auto& Rz = job.spec.rating.input.flank_roughness) {
    const double um = (*Rz)[which == 1 ? 0 : 1];
    flank = "Rz " + short_decimals(value_in(units, Unit::um, um), digits_in(units, Unit::um, 3));
  }
  SurfaceRequirements required = textures(job.spec.drawing, flank);
  const auto runout = [&](const std::optional<double>& um) {
    return um ? short_decimals(value_in(units, Unit::mm, *um / kUmPerMm), 5) : "";
  };
  const ToleranceInput& tolerance = job.spec.gear(which).tolerance;
  required.tip_runout = runout(tolerance.tip_runout_um);
  required.face_runout = runout(tolerance.face_runout_um);
  return required;
}

// Returns the heat treatment of a material and its given hardness, for example "case-hardened, 700
// HV". Cast materials and plastics have no heat treatment.
std::string heat_treatment(const MaterialInput& material) {
  std::optional<MaterialKind> kind = material.kind;
  if (const auto row = material.name ? material_named(*material.name) : std::nullopt; row && !kind)
    kind = row->kind;
  std::string words;
  if (kind && *kind <= MaterialKind::nitrocarburized) {
    words = material_kind_words()[static_cast<std::size_t>(*kind)];
    std::replace(words.begin(), words.end(), '_', '-');
  }
  if (material.surface_hardness)
    words += fmt::format("{}{:g} HV", words.empty() ? "" : ", ", *material.surface_hardness);
  return words;
}

// Sets the material and the heat treatment of the title block. If [drawing] gives a material,
// `material` is not used.
void add_material(DrawingInput& words, const MaterialInput& material) {
  if (!words.material.empty()) return;
  words.material = material.name.value_or("");
  if (words.heat_treatment.empty()) words.heat_treatment = heat_treatment(material);
}

// The number of a sheet, and the drawing number of the mating part on this sheet.
struct SheetNumbers {
  std::string own, mate;
};

// Returns the numbers of a sheet. If the mating part is also drawn, its number consists of the
// numbers of the drawing and of its sheet. If it is not drawn, its number is unknown and stays
// blank.
SheetNumbers sheet_numbers(const SolvedJob& job, const std::vector<int>& parts, std::size_t sheet) {
  const auto name = [&](std::size_t i) { return fmt::format("{}/{}", i + 1, parts.size()); };
  SheetNumbers numbers{name(sheet), ""};
  const std::string& drawing = job.spec.drawing.number;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] != parts[sheet])
      numbers.mate = (drawing.empty() ? "sheet " : drawing + ", sheet ") + name(i);
  return numbers;
}

Result<GearSheet> sheet_of_gear(const SolvedJob& job, int which, const SheetNumbers& numbers,
                                SheetSize size, double tolerance_mm) {
  const auto body = make_body(job, which);
  if (!body) return body.error();
  const UnitSystem units = job.spec.units();
  const auto mass = mass_of(job, which, *body);
  GearSheetInput input{{title_words(job), gear_drawing_data(job, which, numbers.mate),
                        surfaces(job, which), numbers.own, units},
                       *body,
                       job.gear(which).reference_diameter,
                       job.spec.gear(which).tolerance.tip_fit.value_or("")};
  if (mass)
    input.mass =
        fmt::format("{:.3g} {}", value_in(units, Unit::kg, *mass), unit_text(units, Unit::kg));
  if (job.parts() > 1) input.words.title += fmt::format(", gear {}", which);
  add_material(input.words, job.spec.gear(which).material);
  auto made = gear_sheet(input, size, tolerance_mm);
  if (!made) return of_body(made.error(), body->name);
  return made;
}

// The spec gives no material of a rack, so the mass of the rack is unknown.
Result<GearSheet> sheet_of_rack(const SolvedJob& job, const SheetNumbers& numbers, SheetSize size,
                                double tolerance_mm) {
  const auto body = make_body(job, 2);
  if (!body) return body.error();
  RackSheetInput input{{title_words(job), rack_drawing_data(job, numbers.mate),
                        textures(job.spec.drawing, ""), numbers.own, job.spec.units()},
                       job.rack->rack};
  input.words.title += ", rack";
  auto made = rack_sheet(input, size, tolerance_mm);
  if (!made) return of_body(made.error(), body->name);
  return made;
}

// The entries are in the order of SheetFormat.
constexpr std::array kKinds{"PDF drawing", "SVG drawing", "DXF drawing"};

}  // namespace

std::optional<double> mass_of(const SolvedJob& job, int which, const ToothedBody& body) {
  const auto density = density_of(job.spec.gear(which).material);
  return density ? std::optional(metal_volume(body) * *density) : std::nullopt;
}

std::optional<SheetFormat> sheet_format(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  if (ending == ".pdf") return SheetFormat::pdf;
  if (ending == ".svg") return SheetFormat::svg;
  if (ending == ".dxf") return SheetFormat::dxf;
  return std::nullopt;
}

namespace {

struct ScaledSheets {
  WorkshopSheets sheets;
  double least_factor;  // smallest scale, mm on paper per mm on the gear
};

Result<ScaledSheets> sheets_of_size(const SolvedJob& job, const std::vector<int>& gears,
                                    SheetSize size, double tolerance_mm) {
  ScaledSheets scaled{{{}, size, "", 0.0}, kInfinity};
  WorkshopSheets& all = scaled.sheets;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    const SheetNumbers numbers = sheet_numbers(job, gears, i);
    auto made = gears[i] == 2 && job.rack
                    ? sheet_of_rack(job, numbers, size, tolerance_mm)
                    : sheet_of_gear(job, gears[i], numbers, size, tolerance_mm);
    if (!made) return made.error();
    GearSheet sheet = std::move(made).take();
    all.scales += (i == 0 ? "" : ", ") + sheet.scale;
    all.deviation_mm = std::max(all.deviation_mm, sheet.deviation_mm);
    all.sheets.push_back(std::move(sheet.sheet));
    scaled.least_factor = std::min(scaled.least_factor, sheet.factor);
  }
  return scaled;
}

}  // namespace

Result<WorkshopSheets> workshop_sheets(const SolvedJob& job, const std::vector<int>& gears,
                                       std::optional<SheetSize> size, double tolerance_mm) {
  constexpr double kReadable = 0.5;  // at the scale 1:2, teeth of usual modules are still distinct
  auto made = sheets_of_size(job, gears, size.value_or(SheetSize::a4), tolerance_mm);
  if (!made) return made.error();
  if (!size && made->least_factor < kReadable) {
    auto larger = sheets_of_size(job, gears, SheetSize::a3, tolerance_mm);
    if (!larger) return larger.error();
    if (larger->least_factor > made->least_factor) made = std::move(larger);
  }
  return std::move(made->sheets);
}

Result<JobFile> make_workshop_drawing(const SolvedJob& job, const std::vector<int>& gears,
                                      SheetFormat format, const std::filesystem::path& path,
                                      const FileOptions& options) {
  GW_EXPECTS(!gears.empty());
  if (options.on_file) options.on_file(path.filename().string());
  const auto made = workshop_sheets(job, gears, options.sheet, options.drawing_tolerance_mm);
  if (!made) return made.error();
  const DrawingInput words = title_words(job);
  const SheetWords about{words.title, words.author};
  std::string note =
      fmt::format("{}, scale {}", made->size == SheetSize::a4 ? "A4" : "A3", made->scales);
  const bool pdf = format == SheetFormat::pdf;
  const int unknown = pdf ? letters_not_in_pdf(made->sheets) : 0;
  if (unknown > 0)
    note += fmt::format(
        "; {} letters are missing in the fonts of the PDF and appear as question marks", unknown);
  std::string bytes = pdf                          ? sheets_pdf(made->sheets, about)
                      : format == SheetFormat::svg ? sheets_svg(made->sheets, about)
                                                   : sheets_dxf(made->sheets);
  return JobFile{path, kKinds[static_cast<std::size_t>(format)], made->deviation_mm, note,
                 std::move(bytes)};
}

}  // namespace gearwright
