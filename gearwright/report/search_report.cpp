#include "gearwright/report/search_report.hpp"

#include <fmt/format.h>

#include "gearwright/base/units.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/page_style.hpp"
#include "gearwright/report/search_section.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/report/shown_values.hpp"

namespace gearwright {

namespace {

std::string band(const std::array<double, 2>& limits) {
  return limits[0] == limits[1] ? fmt::format("{:.6g}", limits[0])
                                : fmt::format("{:.6g} … {:.6g}", limits[0], limits[1]);
}

std::string kind_of(const SearchProblem& problem) {
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
  if (problem.center_distance)
    kind += ", centre distance " + band(*problem.center_distance) + " mm";
  return kind;
}

std::string foot(const SearchReport& report) {
  const std::string version = report.version.empty() ? "" : " " + escaped(report.version);
  return fmt::format(
      "<footer>\n<p>Gearwright{}. Nominal geometry of gears cut by racks; symbols and terms of ISO "
      "21771. Lengths in mm, angles in degrees, profile shifts and regions in normal modules, "
      "“{}”: "
      "there is no such value.</p>\n<p>Every combination of module and tooth numbers is tried; its "
      "profile shifts are not: the region that the limits leave them is solved exactly. "
      "Manufacturing deviations, load and strength are not considered.</p>\n</footer>\n",
      version, kNoValue);
}

}  // namespace

std::string search_report(const SearchReport& report) {
  const SearchProblem& problem = report.search.problem();
  const std::string title =
      report.title.empty() ? "Design search, ratio " + band(problem.ratio) : report.title;
  std::string page = page_head(title, report.version, search_style());
  page += fmt::format(
      "<body>\n<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p "
      "class=\"verdict\">{}</p>\n</header>\n<main>\n",
      escaped(kind_of(problem)), escaped(title), search_verdict(report));
  page += with_contents(search_sections(report) + spec_section(report.spec_text)) + "</main>\n" +
          foot(report);
  page += fmt::format("<script>{}{}</script>\n</body>\n</html>\n", page_script(), sort_script());
  return page;
}

}  // namespace gearwright
