#include "gearwright/cad/figure_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <sstream>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/cad/style_sheet.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright {

namespace {

constexpr double kMmPerPx = kMmPerInch / 96;  // one CSS px is 1/96 inch
constexpr double kBold = 0.03;  // width of the outline of bold letters, relative to their size

using Tree = boost::property_tree::ptree;
using Px = std::complex<double>;  // a point x + iy with y down, px

std::string attribute(const Tree& node, const char* name) {
  return node.get(std::string("<xmlattr>.") + name, std::string());
}

double number(const Tree& node, const char* name) {
  return std::strtod(attribute(node, name).c_str(), nullptr);
}

// Returns the numbers in a text. All other characters separate numbers.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.c_str();
  while (*at != 0) {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end != at) numbers.push_back(value);
    at = end == at ? at + 1 : end;
  }
  return numbers;
}

struct Mapping {
  Px turn = 1.0, shift = 0.0;

  Px operator()(const Px& p) const { return turn * p + shift; }
  Mapping then(const std::string& transform) const {
    Mapping place = *this;
    for (const std::string_view one : trimmed_parts(transform, ')')) {
      const std::vector<double> n = numbers_of(std::string(one));
      if (one.starts_with("translate")) place.shift = place({n.at(0), n.at(1)});
      if (one.starts_with("scale")) place.turn *= n.at(0);
      if (one.starts_with("rotate")) place.turn *= std::polar(1.0, n.at(0) * kPi / 180.0);
    }
    return place;
  }
};

// Returns the outline of a shape as path data, or an empty text for a group.
std::string outline(const std::string& tag, const Tree& node) {
  if (tag == "path") return attribute(node, "d");
  if (tag == "polyline") return "M" + attribute(node, "points");
  if (tag == "polygon") return "M" + attribute(node, "points") + "Z";
  if (tag == "rect") {
    const double width = number(node, "width");
    return fmt::format("M{} {}h{}v{}h{}Z", number(node, "x"), number(node, "y"), width,
                       number(node, "height"), -width);
  }
  if (tag != "circle") return {};
  const double r = number(node, "r");
  return fmt::format("M{0} {1}a{2} {2} 0 1 1 {3} 0a{2} {2} 0 1 1 -{3} 0", number(node, "cx") - r,
                     number(node, "cy"), r, 2 * r);
}

class PictureReader {
 public:
  PictureReader(const Tree& svg, const PictureScale& scale)
      : scale_(scale), height_(number(svg, "height")) {
    sheet_.size = scale.mm_per_px * Vec2(number(svg, "width"), height_);
    sheet_.corner = scale.corner;
    collect(svg);
    const std::vector<double> view = numbers_of(attribute(svg, "viewBox"));
    const double zoom = number(svg, "width") / view.at(2);
    const Mapping place{zoom, -zoom * Px(view.at(0), view.at(1))};
    draw("svg", svg, place, styles_.root(), {}, true);
  }
  Sheet take() { return std::move(sheet_); }

 private:
  void collect(const Tree& node) {
    for (const auto& [tag, child] : node) {
      if (const std::string id = attribute(child, "id"); !id.empty()) ids_[id] = {tag, &child};
      collect(child);
    }
  }

  Vec2 mm(const Px& p) const {
    return scale_.corner + scale_.mm_per_px * Vec2(p.real(), height_ - p.imag());
  }

  // Draws an element. `styled` is false for shapes in definitions, which ignore the style sheet.
  void draw(const std::string& tag, const Tree& node, const Mapping& parent, Style style,
            std::optional<SheetBox> clip, bool styled) {
    if (tag == "defs" || tag == "clipPath") return;
    for (const char* name : {"fill", "stroke", "fill-rule", "visibility"})
      if (const std::string value = attribute(node, name); !value.empty()) style[name] = value;
    const std::string classes = attribute(node, "class");
    if (styled) styles_.apply(tag, classes, style);
    apply_declarations(attribute(node, "style"), style);
    if (style["visibility"] == "hidden") return;
    const Mapping place = parent.then(attribute(node, "transform"));
    if (const std::string url = attribute(node, "clip-path"); !url.empty()) {
      const Tree& box = ids_.at(url.substr(5, url.size() - 6)).second->get_child("rect");
      const Px corner(number(box, "x"), number(box, "y"));
      const Px size(number(box, "width"), number(box, "height"));
      const Vec2 a = mm(place(corner)), b = mm(place(corner + size));
      clip = SheetBox{a.cwiseMin(b), a.cwiseMax(b)};
    }
    if (tag == "text") return words(node, place, style);
    if (tag == "use") {
      const auto& [shape, of] = ids_.at(attribute(node, "href").substr(1));
      if (styled) name_ = classes;
      return draw(shape, *of, place, style, clip, false);
    }
    const std::string d = outline(tag, node);
    for (const auto& [name, child] : node)
      if (d.empty()) draw(name, child, place, style, clip, styled);
    if (styled) name_ = classes;
    const auto ink = ink_of(style);
    if (!(ink->fill || ink->stroke) || (scale_.outlines && !styled && !ink->stroke)) return;
    const std::size_t first = sheet_.paths.size();
    add_pieces(d, place);
    // If areas are filled, a shape that lies outside the sheet is omitted. In a figure of a mesh,
    // most teeth are outside.
    if (!scale_.outlines && !on_sheet(first)) sheet_.paths.resize(first);
    for (std::size_t i = first; i < sheet_.paths.size(); ++i) {
      sheet_.paths[i].ink = ink;
      sheet_.paths[i].clip = clip;
      sheet_.paths[i].more = i + 1 < sheet_.paths.size();
    }
  }

