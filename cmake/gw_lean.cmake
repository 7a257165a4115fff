# A lean build: without oneTBB, NLopt, zlib, zstd, SQLite and Highway, as a browser has none of them.
#
#   X_without.cpp   stands in for X.cpp in a lean build: the same functions without the library, or a
#                   plain sentence in their place
#
#   base/parallel          one item after the other                    (oneTBB)
#   base/packing           its own CRC-32, stb_image_write's deflate   (zlib)
#   math/minimise          none: the verb compensate refuses           (NLopt)
#   design/candidate_simd  plain doubles, the kernels' oracle          (Highway)
#   pair/closed_forms_simd plain doubles too                           (Highway)
#   job/search_campaign    none: a search leaves no folder             (zstd, SQLite: the store)
#   apps/common/watch      no line of progress                         (threads, signals)
#
# What only a folder of a search needs is left out with the store.
include_guard()

set(gw_store_sources "/gearwright/store/|/gearwright/job/search_(files|record|tables)\\.cpp$")

# Leaves one of each pair in the list. On Windows, X_windows.cpp stands in for X.cpp likewise.
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
