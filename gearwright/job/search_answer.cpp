#include "gearwright/job/search_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/loaded_designs.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/search_reasons.hpp"
#include "gearwright/report/search_report.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// If there are more designs than this, the boundaries of their regions are omitted. Each curve of a
// boundary has 25 points.
constexpr std::size_t kMaxBoundaries = 10'000;

Value edges_of(const Search& search, const DesignRow& row) {
  const ShiftGraph graph = search.graph(row.trial);
  const auto region = shift_region(graph);
  ValueList edges;
  if (!region) return edges;
  for (const auto& loop : region_boundary(graph, *region)) {
    for (const RegionEdge& e : loop) {
      ValueList points(e.points.begin(), e.points.end());
      edges.push_back(ValueMap{{"constraint", name(e.edge)}, {"points", std::move(points)}});
    }
  }
  return edges;
}

// Returns a value from the table of a gear. If gear 2 lacks the value, returns that of gear 1.
Json of_gear(const Json& tree, int which, const char* key) {
  for (const char* table : {which == 0 ? "gear1" : "gear2", "gear1"})
    if (tree.contains(table) && tree[table].contains(key)) return tree[table][key];
  return nullptr;
}

Json rack_of(const Json& tree, int rack, int which) {
  if (tree["search"].contains("racks"))
    return tree["search"]["racks"][static_cast<std::size_t>(rack)];
  return of_gear(tree, which, "rack");
}

// Returns the face width in words, for example "10 mm to 120 mm (the least sufficient width)".
std::string face_words(const SearchProblem& p) {
  std::string words;
  const auto add = [&](const std::optional<std::array<double, 2>>& band, const char* unit) {
    if (!band) return;
    if (!words.empty()) words += " and ";
    words += (*band)[0] == (*band)[1]
                 ? fmt::format("{:g}{}", (*band)[0], unit)
                 : fmt::format("{0:g}{2} to {1:g}{2} ({3})", (*band)[0], (*band)[1], unit,
                               p.choices.empty() ? "the least sufficient width"
                                                 : "every width with its helix angles");
  };
  add(p.face_width, " mm");
  add(p.face_modules, " modules");
  add(p.face_diameters, " d_1");
  return words.empty() ? fmt::format("{:g} modules", kFaceModules) : words;
}

// Tables of the spec that apply to a pair. A search copies these tables to the specs of its designs,
// and uses them only for the transmission error under load (job/loaded_designs.hpp).
constexpr const char* kPairTables[] = {"errors", "contact", "load", "compensate", "scatter"};

Json rating_of(const Json& tree, const SearchLimits& limits) {
  Json rating = tree["rating"];
  if (limits.safety_flank) rating["safety_flank_min"] = *limits.safety_flank;
  if (limits.safety_root) rating["safety_root_min"] = *limits.safety_root;
  return rating;
}

// Returns the conditions that all designs satisfy, for example "every design runs without
// interference and has a form clearance ≥ 0.02 modules, tip clearance ≥ 0.2 modules". If designs
// with interference are allowed, the text begins with this fact instead of the first condition.
std::string margin_line(const SearchLimits& limits) {
  std::string text =
      limits.avoid_interference
          ? fmt::format(
                "every design runs without interference and has a form clearance ≥ {:g} modules",
                limits.form_clearance)
          : "the list includes designs with interference";
  if (limits.tip_clearance)
    text += fmt::format(", tip clearance ≥ {:g} modules", *limits.tip_clearance);
  return text;
}

}  // namespace

Json design_row_json(const Search& search, const DesignRow& row, bool with_edges) {
  DesignView view{&search.problem(), &row};
  if (with_edges) view.edges = [&] { return edges_of(search, row); };
  return to_json(design_quantities().of(view));
}

namespace {

bool has_boundaries(const SearchRun& run) { return run.answer.designs.size() <= kMaxBoundaries; }

Json search_head(const SearchRun& run) {
  Json head = to_json(search_quantities().of(run));
  head.erase("designs");
  return head;
}

std::vector<Warning> search_warnings(const SearchRun& run) {
  const SearchAnswer& a = run.answer;
  std::vector<Warning> warnings;
  const auto warn = [&](WarningCode code, const std::string& message) {
    warnings.push_back({code, message});
  };
  if (a.cut) {
    warn(WarningCode::designs_cut,
         fmt::format("The best {1} of {0} feasible designs are listed. The file search.parquet in "
                     "--out DIR contains all designs.",
                     a.counts.feasible, a.designs.size()));
  }
  if (run.pair_not_read) warn(WarningCode::not_read, std::string(kPairNotRead));
  if (run.teeth_not_read) warn(WarningCode::not_read, std::string(kTeethNotRead));
  if (run.rating_not_read) {
    warn(WarningCode::not_read,
         "The table [rating] has no effect on this search. This table is used only with "
         "safety_flank_min, safety_root_min or one of the objectives safety, balance and noise in "
         "[search].");
  }
  if (!has_boundaries(run)) {
    warn(WarningCode::edges_left_out,
         fmt::format("The borders of the regions are omitted, because there are more than {} "
                     "designs. Use --top N for fewer designs.",
                     kMaxBoundaries));
  }
  for (const std::string& line : load_failures(a)) warn(WarningCode::no_load, line);
  if (!run.changes_left_out.empty())
    warn(WarningCode::changes_left_out, run.changes_left_out + ".");
  return warnings;
}

}  // namespace

