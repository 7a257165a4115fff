#include "gearwright/report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/units.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string length(UnitSystem units, double mm) {
  return text_in(units, Unit::mm, mm, kLengthDigits);
}
std::string with_unit(UnitSystem units, double mm) {
  return length(units, mm) + " " + std::string(unit_text(units, Unit::mm));
}
std::string ratio(const std::optional<double>& value) { return fixed(value, kRatioDigits); }
std::string none() { return std::string(kNoValue); }

// Returns a factor of the spec with as many digits as the user gave.
std::string given(double value) { return fmt::format("{:.10g}", value); }

constexpr int kRackDigits = 6;  // digits of the data of arcs, in modules or degrees

std::optional<double> unless_zero(double value) {
  return value != 0.0 ? std::optional(value) : std::nullopt;
}

// Adds the rows of the rack. A row is omitted if no gear has a value for it. A gear that is cut by
// a pinion cutter has no rack.
void add_rack(TableBuilder& table, const std::vector<const Gear*>& gears) {
  struct Row {
    const char *words, *symbol, *unit;
    std::optional<double> (*value)(const StraightRack&);
  };
  static const std::array<Row, 8> kRows{
      {{"Addendum", "h_aP*", "", [](const StraightRack& r) { return std::optional(r.addendum); }},
       {"Dedendum", "h_fP*", "", [](const StraightRack& r) { return std::optional(r.dedendum); }},
       {"Root fillet radius", "ρ_fP*", "",
        [](const StraightRack& r) { return std::optional(r.root_fillet_radius); }},
       {"Tip fillet radius", "ρ_1*", "",
        [](const StraightRack& r) { return unless_zero(r.tip_fillet_radius); }},
       {"Height of the straight flank of the tool", "", "",
        [](const StraightRack& r) { return r.tool_addendum; }},
       {"Semi-topping angle", "", "°",
        [](const StraightRack& r) {
          return r.semi_topping_angle ? std::optional(r.semi_topping_angle->deg()) : std::nullopt;
        }},
       {"Protuberance", "pr_P*", "",
        [](const StraightRack& r) { return unless_zero(r.protuberance); }},
       {"Protuberance angle", "α_pr", "°", [](const StraightRack& r) {
          return r.protuberance != 0.0 ? std::optional(r.protuberance_angle.deg()) : std::nullopt;
        }}}};
  if (std::none_of(gears.begin(), gears.end(), [](const Gear* g) { return g->straight_cutter(); }))
    return;
  table.group("Basic rack, in normal modules");
  for (const Row& row : kRows) {
    std::vector<std::string> values;
    bool any = false;
    for (const Gear* g : gears) {
      const StraightRack* rack = g->straight_cutter();
      const std::optional<double> v = rack ? row.value(*rack) : std::nullopt;
      values.push_back(v ? given(*v) : none());
      any = any || v;
    }
    if (any) table.row(row.words, row.symbol, row.unit, values);
  }
}

void add_arcs(TableBuilder& table, const std::vector<const Gear*>& gears) {
  std::size_t most = 0;
  for (const Gear* g : gears)
    most = std::max(most, g->arc_cutter() ? g->arc_cutter()->arcs.size() : 0);
  if (most == 0) return;
  table.group("Basic rack of arcs, in normal modules, starting at the tip of the cutter");
  const auto row = [&](const char* words, const char* symbol, const char* unit, const auto& value) {
    std::vector<std::string> values;
    for (const Gear* g : gears)
      values.push_back(g->arc_cutter() ? value(*g->arc_cutter()) : none());
    table.row(words, symbol, unit, values);
  };
  row("Addendum", "h_a*", "", [](const RackOfArcs& r) { return given(r.addendum); });
  row("Dedendum", "h_f*", "", [](const RackOfArcs& r) { return given(r.dedendum); });
  for (std::size_t i = 0; i < most; ++i) {
    const auto of = [i](double RackArc::*member) {
      return [i, member](const RackOfArcs& r) {
        return i < r.arcs.size() ? fixed(r.arcs[i].*member, kRackDigits) : none();
      };
    };
    const std::string n = std::to_string(i + 1);
    row(("Arc " + n + ": radius (> 0 for a convex, < 0 for a concave tooth)").c_str(), "q*", "",
        of(&RackArc::radius));
    row("  height of its centre", "x*", "", of(&RackArc::center_height));
    row("  distance of its centre from the middle of the tooth", "y*", "",
        of(&RackArc::center_offset));
    row("  normal angle from root to tip", "τ", "°", [i](const RackOfArcs& r) {
      if (i >= r.arcs.size()) return none();
      return fixed(r.arcs[i].begin.deg(), kRackDigits) + " … " +
             fixed(r.arcs[i].end.deg(), kRackDigits);
    });
  }
}

