#include "gearwright/report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

std::string length(const std::optional<double>& mm) { return fixed(mm, kLengthDigits); }
std::string angle(double rad) { return fixed(kDegree * rad, kAngleDigits); }
std::string ratio(const std::optional<double>& value) { return fixed(value, kRatioDigits); }
std::string none() { return std::string(kNoValue); }

// A factor as given: no digit more than the input had.
std::string given(double value) { return fmt::format("{:.10g}", value); }

std::optional<double> diameter(const std::optional<double>& radius) {
  return radius ? std::optional(2 * *radius) : std::nullopt;
}

const char* hand(const Gear& g) {
  const double beta = g.spec.helix_angle.rad();
  return beta > 0.0 ? "right" : beta < 0.0 ? "left" : "spur";
}

std::optional<double> neck_thickness(const Gear& g) {
  if (!g.tooth || !g.tooth->neck_half_angle || !g.tooth->neck_radius) return std::nullopt;
  return 2 * *g.tooth->neck_radius * std::sin(*g.tooth->neck_half_angle);
}

std::string teeth(const Gear& g) {
  return g.internal() ? fmt::format("{} (ring)", g.spec.teeth) : fmt::format("{}", g.spec.teeth);
}

std::optional<double> tip_form_diameter(const Gear& g) {
  if (!g.exists() || (g.tooth && !g.tooth->tip_form_radius)) return std::nullopt;
  return 2 * g.tip_form_radius();
}

// Rows of one function of the gear each.
class GearRows {
 public:
  GearRows(TableBuilder& table, const std::vector<const Gear*>& gears)
      : table_(table), gears_(gears) {}

  void add(std::string_view words, std::string_view symbol, std::string_view unit,
           const std::function<std::string(const Gear&)>& value) {
    std::vector<std::string> values;
    for (const Gear* g : gears_) values.push_back(value(*g));
    table_.row(words, symbol, unit, values);
  }
  bool any(const std::function<bool(const Gear&)>& is) const {
    for (const Gear* g : gears_) {
      if (is(*g)) return true;
    }
    return false;
  }

 private:
  TableBuilder& table_;
  const std::vector<const Gear*>& gears_;
};

void add_rack(TableBuilder& table, GearRows& rows) {
  table.group("Basic rack, in normal modules");
  rows.add("Addendum", "h_aP*", "", [](const Gear& g) { return given(g.spec.rack.addendum); });
  rows.add("Dedendum", "h_fP*", "", [](const Gear& g) { return given(g.spec.rack.dedendum); });
  rows.add("Root fillet radius", "ρ_fP*", "",
           [](const Gear& g) { return given(g.spec.rack.root_fillet_radius); });
  if (rows.any([](const Gear& g) { return g.spec.rack.tip_fillet_radius != 0.0; })) {
    rows.add("Tip fillet radius", "ρ_1*", "",
             [](const Gear& g) { return given(g.spec.rack.tip_fillet_radius); });
  }
  if (rows.any([](const Gear& g) { return g.spec.rack.tool_addendum.has_value(); })) {
    rows.add("Height of the tool’s straight flank", "", "", [](const Gear& g) {
      return g.spec.rack.tool_addendum ? given(*g.spec.rack.tool_addendum) : none();
    });
  }
  if (rows.any([](const Gear& g) { return g.spec.rack.semi_topping_angle.has_value(); })) {
    rows.add("Semi-topping angle", "", "°", [](const Gear& g) {
      return g.spec.rack.semi_topping_angle ? given(g.spec.rack.semi_topping_angle->deg()) : none();
    });
  }
  if (rows.any([](const Gear& g) { return g.spec.rack.protuberance != 0.0; })) {
    rows.add("Protuberance", "pr_P*", "",
             [](const Gear& g) { return given(g.spec.rack.protuberance); });
    rows.add("Protuberance angle", "α_pr", "°", [](const Gear& g) {
      return g.spec.rack.protuberance != 0.0 ? given(g.spec.rack.protuberance_angle.deg()) : none();
    });
  }
}

void add_tooth(TableBuilder& table, GearRows& rows) {
  table.group("Tooth");
  rows.add("Reference thickness, normal", "s_n", "mm",
           [](const Gear& g) { return length(g.reference.reference_tooth_thickness_normal); });
  rows.add("Allowance contained in it", "E_sn", "mm",
           [](const Gear& g) { return length(g.spec.thickness_allowance); });
  rows.add("Reference thickness, transverse", "s_t", "mm",
           [](const Gear& g) { return length(g.reference.reference_tooth_thickness_transverse); });
  rows.add("Base thickness, transverse", "s_bt", "mm",
           [](const Gear& g) { return length(g.reference.base_tooth_thickness); });
  rows.add("Tip thickness, normal", "s_an", "mm",
           [](const Gear& g) { return length(g.tip_tooth_thickness_normal); });
  rows.add("Smallest root thickness (chord)", "", "mm",
           [](const Gear& g) { return length(neck_thickness(g)); });
  rows.add("Base pitch, normal", "p_bn", "mm",
           [](const Gear& g) { return length(g.reference.base_pitch_normal); });
  rows.add("Base pitch, transverse", "p_bt", "mm",
           [](const Gear& g) { return length(g.reference.base_pitch_transverse); });
  rows.add("Undercut", "", "", [](const Gear& g) {
    return std::string(g.internal() ? kNoValue : g.undercut ? "yes" : "no");
  });
  rows.add("Least profile shift without undercut", "x_Emin", "", [](const Gear& g) {
    const auto& x = g.undercut_free_profile_shift;
    return g.internal() || !x ? none() : ratio(*x);
  });
}

