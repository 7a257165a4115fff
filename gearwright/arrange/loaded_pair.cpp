#include "gearwright/arrange/loaded_pair.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

constexpr double kMostPoisson = 0.49;  // at 0.5, plane strain has no stiffness matrix
constexpr double kHertzRatio = 0.1;    // half width of the contact over radius of curvature; above
                                       // this ratio, Hertz' theory is wrong by more than 1 %

Result<ElasticBody> body_of(const Arranged& arranged, int which, std::vector<Warning>& warnings) {
  const GearInput& input = arranged.completed.gear(which);
  const Gear& gear = arranged.gear(which);
  ElasticBody body;
  const MaterialInput& given = input.material;
  const auto E = youngs_modulus_of(given, gear_field(which, "material"));
  if (!E) return E.error();
  body.youngs_modulus = *E;
  body.poisson_ratio = given.poisson_ratio.value_or(body.poisson_ratio);
  if (!(body.poisson_ratio <= kMostPoisson)) {
    return refused(gear_field(which, "material.poisson_ratio"), body.poisson_ratio,
                   {0.0, kMostPoisson}, "must lie between {} and {} for teeth under load");
  }
  const auto bore = body_bore(gear);
  body.bore_diameter = bore ? bore->diameter : kShaft * gear.root_diameter;
  if (gear.bore) return body;
  const auto code = bore ? WarningCode::held_at_rim_as_drawn : WarningCode::held_at_half_the_root;
  warnings.push_back(held_without_bore(std::to_string(which), code, body.bore_diameter));
  warnings.back().gear = which;
  return body;
}

// Returns an error if the gear is internal and none of the default cutters generates its flanks.
std::optional<Error> not_made_for(const Gear& gear, int which) {
  if (!gear.tooth)
    return Error{gear_field(which, "cut_by"), "",
                 "is missing; give a pinion cutter, because none of the default cutters generates "
                 "the whole flank of this internal gear",
                 FailureKind::not_under_load};
  return std::nullopt;
}

std::optional<Error> not_made_for(const Arranged& arranged) {
  if (arranged.pair->mounted().crossed_inside()) {
    Error error = refused("pair.shaft_angle", arranged.pair->shaft_angle().deg(),
                          "crosses the axes of an internal pair; teeth under load are computed for "
                          "internal pairs on parallel axes only. The command `gearwright contact` "
                          "computes where these teeth touch if there is no load");
    error.kind = FailureKind::not_under_load;
    return error;
  }
  for (int i = 1; i <= 2; ++i)
    if (auto error = not_made_for(arranged.gears[i - 1], i)) return error;
  return std::nullopt;
}

LoadRegime regime_of(const Arranged& arranged) {
  return arranged.pair->parallel() ? LoadRegime::line : LoadRegime::point;
}

// Returns an error if a shaft deflection is given, which is possible for line contact only. For
// point contact, the errors of mounting describe the displacement of the gears.
std::optional<Error> not_for_points(const LoadInput& input) {
  for (const auto& [field, value] : {std::pair("load.deflection_slope", input.deflection_slope),
                                     std::pair("load.deflection_bow", input.deflection_bow)})
    if (value != 0.0)
      return refused(field, value,
                     "applies only to teeth with line contact, but these teeth have point contact; "
                     "give the displacement of the gears in `errors` instead");
  return std::nullopt;
}

// Returns the error that a shaft deflection requires a single face with line contact.
Error not_for_shaft(int which, bool of_half) {
  return {gear_field(which, "shaft"), "",
          of_half
              ? "cannot be used for a double-helical gear under load; leave out the shaft, and "
                "give the slope and the bow of the deflection in `load`"
              : "applies under load only to teeth with line contact, but these teeth have point "
                "contact; leave out the shaft, and give the displacement of the gears in `errors` "
                "instead"};
}

