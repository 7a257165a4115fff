# Run at install time: copies the public headers, which show the standard library, Eigen and our own,
# and the texts (.inc) that they include.
#
# A header that includes anything else serves our own sources only and stays here, as do one whose
# comment says "Internal to ..." and those of tests. That no public header needs one of those,
# tests/consumer compiles and so proves.
#
#   gw_source       the source folder             gw_headers_to   include folder under the prefix
file(GLOB_RECURSE headers RELATIVE ${gw_source} ${gw_source}/gearwright/*.hpp
     ${gw_source}/gearwright/*.inc)
foreach(header IN LISTS headers)
  if(header MATCHES "/testing/")
    continue()
  endif()
  # <vector> and <Eigen/Core> are public; <boost/...>, <fmt/...>, <gp_Pnt.hxx>, <toml++/toml.h> are not.
  file(STRINGS ${gw_source}/${header} foreign REGEX "^ *# *include +<[^>]*[./][^>]*>")
  list(FILTER foreign EXCLUDE REGEX "<Eigen/|<unsupported/Eigen/")
  file(STRINGS ${gw_source}/${header} internal REGEX "^//.* Internal to ")
  if(foreign OR internal)
    message(STATUS "Kept inside: ${header}")
    continue()
  endif()
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${gw_source}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/${gw_headers_to}/${folder})
endforeach()
