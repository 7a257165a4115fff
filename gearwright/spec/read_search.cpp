#include "gearwright/spec/read_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/design/face_width.hpp"
#include "gearwright/design/search_space.hpp"
#include "gearwright/design/whole_overlap.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/spec/read_gear.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMaxAngles = 100'000;  // greatest number of angles in a range with a step

void check_teeth(TableReader& t, SearchProblem& p) {
  if (p.ratio[0] < 0.0 && p.ratio[1] >= 0.0)
    t.fail("ratio",
           "must not contain 0; the ratio is positive for external pairs and negative for internal "
           "pairs");
  if (p.ratio[0] >= 0.0 && p.ratio[1] < 1.0)
    t.fail("ratio",
           "must contain values of 1 or more, because the ratio is z2/z1, and z2 is at least z1");
  if (p.ratio[0] < 0.0 && p.ratio[0] >= -1.0)
    t.fail("ratio",
           "must contain values below -1, because an internal gear has more teeth than its pinion");
  const double most = std::max(std::abs(p.ratio[0]), std::abs(p.ratio[1])) * p.pinion_teeth[1];
  if (!(most <= kMaxSearchTeeth)) {
    t.fail("ratio", fmt::format("gives wheels of {1:.6g} teeth for pinions of {0} teeth, but at "
                                "most {2} teeth are allowed; narrow ratio or pinion_teeth",
                                p.pinion_teeth[1], most, kMaxSearchTeeth));
  }
  if (!t.has("target_ratio")) p.target_ratio = (p.ratio[0] + p.ratio[1]) / 2.0;
}

// Reads one helix angle, a range of angles with a step, or a list of angles.
void read_helix(TableReader& t, SearchProblem& p, double of_gear_deg) {
  const auto b = t.numbers("helix_angle_deg");
  const auto step = t.number("helix_step_deg");
  const auto list = t.numbers("helix_angles_deg");
  if (b && list)
    t.fail("helix_angles_deg", "contradicts helix_angle_deg; leave out one of the two");
  std::vector<double> degrees{of_gear_deg};
  if (list) degrees = *list;
  if (b) {
    degrees.clear();
    const double h = step.value_or(1.0);
    const double count = std::floor((b->back() - b->front()) / h + 1e-9);
    if (!(count < kMaxAngles))
      t.fail("helix_step_deg",
             fmt::format("gives {:.6g} angles in the band, but at most {} are allowed", count + 1,
                         kMaxAngles));
    for (int i = 0; i <= static_cast<int>(count); ++i) degrees.push_back(b->front() + i * h);
    // If the range is not a whole number of steps, its end is added.
    if (degrees.back() < b->back() - 1e-9 * h) degrees.push_back(b->back());
  } else if (step) {
    t.fail("helix_step_deg", "needs a band, helix_angle_deg = [least, greatest]");
  }
  const char* key = list ? "helix_angles_deg" : "helix_angle_deg";
  auto sorted = degrees;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    t.fail(key, fmt::format("contains {} twice", *twice));
  p.helix.clear();
  for (const double beta : degrees) {
    t.check(key, beta);
    if (p.shaft_angle && !(std::abs(p.shaft_angle->deg() - beta) < 89.0)) {
      t.fail(key, fmt::format("contains {}, which gives gear 2 a helix angle of {} degrees (the "
                              "shaft angle minus this angle); at most 89 degrees are allowed",
                              beta, p.shaft_angle->deg() - beta));
    }
    p.helix.push_back(Angle::degrees(beta));
  }
}

// Returns the number of combinations of module, face width and overlap ratio.
double count_of_overlaps(const SearchProblem& p, std::size_t ratios,
                         const std::array<double, 2>& band_deg) {
  double count = 0.0;
  for (const double module : p.modules) {
    const auto [least, most] = overlap_face_widths(p, module, band_deg);
    if (least <= most) count += std::floor((most - least) / p.face_step) + 1.0;
  }
  return count * static_cast<double>(ratios);
}

