# What the build needs from outside. tools/packages.txt names the Debian packages of each.
include_guard()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)  # headers only
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)
find_package(TBB 2021 REQUIRED)
find_package(NLopt 2.7 REQUIRED)
find_package(hwy 1.0.3 REQUIRED)
find_package(SQLite3 3.34 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd>=1.4)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
if(GEARWRIGHT_CLI)
  find_package(CLI11 2.1 QUIET)
endif()

# MPI for searches on many ranks: where the package is.
set(why_no_mpi "switched off (GEARWRIGHT_MPI=OFF)")
if(NOT DEFINED GEARWRIGHT_MPI OR GEARWRIGHT_MPI)
  find_package(MPI QUIET COMPONENTS CXX)
endif()
if(NOT DEFINED GEARWRIGHT_MPI AND NOT MPI_CXX_FOUND)
  set(GEARWRIGHT_MPI OFF)
  set(why_no_mpi "MPI not found (Debian: libopenmpi-dev openmpi-bin)")
else()
  option(GEARWRIGHT_MPI "Build gearwright-mpi" ON)
endif()
if(GEARWRIGHT_MPI AND NOT MPI_CXX_FOUND)
  message(FATAL_ERROR "GEARWRIGHT_MPI=ON, but MPI was not found. "
                      "On Debian: apt-get install libopenmpi-dev openmpi-bin")
endif()

# Scripts run on the system's Python, where Debian's modules are, not on the first of the PATH.
find_program(GEARWRIGHT_PYTHON python3 HINTS /usr/bin NO_CMAKE_ENVIRONMENT_PATH
             DOC "Python that runs the script tests")
