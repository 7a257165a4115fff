# Settings of the build for WebAssembly (emscripten 3.1.6, preset `wasm`). They replace the search for
# packages, because this system has no packages for WebAssembly. Only header libraries are used.
include_guard()

if(NOT GEARWRIGHT_LEAN)
  message(FATAL_ERROR "A build for WebAssembly is lean: GEARWRIGHT_LEAN=ON")
endif()

include(gw_system_headers)
gw_system_headers()
gw_link_headers(fmt fmt/format.h libfmt-dev)
gw_link_headers(stb stb/stb_image_write.h libstb-dev)
set(gw_libraries "")

# Some errors are exceptions. Without this option, no catch block would run. -msimd128 is not used, because
# clang 14 compiles vectors wrongly, both its own and those of Eigen (SSE2 with -fno-vectorize: ∂TE/∂f_Hβ1 of a
# spur pair -2.29 instead of 5.73, and wrong ends of contact lines). The time-critical code is scalar anyway.
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

add_library(gw_fmt STATIC ${CMAKE_CURRENT_LIST_DIR}/fmt.cpp)
target_include_directories(gw_fmt SYSTEM PUBLIC ${gw_links})
add_library(fmt::fmt INTERFACE IMPORTED)
target_link_libraries(fmt::fmt INTERFACE gw_fmt)

# The memory can grow, because meshes of large gears need hundreds of MB. The stack is large enough
# for deeply nested specs.
set(gw_memory -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB -sINITIAL_MEMORY=32MB -sTOTAL_STACK=4MB)

# Options for a program that runs under node and reads and writes files of the machine.
set(gw_under_node -sNODERAWFS -sENVIRONMENT=node -sEXIT_RUNTIME
    "SHELL:--pre-js ${CMAKE_CURRENT_LIST_DIR}/wasm_node.js")

# The optimiser of emcc needs the module acorn, which only Debian's own node finds by itself.
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
