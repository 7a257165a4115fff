#include "gearwright/report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/quantity_table.hpp"
#include "gearwright/report/shown_values.hpp"

namespace gearwright {

using shown::angle;
using shown::length;
using shown::ratio;

std::string pair_table(const Pair& pair) {
  TableBuilder t("Pair data, symbols of ISO 21771", {"Gear 1", "Gear 2"});
  const auto& quantities = pair_quantities();
  add_groups(t, text_groups(quantities.table(), {quantities.of(pair)}, kPage));
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

namespace {

// What was looked at, where nothing was found.
std::string nothing_strikes(const InvolutePair& p) {
  if (p.overlap) {
    return fmt::format(
        "<p>No interference: in every position of a pitch, and over the whole backlash, the two "
        "finished {}.</p>\n",
        p.crossed() ? "gears meet flank on flank only; tips keep clear of roots and fillets"
                    : "outlines meet flank on flank only");
  }
  const bool lost = std::any_of(p.warnings.begin(), p.warnings.end(), [](const Warning& w) {
    return w.code == WarningCode::contact_lost_to_undercut;
  });
  return fmt::format(
      "<p>No interference was found: tips keep clear of roots, and {}. The internal gear’s root "
      "fillet is not checked.</p>\n",
      lost ? "where an undercut took the flank nothing strikes"
           : "none reaches below the mating gear’s usable flank");
}

struct CollisionRow {
  std::string code;
  int gear;
  std::string amount, words;
};

std::string strike_rows(const std::string& caption, const std::vector<CollisionRow>& rows) {
  if (rows.empty()) return "";
  std::string text = fmt::format(
      "<div class=\"scroll\"><table>\n<caption>{}</caption>\n<thead><tr><th scope=\"col\">What</th>"
      "<th scope=\"col\">Gear</th><th scope=\"col\" class=\"value\">Depth</th>"
      "<th scope=\"col\">In words</th></tr></thead>\n<tbody>\n",
      caption);
  for (const CollisionRow& row : rows) {
    text += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"value\">{}</td><td "
        "class=\"words\">{}</td></tr>\n",
        escaped(row.code), row.gear > 0 ? std::to_string(row.gear) : "both", row.amount,
        escaped(row.words));
  }
  return text + "</tbody></table></div>\n";
}

std::vector<CollisionRow> rows_of(const std::vector<Collision>& collisions) {
  std::vector<CollisionRow> rows;
  for (const Collision& s : collisions)
    rows.push_back({to_string(s.cause), s.gear, length(s.depth) + " mm", s.message});
  return rows;
}

// Without what a row of the overlap has said.
std::vector<CollisionRow> rows_of(const std::vector<Interference>& named,
                                  const std::vector<CollisionRow>& listed) {
  std::vector<CollisionRow> rows;
  for (const Interference& i : named) {
    const bool again = std::any_of(listed.begin(), listed.end(),
                                   [&](const CollisionRow& row) { return row.words == i.message; });
    if (again) continue;
    const auto* turn = std::get_if<Angle>(&i.amount);
    rows.push_back({to_string(i.code), i.gear,
                    turn ? angle(*turn) + "°" : length(std::get<double>(i.amount)) + " mm",
                    i.message});
  }
  return rows;
}

}  // namespace

std::string interference_table(const InvolutePair& p) {
  const std::vector<CollisionRow> overlap =
      p.overlap ? rows_of(*p.overlap) : std::vector<CollisionRow>{};
  if (overlap.empty() && p.interference.empty() && p.beyond_flank.empty())
    return nothing_strikes(p);
  return strike_rows("Overlap of the outlines, in the middle of the backlash", overlap) +
         strike_rows(p.overlap ? "What explains it" : "Interference",
                     rows_of(p.interference, overlap)) +
         strike_rows("Contact beyond the flanks, before they meet", rows_of(p.beyond_flank));
}

}  // namespace gearwright
