# Options with which every target of the project is compiled.
#
# The same input must give the same bits. Therefore operations are not contracted into fused
# multiply-adds, and -ffast-math is never used. -DNDEBUG disables the asserts of included libraries.
# It has no effect on our own contracts, which stay enabled.
include_guard()
include(gw_unity)

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Without these two settings, ccache stores nothing that is compiled with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()

if(CMAKE_CXX_FLAGS MATCHES "-ffast-math|-Ofast|-funsafe-math")
  message(FATAL_ERROR "CMAKE_CXX_FLAGS enables fast math, which makes results irreproducible")
endif()

function(gw_target target)
  gw_unity(${target})
  if(MSVC)  # untested
    target_compile_options(${target} PRIVATE /utf-8 /bigobj /permissive- /fp:precise)
    target_compile_definitions(${target} PRIVATE NOMINMAX BOOST_MATH_PROMOTE_DOUBLE_POLICY=false)
    return()
  endif()
  # The message of a violated contract contains the file name relative to the source folder,
  # wherever that folder is.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic
                         -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
                         $<$<BOOL:${GEARWRIGHT_WERROR}>:-Werror>)
  # Boost's functions of a double compute with doubles. By default they compute with long doubles,
  # which differ between systems.
  target_compile_definitions(${target} PRIVATE BOOST_MATH_PROMOTE_DOUBLE_POLICY=false)
  # Eigen divides long sums into parts that fit into the cache. By default it asks the processor for its cache, so the last
  # digits of `load` would depend on the processor.
  target_compile_definitions(${target} PRIVATE EIGEN_NO_CPUID EIGEN_DEFAULT_L1_CACHE_SIZE=32768)
  # Eigen computes blocks of six rows at once if the processor has fused multiply-adds, otherwise of four. The order of a
  # sum depends on it. All processors compute blocks of six rows of vectors of two doubles, without fusing.
  # WebAssembly has no vectors (cmake/gw_wasm.cmake).
  if(NOT EMSCRIPTEN)
    target_compile_definitions(${target} PRIVATE EIGEN_HAS_SINGLE_INSTRUCTION_MADD)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
    target_include_directories(${target} BEFORE PRIVATE ${PROJECT_SOURCE_DIR}/cmake/eigen_vectors)
  endif()
  if(WIN32)
    # Boost assumes these functions of C only on systems with POSIX, and computes its own elsewhere.
    target_compile_definitions(${target} PRIVATE BOOST_HAS_LOG1P BOOST_HAS_EXPM1)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 wrongly reports that std::string copies beyond its small buffer (GCC bug 105329),
    # depending on the length of a literal. The presets of clang keep the warning.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With -fipa-modref, g++ 12 for Windows wrongly removes stores to an array that a function reads through a
    # reference, if -fipa-sra has changed the signature of a function that it calls. `pair` then printed the angles of
    # `contact_ratio_range` from memory that was never written.
    target_compile_options(${target} PRIVATE -fno-ipa-modref)
    # The compiler collects garbage only above one gigabyte. By default it does so every 128 MB, and
    # a precompiled header alone fills that. For sources with many templates, this saves 10 to 20 %
    # of the time and uses 15 % more memory.
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=1048576)
  endif()
  if(UNIX AND NOT APPLE AND NOT EMSCRIPTEN)
    # A program loads only the libraries that it calls.
    target_link_options(${target} PRIVATE LINKER:--as-needed)
  endif()
  # In WebAssembly, position-independent code is slow, because it reads every address from a table.
  if(EMSCRIPTEN)
    return()
  endif()
  # Programs are compiled with -fPIC too, not with CMake's -fPIE, so that all targets can use one
  # precompiled header (gw_precompiled.cmake).
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE")
    target_compile_options(${target} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
  else()
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
endfunction()
