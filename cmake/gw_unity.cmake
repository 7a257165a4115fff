# Sources of one folder compiled together, a few at a time, where CMAKE_UNITY_BUILD asks for it.
#
# Most of a source's time is templates that its neighbours instantiate too. In return a name in an unnamed
# namespace may meet its like in a neighbour; the compiler says so, and the new one gets a better name.
#
# The presets `edit` and `clang` compile every source alone, which shows that each includes what it uses.
include_guard()

set(gw_together 8)

# Highway compiles `_simd` once for each instruction set by including it again; pictures name their measures
# alike, tables of quantities what they look at.
set(gw_alone "_(simd|picture|quantities)\\.cpp$")

function(gw_unity target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "${gw_alone}")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME room)
    if(NOT DEFINED n_${room})
      set(n_${room} 0)
    endif()
    math(EXPR group "${n_${room}} / ${gw_together}")
    math(EXPR n_${room} "${n_${room}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
