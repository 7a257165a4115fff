#include "gearwright/report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/shown_values.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

using shown::angle;
using shown::length;
using shown::none;
using shown::ratio;

namespace {

void add_crossed_contact(TableBuilder& t, const InvolutePair& p) {
  const FaceWidths<double>& f = *p.face_widths;
  t.common("Distance of the pitch planes", "X", "mm", length(p.mesh.pitch_plane_distance));
  t.common("Length of the line of action", "AE", "mm", length(p.path_length()));
  t.common("Contact ratio, tip to tip", "ε", "", ratio(p.contact_ratio()));
  t.common("Contact ratio of the usable flanks and faces", "ε", "", ratio(p.contact_ratio_true()));
  const auto needed = [&](const std::array<double, 2>& widths) {
    std::vector<std::string> values;
    for (const double w : widths) values.push_back(p.flanks_meet() ? length(w) : none());
    return values;
  };
  t.row("Face width needed, one flank", "f", "mm", needed(f.one_flank));
  t.row("Face width needed, both flanks, about the centre line", "f′", "mm", needed(f.both_flanks));
  if (p.least_distance) {
    t.common("Least centre distance without backlash", "", "mm",
             length(p.least_distance->center_distance));
    t.common("Shaft angle there", "", "°", angle(p.least_distance->shaft_angle));
  }
  if (p.contact_ratio_range) {
    const CrossedPlaces& r = *p.contact_ratio_range;
    t.common("Contact ratio ≥ 1 without backlash, shaft angle", "Σ", "°",
             angle(r.lo.shaft_angle) + " … " + angle(r.hi.shaft_angle));
  }
}

}  // namespace

std::string pair_table(const InvolutePair& p) {
  const Mesh<double>& m = p.mesh;
  const auto& sides = m.rack.sides;
  TableBuilder t("Pair data", {"Gear 1", "Gear 2"});
  t.group("Mounting");
  t.common("Centre distance", "a", "mm", length(p.center_distance));
  if (p.crossed()) t.common("Shaft angle", "Σ", "°", angle(p.shaft_angle));
  t.common("Reference centre distance", "a_d", "mm", length(p.reference_center_distance));
  t.common("Free of backlash, as cut", "", "mm", length(p.backlash_free_center_distance));
  t.common("Extended by the profile shifts", "", "mm", length(p.extended_center_distance));
  t.common("Gear ratio", "u", "", ratio(p.gear_ratio()));
  t.common("Working pressure angle, normal", "α_wn", "°", angle(m.rack.normal_pressure_angle));
  t.row("Working pressure angle, transverse", "α_wt", "°",
        {angle(sides[0].transverse_angle), angle(sides[1].transverse_angle)});
  t.row("Working helix angle", "β_w", "°",
        {angle(sides[0].helix_angle), angle(sides[1].helix_angle)});
  t.row("Working pitch diameter", "d_w", "mm",
        {length(2 * sides[0].pitch_radius), length(2 * sides[1].pitch_radius)});
  t.group("Contact");
  if (p.crossed()) {
    add_crossed_contact(t, p);
  } else {
    t.common("Length of the path of contact", "g_α", "mm", length(p.path_length()));
    t.common("Transverse contact ratio, tip to tip", "ε_α", "",
             ratio(p.transverse_contact_ratio()));
    t.common("Transverse contact ratio of the usable flanks", "ε_α", "", ratio(m.true_ratio));
    t.common("Overlap ratio", "ε_β", "", ratio(m.overlap_ratio));
    t.common("Total contact ratio, tip to tip", "ε_γ", "", ratio(p.contact_ratio()));
    t.common("Total contact ratio of the usable flanks", "ε_γ", "", ratio(p.contact_ratio_true()));
  }
  t.row("Specific sliding at A", "ζ", "", {ratio(p.sliding_A.zeta_1), ratio(p.sliding_A.zeta_2)});
  t.row("Specific sliding at E", "ζ", "", {ratio(p.sliding_E.zeta_1), ratio(p.sliding_E.zeta_2)});
  if (p.efficiency) {
    const auto percent = [](const std::optional<double>& v) {
      return v ? fixed(100 * *v, 2) : std::string("self-locking");
    };
    t.row("Efficiency of the teeth, this gear driving", "η", "%",
          {percent(p.efficiency->gear1_drives), percent(p.efficiency->gear2_drives)});
  }
  t.group("Backlash");
  t.common("Along the common normal", "j_bn", "mm", length(m.backlash.normal_base));
  t.common("Normal, at the working pitch circles", "j_n", "mm", length(m.backlash.normal));
  t.row("Circumferential, at the working pitch circles", "j_wt", "mm",
        {length(m.backlash.circumferential[0]), length(m.backlash.circumferential[1])});
  t.row("Rotation, the mate held", "", "°",
        {angle(m.backlash.rotation[0]), angle(m.backlash.rotation[1])});
  t.group("Clearances");
  t.row("Own tip to the mate’s root", "c", "mm",
        {length(p.tip_clearance[0]), length(p.tip_clearance[1])});
  t.row("Contact starts at diameter", "d_Nf", "mm",
        {length(p.contact_root_diameter[0]), length(p.contact_root_diameter[1])});
  t.row("From there to the root form circle, radial", "c_F", "mm",
        {length(p.form_clearance[0]), length(p.form_clearance[1])});
  if (!p.crossed()) {
    t.row("Mate’s tip corner to own root fillet", "", "mm",
          {length(p.fillet_clearance[0]), length(p.fillet_clearance[1])});
  }
  t.common("Tip shortening that keeps the racks’ clearance", "k m_n", "mm",
           length(p.tip_shortening));
  if (p.kind == PairKind::parallel_internal) {
    const auto degrees = [](const std::optional<Angle>& a) { return a ? angle(*a) : none(); };
    t.group("Internal pair: margins against interference");
    t.common("Involute: path’s start above the pinion’s form point", "", "mm",
             length(p.involute_margin));
    t.common("Trochoid: tips pass each other", "", "°", degrees(p.trochoid_margin));
    t.common("Trimming: radial assembly", "", "°", degrees(p.trimming_margin));
  }
  return t.str();
}

