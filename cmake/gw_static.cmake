# The target `gearwright_static` is the same program, linked statically, so that it runs on any
# Linux for x86-64. Only tools/dist.sh builds it.
#
# It contains the same objects as the program that the tests run, so nothing is compiled again. Its
# libraries come from tools/portable_libraries.sh, because Debian's packages contain no static
# oneTBB, Highway, fmt and toml++.
include_guard()

if(NOT has_cli OR GEARWRIGHT_LEAN OR CMAKE_CROSSCOMPILING OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR
   NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  return()
endif()

set(gw_portable ${PROJECT_SOURCE_DIR}/build/portable)
add_executable(gearwright_static EXCLUDE_FROM_ALL $<TARGET_OBJECTS:gearwright_cli>
               $<TARGET_OBJECTS:gearwright_apps>)
set_target_properties(gearwright_static PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME gearwright
                      RUNTIME_OUTPUT_DIRECTORY ${gw_portable}/linux-x86_64)
add_dependencies(gearwright_static gearwright)
target_link_libraries(gearwright_static PRIVATE $<TARGET_FILE:gearwright>)
foreach(library fmt tomlplusplus z tbb hwy zstd sqlite3)
  target_link_libraries(gearwright_static PRIVATE ${gw_portable}/libraries/linux-x86_64/lib/lib${library}.a)
endforeach()
target_link_libraries(gearwright_static PRIVATE ${gw_elementary_file})
target_link_options(gearwright_static PRIVATE -static -s LINKER:-Map=${gw_portable}/linux-x86_64/gearwright.map)
