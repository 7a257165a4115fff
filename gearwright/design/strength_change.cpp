#include "gearwright/design/strength_change.hpp"

#include <algorithm>
#include <random>

#include "gearwright/base/contract.hpp"
#include "gearwright/design/design_strength.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright::detail {

namespace {

// Makes a Knob for the face width. It changes the greatest width of a band, or the given width.
Knob wider_face(const char* field, std::optional<std::array<double, 2>> SearchProblem::*member,
                const std::array<double, 2>& band, double far) {
  const bool one = band[0] == band[1];
  return {field,
          band[1],
          far,
          band[1],
          Knob::Kind::limit,
          [=](SearchProblem& q, double v) {
            q.*member = {one ? v : band[0], v};
          },
          [=](double v) { return one ? shown(v) : "[" + shown(band[0]) + ", " + shown(v) + "]"; }};
}

}  // namespace

void add_strength_knobs(const SearchProblem& p, std::vector<Knob>& k) {
  GW_EXPECTS(p.rating.has_value());
  constexpr double kLightest = 1e-3;  // fraction of the given load; to propose an even smaller load
                                      // would not be useful
  add_limit(p, k, "limits.safety_flank", &SearchLimits::safety_flank, 0.0);
  add_limit(p, k, "limits.safety_root", &SearchLimits::safety_root, 0.0);
  const double torque = p.rating->input.torque;
  const auto &power = p.rating->power_kW, &output = p.rating->output_torque;
  const double load = power ? *power : output.value_or(torque);
  k.push_back({power    ? "rating.power"
               : output ? "rating.output_torque"
                        : "rating.torque",
               load, kLightest * load, load, Knob::Kind::limit,
               [=, on_output = output.has_value()](SearchProblem& q, double v) {
                 if (on_output)
                   q.rating->output_torque = v;
                 else
                   q.rating->input.torque = torque * (v / load);
               }});
  // If helix angles were chosen for the face widths, other face widths would require other trials.
  if (!p.choices.empty()) return;
  constexpr double kWidest = 4.0;
  if (const auto& band = p.face_width)
    k.push_back(wider_face("face_width", &SearchProblem::face_width, *band, kWidest * (*band)[1]));
  if (const auto& band = p.face_diameters)
    k.push_back(
        wider_face("face_diameters", &SearchProblem::face_diameters, *band, kWidest * (*band)[1]));
  if (p.face_modules || (!p.face_width && !p.face_diameters)) {
    const auto band = p.face_modules.value_or(std::array{kFaceModules, kFaceModules});
    k.push_back(wider_face("face_modules", &SearchProblem::face_modules, band,
                           std::max(band[1], kMostFaceModules)));
  }
}

std::vector<Material> stronger_steels(const SearchRating& rating) {
  std::vector<Material> steels;
  if (rating.input.edition == RatingEdition::vdi_2736) return steels;
  const Material& now = rating.input.materials[0];
  for (const std::string_view name : kSteelsByStrength) {
    const Material steel = *material_named(name);
    if (steel.sigma_Hlim > now.sigma_Hlim || steel.sigma_Flim > now.sigma_Flim)
      steels.push_back(steel);
  }
  return steels;
}

std::optional<DesignRow> safest_design(const SearchProblem& problem, const SearchWatch& watch,
                                       std::int64_t most_questions) {
  const Search search(problem);
  std::vector<std::int64_t> order;
  search.candidates([&](const Trial& t) {
    order.push_back(t.index);
    return true;
  });
  std::mt19937_64 random(1);
  std::optional<DesignRow> best;
  double most = 0.0;
  for (std::size_t i = 0; i < order.size() && static_cast<std::int64_t>(i) < most_questions; ++i) {
    if (watch && !watch(1)) break;
    std::swap(order[i], order[i + random() % (order.size() - i)]);
    const auto row = design_row(search.graph(search.space().trial(order[i])), RegionDetail::point);
    const auto least = row ? least_safety(problem, *row) : std::nullopt;
    if (!least || *least <= most) continue;
    most = *least;
    best = row;
  }
  return best;
}

}  // namespace gearwright::detail
