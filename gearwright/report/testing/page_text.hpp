// Functions that examine the text of a page, a section or a figure, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright::testing {

/// Wraps a piece of a page into a page that the strict reader accepts.
inline std::string as_page(const std::string& piece) { return "<!DOCTYPE html>\n" + piece; }

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

inline std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

/// Checks that the text is well-formed HTML and that every number is finite. Ids that begin with
/// `elsewhere` may be defined in another part of the page.
inline void expect_sound_figure(const std::string& figure, const std::string& elsewhere = "") {
  for (const std::string& fault : StrictHtml::read(as_page(figure)).faults) {
    if (elsewhere.empty() || fault.rfind("no such id: " + elsewhere, 0) != 0)
      ADD_FAILURE() << fault;
  }
  EXPECT_FALSE(has(figure, "nan"));
  EXPECT_FALSE(has(figure, "inf"));
}

}  // namespace gearwright::testing
