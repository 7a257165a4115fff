#include "gearwright/report/search_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/search_figures.hpp"

namespace gearwright {

namespace {

std::string band(const std::array<double, 2>& limits) {
  return limits[0] == limits[1] ? fmt::format("{:.6g}", limits[0])
                                : fmt::format("{:.6g} … {:.6g}", limits[0], limits[1]);
}

std::string kind_of(const SearchProblem& problem, UnitSystem units) {
  const bool helical = [&] {
    for (const Angle beta : problem.helix)
      if (beta != Angle()) return true;
    return false;
  }();
  std::string kind = "Design search, ";
  if (problem.crossed()) {
    kind += fmt::format("crossed helical gears, shaft angle {:.8g}°", problem.shaft_angle->deg());
  } else {
    kind += fmt::format("{} gears{}", helical ? "helical" : "spur",
                        problem.internal() ? ", internal" : "");
  }
  kind += ": ratio " + band(problem.ratio);
  if (problem.center_distance) {
    const auto [least, most] = *problem.center_distance;
    kind += fmt::format(", centre distance {} {}",
                        band({value_in(units, Unit::mm, least), value_in(units, Unit::mm, most)}),
                        unit_text(units, Unit::mm));
  }
  return kind;
}

std::string rejected_table(const SearchCounts& counts) {
  if (counts.tested == counts.feasible) return {};
  std::vector<std::vector<std::string>> rows;
  for (const auto& [words, n, of_verdict] : rejected_by(counts)) {
    const double share = 100.0 * static_cast<double>(n) / static_cast<double>(counts.tested);
    rows.push_back({of_verdict ? "of these: " + words : words, counted(n),
                    fixed(share, share < 1.0 ? 3 : 1) + "\u00a0%"});
  }
  return value_table(
      "Rejected trials; each trial counts for the first limit that leaves no permissible profile "
      "shift",
      {"Limit", "Trials", "Share of all"}, rows, "tally");
}

std::string reason_list(const std::vector<SearchReason>& reasons) {
  if (reasons.empty()) return {};
  std::string text = "<ul class=\"reasons\">\n";
  bool inner = false;  // true while changes are written, which form an inner list
  for (const auto& [reason, is_change] : reasons) {
    if (is_change != inner) text += is_change ? "<ul>\n" : "</ul>\n";
    inner = is_change;
    text += "<li>" + escaped(reason) + "</li>\n";
  }
  return text + (inner ? "</ul>\n" : "") + "</ul>\n";
}

std::string tried_section(const SearchReport& report) {
  const bool none = report.answer.counts.feasible == 0;
  const std::string lists = reason_list(report.reasons) + rejected_table(report.answer.counts);
  if (lists.empty()) return {};
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n",
                     none ? "Why no design is feasible" : "Rejected trials", lists);
}

std::string table_section(const SearchReport& report) {
  const SearchProblem& problem = report.search.problem();
  const SearchAnswer& answer = report.answer;
  const std::size_t shown = std::min(report.rows, answer.designs.size());
  const auto* const end = answer.designs.data() + shown;
  const bool interferes = std::any_of(answer.designs.data(), end,
                                      [](const DesignRow& row) { return row.interference; });
  const bool all = static_cast<std::int64_t>(shown) == answer.counts.feasible;
  return fmt::format(
      "<section>\n<h2>Designs</h2>\n<p>{} {}. Profile shifts are in modules.{}<span "
      "id=\"sort-hint\" hidden> Click a heading to sort by its column, and click again to reverse "
      "the order.</span></p>\n{}{}</section>\n",
      all ? fmt::format("All {} designs, sorted", counted(answer.counts.feasible))
          : fmt::format("The best {} of {} designs, sorted",
                        counted(static_cast<std::int64_t>(shown)), counted(answer.counts.feasible)),
      escaped(order_in_words(problem)),
      interferes ? "" : " None of these designs has interference.",
      design_table(problem, answer, report.rows, report.units),
      design_table_key(problem, answer, report.rows, report.units));
}

std::string picture_section(const SearchReport& report) {
  const SearchProblem& problem = report.search.problem();
  const DesignRow& best = report.answer.designs.front();
  return "<section>\n<h2>The best design and the other designs</h2>\n" + picture_hint() +
         side_by_side(shift_region_figure(report.search.graph(best.trial), best, report.units) +
                      pareto_figure(problem, report.answer, report.units)) +
         "</section>\n";
}

std::string thumbnail_section(const SearchReport& report) {
  const std::size_t n = std::min({kRegionPictures, report.rows, report.answer.designs.size()});
  if (n < 2) return {};
  std::string text = fmt::format(
      "<section>\n<h2>Feasible profile shifts of the best {} designs</h2>\n<p>In each picture, {} "
      "increases to the right, and {} increases upwards. The filled region contains the shifts "
      "within the limits, and the dot is the design. A large region allows later changes. A narrow "
      "region or a line allows hardly any other profile shifts.</p>\n<div class=\"multiples\">\n",
      n, symbol_html("x_1"), symbol_html("x_2"));
  for (std::size_t i = 0; i < n; ++i) {
    const DesignRow& row = report.answer.designs[i];
    text +=
        shift_region_thumbnail(report.search.graph(row.trial), row, fmt::format("region-{}", i + 1),
                               fmt::format("#design-{}", i + 1));
  }
  return text + "</div>\n</section>\n";
}

std::string chart_section(const SearchReport& report) {
  const SearchProblem& problem = report.search.problem();
  const DesignRow* best = report.answer.designs.empty() ? nullptr : &report.answer.designs.front();
  Trial trial;  // of the best design, or the first rack and helix angle if there is no design
  trial.helix = {problem.helix.front(), Angle()};
  if (best != nullptr) trial = best->trial;
  return "<section>\n<h2>Limits for each number of teeth</h2>\n" + (best ? "" : picture_hint()) +
         side_by_side(shift_limits_figure(problem, trial, best) +
                      identical_gears_figure(problem, trial)) +
         "</section>\n";
}

// Returns words for the dimensions that have tolerances in the designs. The words complete the
// phrase "the tolerances of". The result is empty if no dimension has a tolerance.
std::string toleranced(const SearchAllowances& allowances) {
  const bool teeth = !allowances.series.empty() ||
                     (allowances.backlash && (*allowances.backlash)[0] < (*allowances.backlash)[1]);
  const bool distance = allowances.distance_tolerance.has_value();
  if (teeth && distance) return "the tooth thicknesses and of the centre distance";
  if (teeth) return "the tooth thicknesses";
  return distance ? "the centre distance" : "";
}

// Returns sentences that state whether the numbers of the designs include load, strength and
// tolerances.
std::string included(const SearchProblem& problem) {
  const std::string with = toleranced(problem.allowances);
  if (with.empty() && !problem.rating)
    return "Manufacturing deviations, load and strength are not considered.";
  std::string text = "Load and strength are not considered.";
  if (problem.rating) {
    text = fmt::format(
        "Strength is rated by {}. Load is considered only in this rating{}.",
        name(problem.rating->input.edition),
        problem.ranks_by(Objective::noise) ? " and in the transmission error under load" : "");
  }
  if (with.empty()) return text + " The geometry includes no manufacturing deviations.";
  return text +
         fmt::format(
             " The backlash of a design is given at the ends of the tolerances of {}, and all "
             "other numbers for their mean. No other manufacturing deviations are included.",
             with);
}

std::string foot(const SearchProblem& problem, UnitSystem units) {
  return fmt::format(
      "The geometry is that of gears cut by racks. Symbols and terms are those of "
      "ISO 21771. Lengths are in {}, angles in degrees, profile shifts and regions in normal "
      "modules; “{}” means that there is no such value.</p>\n<p>Every combination of module and "
      "numbers of teeth is tried. The profile shifts of a combination are not sampled, because "
      "their region within the limits is computed exactly. {}",
      to_string(units), kNoValue, included(problem));
}

std::string search_verdict(const SearchReport& report) {
  const SearchCounts& counts = report.answer.counts;
  std::string text = fmt::format(
      "{} combinations of module and numbers of teeth were tried, and {} of them satisfy the "
      "limits.",
      counted(counts.tested), counts.feasible == 0 ? "none" : counted(counts.feasible));
  if (report.answer.designs.empty()) return text;
  const DesignRow& best = report.answer.designs.front();
  text += fmt::format(
      " The best design by {} has module {:.10g}\u00a0mm, {}:{} teeth, {}\u00a0=\u00a0{}, "
      "{}\u00a0=\u00a0{}",
      words_of(report.search.problem().objectives.front()).name, best.trial.module, best.trial.z1,
      best.trial.z2, symbol_html("x_1"), fixed(best.shift[0], 4), symbol_html("x_2"),
      fixed(best.shift[1], 4));
  text += fmt::format(", centre distance {} {}, contact ratio {}.",
                      text_in(report.units, Unit::mm, best.center_distance, kLengthDigits),
                      unit_text(report.units, Unit::mm), fixed(best.contact_ratio, 3));
  return text;
}

std::string search_sections(const SearchReport& report) {
  std::string text;
  const bool any = !report.answer.designs.empty();
  if (!any) text += tried_section(report);
  if (any) text += table_section(report) + picture_section(report) + thumbnail_section(report);
  text += chart_section(report);
  if (any) text += tried_section(report);
  return text;
}

}  // namespace

