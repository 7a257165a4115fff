#include "gearwright/job/rating_answer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

// The named row of the table first, then whatever stands beside the name.
Result<Material> material_of(const MaterialInput& given, int which) {
  const std::string table = gear_field(which, "material");
  Material m;
  if (given.name) {
    const auto row = material_named(*given.name, given.surface_hardness);
    const bool in_table = material_named(*given.name).has_value();
    if (!row && in_table && !(given.sigma_Hlim && given.sigma_Flim)) {
      return refused(table + ".surface_hardness", *given.surface_hardness,
                     "is off the line of ISO 6336-5 for this material; give its "
                     "`sigma_Hlim` and `sigma_Flim`");
    }
    if (row) m = *row;
    m.name = *given.name;
  }
  if (given.kind) m.kind = *given.kind;
  if (given.sigma_Hlim || given.sigma_Flim) m.from_table = false;
  if (given.sigma_Hlim) m.sigma_Hlim = *given.sigma_Hlim;
  if (given.sigma_Flim) m.sigma_Flim = *given.sigma_Flim;
  if (given.youngs_modulus) m.youngs_modulus = *given.youngs_modulus;
  if (given.poisson_ratio) m.poisson_ratio = *given.poisson_ratio;
  constexpr double kPerCubicMillimetre = 1e-9;
  if (given.density) m.density = *given.density * kPerCubicMillimetre;
  if (given.surface_hardness) m.hardness_HV = given.surface_hardness;
  if (given.yield_strength) m.yield_strength = given.yield_strength;
  if (!(m.sigma_Hlim > 0.0) || !(m.sigma_Flim > 0.0)) {
    return Error{m.sigma_Hlim > 0.0 ? table + ".sigma_Flim"
                 : given.name       ? table + ".sigma_Hlim"
                                    : table,
                 "",
                 "is missing; a rating needs the material's strength: `name` of the shipped table, "
                 "or `kind`, `sigma_Hlim` and `sigma_Flim`"};
  }
  if (m.kind == MaterialKind::plastic) {
    return Error{table + ".kind", "plastic",
                 "is not a material of ISO 6336; plastics are rated by VDI 2736, which is not in "
                 "this version"};
  }
  return m;
}

void warn_of_limits(SolvedJob& job, const Rating& rating) {
  for (const int which : {1, 2}) {
    if (!job.gears[static_cast<std::size_t>(which - 1)].spec.root_fillet) continue;
    job.warnings.push_back({"rating_root_fillet",
                            "The root's circular arc is not in the standard: Y_F and Y_S are those "
                            "of the root that the rack would have cut.",
                            which});
  }
  for (const RatingLimit& limit : rating.limits)
    job.warnings.push_back({limit.code, limit.text, limit.gear});
}

}  // namespace

RatingView RatingAnswer::view() const {
  const double ratio = std::abs(static_cast<double>(pair.gears[pair.place(2)].teeth) /
                                pair.gears[pair.place(1)].teeth);
  const double n = input.speed.value_or(0.0);
  return {input,
          rating,
          input.torque * n * 2 * std::numbers::pi / 60.0 / 1000.0,
          {input.torque, input.torque * ratio},
          {n, n / ratio},
          spectrum,
          torque_holding,
          face_holding};
}

Result<RatingAnswer> answer_rating(SolvedJob& job) {
  const RatingTable& table = job.spec.rating;
  if (!table.given) {
    return Error{"rating", "",
                 "is missing; a rating asks for the load and what the gears are made of: [rating] "
                 "and [gear1.material], [gear2.material]"};
  }
  const InvolutePair* pair = job.pair->involute();
  if (!pair) {
    return Error{"gear1.rack", "", "cuts circular arcs; ISO 6336 rates involute gears only"};
  }
  RatingAnswer answer;
  answer.input = table.input;
  std::array<double, 2> bore{};
  for (const int which : {1, 2}) {
    const auto i = static_cast<std::size_t>(which - 1);
    auto material = material_of(job.spec.gears[i]->material, which);
    if (!material) return material.error();
    answer.input.materials[i] = std::move(material).take();
    if (const auto given = job.bore(which)) bore[i] = given->diameter;
  }
  auto rated = rated_pair(*pair, bore);
  if (!rated) return rated.error();
  answer.pair = *rated;
  if (table.web_thickness) {
    answer.input.body = RatedBody{*table.web_thickness / rated->face_width,
                                 *table.rim_thickness / rated->normal_module};
  }
  auto made = rate(answer.pair, answer.input);
  if (!made) return made.error();
  answer.rating = std::move(made).take();
  answer.wanted = {table.safety_flank_min.value_or(1.0), table.safety_root_min.value_or(1.0)};
  if (!table.spectrum.empty()) {
    auto whole = rate_spectrum(answer.pair, answer.input, table.spectrum);
    if (!whole) return whole.error();
    answer.spectrum = *whole;
  }
  answer.torque_holding = torque_of_safety(answer.pair, answer.input, answer.wanted);
  answer.face_holding = face_width_of_safety(answer.pair, answer.input, answer.wanted,
                                             kMostFaceModules * answer.pair.normal_module);
  warn_of_limits(job, answer.rating);
  return answer;
}

}  // namespace gearwright
