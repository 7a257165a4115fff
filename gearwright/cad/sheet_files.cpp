// Writes sheets as PDF 1.4 (Adobe, PDF Reference, third edition), SVG and DXF.
#include "gearwright/cad/sheet_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/cad/dxf_document.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr int kDecimals = 4;  // decimals of a length in mm
// A cubic approximates an arc of at most π/8. The error is 4e-8 of the radius.
const double kMostBulge = std::tan(std::acos(-1.0) / 32);

std::string number(double mm) { return short_decimals(mm, kDecimals); }
std::string point(const Vec2& p) { return number(p.x()) + " " + number(p.y()); }

// Draws an arc from a to b. The pen is already at a.
void append_arc(std::string& out, const Vec2& a, const Vec2& b, double bulge) {
  const Vec2 chord = b - a, left(-chord.y(), chord.x());
  if (bulge == 0.0) {
    out += point(b) + " l\n";
  } else if (std::abs(bulge) > kMostBulge) {
    const Vec2 middle = (a + b - bulge * left) / 2;
    const double half = bulge / (1 + std::hypot(1.0, bulge));  // tan(sweep/8)
    append_arc(out, a, middle, half);
    append_arc(out, middle, b, half);
  } else {
    // The handles of the cubic lie on the end tangents. The length of a handle is c (1 + b²)/3,
    // where c is the length of the chord and b the bulge.
    const Vec2 along = (1 - bulge * bulge) * chord / 3, across = 2 * bulge * left / 3;
    out +=
        fmt::format("{} {} {} c\n", point(a + along - across), point(b - along - across), point(b));
  }
}

// The content of a PDF page. The line setting of a layer is written only if it differs from the
// current one. A mark of a figure always has its own settings.
class Content {
 public:
  explicit Content(const Sheet& sheet) {
    out_ = fmt::format("{0:.10f} 0 0 {0:.10f} 0 0 cm\n1 j\n", kPointsPerMm);
    for (const SheetPath& path : sheet.paths) add(path);
    for (const SheetCircle& c : sheet.circles) {
      const Vec2 right(c.radius, 0);
      add(SheetPath{c.layer, {c.center - right, c.center + right}, {1.0, 1.0}, true});
    }
    out_ += "BT\n";
    for (const SheetText& text : sheet.texts) add(text);
    out_ += "ET\n";
  }
  const std::string& text() const { return out_; }
  // Returns the graphics states for "gs" as an entry of the resources, or "" if there are none.
  std::string states() const {
    std::string list;
    for (std::size_t i = 0; i < opacities_.size(); ++i)
      list += fmt::format(" /O{} << {} >>", i, opacities_[i]);
    return list.empty() ? list : fmt::format(" /ExtGState <<{} >>", list);
  }

 private:
  void style(const LayerStyle& style) {
    if (style.line_width != width_) out_ += number(style.line_width) + " w\n";
    if (style.chain != chain_)
      out_ += style.chain ? fmt::format("[{:g}] 0 d\n", fmt::join(kChain_mm, " ")) : "[] 0 d\n";
    width_ = style.line_width;
    chain_ = style.chain;
  }

  // Sets the look of a mark of a figure. The caller must write "Q" afterwards, which restores the
  // previous look.
  void begin(const SheetInk& ink, const std::optional<SheetBox>& clip) {
    const auto colour = [](std::uint32_t c) {
      return fmt::format("{:.3g} {:.3g} {:.3g}", (c >> 16) / 255.0, (c >> 8 & 255) / 255.0,
                         (c & 255) / 255.0);
    };
    out_ += "q\n";
    if (clip) out_ += fmt::format("{} {} re W n\n", point(clip->lo), point(clip->hi - clip->lo));
    if (ink.fill) out_ += colour(*ink.fill) + " rg\n";
    if (ink.stroke)
      out_ += fmt::format("{} RG {} w [{:.4g}] 0 d\n", colour(*ink.stroke), number(ink.line_width),
                          fmt::join(ink.dashes, " "));
    const std::string opacity =
        fmt::format("/ca {:.3g} /CA {:.3g}", ink.fill_opacity, ink.stroke_opacity);
    if (opacity == "/ca 1 /CA 1") return;
    const auto at = std::find(opacities_.begin(), opacities_.end(), opacity);
    out_ += fmt::format("/O{} gs\n", at - opacities_.begin());
    if (at == opacities_.end()) opacities_.push_back(opacity);
  }

