// The quantities of a planetary set of a drive: the positions at which its planets can be
// assembled, and the phases of its meshes.
#include "gearwright/catalogue/drive_quantities.hpp"

namespace gearwright {

namespace {

Value degrees_of(const Rational& turns) { return Value(360 * turns.value()); }

const Quantities<Resultant>& resultant_quantities() {
  using R = Resultant;
  return define("drive.phasing.resultant", [](Quantities<R>& q) {
    q.number("torque", "torque and axial force", "R_k",
             "share of harmonic k that remains in the sum over all planets [T13.18]", &R::torque);
    q.number("force_forward", "transverse force that turns with the sun", "F_k^+", "[T13.18]",
             &R::force_forward);
    q.number("force_backward", "transverse force that turns against the sun", "F_k^-", "[T13.18]",
             &R::force_backward);
  });
}

const char* phasing_words(PhasingClass kind) {
  switch (kind) {
    case PhasingClass::in_phase: return "in_phase";
    case PhasingClass::sequential: return "sequential";
    case PhasingClass::counter: return "counter";
    case PhasingClass::mixed: return "mixed";
  }
  return "";
}

template <class Show>
ValueList each(const std::vector<Rational>& list, Show show) {
  ValueList values;
  for (const Rational& r : list) values.push_back(show(r));
  return values;
}

}  // namespace

Value phase_list(const std::vector<Rational>& phases) {
  if (phases.empty()) return {};
  ValueList values;
  for (const Rational& r : phases) values.emplace_back(r.value());
  return values;
}

const Quantities<PlanetSet>& assembly_quantities() {
  using P = PlanetSet;
  return define("drive.assembly", [](Quantities<P>& q) {
    q.term("positions",
           "number of positions in a turn at which a planet can be assembled; 0 if every position "
           "is possible [T13.12]",
           [](const P& p) { return p.assembly.places; });
    q.term("equal", "true if the planets are at equal pitch",
           [](const P& p) { return p.assembly.equal; });
    q.number("angles_deg", "positions of the planets", "",
             "counter-clockwise from the first planet [T13.13]",
             [](const P& p) { return each(p.assembly.turns, degrees_of); });
    q.whole("angles_exact", "positions of the planets", "", "[p, q] in turns",
            [](const P& p) { return each(p.assembly.turns, exact_fraction); })
        .list({0, 2})
        .doors(kJson);
    q.number("clocking_deg", "clocking", "δ",
             "rotation of the second gear of each stepped planet on its shaft; null if all stepped "
             "planets are equal [T13.14]",
             [](const P& p) {
               return p.assembly.clocking.empty() ? Value()
                                                  : Value(each(p.assembly.clocking, degrees_of));
             })
        .list({0});
    q.whole("planets_max", "greatest number of planets", "", "at equal pitch [T13.15b]",
            [](const P& p) { return p.neighbours ? Value(p.neighbours->most) : Value(); });
    q.term("neighbour_clearance_mm",
           "least distance of the tip circles of neighbouring planets [T13.15b]",
           [](const P& p) { return p.neighbours ? Value(p.neighbours->clearance) : Value(); });
  });
}

const Quantities<PlanetSet>& phasing_quantities() {
  using P = PlanetSet;
  return define("drive.phasing", [](Quantities<P>& q) {
    q.word("class", "class of phasing", "for the first harmonic [T13.19]", [](const P& p) {
       return phasing_words(p.phasing.kind);
     }).one_of({"in_phase", "sequential", "counter", "mixed"});
    q.number("sun_phase", "phases of the sun's meshes", "γ",
             "phase by which each mesh follows the first mesh, in periods [T13.16]",
             [](const P& p) { return phase_list(p.sun_phases); })
        .list({0});
    q.number("ring_phase", "phases of the ring's meshes", "γ", "as `sun_phase`", [](const P& p) {
       return phase_list(p.ring_phases);
     }).list({0});
    q.number("sun_ring_phase", "phase of the ring relative to the sun", "γ_rs",
             "at the same planet [T13.17]", &P::sun_ring_phase);
    q.record<resultant_quantities>(
         "resultants",
         "shares of harmonics 1, 2, … that remain in the sum over all planets [T13.18]",
         [](const P& p) -> const auto& { return p.phasing.resultants; })
        .doors(kJson);
  });
}

}  // namespace gearwright
