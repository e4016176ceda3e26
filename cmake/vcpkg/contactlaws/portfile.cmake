# An overlay port, which installs the sources that it lies in:  vcpkg install contactlaws --overlay-ports=cmake/vcpkg
# Not tested yet.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(VCPKG_BUILD_TYPE release)  # headers only

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DCONTACTLAWS_BUILD_TESTS=OFF -DCONTACTLAWS_BUILD_BENCH=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/contactlaws)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
