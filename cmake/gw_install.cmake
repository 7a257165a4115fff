# Rules for installation and packages: find_package(gearwright), pkg-config, DEB.
#
# Component `runtime` contains the program and shared libraries, `dev` the files for a compiler, `python3` the module
# for the Python of Debian.
include_guard()
include(CMakePackageConfigHelpers)

set(gw_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gearwright)

function(gw_install_library target export)
  install(TARGETS ${target} EXPORT ${export}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  install(EXPORT ${export} NAMESPACE gearwright:: DESTINATION ${gw_cmake_dir} COMPONENT dev)
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
endfunction()

gw_install_library(gearwright gearwrightTargets)
install(CODE "set(gw_source ${PROJECT_SOURCE_DIR})
set(gw_headers_to ${CMAKE_INSTALL_INCLUDEDIR})" COMPONENT dev)
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/gw_install_headers.cmake COMPONENT dev)
if(has_cli)
  file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(gearwright_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
  if(has_mpi)
    set_target_properties(gearwright_mpi PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
    # Only targets that were built are installed, because `make demo` builds only the program.
    install(TARGETS gearwright_mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT mpi OPTIONAL)
  endif()
  install(TARGETS gearwright_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gearwrightConfig.cmake.in
  ${PROJECT_BINARY_DIR}/gearwrightConfig.cmake INSTALL_DESTINATION ${gw_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gearwrightConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gearwrightConfig.cmake
  ${PROJECT_BINARY_DIR}/gearwrightConfigVersion.cmake DESTINATION ${gw_cmake_dir} COMPONENT dev)

# The paths in the pkg-config file are relative to this file, so that the prefix can be moved. Debian permits the file in
# share, not in lib, if the folder of the library is not named after an architecture.
set(pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
file(RELATIVE_PATH pc_to_prefix ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
set(pc_requires "eigen3")
set(pc_requires_private "fmt, tomlplusplus, zlib, tbb, libhwy, libzstd, sqlite3")
if(NOT BUILD_SHARED_LIBS)
  # A static archive requires its dependencies both with and without --static.
  string(APPEND pc_requires ", ${pc_requires_private}")
  set(pc_requires_private "")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/gearwright.pc.in ${PROJECT_BINARY_DIR}/gearwright.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/gearwright.pc DESTINATION ${pc_dir} COMPONENT dev)

install(FILES ${PROJECT_SOURCE_DIR}/docs/schema/spec.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/gearwright COMPONENT runtime)
include(gw_install_documents)

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${gw_synopsis}")
  set(CPACK_PACKAGE_CONTACT "${gw_maintainer}")
  set(CPACK_PACKAGE_VENDOR "The Gearwright developers")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
      GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_COMPONENTS_ALL "")
  foreach(pair IN LISTS gw_packages)
    string(REGEX MATCH "(.*):(.*)" pair ${pair})
    list(APPEND CPACK_COMPONENTS_ALL ${CMAKE_MATCH_1})
    string(TOUPPER ${CMAKE_MATCH_1} part)
    set(CPACK_DEBIAN_${part}_PACKAGE_NAME ${CMAKE_MATCH_2})
    set(CPACK_DEBIAN_${part}_DESCRIPTION "${gw_about_${part}}")
  endforeach()
  set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
      "libeigen3-dev, libfmt-dev, libtomlplusplus-dev, zlib1g-dev, libtbb-dev, libhwy-dev, \
libzstd-dev, libsqlite3-dev")
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}~), python3-numpy")
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packaging/debian/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/prerm)
  if(BUILD_SHARED_LIBS)
    string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", gearwright (= ${PROJECT_VERSION})")
    # dpkg-shlibdeps searches this folder for the libraries of this build.
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
  endif()
  set(CPACK_GEARWRIGHT_PACKAGES ${gw_packages})
  set(CPACK_GEARWRIGHT_SBOM ${GEARWRIGHT_PYTHON_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/sbom.py)
  set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/gw_package_contents.cmake)
  include(CPack)
endif()
