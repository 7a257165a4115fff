# Determines the public headers: those that expose only the standard library, Eigen and our own
# types.
#
# Private headers are those that include anything else, those whose comment contains "Internal to ..."
# and those of tests. tests/consumer compiles the public headers, which checks that none of them
# needs a private header. The install step uses this file, and the documents
# use it as a script:
#
#   cmake -P cmake/gw_public_headers.cmake     prints their paths, one per line

function(gw_public_headers out kept_out source)
  file(GLOB_RECURSE headers RELATIVE ${source} ${source}/gearwright/*.hpp
       ${source}/gearwright/*.inc)
  set(public "")
  set(kept "")
  foreach(header IN LISTS headers)
    if(header MATCHES "/testing/")
      continue()
    endif()
    # <vector> and <Eigen/Core> are public; <boost/...>, <fmt/...>, <gp_Pnt.hxx>, <toml++/toml.h> are not.
    file(STRINGS ${source}/${header} foreign REGEX "^ *# *include +<[^>]*[./][^>]*>")
    list(FILTER foreign EXCLUDE REGEX "<Eigen/|<unsupported/Eigen/")
    file(STRINGS ${source}/${header} internal REGEX "^//.* Internal to ")
    if(foreign OR internal)
      list(APPEND kept ${header})
    else()
      list(APPEND public ${header})
    endif()
  endforeach()
  set(${out} "${public}" PARENT_SCOPE)
  set(${kept_out} "${kept}" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  get_filename_component(gw_root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
  gw_public_headers(gw_public gw_kept ${gw_root})
  list(JOIN gw_public "\n" gw_lines)
  execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${gw_lines}")  # message() writes to stderr
endif()