// Lists the rotations of gear 1 at which `is` returns true. At most kMostNamed of them are
// named, and the others are counted. Returns an empty text if there are none.
template <class Is>
std::string rotations_where(const LoadedTorque& t, Is is) {
  constexpr int kMostNamed = 8;
  std::string list;
  int count = 0;
  for (const LoadedPosition& p : t.positions) {
    if (!is(p) || ++count > kMostNamed) continue;
    list += fmt::format("{}{}°", list.empty() ? "" : ", ", format_number(p.rotation1.deg()));
  }
  return count > kMostNamed ? fmt::format("{} and {} more", list, count - kMostNamed) : list;
}

void warn_about(const LoadedContact& contact, double share, std::vector<Warning>& warnings) {
  const auto untouched = [](const LoadedPosition& p) { return !p.solved() && !p.unfinished; };
  const auto is_lost = [](const Warning& w) { return w.code == WarningCode::contact_lost; };
  // Whether teeth touch does not depend on the torque, so only the first torque is examined.
  if (const std::string where = rotations_where(contact.torques.front(), untouched);
      !where.empty() && std::none_of(warnings.begin(), warnings.end(), is_lost))
    warnings.push_back(
        {WarningCode::contact_lost,
         fmt::format("No teeth touch at rotation1 = {}; the results under load cover the remaining "
                     "positions.",
                     where),
         0});
  std::vector<double> at_edges;  // the torques at which an edge carries load
  for (const LoadedTorque& t : contact.torques) {
    const double whole = t.torque / share;
    const std::string torque = format_number(newton_metres(whole));
    if (const std::string where =
            rotations_where(t, [](const LoadedPosition& p) { return p.unfinished; });
        !where.empty())
      warnings.push_back(
          {WarningCode::load_unfinished,
           fmt::format(
               "At {} N m the forces do not converge at rotation1 = {}. These positions have no "
               "results, and maximum and peak-to-peak values cover the remaining positions.",
               torque, where),
           0});
    if (t.edge_carries)
      at_edges.push_back(whole);
    else if (t.beyond_flank)
      warnings.push_back({WarningCode::ellipse_beyond_flank,
                          fmt::format("At {} N m the contact ellipse extends beyond an end of the "
                                      "flank; the pressure there is a lower bound.",
                                      torque),
                          0});
    if (t.max_width_ratio > kHertzRatio)
      warnings.push_back(
          {WarningCode::beyond_hertz,
           fmt::format("At {} N m the half width of the contact is {:.2f} times the radius of "
                       "relative curvature, which is outside the range of Hertz’ theory.",
                       torque, t.max_width_ratio),
           0});
  }
  if (!at_edges.empty()) warnings.push_back(edge_carries_at(at_edges));
}

Result<std::array<ElasticBody, 2>> bodies_of(const Arranged& arranged,
                                             std::vector<Warning>& warnings) {
  std::array<ElasticBody, 2> bodies;
  for (std::size_t i = 0; i < arranged.gears.size(); ++i) {
    auto body = body_of(arranged, static_cast<int>(i) + 1, warnings);
    if (!body) return body.error();
    bodies[i] = *body;
  }
  return bodies;
}

// Returns the member of the input that causes a deflection of the axes under load, or an empty text
// if there is none.
std::string deflecting_member(const LoadRequest& request) {
  for (const int which : {1, 2})
    if (request.shafts[which - 1]) return gear_field(which, "shaft");
  if (!request.deflects()) return {};
  return request.deflection_slope != 0.0 ? "load.deflection_slope" : "load.deflection_bow";
}

Error no_touch(const LoadTask& task) {
  const std::string member = deflecting_member(task.request);
  if (member.empty()) return nothing_touches(task.setup);
  const LoadRequest& r = task.request;
  const double um = (r.deflection_slope != 0.0 ? r.deflection_slope : r.deflection_bow) / kMmPerUm;
  const bool by_shaft = r.shafts[0] || r.shafts[1];
  return {member, by_shaft ? "" : format_number(um),
          "no teeth touch at any position under this deflection; a smaller deflection or a stiffer "
          "shaft would help",
          FailureKind::nothing_touches};
}

