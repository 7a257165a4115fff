#include "gearwright/job/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

// Display width of UTF-8 text: bytes that do not continue a character.
std::size_t width(const std::string& s) {
  std::size_t n = 0;
  for (unsigned char c : s) n += (c & 0xC0) != 0x80;
  return n;
}

std::string pad(const std::string& s, std::size_t n) {
  return s + std::string(width(s) < n ? n - width(s) : 0, ' ');
}

std::string pad_left(const std::string& s, std::size_t n) {
  return std::string(width(s) < n ? n - width(s) : 0, ' ') + s;
}

// Four decimals; what rounds to nothing has no sign.
std::string mm(double v) { return fmt::format("{:.4f}", std::abs(v) < 0.5e-4 ? 0.0 : v); }
std::string angle(const std::optional<double>& rad) {
  if (!rad) return "-";
  return fmt::format("{:.5f}", std::abs(deg(*rad)) < 0.5e-5 ? 0.0 : deg(*rad));
}
std::string angle(Angle value) { return angle(value.rad()); }
std::string maybe(const std::optional<double>& v, double factor = 1.0) {
  return v ? mm(factor * *v) : "-";
}

class Table {
 public:
  void head(const std::string& text) { out_ += "\n" + text + "\n"; }
  void row(const std::string& what, const std::string& symbol,
           const std::vector<std::string>& values, const char* unit) {
    std::string line = "  " + pad(what, 38) + pad(symbol, 7);
    for (const std::string& v : values) line += pad_left(v, 14);
    line += std::string("  ") + unit;
    while (!line.empty() && line.back() == ' ') line.pop_back();
    out_ += line + "\n";
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

}  // namespace

std::string gear_listing(const SolvedJob& job) {
  using Reference = ReferenceGeometry<double>;
  Table t;
  if (!job.spec.title.empty()) t.head(job.spec.title);
  std::vector<std::string> heads;
  for (std::size_t i = 0; i < job.gears.size(); ++i)
    heads.push_back(fmt::format("gear {}", i + 1));
  t.row("", "", heads, "");
  const auto is_involute = [](const Gear& g) { return g.involute() != nullptr; };
  const auto each = [&](const char* what, const char* symbol, const char* unit,
                        const std::function<std::string(const Gear&)>& value) {
    std::vector<std::string> values;
    for (const Gear& g : job.gears) values.push_back(value(g));
    const bool none = std::all_of(values.begin(), values.end(), [](auto& v) { return v == "-"; });
    if (none && std::none_of(job.gears.begin(), job.gears.end(), is_involute)) return;
    t.row(what, symbol, values, unit);
  };
  each("teeth", "z", "", [](const Gear& g) { return fmt::format("{}", g.spec.teeth); });
  each("normal module", "m_n", "mm", [](const Gear& g) { return mm(g.spec.normal_module); });
  each("normal pressure angle", "α_n", "°",
       [](const Gear& g) { return g.arcs() ? "-" : angle(g.spec.normal_pressure_angle.rad()); });
  each("transverse pressure angle", "α_t", "°",
       [](const Gear& g) { return angle(of_involute(g, &Reference::transverse_pressure_angle)); });
  each("helix angle (+ right hand)", "β", "°",
       [](const Gear& g) { return angle(g.spec.helix_angle.rad()); });
  each("base helix angle", "β_b", "°",
       [](const Gear& g) { return angle(of_involute(g, &Reference::base_helix_angle)); });
  each("profile shift", "x", "",
       [](const Gear& g) { return g.arcs() ? "-" : fmt::format("{:.5f}", g.spec.profile_shift); });
  each("face width", "b", "mm", [](const Gear& g) { return mm(g.spec.face_width); });
  each("lead", "p_z", "mm",
       [](const Gear& g) { return g.lead == 0.0 ? std::string("-") : mm(g.lead); });
  each("reference diameter", "d", "mm", [](const Gear& g) { return mm(g.reference_diameter); });
  each("base diameter", "d_b", "mm",
       [](const Gear& g) { return maybe(of_involute(g, &Reference::base_diameter)); });
  each("tip diameter", "d_a", "mm", [](const Gear& g) { return mm(g.tip_diameter); });
  each("tip form diameter", "d_Fa", "mm",
       [](const Gear& g) { return g.exists() ? mm(2 * g.tip_form_radius()) : "-"; });
  each("root form diameter", "d_Ff", "mm",
       [](const Gear& g) { return maybe(g.root_form_radius(), 2.0); });
  each("root diameter", "d_f", "mm", [](const Gear& g) { return mm(g.root_diameter); });
  each("pointed diameter", "", "mm", [](const Gear& g) { return maybe(g.pointed_diameter); });
  each("normal thickness at d", "s_n", "mm", [](const Gear& g) {
    return g.arcs() ? maybe(g.arcs()->reference_thickness)
                    : maybe(of_involute(g, &Reference::reference_tooth_thickness_normal));
  });
  each("transverse thickness at d_b", "s_bt", "mm",
       [](const Gear& g) { return maybe(of_involute(g, &Reference::base_tooth_thickness)); });
  each("normal thickness at the tip", "s_an", "mm",
       [](const Gear& g) { return maybe(g.tip_tooth_thickness_normal); });
  const auto any = [&](const auto& has) {
    return std::any_of(job.gears.begin(), job.gears.end(), has);
  };
  const auto fillet = [&](const char* what, const char* symbol,
                          std::optional<FilletArc> GeneratedTooth::*arc) {
    if (!any([&](const Gear& g) { return g.tooth && (*g.tooth).*arc; })) return;
    const auto of = [arc](const Gear& g) {
      return g.tooth ? (*g.tooth).*arc : std::optional<FilletArc>();
    };
    each(fmt::format("{} fillet, radius", what).c_str(), symbol, "mm",
         [of](const Gear& g) { return of(g) ? mm(of(g)->radius) : std::string("-"); });
    each("  span", "σ", "°",
         [of](const Gear& g) { return of(g) ? angle(of(g)->span) : std::string("-"); });
  };
  fillet("circular root", "r_r", &GeneratedTooth::root_fillet);
  fillet("circular tip", "r_t", &GeneratedTooth::tip_fillet);
  if (any([](const Gear& g) { return of_involute(g, &InvoluteTeeth::undercut_l) > 0.0; })) {
    each("undercut limit along the rack's flank", "l_F", "mm",
         [](const Gear& g) { return maybe(of_involute(g, &InvoluteTeeth::undercut_l)); });
  }
  each("shift without undercut, at least", "", "", [](const Gear& g) {
    const auto x = of_involute(g, &InvoluteTeeth::undercut_free_profile_shift);
    return g.internal() || !x ? std::string("-") : fmt::format("{:.5f}", *x);
  });
  if (any([](const Gear& g) { return g.arcs() != nullptr; })) {
    each("flank begins at the rack's angle", "", "°",
         [](const Gear& g) { return g.arcs() ? angle(g.arcs()->flank_begin.rad()) : "-"; });
    each("  undercut limit", "", "°", [](const Gear& g) {
      return g.arcs() && g.arcs()->undercut_limit ? angle(g.arcs()->undercut_limit->rad()) : "-";
    });
  }
  return t.take();
}

std::string pair_listing(const InvolutePair& p) {
  Table t;
  t.head(p.crossed()                             ? "pair on crossed axes"
         : p.kind == PairKind::parallel_external ? "external pair, parallel axes"
                                                 : "internal pair, parallel axes");
  const auto one = [&](const char* what, const char* symbol, const std::string& v,
                       const char* unit) { t.row(what, symbol, {v}, unit); };
  const auto two = [&](const char* what, const char* symbol, const std::string& v1,
                       const std::string& v2, const char* unit) {
    t.row(what, symbol, {v1, v2}, unit);
  };
  const auto number = [](double v) { return fmt::format("{:.5f}", v); };
  const auto& m = p.mesh;
  const auto& sides = m.rack.sides;
  one("gear ratio", "u", fmt::format("{:.6g}", p.gear_ratio()), "");
  if (p.crossed()) one("shaft angle", "Σ", angle(p.shaft_angle), "°");
  one("centre distance", "a", mm(p.center_distance), "mm");
  one("  reference", "a_d", mm(p.reference_center_distance), "mm");
  one("  backlash-free", "", maybe(p.backlash_free_center_distance), "mm");
  one("  extended", "", mm(p.extended_center_distance), "mm");
  one("working pressure angle, normal", "α_wn", angle(m.rack.normal_pressure_angle), "°");
  two("working pressure angle, transverse", "α_wt", angle(sides[0].transverse_angle),
      angle(sides[1].transverse_angle), "°");
  two("working helix angle", "β_w", angle(sides[0].helix_angle), angle(sides[1].helix_angle), "°");
  two("working pitch diameters", "d_w", mm(2 * sides[0].pitch_radius),
      mm(2 * sides[1].pitch_radius), "mm");
  if (p.crossed()) {
    one("distance of the pitch planes", "X", mm(m.pitch_plane_distance), "mm");
    one("contact ratio", "ε", number(p.contact_ratio()), "");
    one("  on the usable flanks and faces", "", number(p.contact_ratio_true()), "");
    one("length of the line of action", "AE", mm(p.path_length()), "mm");
    two("face width for one flank", "f", mm(p.face_widths->one_flank[0]),
        mm(p.face_widths->one_flank[1]), "mm");
    two("face width for both flanks", "f'", mm(p.face_widths->both_flanks[0]),
        mm(p.face_widths->both_flanks[1]), "mm");
  } else {
    one("transverse contact ratio", "ε_α", number(*p.transverse_contact_ratio()), "");
    one("overlap ratio", "ε_β", number(m.overlap_ratio), "");
    one("total contact ratio", "ε_γ", number(p.contact_ratio()), "");
    one("  on the usable flanks", "", number(p.contact_ratio_true()), "");
    one("  of it before the pitch point", "", number(approach_and_recess(p)[0]), "");
    one("  after it (gear 1 driving)", "", number(approach_and_recess(p)[1]), "");
    one("length of the path of contact", "g_α", mm(p.path_length()), "mm");
    if (const auto overlap = face_width_for_overlap(p)) {
      if (p.mesh.true_ratio < 1.2) {
        one("face width for a total of 1", "b", maybe(face_width_for_total(p, 1.0)), "mm");
        one("face width for a total of 1.2", "b", maybe(face_width_for_total(p, 1.2)), "mm");
      }
      one("face width for an overlap of 1", "b", mm(*overlap), "mm");
      two("axial force/tangential, along +z", "F_z/F_t", number(axial_force(p)[0]),
          number(axial_force(p)[1]), "");
    }
  }
  two("backlash: rotation, mate held", "", angle(m.backlash.rotation[0]),
      angle(m.backlash.rotation[1]), "°");
  one("  normal, along the line of action", "j_bn", mm(m.backlash.normal_base), "mm");
  one("  normal", "j_n", mm(m.backlash.normal), "mm");
  two("  circumferential", "j_wt", mm(m.backlash.circumferential[0]),
      mm(m.backlash.circumferential[1]), "mm");
  two("tip clearance", "c", mm(p.tip_clearance[0]), mm(p.tip_clearance[1]), "mm");
  two("form clearance", "c_F", maybe(p.form_clearance[0]), maybe(p.form_clearance[1]), "mm");
  if (!p.crossed())
    two("fillet clearance", "", maybe(p.fillet_clearance[0]), maybe(p.fillet_clearance[1]), "mm");
  two("specific sliding at A", "ζ", maybe(p.sliding_A.zeta_1), maybe(p.sliding_A.zeta_2), "");
  two("specific sliding at E", "ζ", maybe(p.sliding_E.zeta_1), maybe(p.sliding_E.zeta_2), "");
  if (p.efficiency) {
    const auto percent = [](const std::optional<double>& v) {
      return v ? fmt::format("{:.3f}", 100 * *v) : std::string("locks");
    };
    two("efficiency, this gear driving", "η", percent(p.efficiency->gear1_drives),
        percent(p.efficiency->gear2_drives), "%");
  }
  if (p.least_distance) {
    t.head("minimum centre distance");
    one("centre distance", "a", mm(p.least_distance->center_distance), "mm");
    one("shaft angle", "Σ", angle(p.least_distance->shaft_angle), "°");
    one("working pressure angle, normal", "α_wn", angle(p.least_distance->normal_pressure_angle),
        "°");
  }
  if (p.contact_ratio_range) {
    const CrossedPlaces& r = *p.contact_ratio_range;
    t.head("contact ratio of 1 and more, without backlash: the two ends");
    two("shaft angle", "Σ", angle(r.lo.shaft_angle), angle(r.hi.shaft_angle), "°");
    two("centre distance", "a", mm(r.lo.center_distance), mm(r.hi.center_distance), "mm");
    two("working pressure angle, normal", "α_wn", angle(r.lo.normal_pressure_angle),
        angle(r.hi.normal_pressure_angle), "°");
  }
  return t.take();
}

std::string pair_listing(const ArcPair& p) {
  Table t;
  t.head("circular-arc pair, parallel axes");
  const auto one = [&](const char* what, const char* symbol, const std::string& v,
                       const char* unit) { t.row(what, symbol, {v}, unit); };
  const auto two = [&](const char* what, const char* symbol, const std::array<double, 2>& v,
                       const char* unit) {
    t.row(what, symbol, {mm(v[0]), mm(v[1])}, unit);
  };
  one("gear ratio", "u", fmt::format("{:.6g}", p.gear_ratio()), "");
  one("centre distance", "a", mm(p.center_distance), "mm");
  one("  reference", "a_d", mm(p.reference_center_distance), "mm");
  two("working pitch diameters", "d_w", p.working_pitch_diameter(), "mm");
  one("overlap ratio", "ε_β", fmt::format("{:.5f}", p.overlap_ratio), "");
  if (p.contacts.size() > 1)
    one("contact points at a time, on average", "", fmt::format("{:.5f}", p.contact_ratio), "");
  one("face width for continuous contact", "b", mm(p.face_for_contact), "mm");
  if (p.backlash_rotation) {
    const auto& j = *p.backlash_rotation;
    t.row("backlash: rotation, mate held", "", {angle(j[0]), angle(j[1])}, "°");
    one("  normal, at the contact", "j_bn", mm(p.backlash_normal), "mm");
  }
  two("tip clearance", "c", p.tip_clearance, "mm");
  for (const ArcPairContact& c : p.contacts) {
    const ArcContact& at = c.at;
    t.head(fmt::format("contact on the convex flank of gear {}", c.convex_gear));
    one("normal angle of the racks", "θ", angle(at.theta), "°");
    t.row("point at rotation 0, housing frame", "x, y, z",
          {mm(at.point.x()), mm(at.point.y()), mm(at.point.z())}, "mm");
    const auto curvature = [](double k) { return fmt::format("{:.6f}", k); };
    t.row("relative curvatures", "k1, k2", {curvature(at.gap[0]), curvature(at.gap[1])}, "1/mm");
    one("transverse radii: concave less convex", "Δρ",
        mm(at.transverse_radius_concave - at.transverse_radius_convex), "mm");
    one("  in line contact it would be", "", mm(at.line_contact_difference), "mm");
  }
  return t.take();
}

std::string warning_listing(const std::vector<Warning>& warnings) {
  std::string out;
  for (const Warning& w : warnings) {
    out += fmt::format("{}warning: {}{}\n", out.empty() ? "\n" : "",
                       w.gear ? fmt::format("gear {}: ", w.gear) : "", w.message);
  }
  return out;
}

std::string file_listing(const std::vector<JobFile>& files) {
  std::string out = "\n";
  for (const JobFile& f : files) {
    std::string note = f.note;
    if (f.deviation_mm) note += fmt::format(", within {:.2g} µm", *f.deviation_mm * 1e3);
    out += "  " + pad(f.path.string(), 44) + "  " + pad(f.what, 14) + note + "\n";
  }
  return out;
}

std::string outline_listing(const Outline& outline, int n) {
  std::string out = "arc          x_mm                    y_mm\n";
  for (const Arc& arc : outline.arcs) {
    const std::string name(to_string(arc.name));
    for (const Vec2& p : sample(arc, n)) {
      out += pad(name, 13) + pad(fmt::format("{}", p.x()), 24) + fmt::format("{}\n", p.y());
    }
  }
  return out;
}

}  // namespace gearwright
