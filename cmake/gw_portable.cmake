# Builds a program that runs without any package. Every library is linked statically.
#
# GEARWRIGHT_LIBRARIES is the folder with the libraries for the target, which
# tools/portable_libraries.sh compiles from Debian's sources. Header-only libraries come from this
# system.
include_guard()
include(gw_system_headers)
gw_system_headers()

set(CMAKE_PREFIX_PATH ${GEARWRIGHT_LIBRARIES})
set(CMAKE_FIND_ROOT_PATH ${GEARWRIGHT_LIBRARIES})
set(BUILD_SHARED_LIBS OFF)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED CONFIG PATHS ${GEARWRIGHT_LIBRARIES} NO_DEFAULT_PATH)
foreach(library fmt hwy z zstd sqlite3 elementary)
  add_library(gw_${library} STATIC IMPORTED)
  set_target_properties(gw_${library} PROPERTIES
    IMPORTED_LOCATION ${GEARWRIGHT_LIBRARIES}/lib/lib${library}.a
    INTERFACE_INCLUDE_DIRECTORIES ${GEARWRIGHT_LIBRARIES}/include)
endforeach()
add_library(fmt::fmt ALIAS gw_fmt)
set(gw_elementary gw_elementary)
set(gw_why_elementary "of musl's sources")
set(gw_libraries gw_z TBB::tbb Threads::Threads gw_hwy gw_zstd gw_sqlite3)
file(GLOB_RECURSE gw_lanes ${PROJECT_SOURCE_DIR}/gearwright/*_simd.cpp)
# Highway compiles these files once for each instruction set and chooses one at run time.
if(WIN32)
  add_link_options(LINKER:--wrap=mbrtowc)  # base/system_windows.cpp
  add_link_options(LINKER:--no-insert-timestamp)  # the same input gives the same bytes
  add_link_options(LINKER:--exclude-all-symbols)  # oneTBB would export its functions from the program
  # g++ aligns the stack on Windows to 16 bytes and moves wider vectors as if it were aligned to their
  # size (GCC bug 54412). The assembler replaces these moves by moves that permit any alignment.
  set_source_files_properties(${gw_lanes} PROPERTIES COMPILE_OPTIONS -Wa,-muse-unaligned-vector-move)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  # NEON is the only instruction set used, because every 64-bit ARM processor has it. SVE vectors cannot
  # be members of the struct `Lane` (math/lanes.inc), because their size is unknown at compile time. On
  # most processors with SVE they have 128 bits, like NEON vectors.
  set_source_files_properties(${gw_lanes} PROPERTIES COMPILE_DEFINITIONS HWY_COMPILE_ONLY_STATIC)
  # Highway's NEON includes AES, which the compiler never uses by itself. Without these
  # options, the compiler would generate the constructor of an array of lanes for another instruction set.
  set_source_files_properties(${gw_lanes} PROPERTIES COMPILE_OPTIONS "-march=armv8-a+crypto;-Wno-invalid-pch")
endif()
# tools/sbom.py reads the map, which lists the archives whose members the program contains.
add_link_options(-static -s LINKER:-Map=${PROJECT_BINARY_DIR}/gearwright.map)

set(GEARWRIGHT_MPI OFF)
set(why_no_mpi "not in a portable build")
set(GEARWRIGHT_PYTHON OFF)
set(why_no_python "not in a portable build")
find_program(GEARWRIGHT_PYTHON_EXECUTABLE python3 HINTS /usr/bin NO_CMAKE_ENVIRONMENT_PATH
             NO_CMAKE_FIND_ROOT_PATH DOC "Python that runs the script tests")
