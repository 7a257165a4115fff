#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

double share(const ContactResult& result, bool (*is)(TouchKind)) {
  const auto n = std::count_if(result.positions.begin(), result.positions.end(),
                               [&](const ContactPoint& p) { return is(p.kind); });
  return static_cast<double>(n) / static_cast<double>(result.positions.size());
}

bool inside(TouchKind kind) { return kind == TouchKind::interior || kind == TouchKind::line; }
bool at_ridge(TouchKind kind) { return kind == TouchKind::ridge; }
bool nowhere(TouchKind kind) { return kind == TouchKind::none; }

std::string assumed(const ContactReport& report) {
  std::string text;
  for (const NamedAmount& e : report.errors)
    text += fmt::format("<li>{} {}</li>\n", escaped(e.name), escaped(words_of(e)));
  for (const std::string& m : report.modifications)
    text += fmt::format("<li>{}</li>\n", escaped(m));
  return text.empty() ? "<p>No error and no modification is given, so the gears are as drawn.</p>\n"
                      : "<ul class=\"assumed\">\n" + text + "</ul>\n";
}

std::string facts(const ContactReport& report, UnitSystem units) {
  const ContactResult& a = report.driving;
  const ContactResult& b = report.other;
  TableBuilder t("Tooth contact", {"Driving flanks", "Non-working flanks"});
  const TeUnit unit = te_unit(a.rack);
  const Unit te = a.rack ? Unit::um : Unit::arcsec;
  const std::string_view symbol = unit_text(units, te);
  const auto shown = [&](Angle x) { return shown_arcsec(value_in(units, te, unit.of(x))); };
  t.row("Transmission error, peak to peak", "", symbol,
        {shown(report.span[0].value_or(a.peak_to_peak)),
         shown(report.span[1].value_or(b.peak_to_peak))});
  const auto wave = [&](const ContactResult& r) {
    return r.harmonics.empty() ? std::string(kNoValue) : shown(r.harmonics[0]);
  };
  t.row("Amplitude at the mesh frequency", "", symbol, {wave(a), wave(b)});
  t.row("Share of the rotation with contact inside the flanks", "", "%",
        {percent(share(a, inside)), percent(share(b, inside))});
  if (share(a, at_ridge) > 0.0 || share(b, at_ridge) > 0.0)
    t.row("Share of the rotation with contact at the start of a relief", "", "%",
          {percent(share(a, at_ridge)), percent(share(b, at_ridge))});
  t.row("Share of the rotation with an edge in contact", "", "%",
        {percent(share(a, is_edge)), percent(share(b, is_edge))});
  if (a.contact_lost || b.contact_lost)
    t.row("Share of the rotation without contact", "", "%",
          {percent(share(a, nowhere)), percent(share(b, nowhere))});
  if (report.min_play && a.rack) {
    t.common("Minimum backlash along the rack", "", unit_text(units, Unit::mm),
             text_in(units, Unit::mm, a.rack.of(*report.min_play), kLengthDigits));
  } else if (report.min_play) {
    t.common("Minimum angular backlash of gear 2 between both flanks", "", "°",
             fixed(kDegPerRad * report.min_play->rad(), kAngleDigits));
  }
  t.common("Thickness of the marking compound", "δ", unit_text(units, Unit::mm),
           fmt::format("{:g}", value_in(units, Unit::mm, report.marking)));
  return t.str();
}

std::string beside(const std::string& figure, const char* words) {
  return in_columns(figure, fmt::format("\n<p>{}</p>\n", words));
}

std::string te_part(const ContactReport& report, const FigureForm& form) {
  const std::string spectrum = form.html(spectrum_figure(report.driving));
  const std::string curves =
      std::string(
          "<h3>Transmission error, the cause of gear noise</h3>\n<p>If gear 1 turns evenly, a "
          "perfect ") +
      (report.driving.rack
           ? "rack moves evenly too. The <em>transmission error</em> is the travel by "
             "which the rack is "
           : "gear 2 turns evenly too. The <em>transmission error</em> is the angle "
             "by which gear 2 is ") +
      "ahead (above zero) or behind. A constant part is a small shift without effect. The part "
      "that repeats with every tooth excites the shafts at the tooth frequency and causes gear "
      "whine. A low and smooth curve means a quiet pair. A sharp corner causes an impact. The "
      "teeth are rigid here and carry no load.</p>\n" +
      side_by_side(form.html(transmission_error_figure(report, report.driving)) +
                   form.html(transmission_error_figure(report, report.other)));
  if (spectrum.empty())
    return curves +
           fmt::format("<p class=\"nopicture\">{}</p>\n",
                       report.driving.contact_lost
                           ? "There is no spectrum, because contact is lost."
                           : "There is no spectrum, because the transmission error is constant.");
  return curves + beside(spectrum,
                         "A periodic curve is a sum of harmonics. The first bar belongs to the "
                         "tooth frequency, teeth × revolutions per second, and the next bars to "
                         "its multiples. One tall bar at the left is a pure, low tone. Bars that "
                         "decrease slowly are caused by sharp corners of the curve, where contact "
                         "passes from one tooth pair to the next. Such a pair sounds harsh. A tall "
                         "bar near a resonance of the housing should be lowered.");
}

