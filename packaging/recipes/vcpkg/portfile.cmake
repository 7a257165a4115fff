# Not run (../README.md).
vcpkg_download_distfile(archive
  URLS "https://gearwright.invalid/gearwright-${VERSION}.tar.gz"
  FILENAME "gearwright-${VERSION}.tar.gz"
  SHA512 0)
vcpkg_extract_source_archive(source ARCHIVE "${archive}")
vcpkg_find_acquire_program(PKGCONFIG)
vcpkg_cmake_configure(
  SOURCE_PATH "${source}"
  OPTIONS -DPKG_CONFIG_EXECUTABLE=${PKGCONFIG} -DGEARWRIGHT_CLI=OFF -DGEARWRIGHT_TESTS=OFF -DGEARWRIGHT_BENCH=OFF -DGEARWRIGHT_PYTHON=OFF -DGEARWRIGHT_MPI=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME gearwright CONFIG_PATH lib/cmake/gearwright)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