// Reads the overlap ratios, which are whole numbers, and computes the helix angles from them.
// `of_gear` is true if [gear1] has a helix angle that [search] does not replace.
void read_overlaps(TableReader& t, SearchProblem& p, bool of_gear) {
  const char* const key = "overlap_ratio";
  const auto ratios = t.numbers(key);
  if (!ratios) return;
  require_parallel(t, p, key,
                   "is not available on crossed axes, where the teeth have no overlap ratio");
  if (of_gear)
    t.fail(key,
           "determines the helix angles itself; leave out helix_angle_deg of [gear1], or give a "
           "band, helix_angle_deg = [least, greatest], in [search]");
  const auto given = t.numbers("helix_angle_deg");
  if (given && given->front() == given->back())
    t.fail(key,
           "determines the helix angles itself; leave out helix_angle_deg, or give a band, "
           "helix_angle_deg = [least, greatest]");
  std::array<double, 2> band = kUsualOverlapHelix_deg;
  if (given) band = {given->front(), given->back()};
  p.default_overlap_helix = !given;
  if (p.face_diameters)
    t.fail("face_width_diameters",
           "cannot be combined with overlap_ratio, because the helix angles are the same for all "
           "numbers of teeth; use face_width_mm or face_width_modules");
  if (!p.face_width && !p.face_modules) {
    if (!p.limits.safety_flank && !p.limits.safety_root)
      t.fail(key,
             "needs face widths, from which the helix angle follows; give face_width_mm or "
             "face_width_modules, or a required safety by safety_flank_min or safety_root_min in "
             "[search], with "
             "which all widths from 0.2 to 1 times the reference diameter of the pinion are tried");
    p.face_diameters = kUsualFace;
  }
  auto sorted = *ratios;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i] != std::floor(sorted[i]))
      t.fail(key, fmt::format("contains {}, but only whole numbers are allowed", sorted[i]));
    if (i > 0 && sorted[i] == sorted[i - 1])
      t.fail(key, fmt::format("contains {} twice", sorted[i]));
  }
  if (const double count = count_of_overlaps(p, sorted.size(), band); count > kMaxAngles)
    t.fail(key, fmt::format("gives {:.6g} combinations of module, face width and overlap ratio, "
                            "but at most {} are allowed; narrow the bands, or use a greater "
                            "face_width_step_mm",
                            count, kMaxAngles));
  p.overlap_ratios = sorted;
  p.overlap_helix_deg = band;
  set_overlap_choices(p);
  if (p.choices.empty()) {
    const auto any = whole_overlap_choices(p, sorted, {kLeastOverlapHelix_deg, 89.0});
    t.fail(key,
           any.empty()
               ? "has no helix angle between 1 and 89 degrees for any module and face width; the "
                 "face width must exceed overlap_ratio times the axial pitch at this angle"
               : fmt::format(
                     "needs helix angles of {} to {} degrees for these modules and face "
                     "widths, and none of them is in the band helix_angle_deg{}; change "
                     "the band or the face width",
                     format_number(any.front().helix.deg()), format_number(any.back().helix.deg()),
                     given ? "" : fmt::format(" (default: [{:g}, {:g}])", band[0], band[1])));
  }
}

void read_limits(TableReader& t, SearchProblem& p) {
  SearchLimits& l = p.limits;
  // By default, a search rejects pairs with interference.
  const bool word = t.given("interference");
  const bool avoid = t.boolean("avoid_interference").value_or(true);
  if (word && t.given("avoid_interference") && l.avoid_interference != avoid)
    t.fail("avoid_interference", "contradicts interference; leave out one of the two");
  if (!word) l.avoid_interference = avoid;
  l.clear_fillets = l.avoid_interference;
  if (l.avoid_interference) {
    if (!t.has("tip_clearance_min")) l.tip_clearance = kRunningTipClearance;
    if (!t.has("form_clearance_min")) l.form_clearance = kRunningFormClearance;
  } else if (l.form_clearance > 0.0) {
    t.fail("form_clearance_min", "needs interference = \"exclude\"");
  }
  if (l.sliding)
    require_parallel(t, p, "sliding_max",
                     "is not available on crossed axes, where the teeth also slide in the "
                     "direction of their length");
}

void check_objectives(const TableReader& t, const SearchProblem& p) {
  if (t.given("loaded_designs") && p.loaded_designs > 0 && !p.ranks_by(Objective::noise))
    t.fail("loaded_designs", "needs `noise` in `objective`; leave out this key, or set it to 0");
  if (!p.crossed()) return;
  for (const Objective objective : p.objectives) {
    if (objective == Objective::sliding)
      t.fail("objective", "sliding is not available on crossed axes");
    if (needs_rating(objective))
      t.fail("objective",
             fmt::format("{} is not available on crossed axes, because ISO 6336 covers parallel "
                         "axes only",
                         kObjectiveNames[static_cast<std::size_t>(objective)]));
  }
}

// The values of a [gearN] that a search reads. The search determines all other values.
struct Blank {
  std::optional<Angle> alpha;
  std::optional<double> helix_deg, face_mm;
  std::optional<StraightRack> rack;
};

Blank read_blank(const Json* node, const std::string& path) {
  Blank b;
  if (!node) return b;
  const bool whole = node->contains("teeth");  // a complete gear, from which the search may start
  if (!whole) {
    for (const Key& key : gear_keys().keys) {
      const std::string name(key.key);
      if (blank_keys().find(name) || !node->contains(name)) continue;
      TableReader(gear_keys(), *node, path)
          .fail(name, fmt::format("cannot be combined with [search], because this gear has no "
                                  "number of teeth; without the key teeth, the table [{}] may "
                                  "contain only {}",
                                  path, fmt::join(blank_keys().names(), ", ")));
    }
  }
  TableReader t(whole ? gear_keys() : blank_keys(), *node, path);
  if (const auto alpha_deg = t.number("normal_pressure_angle_deg"))
    b.alpha = Angle::degrees(*alpha_deg);
  b.helix_deg = t.number("helix_angle_deg");
  b.face_mm = t.number("face_width_mm");
  t.table("material");       // for a rated search; read by read_search_rating
  t.table("modifications");  // for the designs; read by spec.cpp
  if (const Json* rack = t.any("rack");
      rack && rack->is_object() && rack->contains("kind") && (*rack)["kind"] != "straight") {
    t.fail("rack.kind",
           "must be \"straight\" or absent, because a search covers involute gears "
           "only");
  }
  b.alpha = rack_angle(t, b.alpha);
  if (t.has("rack")) b.rack = read_straight_rack(t);
  if (b.rack && (b.rack->protuberance != 0.0 || b.rack->tip_fillet_radius != 0.0 ||
                 b.rack->semi_topping_angle)) {
    t.fail("rack",
           "has a protuberance, tip rounding or chamfer, which a search does not support; leave "
           "out these keys and add them to the pair after the search");
  }
  if (!whole) t.finish();
  return b;
}

