// Gears cut by a finished pinion with circular root and tip fillets. Source: the sets S of Chen and
// Tsay, "Tooth profile design for the manufacture of helical gear sets with small numbers of
// teeth", recomputed with 40 digits and confirmed by sweeping the cutter. Numbers are in mm and
// rad, truncated after 18 digits. The pinion itself is computed here in the transverse section z =
// 0:
//
//   α, α_t    pressure angle, normal and transverse      r, r_b   reference and base radius
//   l         position along the straight flank of the rack that cut the pinion, from its lower end
//             m (1 − x) below the pitch line; x_a = l cos α − m (1 − x) its height above that line
//   t         roll angle of the involute; the point of the rack at the height x_a cuts the point
//             with t = tan α_t + 2 x_a/(r sin 2α_t)
//   σ         half angle of the tooth on the base circle
//   e(a)      unit vector of polar angle a; the flank y > 0 of tooth 0 is the end of the string
//             that leaves the base circle at e(σ − t), and the string is its normal
//   C, J      ends of the involute, at l_C and l_J. Below C, there is an arc about A, the point at
//             which the string of C meets the middle of the space. Above J, there is an arc about
//             O, the point at which the string of J meets the x axis
//
// The gear of the source has space 0 on the negative x axis. `points` lie on its side y > 0, each
// with the unit normal that points out of the material. The blank has no effect.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <ostream>
#include <vector>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/toothed_outline.hpp"

