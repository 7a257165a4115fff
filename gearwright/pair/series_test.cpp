#include "gearwright/pair/series.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/testing/numbers.hpp"

namespace gearwright {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
using testing::kDegree;

// Values computed with 40 digits from the equations of the theory page; angles in degrees, α = 20°.
// The last three columns are the exact solution.
struct Golden {
  std::string pair;
  int z1, z2;
  double module, beta1, beta2, x1, x2;
  double virtual1, virtual2, weight1, weight2, L, M2, M4, a0, Sigma0;
  double one_term, two_terms, three_terms, a_one, a_two, Sigma_one, virtual_spur, corrected;
  double alpha, a, Sigma;
};
constexpr const char* kTable = R"(
paper_9_15 9 15 3.0 51.576509202864735 39.376587488576405 -0.4531138337575591 0.18803679137509272
  37.495920850661875 32.47616840682258 0.5358696767318718 0.46413032326812825
  -0.02081667693761885 1.1642228761688616 1.5639093215928883 50.0351344483792 90.95309669144115
  18.807292267987126 18.71425943581489 18.703855112110833 50.012393482352216 50.01028640994174
  90.04956201234414 18.720955204826822 18.705174053191552 18.702224668881318 50.00999869140838
  90.0127243763086
crossed90_45_45 20 20 2.0 45.0 45.0 0.0 0.0 56.568542494923804 56.568542494923804 0.5 0.5 0.0 1.0
  1.0 56.568542494923804 90.0 20.0 20.0 20.0 56.568542494923804 56.568542494923804 90.0 20.0 20.0
  20.0 56.568542494923804 90.0
crossed90_lefthand 13 27 1.5 -45.0 -45.0 0.5 0.2 36.76955262170047 76.36753236814714 0.325 0.675
  0.0339982985029324 1.0 1.0 43.47640687119285 -90.0 21.94795901484397 21.70573911784955
  21.749592317372244 43.427366853538594 43.434688273849105 -91.41799819794744 21.770802985927396
  21.734645841419567 21.741921739363274 43.43353727362859 -91.34408834618246
crossed20_opposite 15 40 2.0 35.0 -15.0 0.2 -0.3 27.289633352363403 44.38422663744945
  0.3807473653050377 0.6192526346949623 -0.007666609332454334 0.23113719169070474
  0.09471801426942876 59.52266604782516 20.0 19.560735642074757 19.54983235064555
  19.54941238011094 59.520559664222695 59.52049326995502 19.930890902552367 19.549841229371857
  19.549416261342586 19.54939194630784 59.52049043821295 19.930144707142155
worm_like 2 40 2.0 80.0 10.0 0.0 0.2 381.9612497303163 41.87989791802468 0.9011896363758145
  0.09881036362418553 0.002592931275973414 28.988428658153403 932.2687978709461 52.53460544171707
  90.0 20.148564018680748 20.141268855974253 20.141587121292144 52.53318063769088
  52.53323449566374 90.3161970529395 20.1473805685534 20.14128398617023 20.141574500414485
  52.53323247888794 90.3070095329827
near_parallel 20 33 2.0 30.0 -29.5 0.1 0.0 30.79201435678004 50.05225083144893
  0.38088062628916564 0.6191193737108344 0.006796963057448035 0.325139599966219
  0.10575706213768793 61.2095436398818 0.5 20.38943729669811 20.380731451144293
  20.381031079065405 61.20767618962968 61.20772880987585 0.5016410350696183 20.381467361160652
  20.38099748929071 20.381019262058473 61.20772697433685 0.5016261383127374
parallel_helical 17 43 2.0 25.0 -25.0 0.3 -0.1 22.836092154288245 57.76188015496438
  0.2833333333333333 0.7166666666666667 0.013635466703368727 0.21744283205399903
  0.047281385211663626 66.6026751377495 0.0 20.78125469379419 20.74684451616931 20.74920140114814
  66.59518251037525 66.59560204431862 0.0 20.750177345264156 20.74891271121712 20.74902390760312
  66.595574014918 0.0
spur 17 42 3.0 0.0 0.0 0.4 0.2 17.0 42.0 0.288135593220339 0.711864406779661 0.055880896666873674
  0.0 0.0 90.3 0.0 23.201739534418532 22.645051529295543 22.79882257293718 90.161821648406
  90.19291836200037 0.0 22.761323530956208 22.761323530956208 22.761323530956208 90.1860806407378
  0.0
internal_spur 20 -60 2.0 0.0 0.0 0.2 -0.5 20.0 60.0 -0.5 1.5 0.04121216129181934 0.0 0.0 40.6 0.0
  22.361282906633665 22.05849682134724 22.120179132230202 40.56603115523314 40.57166905419262 0.0
  22.108270266995163 22.108270266995163 22.108270266995163 40.57069277913942 0.0
interference 7 60 2.0 15.0 30.0 -0.2 0.0 7.767239661553654 92.37604307034012 0.07756126471655929
  0.9224387352834407 -0.010974185564937953 0.31304822669020865 0.10289300376624305
  76.12896556562568 45.0 19.371225483535664 19.348576267229806 19.34731893735244
  76.12293530021836 76.12266124607768 44.80654881583935 19.348509320823897 19.347329990116947
  19.347228697586786 76.12264403509523 44.80321701880477
)";

