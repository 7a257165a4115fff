#include "gearwright/catalogue/search_quantities.hpp"

#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"
#include "gearwright/design/design_objectives.hpp"

namespace gearwright {

double tidy_degrees(Angle angle) {
  constexpr double kPlaces = 1e9;      // for nine decimals of a degree, as in usual input
  constexpr double kRounding = 1e-13;  // relative error of the conversion to radians and back
  const double value = angle.deg();
  const double tidy = std::round(value * kPlaces) / kPlaces;
  return std::abs(value - tidy) < kRounding * (1.0 + std::abs(value)) ? tidy : value;
}

namespace {

constexpr unsigned kColumns = 0;  // for quantities in CSV and Parquet only
constexpr int kFewDigits = 3;     // decimals of most quantities in the table of the page

bool is_crossed(const DesignView& v) { return v.problem->crossed(); }
bool is_parallel(const DesignView& v) { return !is_crossed(v); }

Value objective_value(const DesignView& v, Objective o) {
  const auto c = cost(*v.problem, *v.row, o);
  return c ? Value(seeks_greatest(o) ? -*c : *c) : Value();
}

Value objective(const DesignView& v) {
  const auto& objectives = v.problem->objectives;
  if (objectives.size() == 1) return objective_value(v, objectives.front());
  ValueMap all;
  for (const Objective o : objectives)
    all.emplace_back(kObjectiveNames[static_cast<std::size_t>(o)], objective_value(v, o));
  return all;
}

const Quantities<DesignView>& region_quantities() {
  return define("search.designs region", [](Quantities<DesignView>& q) {
    q.add(Type::map, "edges", "edges of the region", "",
          "edges in counter-clockwise order, each {constraint, points}; a straight edge has two "
          "points (x1, x2), and a curved edge has 25 or more",
          [](const DesignView& v) { return v.edges(); })
        .list({0})
        .when([](const DesignView& v) { return static_cast<bool>(v.edges); });
    q.number("lo", "middle of the region at the least Σx", "", "[x1, x2]", [](const DesignView& v) {
       return v.row->lo;
     }).column("lo_x#");
    q.number("hi", "middle of the region at the greatest Σx", "", "[x1, x2]",
             [](const DesignView& v) { return v.row->hi; })
        .column("hi_x#");
    q.term("area", "modules²", [](const DesignView& v) { return v.row->area; }).column("area");
    q.number("shift_sum", "sums of the profile shifts", "Σx", "[least, greatest]",
             [](const DesignView& v) { return v.row->sums; })
        .ends()
        .column("shift_sum_#");
  });
}

void add_numbers(Quantities<DesignView>& q) {
  q.add(Type::index, "trial", "number of the trial", "", "in the order of the search",
        [](const DesignView& v) { return v.row->trial.index; })
      .column("trial")
      .doors(kJson);
  const auto by_pitch = [](const DesignView& v) { return v.problem->by_pitch; };
  q.term("module_mm", "", [](const DesignView& v) { return v.row->trial.module; })
      .column("module_mm")
      .digits(3)
      .shown([](const DesignView& v) { return !v.problem->by_pitch; });
  q.term(
       "normal_diametral_pitch_per_in", "25.4 mm/m_n; only with `diametral_pitches_per_in`",
       [](const DesignView& v) { return without_rounding_error(kMmPerInch / v.row->trial.module); })
      .digits(3)
      .when(by_pitch);
  q.term("teeth", "[z1, z2]; negative for an internal gear",
         [](const DesignView& v) {
           return std::array{v.row->trial.z1, v.row->trial.z2};
         })
      .per_gear()
      .column("z#");
  q.term("helix_angle_deg", "> 0 right hand",
         [](const DesignView& v) {
           const auto& helix = v.row->trial.helix;
           return std::array{tidy_degrees(helix[0]), tidy_degrees(helix[1])};
         })
      .per_gear()
      .column("helix#_deg")
      .digits(kFewDigits)
      .shown([](const DesignView& v) { return is_crossed(v) || v.row->trial.helix[0] != Angle(); });
  q.term("rack", "position of the rack in the list of racks, from 1; absent if there is one rack",
         [](const DesignView& v) { return v.row->trial.rack + 1; })
      .column("rack")
      .when([](const DesignView& v) { return v.problem->racks.size() > 1; });
}

void add_place(Quantities<DesignView>& q) {
  q.term("profile_shift", "[x1, x2]", [](const DesignView& v) { return v.row->shift; })
      .per_gear()
      .column("x#")
      .digits(4);
  q.word("point", "position of the profile shifts in the region",
         "`eq11` is a point on the line of balanced strength [T2.18a], away from the borders of "
         "the region; `lo_hi` is a point in the middle of the region, used if the line does not "
         "cross the region",
         [](const DesignView& v) { return v.row->balanced ? "eq11" : "lo_hi"; })
      .one_of({"eq11", "lo_hi"})
      .column("point")
      .greater_first();
  q.term("center_distance_mm", "centre distance of the design as mounted", [](const DesignView& v) {
     return v.row->center_distance;
   }).column("center_distance_mm");
  q.number("ratio", "gear ratio", "u", "z2/z1", [](const DesignView& v) { return v.row->ratio; })
      .column("ratio")
      .digits(4);
  q.number("ratio_error", "gear ratio minus its target", "Δu", "the target is `target_ratio`",
           [](const DesignView& v) { return v.row->ratio - v.problem->target_ratio; })
      .digits(4);
}

void add_design_contact(Quantities<DesignView>& q) {
  q.number("contact_ratio", "transverse contact ratio", "ε_α",
           "between the tips, by Eq. 10 of [T2.19]; for crossed axes, AE/p_bn",
           [](const DesignView& v) { return v.row->contact_ratio; })
      .column("contact_ratio")
      .greater_first()
      .digits(kFewDigits);
  q.number("contact_ratio_true", "effective transverse contact ratio", "ε_α,eff",
           "for the part of the path on the usable flanks, which begin at ρ_F of [T9.1]; for "
           "crossed gears, the limits of the faces are ignored",
           [](const DesignView& v) { return v.row->contact_ratio_true; })
      .column("contact_ratio_true")
      .greater_first()
      .digits(kFewDigits);
  q.term("overlap_ratio", "0 on crossed axes",
         [](const DesignView& v) { return v.row->overlap_ratio; })
      .column("overlap_ratio")
      .greater_first()
      .digits(kFewDigits)
      .shown([](const DesignView& v) { return is_parallel(v) && v.row->overlap_ratio != 0.0; });
  const auto angle = [](const DesignView& v) { return tidy_degrees(v.row->working_angle); };
  q.term("working_normal_pressure_angle_deg", "crossed axes only", angle)
      .when(is_crossed)
      .digits(kFewDigits);
  q.term("working_transverse_pressure_angle_deg", "parallel axes only", angle)
      .when(is_parallel)
      .digits(kFewDigits);
  q.number("working_angle_deg", "working pressure angle", "",
           "in the transverse section, or for crossed axes in the normal section", angle)
      .column("working_angle_deg")
      .doors(kColumns);
}

void add_limits(Quantities<DesignView>& q) {
  q.number("backlash_normal_mm", "normal backlash, shortest distance of the flanks", "j_bn",
           "`backlash.normal_base_mm` of the pair",
           [](const DesignView& v) { return v.row->backlash_normal; })
      .column("backlash_normal_mm");
  q.term("backlash_mm",
         "[least, greatest] at the ends of the tolerances; only for designs with thickness "
         "allowances or with a tolerance of the centre distance",
         [](const DesignView& v) { return v.row->backlash_ends; })
      .ends()
      .column("backlash_#_mm")
      .when([](const DesignView& v) {
        return v.problem->allowances.thin_teeth() || v.problem->allowances.distance_tolerance;
      })
      .digits(kFewDigits);
  q.number("tip_thickness_mm", "normal tip tooth thickness", "s_an", "per gear",
           [](const DesignView& v) { return v.row->tip_thickness; })
      .per_gear()
      .column("tip_thickness#_mm")
      .greater_first()
      .digits(kFewDigits);
  q.term("tip_clearance_mm", "per gear, from its tip to the root of the mating gear",
         [](const DesignView& v) { return v.row->tip_clearance; })
      .per_gear()
      .column("tip_clearance#_mm")
      .greater_first()
      .digits(kFewDigits);
  q.number("form_clearance_path_mm", "form clearance along the line of action", "",
           "per gear, distance from the start of its flank to the tip of the mating gear; negative "
           "for interference; null for an internal gear, because the start of its flank depends on "
           "the cutter",
           [](const DesignView& v) { return v.row->form_clearance; })
      .per_gear()
      .column("form_clearance_path#_mm")
      .doors(kJson);
  q.number("tip_alteration_mm", "tip alteration", "k m_n",
           "applied tip alteration; 0 without `shorten_tips`",
           [](const DesignView& v) { return v.row->tip_alteration; })
      .column("tip_alteration_mm")
      .shown([](const DesignView& v) { return v.row->tip_alteration != 0.0; });
  q.record<two_gears>("specific_sliding", "[at A, at E], for the path between the tips",
                      [](const DesignView& v) {
                        return two_gears().of({v.row->sliding[0], v.row->sliding[1]});
                      })
      .doors(kJson);
  for (const std::size_t gear : {0, 1}) {
    for (const std::size_t end : {0, 1}) {
      const std::string name = "sliding" + std::to_string(gear + 1) + (end == 0 ? "_A" : "_E");
      q.number(name.c_str(), "specific sliding", "ζ", "",
               [gear, end](const DesignView& v) { return v.row->sliding[gear][end]; })
          .column(name)
          .doors(kColumns);
    }
  }
  q.number("sliding_max", "maximum specific sliding", "ζ_max",
           "at the ends of the path of contact; null if a flank reaches its base tangent point",
           [](const DesignView& v) { return v.row->max_sliding(); })
      .column("sliding_max")
      .doors(kPage)
      .expected([](const DesignView&) { return true; })
      .digits(kFewDigits);
  q.flag("interference", "interference",
         "true if a tip passes the start of the flank of the mating gear",
         [](const DesignView& v) { return v.row->interference; })
      .column("interference")
      .shown([](const DesignView& v) { return v.row->interference; });
}

void add_strength(Quantities<DesignView>& q) {
  const auto rated = [](const DesignView& v) { return v.problem->rating.has_value(); };
  q.term("S_H", "as computed by the verb `rate`; only for a rated search",
         [](const DesignView& v) { return v.row->flank_safety; })
      .per_gear()
      .column("S_H#")
      .when(rated)
      .greater_first()
      .digits(kFewDigits);
  q.term("S_F", "as computed by the verb `rate`; only for a rated search",
         [](const DesignView& v) { return v.row->root_safety; })
      .per_gear()
      .column("S_F#")
      .when(rated)
      .greater_first()
      .digits(kFewDigits);
  const auto weighed = [](const DesignView& v) { return v.problem->weighs(); };
  const auto wide = [](const DesignView& v) {
    return v.problem->weighs() || v.problem->has_face_band() || !v.problem->choices.empty();
  };
  q.term("face_width_mm",
         "common width of both gears; only if the search computes safety factors or masses, has a "
         "band of face widths, or requires whole overlap ratios",
         [wide](const DesignView& v) { return wide(v) ? Value(v.row->face_width) : Value(); })
      .column("face_width_mm")
      .when(wide)
      .digits(kFewDigits);
  q.number("mass_kg", "mass of both gears", "m",
           "mass of solid cylinders with the mean diameter (d_a + d_f)/2; for an internal gear, "
           "the mass of the ring between the mean diameter and the diameter d_f + 5 m_n; only for "
           "a rated search or with `objective` = `mass` or `cost`",
           [](const DesignView& v) { return v.problem->weighs() ? Value(v.row->mass) : Value(); })
      .column("mass_kg")
      .when(weighed)
      .digits(kFewDigits);
}

void add_ranks(Quantities<DesignView>& q) {
  q.term("efficiency",
         "efficiency with gear 1 driving, if flank friction is the only loss [T4.27]; only with "
         "`friction_coefficient` or `objective` = `efficiency`; null if the contact ratio is less "
         "than 1 or gear 1 cannot drive",
         [](const DesignView& v) { return v.row->efficiency; })
      .column("efficiency")
      .when([](const DesignView& v) { return v.problem->flank_friction().has_value(); })
      .greater_first()
      .digits(5);
  q.number(
       "balance", "balance of the load reserves", "R_max/R_min",
       "greatest load reserve divided by the least; the reserves are (S_H/S_Hmin)² for the flanks "
       "and S_F/S_Fmin for the root of each gear [T9.17]; only with `objective` = `balance`",
       [](const DesignView& v) { return load_balance(*v.problem, *v.row); })
      .column("balance")
      .when([](const DesignView& v) { return v.problem->ranks_by(Objective::balance); })
      .digits(kFewDigits);
  q.number("relative_cost", "relative cost", "",
           "mass in kg times (b/d_1)^`cost_exponent` [T9.18], for comparisons of designs of one "
           "kind; only with `objective` = `cost`",
           [](const DesignView& v) { return relative_cost(*v.problem, *v.row); })
      .or_null()
      .column("relative_cost")
      .when([](const DesignView& v) { return v.problem->ranks_by(Objective::cost); })
      .digits(kFewDigits);
  q.number("noise_um", "estimated transmission error under load, peak to peak", "δ_pp",
           "variation of the deflection of perfect teeth under the torque of `[rating]`; every mm "
           "of contact line is assumed to have the same stiffness [T9.16]; 0 if a contact ratio "
           "ε_α or ε_β is a whole number; only with `objective` = `noise`",
           [](const DesignView& v) { return v.row->noise; })
      .column("noise_um")
      .when([](const DesignView& v) { return v.problem->ranks_by(Objective::noise); })
      .digits(kFewDigits);
  q.number("loaded_noise_um", "loaded transmission error, peak to peak", "δ_load",
           "along the line of action, as computed by the verb `load` for the spec of the design, "
           "under the torque of `[load]` (the greatest value of several torques) or of `[rating]`; "
           "null for all designs except the first `loaded_designs`, and if a position has no "
           "result; only with `objective` = `noise`",
           [](const DesignView& v) { return v.row->loaded_noise; })
      .column("loaded_noise_um")
      .when([](const DesignView& v) { return v.problem->loads_designs(); })
      .digits(kFewDigits);
}

void add_design(Quantities<DesignView>& q) {
  add_numbers(q);
  add_place(q);
  add_design_contact(q);
  add_limits(q);
  add_strength(q);
  add_ranks(q);
  q.term("area", "modules²", [](const DesignView& v) { return v.row->area; })
      .doors(kPage)
      .greater_first()
      .digits(4)
      // If the centre distance is exact, the region is a line and has no area.
      .shown([](const DesignView& v) { return v.row->area > 0.0; });
  q.record<region_quantities>("region", "profile shifts that satisfy every limit").doors(kJson);
  q.add(Type::map, "objective", "objective", "",
        "value of the objective, or one value for each of several objectives", objective)
      .doors(kJson);
}

void add_point(Quantities<ShiftPoint>& q) {
  using P = ShiftPoint;
  const auto column = [&q](const char* name, Type type, auto get) -> QuantityEntry<P> {
    return q.add(type, name, name, "", "", get).column(name).doors(kColumns);
  };
  column("trial", Type::index, &P::trial);
  column("x#", Type::number, &P::shift).per_gear();
  column("center_distance_mm", Type::number, &P::center_distance);
  column("working_angle_deg", Type::number,
         [](const P& p) { return tidy_degrees(p.working_angle); });
  column("contact_ratio", Type::number, &P::contact_ratio);
  column("contact_ratio_true", Type::number, &P::contact_ratio_true);
  column("sliding_max", Type::number, &P::sliding);
  column("tip_thickness#_mm", Type::number, &P::tip_thickness).per_gear();
  column("tip_clearance#_mm", Type::number, &P::tip_clearance).per_gear();
  column("backlash_normal_mm", Type::number, &P::backlash_normal);
  column("interference", Type::flag, &P::interference);
}

}  // namespace

const Quantities<DesignView>& design_quantities() { return define<add_design>("search.designs"); }

const Quantities<ShiftPoint>& point_quantities() { return define<add_point>("search.points"); }

}  // namespace gearwright
