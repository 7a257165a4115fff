#include "gearwright/arrange/loaded_pair.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/rating/dynamic.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright {

namespace {

constexpr double kFullLineLoad = 100;  // N/mm; for smaller line loads, the standard reduces the
                                       // stiffness

// Returns σ_F0 of gears 1 and 2 under a tangential force of 1 N.
std::optional<std::array<double, 2>> nominal_per_newton(const RatedPair& pair) {
  constexpr RatingEdition kEdition = RatingEdition::iso_2006;
  std::array<double, 2> list{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto section = critical_section(pair, pair.gears[i]);
    if (!section) return std::nullopt;
    list[i] = form_factor(kEdition, pair, *section).value *
              stress_correction_factor(*section).value * root_helix_factor(kEdition, pair).value /
              (root_face_width(pair, pair.gears[i]) * pair.normal_module);
  }
  return turned(pair, list);
}

}  // namespace

std::vector<LoadStandard> load_standard(const Arranged& arranged, const LoadAnalysis& answer) {
  if (answer.contact->regime == LoadRegime::point) return {};
  const auto rated = rated_pair(*arranged.pair);
  if (!rated) return {};
  const auto& [one, two] = answer.compliance->bodies;
  const double elasticity = relative_elasticity(one.youngs_modulus, two.youngs_modulus);
  const RatedGear& first = rated->gears[rated->place(1)];
  const auto nominal = nominal_per_newton(*rated);
  std::vector<LoadStandard> list;
  for (const LoadedTorque& t : answer.contact->torques) {
    const double force = 2 * t.torque / first.reference_diameter;
    LoadStandard s;
    const auto under = [&](double line_load) {
      return mesh_stiffness(*rated, line_load, elasticity, std::nullopt).c_gamma_alpha.value;
    };
    s.stiffness = under(force / rated->face_width);
    s.low_load = std::max(1.0, under(kFullLineLoad) / s.stiffness);
    if (nominal) s.root_stress = {force * (*nominal)[0], force * (*nominal)[1]};
    list.push_back(s);
  }
  return list;
}

