#include "gearwright/catalogue/rating_quantities.hpp"

#include <cmath>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

using R = Rating;

constexpr const char* kRatingInputs = "Inputs of the rating";
constexpr const char* kRatedLoad = "Load";
constexpr const char* kMaterial = "Material";
constexpr const char* kGeneral = "General influence, ISO 6336-1";
constexpr const char* kFlank = "Flank, ISO 6336-2";
constexpr const char* kRoot = "Root, ISO 6336-3";

// A factor of the rating: `of` returns the value of a pair, or `each` the value of gear i.
struct FactorEntry {
  const char *group, *key, *words, *symbol;
  Unit unit;
  int digits;
  const Factor* (*of)(const R&) = nullptr;
  const Factor* (*each)(const R&, std::size_t) = nullptr;
};

template <auto member>
const Factor* one(const R& r) {
  return &(r.*member);
}
template <auto member>
const Factor* factor_of(const R& r) {
  const auto& f = r.*member;
  return f ? &*f : nullptr;
}
template <auto member>
const Factor* per(const R& r, std::size_t i) {
  return &(r.*member)[i];
}
template <auto member>
const Factor* first(const R& r) {
  return &(r.*member)[0];
}
template <auto member>
const Factor* of_face(const R& r) {
  const auto& f = r.face.*member;
  return f ? &*f : nullptr;
}
template <auto member>
const Factor* of_stiffness(const R& r) {
  return &(r.stiffness.*member);
}

const Factor* cycles(const R& r, std::size_t i) { return r.N_L[i] ? &*r.N_L[i] : nullptr; }

constexpr const char* kWhole = "Spectrum, ISO 6336-6, with K_A = 1";
constexpr const char* kSizing = "With the required safeties";
constexpr const char* kBeside = "Additional computation of the teeth under load";

constexpr Unit kNone = Unit::none;
constexpr Unit kStress = Unit::megapascal;
constexpr Unit kStiff = Unit::newton_per_mm_um;

