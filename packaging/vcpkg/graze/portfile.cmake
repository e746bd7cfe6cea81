# SPDX-License-Identifier: MIT
# An overlay port. It builds the checkout that contains it or, as `./dev package vcpkg` packs it, the archive beside it.
set(archive "${CMAKE_CURRENT_LIST_DIR}/graze-${VERSION}.tar.gz")
if(EXISTS "${archive}")
  vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
else()
  cmake_path(SET SOURCE_PATH NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../..")
endif()

vcpkg_check_features(
  OUT_FEATURE_OPTIONS features
  FEATURES
    c           GRAZE_C
    compression GRAZE_COMPRESSION
    tbb         GRAZE_TBB
    tools       GRAZE_BUILD_CLI
)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${features}
    -DGRAZE_BUILD_BENCH=OFF
    -DGRAZE_BUILD_EXAMPLES=OFF
    -DGRAZE_BUILD_TESTS=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/graze)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES graze AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