void add_crossed_contact(TableBuilder& t, const Pair& p) {
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

std::string gear_table(const std::vector<const Gear*>& gears) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < gears.size(); ++i) columns.push_back(fmt::format("Gear {}", i + 1));
  TableBuilder table("Gear data, symbols of ISO 21771", columns);
  GearRows rows(table, gears);
  table.group("Teeth");
  rows.add("Number of teeth", "z", "", teeth);
  rows.add("Normal module", "m_n", "mm", [](const Gear& g) { return given(g.spec.normal_module); });
  rows.add("Normal pressure angle", "α_n", "°",
           [](const Gear& g) { return angle(g.spec.normal_pressure_angle.rad()); });
  rows.add("Helix angle", "β", "°", [](const Gear& g) { return angle(g.spec.helix_angle.rad()); });
  rows.add("Hand of helix", "", "", [](const Gear& g) { return std::string(hand(g)); });
  rows.add("Lead", "p_z", "mm",
           [](const Gear& g) { return g.lead == 0.0 ? none() : length(g.lead); });
  rows.add("Profile shift", "x", "", [](const Gear& g) { return ratio(g.spec.profile_shift); });
  rows.add("Profile shift as cut, with allowance", "x_E", "",
           [](const Gear& g) { return ratio(g.reference.generating_profile_shift); });
  rows.add("Face width", "b", "mm", [](const Gear& g) { return length(g.spec.face_width); });
  rows.add("Transverse module", "m_t", "mm",
           [](const Gear& g) { return fixed(g.reference.transverse_module, 5); });
  rows.add("Transverse pressure angle", "α_t", "°",
           [](const Gear& g) { return angle(g.reference.transverse_pressure_angle); });
  rows.add("Base helix angle", "β_b", "°",
           [](const Gear& g) { return angle(g.reference.base_helix_angle); });

  table.group("Diameters");
  rows.add("Tip", "d_a", "mm", [](const Gear& g) { return length(g.tip_diameter); });
  if (rows.any([](const Gear& g) { return 2 * g.actual_tip_radius() != g.tip_diameter; })) {
    rows.add("Tip, as the tooth really ends", "", "mm",
             [](const Gear& g) { return g.exists() ? length(2 * g.actual_tip_radius()) : none(); });
  }
  rows.add("Tip form, end of the usable flank", "d_Fa", "mm",
           [](const Gear& g) { return length(tip_form_diameter(g)); });
  rows.add("Reference", "d", "mm",
           [](const Gear& g) { return length(g.reference.reference_diameter); });
  rows.add("Base", "d_b", "mm", [](const Gear& g) { return length(g.reference.base_diameter); });
  rows.add("Root form, start of the usable flank", "d_Ff", "mm", [](const Gear& g) {
    return g.exists() ? length(diameter(g.root_form_radius())) : none();
  });
  rows.add("Root", "d_f", "mm", [](const Gear& g) { return length(g.root_diameter); });
  rows.add("Where the flanks meet (point)", "", "mm",
           [](const Gear& g) { return length(g.pointed_diameter); });
  add_tooth(table, rows);
  add_rack(table, rows);
  return table.str();
}

std::string pair_table(const Pair& p) {
  const Mesh<double>& m = p.mesh;
  const auto& sides = m.rack.sides;
  TableBuilder t("Pair data", {"Gear 1", "Gear 2"});
  t.group("Mounting");
  t.common("Centre distance", "a", "mm", length(p.center_distance));
  if (p.crossed()) t.common("Shaft angle", "Σ", "°", angle(p.shaft_angle()));
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
    const auto degrees = [](const std::optional<double>& rad) {
      return rad ? angle(*rad) : none();
    };
    t.group("Internal pair: margins against interference");
    t.common("Involute: path’s start above the pinion’s form point", "", "mm",
             length(p.involute_margin));
    t.common("Trochoid: tips pass each other", "", "°", degrees(p.trochoid_margin));
    t.common("Trimming: radial assembly", "", "°", degrees(p.trimming_margin));
  }
  return t.str();
}

std::string path_table(const Pair& p) {
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

std::string interference_table(const Pair& p) {
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
        p.kind == PairKind::parallel_internal ? "; the ring’s root fillet is not checked" : "");
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
        escaped(i.code), i.gear, turns ? angle(i.amount) + "°" : length(i.amount) + " mm",
        escaped(i.message));
  }
  return text + "</tbody></table></div>\n";
}

}  // namespace gearwright
