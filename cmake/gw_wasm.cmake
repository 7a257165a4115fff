# The build for WebAssembly: emscripten 3.1.6, preset `wasm`. Included in place of the search for
# packages, which for a foreign machine would find none: all that is needed here are headers.
#
# The system's include folder must not be on emcc's path, its C library is another. So a folder in
# the build holds links to the libraries' own folders, and targets have the names that Debian's have.
include_guard()

if(NOT GEARWRIGHT_LEAN)
  message(FATAL_ERROR "A build for WebAssembly is lean: GEARWRIGHT_LEAN=ON")
endif()

set(gw_links ${PROJECT_BINARY_DIR}/include)
set(gw_found "")
# Links `folder` of the system's headers, where `header` must lie below.
function(gw_link_headers folder header package)
  find_path(found ${header} PATHS /usr/include /usr/include/eigen3 NO_DEFAULT_PATH
            NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
  if(NOT found)
    message(FATAL_ERROR "${header} not found (Debian: ${package})")
  endif()
  file(MAKE_DIRECTORY ${gw_links})
  file(CREATE_LINK ${found}/${folder} ${gw_links}/${folder} SYMBOLIC)
endfunction()
gw_link_headers(Eigen Eigen/Geometry libeigen3-dev)
gw_link_headers(boost boost/version.hpp libboost-dev)
gw_link_headers(fmt fmt/format.h libfmt-dev)
gw_link_headers(nlohmann nlohmann/json.hpp nlohmann-json3-dev)
gw_link_headers(toml++ toml++/toml.h libtomlplusplus-dev)
gw_link_headers(CLI CLI/CLI.hpp libcli11-dev)
gw_link_headers(stb stb/stb_image_write.h libstb-dev)

foreach(name Eigen3::Eigen Boost::headers fmt::fmt nlohmann_json::nlohmann_json
        tomlplusplus::tomlplusplus CLI11::CLI11)
  add_library(${name} INTERFACE IMPORTED)
  target_include_directories(${name} SYSTEM INTERFACE ${gw_links})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
set(CLI11_FOUND ON)
set(gw_libraries "")

# Refusals throw: without this no catch block runs. No -msimd128: clang 14 puts the complex products of
# contact/sensitivity.cpp into lanes wrongly (∂TE/∂f_Hβ1 of a helical pair -0.0011 instead of 0.0119), and
# what is hot here is scalar anyway.
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

# One memory that grows: meshes of large gears take hundreds of MB. The stack is for specs that nest.
set(gw_memory -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB -sINITIAL_MEMORY=32MB -sTOTAL_STACK=4MB)

# A program under node, with the machine's files.
set(gw_under_node -sNODERAWFS -sENVIRONMENT=node -sEXIT_RUNTIME
    "SHELL:--pre-js ${CMAKE_CURRENT_LIST_DIR}/wasm_node.js")

# emcc's optimiser needs acorn, which is not where a node that is not Debian's looks.
execute_process(COMMAND dpkg -L node-acorn OUTPUT_VARIABLE files ERROR_QUIET)
if(files MATCHES "([^\n]*)/acorn/package\\.json")
  set(gw_node_path ${CMAKE_MATCH_1})
  set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=${gw_node_path}")
endif()

set(GEARWRIGHT_MPI OFF)
set(why_no_mpi "not in a browser")
set(GEARWRIGHT_BENCH OFF)
set(GEARWRIGHT_PYTHON OFF)
set(why_no_python "not in a browser")
find_program(GEARWRIGHT_PYTHON_EXECUTABLE python3 HINTS /usr/bin NO_CMAKE_ENVIRONMENT_PATH
             NO_CMAKE_FIND_ROOT_PATH DOC "Python that runs the script tests")
