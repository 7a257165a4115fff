#include "gearwright/report/html_text.hpp"

#include <fmt/format.h>

namespace gearwright {

std::string file_link(std::string_view name) {
  std::string result = "./";  // a name with a colon must not look like "protocol:"
  for (const char c : name) {
    if (is_letter_or_digit(c) || c == '-' || c == '.' || c == '_' || c == '~' || c == '/') {
      result += c;
    } else {
      result += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

std::string side_by_side(std::string_view figures) {
  return figures.empty() ? "" : fmt::format("<div class=\"figures\">\n{}</div>\n", figures);
}

std::string caption_of_gears() {
  return caption_key("g1", "gear 1") + " " + caption_key("g2", "gear 2");
}

std::string in_columns(std::string_view left, std::string_view right) {
  return fmt::format("<div class=\"columns\"><div>{}</div><div>{}</div></div>\n", left, right);
}

std::string value_table(std::string_view caption, const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows, std::string_view style) {
  std::string text = fmt::format(
      "<div class=\"scroll\"><table{}>\n<caption>{}</caption>\n<thead><tr><th "
      "scope=\"col\">{}</th>",
      style.empty() ? "" : fmt::format(" class=\"{}\"", style), caption, heads.front());
  for (std::size_t i = 1; i < heads.size(); ++i)
    text += fmt::format("<th scope=\"col\" class=\"value\">{}</th>", heads[i]);
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    text += fmt::format("<tr><th scope=\"row\">{}</th>", row.front());
    for (std::size_t i = 1; i < row.size(); ++i)
      text += fmt::format("<td class=\"value\">{}</td>", row[i]);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace gearwright