std::string search_report(const SearchReport& report) {
  const SearchProblem& problem = report.search.problem();
  return page_html(
      {.title = report.title.empty() ? "Design search, ratio " + band(problem.ratio) : report.title,
       .kind = escaped(kind_of(problem, report.units)),
       .verdict = search_verdict(report),
       .sections = search_sections(report),
       .spec = report.spec_text,
       .foot = foot(problem, report.units),
       .style = search_style(),
       .script = sort_script()});
}

namespace {

std::string table_of(const StudyReport& report) {
  const std::size_t count = std::min(kStudyRows, report.rows.size());
  const auto first = report.rows.begin();
  std::string text =
      sortable_table(report.columns, {first, first + static_cast<std::ptrdiff_t>(count)});
  if (count < report.rows.size())
    text += fmt::format("<p>The files contain {} more designs.</p>\n", report.rows.size() - count);
  return text + column_key(report.columns);
}

std::string figure_of(const StudyReport& report) {
  if (report.rows.empty()) return {};
  RankingScene scene{"scatter-ranking", "transmission error, peak to peak", "″", report.percentile,
                     report.ranking};
  scene.entries.resize(std::min(kStudyDots, scene.entries.size()));
  return picture_hint() + side_by_side(figure_html(ranking_figure(scene)));
}

std::string refused_section(const StudyReport& report) {
  if (report.refused.empty()) return {};
  std::string text =
      "<section>\n<h2>Designs without scatter results</h2>\n<ul class=\"reasons\">\n";
  for (const std::string& line : report.refused) text += "<li>" + escaped(line) + "</li>\n";
  return text + "</ul>\n</section>\n";
}

}  // namespace

std::string study_report(const StudyReport& report) {
  return page_html({.title = report.title,
                    .kind = "Designs ranked under tolerances",
                    .verdict = escaped(report.sentence),
                    .sections = "<section>\n<h2>Ranking</h2>\n" + figure_of(report) +
                                table_of(report) + "</section>\n" + refused_section(report),
                    .spec = report.spec_text,
                    .foot = "The teeth are rigid. The samples of every design are computed as by "
                            "<code>gearwright scatter</code>.",
                    .style = search_style(),
                    .script = sort_script()});
}

}  // namespace gearwright
