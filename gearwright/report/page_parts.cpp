#include "gearwright/report/page_parts.hpp"

#include <fmt/format.h>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

std::string FigureForm::html(Figure figure, double width, std::string_view control) const {
  if (is_in(figure.id, above)) return {};
  figure.id = prefix + figure.id;
  return figure_html(in_units(units, std::move(figure)), width, "", control);
}

std::string FigureForm::html(std::optional<Figure> figure) const {
  return figure ? html(std::move(*figure)) : std::string();
}

std::string FigureForm::row(const std::vector<std::optional<Figure>>& figures,
                            const std::string& more) const {
  std::string shown;
  bool moved = false;
  for (const auto& figure : figures) {
    const std::string one = html(figure);
    moved = moved || (figure && one.empty());
    shown += one;
  }
  shown += more;
  if (shown.empty() && moved) return "<p>The figure is at the head of the report.</p>\n";
  return side_by_side(shown);
}

std::string page_head(std::string_view title, std::string_view more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
      "content=\"Gearwright "
      "{}\">\n<title>{}</title>\n<style>{}{}{}</style>\n</head>\n",
      kVersion, escaped(title), figure_style(), page_style(), more_style);
}

std::string picture_hint() {
  return "<p class=\"hint\" id=\"hint\" hidden>In each picture, the wheel zooms, dragging moves, "
         "and a double click restores the view. The keys +, −, 0 and the arrow keys do the "
         "same.</p>\n";
}

std::string with_contents(const std::string& sections) {
  constexpr std::string_view kOpen = "<h2>", kClose = "</h2>";
  constexpr int kWorthIt = 4;
  std::string text, links;
  std::size_t from = 0;
  int count = 0;
  for (std::size_t at = sections.find(kOpen); at != std::string::npos;
       at = sections.find(kOpen, from)) {
    const std::size_t begin = at + kOpen.size(), end = sections.find(kClose, begin);
    ++count;
    links += fmt::format("<a href=\"#part-{}\">{}</a>\n", count,
                         std::string_view(sections).substr(begin, end - begin));
    text += sections.substr(from, at - from) + fmt::format("<h2 id=\"part-{}\">", count);
    from = begin;
  }
  text += sections.substr(from);
  if (count < kWorthIt) return text;
  return "<nav class=\"contents\" aria-label=\"Contents\">\n" + links + "</nav>\n" + text;
}

namespace {

std::string spec_section(const std::string& spec) {
  if (spec.empty()) return {};
  return fmt::format(
      "<section>\n<h2>Specification</h2>\n<details><summary>The specification from which "
      "this report was made</summary>\n<pre>{}</pre></details>\n</section>\n",
      escaped(spec));
}

constexpr int kPitchSteps = 120;  // steps per pitch, of the slider and of the arrow keys

}  // namespace

std::string page_html(const ReportPage& page) {
  const std::string level = page.level.empty() ? "" : fmt::format("<b>{}</b> ", page.level);
  return page_head(page.title, page.style) + "<body>\n" + page.definitions +
         fmt::format(
             "<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"verdict{}{}\">{}{}</p>\n"
             "{}</header>\n<main>\n{}</main>\n<footer>\n<p>Gearwright {}. {}</p>\n</footer>\n",
             page.kind, escaped(page.title), level.empty() ? "" : " ", page.level, level,
             page.verdict, page.head, with_contents(page.sections + spec_section(page.spec)),
             kVersion, page.foot) +
         fmt::format("<script>{}{}{}{}</script>\n</body>\n</html>\n", figure_script(),
                     zoom_script(), page_script(), page.script);
}

std::string turn_control(const InvolutePair& pair) {
  return fmt::format(
      "<div class=\"turn\" data-pitch=\"{:.12g}\" hidden><button type=\"button\">Turn</button> "
      "<label>Gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"{:.9g}\" "
      "value=\"0\"></label> <output>0.00°</output></div>\n",
      turn_per_pitch(pair, 0), 1.0 / kPitchSteps);
}

}  // namespace gearwright
