#include "gearwright/verdict/remedy.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/verdict/meaning.hpp"

namespace gearwright::detail {

namespace {

// Contact below the usable flank of the gear that the warning names: the mating tip reaches too
// far, or the gear stands too deep in its cutter.
bool reaches_too_deep(const std::string& code) {
  return code == "base_tangent" || code == "form_circle" || code == "tip_to_fillet";
}

// A sum of shifts that a given centre distance asked for, when it is the reason.
std::string of_the_distance(const Judged& judged, const InvolutePair& pair) {
  const double sum = pair.gears[0].spec.profile_shift + pair.gears[1].spec.profile_shift;
  if (!judged.shifts_follow || pair.crossed() || !(sum < 0.0)) return "";
  return fmt::format(
      "The centre distance {:.6g} mm asks for a sum of profile shifts of {:.4f}: one nearer to the "
      "reference centre distance, {:.6g} mm, would help most.",
      pair.center_distance, sum, pair.reference_center_distance);
}

std::string shorter_tip(const InvolutePair& pair, const Warning& warning) {
  const int tip = 3 - warning.gear;
  const auto diameter = tip_that_clears(pair, tip);
  const std::string shift = fmt::format("shift gear {} outward", warning.gear);
  if (warning.code == "tip_to_fillet" || !diameter)
    return fmt::format("Shorten the tip of gear {}, or {}.", tip, shift);
  const bool internal = pair.gears[static_cast<std::size_t>(tip - 1)].internal();
  return fmt::format("A tip diameter of gear {} of at {} {:.4f} mm would do; or {}.", tip,
                     internal ? "least" : "most", *diameter, shift);
}

// Where an undercut took the flank, the shift without it brings the contact back.
std::string without_undercut(const InvolutePair& pair) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Gear& gear = pair.gears[i];
    if (!gear.undercut || !gear.involute()) continue;
    const auto least = gear.involute()->undercut_free_profile_shift;
    return least ? fmt::format(
                       "Undercut has taken the flank of gear {}: more teeth, or a generating "
                       "profile shift nearer to {:.4f}, would help.",
                       i + 1, *least)
                 : fmt::format("Undercut has taken the flank of gear {}: more teeth would help.",
                               i + 1);
  }
  return "";
}

}  // namespace

std::optional<double> tip_that_clears(const InvolutePair& pair, int tip) {
  const auto t = static_cast<std::size_t>(tip - 1);
  const auto other = 1 - t;
  const auto start = [&](std::size_t i) {
    const auto form = pair.gears[i].root_form_radius();
    const double base = pair.gears[i].base_radius();
    return form && *form > base ? std::sqrt(*form * *form - base * base) : 0.0;
  };
  const auto& mesh = pair.mesh;
  const double rho = tip == 2 ? mesh.rho2(start(0))
                              : leaf::rho_1_where(mesh.base_tangent_distance, mesh.sigma,
                                                  start(1) / mesh.base_cosine_ratio);
  if (!(rho > 0.0)) return std::nullopt;
  const double radius = std::hypot(pair.gears[t].base_radius(), rho);
  const double now = pair.gears[t].actual_tip_radius();
  const bool shorter = pair.gears[t].internal() ? radius > now : radius < now;
  // An internal gear without an outline has no flank that begins anywhere.
  if (!shorter || (pair.gears[other].internal() && !pair.gears[other].root_form_radius()))
    return std::nullopt;
  return 2 * radius;
}

std::string remedy_for(const Warning& warning, const Judged& judged) {
  const Meaning meaning = meaning_of(warning);
  const InvolutePair* pair = judged.pair ? judged.pair->involute() : nullptr;
  if (!pair) return meaning.remedy;
  if (reaches_too_deep(warning.code)) {
    const std::string distance = of_the_distance(judged, *pair);
    return distance.empty() ? shorter_tip(*pair, warning) : distance;
  }
  if (warning.code == "no_contact") {
    std::string help = of_the_distance(judged, *pair);
    if (help.empty()) help = without_undercut(*pair);
    if (!help.empty()) return help;
  }
  return meaning.remedy;
}

}  // namespace gearwright::detail
