# Compiles sources of one folder together, eight at a time, if CMAKE_UNITY_BUILD is set. Tests of one folder are all
# compiled together.
#
# Most of the compile time of a source is for templates that its neighbours also instantiate. The
# disadvantage is that a name in an unnamed namespace may conflict with a name in a neighbour. The
# compiler then reports an error, and the new name must be changed.
#
# The presets `edit` and `clang` compile every source alone, which shows that each includes
# everything that it uses.
include_guard()

set(gw_together 8)

# These sources are compiled alone. Highway includes a source `_simd` again for each instruction set.
# The sources `_picture` have the same names of dimensions, and `_quantities` the same names of subjects.
# The program gearwright writes no figures as PDF, so the linker leaves out their sources.
set(gw_alone "(_(simd|picture|quantities)|/(figure_files|style_sheet))\\.cpp$")

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
