#include "gearwright/catalogue/gear_quantities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

double measured_degrees(double rad) { return Angle::radians(rad).deg(); }

constexpr const char* kSpan = "Span measurement";
constexpr const char* kBalls = "Balls in opposite spaces";
constexpr const char* kPins = "Pins in opposite spaces";
constexpr const char* kSizes = "Sizes of balls and pins";
constexpr const char* kChord =
    "Chordal tooth thickness (shortest over all inclinations of the calliper)";
constexpr const char* kConstant = "Constant chord";
constexpr const char* kRanges = "Profile and helix on a measuring machine";
constexpr const char* kTolerances = "Tolerances of the flanks by ISO 1328";
constexpr const char* kThickness = "Tooth thickness on the cylinder of the chord, and base pitch";

const char* place_word(ContactPlace place) {
  switch (place) {
    case ContactPlace::usable: return "usable";
    case ContactPlace::below_flank: return "below_flank";
    case ContactPlace::on_tip_rounding: return "on_tip_rounding";
    case ContactPlace::beyond_tip: return "beyond_tip";
  }
  return "";
}
const std::vector<std::string> kPlaces{"usable", "below_flank", "on_tip_rounding", "beyond_tip"};

void add_span(Quantities<Span>& q) {
  using S = Span;
  q.whole("teeth", "teeth between the anvils", "k", "number of tooth spaces for an internal gear",
          &S::teeth);
  q.number("length_mm", "span", "W_k", "exact at any helix angle [T10.2]", &S::length);
  q.term("contact_diameter_mm", "for symmetric contact of the anvils [T10.3]",
         &S::contact_diameter);
  q.term("contact", "whether the contact is on the usable flank from d_Ff to d_Fa", [](const S& s) {
     return place_word(s.place);
   }).one_of(kPlaces);
  q.number("min_face_width_mm", "required face width", "",
           "W_k sin |β_b|; if the face is narrower than this width, one of the anvils does not "
           "touch [T10.4]",
           &S::min_face_width);
  q.flag("face_wide_enough", "face is wide enough for both anvils",
         "true if b is greater than the required face width", &S::face_is_wide_enough);
}

const Quantities<Span>& span_quantities() { return define<add_span>("measure.span"); }

// Adds the position of a ball or pin. Its rows follow the dimension over the balls or pins.
template <class V, class Seat>
void add_seat(Quantities<V>& q, const Seat& seat) {
  q.term("center_diameter_mm", "[T10.6]", [seat](const V& v) { return seat(v).center_diameter; });
  q.term("contact_diameter_mm", "[T10.7]", [seat](const V& v) { return seat(v).contact_diameter; });
  q.term("contact_offset_mm",
         "axial distance of each of the two contacts from the centre of the ball, D_M sin |β_b|/2",
         [seat](const V& v) { return seat(v).contact_offset; });
  q.term("contact", "whether the contact is on the usable flank from d_Ff to d_Fa",
         [seat](const V& v) { return place_word(seat(v).place); })
      .one_of(kPlaces);
}

const Quantities<BallMeasure>& ball_quantities() {
  using B = BallMeasure;
  return define("measure.over_balls", [](Quantities<B>& q) {
    q.number("ball_diameter_mm", "diameter of the balls", "D_M", "as given, or the standard size",
             [](const B& b) { return b.seat.ball_diameter; });
    q.number(
        "dimension_mm", "dimension over or between two balls", "M_dK",
        "over the balls, or between them for an internal gear; both balls are in one transverse "
        "plane, in tooth spaces that are opposite or as nearly opposite as possible [T10.8]",
        &B::dimension);
    q.number(
        "radial_mm", "distance from the axis over one ball", "M_rK",
        "from the axis to the outer side of the ball or, for an internal gear, to its inner side",
        [](const B& b) { return b.seat.radial; });
    add_seat<B>(q, [](const B& b) -> const BallSeat& { return b.seat; });
  });
}

