#include "gearwright/report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/arc_pair_section.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

struct Meaning {
  const char* code;
  Severity severity;
  const char* reason;  // completes "does not run as specified: …"
};

constexpr std::array<Meaning, 37> kMeanings{{
    {"through_axis", Severity::problem, "the cutter passes the axis"},
    {"severed", Severity::problem, "the teeth are cut off at their roots"},
    {"no_flank", Severity::problem, "a gear has no usable flank"},
    {"negative_backlash", Severity::problem, "the teeth are too thick for this centre distance"},
    {"contact_ratio", Severity::problem, "contact is not continuous"},
    {"contact_lost", Severity::caution, "contact is lost where an undercut took the flank"},
    {"no_contact", Severity::problem, "the teeth do not touch"},
    {"not_read", Severity::note, "a part of the spec was not read"},
    {"rack_not_used", Severity::caution, "an internal gear is not cut by a rack"},
    {"base_tangent", Severity::problem, "a tip reaches where the mating gear has no involute"},
    {"form_circle", Severity::problem, "a tip reaches below the mating gear’s usable flank"},
    {"tip_to_fillet", Severity::problem, "a tip corner cuts into a root fillet"},
    {"root", Severity::problem, "a tip cuts into the mating gear’s root"},
    {"trochoid", Severity::problem, "the tips strike each other"},
    {"overlap", Severity::problem, "the teeth overlap"},
    {"beyond_flank", Severity::caution, ""},
    {"tip_bulge", Severity::note, ""},
    {"no_tip_clearance", Severity::caution, ""},
    {"transverse_contact_ratio", Severity::note, ""},
    {"undercut", Severity::caution, ""},
    {"pointed", Severity::caution, ""},
    {"thin_tip", Severity::caution, ""},
    {"trimming", Severity::caution, ""},
    {"nearly_parallel", Severity::caution, ""},
    {"face_width", Severity::caution, ""},
    {"self_locking", Severity::note, ""},
    {"full_radius_root", Severity::note, ""},
    {"tip_cut_by_rack", Severity::note, ""},
    {"default_face_width", Severity::note, ""},
    {"default_shaft_angle", Severity::note, ""},
    {"default_cutter", Severity::note, ""},
    {"tip_fillet_cut_off", Severity::note, ""},
    {"no_chord", Severity::note, ""},
    {"interference", Severity::problem, "the flanks cut into each other"},
    {"contact_off_flank", Severity::problem, "the teeth touch off their flanks"},
    {"pressure_angle", Severity::caution, ""},
    {"unequal_lead", Severity::caution, ""},
}};

const Meaning* meaning_of(const std::string& code) {
  for (const Meaning& meaning : kMeanings) {
    if (code == meaning.code) return &meaning;
  }
  return nullptr;
}

std::vector<std::string> reasons(const ReportInput& input) {
  std::vector<std::string> list;
  for (const Warning& w : input.warnings) {
    if (severity_of(w) != Severity::problem) continue;
    std::string reason = meaning_of(w.code)->reason;
    if (std::find(list.begin(), list.end(), reason) == list.end())
      list.push_back(std::move(reason));
  }
  return list;
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += i + 1 == list.size() ? " and " : ", ";
    text += list[i];
  }
  return text;
}

std::string cautions(const ReportInput& input) {
  const auto n = std::count_if(input.warnings.begin(), input.warnings.end(), [&](const Warning& w) {
    return severity_of(w) == Severity::caution;
  });
  if (n == 0) return "";
  return n == 1 ? " One point to look at follows."
                : fmt::format(" {} points to look at follow.", n);
}

}  // namespace

Severity severity_of(const Warning& warning) {
  const Meaning* meaning = meaning_of(warning.code);
  return meaning == nullptr ? Severity::caution : meaning->severity;
}

std::optional<double> face_width_needed(const InvolutePair& pair) {
  const Mesh<double>& m = pair.mesh;
  const double tan_beta = std::abs(m.tan_base_helix[0]);
  if (pair.crossed() || !pair.flanks_meet() || tan_beta == 0.0) return std::nullopt;
  if (!(m.true_ratio > 0.0 && m.true_ratio < 1.0)) return std::nullopt;
  // Rounding of the ratio itself must not ask for a hundredth more.
  return std::ceil((1.0 - m.true_ratio) * m.step / tan_beta * 100 - 1e-9) / 100;
}

std::string verdict(const ReportInput& input) {
  for (std::size_t i = 0; i < input.gears.size(); ++i) {
    if (input.gears[i]->exists()) continue;
    return fmt::format("Gear {} cannot be made as specified: {}.", i + 1,
                       input.gears[i]->tooth->through_axis
                           ? "the cutter passes its axis"
                           : "its teeth are cut off at their roots");
  }
  const std::vector<std::string> against = reasons(input);
  if (const ArcPair* arcs = input.pair ? input.pair->arcs() : nullptr) {
    return against.empty()
               ? arc_verdict(*arcs) + cautions(input)
               : fmt::format("The pair does not run as specified: {}.", joined(against));
  }
  const bool ring = std::any_of(input.gears.begin(), input.gears.end(),
                                [](const Gear* gear) { return gear->internal() && !gear->tooth; });
  if (!input.pair) {
    const char* who = input.gears.size() == 1 ? "The gear" : "Each gear";
    if (!against.empty()) return fmt::format("{} has a problem: {}.", who, joined(against));
    if (ring) {
      return fmt::format(
          "{} has the data below; an internal gear’s outline is what its pinion cutter leaves, "
          "which is not "
          "given, and is not checked.{}",
          who, cautions(input));
    }
    return fmt::format("{} can be cut as specified.{}", who, cautions(input));
  }
  const InvolutePair& p = *input.pair->involute();
  const std::optional<double> face = face_width_needed(p);
  if (!against.empty()) {
    const bool too_narrow = face && p.contact_ratio_true() < 1.0;
    return fmt::format("The pair does not run as specified: {}.{}", joined(against),
                       too_narrow ? fmt::format(" With a transverse contact ratio of {} contact is "
                                                "continuous only on helical gears, from b ≥ {:.2f} "
                                                "mm on.",
                                                fixed(p.mesh.true_ratio, 3), *face)
                                  : "");
  }
  // A backlash that the report shows as 0.0000 mm is none.
  const double j = p.mesh.backlash.normal;
  const std::string backlash =
      std::abs(j) < 0.5e-4 ? std::string("no backlash")
                           : fmt::format("a normal backlash of {} mm", fixed(j, kLengthDigits));
  const std::string contact =
      face
          ? fmt::format(
                "The pair runs only as a helical gear pair: transverse contact ratio {}, total {}; "
                "it needs b ≥ {:.2f} mm. There is",
                fixed(p.mesh.true_ratio, 3), fixed(p.contact_ratio_true(), 3), *face)
          : fmt::format("The pair runs: contact is continuous ({}contact ratio {}), there is",
                        p.crossed() ? "" : "total ", fixed(p.contact_ratio_true(), 3));
  const bool nothing_strikes = p.interference.empty() && p.beyond_flank.empty();
  return fmt::format(
      "{} {}{}.{}{}", contact, backlash, nothing_strikes ? " and no interference" : "",
      ring ? " The internal gear’s cutter is not given: its root fillet is not checked." : "",
      cautions(input));
}

}  // namespace gearwright
