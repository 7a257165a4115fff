// Writes the parts that all pages share, which are the head, the style, the hint about pictures,
// and the spec.
//
// Style sheets and scripts are files in report/page/. The build converts each file into a function
// with the name of the file (cmake/gw_embed.cmake).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Widths of figures, px, in addition to kFigureWidth. A wide figure is beside a table or narrow
/// figures, and a plane figure is in a column. A narrow figure is beside a wide one, and small
/// figures form a row.
inline constexpr double kWideFigure = 640.0, kPlaneFigure = 520.0, kNarrowFigure = 420.0,
                        kSmallFigure = 240.0;

/// The form in which a section shows its figures. It consists of the unit of lengths, a prefix that
/// makes the ids of the figures unique in the page, and the ids of the figures at the head of the
/// page. Sections omit the figures at the head of the page.
struct FigureForm {
  UnitSystem units = UnitSystem::mm;
  std::string prefix;
  std::vector<std::string> above = {};

  // This constructor converts a system of units to a form without a prefix.
  FigureForm(UnitSystem in = UnitSystem::mm, std::string before = {})
      : units(in), prefix(std::move(before)) {}
  /// Returns figure_html() of the figure in this form. The result is empty if the figure is already
  /// at the head of the page, or if there is no figure.
  std::string html(Figure figure, double width = kFigureWidth, std::string_view control = "") const;
  std::string html(std::optional<Figure> figure) const;
  /// Returns side_by_side() of these figures and of `more`, which is HTML. If the head of the page
  /// contains all of them, returns a sentence that refers to it.
  std::string row(const std::vector<std::optional<Figure>>& figures,
                  const std::string& more = {}) const;
};

/// Returns the style sheet of every page. On screen, the preference of the user determines whether
/// the page is light or dark. On paper, the page is always light. The colours of figures are in
/// figure/figure_style.css.
std::string_view page_style();

/// Returns additional styles for the page of a design search. They apply to the wide table, the
/// edges of a region, and the dots and curves of the charts.
std::string_view search_style();

/// Returns the script that makes every picture zoomable (zoom_script.js) and unfolds the tables
/// before printing. Without the script, the pictures are static and complete.
std::string_view page_script();

/// Returns the page from the doctype to </head>, including the style. `title` is plain text.
/// `more_style` is added to the style of the page.
std::string page_head(std::string_view title, std::string_view more_style);

/// A page with all its parts. Title, level and spec are plain text. `style` is CSS and
/// `script` is JavaScript. All other texts are HTML.
struct ReportPage {
  std::string title;
  std::string kind;           ///< subject of the page, above the title
  std::string verdict{};      ///< headline of the verdict, below the title
  std::string level{};        ///< level of the verdict, "green"; empty if there is none
  std::string head{};         ///< content of the header after the verdict
  std::string definitions{};  ///< SVG definitions of the shapes
  std::string sections;
  std::string spec{};                  ///< the spec as given, plain text; omitted if empty
  std::string foot;                    ///< text of the footer after the version
  std::string_view style{}, script{};  ///< in addition to the style and the script of all pages
};
std::string page_html(const ReportPage& page);

/// Returns the hint about zooming. It is hidden until the script of the page makes it visible.
std::string picture_hint();

/// Returns the sections of a page after a list of links to their headings. Short pages have no
/// list.
std::string with_contents(const std::string& sections);

// The control that turns the gears of a picture (figure/mesh.hpp), and its script.
//
//   t    rotation of gear 1 from the drawn position, in pitches, from 0 to 1. After one pitch, the
//        next tooth takes the place of the first, and the picture repeats.
//
// Without the script, and on paper, the picture is static at t = 0.

/// Returns a button and a slider (HTML) for all pictures in the same group of figures. They are
/// hidden until the script makes them visible.
std::string turn_control(const InvolutePair& pair);

/// Returns the script of this control, figure/turn_script.js. The web page uses the same file.
std::string_view turn_script();

}  // namespace gearwright
