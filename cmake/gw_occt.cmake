# OCCT is a CAD kernel. The tests read our STEP files with it, because it is independent of our
# code. Nothing that is installed depends on it.
include_guard()

# No version is requested, because OCCT accepts only an exact match of the patch level.
find_package(OpenCASCADE CONFIG QUIET)
set(gw_occt_libraries
  TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKShHealing TKXSBase TKSTEP TKXCAF
  TKLCAF TKCDF TKXDESTEP)

# Shared libraries are linked by file name. CMake targets would also require the dependencies of the
# viewer (X11, OpenGL, TBB, fonts), whose development packages are not needed to read files. The
# targets set no include path.
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
