#include "gearwright/arrange/given_pair.hpp"

#include <fmt/format.h>

#include "gearwright/base/error.hpp"

namespace gearwright {

namespace {

constexpr double kPerCubicMillimetre = 1e-9;

// Returns the material of the table that has the given name or, if the table does not contain the
// name, the given kind. The given values of the material are not used. Returns none for a plastic,
// or if neither the name nor a kind determines a material.
std::optional<Material> usual_material(const MaterialInput& given) {
  if (given.kind == MaterialKind::plastic) return std::nullopt;
  const auto row = given.name ? material_named(*given.name) : std::nullopt;
  return row || !given.kind ? row : material_of_kind(*given.kind);
}

}  // namespace

std::optional<double> density_of(const MaterialInput& given) {
  if (given.density) return *given.density * kPerCubicMillimetre;
  const auto usual = usual_material(given);
  return usual ? usual->density : std::nullopt;
}

Result<double> youngs_modulus_of(const MaterialInput& given, const std::string& owner) {
  if (given.youngs_modulus) return *given.youngs_modulus;
  if (given.kind == MaterialKind::plastic)
    return absent_input(owner + ".youngs_modulus",
                        "; give the value of this plastic, because the default applies to steel");
  return usual_material(given).value_or(Material{}).youngs_modulus;
}

Result<Material> material_of(const MaterialInput& given, const std::string& owner,
                             RatingEdition edition) {
  const bool plastic = given.kind == MaterialKind::plastic;
  Material m = given.kind ? material_of_kind(*given.kind).value_or(Material{}) : Material{};
  if (plastic) m.density.reset();
  if (given.name) {
    const auto row = material_named(*given.name, given.surface_hardness);
    const auto listed = material_named(*given.name);
    if (!row && listed && !(given.sigma_Hlim && given.sigma_Flim)) {
      return refused(owner + ".surface_hardness", *given.surface_hardness,
                     "is outside the range of ISO 6336-5 for this material; give `sigma_Hlim` and "
                     "`sigma_Flim` of the material");
    }
    if (row || listed) m = row ? *row : *listed;
    m.name = *given.name;
  }
  if (given.kind) m.kind = *given.kind;
  if (given.sigma_Hlim || given.sigma_Flim) m.from_table = false;
  if (given.sigma_Hlim) m.sigma_Hlim = *given.sigma_Hlim;
  if (given.sigma_Flim) m.sigma_Flim = *given.sigma_Flim;
  if (given.poisson_ratio) m.poisson_ratio = *given.poisson_ratio;
  if (given.density) m.density = *given.density * kPerCubicMillimetre;
  if (given.surface_hardness) m.hardness_HV = given.surface_hardness;
  if (given.yield_strength) m.yield_strength = given.yield_strength;
  m.sigma_Hlim_by = given.sigma_Hlim_by;
  m.sigma_Flim_by = given.sigma_Flim_by;
  m.youngs_modulus_by = given.youngs_modulus_by;
  if (!m.has_strengths()) {
    return absent_input(
        m.has_flank_strength() ? owner + ".sigma_Flim"
        : given.name           ? owner + ".sigma_Hlim"
                               : owner,
        fmt::format("; a rating needs the strength of the material. Give the name of a listed "
                    "material, for example name = \"16MnCr5\", or give `material.kind`, "
                    "`material.sigma_Hlim` and `material.sigma_Flim`. If `{}` is absent, the "
                    "material of gear 1 applies to both gears",
                    gear_field(2, "material")));
  }
  const bool by_temperature =
      !m.sigma_Hlim_by.empty() || !m.sigma_Flim_by.empty() || !m.youngs_modulus_by.empty();
  if (by_temperature && !plastic)
    return Error{owner + ".temperatures", "", "is used only with a `kind` of \"plastic\""};
  if (plastic && edition != RatingEdition::vdi_2736) {
    return Error{owner + ".kind", "plastic",
                 "is not covered by ISO 6336; to rate plastics by VDI 2736, give `rating.edition` "
                 "= \"VDI 2736:2014\""};
  }
  if (!m.youngs_modulus_by.empty()) return m;
  const auto E = youngs_modulus_of(given, owner);
  if (!E) return E.error();
  m.youngs_modulus = *E;
  return m;
}

namespace {

bool of_arcs(const GearInput& gear) { return !is_straight(gear.cylindrical.rack); }

bool cuts_with_arcs(const GearInput& gear) {
  return gear.cut_by && gear.cut_by->cutter && of_arcs(*gear.cut_by->cutter);
}

}  // namespace

bool has_arcs(const GearInput& gear) { return of_arcs(gear) || cuts_with_arcs(gear); }

bool has_arcs(const GivenPair& given) {
  for (const auto& gear : given.gears)
    if (gear && has_arcs(*gear)) return true;
  return false;
}

std::optional<Error> check_arcs(const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->cut_by) continue;
    const GearInput* const cutter = given.find(3 - which);
    const bool by_mate = gear->cut_by->gear != 0 && cutter && of_arcs(*cutter);
    if (!by_mate && !cuts_with_arcs(*gear)) continue;
    return Error{
        gear_field(which, "cut_by"), "",
        "a gear with circular-arc teeth cannot be a pinion cutter; give this gear its own rack"};
  }
  if (!given.gears[1]) return std::nullopt;
  if (given.pair.shaft_angle && given.pair.shaft_angle->rad() != 0.0) {
    return refused("pair.shaft_angle", given.pair.shaft_angle->deg(),
                   "circular-arc gears run on parallel axes only; leave out this key");
  }
  if (given.pair.shorten_tips) {
    return Error{"pair.shorten_tips", "true",
                 "is not available for circular-arc gears, which have no profile shifts; give "
                 "`gear1.tip_diameter` and `gear2.tip_diameter` instead"};
  }
  return std::nullopt;
}

}  // namespace gearwright
