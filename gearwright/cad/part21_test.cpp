#include "gearwright/cad/part21.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

namespace gearwright {
namespace {

std::string real(double value) {
  std::string text;
  append_real(text, value);
  return text;
}

TEST(Part21, RealsHaveAPointAndACapitalE) {
  EXPECT_EQ(real(0.0), "0.");
  EXPECT_EQ(real(-0.0), "0.");
  EXPECT_EQ(real(-12.5), "-12.5");
  EXPECT_EQ(real(1e300), "1.E+300");
  EXPECT_EQ(real(-1.5e-7), "-1.5E-07");
  EXPECT_EQ(real(1e-7), "1.E-07");
  EXPECT_EQ(real(123456.0), "123456.");
}

TEST(Part21, RealsReadBackToTheSameDouble) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-300, 300);
  for (int i = 0; i < 20'000; ++i) {
    const double value = std::ldexp(mantissa(random), i % 2 ? exponent(random) : 7);
    const std::string text = real(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_NE(text.find('.'), std::string::npos) << text;
  }
  using Limits = std::numeric_limits<double>;
  for (const double value : {Limits::min(), Limits::denorm_min(), Limits::max(), 0.1, 1.0 / 3})
    EXPECT_EQ(std::strtod(real(value).c_str(), nullptr), value);
}

TEST(Part21, TextIsEscaped) {
  EXPECT_EQ(part21_string(""), "''");
  EXPECT_EQ(part21_string("gear 1"), "'gear 1'");
  EXPECT_EQ(part21_string("it's a \\ b"), "'it''s a \\\\ b'");
  EXPECT_EQ(part21_string("Zahnr\u00e4der"), "'Zahnr\\X2\\00E4\\X0\\der'");
  EXPECT_EQ(part21_string("\u03b1\u03b2"), "'\\X2\\03B103B2\\X0\\'");
  EXPECT_EQ(part21_string("\u03b1\U0001F527x"), "'\\X2\\03B1\\X0\\\\X4\\0001F527\\X0\\x'");
  EXPECT_EQ(part21_string("a\nb\x7f"), "'a\\X2\\000A\\X0\\b\\X2\\007F\\X0\\'");
}

TEST(Part21, BytesThatAreNoTextAreReplaced) {
  const std::string unknown = "\\X2\\FFFD\\X0\\";
  EXPECT_EQ(part21_string("a\xFFz"), "'a" + unknown + "z'");
  EXPECT_EQ(part21_string("\xC3"), "'" + unknown + "'");                   // truncated sequence
  EXPECT_EQ(part21_string("\xC0\x80"), "'\\X2\\FFFDFFFD\\X0\\'");          // overlong
  EXPECT_EQ(part21_string("\xED\xA0\x80"), "'\\X2\\FFFDFFFDFFFD\\X0\\'");  // a surrogate
  EXPECT_EQ(part21_string("\xF4\x90\x80\x80"), "'\\X2\\FFFDFFFDFFFDFFFD\\X0\\'");
}

TEST(Part21, InstancesAreNumberedInOrder) {
  Part21 file("FILE_DESCRIPTION((''),'2;1');\n");
  const Part21Id origin = file.point({0.0, -1.5, 2e-5});
  const Part21Id z = file.direction(Vec3::UnitZ());
  EXPECT_EQ(file.placement(origin, z, z), 3u);
  std::string list;
  append_ids(list, {1, 2, 3});
  append_reals(list, {0.0, 0.5});
  append_integers(list, {6, 1, 6});
  EXPECT_EQ(list, "(#1,#2,#3)(0.,0.5)(6,1,6)");
  EXPECT_EQ(std::move(file).finish(),
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n"
            "#1=CARTESIAN_POINT('',(0.,-1.5,2.E-05));\n"
            "#2=DIRECTION('',(0.,0.,1.));\n"
            "#3=AXIS2_PLACEMENT_3D('',#1,#2,#2);\n"
            "ENDSEC;\nEND-ISO-10303-21;\n");
}

}  // namespace
}  // namespace gearwright
