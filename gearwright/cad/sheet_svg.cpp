#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/cad/file_text.hpp"
#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/cad/sheet_font.hpp"

namespace gearwright {

namespace {

std::string svg_number(double value) { return short_decimals(value, 4); }

// One sheet in a group of its own; y is turned over here and nowhere else.
class SheetSvg {
 public:
  explicit SheetSvg(const Sheet& sheet) : sheet_(sheet) {
    for (int i = 0; i < kSheetLayers; ++i) layer(static_cast<SheetLayer>(i));
  }
  const std::string& text() const { return out_; }

 private:
  std::string place(const Vec2& p) const {
    return svg_number(p.x()) + " " + svg_number(sheet_.size.y() - p.y());
  }

  void layer(SheetLayer layer) {
    const LayerStyle& style = style_of(layer);
    out_ += fmt::format("<g class=\"{}\" stroke-width=\"{}\"", style.name, style.line_width);
    if (style.chain) out_ += fmt::format(" stroke-dasharray=\"{:g}\"", fmt::join(kChain_mm, " "));
    out_ += ">\n";
    for (const SheetPath& path : sheet_.paths) {
      if (path.layer == layer) add(path);
    }
    for (const SheetCircle& c : sheet_.circles) {
      if (c.layer != layer) continue;
      out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", svg_number(c.center.x()),
                          svg_number(sheet_.size.y() - c.center.y()), svg_number(c.radius));
    }
    for (const SheetText& text : sheet_.texts) {
      if (text.layer == layer) add(text);
    }
    out_ += "</g>\n";
  }

  void add(const SheetPath& path) {
    out_ += path.filled ? "<path fill=\"#000\" stroke=\"none\" d=\"M" : "<path d=\"M";
    out_ += place(path.points.front());
    const std::size_t n = path.points.size();
    for (std::size_t i = 0; i < path.bulges.size(); ++i) {
      const Vec2 &a = path.points[i], &b = path.points[(i + 1) % n];
      const double bulge = path.bulges[i];
      if (bulge == 0.0) {
        out_ += "\nL" + place(b);
        continue;
      }
      const double radius = (b - a).norm() * (1 + bulge * bulge) / (4 * std::abs(bulge));
      out_ += fmt::format("\nA{0} {0} 0 {1} {2} {3}", svg_number(radius),
                          std::abs(bulge) > 1 ? 1 : 0, bulge > 0 ? 0 : 1, place(b));
    }
    out_ += path.closed ? "Z\"/>\n" : "\"/>\n";
  }

  void add(const SheetText& text) {
    const std::string x = svg_number(text.at.x()), y = svg_number(sheet_.size.y() - text.at.y());
    out_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" "
        "lengthAdjust=\"spacingAndGlyphs\"",
        x, y, svg_number(text.height / kCapital), svg_number(text_width(text.text, text.height)));
    if (text.upright) out_ += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
    out_ += fmt::format(">{}</text>\n", xml_text(text.text));
  }

  const Sheet& sheet_;
  std::string out_;
};

}  // namespace

std::string sheets_svg(const std::vector<Sheet>& sheets, const SheetWords& words) {
  GW_EXPECTS(!sheets.empty());
  std::string groups;
  double x = 0.0, height = 0.0;
  for (const Sheet& sheet : sheets) {
    if (x > 0.0) x += kBetweenSheets_mm;
    groups += fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n", svg_number(x),
                          SheetSvg(sheet).text());
    x += sheet.size.x();
    height = std::max(height, sheet.size.y());
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\">\n<title>{2}</title>\n"
      "<style>text{{font-family:Helvetica,Arial,\"Liberation Sans\",sans-serif;fill:#000;"
      "stroke:none;white-space:pre}}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<g fill=\"none\" stroke=\"#000\" stroke-linejoin=\"round\">\n{3}</g>\n</svg>\n",
      svg_number(x), svg_number(height), xml_text(words.title), groups);
}

}  // namespace gearwright