namespace {

constexpr double kWorthANote = 0.25;  // least relative difference from c_γα that causes a note
constexpr double kFactor = 0.03;      // a factor within this distance of 1 is not mentioned
// The ratio of the computed stiffness to the stiffness of the standard is the product of the
// factors of the known effects and a remaining factor. If the remaining factor differs from 1
// by more than kMuchLeft, the factors of face width and bodies are computed as well.
constexpr double kMuchLeft = 0.1;
constexpr double kOverlap = 2.0;  // overlap ratio to which a narrow helical face, ε_β < 1, is
                                  // widened
constexpr double kWidest = 12.0;  // modules, limit of the widened face; a wider face takes more
                                  // time and gives the same ratio
constexpr double kLeastWider = 1.2;
constexpr double kThickRim = 8.0;  // modules; an internal gear with this rim counts as solid
constexpr int kPositions = 8, kMostSlices = 16;  // resolution of drafted()

struct StiffnessFactor {
  std::string of;
  double value;
};

double mean_stiffness(const ContactPair& pair, const Gear& gear_1, const Gear& gear_2,
                      const PairCompliance& compliance, LoadRequest request, double torque) {
  request.torques = {torque};
  request.root_stress = false;
  request.progress = nullptr;
  return loaded_contact(pair, gear_1, gear_2, compliance, request.undeflected())
      .torques.front()
      .without_twist.mean;
}

bool has_modifications(const ContactSetup& setup) {
  for (const int which : {1, 2})
    for (const bool left : {false, true})
      if (const RemovalField* removal = setup.removal(which, left); removal && !removal->none())
        return true;
  return false;
}

// Returns the pair without errors and modifications.
ContactPair bare_pair(const LoadTask& task, const Gear& gear_1, const Gear& gear_2) {
  ContactMount place = task.setup.place();
  place.errors = ContactErrors();
  place.gear2_drives = task.gear2_drives;
  return ContactPair({&gear_1, {}}, {&gear_2, {}}, place);
}

double solid_body(const Gear& gear) {
  return gear.internal() ? gear.root_diameter + 2 * kThickRim * gear.spec.normal_module
                         : kShaft * gear.root_diameter;
}

// Returns the stiffness of the pair without errors and modifications. The faces are wider by the
// factor `wider`, and the line load is the same. If `solid` is true, the bodies are solid. The
// accuracy is low, but sufficient for ratios. Returns NaN if no such pair can be computed.
double drafted(const LoadTask& task, double torque, double wider, bool solid) {
  std::array<Gear, 2> gears{task.setup.gear(1), task.setup.gear(2)};
  LoadRequest request = task.request.undeflected();
  for (std::size_t g = 0; g < 2; ++g) {
    gears[g].spec.face_width *= wider;
    if (solid) request.bodies[g].bore_diameter = solid_body(gears[g]);
  }
  request.accuracy = ComplianceAccuracy::draft;
  request.rotations.clear();
  request.positions = kPositions;
  request.root_stress = false;
  request.progress = nullptr;
  request.slices = fair_slices(gears[0], gears[1], request.regime);
  for (int& count : request.slices) count = std::min(count, kMostSlices);
  const auto compliance = pair_compliance(gears[0], gears[1], request);
  if (!compliance) return kNoNumber;
  return mean_stiffness(bare_pair(task, gears[0], gears[1]), gears[0], gears[1], *compliance,
                        request, torque * wider);
}

// Adds the effect of a narrow helical face, and the effect of bodies that are held at a diameter
// other than that of solid bodies. Both effects need new compliance tables.
void add_of_shape(const LoadTask& task, const InvolutePair& pair, double torque,
                  std::vector<StiffnessFactor>& factors) {
  const std::array<const Gear*, 2> gears{&task.setup.gear(1), &task.setup.gear(2)};
  const double overlap = pair.mesh.overlap_ratio;
  const double face = std::max(gears[0]->spec.face_width, gears[1]->spec.face_width);
  const double wider =
      overlap > 0.0 && overlap < 1.0
          ? std::min(kOverlap / overlap, kWidest * gears[0]->spec.normal_module / face)
          : 1.0;
  const bool narrow = wider >= kLeastWider;
  bool solid = true;
  for (std::size_t g = 0; g < 2; ++g)
    solid = solid &&
            std::abs(task.request.bodies[g].bore_diameter / solid_body(*gears[g]) - 1) < kFactor;
  if (!narrow && solid) return;
  const double as_is = drafted(task, torque, 1.0, false);
  const double wide = narrow ? drafted(task, torque, wider, false) : as_is;
  if (narrow)
    factors.push_back(
        {fmt::format("the free ends of a narrow helical face (overlap ratio {:.2f})", overlap),
         as_is / wide});
  if (!solid)
    factors.push_back({"bodies held at another diameter than half the root diameter",
                       wide / drafted(task, torque, narrow ? wider : 1.0, true)});
}

std::vector<StiffnessFactor> factors_of(const Arranged& arranged, const LoadTask& task,
                                        const LoadAnalysis& answer, const LoadedTorque& t,
                                        const LoadStandard& standard) {
  std::vector<StiffnessFactor> factors;
  const Gear& one = task.setup.gear(1);
  const Gear& two = task.setup.gear(2);
  double with = t.without_twist.mean;
  const auto without = [&](const std::string& what, const ContactPair& pair) {
    const double k = mean_stiffness(pair, one, two, *answer.compliance, task.request, t.torque);
    factors.push_back({what, with / k});
    with = k;
  };
  if (const auto perfect = task.perfect_pair())
    without("errors of mounting and deflections of the shafts", *perfect);
  if (has_modifications(task.setup))
    without("modifications of the flanks", bare_pair(task, one, two));
  if (standard.low_load > 1.0)
    factors.push_back(
        {fmt::format("a load below {} N/mm, for which the standard reduces the stiffness", 100),
         standard.low_load});
  double left = t.without_twist.mean / standard.stiffness;
  for (const StiffnessFactor& f : factors) left /= f.value;
  if (!(std::abs(left - 1) <= kMuchLeft))
    add_of_shape(task, *arranged.pair->involute(), t.torque, factors);
  return factors;
}

}  // namespace

void explain_stiffness(const Arranged& arranged, const LoadTask& task, const LoadAnalysis& answer,
                       std::vector<Warning>& warnings) {
  const std::vector<LoadStandard>& standard = answer.standard;
  for (std::size_t i = 0; i < standard.size(); ++i) {
    const LoadedTorque& t = answer.contact->torques[i];
    const double ratio = t.without_twist.mean / standard[i].stiffness;
    if (!(std::abs(ratio - 1) > kWorthANote)) continue;
    double left = ratio;
    std::string list;
    for (const StiffnessFactor& f : factors_of(arranged, task, answer, t, standard[i])) {
      if (!(std::abs(f.value - 1) > kFactor) || !std::isfinite(f.value)) continue;
      left /= f.value;
      list += fmt::format("{}{:.2f} for {}", list.empty() ? "" : ", ", f.value, f.of);
    }
    const char* ring = task.setup.gear(2).internal()
                           ? ", because one gear is internal and the standard treats it as a rack"
                           : "";
    warnings.push_back(
        {WarningCode::stiffness_differs,
         list.empty()
             ? fmt::format("At {} N m, the mesh stiffness without the twist of the bodies is "
                           "{:.2f} times c_γα of ISO 6336-1. The difference is not due to errors, "
                           "modifications, face width or bodies, but to the teeth themselves{}.",
                           format_number(newton_metres(t.torque / task.torque_share)), ratio, ring)
             : fmt::format("At {} N m, the mesh stiffness without the twist of the bodies is "
                           "{:.2f} times c_γα of ISO 6336-1. This ratio is the product of several "
                           "factors: {}. The remaining factor of {:.2f} is due to the teeth "
                           "themselves{}.",
                           format_number(newton_metres(t.torque / task.torque_share)), ratio, list,
                           left, ring),
         0});
  }
}

}  // namespace gearwright
