# Finds header-only libraries on this system for a build for another system.
#
# The include folder of this system must not be on the path of such a compiler, because its C library
# is different. Therefore a folder in the build contains links to the folders of the libraries, and
# targets have the names that Debian uses.
include_guard()

set(gw_links ${PROJECT_BINARY_DIR}/include)

# Links `folder` of the system's headers, which must contain `header`.
function(gw_link_headers folder header package)
  find_path(found ${header} PATHS /usr/include /usr/include/eigen3 NO_DEFAULT_PATH
            NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
  if(NOT found)
    message(FATAL_ERROR "${header} not found (Debian: ${package})")
  endif()
  file(MAKE_DIRECTORY ${gw_links})
  file(CREATE_LINK ${found}/${folder} ${gw_links}/${folder} SYMBOLIC)
endfunction()

macro(gw_system_headers)
  gw_link_headers(Eigen Eigen/Geometry libeigen3-dev)
  gw_link_headers(boost boost/version.hpp libboost-dev)
  gw_link_headers(nlohmann nlohmann/json.hpp nlohmann-json3-dev)
  gw_link_headers(toml++ toml++/toml.h libtomlplusplus-dev)
  gw_link_headers(CLI CLI/CLI.hpp libcli11-dev)
  foreach(name Eigen3::Eigen Boost::headers nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus
          CLI11::CLI11)
    add_library(${name} INTERFACE IMPORTED)
    target_include_directories(${name} SYSTEM INTERFACE ${gw_links})
  endforeach()
  set(CLI11_FOUND ON)
endmacro()
