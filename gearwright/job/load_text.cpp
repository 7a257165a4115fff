#include "gearwright/job/load_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/torque.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

namespace {

// One line for each torque with the values that depend on the load.
std::string harris_map(const LoadedContact& contact, const LoadedTorque* quiet) {
  const bool lines = contact.regime == LoadRegime::line;
  std::string out =
      fmt::format("  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}{}\n", "torque", "TE p-p", "stiffness",
                  "pressure", "root 1", "root 2", lines ? fmt::format("{:>9}", "K_Hβ") : "");
  out += fmt::format("  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}\n", "N m", "arcsec",
                     unit_text(lines ? Unit::newton_per_mm_um : Unit::newton_per_um), "N/mm²",
                     "N/mm²", "N/mm²");
  for (const LoadedTorque& t : contact.torques)
    out += fmt::format(
        "  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}{}{}\n", format_number(newton_metres(t.torque)),
        fixed_decimals(t.peak_to_peak.arcsec(), 4), fixed_decimals(t.stiffness.mean, 3),
        fixed_decimals(t.max_pressure, 1), fixed_decimals(t.max_root_stress[0], 1),
        fixed_decimals(t.max_root_stress[1], 1),
        lines ? fmt::format("{:>9}", fixed_decimals(t.face_load_factor, 3)) : "",
        &t == quiet ? "  quietest" : "");
  return out;
}

// Lists both halves of a double-helical pair under torque number i.
std::string halves_listing(const LoadAnalysis& answer, std::size_t i) {
  std::string out = fmt::format("\n  {:<11}{:>14}{:>12}{:>11}{:>11}{:>9}\n", "", "TE p-p",
                                "pressure", "root 1", "root 2", "K_Hβ");
  for (std::size_t h = 0; h < 2; ++h) {
    const LoadedTorque& t = answer.halves[h].contact->torques[i];
    out +=
        fmt::format("  {:<11}{:>14}{:>12}{:>11}{:>11}{:>9}\n", h == 0 ? "half z > 0" : "half z < 0",
                    fixed_decimals(t.peak_to_peak.arcsec(), 4), fixed_decimals(t.max_pressure, 1),
                    fixed_decimals(t.max_root_stress[0], 1),
                    fixed_decimals(t.max_root_stress[1], 1), fixed_decimals(t.face_load_factor, 3));
  }
  return out;
}

}  // namespace

Json load_json(const SolvedJob& job, const LoadAnalysis& answer) {
  return titled_record(job.spec, "load", load_quantities().of(load_view(job, answer)));
}

std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer) {
  const UnitSystem units = job.spec.units();
  std::string out = title_listing(job.spec);
  for (std::size_t i = 0; i < answer.probes.size(); ++i) {
    const LoadProbeInput& input = job.spec.load.probes[i];
    const ProbeAnswer& p = answer.probes[i];
    const auto position = [&](double mm) { return format_number(value_in(units, Unit::mm, mm)); };
    const std::string_view unit = unit_text(units, Unit::mm);
    out +=
        fmt::format("  Probe {} on gear {}, diameter {} {}: {:.6g} µm per {}\n", i + 1, input.gear,
                    position(input.diameter), unit, p.own * kUmPerMm, input.z ? "N" : "N/mm");
    for (std::size_t k = 0; k < p.profile.size(); ++k)
      out += fmt::format("    z = {:>9} {}{:>16.6g} µm per N\n", position(input.read_z[k]), unit,
                         p.profile[k] * kUmPerMm);
  }
  if (!answer.contact) return out;
  const LoadView whole = load_view(job, answer);
  const auto views = torque_views(*answer.contact, whole.standard);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const LoadedTorque& t = *views[i].torque;
    out += quantity_listing(units, load_torque_quantities().table(),
                            {load_torque_quantities().of(views[i])}, {});
    if (!answer.halves.empty()) out += halves_listing(answer, i);
    out +=
        fmt::format("\n  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11}  {}\n", "rotation1", "TE", "approach",
                    "pressure", "root 1", "root 2", whole.halves.empty() ? "shares" : "");
    out += fmt::format("  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11}\n", "°", "arcsec",
                       unit_text(units, Unit::um), "N/mm²", "N/mm²", "N/mm²");
    // The rows are limited to one page. --json has all positions.
    const std::size_t step = std::max<std::size_t>(1, t.positions.size() / 32);
    for (std::size_t at = 0; at < t.positions.size(); at += step) {
      const LoadedPosition& p = t.positions[at];
      if (!p.solved()) {
        out += fmt::format("  {:>11}{:>14}\n", fixed_decimals(p.rotation1.deg(), 4),
                           p.unfinished ? "unfinished" : "no contact");
        continue;
      }
      std::string shares;
      for (const LoadedPair& k : p.pairs) shares += fmt::format(" {:.3f}", k.share);
      out += fmt::format("  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11} {}\n",
                         fixed_decimals(p.rotation1.deg(), 4), fixed_decimals(p.te.arcsec(), 4),
                         text_in(units, Unit::um, p.approach * kUmPerMm, 4),
                         fixed_decimals(p.max_pressure, 1), fixed_decimals(p.root_stress[0], 1),
                         fixed_decimals(p.root_stress[1], 1), shares);
    }
    out += "\n";
  }
  if (const LoadedTorque* quiet = quietest(*answer.contact))
    out += harris_map(*answer.contact, quiet);
  return out;
}

}  // namespace gearwright
