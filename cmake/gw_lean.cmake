# A lean build, without oneTBB, zlib, zstd, SQLite and Highway, none of which is available in
# a browser.
#
#   X_without.cpp   replaces X.cpp in a lean build. It has the same functions without the library,
#                   or returns an error instead.
#
#   X                      in a lean build                             missing
#   base/parallel          processes one item after the other          oneTBB
#   base/packing           own CRC-32, deflate and inflate of stb      zlib
#   design/candidate_simd  plain doubles                               Highway
#   pair/closed_forms_simd plain doubles                               Highway
#   contact/touch_lanes_simd  plain doubles                            Highway
#   job/campaign           a search or a study writes no folder        zstd and SQLite
#   apps/common/watch      no progress line                            threads and signals
#
# Functions that only the folder of a search needs are omitted together with the store.
include_guard()

set(gw_store_sources "/gearwright/store/|/gearwright/job/(search_(campaign|files|record)|study_campaign)\\.cpp$")

# Removes from the list the source of each pair that this build does not use. On Windows,
# X_windows.cpp replaces X.cpp in the same way.
function(gw_choose_twins list_name)
  set(kept "")
  foreach(source IN LISTS ${list_name})
    if(WIN32)
      string(REGEX REPLACE "\\.cpp$" "_windows.cpp" twin ${source})
      if(EXISTS ${twin})
        continue()
      endif()
    elseif(source MATCHES "_windows\\.cpp$")
      continue()
    endif()
    if(GEARWRIGHT_LEAN)
      string(REGEX REPLACE "\\.cpp$" "_without.cpp" twin ${source})
      if(EXISTS ${twin} OR source MATCHES "${gw_store_sources}")
        continue()
      endif()
    elseif(source MATCHES "_without\\.cpp$")
      continue()
    endif()
    list(APPEND kept ${source})
  endforeach()
  set(${list_name} ${kept} PARENT_SCOPE)
endfunction()