  void add(const SheetPath& path) {
    if (!path.ink)
      style(style_of(path.layer));
    else if (!piece_follows_)
      begin(*path.ink, path.clip);
    piece_follows_ = path.more;
    out_ += point(path.points.front()) + " m\n";
    const std::size_t n = path.points.size();
    for (std::size_t i = 0; i < path.bulges.size(); ++i)
      append_arc(out_, path.points[i], path.points[(i + 1) % n], path.bulges[i]);
    if (!path.ink) {
      out_ += path.filled ? "f\n" : path.closed ? "s\n" : "S\n";
      return;
    }
    if (path.closed) out_ += "h\n";
    if (path.more) return;
    const SheetInk& ink = *path.ink;
    out_ += fmt::format("{}{}\nQ\n",
                        !ink.fill    ? "S"
                        : ink.stroke ? "B"
                                     : "f",
                        ink.fill && ink.even_odd ? "*" : "");
  }

  void add(const SheetText& text) {
    const double size = text.height / kCapital;
    if (text.ink) {
      out_ += "ET\n";
      begin(*text.ink, {});
      out_ += fmt::format("BT\n{} Tr\n", !text.ink->fill ? 1 : text.ink->stroke ? 2 : 0);
    }
    out_ += fmt::format("{} {} Tm\n",
                        text.upright   ? "0 1 -1 0"
                        : text.slanted ? "1 0 0.2 1"
                                       : "1 0 0 1",
                        point(text.at));
    std::string run;
    SheetFont font = SheetFont::helvetica;
    const auto show = [&] {
      if (run.empty()) return;
      out_ += fmt::format("/{} {} Tf ({}) Tj\n", font == SheetFont::symbol ? "S" : "H",
                          number(size), run);
      run.clear();
    };
    for (const char32_t code : code_points(text.text)) {
      const SheetLetter letter = letter_of(code);
      if (letter.font != font) show();
      font = letter.font;
      const char c = static_cast<char>(letter.code);
      if (c == '(' || c == ')' || c == '\\') run += '\\';
      run += letter.code < 0x7F ? std::string(1, c) : fmt::format("\\{:03o}", letter.code);
    }
    show();
    if (text.ink) out_ += "ET\nQ\nBT\n";
  }

  std::string out_;
  std::vector<std::string> opacities_;
  double width_ = 1.0;
  bool chain_ = false;
  bool piece_follows_ = false;
};

// Encodes a text of the document information as hexadecimal UTF-16 with a byte order mark.
std::string information(const std::string& utf8) {
  std::string text = "<FEFF";
  for (const char32_t code : code_points(utf8)) {
    const auto c = static_cast<std::uint32_t>(code);
    text += c < 0x10000 ? fmt::format("{:04X}", c)
                        : fmt::format("{:04X}{:04X}", 0xD800 + ((c - 0x10000) >> 10),
                                      0xDC00 + ((c - 0x10000) & 0x3FF));
  }
  return text + ">";
}

class Objects {
 public:
  int next() const { return static_cast<int>(places_.size()) + 1; }
  void add(const std::string& object) {
    places_.push_back(text_.size());
    text_ += fmt::format("{} 0 obj\n{}\nendobj\n", places_.size(), object);
  }
  std::string file(int catalog, int info) const {
    std::string text = text_ + fmt::format("xref\n0 {}\n0000000000 65535 f \n", next());
    for (const std::size_t place : places_) text += fmt::format("{:010} 00000 n \n", place);
    return text +
           fmt::format("trailer\n<< /Size {} /Root {} 0 R /Info {} 0 R >>\nstartxref\n{}\n%%EOF\n",
                       next(), catalog, info, text_.size());
  }

