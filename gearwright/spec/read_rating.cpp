#include "gearwright/spec/read_rating.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace gearwright {

namespace {

// One number stands for both gears.
std::optional<std::array<double, 2>> both(TableReader& t, const std::string& key) {
  const auto list = t.numbers(key);
  if (!list) return std::nullopt;
  for (const double v : *list) t.check(key, v);
  return std::array{list->front(), list->back()};
}

PinionMounting read_mounting(const Json& node) {
  TableReader t(rating_mounting_keys(), node, "rating.mounting");
  PinionMounting m;
  t.read(m);
  t.finish();
  if (2 * m.offset >= m.bearing_span && m.arrangement != PinionArrangement::c)
    t.fail("pinion_offset_mm",
           fmt::format("must be less than half of the bearing span {} mm; an overhung pinion is "
                       "arrangement = \"c\"",
                       format_number(m.bearing_span)));
  return m;
}

PlasticInput read_plastic(const Json& node) {
  TableReader t(rating_plastic_keys(), node, "rating.plastic");
  PlasticInput p;
  t.read(p);
  p.flank_temperature = both(t, "flank_temperature_C");
  p.root_temperature = both(t, "root_temperature_C");
  t.finish();
  return p;
}

std::vector<LoadBin> read_spectrum(TableReader& rating) {
  std::vector<LoadBin> spectrum;
  const Json* list = rating.any("spectrum");
  if (!list) return spectrum;
  if (!list->is_array() || list->empty() || list->size() > kMaxLoadBins) {
    rating.fail("spectrum", fmt::format("must be a list of 1 to {} tables, one for each step, "
                                        "[[rating.spectrum]]",
                                        kMaxLoadBins));
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string name = fmt::format("{}[{}]", rating.name("spectrum"), i + 1);
    if (!(*list)[i].is_object()) rating.fail("spectrum", "must be a list of tables");
    TableReader t(load_bin_keys(), (*list)[i], name);
    LoadBin bin;
    t.read(bin);
    t.finish();
    spectrum.push_back(bin);
  }
  return spectrum;
}

// Columns of one table: temperatures, and what a plastic has there.
void read_by_temperature(TableReader& t, MaterialInput& m) {
  const auto celsius = t.numbers("temperatures_C");
  for (std::size_t i = 0; celsius && i < celsius->size(); ++i) {
    t.check("temperatures_C", (*celsius)[i]);
    if (i > 0 && !((*celsius)[i - 1] < (*celsius)[i]))
      t.fail("temperatures_C", "must rise from one to the next");
  }
  const auto column = [&](const char* key, ByTemperature& list) {
    const auto values = t.numbers(key);
    if (!values || !celsius) return;
    if (values->size() != celsius->size())
      t.fail(key,
             fmt::format("has {} values for {} temperatures_C", values->size(), celsius->size()));
    for (std::size_t i = 0; i < values->size(); ++i) {
      t.check(key, (*values)[i]);
      list.push_back({(*celsius)[i], (*values)[i]});
    }
  };
  column("sigma_Hlim_by_temperature_MPa", m.sigma_Hlim_by);
  column("sigma_Flim_by_temperature_MPa", m.sigma_Flim_by);
  column("youngs_modulus_by_temperature_MPa", m.youngs_modulus_by);
}

}  // namespace

void read_rating(const Json& node, RatingTable& r) {
  TableReader t(rating_keys(), node, "rating");
  r.given = true;
  t.read(r);
  RatingInput& in = r.input;
  if (const auto q = both(t, "quality")) {
    for (const double grade : *q)
      if (grade != std::floor(grade))
        t.fail("quality", "must be whole numbers, grades of ISO 1328-1");
    in.quality = {static_cast<int>((*q)[0]), static_cast<int>((*q)[1])};
  }
  in.flank_roughness = both(t, "flank_roughness_um");
  in.root_roughness = both(t, "root_roughness_um");
  if (const auto rim = both(t, "rim_thickness_mm")) {
    in.rim = {(*rim)[0], (*rim)[1]};
    r.rim_thickness = std::min((*rim)[0], (*rim)[1]);
  }
  if (const Json* mounting = t.table("mounting")) {
    in.mounting = read_mounting(*mounting);
    if (in.face_load_factor)
      t.fail("face_load_factor",
             "has no place beside [rating.mounting], which makes it; leave one out");
  }
  if (const Json* plastic = t.table("plastic")) {
    if (in.edition != RatingEdition::vdi_2736)
      t.fail("plastic", "belongs to standard = \"VDI 2736:2014\"");
    in.plastic = read_plastic(*plastic);
  }
  if (const Json* material = t.table("material"))
    r.material = read_material(*material, t.name("material"));
  r.spectrum = read_spectrum(t);
  if (!r.spectrum.empty() && in.edition == RatingEdition::vdi_2736)
    t.fail("spectrum", "has no place in VDI 2736, whose strengths are given for one life");
  t.finish();
  if (!r.spectrum.empty()) {
    if (in.life_h) t.fail("life_h", "has no place beside a spectrum, whose steps have their hours");
    // Without a load of its own the rating shows the heaviest step.
    const LoadBin& worst =
        *std::max_element(r.spectrum.begin(), r.spectrum.end(),
                          [](const LoadBin& a, const LoadBin& b) { return a.torque < b.torque; });
    if (!r.torque && !r.power) r.torque = worst.torque;
    if (!in.speed) in.speed = worst.speed;
  }
  // Given twice is accepted where it agrees.
  constexpr double kWattPerKilowatt = 1000.0;
  if (r.power) {
    const double omega = *in.speed * 2 * std::numbers::pi / 60.0;
    const double torque = *r.power * kWattPerKilowatt / omega;
    if (r.torque && std::abs(torque - *r.torque) > 1e-9 * torque) {
      t.fail("torque_Nm", fmt::format("contradicts power_kW = {}, which is {} N m at this speed; "
                                      "leave one of them out",
                                      format_number(*r.power), format_number(torque, *r.torque)));
    }
    r.torque = torque;
  }
  in.torque = r.torque.value_or(0.0);
}

MaterialInput read_material(const Json& node, const std::string& path) {
  TableReader t(material_keys(), node, path);
  MaterialInput m;
  t.read(m);
  read_by_temperature(t, m);
  t.finish();
  const bool by_temperature = !m.sigma_Hlim_by.empty() || !m.sigma_Flim_by.empty();
  if (!m.name || m.sigma_Hlim || m.sigma_Flim || m.youngs_modulus || by_temperature) return m;
  std::vector<std::string> known;
  for (const NamedMaterial& row : named_materials()) known.emplace_back(row.name);
  if (std::find(known.begin(), known.end(), *m.name) == known.end()) {
    t.fail("name", fmt::format("is not in the shipped table; {}. Of any other material give the "
                               "values: kind, sigma_Hlim_MPa, sigma_Flim_MPa, and of a plastic "
                               "youngs_modulus_MPa",
                               word_hint(*m.name, known)));
  }
  return m;
}

}  // namespace gearwright