const std::vector<Golden>& golden() {
  static const std::vector<Golden> rows = [] {
    std::vector<Golden> all;
    std::istringstream in(kTable);
    for (Golden g; in >> g.pair >> g.z1 >> g.z2;) {
      for (double* v : {&g.module,       &g.beta1,       &g.beta2,   &g.x1,      &g.x2,
                        &g.virtual1,     &g.virtual2,    &g.weight1, &g.weight2, &g.L,
                        &g.M2,           &g.M4,          &g.a0,      &g.Sigma0,  &g.one_term,
                        &g.two_terms,    &g.three_terms, &g.a_one,   &g.a_two,   &g.Sigma_one,
                        &g.virtual_spur, &g.corrected,   &g.alpha,   &g.a,       &g.Sigma})
        in >> *v;
      EXPECT_TRUE(in) << g.pair;
      all.push_back(g);
    }
    EXPECT_EQ(all.size(), 10u);
    return all;
  }();
  return rows;
}

const Golden& golden(const std::string& pair) {
  for (const Golden& g : golden())
    if (g.pair == pair) return g;
  ADD_FAILURE() << pair;
  std::abort();
}

ReferencePair<double> pair_of(const Golden& g) {
  ReferencePair<double> pair;
  pair[0] = {g.z1, g.module, 20 * kDegree, g.beta1 * kDegree, g.x1, 0.0};
  pair[1] = {g.z2, g.module, 20 * kDegree, g.beta2 * kDegree, g.x2, 0.0};
  return pair;
}

// The relative error of lengths is at most 2e-14, and the error of angles at most 2e-13°. These
// limits and those of the coefficients are a few rounding errors of tan β, even near 80°.
TEST(MinDistanceSeries, golden_values) {
  for (const Golden& g : golden()) {
    const auto s = min_distance_series(pair_of(g));
    const std::string p = g.pair;
    const double big = 1 + std::abs(g.M2);
    EXPECT_NEAR(std::abs(s.virtual_teeth[0]), g.virtual1, 1e-14 * g.virtual1 * big) << p;
    EXPECT_NEAR(std::abs(s.virtual_teeth[1]), g.virtual2, 1e-14 * g.virtual2 * big) << p;
    EXPECT_NEAR(s.weight[0], g.weight1, 1e-14) << p;
    EXPECT_NEAR(s.weight[1], g.weight2, 1e-14) << p;
    EXPECT_NEAR(s.L, g.L, 4e-14 * std::abs(g.L)) << p;
    EXPECT_NEAR(s.M2, g.M2, 2e-14 * big) << p;
    EXPECT_NEAR(s.M4, g.M4, 4e-14 * big * big) << p;
    EXPECT_NEAR(s.rack_center_distance, g.a0, 2e-14 * g.a0) << p;
    EXPECT_NEAR(s.rack_shaft_angle / kDegree, g.Sigma0, 2e-13) << p;
    EXPECT_NEAR(s.pressure_angle(1) / kDegree, g.one_term, 2e-13) << p;
    EXPECT_NEAR(s.pressure_angle(2) / kDegree, g.two_terms, 2e-13) << p;
    EXPECT_NEAR(s.pressure_angle(3) / kDegree, g.three_terms, 2e-13) << p;
    EXPECT_NEAR(s.center_distance(1), g.a_one, 2e-14 * g.a0) << p;
    EXPECT_NEAR(s.center_distance(2), g.a_two, 2e-14 * g.a0) << p;
    EXPECT_NEAR(s.shaft_angle(s.L) / kDegree, g.Sigma_one, 2e-13) << p;
    ASSERT_TRUE(s.virtual_pressure_angle());
    EXPECT_NEAR(*s.virtual_pressure_angle() / kDegree, g.virtual_spur, 2e-13) << p;
    EXPECT_NEAR(*s.corrected_virtual_pressure_angle() / kDegree, g.corrected, 2e-13) << p;
  }
}