 private:
  std::string text_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";  // four bytes that mark a binary file
  std::vector<std::size_t> places_;
};

// Writes one sheet as an SVG group. Only this class reverses the y axis.
class SheetSvg {
 public:
  explicit SheetSvg(const Sheet& sheet) : sheet_(sheet) {
    for (int i = 0; i < kSheetLayers; ++i) layer(static_cast<SheetLayer>(i));
  }
  const std::string& text() const { return out_; }

 private:
  std::string place(const Vec2& p) const {
    return number(p.x()) + " " + number(sheet_.size.y() - p.y());
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
      out_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", number(c.center.x()),
                          number(sheet_.size.y() - c.center.y()), number(c.radius));
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
      out_ += fmt::format("\nA{0} {0} 0 {1} {2} {3}", number(radius), std::abs(bulge) > 1 ? 1 : 0,
                          bulge > 0 ? 0 : 1, place(b));
    }
    out_ += path.closed ? "Z\"/>\n" : "\"/>\n";
  }

  void add(const SheetText& text) {
    const std::string x = number(text.at.x()), y = number(sheet_.size.y() - text.at.y());
    out_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" "
        "lengthAdjust=\"spacingAndGlyphs\"",
        x, y, number(text.height / kCapital), number(text_width(text.text, text.height)));
    if (text.upright) out_ += fmt::format(" transform=\"rotate(-90 {} {})\"", x, y);
    out_ += fmt::format(">{}</text>\n", escaped(text.text));
  }

  const Sheet& sheet_;
  std::string out_;
};

template <class Mark>
std::string layer_of(const Mark& mark) {
  return mark.ink ? mark.ink->name : style_of(mark.layer).name;
}

// Returns the AutoCAD colour index nearest to the hue of a colour, from 1 for red and 2 for yellow
// to 6 for magenta. For shades of grey, returns 7, the colour of the text.
int colour_index(std::uint32_t rgb) {
  const Eigen::Vector3i c(static_cast<int>(rgb >> 16), rgb >> 8 & 255, rgb & 255);
  int i = 0;
  const int most = c.maxCoeff(&i), range = most - c.minCoeff();
  if (range < 64) return 7;
  const double sixths = 2 * i + static_cast<double>(c[(i + 1) % 3] - c[(i + 2) % 3]) / range;
  return 1 + (static_cast<int>(std::lround(sixths)) + 6) % 6;
}

void add(DxfEntities& entities, const SheetPath& path) {
  const std::string layer = layer_of(path);
  const std::vector<Vec2>& p = path.points;
  if (path.filled || (path.ink && !path.ink->stroke && p.size() == 3)) {
    GW_EXPECTS(p.size() == 3);
    entities.triangle(layer, p[0], p[1], p[2]);
  } else if (!path.closed && p.size() == 2 && path.bulges[0] == 0.0) {
    entities.line(layer, p[0], p[1]);
  } else {
    entities.polyline(layer, p, path.bulges);
  }
}

}  // namespace

