#include "gearwright/cad/style_sheet.hpp"

#include <algorithm>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright {

std::vector<std::string_view> trimmed_parts(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (const std::string_view part : split(text, separator))
    if (!trimmed(part).empty()) parts.push_back(trimmed(part));
  return parts;
}

StyleSheet::StyleSheet(std::string css) {
  for (std::size_t at = 0; (at = css.find("/*", at)) != css.npos;)
    css.erase(at, css.find("*/", at) + 2 - at);
  read(css);
  std::stable_sort(rules_.begin(), rules_.end(),
                   [](const Rule& a, const Rule& b) { return a.weight < b.weight; });
}

void StyleSheet::read(std::string_view css) {
  for (std::size_t open; (open = css.find('{')) != css.npos;) {
    const std::string_view head = trimmed(css.substr(0, open));
    std::size_t end = open + 1;
    for (int depth = 1; depth > 0; ++end) {
      GW_EXPECTS(end < css.size());
      depth += css[end] == '{' ? 1 : css[end] == '}' ? -1 : 0;
    }
    const std::string_view block = css.substr(open + 1, end - open - 2);
    css.remove_prefix(end);
    if (head == "@media print") read(block);
    if (head == ":root") apply_declarations(block, root_);
    if (head.starts_with("@")) continue;
    for (const std::string_view selector : trimmed_parts(head, ',')) add(selector, block);
  }
}

// Selectors with a state, with an attribute, or with an ancestor other than svg apply only to the
// page. They are skipped here.
void StyleSheet::add(std::string_view selector, std::string_view declarations) {
  const std::vector<std::string_view> steps = trimmed_parts(selector, ' ');
  if (selector.find_first_of(":[>*") != selector.npos || steps.size() > 2) return;
  if (steps.size() == 2 && steps[0] != "svg") return;
  const std::string_view last = steps.back();
  const std::string_view tag = last.substr(0, last.find('.'));
  Rule rule{std::string(tag),
            {},
            static_cast<int>(steps.size()) - (tag.empty() ? 1 : 0),
            std::string(declarations)};
  for (const std::string_view name : trimmed_parts(last.substr(tag.size()), '.')) {
    rule.classes.emplace_back(name);
    rule.weight += 10;
  }
  rules_.push_back(std::move(rule));
}

void StyleSheet::apply(std::string_view tag, std::string_view classes, Style& style) const {
  const std::vector<std::string_view> own = trimmed_parts(classes, ' ');
  for (const Rule& rule : rules_) {
    if (!rule.tag.empty() && rule.tag != tag) continue;
    if (std::all_of(rule.classes.begin(), rule.classes.end(),
                    [&](const std::string& name) { return is_in(name, own); }))
      apply_declarations(rule.declarations, style);
  }
}

const StyleSheet& figure_styles() {
  static const StyleSheet sheet{std::string(figure_style())};
  return sheet;
}

void apply_declarations(std::string_view declarations, Style& style) {
  for (const std::string_view one : trimmed_parts(declarations, ';')) {
    const std::size_t colon = one.find(':');
    if (colon == one.npos || one.find("color-mix") != one.npos) continue;
    style[std::string(one.substr(0, colon))] = trimmed(one.substr(colon + 1));
  }
}

std::string text_in(const Style& style, std::string_view name) {
  auto at = style.find(name);
  while (at != style.end() && at->second.starts_with("var("))
    at = style.find(at->second.substr(4, at->second.size() - 5));
  return at == style.end() ? std::string() : at->second;
}

double number_in(const Style& style, std::string_view name, double absent) {
  const std::string text = text_in(style, name);
  return text.empty() ? absent : std::strtod(text.c_str(), nullptr);
}

std::optional<std::uint32_t> colour_in(const Style& style, std::string_view name,
                                       std::optional<std::uint32_t> absent) {
  std::string text = text_in(style, name);
  if (text.empty()) return absent;
  if (!text.starts_with('#')) return {};
  if (text.size() == 4) text = {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
  return static_cast<std::uint32_t>(std::strtoul(text.c_str() + 1, nullptr, 16));
}

}  // namespace gearwright
