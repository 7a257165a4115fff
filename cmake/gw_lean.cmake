# A lean build, without oneTBB, NLopt, zlib, zstd, SQLite and Highway, none of which is available in
# a browser.
#
#   X_without.cpp   replaces X.cpp in a lean build. It has the same functions without the library,
#                   or returns an error instead.
#
#   base/parallel          one item after the other                    (oneTBB)
#   base/packing           its own CRC-32, stb_image_write's deflate   (zlib)
#   math/minimise          none: the verb compensate refuses           (NLopt)
#   design/candidate_simd  plain doubles, the kernels' oracle          (Highway)
#   pair/closed_forms_simd plain doubles too                           (Highway)
#   job/search_campaign    none: a search leaves no folder             (zstd, SQLite: the store)
#   job/study_campaign     none: neither does a study of designs
#   apps/common/watch      no line of progress                         (threads, signals)
#
# Functions that only the folder of a search needs are omitted together with the store.
include_guard()

set(gw_store_sources "/gearwright/store/|/gearwright/job/(campaign|search_(files|record|tables))\\.cpp$")

# Keeps one of each pair in the list. On Windows, X_windows.cpp replaces X.cpp in the same way.
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