const std::vector<FactorEntry>& entries() {
  static const std::vector<FactorEntry> kAll{
      {kRatedLoad, "F_t_N", "tangential load", "F_t", Unit::newton, 1, one<&R::F_t>},
      {kRatedLoad, "v_m_per_s", "pitch line velocity", "v", Unit::m_per_s, 3, factor_of<&R::v>},
      {kRatedLoad, "N_L", "load cycles", "N_L", kNone, 0, nullptr, cycles},
      {kRatedLoad, "K_A", "application factor", "K_A", kNone, 3, one<&R::K_A>},
      {kRatedLoad, "K_gamma", "mesh load factor", "K_γ", kNone, 3, one<&R::K_gamma>},
      {kGeneral, "c_th_prime", "theoretical single stiffness", "c'_th", kStiff, 5,
       of_stiffness<&Stiffness::c_th>},
      {kGeneral, "c_prime", "single stiffness", "c'", kStiff, 5, of_stiffness<&Stiffness::c_prime>},
      {kGeneral, "c_gamma_alpha", "mesh stiffness", "c_γα", kStiff, 5,
       of_stiffness<&Stiffness::c_gamma_alpha>},
      {kGeneral, "c_gamma_beta", "mesh stiffness for the face load factor", "c_γβ", kStiff, 5,
       of_stiffness<&Stiffness::c_gamma_beta>},
      {kGeneral, "m_red", "reduced mass", "m_red", Unit::kg_per_mm, 5, factor_of<&R::m_red>},
      {kGeneral, "n_E1_rpm", "resonance speed of the pinion", "n_E1", Unit::per_minute, 1,
       factor_of<&R::n_E1>},
      {kGeneral, "N", "resonance ratio", "N", kNone, 4, factor_of<&R::N>},
      {kGeneral, "K_v", "dynamic factor", "K_v", kNone, 4, one<&R::K_v>},
      {kGeneral, "f_sh_um", "misalignment by deflection", "f_sh", Unit::um, 2,
       of_face<&FaceLoad::f_sh>},
      {kGeneral, "F_betax_um", "misalignment before running-in", "F_βx", Unit::um, 2,
       of_face<&FaceLoad::F_betax>},
      {kGeneral, "F_betay_um", "misalignment after running-in", "F_βy", Unit::um, 2,
       of_face<&FaceLoad::F_betay>},
      {kGeneral, "K_Hbeta", "face load factor, flank", "K_Hβ", kNone, 4,
       [](const R& r) { return &r.face.K_Hbeta; }},
      {kGeneral, "K_Fbeta", "face load factor, root", "K_Fβ", kNone, 4, one<&R::K_Fbeta>},
      {kGeneral, "K_Halpha", "transverse load factor, flank", "K_Hα", kNone, 4, one<&R::K_Halpha>},
      {kGeneral, "K_Falpha", "transverse load factor, root", "K_Fα", kNone, 4, one<&R::K_Falpha>},
      {kFlank, "Z_H", "zone factor", "Z_H", kNone, 5, one<&R::Z_H>},
      {kFlank, "Z_B", "single pair contact factor, pinion", "Z_B", kNone, 4, first<&R::Z_B>},
      {kFlank, "Z_D", "single pair contact factor, wheel", "Z_D", kNone, 4,
       [](const R& r) { return &r.Z_B[1]; }},
      {kFlank, "Z_E", "elasticity factor", "Z_E", kNone, 3, one<&R::Z_E>},
      {kFlank, "Z_epsilon", "contact ratio factor", "Z_ε", kNone, 5, one<&R::Z_epsilon>},
      {kFlank, "Z_beta", "helix angle factor", "Z_β", kNone, 5, one<&R::Z_beta>},
      {kFlank, "sigma_H0_MPa", "nominal contact stress", "σ_H0", kStress, 2, one<&R::sigma_H0>},
      {kFlank, "sigma_H_MPa", "contact stress", "σ_H", kStress, 2, nullptr, per<&R::sigma_H>},
      {kFlank, "Z_NT", "life factor", "Z_NT", kNone, 4, nullptr, per<&R::Z_NT>},
      {kFlank, "Z_L", "lubricant factor", "Z_L", kNone, 5, nullptr, per<&R::Z_L_at_N>},
      {kFlank, "Z_v", "velocity factor", "Z_v", kNone, 5, nullptr, per<&R::Z_v_at_N>},
      {kFlank, "Z_R", "roughness factor", "Z_R", kNone, 5, nullptr, per<&R::Z_R_at_N>},
      {kFlank, "Z_W", "work hardening factor", "Z_W", kNone, 4, nullptr, per<&R::Z_W>},
      {kFlank, "Z_X", "size factor", "Z_X", kNone, 4, nullptr, per<&R::Z_X>},
      {kFlank, "sigma_HG_MPa", "pitting stress limit", "σ_HG", kStress, 2, nullptr,
       per<&R::sigma_HG>},
      {kFlank, "S_H", term_of("S_H").words, "S_H", kNone, 3, nullptr, per<&R::S_H>},
      {kRoot, "Y_F", "form factor", "Y_F", kNone, 4, nullptr, per<&R::Y_F>},
      {kRoot, "Y_S", "stress correction factor", "Y_S", kNone, 4, nullptr, per<&R::Y_S>},
      {kRoot, "Y_epsilon", "contact ratio factor", "Y_ε", kNone, 4, factor_of<&R::Y_epsilon>},
      {kRoot, "Y_beta", "helix angle factor", "Y_β", kNone, 4, nullptr, per<&R::Y_beta>},
      {kRoot, "Y_B", "rim thickness factor", "Y_B", kNone, 4, nullptr, per<&R::Y_B>},
      {kRoot, "Y_DT", "deep tooth factor", "Y_DT", kNone, 4, nullptr, per<&R::Y_DT>},
      {kRoot, "sigma_F0_MPa", "nominal root stress", "σ_F0", kStress, 2, nullptr,
       per<&R::sigma_F0>},
      {kRoot, "sigma_F_MPa", "root stress", "σ_F", kStress, 2, nullptr, per<&R::sigma_F>},
      {kRoot, "Y_ST", "stress correction of the test gears", "Y_ST", kNone, 2, nullptr,
       per<&R::Y_ST>},
      {kRoot, "Y_M", "mean stress factor", "Y_M", kNone, 2, nullptr, per<&R::Y_M>},
      {kRoot, "Y_NT", "life factor", "Y_NT", kNone, 4, nullptr, per<&R::Y_NT>},
      {kRoot, "Y_delta_relT", "relative notch sensitivity factor", "Y_δrelT", kNone, 4, nullptr,
       per<&R::Y_delta_relT>},
      {kRoot, "Y_R_relT", "relative surface factor", "Y_RrelT", kNone, 4, nullptr,
       per<&R::Y_R_relT>},
      {kRoot, "Y_X", "size factor", "Y_X", kNone, 4, nullptr, per<&R::Y_X>},
      {kRoot, "sigma_FG_MPa", "root stress limit", "σ_FG", kStress, 2, nullptr, per<&R::sigma_FG>},
      {kRoot, "S_F", term_of("S_F").words, "S_F", kNone, 3, nullptr, per<&R::S_F>}};
  return kAll;
}