Error too_fine(const ContactSetup& setup, const LoadRequest& request) {
  const NarrowestSlices narrowest = narrowest_slices(setup.gear(1), setup.gear(2), request);
  const std::size_t g = narrowest.gear - 1;
  const auto fair = fair_slices(setup.gear(1), setup.gear(2), request.regime, request.reach);
  LoadRequest coarser = request;
  coarser.slices = fair;
  const bool fair_is_enough =
      request.slices[g] > fair[g] && !surely_too_fine(setup.gear(1), setup.gear(2), coarser);
  const std::string width = format_number(narrowest.width);
  const std::string member = deflecting_member(request);
  return refused(
      "load.slices", request.slices[g],
      fair_is_enough
          ? fmt::format("are too many for these teeth, because each slice is only {} mm wide; {}",
                        width,
                        fair[0] == fair[1] ? fmt::format("{} slices are sufficient", fair[0])
                                           : fmt::format("leave out this key, because {} slices of "
                                                         "gear 1 and {} of gear 2 are sufficient",
                                                         fair[0], fair[1]))
          : fmt::format("are too many, because each slice is {} mm wide, which is less than the "
                        "width of the contact; reduce the torque{}{}",
                        width,
                        member.empty() ? "" : fmt::format(" or the deflection (`{}`)", member),
                        request.slices[g] > kLeastSlices ? " or the number of slices" : ""));
}

Result<LoadTask> task_of(const Arranged& arranged, const ContactErrors& errors,
                         const LoadInput& input, const std::array<ElasticBody, 2>& bodies,
                         const std::optional<HalfPlace>& half = {}) {
  if (input.driver != 1 && input.driver != 2)
    return refused("load.driver", input.driver, "must be 1 or 2, the number of the driving gear");
  for (const double torque : input.torques)
    if (!(torque > 0.0)) return refused("load.torques", torque, "must be > 0 N m, on gear 1");
  if (auto error = not_made_for(arranged)) return *error;
  auto setup = setup_of(arranged, errors);
  if (!setup) return setup.error();
  if (half)
    setup = HalvesSetup(*setup, arranged.completed.gear(1).double_helical->stagger_pitches)
                .half(half->below);
  LoadTask task{std::move(setup).take(), {}, input.driver == 2};
  if (half) task.torque_share = 0.5;
  LoadRequest& request = task.request;
  request.regime = regime_of(arranged);
  const ContactPair pair = task.pair();
  request.middle = {pair.middle(1), pair.middle(2)};
  for (const int which : {1, 2}) {
    const auto& shaft = arranged.completed.gear(which).shaft;
    if (!shaft) continue;
    if (half || request.regime == LoadRegime::point) return not_for_shaft(which, half.has_value());
    request.shafts[which - 1] = shaft;
  }
  if (request.regime == LoadRegime::point)
    if (auto error = not_for_points(input)) return *error;
  // A gear that is displaced along its axis carries load on the face that it shares with the other
  // gear. The displacement is left out if there are shafts, whose bearings are not displaced, and
  // for the halves of double-helical gears, which share their slices.
  if (request.regime == LoadRegime::line && !half && !request.shafts[0] && !request.shafts[1])
    request.middle[0] += pair.turned() * errors.axial;
  for (const double m : input.torques) request.torques.push_back(from_newton_metres(m));
  request.positions = input.positions;
  request.rotations = input.rotations;
  if (request.regime == LoadRegime::point && arranged.pair->crossed())
    request.reach = crossed_reach(task.setup.gear(1), task.setup.gear(2)) + std::abs(errors.axial);
  request.slices = input.slices ? std::array{*input.slices, *input.slices}
                                : fair_slices(task.setup.gear(1), task.setup.gear(2),
                                              request.regime, request.reach);
  request.accuracy = input.accuracy;
  request.bodies = bodies;
  while (!input.slices && surely_too_fine(task.setup.gear(1), task.setup.gear(2), request) &&
         halve_slices(request.slices)) {
  }
  if (surely_too_fine(task.setup.gear(1), task.setup.gear(2), request))
    return too_fine(task.setup, request);
  request.deflection_slope = input.deflection_slope * kMmPerUm;
  request.deflection_bow = input.deflection_bow * kMmPerUm;
  request.deflection_offset = input.deflection_offset * kMmPerUm;
  task.with_errors = request.deflects() || errors != ContactErrors();
  return task;
}

}  // namespace

