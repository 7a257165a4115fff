# The build of a program that runs without any package: every library is linked statically.
#
# GEARWRIGHT_LIBRARIES is the folder with the libraries for the target, which tools/portable_libraries.sh compiles
# from Debian's sources; libraries that are headers only come from this system.
include_guard()
include(gw_system_headers)
gw_system_headers()

set(CMAKE_PREFIX_PATH ${GEARWRIGHT_LIBRARIES})
set(CMAKE_FIND_ROOT_PATH ${GEARWRIGHT_LIBRARIES})
set(BUILD_SHARED_LIBS OFF)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
foreach(package fmt NLopt TBB hwy)
  find_package(${package} REQUIRED CONFIG PATHS ${GEARWRIGHT_LIBRARIES} NO_DEFAULT_PATH)
endforeach()
foreach(library z zstd sqlite3)
  add_library(gw_${library} STATIC IMPORTED)
  set_target_properties(gw_${library} PROPERTIES
    IMPORTED_LOCATION ${GEARWRIGHT_LIBRARIES}/lib/lib${library}.a
    INTERFACE_INCLUDE_DIRECTORIES ${GEARWRIGHT_LIBRARIES}/include)
endforeach()
set(gw_libraries gw_z TBB::tbb NLopt::nlopt Threads::Threads hwy::hwy gw_zstd gw_sqlite3)
add_link_options(-static -s)

set(GEARWRIGHT_MPI OFF)
set(why_no_mpi "not in a portable build")
set(GEARWRIGHT_PYTHON OFF)
set(why_no_python "not in a portable build")
find_program(GEARWRIGHT_PYTHON_EXECUTABLE python3 HINTS /usr/bin NO_CMAKE_ENVIRONMENT_PATH
             NO_CMAKE_FIND_ROOT_PATH DOC "Python that runs the script tests")