Value number(const Factor* f) { return f && is_there(*f) ? Value(f->value) : Value(); }

Value tolerance(const RatingAnswer& v, double Tolerances::*member) {
  const auto& of = v.rating.tolerance;
  return of ? Value(std::array{(*of)[0].*member, (*of)[1].*member}) : Value();
}

double speed(const RatingAnswer& v) { return v.input.speed.value_or(0.0); }

double ratio(const RatingAnswer& v) {
  const auto& gears = v.pair.gears;
  return std::abs(static_cast<double>(gears[v.pair.place(2)].teeth) / gears[v.pair.place(1)].teeth);
}

template <class F>
ValueList of_materials(const RatingAnswer& v, F value) {
  ValueList values;
  for (const Material& m : v.input.materials) values.push_back(value(m));
  return values;
}

// Returns a strength of both materials. A value is null if the strength is given by temperature, as
// for some plastics.
Value strengths(const RatingAnswer& v, double Material::*member) {
  return of_materials(
      v, [member](const Material& m) { return m.*member > 0.0 ? Value(m.*member) : Value(); });
}

// The inputs that the report lists before the factors. Results in JSON do not repeat them.
void add_given(Quantities<RatingAnswer>& q) {
  q.under(kRatingInputs);
  const auto add = [&q](bool each, const char* key, const char* words, const char* symbol,
                        int digits, auto get) {
    auto made = q.number(key, words, symbol, "", get).digits(digits).doors(kPage);
    if (each) made.per_gear();
  };
  const auto required = [](double s) { return s != 1.0 ? Value(s) : Value(); };  // 1 by default
  add(false, "safety_flank_min", "required safety against pitting", "S_Hmin", 2,
      [required](const RatingAnswer& v) { return required(v.wanted.flank); });
  add(false, "safety_root_min", "required safety against root breakage", "S_Fmin", 2,
      [required](const RatingAnswer& v) { return required(v.wanted.root); });
  add(false, "life_h", "required life", "L_h", 0,
      [](const RatingAnswer& v) { return v.input.life_h; });
  add(false, "viscosity_40C_mm2_s", "viscosity at 40 °C", "ν_40", 0,
      [](const RatingAnswer& v) { return v.input.viscosity; });
  add(true, "quality", "accuracy grade of ISO 1328-1", "", 0,
      [](const RatingAnswer& v) { return v.input.quality; });
  add(true, "flank_roughness_um", "roughness of the flanks", "Rz", 1,
      [](const RatingAnswer& v) { return v.input.flank_roughness; });
  add(true, "root_roughness_um", "roughness of the roots", "Rz", 1,
      [](const RatingAnswer& v) { return v.input.root_roughness; });
  add(true, "surface_hardness_HV", "surface hardness", "", 0, [](const RatingAnswer& v) {
    return of_materials(v, [](const Material& m) { return Value(m.hardness_HV); });
  });
}

