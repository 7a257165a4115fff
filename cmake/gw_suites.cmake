# Writes a file for CTest with one test for each suite of a program of GoogleTest. All tests of a suite run in one
# process, so that they can share what they compute, and the program starts once for each suite.
#
# Tests whose suite or name starts with "Long" are tests of their own, with the label `long`.
#
#   cmake -DPROGRAM=<path> -DSET=<name> -DINTO=<file> -P gw_suites.cmake
cmake_minimum_required(VERSION 3.25)
set(long "Long*:*.Long*:*/Long*")

# Sets `out` to the suites with a test that matches the filter.
function(gw_list_suites filter out)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE lines
                  COMMAND_ERROR_IS_FATAL ANY)
  # A comment contains the value of a parameter, with any characters.
  string(REGEX REPLACE " *#[^\n]*" "" lines "${lines}")
  string(REGEX MATCHALL "[^\n]+" lines "${lines}")
  list(FILTER lines INCLUDE REGEX "^[^ ]+\\.$")
  list(TRANSFORM lines REPLACE "\\.$" "")
  set(${out} ${lines} PARENT_SCOPE)
endfunction()

function(gw_add_suite name filter properties)
  file(APPEND ${INTO}.new "add_test(${SET}:${name} \"${PROGRAM}\" --gtest_brief=1 \"--gtest_filter=${filter}\")\n"
       "set_tests_properties(${SET}:${name} PROPERTIES ${properties})\n")
endfunction()

# Most suites of unit_tests are short. They start last, so that two processors finish at nearly the same time.
set(cost 5)
if(SET STREQUAL "unit_tests")
  set(cost 0)
endif()

file(WRITE ${INTO}.new "")
gw_list_suites("-${long}" short_suites)
foreach(suite IN LISTS short_suites)
  gw_add_suite(${suite} "${suite}.*-${long}" "LABELS ${SET} TIMEOUT 1800 COST ${cost}")
endforeach()
gw_list_suites("${long}" long_suites)
foreach(suite IN LISTS long_suites)
  if(suite IN_LIST short_suites)
    gw_add_suite(${suite}.Long "${suite}.Long*:${suite}.*/Long*" "LABELS long TIMEOUT 3600")
  else()
    gw_add_suite(${suite} "${suite}.*" "LABELS long TIMEOUT 3600")
  endif()
endforeach()
file(RENAME ${INTO}.new ${INTO})
