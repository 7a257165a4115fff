#include "gearwright/arrange/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/verdict/remedy.hpp"

namespace gearwright {

namespace {

// A finding of the assembly, or of one of the meshes.
struct Part {
  Finding finding;
  std::optional<std::size_t> mesh{};
};

struct JudgedMesh {
  Judged judged;
  std::vector<Warning> warnings;
};

JudgedMesh judged_mesh(const Drive& drive, std::size_t m, const Safeties& wanted) {
  JudgedMesh made;
  if (const auto& rack = drive.geometry.racks[m]) {
    made.judged.gears = {&rack->pinion};
    made.judged.rack = &*rack;
    made.warnings = rack->warnings;
  } else {
    const Pair& pair = *drive.geometry.pairs[m];
    made.judged.gears = {&pair.gear(1), &pair.gear(2)};
    made.judged.pair = &pair;
    made.warnings = pair.warnings();
  }
  int which = 0;
  for (const Gear* gear : made.judged.gears) {
    const auto& halves = drive.graph.gear(drive.graph.meshes[m], which++).double_helical;
    const auto groove = halves ? groove_diameter(*gear, *halves) : std::nullopt;
    if (auto w = body_warning(*gear, groove, which)) made.warnings.push_back(*w);
    for (Warning w : gear->warnings) {
      w.gear = which;
      made.warnings.push_back(std::move(w));
    }
  }
  if (!drive.contacts.empty() && drive.contacts[m]) {
    const MeshContact& c = *drive.contacts[m];
    warn_of_contact(c.driving, c.other, c.least_play, made.judged.gears, made.warnings);
    made.judged.contact = &c.judged();
  }
  if (!drive.ratings.empty() && drive.ratings[m]) {
    made.judged.rating = *drive.ratings[m];
    made.judged.rating->wanted = wanted;
  }
  return made;
}

std::vector<Finding> mesh_findings(const Drive& drive, std::size_t m, const Safeties& wanted) {
  JudgedMesh mesh = judged_mesh(drive, m, wanted);
  mesh.judged.warnings = &mesh.warnings;
  std::vector<Finding> findings = findings_of(mesh.judged);
  const bool planets = drive.graph.frame(drive.graph.meshes[m]).has_value();
  for (Finding& f : findings)
    if (planets && f.code == WarningCode::trimming) f.level = Level::green;
  return findings;
}

std::size_t gear_index(const Drive& drive, std::size_t m, int which) {
  return drive.graph.meshes[m].gears[which - 1];
}

std::vector<Part> parts_of(const Drive& drive, const Safeties& wanted) {
  std::vector<Part> parts;
  for (const Warning& w : drive.findings)
    parts.push_back({{w.code, level_of(severity_of(w)), 0, w.message}});
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    if (!drive.geometry.pairs[m] && !drive.geometry.racks[m]) continue;
    for (Finding& f : mesh_findings(drive, m, wanted)) {
      // A gear may belong to several meshes. A finding about this gear alone is listed only once,
      // with its first mesh.
      const auto same = [&](const Part& part) {
        return part.mesh && f.gear > 0 && part.finding.gear > 0 && part.finding.code == f.code &&
               part.finding.message == f.message &&
               gear_index(drive, *part.mesh, part.finding.gear) == gear_index(drive, m, f.gear);
      };
      if (std::none_of(parts.begin(), parts.end(), same)) parts.push_back({std::move(f), m});
    }
  }
  return parts;
}

// Replaces "gear 1" and "gear 2" of a mesh by the names of the gears.
std::string with_names(std::string text, const Drive& drive, std::size_t m) {
  const DriveMesh& mesh = drive.graph.meshes[m];
  for (const int which : {0, 1}) {
    const std::string name = drive.graph.gear(mesh, which).name;
    for (const char* form : {"gear {}", "Gear {}"}) {
      const std::string from = fmt::format(fmt::runtime(form), which + 1);
      for (std::size_t at = text.find(from); at != std::string::npos;
           at = text.find(from, at + name.size()))
        text.replace(at, from.size(), name);
    }
  }
  return text;
}

std::optional<DriveChange> of_drive(const Drive& drive, std::size_t m, const SpecChange& change) {
  if (change.what == Adjustable::center_distance) return DriveChange{change.what, m, change.value};
  if (change.gear == 0) return std::nullopt;
  return DriveChange{change.what, gear_index(drive, m, change.gear), change.value};
}

// True if no finding outside the mesh `mesh` is worse after a change than before it.
bool no_worse(const std::vector<Part>& before, const std::vector<Part>& after, std::size_t mesh) {
  return std::all_of(after.begin(), after.end(), [&](const Part& now) {
    if (now.mesh == mesh || now.finding.level == Level::green) return true;
    return std::any_of(before.begin(), before.end(), [&](const Part& was) {
      return was.mesh == now.mesh && was.finding.code == now.finding.code &&
             was.finding.gear == now.finding.gear && was.finding.level >= now.finding.level;
    });
  });
}

// Adds remedies to the findings of the mesh that has the worst finding.
void add_remedy(std::vector<Part>& parts, const Drive& drive, const DriveInput& input,
                const std::function<std::string(const DriveChange&)>& key_of,
                const Safeties& wanted) {
  const std::size_t m = *parts.front().mesh;
  const TryChange attempt = [&](const SpecChange& change, TryDepth) -> std::optional<ChangedState> {
    const auto of_it = of_drive(drive, m, change);
    auto other = of_it ? changed(input, *of_it) : std::nullopt;
    if (!other) return std::nullopt;
    other->stages.clear();
    const auto made = make_drive(*other);
    if (!made || !made->geometry.pairs[m]) return std::nullopt;
    const std::vector<Part> after = parts_of(*made, {});
    if (!no_worse(parts, after, m)) return std::nullopt;
    ChangedState state;
    for (const Part& part : after)
      if (part.mesh == m) state.findings.push_back(part.finding);
    const Pair& pair = *made->geometry.pairs[m];
    state.contact_ratio = pair.contact_ratio_true();
    state.backlash = pair.stated_backlash().normal;
    return state;
  };
  std::vector<Finding> own;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].mesh != m) continue;
    own.push_back(parts[i].finding);
    places.push_back(i);
  }
  JudgedMesh mesh = judged_mesh(drive, m, wanted);
  mesh.judged.warnings = &mesh.warnings;
  detail::add_remedies(own, mesh.judged, attempt);
  for (std::size_t i = 0; i < own.size(); ++i) {
    Finding& f = parts[places[i]].finding;
    f.remedy = own[i].remedy;
    const auto change = own[i].change ? of_drive(drive, m, *own[i].change) : std::nullopt;
    if (!change || !key_of) continue;
    const std::string key = key_of(*change);
    // A stage with `teeth` has no key for a tip diameter.
    if (key.empty() && change->what == Adjustable::tip_diameter && !input.stages.empty() &&
        !drive.graph.frame(drive.graph.meshes[m]))
      f.remedy.insert(f.remedy.size() - 1,
                      " (`tip_diameter`, which a gear with its own table can have)");
    if (key.empty()) continue;
    f.change = own[i].change;
    f.change->path = key;
    f.remedy.insert(f.remedy.size() - 1,
                    fmt::format(" ({} = {})", key, format_number(change->value)));
  }
}