std::vector<TextGroup> gear_groups(UnitSystem units, const std::vector<const Gear*>& gears,
                                   const std::array<std::optional<Halves>, 2>& halves = {}) {
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < gears.size(); ++i)
    records.push_back(gear_record(*gears[i], halves[i]));
  return text_groups(gear_quantities().table(), records, kPage, units);
}

// Returns a sentence for a pair without interference. It states what was checked.
std::string no_collision_text(const InvolutePair& p) {
  if (p.overlap && p.crossed_inside()) {
    return "<p>There is no interference of tips. The tips keep clear of roots, fillets and flanks. "
           "Whether the flanks overlap beside the line of action depends on the lead "
           "crowning.</p>\n";
  }
  if (p.overlap) {
    return fmt::format(
        "<p>There is no interference. In every position of a pitch and over the whole backlash, "
        "{}.</p>\n",
        p.crossed() ? "the two finished gears touch only with their flanks, and tips keep clear of "
                      "roots and fillets"
                    : "the two finished outlines touch only with their flanks");
  }
  const bool lost = warns(p, WarningCode::contact_lost_to_undercut);
  return fmt::format(
      "<p>No interference was found. Tips keep clear of roots, and {}. The root fillet of the "
      "internal gear is not checked.</p>\n",
      lost ? "nothing collides where undercut removed the flank"
           : "no tip reaches below the usable flank of the mating gear");
}

struct CollisionRow {
  std::string code;
  int gear;
  std::string amount, words;
};

std::string collision_rows(const std::string& caption, const std::vector<CollisionRow>& rows) {
  if (rows.empty()) return "";
  std::vector<std::vector<std::string>> cells;
  for (const CollisionRow& row : rows)
    cells.push_back({escaped(row.code), row.gear > 0 ? std::to_string(row.gear) : "both",
                     row.amount, escaped(row.words)});
  return value_table(caption, {"Code", "Gear", "Depth", "Meaning"}, cells, "collisions");
}

std::vector<CollisionRow> rows_of(const std::vector<Collision>& collisions, UnitSystem units) {
  std::vector<CollisionRow> rows;
  for (const Collision& s : collisions)
    rows.push_back({to_string(s.cause), s.gear, with_unit(units, s.depth), s.message});
  return rows;
}

// Returns the rows of the interferences that are not also entries of the overlap.
std::vector<CollisionRow> rows_of(const std::vector<Interference>& named, UnitSystem units) {
  std::vector<CollisionRow> rows;
  for (const Interference& i : named) {
    if (i.of_overlap) continue;
    const auto* turn = std::get_if<Angle>(&i.amount);
    rows.push_back({to_string(i.code), i.gear,
                    turn ? fixed(kDegPerRad * turn->rad(), kAngleDigits) + "°"
                         : with_unit(units, std::get<double>(i.amount)),
                    i.message});
  }
  return rows;
}

}  // namespace

std::vector<std::string> gear_headings(std::size_t gears) {
  std::vector<std::string> columns;
  for (std::size_t i = 1; i <= gears; ++i) columns.push_back(fmt::format("Gear {}", i));
  return columns;
}

std::string gear_table(const std::vector<const Gear*>& gears,
                       const std::array<std::optional<Halves>, 2>& halves, UnitSystem units) {
  using namespace gear_group;
  // Gears with few teeth have additional rows, which are in a separate table.
  std::vector<TextGroup> common, cutter;
  for (TextGroup& g : gear_groups(units, gears, halves)) {
    if (g.title == kCutter)
      cutter.push_back(std::move(g));
    else if (g.title == kTeeth || g.title == kDiameters || g.title == kTooth)
      common.push_back(std::move(g));
  }
  TableBuilder table("Gear data, symbols of ISO 21771", gear_headings(gears.size()));
  table.decisive_rows({"teeth", "profile_shift", "tip_diameter_mm"});
  table.groups(common);
  if (halves[0] || halves[1]) {
    std::vector<ValueRecord> records;
    for (std::size_t i = 0; i < gears.size(); ++i)
      if (halves[i]) records.push_back(double_helical_quantities().of(*halves[i]));
    table.groups(text_groups(double_helical_quantities().table(), records, kPage, units));
  }
  add_rack(table, gears);
  add_arcs(table, gears);
  table.groups(cutter);
  return table.str();
}

