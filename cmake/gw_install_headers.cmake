# Runs at install time. Copies the public headers (see gw_public_headers.cmake) and the texts (.inc)
# that they include.
#
#   gw_source       the source folder             gw_headers_to   include folder under the prefix
include(${CMAKE_CURRENT_LIST_DIR}/gw_public_headers.cmake)
gw_public_headers(headers kept ${gw_source})
foreach(header IN LISTS kept)
  message(STATUS "Kept inside: ${header}")
endforeach()
foreach(header IN LISTS headers)
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${gw_source}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/${gw_headers_to}/${folder})
endforeach()
