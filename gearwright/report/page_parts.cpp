#include "gearwright/report/page_parts.hpp"

#include <fmt/format.h>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/mesh.hpp"

namespace gearwright {

std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
      "content=\"Gearwright "
      "{}\">\n<title>{}</title>\n<style>{}{}{}</style>\n</head>\n",
      escaped(version), escaped(title), figure_style(), page_style(), more_style);
}

std::string page_end(std::string_view own_script) {
  return fmt::format("<script>{}{}{}{}</script>\n</body>\n</html>\n", figure_script(),
                     zoom_script(), page_script(), own_script);
}

std::string picture_hint() {
  return "<p class=\"hint\" id=\"hint\" hidden>In each picture, the wheel zooms, dragging moves, "
         "and a double click restores the view. The keys +, −, 0 and the arrow keys do the "
         "same.</p>\n";
}

std::string spec_section(const std::string& spec) {
  if (spec.empty()) return {};
  return fmt::format(
      "<section>\n<h2>Specification</h2>\n<details><summary>The specification from which "
      "this report was made</summary>\n<pre>{}</pre></details>\n</section>\n",
      escaped(spec));
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

constexpr int kPitchSteps = 120;  // steps per pitch, of the slider and of the arrow keys

}  // namespace

std::string turn_control(const InvolutePair& pair) {
  return fmt::format(
      "<div class=\"turn\" data-pitch=\"{:.12g}\" hidden><button type=\"button\">Turn</button> "
      "<label>Gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"{:.9g}\" "
      "value=\"0\"></label> <output>0.00°</output></div>\n",
      turn_per_pitch(pair, 0), 1.0 / kPitchSteps);
}

}  // namespace gearwright