const Quantities<PinMeasure>& pin_quantities() {
  using P = PinMeasure;
  return define("measure.over_pins", [](Quantities<P>& q) {
    q.number("pin_diameter_mm", "diameter of the pins", "D_M",
             "as given, or the diameter of the balls",
             [](const P& p) { return p.seat.ball_diameter; });
    q.number("two_free_mm", "dimension over two pins that may tilt", "M_dR",
             "least dimension, as measured by a micrometer on a face that is at least as wide as "
             "`two_free_face_width_mm` [T10.9]; null for an internal helical gear",
             [](const P& p) { return p.reading.two_free; });
    q.number("two_free_face_width_mm", "required face width of two pins that may tilt", "",
             "least face width that includes all contacts of two pins that may tilt [T10.35]",
             [](const P& p) { return p.reading.two_free_face; });
    q.number("three_mm", "dimension over two pins between parallel anvils", "M_dR",
             "for helical gears, this is also the dimension over three pins [T10.10]; for spur "
             "gears, it is equal to the dimension over two pins; null for an internal helical gear",
             [](const P& p) { return p.reading.three; });
    q.number(
        "three_pins_mm", "dimension over three pins", "M_d3R",
        "one anvil touches two pins in neighbouring tooth spaces, which gives a smaller dimension "
        "on a spur gear with an odd number of teeth [T10.30]; on other gears, the dimension is "
        "equal to the dimension between parallel anvils; null for an internal helical gear",
        [](const P& p) { return p.reading.three_pins; });
    add_seat<P>(q, [](const P& p) -> const BallSeat& { return p.seat; });
  });
}

std::string inch_text(double inch) {
  int over = static_cast<int>(std::lround(inch * 64)), under = 64;
  for (; under > 1 && over % 2 == 0; under /= 2) over /= 2;
  const int whole = over / under;
  if (over % under == 0) return fmt::format("{} in", whole);
  return whole > 0 ? fmt::format("{} {}/{} in", whole, over % under, under)
                   : fmt::format("{}/{} in", over, under);
}

const Quantities<BallSizes>& size_quantities() {
  using S = BallSizes;
  return define("measure.ball_sizes", [](Quantities<S>& q) {
    q.number("ideal_mm", "size that touches at the V circle", "D_M",
             "size that touches at the middle of the usable flank if the V circle lies outside the "
             "flank [T10.11]",
             &S::ideal);
    q.number("metric_mm", "nearest metric size", "", "size of measuring pins by DIN 3977",
             &S::metric);
    q.word("inch", "nearest inch size",
           "size of balls; the steps are 1/64 inch for sizes up to 1/2 inch, 1/32 inch for sizes "
           "up to 1 inch, and 1/16 inch for greater sizes",
           [](const S& s) { return inch_text(s.inch); });
    q.number("inch_mm", "diameter of the nearest inch size", "", "",
             [](const S& s) { return s.inch * kMmPerInch; });
  });
}

const Quantities<ChordMeasure>& chord_quantities() {
  using C = ChordMeasure;
  return define("measure.chordal_thickness", [](Quantities<C>& q) {
    q.number("diameter_mm", "diameter of the chord", "d_y",
             "diameter at which the jaws of the calliper touch", &C::diameter);
    q.number("chord_mm", "chordal tooth thickness", "",
             "shortest thickness over the inclinations of the calliper [T5.6]",
             [](const C& c) { return c.chord.chord; });
    q.number("height_mm", "height of the arc over the chord", "", "at the diameter of the chord",
             [](const C& c) { return c.chord.height; });
    q.number("tip_to_chord_mm", "calliper setting from the tip", "",
             "distance from d_a; < 0 if the chord of an internal gear lies beyond the tip",
             [](const C& c) { return c.chord.tip_to_chord; });
    q.number("caliper_angle_deg", "angle of the calliper to the transverse plane", "",
             "signed in the same way as β [T5.7]",
             [](const C& c) { return measured_degrees(c.chord.caliper_angle); })
        .digits(3);
  });
}

const Quantities<ConstantChord>& constant_quantities() {
  using C = ConstantChord;
  return define("measure.constant_chord", [](Quantities<C>& q) {
    q.number("chord_mm", "constant chord", "s_c", "s_n cos² α_n [T10.13]", &C::chord);
    q.number("tip_to_chord_mm", "calliper setting from the tip", "h_c",
             "distance from d_a [T10.13]", &C::tip_to_chord);
    q.number("contact_diameter_mm", "diameter of the contacts", "", "[T10.14]",
             &C::contact_diameter);
    q.term("contact", "whether the contacts are on the usable flank from d_Ff to d_Fa",
           [](const C& c) { return place_word(c.place); })
        .one_of(kPlaces);
  });
}