std::string share(double eta) { return fmt::format("{:.4f}", eta); }

std::string fraction(const Rational& r) {
  const auto p = r.numerator(), q = r.denominator();
  if (!p || !q || *q == 1) return fmt::format("{:.6g}", r.value());
  return fmt::format("{:.6g} ({}/{})", r.value(), *p, *q);
}

// True if a gear of the mesh has another mesh, too.
bool shares_gears(const DriveGraph& graph, std::size_t mesh) {
  const auto& own = graph.meshes[mesh].gears;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m)
    for (const std::size_t gear : graph.meshes[m].gears)
      if (m != mesh && is_in(gear, own)) return true;
  return false;
}

// Returns a summary of a drive that runs, with its ratio, its efficiency, its safeties and the
// least backlash of its meshes.
std::string running(const Drive& drive) {
  std::string text = "The drive runs";
  std::string facts;
  const auto pitch = drive.rack_pitch(drive.graph.output);
  if (const auto pitches = drive.speed_ratio(drive.graph.output); pitch && pitches) {
    facts += fmt::format("travel {:.4f} mm per turn of the input", *pitch * *pitches);
  } else if (drive.motion.ratio) {
    facts += "ratio " + fraction(*drive.motion.ratio);
  }
  if (drive.flow && !drive.flow->self_locking())
    facts += (facts.empty() ? "efficiency " : ", efficiency ") + share(drive.flow->efficiency);
  text += facts.empty() ? "." : ": " + facts + ".";
  std::optional<std::size_t> tight;  // the mesh with the least backlash
  StatedBacklash least{};
  bool everywhere = true;  // true if no mesh has backlash
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    const auto backlash = drive.geometry.stated_backlash(m);
    if (!backlash) continue;
    if (backlash->normal > 0.0 && !backlash->none()) everywhere = false;
    if (tight && backlash->normal >= least.normal) continue;
    tight = m;
    least = *backlash;
  }
  if (!tight) return text + " The teeth are not checked, because no module is given.";
  std::vector<const Rating*> ratings;
  for (const auto& rating : drive.ratings)
    if (rating) ratings.push_back(&rating->rating);
  text += safety_words(ratings);
  if (least.normal > 0.0 && !least.none())
    return text + fmt::format(" The least backlash is {:.4f} mm.", least.normal);
  if (drive.geometry.racks[*tight])
    return text + " There is no backlash between the rack and its pinion.";
  const std::string& name = drive.graph.meshes[*tight].name;
  const ParallelPair* pair = drive.geometry.involutes(*tight);
  if (!pair) return text + fmt::format(" There is no backlash in the mesh {}.", name);
  const CylindricalSpec& spec = pair->gears[0].spec;
  const double recommended = least.recommended();
  // If both gears get the same allowance E_sn, j_bn changes by −2 (E_sn − mean) cos α_n, where
  // `mean` is the mean of the present allowances. The normal backlash is j_n = j_bn/cos α_wn.
  const double per_allowance =
      2 * std::cos(spec.normal_pressure_angle.rad()) / pair->mesh.rack.angles.cos_alpha;
  const double mean = (spec.thickness_allowance + pair->gears[1].spec.thickness_allowance) / 2;
  const double allowance =
      std::floor((mean - (recommended - least.normal) / per_allowance) * 100) / 100;
  const bool alone = !everywhere && !shares_gears(drive.graph, *tight);
  return text + fmt::format(
                    " There is no backlash{}. A thickness allowance of {} mm on {} gears gives a "
                    "backlash of {:.3f} mm in {}; {}.",
                    everywhere ? "" : " in the mesh " + name, format_number(allowance),
                    alone ? "both of its" : "all",
                    least.normal + per_allowance * (mean - allowance),
                    everywhere ? "the mesh " + name : "this mesh", recommendation(recommended));
}

}  // namespace