namespace gearwright::oracle {

/// Involute of the base circle r_b with the half angle σ on it, side y > 0 of tooth 0.
inline Eigen::Vector2d involute_point(double r_b, double sigma, double t) {
  const double s = std::sin(sigma - t), c = std::cos(sigma - t);
  return r_b * Eigen::Vector2d(c - t * s, s + t * c);
}

inline ToothedOutline::Curve involute_curve(double r_b, double sigma, double from, double to) {
  return [=](double u) { return involute_point(r_b, sigma, from + (to - from) * u); };
}

inline ToothedOutline::Curve circle_arc(Eigen::Vector2d centre, double radius, double from,
                                        double to) {
  return [=](double u) -> Eigen::Vector2d {
    const double angle = from + (to - from) * u;
    return centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
}

/// The cutter, and the gear that it cuts.
struct FilletedPinion {
  int teeth, gear_teeth;
  double normal_module, normal_pressure_angle_deg, helix_angle_deg, profile_shift;
  double l_C, l_J, center_distance;
};

struct FilletedHalfTooth {
  std::vector<ToothedOutline::Curve> curves;
  double root_fillet_radius, root_radius, tip_fillet_radius, tip_radius;
};

inline FilletedHalfTooth filleted_half_tooth(const FilletedPinion& n) {
  const double m = n.normal_module, tan_a = std::tan(n.normal_pressure_angle_deg * kDegree);
  const double cos_b = std::cos(n.helix_angle_deg * kDegree);
  const double alpha_t = std::atan(tan_a / cos_b), gamma = kPi / n.teeth;
  const double r = n.teeth * m / (2 * cos_b), r_b = r * std::cos(alpha_t);
  const double half_thickness = m * (kPi / 4 + n.profile_shift * tan_a) / cos_b;
  const double sigma = half_thickness / r + std::tan(alpha_t) - alpha_t;
  const auto roll_angle = [&](double l) {
    const double x_a =
        l * std::cos(n.normal_pressure_angle_deg * kDegree) - m * (1 - n.profile_shift);
    return std::tan(alpha_t) + 2 * x_a / (r * std::sin(2 * alpha_t));
  };
  const double t_C = roll_angle(n.l_C), t_J = roll_angle(n.l_J);
  const double string_C = sigma - t_C, string_J = sigma - t_J;  // polar angles
  const double A = r_b / std::cos(gamma - string_C), O = r_b / std::cos(string_J);
  const double r_r = r_b * (std::tan(gamma - string_C) - t_C);
  const double r_t = r_b * (t_J + std::tan(string_J));
  return {
      {circle_arc({A * std::cos(gamma), A * std::sin(gamma)}, r_r, gamma + kPi,
                  string_C + 1.5 * kPi),
       involute_curve(r_b, sigma, t_C, t_J), circle_arc({O, 0.0}, r_t, string_J + 0.5 * kPi, 0.0)},
      r_r,
      A - r_r,
      r_t,
      O + r_t};
}

struct CutGearPoint {
  double x, y, n_x, n_y;
};

struct PinionCutterCase {
  const char* name;
  FilletedPinion pinion;
  double root_fillet_radius, root_radius, tip_fillet_radius, tip_radius;
  std::vector<CutGearPoint> points;  ///< cut by the root arc, the involute, the tip arc
};

inline void PrintTo(const PinionCutterCase& c, std::ostream* os) { *os << c.name; }

inline const std::vector<PinionCutterCase>& pinion_cutter_cases() {
  static const std::vector<PinionCutterCase> cases = {
      {"S01",
       {2, 60, 1.75, 20, 30, 0.7, 0.245880152767074, 1.90081369698601536, 61.106},
       1.04539738458970828,
       1.10274332355118408,
       0.332,
       4.47987905326711323,
       {
           {-59.301503625513215, 2.14824273915633812, -0.37005383689012783, -0.92901031092388563},
           {-59.5895480677801607, 2.32975596522261278, -0.67286265684500488, -0.73976742630605275},
           {-59.783215168962799, 2.56959265981340285, -0.8643211922357536, -0.5029402316897759},
           {-59.8941342757173368, 2.84661394349130241, -0.97250612097532257, -0.23287731676900447},
           {-59.9210242985613596, 3.14032781585275261, -0.99862953475457387, 0.05233595624294383},
           {-58.9759842338298596, 2.02192332047457587, -0.35331478704331743, -0.93550449558328432},
           {-58.6651603066673683, 1.90768253132557602, -0.33646183902940729, -0.94169710144873506},
           {-58.3693551728564018, 1.80494996370290891, -0.31950042573702648, -0.94758613220849682},
           {-58.0888763813703361, 1.71314759153298351, -0.30243601502078022, -0.95316968941440348},
           {-57.1741377204284967, 1.19463799055615726, -0.6827300640289069, -0.73067069167381052},
           {-56.8322390017925995, 0.76500541473853211, -0.86967973719890182, -0.49361640441303108},
           {-56.6736515609605354, 0.37448780358482616, -0.96858163831752331, -0.24869581804715264},
           {-56.6261209467328867, 0.0, -1.0, 0.0},
       }},
      {"S02",
       {2, 60, 1.75, 20, 30, 0.7, 0.245880152767074, 1.90081369698601536, 61.3350928493613062},
       1.04539738458970828,
       1.10274332355118408,
       0.332,
       4.47987905326711323,
       {
           {-59.5367815012976871, 2.16144019946207182, -0.38024171658139, -0.92488714823552277},
           {-60.0130765809731293, 2.58301979591598439, -0.86558258372576038, -0.50076620368255385},
           {-60.1498031841346405, 3.15231760919249726, -0.99862953475457387, 0.05233595624294383},
           {-58.8800305614183416, 1.90488920018908362, -0.34679118094360528, -0.93794236327172024},
           {-57.3948731206747403, 1.18336385163040711, -0.68564659486021974, -0.72793457601393387},
           {-56.9021295971379082, 0.37110364654189759, -0.96882316247975039, -0.24775326404052714},
       }},
      {"S03",
       {2, 60, 1.75, 20, 30, 0.7, 0.245880152767074, 1.90081369698601536, 62.6425042070743954},
       1.04539738458970828,
       1.10274332355118408,
       0.332,
       4.47987905326711323,
       {
           {-60.8785710494636972, 2.23930900907726119, -0.43146036026666588, -0.90213189585479067},
           {-61.3247947152900866, 2.66008968347505036, -0.87246958791775319, -0.48866841330152077},
           {-61.4554227800205086, 3.22074223280129728, -0.99862953475457387, 0.05233595624294383},
           {-60.1193877442099911, 1.89258746732559614, -0.39879376608498233, -0.91704063821171872},
           {-58.6574706359900245, 1.12117007189164759, -0.70147891599664553, -0.71269020647976573},
           {-58.2061973130732592, 0.35239343250662952, -0.97014992482253119, -0.24250592439533733},
       }},
      {"S05",
       {1, 30, 2, 20, 55, 0.75, 0.05, 2.89113931209330537, 54.0468506642540386},
       2.28636417855178935,
       0.50783894524852608,
       0.5,
       5.30268185475305465,
       {
           {-52.6082560812224191, 4.01507389626726847, -0.60927828954713705, -0.79295647162156071},
           {-52.9350219118062649, 4.36023781871164782, -0.81982131437158848, -0.57261943077583481},
           {-53.1408135504664118, 4.75439331497658745, -0.93743029989711059, -0.34817299268440293},
           {-53.2422183968218149, 5.17239133512220425, -0.99261957169839116, -0.12126988860101454},
           {-53.2457194109295603, 5.59635061985653645, -0.99452189536827333, 0.10452846326765347},
           {-51.9697391830015647, 3.53852787002267396, -0.58667131435381251, -0.80982514712397644},
           {-51.3467792604311601, 3.10039124809510598, -0.5635975673055096, -0.82604950343627201},
           {-50.7410120254367055, 2.69939125696309368, -0.54007540651084474, -0.84161663201373688},
           {-50.154013328290574, 2.33419406663317678, -0.51612354684876052, -0.85651414722014679},
           {-49.3855008015803579, 1.68861782233679844, -0.76039114601453732, -0.64946539943456462},
           {-48.9996433562583294, 1.10090908363615565, -0.89997488566124215, -0.43594174516675288},
           {-48.8045445281570061, 0.5437055731801248, -0.97576556170101666, -0.21881857461901958},
           {-48.7441688095009839, 0.0, -1.0, 0.0},
       }},
      {"S07",
       {8, 24, 3, 20, 0, 0.3, 0.76095150191937041, 4.81577181986395343, 48.0},
       1.75348330613206822,
       9.66692077138979378,
       0.6,
       16.0731809520801256,
       {
           {-37.4163359141306945, 3.48284611344340831, -0.51697563444407164, -0.85600011296211264},
           {-37.5012186939499236, 3.56149520689227078, -0.68159112698129657, -0.73173324075127682},
           {-37.795515786962663, 3.93468301302424667, -0.86731672785310148, -0.49775666101639372},
           {-37.9862807495996533, 4.4429052348195118, -0.98038368005205743, -0.19709855374300717},
           {-38.0051344218407372, 5.00347086778004276, -0.99144486137381041, 0.13052619222005159},
           {-36.337108640895151, 2.88845201765584373, -0.4448297485307222, -0.89561514883464004},
           {-35.421984436505847, 2.47825858851975358, -0.3696704169004832, -0.92916294742559711},
           {-34.6925303153066595, 2.22061555652352794, -0.29200679742045664, -0.95641624320180196},
           {-34.1661720986541486, 2.08169205066419611, -0.21236501295507155, -0.97719041198355619},
           {-32.7018791755473513, 1.4397877951167299, -0.61453356824095174, -0.78889067272027212},
           {-32.2094948757449178, 0.9146605872030856, -0.8362048447122319, -0.54841722956139163},
           {-31.9912759254985667, 0.44654786860213617, -0.95978301104524315, -0.28074289253501443},
           {-31.9268190479198743, 0.0, -1.0, 0.0},
       }},
  };
  return cases;
}

}  // namespace gearwright::oracle
