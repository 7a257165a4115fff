#include "gearwright/report/page_parts.hpp"

#include <fmt/format.h>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_style.hpp"

namespace gearwright {

std::string page_head(std::string_view title, std::string_view version,
                      std::string_view more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
      "content=\"Gearwright "
      "{}\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n",
      escaped(version), escaped(title), page_style(), more_style);
}

std::string picture_hint() {
  return "<p class=\"hint\" id=\"hint\" hidden>Pictures: wheel zooms, drag moves, double click "
         "restores; with "
         "the keyboard + − 0 and arrows.</p>\n";
}

std::string spec_section(const std::string& spec) {
  if (spec.empty()) return {};
  return fmt::format(
      "<section>\n<h2>Specification</h2>\n<details><summary>The specification this report was "
      "made from</summary>\n<pre>{}</pre></details>\n</section>\n",
      escaped(spec));
}

}  // namespace gearwright
