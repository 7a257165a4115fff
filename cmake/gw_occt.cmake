# OCCT, a CAD kernel: the foreign reader that the tests give our STEP files to. Nothing that is installed
# knows it.
include_guard()

find_package(OpenCASCADE CONFIG QUIET)  # without a version: it refuses all but its own patch level
set(gw_occt_libraries
  TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKShHealing TKXSBase TKSTEP TKXCAF
  TKLCAF TKCDF TKXDESTEP)

# Shared libraries are linked by file: as targets they would drag in the viewer's own needs (X11, OpenGL,
# TBB, fonts), whose development packages a reader of files does without. The targets set no include path.
function(gw_link_occt target)
  target_include_directories(${target} SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
  foreach(library IN LISTS gw_occt_libraries)
    get_target_property(type ${library} TYPE)
    if(type STREQUAL "SHARED_LIBRARY")
      target_link_libraries(${target} PRIVATE $<TARGET_LINKER_FILE:${library}>)
    else()
      target_link_libraries(${target} PRIVATE ${library})
    endif()
  endforeach()
endfunction()