// Returns the depth h_FfP* of the straight edge below the datum line.
double straight_depth(const StraightRack& rack, double alpha_n) {
  const double radius =
      rack.named ? std::min(rack.root_fillet_radius, full_radius(rack, Angle::radians(alpha_n)))
                 : rack.root_fillet_radius;
  return rack.dedendum - radius * (1.0 - std::sin(alpha_n));
}

// Completes the racks to be tried. Each rack of the list `racks` is used for both gears. Without
// this list, each gear has the rack of its own table. A gear 2 without a rack has the rack of gear
// 1. If no rack is found, the default rack remains.
void complete_racks(TableReader& t, SearchProblem& p, const std::array<Blank, 2>& blanks) {
  const bool list = t.given("racks");
  if (list && (blanks[0].rack || blanks[1].rack))
    t.fail("racks", "contradicts the rack of a gear; leave out one of the two");
  std::optional<double> depth;
  if (t.given("undercut_depth")) depth = p.racks.front().undercut_depth[0];
  const double alpha = p.normal_pressure_angle.rad();
  for (SearchRacks& racks : p.racks) {
    for (const std::size_t i : {0, 1}) {
      const auto& own = blanks[i].rack ? blanks[i].rack : blanks[0].rack;
      const bool given = list || own;
      if (own) racks.rack[i] = *own;
      racks.flank_depth[i] = straight_depth(racks.rack[i], alpha);
      if (given) {
        const auto edge = make_edge(racks.rack[i], 1.0, p.normal_pressure_angle);
        if (!edge)
          throw SpecError{spelled(
              list ? following_from("search.racks", "", "for one of the racks,", edge.error())
                   : of_gear(static_cast<int>(i) + 1, edge.error()))};
      }
      racks.undercut_depth[i] = depth ? *depth : given ? racks.flank_depth[i] : 1.0;
    }
  }
}

}  // namespace

void require_parallel(const TableReader& t, const SearchProblem& problem, const std::string& key,
                      const char* why) {
  if (problem.crossed()) t.fail(key, why);
}

SearchProblem read_search(const Json& search, const Json* gear_1, const Json* gear_2,
                          UnitSystem units) {
  TableReader t(search_keys(), search, "search");
  SearchProblem p;
  p.face_step = default_face_step(units);
  t.read(p);
  if (p.modules.empty()) p.modules = module_series("ISO54-I");
  const std::array<Blank, 2> blanks{read_blank(gear_1, "gear1"), read_blank(gear_2, "gear2")};
  const auto &one = blanks[0].alpha, &two = blanks[1].alpha;
  p.normal_pressure_angle = one ? *one : two.value_or(p.normal_pressure_angle);
  if (two && *two != p.normal_pressure_angle) {
    throw SpecError{{"gear2.normal_pressure_angle_deg", format_number(two->deg()),
                     fmt::format("both gears of a search need the same pressure angle, but the "
                                 "pressure angle of gear1 is {}",
                                 format_number(p.normal_pressure_angle.deg()))}};
  }
  t.require_all();
  check_teeth(t, p);
  if (p.shaft_angle && p.internal())
    t.fail(
        "shaft_angle_deg",
        "cannot be used for internal pairs, because a search supports internal pairs only on "
        "parallel axes; leave out this key, or describe the pair by [gear1], [gear2] and [pair]");
  const double half = p.shaft_angle ? p.shaft_angle->deg() / 2.0 : 0.0;
  read_helix(t, p, blanks[0].helix_deg.value_or(half));
  complete_racks(t, p, blanks);
  if (!p.face_width && !p.face_modules && !p.face_diameters && blanks[0].face_mm)
    p.face_width = {*blanks[0].face_mm, *blanks[0].face_mm};
  const auto single = [](const auto& band) { return band && (*band)[0] == (*band)[1]; };
  if (single(p.face_width) && single(p.face_modules))
    t.fail("face_width_modules", "contradicts face_width_mm; leave out one of the two");
  read_overlaps(t, p, blanks[0].helix_deg && !t.has("helix_angle_deg"));
  // An internal pair has negative backlash at the extended centre distance, so its default
  // mounting is tight.
  if (!t.given("mounting")) p.mounting = p.ratio[1] < 0.0 ? Mounting::tight : Mounting::extended;
  read_limits(t, p);
  check_objectives(t, p);
  t.finish();
  return p;
}

}  // namespace gearwright