std::string sheets_pdf(const std::vector<Sheet>& sheets, const SheetWords& words) {
  GW_EXPECTS(!sheets.empty());
  enum { kCatalog = 1, kPages, kHelvetica, kSymbol, kInfo, kFirstPage };
  Objects objects;
  std::string kids;
  for (std::size_t i = 0; i < sheets.size(); ++i)
    kids += fmt::format("{}{} 0 R", i > 0 ? " " : "", kFirstPage + 2 * i);
  objects.add(fmt::format("<< /Type /Catalog /Pages {} 0 R >>", int{kPages}));
  objects.add(fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, sheets.size()));
  objects.add("<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
  objects.add("<< /Type /Font /Subtype /Type1 /BaseFont /Symbol >>");
  std::string info = "<< /Producer (Gearwright)";
  if (!words.title.empty()) info += " /Title " + information(words.title);
  if (!words.author.empty()) info += " /Author " + information(words.author);
  objects.add(info + " >>");
  for (const Sheet& sheet : sheets) {
    const Content content(sheet);
    objects.add(fmt::format(
        "<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {} {}] /Contents {} 0 R\n"
        "/Resources << /Font << /H {} 0 R /S {} 0 R >>{} >> >>",
        int{kPages}, number(kPointsPerMm * sheet.size.x()), number(kPointsPerMm * sheet.size.y()),
        objects.next() + 1, int{kHelvetica}, int{kSymbol}, content.states()));
    objects.add(fmt::format("<< /Length {} >>\nstream\n{}endstream", content.text().size(),
                            content.text()));
  }
  return objects.file(kCatalog, kInfo);
}

int letters_not_in_pdf(const std::vector<Sheet>& sheets) {
  int count = 0;
  for (const Sheet& sheet : sheets) {
    for (const SheetText& text : sheet.texts) {
      for (const char32_t code : code_points(text.text)) count += letter_of(code).known ? 0 : 1;
    }
  }
  return count;
}

std::string sheets_svg(const std::vector<Sheet>& sheets, const SheetWords& words) {
  GW_EXPECTS(!sheets.empty());
  std::string groups;
  double x = 0.0, height = 0.0;
  for (const Sheet& sheet : sheets) {
    if (x > 0.0) x += kBetweenSheets_mm;
    groups += fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n", number(x),
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
      number(x), number(height), escaped(words.title), groups);
}

std::string sheets_dxf(const std::vector<Sheet>& sheets) {
  GW_EXPECTS(!sheets.empty());
  constexpr double kUpright_deg = 90.0;
  DxfEntities entities;
  std::vector<DxfLayer> layers;
  const bool figure = !sheets.front().paths.empty() && sheets.front().paths.front().ink;
  for (int i = 0; i < (figure ? 0 : kSheetLayers); ++i) {
    const LayerStyle& style = style_of(static_cast<SheetLayer>(i));
    const auto hundredths = static_cast<int>(std::lround(100 * style.line_width));
    layers.push_back({style.name, style.dxf_color, hundredths, style.chain});
  }
  // A layer of a figure has the default line width of the program that reads the file.
  const auto define = [&](const SheetInk* ink) {
    const auto same = [&](const DxfLayer& layer) { return layer.name == ink->name; };
    if (!ink || std::any_of(layers.begin(), layers.end(), same)) return;
    const int color = colour_index(ink->stroke.value_or(ink->fill.value_or(0)));
    layers.push_back({ink->name, color, DxfLayer{}.line_width, ink->dashes.size() > 2});
  };
  double x = 0.0, height = 0.0;
  for (const Sheet& sheet : sheets) {
    if (x > 0.0) x += kBetweenSheets_mm;
    entities.place(Eigen::Isometry2d(Eigen::Translation2d(x, 0.0)));
    for (const SheetPath& path : sheet.paths) {
      define(path.ink.get());
      add(entities, path);
    }
    for (const SheetCircle& c : sheet.circles)
      entities.circle(style_of(c.layer).name, c.radius, c.center);
    for (const SheetText& t : sheet.texts) {
      if (t.ink && !t.ink->fill) continue;  // the light outline behind a text
      define(t.ink.get());
      entities.text(layer_of(t), t.at, t.text, t.height, t.upright ? kUpright_deg : 0.0);
    }
    x += sheet.size.x();
    height = std::max(height, sheet.size.y());
  }
  const Vec2 corner = sheets.front().corner;
  return dxf_document(entities, layers, {corner, corner + Vec2(x, height)});
}

}  // namespace gearwright
