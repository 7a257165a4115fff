// Words that have to stay within a box.
#include <algorithm>

#include "gearwright/cad/sheet_font.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {

namespace {

constexpr double kLine = 1.5;  // from line to line, in heights of capitals

// Lines broken at spaces; a word alone may be wider than `width`.
std::vector<std::string> broken(std::string_view words, double height, double width) {
  std::vector<std::string> lines;
  while (!words.empty()) {
    const std::size_t space = std::min(words.find_first_of(" \n\t"), words.size());
    const std::string word(words.substr(0, space));
    words.remove_prefix(std::min(space + 1, words.size()));
    if (word.empty()) continue;
    const bool on = !lines.empty() && text_width(lines.back() + " " + word, height) <= width;
    if (on)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::string cut(std::string text, double height, double width) {
  constexpr std::string_view kMore = "…";
  while (!text.empty() && text_width(text + std::string(kMore), height) > width) {
    std::size_t last = text.size() - 1;
    while (last > 0 && (static_cast<unsigned char>(text[last]) & 0xC0) == 0x80) --last;
    text.erase(last);
  }
  return text + std::string(kMore);
}

struct Lines {
  std::vector<std::string> lines;
  double height;  // h  mm
  bool whole;     // they fit
};

Lines laid_out(const Vec2& size, std::string_view words, double largest) {
  Lines all{{}, kSmall, false};
  for (const double h : {kLarge, kUsual, kSmall}) {
    if (h > largest) continue;
    all = {broken(words, h, size.x()), h, false};
    const double more = static_cast<double>(all.lines.size()) - 1;
    const auto fits = [&](const std::string& line) { return text_width(line, h) <= size.x(); };
    all.whole = (kLine * more + 1 + kDescent) * h <= size.y() &&
                std::all_of(all.lines.begin(), all.lines.end(), fits);
    if (all.whole) break;
  }
  return all;
}

}  // namespace

bool words_fit(const Vec2& size, std::string_view words, double largest) {
  return laid_out(size, words, largest).whole;
}

void draw_words(Sheet& sheet, SheetLayer layer, const SheetBox& box, std::string_view words,
                double largest) {
  const Vec2 size = box.hi - box.lo;
  const auto [lines, height, whole] = laid_out(size, words, largest);
  double y = box.hi.y() - height;
  for (std::size_t i = 0; i < lines.size(); ++i, y -= kLine * height) {
    const bool more = i + 1 < lines.size();
    const bool last = y - (kLine + kDescent) * height < box.lo.y();
    std::string line = lines[i];
    if ((more && last) || text_width(line, height) > size.x()) line = cut(line, height, size.x());
    sheet.text(layer, {box.lo.x(), y}, line, height);
    if (last) break;
  }
}

}  // namespace gearwright