Result<ContactSetup> setup_of(const Arranged& arranged, const ContactErrors& errors) {
  GW_EXPECTS(arranged.pair.has_value());
  const GivenPair& given = arranged.completed;
  return ContactSetup::of(*arranged.pair, errors,
                          {given.gear(1).modifications, given.gear(2).modifications});
}

Result<LoadTask> load_task(const Arranged& arranged, const ContactErrors& errors,
                           const LoadInput& input, std::vector<Warning>& warnings,
                           const std::optional<HalfPlace>& half) {
  if (input.torques.empty())
    return absent_input(
        "load.torques",
        "; a report of the pair under load needs a torque, even if there are probes");
  const auto bodies = bodies_of(arranged, warnings);
  if (!bodies) return bodies.error();
  return task_of(arranged, errors, input, *bodies, half);
}

std::optional<ContactPair> LoadTask::perfect_pair() const {
  if (!with_errors) return std::nullopt;
  return setup.pair(ContactErrors(), gear2_drives);
}

Result<PairCompliance> LoadTask::compliance() const {
  return pair_compliance(setup.gear(1), setup.gear(2), request);
}

LoadedContact LoadTask::contact(const PairCompliance& compliance) const {
  const auto perfect = perfect_pair();
  return loaded_contact(pair(), setup.gear(1), setup.gear(2), compliance, request,
                        perfect ? &*perfect : nullptr);
}

bool halve_slices(std::array<int, 2>& slices) {
  const auto before = slices;
  for (int& count : slices) count = std::max(kLeastSlices, count / 2);
  return slices != before;
}

std::vector<LoadedContact> contacts_at_limits(const LoadTask& task,
                                              const PairCompliance& compliance, double deviation) {
  constexpr int kMostPositions = 16;  // per pitch
  const ContactPair pair = task.pair();
  LoadRequest limit = task.request;
  limit.positions = std::min(kMostPositions, limit.positions);
  limit.root_stress = false;
  std::vector<LoadedContact> contacts;
  for (const double sign : {-1.0, 1.0}) {
    limit.deflection_slope = task.request.deflection_slope + sign * deviation;
    contacts.push_back(
        loaded_contact(pair, task.setup.gear(1), task.setup.gear(2), compliance, limit));
  }
  return contacts;
}

std::optional<Error> judge_load(const LoadTask& task, const LoadedContact& found,
                                std::vector<Warning>& warnings) {
  const auto& positions = found.torques.front().positions;
  if (std::all_of(positions.begin(), positions.end(),
                  [](const LoadedPosition& p) { return !p.solved() && !p.unfinished; }))
    return no_touch(task);
  if (found.slices_too_fine) return too_fine(task.setup, task.request);
  for (const LoadedTorque& t : found.torques)
    if (std::none_of(t.positions.begin(), t.positions.end(),
                     [](const LoadedPosition& p) { return p.solved(); })) {
      Error error = refused("load.torques", newton_metres(t.torque / task.torque_share),
                            "the forces converge at no position; accuracy = \"full\", another "
                            "number of slices or a smaller torque may help");
      error.kind = FailureKind::not_converged;
      return error;
    }
  warn_about(found, task.torque_share, warnings);
  return std::nullopt;
}

