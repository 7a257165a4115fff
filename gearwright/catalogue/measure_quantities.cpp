#include "gearwright/catalogue/measure_quantities.hpp"

#include <cmath>
#include <cstdlib>

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

const Quantities<ChordView>& chord_quantities() {
  using C = ChordView;
  static const Quantities<C> kAll("measure.chordal_thickness", [](Quantities<C>& q) {
    q.mm("", "diameter_mm", "diameter of the chord", "d_y", "at which the calliper's jaws touch",
         [](const C& c) { return Value(c.diameter); })
        .always();
    q.mm("", "chord_mm", "chordal tooth thickness", "",
         "the shortest over the inclinations of the calliper [T5.6]",
         [](const C& c) { return Value(c.chord.chord); })
        .always();
    q.mm("", "height_mm", "height of the arc over the chord", "", "at that diameter",
         [](const C& c) { return Value(c.chord.height); })
        .always();
    q.mm("", "tip_to_chord_mm", "calliper setting from the tip", "",
         "from d_a; < 0 where an internal gear's chord passes its tip",
         [](const C& c) { return Value(c.chord.tip_to_chord); })
        .always();
    q.deg("", "caliper_angle_deg", "calliper to the transverse plane", "", "signed like β [T5.7]",
          [](const C& c) { return Value(deg(c.chord.caliper_angle)); })
        .always()
        .digits(3);
  });
  return kAll;
}
const SaidTable& chord_table() { return chord_quantities().table(); }

}  // namespace

const Quantities<std::optional<ChordView>>& measure_quantities() {
  using M = std::optional<ChordView>;
  static const Quantities<M> kAll("measure", [](Quantities<M>& q) {
    q.record("Chordal tooth thickness (shortest over all inclinations of the calliper)",
             "chordal_thickness", "thickness allowance included; null: there is no chord",
             chord_table,
             [](const M& m) { return m ? Value(chord_quantities().of(*m)) : Value(); });
  });
  return kAll;
}

const Quantities<ReferenceInput<double>>& as_rack_quantities() {
  using R = ReferenceInput<double>;
  static const Quantities<R> kAll("as_rack", [](Quantities<R>& q) {
    constexpr const char* kRack = "As the rack asked for has it";
    q.mm(kRack, "normal_module_mm", "normal module", "m_n", "of that rack",
         [](const R& r) { return Value(r.normal_module); })
        .always()
        .digits(6);
    q.deg(kRack, "normal_pressure_angle_deg", "normal pressure angle", "α_n", "of that rack",
          [](const R& r) { return Value(deg(r.normal_pressure_angle)); })
        .always();
    q.deg(kRack, "helix_angle_deg", "helix angle", "β", "at its reference cylinder",
          [](const R& r) { return Value(deg(r.helix_angle)); })
        .always();
    q.pure(kRack, "profile_shift", "profile shift coefficient", "x", "thickness allowance included",
           [](const R& r) { return Value(r.profile_shift); })
        .always();
    q.mm(kRack, "reference_diameter_mm", "reference diameter", "d", "of that rack", [](const R& r) {
       return Value(r.normal_module / std::cos(r.helix_angle) * std::abs(r.teeth));
     }).always();
  });
  return kAll;
}

}  // namespace gearwright
