#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(FacePicture, SaysWhatLiesBeyondTheFaces) {
  EXPECT_NE(
      face_use_figure(testing::crossed_pair()).caption.find("Both lines lie within both faces."),
      std::string::npos);
  const CrossedPair askew = testing::nearly_parallel_pair();
  const std::string text = face_use_figure(askew).caption;
  const double more = (askew.face_widths.both_flanks[0] - 20.0) / 2;
  char words[80];
  std::snprintf(words, sizeof words, "The lines of gear 1 reach %.2f mm beyond the face.", more);
  EXPECT_NE(text.find(words), std::string::npos) << words;
  EXPECT_EQ(text.find("Both faces"), std::string::npos);
}

TEST(FacePicture, EqualFacesShareALine) {
  const auto labels = [](const CrossedPair& pair) {
    const std::string text = figure_html(face_width_figure(pair));
    std::size_t n = 0;
    for (std::size_t at = text.find("\"face-line"); at != text.npos;
         at = text.find("\"face-line", at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(labels(testing::crossed_pair()), 1u);
  const CrossedPair unequal = testing::crossed_sample_pair(
      testing::gear_as_itself(9, 37.4892228898867, 7.263, 47.408, 46.65, 15),
      testing::gear_as_itself(15, 52.6687933717901, 7.618, 36.595, 65.27, 12), 90);
  EXPECT_EQ(labels(unequal), 2u);
}

TEST(FacePicture, WithoutContactThereAreNoDots) {
  EXPECT_EQ(figure_html(face_width_figure(testing::crossed_apart())).find("The dots show"),
            std::string::npos);
  EXPECT_NE(figure_html(face_width_figure(testing::crossed_pair())).find("The dots show"),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