// Solves the equation of the least distance for α_n by bisection. The equation sums the involutes
// of the angles α_t with sin α_t = sin α_n/cos β_b. Shaft angle and centre distance follow from
// α_n.
template <class T>
struct Solved {
  T alpha, a, Sigma;
};

template <class T>
T sum_of_involutes(const ReferencePair<T>& pair, const T& alpha_n) {
  T sum(0);
  for (const auto& g : pair) {
    const T base = asin(T(sin(g.helix_angle) * cos(g.normal_pressure_angle)));
    const T s = sin(alpha_n) / cos(base);
    const T alpha_t = asin(s);
    sum += T(g.teeth) * (tan(alpha_t) - alpha_t);
  }
  return sum;
}

template <class T>
Solved<T> by_halving(const ReferencePair<T>& pair) {
  using std::asin;
  const T alpha = pair[0].normal_pressure_angle;
  const T goal = sum_of_involutes(pair, alpha) +
                 2 * (pair[0].profile_shift + pair[1].profile_shift) * tan(alpha);
  const bool external = pair[1].teeth > 0;
  T lo = alpha - T(0.06), hi = alpha + T(0.06);
  for (int i = 0; i < 150; ++i) {
    const T x = (lo + hi) / 2;
    ((sum_of_involutes(pair, x) < goal) == external ? lo : hi) = x;
  }
  Solved<T> out{lo, T(0), T(0)};
  for (int i : {0, 1}) {
    const auto& g = pair[static_cast<std::size_t>(i)];
    const T base = asin(T(sin(g.helix_angle) * cos(alpha)));
    const T alpha_t = asin(T(sin(lo) / cos(base)));
    const T r_b = g.normal_module * std::abs(g.teeth) / cos(g.helix_angle) / 2 *
                  cos(T(atan(T(tan(alpha) / cos(g.helix_angle)))));
    const T beta = asin(T(sin(base) / cos(lo)));
    const T sign = i == 0 && !external ? T(-1) : T(1);
    out.a += sign * r_b / cos(alpha_t);
    out.Sigma += i == 1 && !external ? T(-beta) : beta;
  }
  return out;
}

ReferencePair<Exact> exact_pair(int z1, int z2, double beta1, double beta2, const Exact& sum_x) {
  const Exact degree = Exact(kDegree);
  ReferencePair<Exact> pair;
  pair[0] = {z1, Exact(2), 20 * degree, Exact(beta1) * degree, sum_x * 3 / 4, Exact(0)};
  pair[1] = {z2, Exact(2), 20 * degree, Exact(beta2) * degree, sum_x / 4, Exact(0)};
  return pair;
}

double order(const Exact& coarse, const Exact& fine) {
  return static_cast<double>(log(abs(coarse / fine)) / log(Exact(2)));
}

struct Shape {
  int z1, z2;
  double beta1, beta2;
};
const Shape kShapes[] = {{9, 15, 51.6, 39.4},  {13, 27, -45, -45}, {15, 40, 35, -15},
                         {17, 43, 25, -25},    {17, 42, 0, 0},     {20, -60, 0, 0},
                         {20, -61, 22.5, 22.5}};

// The bisection with 50 digits agrees with the exact solution of the table.
TEST(MinDistanceSeries, exact_solution_of_these_tests) {
  for (const Golden& g : golden()) {
    ReferencePair<Exact> pair;
    const Exact degree = atan(Exact(1)) / 45;
    pair[0] = {g.z1, Exact(g.module), 20 * degree, Exact(g.beta1) * degree, Exact(g.x1), Exact(0)};
    pair[1] = {g.z2, Exact(g.module), 20 * degree, Exact(g.beta2) * degree, Exact(g.x2), Exact(0)};
    const auto s = by_halving(pair);
    EXPECT_NEAR(static_cast<double>(s.alpha / degree), g.alpha, 1e-13) << g.pair;
    EXPECT_NEAR(static_cast<double>(s.a), g.a, 1e-13 * g.a) << g.pair;
    EXPECT_NEAR(static_cast<double>(s.Sigma / degree), g.Sigma, 1e-13 * 90) << g.pair;
  }
}

