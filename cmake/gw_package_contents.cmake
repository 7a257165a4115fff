# Runs in CPack before a .deb is made. Adds to each package the list of the libraries that it contains or links (SPDX),
# and the licences of those that it contains.
foreach(pair IN LISTS CPACK_GEARWRIGHT_PACKAGES)
  string(REGEX MATCH "(.*):(.*)" pair ${pair})
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${CMAKE_MATCH_1}${CPACK_PACKAGING_INSTALL_PREFIX})
  execute_process(COMMAND ${CPACK_GEARWRIGHT_SBOM} ${CPACK_PACKAGE_VERSION} ${CMAKE_MATCH_2} ${root} -
                          ${root}/share/doc/${CMAKE_MATCH_2} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