void add_inputs(Quantities<RatingAnswer>& q) {
  q.word("standard", "standard", "standard with its edition",
         [](const RatingAnswer& v) { return name(v.rating.edition); });
  q.under(kRatedLoad);
  q.term("power_kW", "null without a speed", [](const RatingAnswer& v) {
    const double power = kilowatts(v.input.torque, speed(v));
    return power > 0 ? Value(power) : Value();
  });
  q.number("torque_Nm", "torque", "T", "torque on each gear under the nominal load",
           [](const RatingAnswer& v) {
             return std::array{v.input.torque, v.input.torque * ratio(v)};
           })
      .per_gear();
  q.term("speed_rpm", "null if no speed is given", [](const RatingAnswer& v) {
     return speed(v) > 0 ? Value(std::array{speed(v), speed(v) / ratio(v)}) : Value();
   }).per_gear();
  q.under(kMaterial);
  q.add(Type::text, "material", "material", "",
        "name of the material, or its kind if it has no name",
        [](const RatingAnswer& v) {
          return of_materials(v, [](const Material& m) {
            return Value(m.name.empty() ? std::string(material_letters(m.kind)) : m.name);
          });
        })
      .per_gear();
  q.number("sigma_Hlim_MPa", "allowable contact stress number", "σ_Hlim",
           "value of the reference test gears",
           [](const RatingAnswer& v) { return strengths(v, &Material::sigma_Hlim); })
      .per_gear()
      .digits(0);
  q.number("sigma_Flim_MPa", "allowable bending stress number", "σ_Flim",
           "value of the reference test gears",
           [](const RatingAnswer& v) { return strengths(v, &Material::sigma_Flim); })
      .per_gear()
      .digits(0);
  q.under(kGeneral);
  q.number("f_pb_um", "base pitch deviation", "f_pb",
           "deviation that belongs to the accuracy grade",
           [](const RatingAnswer& v) { return tolerance(v, &Tolerances::f_pb); })
      .per_gear()
      .digits(1);
  q.number("f_falpha_um", "profile form deviation", "f_fα",
           "deviation that belongs to the accuracy grade",
           [](const RatingAnswer& v) { return tolerance(v, &Tolerances::f_falpha); })
      .per_gear()
      .digits(1);
}

void add_section(Quantities<RatingAnswer>& q) {
  using C = CriticalSection;
  struct Row {
    const char *key, *words, *symbol, *meaning;
    double C::*member;
    double scale = 1.0;
  };
  q.under(kRoot);
  for (const Row& row :
       {Row{"h_F_mm", "bending moment arm", "h_F", "distance of the load from the critical section",
            &C::h_F},
        Row{"s_Fn_mm", "chord of the critical section", "s_Fn", "in the normal section", &C::s_Fn},
        Row{"rho_F_mm", "fillet radius at the critical section", "ρ_F", "", &C::rho_F},
        Row{"alpha_Fen_deg", "direction of the load", "α_Fen",
            "at the outer point of single pair contact", &C::alpha_Fen, kDegPerRad},
        Row{"d_en_mm", "diameter of the point of load", "d_en", "diameter on the virtual spur gear",
            &C::d_en}})
    q.number(row.key, row.words, row.symbol, row.meaning,
             [row](const RatingAnswer& v) {
               const auto& [one, two] = v.rating.section;
               return Value(std::array{std::abs(one.*row.member) * row.scale,
                                       std::abs(two.*row.member) * row.scale});
             })
        .per_gear()
        .digits(3);
}