const Quantities<ThicknessAt>& thickness_quantities() {
  using T = ThicknessAt;
  return define("measure.tooth_thickness", [](Quantities<T>& q) {
    q.number("diameter_mm", "diameter", "d_y", "diameter of the chord", &T::diameter);
    q.number("transverse_mm", "transverse tooth thickness", "s_yt", "arc [T2.11]", &T::transverse);
    q.number("normal_mm", "normal tooth thickness", "s_yn", "s_yt cos β_y", &T::normal);
    q.number("half_angle_deg", "half angle of the tooth", "ψ_y", "s_yt/d_y",
             [](const T& t) { return measured_degrees(t.half_angle); });
    q.number("helix_angle_deg", "helix angle", "β_y", "> 0 right hand [T2.12]",
             [](const T& t) { return measured_degrees(t.helix); });
  });
}

void add_measure(Quantities<GearMeasures>& q) {
  using M = GearMeasures;
  q.under(kSpan);
  q.record<span_quantities>("span", "null if no span can be measured", &M::span);
  q.under("Other spans");
  q.record<span_quantities>(
       "spans", "all spans that can be measured, but at most 31 around the usual span", &M::spans)
      .doors(kJson);
  q.under(kBalls);
  q.record<ball_quantities>("over_balls", "null if no measurement over balls is possible",
                            &M::balls);
  q.under(kPins);
  q.record<pin_quantities>("over_pins", "null if no measurement over pins is possible", &M::pins);
  q.under(kSizes);
  q.record<size_quantities>("ball_sizes", "null if no measurement over balls is possible",
                            &M::sizes);
  q.under(kChord);
  q.record<chord_quantities>("chordal_thickness",
                             "including the thickness allowance; null if there is no chord",
                             &M::chord);
  q.under(kConstant);
  q.record<constant_quantities>("constant_chord", "null if there is no usable flank", &M::constant);
  q.under(kThickness);
  q.record<thickness_quantities>("tooth_thickness",
                                 "null if the flank does not reach the diameter of the chord",
                                 &M::thickness);
  q.term("normal_base_pitch_mm",
         "distance of two flanks of the same side, along their common normal",
         [](const M& m) { return m.reference ? Value(m.reference->base_pitch_normal) : Value(); });
  q.term("transverse_base_pitch_mm", "π d_b/z", [](const M& m) {
    return m.reference ? Value(m.reference->base_pitch_transverse) : Value();
  });
  q.under(kRanges);
  q.record<range_quantities>("flank", "null if there is no usable flank", &M::ranges);
  q.under(kTolerances);
  q.record<tolerance_quantities>("tolerances",
                                 "by the edition of ISO 1328-1 in the spec; only with `quality`",
                                 &M::tolerances)
      .when([](const M& m) { return m.tolerances.has_value(); });
}

}  // namespace

const Quantities<GearMeasures>& measure_quantities() { return define<add_measure>("measure"); }

const Quantities<ReferenceInput<double>>& as_rack_quantities() {
  using R = ReferenceInput<double>;
  return define("as_rack", [](Quantities<R>& q) {
    constexpr const char* kRack = "Values for the requested rack";
    q.under(kRack);
    q.term("normal_module_mm", "of the requested rack", &R::normal_module).digits(6);
    q.term("normal_pressure_angle_deg", "of the requested rack",
           [](const R& r) { return measured_degrees(r.normal_pressure_angle); });
    q.term("helix_angle_deg", "at the reference cylinder for the requested rack",
           [](const R& r) { return measured_degrees(r.helix_angle); });
    q.term("profile_shift", "including the thickness allowance", &R::profile_shift);
    q.term("reference_diameter_mm", "of the requested rack", [](const R& r) {
      return r.normal_module / std::cos(r.helix_angle) * std::abs(r.teeth);
    });
  });
}

}  // namespace gearwright