std::string path_table(const InvolutePair& p) {
  const Mesh<double>& m = p.mesh;
  struct Mark {
    const char* letter;
    const char* words;
    double rho1;
  };
  // Along the line of action: crossed lines leave the transverse section at the angle β_b1.
  const double cosine = p.crossed() ? std::cos(p.input.gears[0].helix_angle) : 1.0;
  const std::array<Mark, 5> marks{
      {{"A", "tip of gear 2 comes in", m.rho1_A},
       {"B", p.crossed() ? "one pitch before E" : "one base pitch before E", m.rho1_B},
       {"C", p.crossed() ? "pitch point of gear 1" : "pitch point", m.rho1_C},
       {"D", p.crossed() ? "one pitch after A" : "one base pitch after A", m.rho1_D},
       {"E", "tip of gear 1 goes out", m.rho1_E}}};
  std::string text =
      "<div class=\"scroll\"><table>\n<caption>" +
      std::string(p.crossed() ? "Points of the line of action; ζ: mm of sliding per mm that the "
                                "contact runs over the flank"
                              : "Points of the path of contact") +
      "</caption>\n<thead><tr><th scope=\"col\">Point</th><th scope=\"col\" class=\"value\">from "
      "C, mm</th>";
  for (const char* symbol : {"ρ_1", "ρ_2"}) {
    text += fmt::format("<th scope=\"col\" class=\"value\">{}, mm</th>", symbol_html(symbol));
  }
  for (const char* symbol : {"ζ_1", "ζ_2"}) {
    text += fmt::format("<th scope=\"col\" class=\"value\">{}</th>", symbol_html(symbol));
  }
  text += "</tr></thead>\n<tbody>\n";
  for (const Mark& mark : marks) {
    const SpecificSliding<double> s = specific_sliding(p.input, m, mark.rho1);
    text +=
        fmt::format("<tr><th scope=\"row\"><strong>{}</strong> {}</th>", mark.letter, mark.words);
    for (const std::string& value : {length((mark.rho1 - m.rho1_C) / cosine), length(mark.rho1),
                                     length(m.rho2(mark.rho1)), ratio(s.zeta_1), ratio(s.zeta_2)}) {
      text += fmt::format("<td class=\"value\">{}</td>", value);
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string interference_table(const InvolutePair& p) {
  if (p.interference.empty()) {
    if (p.crossed()) {
      const bool lost = std::any_of(p.warnings.begin(), p.warnings.end(),
                                    [](const Warning& w) { return w.code == "contact_lost"; });
      return fmt::format(
          "<p>No interference was found: tips keep clear of roots, and {}. Whether a tip corner "
          "strikes a root fillet is checked on parallel axes only.</p>\n",
          lost ? "where an undercut took the flank nothing strikes"
               : "none reaches below the mate’s usable flank");
    }
    return fmt::format(
        "<p>No interference was found: tips, roots, fillets and flanks keep clear of each "
        "other{}.</p>\n",
        p.kind == PairKind::parallel_internal && !p.gears[1].tooth
            ? "; the ring’s root fillet is not checked"
            : "");
  }
  std::string text =
      "<div class=\"scroll\"><table>\n<caption>Interference</caption>\n<thead><tr><th "
      "scope=\"col\">"
      "What</th><th scope=\"col\">Gear</th><th scope=\"col\" class=\"value\">Amount</th>"
      "<th scope=\"col\">In words</th></tr></thead>\n<tbody>\n";
  for (const Interference& i : p.interference) {
    const bool turns = i.code == "trochoid" || i.code == "trimming";
    text += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"value\">{}</td><td "
        "class=\"words\">{}</td></tr>\n",
        escaped(i.code), i.gear,
        turns ? angle(std::get<Angle>(i.amount)) + "°" : length(std::get<double>(i.amount)) + " mm",
        escaped(i.message));
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace gearwright
