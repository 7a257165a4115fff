# Precompiled headers: what nearly every source includes is parsed once.
#
# Measured with g++ 12: making one takes 5 s, loading it 0.15 s, parsing the same headers 1.2 s a source.
# <complex>, <filesystem> and nlohmann/json.hpp stay out of the first: they cost every source more than they save
# some.
# A source includes what it uses all the same: the presets of clang build without.
#
# A compiler takes a precompiled header only where every macro of its making is defined too. So the
# owners below define next to nothing, and what uses one may define more.
include_guard()

set(gw_precompiled_headers
  <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <memory> <numbers> <optional> <span>
  <string> <string_view> <utility> <vector> <Eigen/Geometry> <fmt/format.h>)

# Makes a precompiled header NAME of the list above and more, with what LIBRARIES want.
function(gw_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  gw_target(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen fmt::fmt ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${gw_precompiled_headers} ${arg_HEADERS})
endfunction()

gw_precompiled(gw_precompiled)

# Of the rooms spec and job, whose sources nearly all read JSON and a spec or what was solved of it: a
# third of their time, for 11 s of making the header.
gw_precompiled(gw_precompiled_answers
  HEADERS <filesystem> <map> <nlohmann/json.hpp> "${PROJECT_SOURCE_DIR}/gearwright/job/solved_job.hpp"
  LIBRARIES nlohmann_json::nlohmann_json)
# Not from a cache of objects: `#pragma once` goes by a file's time, so that one made for another checkout
# of the same text has its headers twice.
set_target_properties(gw_precompiled_answers PROPERTIES CXX_COMPILER_LAUNCHER "")
