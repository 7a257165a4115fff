# Finds the dependencies of the build. tools/packages.txt lists the Debian package of each.
include_guard()

if(EMSCRIPTEN)
  include(gw_wasm)
  return()
elseif(GEARWRIGHT_LIBRARIES)
  include(gw_portable)
  return()
endif()

include(gw_elementary)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)  # headers only
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(tomlplusplus REQUIRED)
set(gw_libraries "")
if(NOT GEARWRIGHT_LEAN)
  find_package(ZLIB REQUIRED)
  find_package(TBB 2021 REQUIRED)
  find_package(hwy 1.0.3 REQUIRED)
  find_package(SQLite3 3.34 REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd>=1.4)
  set(THREADS_PREFER_PTHREAD_FLAG ON)
  find_package(Threads REQUIRED)
  set(gw_libraries ZLIB::ZLIB TBB::tbb Threads::Threads hwy::hwy PkgConfig::zstd
                   SQLite::SQLite3)
endif()
if(GEARWRIGHT_CLI)
  find_package(CLI11 2.1 QUIET)
endif()

# MPI for searches on many ranks, if the package is installed.
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

# Scripts run with the Python of the system, because it has Debian's modules. The first Python in
# PATH may not have them.
find_program(GEARWRIGHT_PYTHON_EXECUTABLE python3 HINTS /usr/bin NO_CMAKE_ENVIRONMENT_PATH
             DOC "Python that runs the script tests and for which the package is built")

# The Python package, if pybind11 and NumPy are installed.
set(why_no_python "switched off (GEARWRIGHT_PYTHON=OFF)")
if(GEARWRIGHT_LEAN OR CMAKE_CROSSCOMPILING)
  set(GEARWRIGHT_PYTHON OFF)
  set(why_no_python "not in a lean or a cross build")
endif()
if(NOT DEFINED GEARWRIGHT_PYTHON OR GEARWRIGHT_PYTHON)
  set(Python_EXECUTABLE ${GEARWRIGHT_PYTHON_EXECUTABLE})
  find_package(Python 3.11 QUIET COMPONENTS Interpreter Development.Module NumPy)
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
if(Python_Development.Module_FOUND AND Python_NumPy_FOUND AND pybind11_FOUND)
  option(GEARWRIGHT_PYTHON "Build the Python package" ${PROJECT_IS_TOP_LEVEL})
elseif(NOT DEFINED GEARWRIGHT_PYTHON)
  set(GEARWRIGHT_PYTHON OFF)
  set(why_no_python "pybind11 not found (Debian: pybind11-dev python3-dev python3-numpy)")
elseif(GEARWRIGHT_PYTHON)
  message(FATAL_ERROR "GEARWRIGHT_PYTHON=ON, but pybind11, NumPy or Python's headers were not found. "
                      "On Debian: apt-get install pybind11-dev python3-dev python3-numpy")
endif()
