// Blocks of documents that are generated from the catalogue. A test compares each block with the
// document. If GW_WRITE_DOCS is set, the test writes the block instead.
//
//   <!-- keys: pair -->
//   | key | …
//   <!-- end -->
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"

namespace gearwright {

inline std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

/// Returns the text of a file below the source folder, or "" if the file does not exist.
inline std::string document(const std::string& path) {
  std::ifstream file(testing::source_file(path));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_document(const std::string& path, const std::string& text) {
  std::ofstream(testing::source_file(path)) << text;
}

inline bool documents_are_written() { return std::getenv("GW_WRITE_DOCS") != nullptr; }

/// Expects the file to equal `made`, or writes `made` to the file.
inline void expect_document(const std::string& path, const std::string& made) {
  if (documents_are_written()) write_document(path, made);
  EXPECT_EQ(document(path), made) << path
                                  << " is not what the catalogue says: write it anew with "
                                     "GW_WRITE_DOCS=1";
}

/// Returns the names of all blocks of one kind, for example of the kind "keys", in a document.
inline std::vector<std::string> blocks_of(const std::string& path, const std::string& kind) {
  const std::string text = document(path);
  const std::string begin = "<!-- " + kind + ": ";
  std::vector<std::string> names;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    names.push_back(text.substr(at, text.find(" -->", at) - at));
  }
  return names;
}

/// Expects the block <!-- kind: name --> to equal `made`, whose lines end with a line feed.
inline void expect_block(const std::string& path, const std::string& kind, const std::string& name,
                         const std::string& made) {
  std::string text = document(path);
  const std::string begin = "<!-- " + kind + ": " + name + " -->\n";
  const std::string end = "<!-- end -->";
  const std::size_t from = text.find(begin);
  ASSERT_NE(from, std::string::npos) << path << " has no block " << begin;
  const std::size_t first = from + begin.size();
  const std::size_t last = text.find(end, first);
  ASSERT_NE(last, std::string::npos) << path << ": the block " << name << " has no end";
  if (documents_are_written()) {
    write_document(path, text.replace(first, last - first, made));
    return;
  }
  EXPECT_EQ(text.substr(first, last - first), made)
      << path << ", block " << name << ": write it anew with GW_WRITE_DOCS=1";
}

}  // namespace gearwright
