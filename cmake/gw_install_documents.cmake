# Installs shell completion, manual pages, documents and examples. For each package, it also
# installs the licence and the changes that Debian requires.
include_guard()

set(gw_maintainer "The Gearwright developers <developers@gearwright.invalid>")
set(gw_synopsis "exact engine for cylindrical gears")
set(gw_about "Gearwright reads a gear or a pair as on a drawing and gives its exact
geometry, its contact under errors, the designs within limits, and files
for CAD.
.
")
set(gw_about_RUNTIME "${gw_about}This package contains the program.")
set(gw_about_DEV "${gw_about}This package contains headers and libraries for C++ programs.")
set(gw_about_MPI "${gw_about}This package contains the design search on many ranks.")
set(gw_about_PYTHON3 "${gw_about}This package contains the module for Python.")

# The date of the last change is part of the sources, not of the build.
set(gw_changed "Sun, 22 Nov 2026 00:00:00 +0000")
set(gw_packages dev:libgearwright-dev)  # COMPONENT:PACKAGE
if(has_cli OR BUILD_SHARED_LIBS)
  list(APPEND gw_packages runtime:gearwright)
endif()
if(has_mpi)
  list(APPEND gw_packages mpi:gearwright-mpi)
endif()
if(has_python)
  list(APPEND gw_packages python3:python3-gearwright)
endif()

find_program(GZIP gzip)
mark_as_advanced(GZIP)
function(gw_packed from to)
  cmake_path(GET to PARENT_PATH folder)
  file(MAKE_DIRECTORY ${folder})
  if(GZIP)
    execute_process(COMMAND ${GZIP} -9nc ${from} OUTPUT_FILE ${to} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()

set(gw_texts ${PROJECT_BINARY_DIR}/texts)
file(CONFIGURE OUTPUT ${gw_texts}/copyright @ONLY CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Gearwright

Files: *
Copyright: 2026 The Gearwright developers
License: Apache-2.0
 On Debian systems the text of the Apache License, Version 2.0, is
 /usr/share/common-licenses/Apache-2.0.
")
foreach(pair IN LISTS gw_packages)
  string(REGEX MATCH "(.*):(.*)" pair ${pair})
  set(component ${CMAKE_MATCH_1})
  set(package ${CMAKE_MATCH_2})
  set(optional "")
  if(component STREQUAL "python3")
    set(optional EXCLUDE_FROM_ALL)
  endif()
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${gw_texts}/copyright DESTINATION ${folder} COMPONENT ${component} ${optional})
  file(WRITE ${gw_texts}/${package}.changes
"${package} (${PROJECT_VERSION}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}; what is new stands in CHANGELOG.md of the sources.

 -- ${gw_maintainer}  ${gw_changed}
")
  gw_packed(${gw_texts}/${package}.changes ${gw_texts}/${package}/changelog.gz)
  install(FILES ${gw_texts}/${package}/changelog.gz DESTINATION ${folder} COMPONENT ${component}
          OPTIONAL ${optional})
endforeach()

if(has_cli)
  set(share ${CMAKE_INSTALL_DATADIR})
  install(FILES ${gw_made}/gearwright.bash DESTINATION ${share}/bash-completion/completions
          RENAME gearwright COMPONENT runtime)
  install(FILES ${gw_made}/_gearwright DESTINATION ${share}/zsh/vendor-completions
          COMPONENT runtime)
  install(FILES ${gw_made}/gearwright.fish DESTINATION ${share}/fish/vendor_completions.d
          COMPONENT runtime)
  install(FILES ${gw_made}/gearwright.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT runtime OPTIONAL)
  install(FILES ${PROJECT_SOURCE_DIR}/docs/quickstart.md ${PROJECT_SOURCE_DIR}/docs/spec.md
          ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${share}/doc/gearwright COMPONENT runtime)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${share}/doc/gearwright/examples
          COMPONENT runtime FILES_MATCHING PATTERN *.toml PATTERN *.csv PATTERN cpp EXCLUDE
          PATTERN slurm EXCLUDE)
endif()
if(has_mpi)
  gw_packed(${PROJECT_SOURCE_DIR}/docs/gearwright-mpi.1 ${gw_texts}/gearwright-mpi.1.gz)
  install(FILES ${gw_texts}/gearwright-mpi.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT mpi OPTIONAL)
endif()
