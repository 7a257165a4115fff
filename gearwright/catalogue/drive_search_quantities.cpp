#include <algorithm>
#include <cmath>

#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/drive/drive_rating.hpp"

namespace gearwright {

namespace {

using F = FoundDrive;

// Returns the value that the result of the verb `drive` has for this key.
Value of_drive(const F& f, std::string_view key,
               const Quantities<Drive>& quantities = drive_quantities()) {
  for (const Quantity& q : quantities.list())
    if (q.info.key == key) return quantities.value(q, f.drive);
  return {};
}

Value of_set(const F& f, const Quantities<PlanetSet>& quantities, std::string_view key) {
  if (f.drive.sets.empty()) return {};
  for (const Quantity& q : quantities.list())
    if (q.info.key == key) return quantities.value(q, f.drive.sets.front());
  return {};
}

// True if the search has a module. Without a module, the drive has no geometry.
bool has_module(const F& f) { return f.drive.geometry.gears.front().has_value(); }

Value teeth_of(const F& f) {
  ValueMap map;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (f.candidate.teeth[m] > 0)
      map.emplace_back(to_string(static_cast<SetMember>(m)),
                       static_cast<long long>(f.candidate.teeth[m]));
  return map.empty() ? Value() : Value(std::move(map));
}

Value stages_of(const F& f) {
  if (f.candidate.stages.empty()) return {};
  ValueList list;
  for (const auto& [z1, z2] : f.candidate.stages)
    list.emplace_back(
        ValueList{Value(static_cast<long long>(z1)), Value(static_cast<long long>(z2))});
  return list;
}

void add_found(Quantities<F>& q) {
  q.add(Type::map, "teeth", "numbers of teeth", "z", "numbers of teeth by member; null for a train",
        teeth_of)
      .doors(kJson);
  q.whole("stages", "numbers of teeth of the stages", "z", "[z1, z2] of each stage; null for a set",
          stages_of)
      .list({0, 2})
      .doors(kJson);
  q.whole("planets", "number of planets", "N", "null for a train", [](const F& f) {
    return f.candidate.stages.empty() ? Value(static_cast<long long>(f.candidate.planets))
                                      : Value();
  });
  q.term("ratio", "n_in/n_out", [](const F& f) { return of_drive(f, "ratio"); }).always();
  q.term("ratio_exact", "[p, q] in lowest terms",
         [](const F& f) { return of_drive(f, "ratio_exact"); })
      .fraction()
      .doors(kJson);
  q.term("efficiency", "efficiency with the input driving",
         [](const F& f) { return of_drive(f, "efficiency"); });
  q.term("efficiency_backward", "0 if the output cannot drive the input",
         [](const F& f) { return of_drive(f, "efficiency_backward"); });
  q.number("noise", "variation of the elastic rotation", "ΔΘ/Θ",
           "relative variation, peak to peak, of the elastic rotation of the output under load "
           "[T13.33], for perfect teeth with a constant stiffness per length of the contact line. "
           "Without a module, the profile shifts are assumed to be 0 and the face widths 10 m_n. "
           "This value is given only with `objective` = `noise`",
           [](const F& f) { return f.candidate.noise; });
  q.number("size_mm", "size", "",
           "greatest diameter of the set, measured over the planets, over the suns and over the "
           "root circles of the rings, without profile shifts and without the rims of the rings; "
           "for a train, sum "
           "of the centre distances; null without a module",
           [](const F& f) { return has_module(f) ? Value(f.candidate.size) : Value(); });
  q.number("size_modules", "size in modules", "",
           "the size of a drive of module 1; null if a module is given",
           [](const F& f) { return has_module(f) ? Value() : Value(f.candidate.size); });
  q.number("mass_kg", "mass", "m",
           "mass of all gears with all planets, as solid cylinders with the mean diameter (d_a + "
           "d_f)/2; a ring extends from the mean diameter to the diameter d_f + 5 m_n; only with "
           "`objective` = `mass`",
           [](const F& f) { return f.candidate.mass; });
  q.term("center_distance_mm", "centre distance of the meshes of the set",
         [](const F& f) { return of_drive(f, "center_distance_mm"); });
  q.number("stage_center_distances_mm", "centre distances of the stages", "a",
           "centre distance of each stage of a train; null for a set, or without geometry",
           [](const F& f) {
             ValueList list;
             if (f.candidate.stages.empty()) return Value();
             for (const auto& a : f.drive.geometry.distance) {
               if (!a) return Value();
               list.emplace_back(*a);
             }
             return Value(list);
           })
      .list({0});
  q.add(Type::map, "profile_shift", "profile shifts", "x", "per gear; null without geometry",
        [](const F& f) { return of_drive(f, "profile_shift", coaxial_quantities()); })
      .doors(kJson);
  q.term("positions", "number of positions in a turn at which a planet can be assembled",
         [](const F& f) { return of_set(f, assembly_quantities(), "positions"); });
  q.term("equal", "true if the planets are at equal pitch",
         [](const F& f) { return of_set(f, assembly_quantities(), "equal"); });
  q.term("neighbour_clearance_mm", "least distance of the tip circles of neighbouring planets",
         [](const F& f) { return of_set(f, assembly_quantities(), "neighbour_clearance_mm"); });
  q.word("phasing", "class of phasing", "for the first harmonic", [](const F& f) {
     return of_set(f, phasing_quantities(), "class");
   }).one_of({"in_phase", "sequential", "counter", "mixed"});
  q.term("normal_module_mm",
         "normal module of all meshes; null without geometry, or if the stages of a train have "
         "different modules",
         [](const F& f) {
           return has_module(f) && f.candidate.has_one_module() ? Value(f.candidate.stage_module(0))
                                                                : Value();
         });
  q.number("stage_modules_mm", "normal modules of the stages", "m_n",
           "normal module of each stage of a train; null if all stages have the same module",
           [](const F& f) {
             ValueList list;
             if (f.candidate.has_one_module()) return Value();
             for (const double m : f.candidate.stage_modules) list.emplace_back(m);
             return Value(list);
           })
      .list({0});
  q.number("face_width_mm", "greatest face width", "b",
           "null if the search does not choose the face widths", [](const F& f) {
             const auto& widths = f.candidate.face_widths;
             return widths.empty() ? Value()
                                   : Value(*std::max_element(widths.begin(), widths.end()));
           });
  q.add(Type::map, "face_widths_mm", "face widths", "b",
        "per gear; null if the search does not choose the face widths",
        [](const F& f) {
          ValueMap map;
          if (f.candidate.face_widths.empty()) return Value();
          for (std::size_t g = 0; g < f.drive.graph.gears.size(); ++g)
            map.emplace_back(f.drive.graph.gears[g].name,
                             f.drive.geometry.gears[g]->spec.face_width);
          return Value(std::move(map));
        })
      .doors(kJson);
  q.number("sliding_max", "greatest specific sliding", "|ζ|",
           "greatest magnitude at the ends of the paths of contact of all meshes; null without "
           "geometry, or if a path of contact ends at a base circle",
           [](const F& f) {
             const auto zeta = greatest_sliding(f.drive.geometry);
             return zeta && std::isfinite(*zeta) ? Value(*zeta) : Value();
           });
  q.number("safety_flank", "safety against pitting", "S_H",
           "least value of all meshes; null if designs are not rated",
           [](const F& f) { return least_safety(f.drive, &Rating::S_H); });
  q.number("safety_root", "safety against root breakage", "S_F",
           "least value of all meshes; null if designs are not rated",
           [](const F& f) { return least_safety(f.drive, &Rating::S_F); });
}

template <std::size_t N, class T>
ValueMap counts(const std::array<std::string_view, N>& names, const std::array<T, N>& numbers) {
  ValueMap map;
  for (std::size_t i = 0; i < N; ++i)
    map.emplace_back(std::string(names[i]), static_cast<long long>(numbers[i]));
  return map;
}

void add_drive_search(Quantities<FoundDrives>& q) {
  using S = FoundDrives;
  q.word("kind", "kind", "kind of the drives",
         [](const S& s) { return kDriveKindNames[static_cast<std::size_t>(s.problem.kind)]; });
  q.term("tested",
         "number of tested sets; sets that differ only in the number of planets are counted "
         "separately",
         [](const S& s) { return s.result.tested; });
  q.add(Type::index, "feasible_count", "feasible", "", "number of sets that satisfy all limits",
        [](const S& s) { return s.result.found.size(); });
  q.add(Type::map, "rejected", "rejected", "",
        "number of sets that each limit ruled out; a set counts for the first limit that rules it "
        "out, in the order `ratio`, `assembly`, `neighbours`, `phasing`, `size`",
        [](const S& s) { return counts(kDriveLimitNames, s.result.rejected); })
      .doors(kJson);
  q.add(Type::index, "computed", "computed", "",
        "number of feasible sets whose teeth were computed; the best sets are computed first, "
        "until `designs` has as many drives as `--top` gives",
        [](const S& s) { return s.designs.computed; });
  q.add(Type::index, "hopeless", "hopeless", "",
        "number of feasible trains that were not computed, because an estimate from 64 rated "
        "trains of the same module shows that these trains cannot have the required safeties or, "
        "if each stage has its own module, that they would be larger than allowed",
        [](const S& s) { return s.designs.hopeless; });
  q.add(Type::index, "beyond_limit", "not computed", "",
        "number of feasible sets that were not computed, because at most 20 000 sets of each "
        "module are computed; trains in `hopeless` are not counted; 0 if `designs` has at least as "
        "many drives as `--top` gives",
        [](const S& s) { return s.designs.beyond_limit; });
  q.add(Type::map, "left_out", "not listed", "",
        "number of computed sets that are not listed: `no_teeth` (teeth that cannot be made or "
        "mounted), `neighbours` (planets too close to each other with their profile shifts), "
        "`sliding`, `overlap`, `safety`, `verdict` (amber or red)",
        [](const S& s) { return counts(kDriveFaultNames, s.designs.left_out); })
      .doors(kJson);
  q.term("face_load_factor",
         "default of rated searches; only if `[rating]` has no `face_load_factor`",
         [](const S& s) { return s.default_face_load; })
      .when([](const S& s) { return s.default_face_load.has_value(); });
  q.term("pareto",
         "positions of the Pareto-optimal designs in `designs`; only with several objectives",
         [](const S& s) { return s.designs.pareto; })
      .doors(kJson);
  q.record<found_drive_quantities>(
       "designs",
       "drives with a green verdict, at most as many as `--top` gives, the best drive first. If "
       "only an estimate of the order is known before the teeth are computed, each group of 100 "
       "drives is sorted separately. If there are several objectives, further drives of the Pareto "
       "front follow. The numbers of a drive equal the results of the verb `drive`",
       [](const S& s) -> const auto& { return s.designs.list; })
      .doors(kJson);
}

}  // namespace

const Quantities<FoundDrive>& found_drive_quantities() { return define<add_found>("search.drive"); }

const Quantities<FoundDrives>& drive_search_quantities() {
  return define<add_drive_search>("search.drives");
}

}  // namespace gearwright
