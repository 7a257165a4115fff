#include "gearwright/report/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/search_table.hpp"

namespace gearwright {

namespace {

std::string table_of(const StudyReport& report) {
  std::vector<TableColumn> columns;
  for (const StudyReport::Column& c : report.columns)
    columns.push_back({escaped(c.head), c.unit, c.meaning});
  std::vector<TableRow> rows;
  const std::size_t count = std::min(kStudyRows, report.rows.size());
  for (std::size_t i = 0; i < count; ++i) {
    TableRow& row = rows.emplace_back();
    for (const StudyReport::Cell& cell : report.rows[i].cells)
      row.cells.push_back({escaped(cell.text), cell.key});
  }
  std::string text = sortable_table(columns, rows);
  if (count < report.rows.size())
    text += fmt::format("<p>The files contain {} more designs.</p>\n", report.rows.size() - count);
  return text + column_key(columns);
}

std::string figure_of(const StudyReport& report) {
  if (report.rows.empty()) return {};
  RankingScene scene{
      "scatter-ranking", "transmission error, peak to peak", "″", report.percentile, {}};
  for (std::size_t i = 0; i < std::min(kStudyDots, report.rows.size()); ++i) {
    const StudyReport::Row& r = report.rows[i];
    scene.entries.push_back({r.words, r.percentile, r.mean, r.lower, r.upper});
  }
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
  std::string page = page_head(report.title, report.version, search_style());
  page += fmt::format(
      "<body>\n<header>\n<p class=\"kind\">Designs ranked under tolerances</p>\n<h1>{}</h1>\n<p "
      "class=\"verdict\">{}</p>\n</header>\n<main>\n",
      escaped(report.title), escaped(report.sentence));
  page += with_contents("<section>\n<h2>Ranking</h2>\n" + figure_of(report) + table_of(report) +
                        "</section>\n" + refused_section(report) + spec_section(report.spec_text)) +
          "</main>\n";
  page += fmt::format(
      "<footer>\n<p>Gearwright{}. The teeth are rigid. The samples of every design are "
      "computed as for the verb scatter.</p>\n</footer>\n",
      report.version.empty() ? "" : " " + escaped(report.version));
  return page + page_end(sort_script());
}

}  // namespace gearwright
