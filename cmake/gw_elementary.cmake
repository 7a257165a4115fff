# One set of elementary functions (sin, pow, …) for all systems, so that they give the same bits: those of musl, which
# emscripten also uses. C libraries differ in the last bit of one result in ten.
#
# Debian's package musl-dev has them as position-independent objects in an archive. Here, those of tools/elementary.txt
# become one object, whose internal names are local, in an archive of their own. It stands before the C library on the
# command line of the linker. Programs of users do not get it from find_package(gearwright).
#
#   gw_elementary        what the core links: "" if the C library is used
#   gw_elementary_file   the archive
include_guard()

set(gw_elementary "")
string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" gw_processor)
find_file(GEARWRIGHT_MUSL libc.a PATHS /usr/lib/${gw_processor}-linux-musl NO_DEFAULT_PATH
          DOC "Archive of musl (Debian: musl-dev)")
if(NOT GEARWRIGHT_MUSL OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(gw_why_elementary "of the C library, so the last digits may differ from other systems (Debian: musl-dev)")
  return()
endif()
set(gw_why_elementary "of ${GEARWRIGHT_MUSL}")

set(gw_elementary_file ${PROJECT_BINARY_DIR}/elementary/libelementary.a)
file(STRINGS ${PROJECT_SOURCE_DIR}/tools/elementary.txt lines REGEX "^[^#]")
string(REGEX MATCHALL "[a-z0-9_]+" gw_members "${lines}")
list(TRANSFORM gw_members APPEND .lo)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/elementary.txt)
if(NOT EXISTS ${gw_elementary_file} OR ${PROJECT_SOURCE_DIR}/tools/elementary.txt IS_NEWER_THAN ${gw_elementary_file})
  set(folder ${PROJECT_BINARY_DIR}/elementary)
  file(REMOVE_RECURSE ${folder})
  file(MAKE_DIRECTORY ${folder})
  foreach(command "${CMAKE_AR} x ${GEARWRIGHT_MUSL} ${gw_members}" "${CMAKE_LINKER} -r -o elementary.o ${gw_members}"
                  "${CMAKE_OBJCOPY} --localize-hidden elementary.o" "${CMAKE_AR} rcs libelementary.a elementary.o")
    string(REPLACE " " ";" command "${command}")
    execute_process(COMMAND ${command} WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endif()
add_library(gw_elementary STATIC IMPORTED GLOBAL)
set_target_properties(gw_elementary PROPERTIES IMPORTED_LOCATION ${gw_elementary_file})
set(gw_elementary $<BUILD_INTERFACE:gw_elementary>)