void add_spectrum(Quantities<RatingAnswer>& q) {
  using S = SpectrumRating;
  struct Row {
    const char *key, *words, *symbol, *meaning;
    std::array<double, 2> S::*member;
    int digits;
  };
  q.under(kWhole);
  for (const Row& row :
       {Row{"damage_flank", "damage of the flanks", "U_H",
            "damage sum by Miner's rule; 1 means failure; null without a spectrum, or if a step "
            "exceeds the static strength",
            &S::damage_flank, 4},
        Row{"damage_root", "damage of the roots", "U_F", "as `damage_flank`, but for the roots",
            &S::damage_root, 4},
        Row{"S_H_spectrum", "safety against pitting, spectrum", "S_H",
            "least safety for the whole spectrum", &S::S_H, 3},
        Row{"S_F_spectrum", "safety against root breakage, spectrum", "S_F",
            "least safety for the whole spectrum", &S::S_F, 3}})
    q.number(row.key, row.words, row.symbol, row.meaning,
             [row](const RatingAnswer& v) {
               return v.spectrum ? Value((*v.spectrum).*row.member) : Value();
             })
        .per_gear()
        .digits(row.digits);
  q.under(kSizing);
  q.number(
      "torque_holding_Nm", "greatest torque", "T_1",
      "greatest torque on gear 1 for which the safety factors are at least `safety_flank_min` and "
      "`safety_root_min`, or at least 1 if these keys are absent; with a spectrum, the greatest "
      "torque if all torques are multiplied by the same factor; null for a mesh of a drive, if no "
      "torque holds, or if K_Hβ is \"computed\" and there is a spectrum or K_Hβ has no value there",
      &RatingAnswer::torque_holding);
  q.number("face_width_holding_mm", "required face width", "b",
           "least face width, up to 40 modules, for which the safeties satisfy the same limits as "
           "for `torque_holding_Nm`; null for a mesh of a drive, if there is no such width, or if "
           "`face_load_factor = \"computed\"`, which applies to one face width",
           &RatingAnswer::face_holding)
      .digits(2);
}

Value over(const std::array<double, 2>& contact, const FactorPair& standard) {
  return std::array{contact[0] / standard[0].value, contact[1] / standard[1].value};
}

const ToothContact* contact_of(const RatingAnswer& v) { return v.contact ? &*v.contact : nullptr; }

void add_rated_contact(Quantities<RatingAnswer>& q) {
  auto of_contact = q.part(contact_of);
  const auto asked = [](const RatingAnswer& v) { return v.contact.has_value(); };
  q.under(kBeside);
  of_contact
      .number("contact_torque_Nm", "torque on the teeth", "T_1",
              "T_1 K_A K_γ K_v; the contact computation determines how the teeth share this torque",
              &ToothContact::torque)
      .when();
  of_contact
      .number("contact_pressure_MPa", "greatest Hertz pressure", "p_H",
              "over all positions and the whole face, as in `load`", &ToothContact::pressure)
      .when();
  q.number("contact_pressure_over_sigma_H",
           "greatest Hertz pressure divided by the contact stress of the standard", "p_H/σ_H", "",
           [](const RatingAnswer& v) {
             return over({v.contact->pressure, v.contact->pressure}, v.rating.sigma_H);
           })
      .per_gear()
      .digits(3)
      .when(asked);
  of_contact
      .number("contact_root_stress_MPa", "greatest root stress", "σ_1",
              "greatest principal stress at the surface of the root", &ToothContact::root_stress)
      .per_gear()
      .when();
  q.number("contact_root_stress_over_sigma_F",
           "greatest root stress divided by the root stress of the standard", "σ_1/σ_F", "",
           [](const RatingAnswer& v) { return over(v.contact->root_stress, v.rating.sigma_F); })
      .per_gear()
      .digits(3)
      .when(asked);
  of_contact
      .number("contact_face_load_factor", "face load factor of the contact", "K_Hβ",
              "greatest load of a slice divided by the mean load, averaged over the positions",
              &ToothContact::face_load_factor)
      .digits(3)
      .when();
}