std::string few_teeth_table(const std::vector<const Gear*>& gears, UnitSystem units) {
  using namespace gear_group;
  const bool any = std::any_of(gears.begin(), gears.end(), [](const Gear* g) {
    return (g->tooth && (g->tooth->root_fillet || g->tooth->tip_fillet)) ||
           root_is_worth_a_picture(*g);
  });
  if (!any) return {};
  std::vector<TextGroup> groups = gear_groups(units, gears);
  std::erase_if(groups, [](const TextGroup& g) {
    return g.title != kUndercut && g.title != kRootFillet && g.title != kTipFillet;
  });
  if (groups.empty()) return {};
  TableBuilder table("Points and fillets; l is the position along the straight flank of the rack",
                     gear_headings(gears.size()));
  table.groups(groups);
  return table.str();
}

std::string pair_table(const Pair& pair, UnitSystem units) {
  TableBuilder t("Pair data, symbols of ISO 21771", gear_headings(2));
  t.decisive_rows(
      {"transverse_contact_ratio", "overlap_ratio", "contact_ratio_crossed", "tip_clearance_mm"});
  t.groups(units, pair_quantities(), pair);
  return t.str();
}

std::string path_table(const InvolutePair& p, UnitSystem units) {
  const Mesh<double>& m = p.mesh;
  struct Mark {
    const char* letter;
    const char* words;
    double rho1;
  };
  const bool crossed = p.crossed();
  const auto [start, end] = contact_ends(p);
  const bool late = start > m.rho1_A, early = end < m.rho1_E;
  std::vector<Mark> marks{
      {"A", late ? "tip of gear 2, not reached" : "start of contact, at the tip of gear 2",
       m.rho1_A},
      {"B", crossed ? "one pitch before E" : "one base pitch before E", m.rho1_B},
      {"C", crossed ? "pitch point of gear 1" : "pitch point", m.rho1_C},
      {"D", crossed ? "one pitch after A" : "one base pitch after A", m.rho1_D},
      {"E", early ? "tip of gear 1, not reached" : "end of contact, at the tip of gear 1",
       m.rho1_E}};
  if (late) marks.push_back({"", "start of contact on the usable flanks", start});
  if (early) marks.push_back({"", "end of contact on the usable flanks", end});
  const std::string unit = ", " + std::string(unit_text(units, Unit::mm));
  std::vector<std::vector<std::string>> rows;
  for (const Mark& mark : marks) {
    const bool reached = mark.rho1 >= start && mark.rho1 <= end;
    const SpecificSliding<double> s =
        reached ? specific_sliding(p.input, m, mark.rho1) : SpecificSliding<double>{};
    rows.push_back({fmt::format("<strong>{}</strong> {}", mark.letter, mark.words),
                    length(units, (mark.rho1 - m.rho1_C) / m.line_cosine), length(units, mark.rho1),
                    length(units, m.rho2(mark.rho1)), ratio(s.zeta_1), ratio(s.zeta_2)});
  }
  return value_table(crossed ? "Points of the line of action; ζ is the sliding distance divided "
                               "by the distance that the contact travels on the flank"
                             : "Points of the path of contact",
                     {"Point", "from C" + unit, symbol_html("ρ_1") + unit,
                      symbol_html("ρ_2") + unit, symbol_html("ζ_1"), symbol_html("ζ_2")},
                     rows);
}

std::string interference_table(const InvolutePair& p, UnitSystem units) {
  const std::vector<CollisionRow> overlap =
      p.overlap ? rows_of(*p.overlap, units) : std::vector<CollisionRow>{};
  if (overlap.empty() && p.interference.empty() && p.beyond_flank.empty())
    return no_collision_text(p);
  return collision_rows("Overlap of the outlines, with the teeth in the middle of the backlash",
                        overlap) +
         collision_rows(p.overlap ? "Causes of the overlap" : "Interference",
                        rows_of(p.interference, units)) +
         collision_rows("Contact beyond the flanks, before the flanks touch",
                        rows_of(p.beyond_flank, units));
}

}  // namespace gearwright