// If the sum of shifts is halved, the error is divided by 2^p, where p is the order of the first
// omitted term. At Σx = 1e-3, the next term changes p by about L/sin² α, which is below 0.01.
TEST(MinDistanceSeries, errors_fall_with_the_right_power) {
  for (const Shape& shape : kShapes) {
    const bool crossed = shape.beta1 + (shape.z2 > 0 ? 1 : -1) * shape.beta2 != 0;
    for (const double sign : {1.0, -1.0}) {
      Exact alpha[3][2], a[2][2], spur[2][2], Sigma[2];
      for (int i : {0, 1}) {
        const Exact sum_x = Exact(sign) / (i == 0 ? 1000 : 2000);
        const auto pair = exact_pair(shape.z1, shape.z2, shape.beta1, shape.beta2, sum_x);
        const auto exact = by_halving(pair);
        const auto s = min_distance_series(pair);
        for (int n = 1; n <= 3; ++n) alpha[n - 1][i] = s.pressure_angle(n) - exact.alpha;
        for (int n = 1; n <= 2; ++n) a[n - 1][i] = s.center_distance(n) - exact.a;
        Sigma[i] = s.shaft_angle(s.L) - exact.Sigma;
        spur[0][i] = *s.virtual_pressure_angle() - exact.alpha;
        spur[1][i] = *s.corrected_virtual_pressure_angle() - exact.alpha;
      }
      const std::string what = ::testing::PrintToString(std::pair{shape.z1, shape.z2});
      for (int n = 1; n <= 3; ++n)
        EXPECT_NEAR(order(alpha[n - 1][0], alpha[n - 1][1]), n + 1, 0.01) << what << n;
      for (int n = 1; n <= 2; ++n)
        EXPECT_NEAR(order(a[n - 1][0], a[n - 1][1]), n + 2, 0.01) << what << n;
      if (crossed) {
        EXPECT_NEAR(order(Sigma[0], Sigma[1]), 2, 0.01) << what;
      } else {  // parallel axes remain parallel
        EXPECT_EQ(Sigma[0], 0) << what;
      }
      if (shape.beta1 == 0) {  // the gears are spur gears, so the virtual pair equals the pair
        EXPECT_LT(abs(spur[0][0]), Exact(1e-40)) << what;
      } else {
        EXPECT_NEAR(order(spur[0][0], spur[0][1]), 2, 0.01) << what;
        EXPECT_NEAR(order(spur[1][0], spur[1][1]), 3, 0.01) << what;
      }
    }
  }
}

// For the helix angle on another rack, the error of n terms is O(Δ^(n + 1)).
TEST(MinDistanceSeries, helix_angle_terms) {
  const auto s = min_distance_series(exact_pair(9, 15, 51.6, 39.4, Exact(0)));
  for (int gear : {0, 1}) {
    const Exact beta = s.helix[static_cast<std::size_t>(gear)];
    for (int n = 1; n <= 3; ++n) {
      Exact error[2];
      for (int i : {0, 1}) {
        const Exact delta = Exact(1) / (i == 0 ? 100000 : 200000);
        const Exact exact = asin(Exact(sin(beta) * cos(s.alpha) / cos(Exact(s.alpha + delta))));
        error[i] = s.helix_angle(gear, delta, n) - exact;
      }
      EXPECT_NEAR(order(error[0], error[1]), n + 1, 1e-3) << gear << n;
    }
    EXPECT_EQ(s.helix_angle(gear, Exact(0), 3), beta);
  }
}