// True for a rating by VDI 2736. Only such a rating has rows and keys for temperatures and Y_ε.
bool by_vdi(const RatingAnswer& v) { return v.rating.edition == RatingEdition::vdi_2736; }

void add_temperatures(Quantities<RatingAnswer>& q) {
  const auto of = [](FactorPair ToothTemperatures::*member) {
    return [member](const RatingAnswer& v) {
      const FactorPair& t = (*v.rating.temperature).*member;
      return ValueList{number(&t[0]), number(&t[1])};
    };
  };
  q.under(kMaterial);
  q.number("flank_temperature_C", "temperature of the flanks", "ϑ_Fla",
           "temperature by VDI 2736, or as given; only for plastic gears",
           of(&ToothTemperatures::flank))
      .per_gear()
      .when(by_vdi);
  q.number("root_temperature_C", "temperature of the roots", "ϑ_Fu",
           "as `flank_temperature_C`, but for the roots", of(&ToothTemperatures::root))
      .per_gear()
      .when(by_vdi);
}

void add_factor(Quantities<RatingAnswer>& q, const FactorEntry& e) {
  q.under(e.group);
  auto quantity = q.number(e.key, e.words, e.symbol, "", [&e](const RatingAnswer& v) {
    if (e.of) return number(e.of(v.rating));
    return Value(ValueList{number(e.each(v.rating, 0)), number(e.each(v.rating, 1))});
  });
  quantity.unit(e.unit).digits(e.digits);
  if (e.each) quantity.per_gear();
  if (std::string_view(e.key) == "Y_epsilon") quantity.when(by_vdi);
}

void add_rating(Quantities<RatingAnswer>& q) {
  q.groups({"", kRatingInputs, kRatedLoad, kMaterial, kGeneral, kFlank, kRoot, kWhole, kSizing,
            kBeside});
  add_inputs(q);
  add_given(q);
  add_temperatures(q);
  for (const FactorEntry& e : entries()) {
    // The section of the root comes before the factors that depend on it.
    if (std::string_view(e.key) == "Y_F") add_section(q);
    add_factor(q, e);
  }
  add_spectrum(q);
  add_rated_contact(q);
  q.add(Type::map, "formulas", "formulas", "",
        "for each factor, the clause of the standard and the branch of the formula, as {key: "
        "{formula, branch}}",
        [](const RatingAnswer& v) {
          ValueMap all;
          for (const FactorSource& s : factor_sources(v.rating)) {
            ValueList branches(s.branches.begin(), s.branches.end());
            all.emplace_back(s.key, ValueMap{{"formula", Value(s.formula)},
                                             {"branch", branches.size() == 1 ? branches.front()
                                                                             : Value(branches)}});
          }
          return all;
        })
      .doors(kJson);
}

}  // namespace

const Quantities<RatingAnswer>& rating_quantities() { return define<add_rating>("rating"); }

std::vector<FactorSource> factor_sources(const Rating& rating) {
  std::vector<FactorSource> all;
  for (const FactorEntry& e : entries()) {
    const Factor* f = e.of ? e.of(rating) : e.each(rating, 0);
    if (!f || !is_there(*f)) continue;
    FactorSource s{e.key, f->formula, {f->branch}};
    if (e.each) {
      const Factor* g = e.each(rating, 1);
      if (std::string_view(g->branch) != f->branch) s.branches.emplace_back(g->branch);
      if (s.formula.empty()) s.formula = g->formula;
    }
    all.push_back(std::move(s));
  }
  return all;
}

std::string source_text(const Rating& rating, std::string_view key) {
  for (const FactorSource& s : factor_sources(rating)) {
    if (s.key != key) continue;
    std::string branches;
    for (const std::string& b : s.branches)
      if (!b.empty()) branches += (branches.empty() ? "" : "; ") + b;
    if (s.formula.empty() || branches.empty()) return s.formula + branches;
    return s.formula + ": " + branches;
  }
  return {};
}

}  // namespace gearwright
