#include "gearwright/job/search_files.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "gearwright/base/output_file.hpp"
#include "gearwright/design/search.hpp"

namespace gearwright {
namespace {

ChunkFinds some_finds() {
  SearchProblem p;
  p.ratio = {1.9, 2.1};
  p.center_distance = {{99.0, 101.0}};
  p.modules = {2.0, 2.5};
  p.pinion_teeth = {20, 40};
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  p.shift_step = 0.02;
  const Search search(p);
  ChunkFinds finds;
  search.range(0, *search.space().size(), finds.designs, {.points = &finds.points});
  return finds;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(SearchRecord, WhatWasPackedComesBackBitForBit) {
  ChunkFinds finds = some_finds();
  ASSERT_GT(finds.designs.size(), 10u);
  ASSERT_GT(finds.points.size(), 10'000u);
  finds.designs[3].sliding[1][0] = std::nullopt;  // beyond a base tangent point
  finds.designs[4].trial.z2 = -61;
  finds.designs[5].area = -0.0;
  finds.points[7].sliding = std::nullopt;
  const ChunkFinds back = unpack(pack(finds), "here");
  ASSERT_EQ(back.designs.size(), finds.designs.size());
  ASSERT_EQ(back.points.size(), finds.points.size());
  for (std::size_t i = 0; i < finds.designs.size(); ++i) {
    const DesignRow& a = finds.designs[i];
    const DesignRow& b = back.designs[i];
    EXPECT_EQ(a.trial.index, b.trial.index);
    EXPECT_EQ(a.trial.z2, b.trial.z2);
    EXPECT_EQ(a.balanced, b.balanced);
    EXPECT_EQ(a.sliding, b.sliding);
    EXPECT_EQ(a.hi, b.hi);
    EXPECT_TRUE(same_bits(a.area, b.area));
    EXPECT_TRUE(same_bits(a.backlash_normal, b.backlash_normal));
  }
  for (std::size_t i = 0; i < finds.points.size(); ++i) {
    EXPECT_EQ(finds.points[i].trial, back.points[i].trial);
    EXPECT_EQ(finds.points[i].shift, back.points[i].shift);
    EXPECT_EQ(finds.points[i].sliding, back.points[i].sliding);
    EXPECT_EQ(finds.points[i].tip_clearance, back.points[i].tip_clearance);
  }
}

TEST(SearchRecord, NothingIsSomethingToo) {
  const ChunkFinds back = unpack(pack({}), "here");
  EXPECT_TRUE(back.designs.empty());
  EXPECT_TRUE(back.points.empty());
}

TEST(SearchRecord, TheSameFindsGiveTheSameBytes) {
  const ChunkFinds finds = some_finds();
  EXPECT_EQ(pack(finds), pack(finds));
}

TEST(SearchRecord, BytesOfAnythingElseAreRefused) {
  EXPECT_THROW(unpack("", "here"), IoError);
  EXPECT_THROW(unpack("no frame of the compressor", "here"), IoError);
  std::string bytes = pack(some_finds());
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(unpack(bytes, "here"), IoError);
}

}  // namespace
}  // namespace gearwright
