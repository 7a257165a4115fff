# Compiles the sources of a room together, at most 36 at a time, and small rooms as one, if CMAKE_UNITY_BUILD is set.
# Tests of one folder are all compiled together.
#
# Most of the compile time of a source is for templates that its neighbours also instantiate. Sixteen sources of the room
# cad take 15.5 s, and the same sources as two parts of eight take 20.5 s. The disadvantage is that a name in an unnamed
# namespace may conflict with a name in another source of its part. The compiler then reports an error, and the new name
# must be changed.
#
# The presets `edit` and `clang` compile every source alone, which shows that each includes
# everything that it uses.
include_guard()

set(gw_together 36)

# Small rooms are compiled as one. Rooms between which names conflict are not joined.
set(gw_joined
  "base curve gear generation math store tool"
  "compliance load"
  "inspection pair"
  "rating verdict")

# These sources are compiled alone. Highway includes a source `_simd` again for each instruction set. The program
# gearwright writes no figures as PDF, so the linker leaves out their sources. windows.h, which system_windows.cpp
# includes, defines common names such as `near` as macros.
set(gw_alone "(_simd|/(figure_files|style_sheet|system_windows))\\.cpp$")

# The parts of a room have the same number of sources, so that two processors finish at nearly the same time.
function(gw_unity target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "${gw_alone}")
  set(rooms "")
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME room)
    if(source MATCHES "/gearwright/[a-z]+/")
      foreach(joined IN LISTS gw_joined)
        if(" ${joined} " MATCHES " ${room} ")
          string(REPLACE " " "_" room ${joined})
        endif()
      endforeach()
    endif()
    list(APPEND rooms ${room})
    list(APPEND sources_${room} ${source})
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  foreach(room IN LISTS rooms)
    list(LENGTH sources_${room} n)
    math(EXPR parts "(${n} + ${gw_together} - 1) / ${gw_together}")
    set(i 0)
    foreach(source IN LISTS sources_${room})
      math(EXPR part "${i} * ${parts} / ${n}")
      math(EXPR i "${i} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${part})
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