Json search_json(const Search& search, const SearchRun& run, UnitSystem units) {
  Json result = search_head(run);
  Json& designs = result["designs"] = Json::array();
  for (const DesignRow& row : run.answer.designs)
    designs.push_back(design_row_json(search, row, has_boundaries(run)));
  return in_units(
      units, {{"search", std::move(result)}, {"warnings", warnings_json(search_warnings(run))}});
}

std::string search_json_text(const Search& search, const SearchRun& run, UnitSystem units) {
  if (units != UnitSystem::mm) return json_text(search_json(search, run, units), 2) + "\n";
  std::string text = "{\n  \"search\": " + json_text(search_head(run));
  const auto& designs = run.answer.designs;
  if (!has_boundaries(run))
    text.reserve(designs.size() * 1000);  // avoids a copy of the whole text while it grows
  add_row_lines(text, "designs", designs.size(), [&](std::size_t i) {
    return design_row_json(search, designs[i], has_boundaries(run));
  });
  return text + ",\n  \"warnings\": " + json_text(warnings_json(search_warnings(run))) + "\n}\n";
}

Json unfinished_json(const SearchRun& run) {
  return {{"search",
           {{"finished", false},
            {"stopped", run.stopped},
            {"chunks_done", run.chunks_done},
            {"chunks", run.chunks}}},
          {"warnings", Json::array()}};
}

std::string rating_line(const SearchProblem& problem) {
  if (!problem.rating) return {};
  const RatingInput& in = problem.rating->input;
  const auto& output = problem.rating->output_torque;
  const SearchLimits& limits = problem.limits;
  std::string text =
      fmt::format("rated by {}, {:g} N m on gear {}, face width {}", name(in.edition),
                  output.value_or(in.torque), output ? 2 : 1, face_words(problem));
  if (limits.safety_flank) text += fmt::format(", S_H ≥ {:g}", *limits.safety_flank);
  if (limits.safety_root) text += fmt::format(", S_F ≥ {:g}", *limits.safety_root);
  return text;
}

std::string drawing_line(const SearchProblem& problem) {
  if (!problem.draw) return {};
  const SearchAllowances& a = problem.allowances;
  std::string text = fmt::format(
      "drawn and checked as by `gearwright run`: mounting {}, {}",
      problem.mounting == Mounting::tight ? "tight" : "extended",
      a.backlash ? fmt::format("backlash {:g} mm … {:g} mm", (*a.backlash)[0], (*a.backlash)[1])
      : a.series.empty() ? std::string("nominal teeth")
                         : "thickness series " + a.series);
  if (a.distance_tolerance) text += ", centre distance " + *a.distance_tolerance;
  const SearchLimits& l = problem.limits;
  if (l.min_shift && l.max_shift)
    text += fmt::format(", {:g} <= x <= {:g}", *l.min_shift, *l.max_shift);
  if (l.sliding) text += fmt::format(", |ζ| <= {:g}", *l.sliding);
  return text;
}

std::vector<std::string> change_lines(const SearchRun& run, UnitSystem units) {
  std::vector<std::string> lines;
  for (const NearestChange& c : run.changes) {
    const SpelledChange spelled = spelled_change(c, units);
    lines.push_back(fmt::format("{} = {} instead of {}", spelled.key, spelled.to, spelled.from));
  }
  return lines;
}