std::optional<DriveInput> changed(const DriveInput& input, const DriveChange& change) {
  DriveInput made = input;
  if (change.what == Adjustable::center_distance) {
    if (change.index >= made.graph.meshes.size()) return std::nullopt;
    made.graph.meshes[change.index].center_distance = change.value;
    return made;
  }
  if (change.index >= made.graph.gears.size()) return std::nullopt;
  DriveGear& gear = made.graph.gears[change.index];
  if (!gear.spec) return std::nullopt;
  switch (change.what) {
    case Adjustable::profile_shift: gear.shift = change.value; return made;
    case Adjustable::tip_diameter: gear.spec->tip_diameter = change.value; return made;
    case Adjustable::thickness_allowance:
      gear.spec->thickness_allowance = change.value;
      return made;
    case Adjustable::face_width: gear.spec->face_width = change.value; return made;
    default: return std::nullopt;
  }
}

Level drive_level(const Drive& drive, const Safeties& wanted, bool unequal_spacing_counts) {
  Level level = Level::green;
  for (const Part& part : parts_of(drive, wanted))
    if (unequal_spacing_counts || part.finding.code != WarningCode::unequal_spacing)
      level = std::max(level, part.finding.level);
  return level;
}

Verdict judge_drive(const Drive& drive, const DriveInput& input,
                    const std::function<std::string(const DriveChange&)>& key_of,
                    const Safeties& wanted) {
  std::vector<Part> parts = parts_of(drive, wanted);
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    if (a.finding.level != b.finding.level) return a.finding.level > b.finding.level;
    if (a.finding.level == Level::green) return false;
    // Findings about the whole drive precede findings about a mesh.
    if (a.mesh.has_value() != b.mesh.has_value()) return !a.mesh;
    return a.finding.code < b.finding.code;
  });
  Verdict verdict;
  if (!parts.empty()) verdict.level = parts.front().finding.level;
  // When a remedy is tried, the changed drive is neither rated nor analysed for contact.
  // Remedies are therefore tried only for a drive without ratings and without contact results.
  const auto worst = parts.empty() ? std::nullopt : parts.front().mesh;
  if (verdict.level != Level::green && worst && drive.geometry.pairs[*worst] &&
      drive.ratings.empty() && drive.contacts.empty())
    add_remedy(parts, drive, input, key_of, wanted);
  for (Part& part : parts) {
    Finding f = std::move(part.finding);
    if (part.mesh) {
      const std::string message = with_names(f.message, drive, *part.mesh);
      std::string where = drive.graph.meshes[*part.mesh].name;
      if (f.gear > 0) {
        const std::string& name = drive.graph.gears[gear_index(drive, *part.mesh, f.gear)].name;
        if (message.find(name) == std::string::npos) where = name;
      }
      f.message = fmt::format("{}: {}", where, message);
      f.remedy = with_names(f.remedy, drive, *part.mesh);
      f.gear = 0;
    }
    verdict.findings.push_back(std::move(f));
  }
  switch (verdict.level) {
    case Level::green: verdict.headline = running(drive); break;
    case Level::amber:
      verdict.headline = running(drive) + " Check: " + verdict.findings.front().whole();
      break;
    case Level::red:
      verdict.headline = "The drive does not run as specified: " + verdict.findings.front().whole();
      break;
  }
  return verdict;
}

}  // namespace gearwright