// The example 9/15 of the paper, from its Tab. 1. The expected values follow from the corrected
// equations of the paper for these data. The paper prints 18°42′33″, 50.014 and 90°01′04″ for three
// terms, 18°43′18″, 50.022 and 90°01′34″ for virtual teeth, and 18°42′20″ for the corrected value
// (docs/theory, page 5).
TEST(MinDistanceSeries, example_of_the_paper) {
  const Golden& g = golden("paper_9_15");
  const auto s = min_distance_series(pair_of(g));
  const double S[] = {std::sin(47.408 * kDegree), std::sin(36.595 * kDegree)};
  const double d_b[] = {37.4892228898867, 52.6687933717901};
  // Sums of the pitch radii and helix angles with which the gears roll on a rack of this angle,
  // column "c" of the table.
  const auto pitch_sum = [&](double alpha) {
    double sum = 0;
    for (int i : {0, 1}) {
      const double c_b = std::sqrt(1 - S[i] * S[i]);
      sum += d_b[i] / 2 * c_b / std::sqrt(std::pow(std::cos(alpha), 2) - S[i] * S[i]);
    }
    return sum;
  };
  const auto helix_sum = [&](double alpha) {
    return (std::asin(S[0] / std::cos(alpha)) + std::asin(S[1] / std::cos(alpha))) / kDegree;
  };
  const double three = s.pressure_angle(3);
  EXPECT_NEAR(three / kDegree, 18.703855112110833, 1e-9);
  EXPECT_NEAR(pitch_sum(three), 50.010974899057224, 1e-9);
  EXPECT_NEAR(helix_sum(three), 90.01385326079942, 1e-9);
  const double spur = *s.virtual_pressure_angle();
  EXPECT_NEAR(spur / kDegree, 18.720955204826822, 1e-9);
  EXPECT_NEAR(pitch_sum(spur), 50.021221346874135, 1e-9);
  EXPECT_NEAR(helix_sum(spur), 90.02570080716839, 1e-9);
  EXPECT_NEAR(*s.corrected_virtual_pressure_angle() / kDegree, 18.705174053191552, 1e-9);
  // The last column of the table prints 89°59′01″. This is Σ to first order, with the Δ of the
  // virtual pair.
  EXPECT_NEAR(s.shaft_angle(spur - s.alpha) / kDegree, 89 + 59 / 60.0 + 2.967 / 3600, 1e-6);
  EXPECT_NEAR(s.shaft_angle(s.L) / kDegree, 90 + 2 / 60.0 + 58.42 / 3600, 2e-6);
  // A tenth of a minute in α_n changes the pitch radii by micrometres, but not the least distance,
  // because a(α) is stationary there.
  EXPECT_NEAR(s.center_distance(2), g.a, 3e-4);
}

TEST(MinDistanceSeries, allowances_count_as_shifts) {
  ReferencePair<double> plain = pair_of(golden("crossed90_lefthand"));
  ReferencePair<double> thinned = plain;
  thinned[0].thickness_allowance = -0.04;
  plain[0].profile_shift -= 0.04 / (2 * 1.5 * std::tan(20 * kDegree));
  EXPECT_NEAR(min_distance_series(thinned).L, min_distance_series(plain).L, 1e-17);
}

TEST(MinDistanceSeries, no_virtual_pair_without_backlash_is_nothing) {
  auto pair = pair_of(golden("spur"));
  pair[0].profile_shift = -2.0;
  EXPECT_FALSE(min_distance_series(pair).virtual_pressure_angle());
  EXPECT_FALSE(min_distance_series(pair).corrected_virtual_pressure_angle());
}

// (1) doubling the module doubles the distance and leaves the angles unchanged, exactly
// (2) the mirror image has the opposite shaft angle and otherwise equal values
// (3) the gears may be exchanged
TEST(MinDistanceSeries, laws) {
  for (const Golden& g : golden()) {
    const auto pair = pair_of(g);
    const auto s = min_distance_series(pair);
    auto doubled = pair;
    auto mirrored = pair;
    for (auto& gear : doubled) gear.normal_module *= 2;
    for (auto& gear : mirrored) gear.helix_angle = -gear.helix_angle;
    const auto d = min_distance_series(doubled);
    EXPECT_EQ(d.center_distance(2), 2 * s.center_distance(2));  // (1)
    EXPECT_EQ(d.pressure_angle(3), s.pressure_angle(3));
    const auto m = min_distance_series(mirrored);
    EXPECT_EQ(m.center_distance(2), s.center_distance(2));  // (2)
    EXPECT_EQ(m.pressure_angle(3), s.pressure_angle(3));
    EXPECT_EQ(m.shaft_angle(m.L), -s.shaft_angle(s.L));
    if (g.z2 < 0) continue;
    const auto e = min_distance_series(ReferencePair<double>{pair[1], pair[0]});
    EXPECT_NEAR(e.center_distance(2), s.center_distance(2), 1e-14 * g.a0);  // (3)
    EXPECT_NEAR(e.pressure_angle(3), s.pressure_angle(3), 1e-14);
    EXPECT_EQ(e.shaft_angle(e.L), s.shaft_angle(s.L));
  }
}

}  // namespace
}  // namespace gearwright