std::vector<LoadedContact> one_contact(const LoadTask& task, const PairCompliance& compliance) {
  return {task.contact(compliance)};
}

Result<LoadAnalysis> loaded(const Arranged& arranged, const ContactErrors& errors,
                            const LoadInput& input, std::vector<Warning>& warnings,
                            Progress* progress, const std::optional<HalfPlace>& half) {
  if (input.torques.empty() && input.probes.empty())
    return absent_input("load.torques", "; give a torque on gear 1 in N m, or a probe");
  const auto bodies = bodies_of(arranged, warnings);
  if (!bodies) return bodies.error();
  LoadAnalysis answer;
  for (std::size_t i = 0; i < input.probes.size(); ++i) {
    const LoadProbeInput& p = input.probes[i];
    const std::string field = fmt::format("load.probe[{}]", i);
    if (p.gear > static_cast<int>(arranged.gears.size()))
      return refused(field + ".gear", p.gear, "is not in the spec");
    const Gear& gear = arranged.gears[p.gear - 1];
    if (auto error = not_made_for(gear, p.gear)) return *error;
    auto found = probe_compliance(gear, (*bodies)[p.gear - 1],
                                  {p.diameter, p.z, p.half_width, p.read_z}, input.accuracy);
    if (!found) {
      const GearMember of = subject_of(found.error().field).member;
      const bool of_body = of == GearMember::teeth || of == GearMember::bore;
      return of_body ? of_gear(p.gear, found.error()) : within(field, found.error());
    }
    answer.probes.push_back(std::move(found).take());
  }
  if (input.torques.empty()) return answer;
  auto made = task_of(arranged, errors, input, *bodies, half);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.progress = progress;
  const bool given = input.slices.has_value();
  SliceResolutions resolutions =
      half && half->ready ? SliceResolutions(given, *half->ready) : SliceResolutions(given);
  auto found = resolutions.solve(task, one_contact);
  if (!found) return found.error();
  task.request.slices = found->slices;
  answer.compliance = *found->compliance;
  answer.contact = std::move(found->contacts.front());
  if (auto error = judge_load(task, *answer.contact, warnings)) return *error;
  answer.standard = load_standard(arranged, answer);
  if (!half || !half->below) explain_stiffness(arranged, task, answer, warnings);
  return answer;
}

Warning edge_carries_at(const std::vector<double>& torques) {
  std::vector<std::string> list;
  for (const double torque : torques) list.push_back(format_number(newton_metres(torque)));
  return {WarningCode::edge_carries,
          fmt::format("At {} N m an edge of a tooth carries load; the pressure there is a lower "
                      "bound, and the root stress depends on the number of slices.",
                      fmt::join(list, ", ")),
          0};
}

Result<LoadedContact> contact_under(const Arranged& arranged, const ContactErrors& errors,
                                    const LoadInput& input, double torque,
                                    std::vector<Warning>& warnings, Progress* progress) {
  const auto bodies = bodies_of(arranged, warnings);
  if (!bodies) return bodies.error();
  auto made = task_of(arranged, errors, input, *bodies);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.progress = progress;
  task.request.torques = {from_newton_metres(torque)};
  SliceResolutions resolutions(input.slices.has_value());
  auto found = resolutions.solve(task, one_contact);
  if (!found) return found.error();
  task.request.slices = found->slices;
  if (auto error = judge_load(task, found->contacts.front(), warnings)) return *error;
  return std::move(found->contacts.front());
}

Warning held_without_bore(const std::string& gear, WarningCode code, double diameter) {
  const char* const message =
      code == WarningCode::held_at_rim_as_drawn
          ? "The internal gear {} has no `bore`, so the outside diameter of its rim has the "
            "default value. The gear is held at this diameter, {} mm, which its CAD files also "
            "have."
          : "Gear {} has no bore, so its body is held at half the root diameter, {} mm.";
  return {code, fmt::format(fmt::runtime(message), gear, format_number(diameter))};
}

}  // namespace gearwright