std::string pattern_part(const ContactReport& report, const FigureForm& form) {
  // If the flanks are conjugate, all tooth pairs in mesh touch at the same time.
  const char* several = report.driving.peak_to_peak.arcsec() < kConjugate
                            ? " Here all tooth pairs in mesh touch at the same time. At each "
                              "position, the path shows only the tooth pair that is nearest to the "
                              "centre line."
                            : "";
  std::vector<std::optional<Figure>> patterns;
  for (std::size_t i = 0; i < (report.driving.rack ? 1u : 2u); ++i)
    patterns.emplace_back(flank_figure(report, i, {.pattern = &report.patterns[i]}));
  return fmt::format(
             "<h3>Bearing contact: where the teeth touch</h3>\n<p>Each picture shows a flank laid "
             "flat, with the face from left to right, the root at the bottom and the tip at the "
             "top. In a workshop, a fitter paints one gear thinly with marking blue and turns the "
             "pair by hand. The paint marks the places where the flanks come closer than its "
             "thickness, here {} µm. The shaded area shows these marks, the <em>marking "
             "pattern</em>. At any instant, the flanks are this close only within an ellipse about "
             "the contact point, or along a line. The ellipse or line moves over the flank while "
             "the gears turn. A good pattern is in the middle and does not reach the borders. "
             "Where the path of contact runs along a border (dashed), an <em>edge</em> is in "
             "contact. The sharp edge then carries the load instead of the flank, scrapes off the "
             "oil and wears or pits the mating gear.{}</p>\n",
             fixed(kUmPerMm * report.marking, 2), several) +
         form.row(patterns);
}

std::string gap_part(const ContactReport& report, const FigureForm& form) {
  if (!report.middle) return {};
  const FlankLayers gap{.gap = &report.middle_gap, .now = &*report.middle, .way = false};
  return "<h3>Gap between the flanks</h3>\n" +
         beside(form.html(flank_figure(report, 0, gap)),
                "The contour lines show the gap between two teeth at one position. The gap is zero "
                "at the contact point. Where the lines are far apart, the flanks are close over a "
                "wide area and share the load. Where the lines are close together, a small spot is "
                "under high pressure. Misaligned shafts tilt the map, so the gap grows towards one "
                "end of the face.");
}

std::string multiples_part(const ContactReport& report, const FigureForm& form) {
  if (report.under.empty()) return {};
  std::string pictures;
  for (const PatternUnder& u : report.under) {
    Figure f = small_pattern("under" + std::to_string(&u - report.under.data()), u.name, u.pattern,
                             report.marking);
    f.caption = u.peak_to_peak ? "<br>peak to peak " + shown_arcsec(u.peak_to_peak->arcsec()) + "″"
                               : "<br>no teeth touch";
    pictures +=
        figure_html(in_units(form.units, f), kSmallFigure, u.as_specified ? " class=\"own\"" : "");
  }
  return "<h3>Which error moves the pattern</h3>\n<p>The pictures show the pattern on gear 1 under "
         "each error alone, in both directions, and under all errors together. The picture that "
         "resembles the pattern on the real gears shows the error to correct.</p>\n<div "
         "class=\"multiples contact\">\n" +
         pictures + "</div>\n";
}

std::string map_part(const ContactReport& report, const FigureForm& form) {
  if (!report.map) return {};
  return "<h3>Permissible misalignment</h3>\n" +
         beside(form.html(error_map_figure(*report.map)),
                "Each point of the map represents the pair with these two errors, and the shade of "
                "the point shows the transmission error. If the area of low values is wide, the "
                "pair tolerates errors of housings and bearings. If it is narrow, the pair "
                "requires accurate mounting. An oblique valley means that one error can be "
                "compensated by the other.");
}

std::string arc_part(const ContactReport& report, const FigureForm& form) {
  if (!report.arc_pair) return {};
  std::string figures;
  for (const Figure& figure : arc_contact_figures(*report.arc_pair))
    figures += form.html(figure, kWideFigure);
  if (figures.empty()) return {};
  return "<h3>Contact of the arcs</h3>\n<p>A convex arc lies in a slightly wider concave arc and "
         "touches it at a point. Both centres lie on the common normal through this point. Across "
         "the tooth the fit is close, so such teeth carry high loads. The point moves along the "
         "tooth while the gears turn. However, a wrong centre distance changes the angle at which "
         "the arcs touch, and the point moves up or down the flank.</p>\n" +
         side_by_side(figures);
}

std::string halves_of(const ContactReport& report, const FigureForm& form) {
  std::vector<std::string> pictures;
  for (const ContactReport& half : report.halves)
    pictures.push_back(pattern_part(half, form) + gap_part(half, form));
  return halves_part(
      "both halves transmit the same torque, and the transmission error is the mean of both halves",
      "The halves are mirror images of each other, so the contact on one half mirrors the contact "
      "on the other.",
      pictures);
}

}  // namespace

std::string contact_section(const ContactReport& report, const FigureForm& form,
                            std::string_view title) {
  GW_EXPECTS(report.gears[0] && (report.gears[1] || report.driving.rack) && report.positions >= 2);
  GW_EXPECTS(report.driving.positions.size() == static_cast<std::size_t>(report.positions));
  GW_EXPECTS(report.other.positions.size() == report.driving.positions.size());
  GW_EXPECTS(share(report.driving, nowhere) < 1.0);
  const std::string what = fmt::format(
      "\n<p>The pair is turned through one pitch with the errors and modifications of the "
      "specification, and the first contact of the flanks is computed at each "
      "position.</p>\n<p><strong>{}</strong></p>\n{}",
      contact_words(report.driving, report.span[0]), assumed(report));
  return fmt::format("<section class=\"contact\">\n<h2>{}</h2>\n", title) +
         in_columns(what, "\n" + facts(report, form.units)) + te_part(report, form) +
         (report.halves.empty() ? pattern_part(report, form) + gap_part(report, form)
                                : halves_of(report, form)) +
         multiples_part(report, form) + map_part(report, form) + arc_part(report, form) +
         "</section>\n";
}

}  // namespace gearwright