  // True if the box around the paths with an index of at least `first` overlaps the sheet.
  bool on_sheet(std::size_t first) const {
    Bounds box;
    for (std::size_t i = first; i < sheet_.paths.size(); ++i) {
      const SheetPath& path = sheet_.paths[i];
      for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Vec2& next = path.points[(k + 1) % path.points.size()];
        const double bulge = k < path.bulges.size() ? std::abs(path.bulges[k]) : 0.0;
        const Vec2 reach = Vec2::Constant(bulge / 2 * (next - path.points[k]).norm());
        for (const Vec2& p : {path.points[k], next}) {
          box.cover(p - reach);
          box.cover(p + reach);
        }
      }
    }
    return box.lo.x() < sheet_.size.x() && box.lo.y() < sheet_.size.y() && box.hi.minCoeff() > 0.0;
  }

  void add_pieces(const std::string& d, const Mapping& place) {
    constexpr const char* kCommands = "MLHVAZmlhva";
    Px pen = 0.0;
    for (std::size_t at = d.find_first_of(kCommands); at != d.npos;) {
      const char command = d[at];
      const std::size_t begin = at + 1;
      at = d.find_first_of(kCommands, begin);
      const std::vector<double> n = numbers_of(d.substr(begin, at - begin));
      const bool relative = command >= 'a';
      const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
      if (kind == 'Z') {
        sheet_.paths.back().closed = true;
        sheet_.paths.back().bulges.push_back(0.0);
      }
      const std::size_t step = kind == 'A' ? 7 : kind == 'H' || kind == 'V' ? 1 : 2;
      for (std::size_t i = 0; i + step <= n.size(); i += step) {
        const Px from = relative ? pen : 0.0;
        const Px to = kind == 'H'   ? Px(from.real() + n[i], pen.imag())
                      : kind == 'V' ? Px(pen.real(), from.imag() + n[i])
                                    : from + Px(n[i + step - 2], n[i + step - 1]);
        double bulge = 0.0;
        if (kind == 'A') {
          const double half = std::asin(std::min(1.0, std::abs(to - pen) / (2 * n[i])));
          bulge = std::tan((n[i + 3] != 0.0 ? kPi - half : half) / 2);
          if (n[i + 4] != 0.0) bulge = -bulge;  // clockwise
        }
        pen = to;
        if (kind == 'M' && i == 0)
          sheet_.paths.push_back({SheetLayer::data, {}, {}});
        else
          sheet_.paths.back().bulges.push_back(bulge);
        sheet_.paths.back().points.push_back(mm(place(pen)));
      }
    }
  }

  std::shared_ptr<SheetInk> ink_of(const Style& style) {
    const double opacity = number_in(style, "opacity", 1.0);
    std::vector<double> dashes = numbers_of(text_in(style, "stroke-dasharray"));
    for (double& dash : dashes) dash *= kMmPerPx;
    std::string name = name_.empty() ? "FIGURE" : name_;
    std::replace(name.begin(), name.end(), ' ', '_');
    return std::make_shared<SheetInk>(
        SheetInk{name, colour_in(style, "fill", 0), colour_in(style, "stroke", {}),
                 opacity * number_in(style, "fill-opacity", 1.0),
                 opacity * number_in(style, "stroke-opacity", 1.0),
                 kMmPerPx * number_in(style, "stroke-width", 1.0), std::move(dashes),
                 text_in(style, "fill-rule") == "evenodd"});
  }

  void words(const Tree& node, const Mapping& place, const Style& style) {
    struct Run {
      std::string text;
      double size, down;  // px; `down` is the shift of the base line
      bool slanted;
    };
    std::vector<Run> runs;
    double width = 0.0, down = 0.0;
    for (const auto& [tag, child] : node) {
      if (tag == "<xmlattr>") continue;
      Style own = style;
      styles_.apply(tag, attribute(child, "class"), own);
      down += number(child, "dy");
      const double size = number_in(own, "font-size", 13.0) * std::abs(place.turn);
      const std::string text = printed(tag == "tspan" ? child.get("<xmltext>", "") : child.data());
      runs.push_back(
          {text, size, down * std::abs(place.turn), text_in(own, "font-style") == "italic"});
      width += text_width(text, kCapital * size);
    }
    const std::string anchor = text_in(style, "text-anchor");
    Px at = place({number(node, "x"), number(node, "y")});
    at -= anchor == "middle" ? width / 2 : anchor == "end" ? width : 0.0;
    name_ = attribute(node, "class");
    const std::shared_ptr<SheetInk> halo = ink_of(style), letters = ink_of(style);
    halo->fill.reset();
    letters->stroke.reset();
    if (number_in(style, "font-weight", 400) > 500) letters->stroke = letters->fill;
    letters->line_width = scale_.mm_per_px * kBold * number_in(style, "font-size", 13.0);
    for (const Run& run : runs) {
      const double height = scale_.mm_per_px * kCapital * run.size;
      SheetText text{SheetLayer::data, mm(at + Px(0.0, run.down)), run.text, height};
      text.slanted = run.slanted;
      for (const auto& ink : {halo, letters}) {
        text.ink = ink;
        if (ink->fill || ink->stroke) sheet_.texts.push_back(text);
      }
      at += text_width(run.text, kCapital * run.size);
    }
  }

  // Returns the text as it is printed. Zero-width spaces, which end subscripts, are removed, and
  // narrow spaces become normal spaces.
  static std::string printed(std::string text) {
    for (std::size_t at; (at = text.find("\u200b")) != text.npos;) text.erase(at, 3);
    for (std::size_t at; (at = text.find("\u202f")) != text.npos;) text.replace(at, 3, " ");
    return text;
  }

  const StyleSheet& styles_ = figure_styles();
  PictureScale scale_;
  double height_;  // px
  Sheet sheet_ = {};
  std::string name_ = {};  // classes of the current element; they name its layer
  std::map<std::string, std::pair<std::string, const Tree*>, std::less<>> ids_ = {};
};

}  // namespace

