#include "gearwright/report/gear_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "gearwright/report/shown_values.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

using shown::angle;
using shown::given;
using shown::length;
using shown::none;
using shown::ratio;

namespace {

constexpr int kRackDigits = 6;  // of arcs, in modules or degrees

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
    // What only an involute gear has is not asked of others.
    const bool none = std::all_of(values.begin(), values.end(),
                                  [](const std::string& v) { return v == kNoValue; });
    if (none && !any([](const Gear& g) { return g.involute() != nullptr; })) return;
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

using Rack = StraightRack;
using Reference = ReferenceGeometry<double>;

std::optional<double> unless_zero(double value) {
  return value != 0.0 ? std::optional(value) : std::nullopt;
}

// Rows that no rack has a number for are left out. A gear that a pinion has cut has no rack.
void add_rack(TableBuilder& table, GearRows& rows) {
  struct Row {
    const char *words, *symbol, *unit;
    std::optional<double> (*value)(const Rack&);
  };
  static const std::array<Row, 8> kRows{
      {{"Addendum", "h_aP*", "", [](const Rack& r) { return std::optional(r.addendum); }},
       {"Dedendum", "h_fP*", "", [](const Rack& r) { return std::optional(r.dedendum); }},
       {"Root fillet radius", "ρ_fP*", "",
        [](const Rack& r) { return std::optional(r.root_fillet_radius); }},
       {"Tip fillet radius", "ρ_1*", "",
        [](const Rack& r) { return unless_zero(r.tip_fillet_radius); }},
       {"Height of the tool’s straight flank", "", "",
        [](const Rack& r) { return r.tool_addendum; }},
       {"Semi-topping angle", "", "°",
        [](const Rack& r) {
          return r.semi_topping_angle ? std::optional(r.semi_topping_angle->deg()) : std::nullopt;
        }},
       {"Protuberance", "pr_P*", "", [](const Rack& r) { return unless_zero(r.protuberance); }},
       {"Protuberance angle", "α_pr", "°", [](const Rack& r) {
          return r.protuberance != 0.0 ? std::optional(r.protuberance_angle.deg()) : std::nullopt;
        }}}};
  if (!rows.any([](const Gear& g) { return !g.cut_by && g.involute(); })) return;
  table.group("Basic rack, in normal modules");
  for (const Row& row : kRows) {
    const auto value = [&row](const Gear& g) {
      return g.cut_by || !g.involute() ? std::nullopt : row.value(g.spec.straight_rack());
    };
    if (!rows.any([&](const Gear& g) { return value(g).has_value(); })) continue;
    rows.add(row.words, row.symbol, row.unit, [&](const Gear& g) {
      const std::optional<double> v = value(g);
      return v ? given(*v) : none();
    });
  }
}

// The arcs of a rack, one row each: signed radius, place of the centre, from which to which angle.
void add_arcs(TableBuilder& table, const std::vector<const Gear*>& gears) {
  std::size_t most = 0;
  for (const Gear* g : gears) most = std::max(most, g->arcs() ? g->arcs()->rack.arcs.size() : 0);
  if (most == 0) return;
  table.group("Basic rack of arcs, in normal modules; from the cutter’s tip on");
  const auto row = [&](const char* words, const char* symbol, const char* unit, const auto& value) {
    std::vector<std::string> values;
    for (const Gear* g : gears) values.push_back(g->arcs() ? value(g->arcs()->rack) : none());
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
    row(("Arc " + n + ": radius, > 0 convex, < 0 concave tooth").c_str(), "q*", "",
        of(&RackArc::radius));
    row("  height of its centre", "x*", "", of(&RackArc::center_height));
    row("  distance of its centre from the tooth’s middle", "y*", "", of(&RackArc::center_offset));
    row("  normal angle, root … tip", "τ", "°", [i](const RackOfArcs& r) {
      if (i >= r.arcs.size()) return none();
      return fixed(r.arcs[i].begin.deg(), kRackDigits) + " … " +
             fixed(r.arcs[i].end.deg(), kRackDigits);
    });
  }
}

void add_tooth(TableBuilder& table, GearRows& rows) {
  table.group("Tooth");
  rows.add("Reference thickness, normal", "s_n", "mm", [](const Gear& g) {
    return length(g.arcs() ? g.arcs()->reference_thickness
                           : of_involute(g, &Reference::reference_tooth_thickness_normal));
  });
  rows.add("Allowance contained in it", "E_sn", "mm",
           [](const Gear& g) { return length(g.spec.thickness_allowance); });
  rows.add("Reference thickness, transverse", "s_t", "mm", [](const Gear& g) {
    return length(of_involute(g, &Reference::reference_tooth_thickness_transverse));
  });
  rows.add("Base thickness, transverse", "s_bt", "mm",
           [](const Gear& g) { return length(of_involute(g, &Reference::base_tooth_thickness)); });
  rows.add("Tip thickness, normal", "s_an", "mm",
           [](const Gear& g) { return length(g.tip_tooth_thickness_normal); });
  rows.add("Smallest root thickness (chord)", "", "mm",
           [](const Gear& g) { return length(neck_thickness(g)); });
  rows.add("Base pitch, normal", "p_bn", "mm",
           [](const Gear& g) { return length(of_involute(g, &Reference::base_pitch_normal)); });
  rows.add("Base pitch, transverse", "p_bt", "mm",
           [](const Gear& g) { return length(of_involute(g, &Reference::base_pitch_transverse)); });
  rows.add("Undercut", "", "", [](const Gear& g) {
    return std::string(g.internal() ? kNoValue : g.undercut ? "yes" : "no");
  });
  rows.add("Least profile shift without undercut", "x_Emin", "", [](const Gear& g) {
    const auto x = of_involute(g, &InvoluteTeeth::undercut_free_profile_shift);
    return g.internal() || !x ? none() : ratio(*x);
  });
  if (rows.any([](const Gear& g) { return g.arcs() != nullptr; })) {
    rows.add("Flank begins at the rack’s normal angle", "τ", "°",
             [](const Gear& g) { return g.arcs() ? angle(g.arcs()->flank_begin.rad()) : none(); });
    rows.add("Undercut limit of it", "", "°", [](const Gear& g) {
      return g.arcs() && g.arcs()->undercut_limit ? angle(g.arcs()->undercut_limit->rad()) : none();
    });
  }
}

void add_cutter(TableBuilder& table, GearRows& rows) {
  if (!rows.any([](const Gear& g) { return g.cut_by.has_value(); })) return;
  table.group("Cut by a pinion cutter");
  rows.add("Teeth of the cutter", "z_0", "", [](const Gear& g) {
    return g.cut_by ? fmt::format("{}", g.cut_by->cutter_teeth) : none();
  });
  rows.add("Generating centre distance", "E", "mm",
           [](const Gear& g) { return g.cut_by ? length(g.cut_by->distance) : none(); });
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
  rows.add("Normal pressure angle", "α_n", "°", [](const Gear& g) {
    return g.involute() ? angle(g.spec.normal_pressure_angle.rad()) : none();
  });
  rows.add("Helix angle", "β", "°", [](const Gear& g) { return angle(g.spec.helix_angle.rad()); });
  rows.add("Hand of helix", "", "", [](const Gear& g) { return std::string(hand(g)); });
  rows.add("Lead", "p_z", "mm",
           [](const Gear& g) { return g.lead == 0.0 ? none() : length(g.lead); });
  rows.add("Profile shift", "x", "",
           [](const Gear& g) { return g.involute() ? ratio(g.spec.profile_shift) : none(); });
  rows.add("Profile shift as cut, with allowance", "x_E", "", [](const Gear& g) {
    return ratio(of_involute(g, &Reference::generating_profile_shift));
  });
  rows.add("Face width", "b", "mm", [](const Gear& g) { return length(g.spec.face_width); });
  rows.add("Transverse module", "m_t", "mm",
           [](const Gear& g) { return fixed(g.transverse_module, 5); });
  rows.add("Transverse pressure angle", "α_t", "°", [](const Gear& g) {
    return angle(of_involute(g, &Reference::transverse_pressure_angle));
  });
  rows.add("Base helix angle", "β_b", "°",
           [](const Gear& g) { return angle(of_involute(g, &Reference::base_helix_angle)); });

  table.group("Diameters");
  rows.add("Tip", "d_a", "mm", [](const Gear& g) { return length(g.tip_diameter); });
  if (rows.any([](const Gear& g) { return 2 * g.actual_tip_radius() != g.tip_diameter; })) {
    rows.add("Tip, as the tooth really ends", "", "mm",
             [](const Gear& g) { return g.exists() ? length(2 * g.actual_tip_radius()) : none(); });
  }
  rows.add("Tip form, end of the usable flank", "d_Fa", "mm",
           [](const Gear& g) { return length(tip_form_diameter(g)); });
  rows.add("Reference", "d", "mm", [](const Gear& g) { return length(g.reference_diameter); });
  rows.add("Base", "d_b", "mm",
           [](const Gear& g) { return length(of_involute(g, &Reference::base_diameter)); });
  rows.add("Root form, start of the usable flank", "d_Ff", "mm", [](const Gear& g) {
    return g.exists() ? length(diameter(g.root_form_radius())) : none();
  });
  rows.add("Root", "d_f", "mm", [](const Gear& g) { return length(g.root_diameter); });
  rows.add("Where the flanks meet (point)", "", "mm",
           [](const Gear& g) { return length(g.pointed_diameter); });
  add_tooth(table, rows);
  add_rack(table, rows);
  add_arcs(table, gears);
  add_cutter(table, rows);
  return table.str();
}

}  // namespace gearwright