std::string search_listing(const Search& search, const SearchRun& run, UnitSystem units) {
  const SearchAnswer& a = run.answer;
  const SearchProblem& p = search.problem();
  std::string text =
      fmt::format("{} candidates (module, z1, z2{}) were tested, and {} are feasible\n",
                  a.counts.tested, p.helix.size() > 1 ? ", helix" : "", a.counts.feasible);
  for (const auto& [words, trials, of_verdict] : rejected_by(a.counts))
    text += fmt::format("  {}{}: {}\n", of_verdict ? "  " : "", words, trials);
  text += wrapped(margin_line(p.limits));
  if (p.shift_step) {
    text += fmt::format("{} of {} points of the grid of profile shifts are feasible (step {})\n",
                        a.counts.points_feasible, a.counts.points_tested, *p.shift_step);
  }
  for (const auto& [line, is_change] : reasons_of(p, run, units))
    text += is_change ? line + "\n" : wrapped(line);  // a change stays on one line
  if (a.counts.feasible == 0) return text;
  text += wrapped(fmt::format("Designs are ranked {}.", order_in_words(p)));
  ListingColumn places{"profile shifts", "profile shifts", "", {}, true};
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < a.designs.size() && i < kListedDesigns; ++i) {
    places.cells.emplace_back(a.designs[i].balanced ? "balanced" : "middle");
    records.push_back(design_quantities().of({&p, &a.designs[i]}));
  }
  text += ranked_listing(units, a.pareto, std::move(places), records,
                         {"module_mm",
                          "normal_diametral_pitch_per_in",
                          "teeth",
                          "helix_angle_deg",
                          "ratio",
                          "center_distance_mm",
                          "profile_shift",
                          "contact_ratio",
                          "contact_ratio_true",
                          "sliding_max",
                          "face_width_mm",
                          "overlap_ratio",
                          "backlash_mm",
                          "S_H",
                          "S_F",
                          "mass_kg",
                          "efficiency",
                          "balance",
                          "relative_cost",
                          "noise_um",
                          "loaded_noise_um",
                          "area",
                          "interference"});
  if (a.counts.feasible > static_cast<std::int64_t>(kListedDesigns)) {
    text += wrapped(
        fmt::format("  … {} more designs; --out DIR writes all of them, and --take N writes one "
                    "design as the spec of a pair",
                    a.counts.feasible - static_cast<std::int64_t>(kListedDesigns)));
  } else {
    text += "\nThe option --take NUMBER > pair.toml writes the spec of a design.\n";
  }
  return text;
}

void add_grade(Json& gear, const RatingInput& rating, std::size_t which) {
  const bool own = gear.contains("tolerance") && gear["tolerance"].contains("quality");
  const FlankTolerances edition = tolerance_edition(rating.edition);
  if (!rating.quality || !has_class(edition, (*rating.quality)[which]) || own ||
      gear.contains("quality"))
    return;
  gear["tolerance"]["quality"] = (*rating.quality)[which];
  if (edition == FlankTolerances::iso_1995) gear["tolerance"]["edition"] = "ISO 1328:1995";
}

Json pair_spec(const JobSpec& spec, const Search& search, const DesignRow& row) {
  const SearchProblem& p = search.problem();
  const Json& tree = spec.tree->tables;
  Json j;
  j["title"] = fmt::format("{}{}:{}, {}", spec.title.empty() ? "" : spec.title + ", ", row.trial.z1,
                           row.trial.z2, size_words(p, row.trial.module));
  const std::array<int, 2> teeth{row.trial.z1, row.trial.z2};
  for (int i = 0; i < 2; ++i) {
    Json g;
    g["teeth"] = teeth[i];
    if (p.by_pitch)
      g["normal_diametral_pitch_per_in"] = without_rounding_error(kMmPerInch / row.trial.module);
    else
      g["normal_module_mm"] = row.trial.module;
    g["normal_pressure_angle_deg"] = tidy_degrees(p.normal_pressure_angle);
    g["helix_angle_deg"] = tidy_degrees(row.trial.helix[i]);
    g["profile_shift"] = row.shift[i];
    g["face_width_mm"] = row.face_width;
    if (p.rating) add_grade(g, p.rating->input, static_cast<std::size_t>(i));
    if (!p.allowances.series.empty()) g["tolerance"]["thickness_series"] = p.allowances.series;
    if (const Json rack = rack_of(tree, row.trial.rack, i); !rack.is_null()) g["rack"] = rack;
    if (const Json material = of_gear(tree, i, "material"); p.rating && !material.is_null())
      g["material"] = material;
    const char* const table = i == 0 ? "gear1" : "gear2";
    if (tree.contains(table) && tree[table].contains("modifications"))
      g["modifications"] = tree[table]["modifications"];
    j[table] = std::move(g);
  }
  Json pair;
  pair["center_distance_mm"] = row.center_distance;
  if (p.crossed()) pair["shaft_angle_deg"] = tidy_degrees(*p.shaft_angle);
  pair["mounting"] = p.mounting == Mounting::tight ? "tight" : "extended";
  if (p.shorten_tips) pair["shorten_tips"] = true;
  if (const auto friction = p.flank_friction()) pair["friction_coefficient"] = *friction;
  if (const auto& ends = p.allowances.backlash) {
    if ((*ends)[0] == (*ends)[1]) {
      pair["backlash_mm"] = (*ends)[0];
    } else {
      pair["backlash_mm"] = *ends;
    }
  }
  if (p.allowances.distance_tolerance)
    pair["center_distance_tolerance"] = *p.allowances.distance_tolerance;
  j["pair"] = std::move(pair);
  if (p.rating) j["rating"] = rating_of(tree, p.limits);
  for (const char* table : kPairTables)
    if (tree.contains(table)) j[table] = tree[table];
  return j;
}

std::string search_page(const JobSpec& spec, const Search& search, const SearchRun& run) {
  return search_report({.title = spec.title,
                        .spec_text = spec.text,
                        .search = search,
                        .answer = run.answer,
                        .reasons = reasons_of(search.problem(), run, spec.units()),
                        .units = spec.units()});
}

}  // namespace gearwright