Sheet picture_sheet(const std::string& svg, const PictureScale& scale) {
  std::istringstream text(svg);
  Tree tree;
  boost::property_tree::read_xml(text, tree, boost::property_tree::xml_parser::no_concat_text);
  return PictureReader(tree.get_child("svg"), scale).take();
}

std::string picture_pdf(const std::string& svg, const std::string& title) {
  return sheets_pdf({picture_sheet(svg, {.mm_per_px = kMmPerPx})}, {title, ""});
}

Result<std::string> figure_file(const Figure& figure, const std::string& ending) {
  std::string svg = figure_svg(figure);
  if (ending == ".pdf") return picture_pdf(svg, figure.title);
  if (ending == ".svg") {
    svg.insert(5, "xmlns=\"http://www.w3.org/2000/svg\" ");
    svg.insert(svg.find('>') + 1, fmt::format("<style>{}</style>", figure_style()));
    return svg;
  }
  if (ending != ".dxf") return Error{"path", ending, "must end in .svg, .pdf or .dxf"};
  if (!figure.plane || (figure.x.unit != "mm" && figure.x.unit != "in"))
    return Error{"path", ending,
                 "needs a figure of a plane, but this figure has axes; save it as .pdf or .svg"};
  const double mm = figure.x.unit == "in" ? kMmPerInch : 1.0;
  const auto axis = [&](std::string_view name) {
    const std::size_t begin = svg.find(name) + name.size();
    return numbers_of(svg.substr(begin, svg.find('"', begin) - begin));
  };
  const std::vector<double> x = axis("data-x=\""), y = axis("data-y=\"");
  const double mm_per_px = mm * (x.at(1) - x.at(0)) / (x.at(3) - x.at(2));
  const Vec2 corner = mm * Vec2(x.at(0), y.at(0)) - Vec2(mm_per_px * x.at(2), 0.0);
  return sheets_dxf({picture_sheet(svg, {mm_per_px, corner, true})});
}

}  // namespace gearwright
