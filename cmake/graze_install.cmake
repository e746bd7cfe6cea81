# SPDX-License-Identifier: MIT
# The files that `cmake --install` installs, and the package for `find_package(graze)`. Each component has its own
# export, so that graze::geometry can be used on a machine that only has GLM.
include(CMakePackageConfigHelpers)
set(graze_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/graze")

# Headers directly in a layer's folder are public; internal ones in sub-folders are only installed if a public one includes
# them.
if(TARGET graze_graze)
  file(GLOB open CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" graze/*.hpp graze/*/*.hpp)
  set(graze_arch)
  if(NOT TARGET graze_distributed)
    list(FILTER open EXCLUDE REGEX "^graze/distributed/")
  endif()
else()
  file(GLOB open CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" graze/math/*.hpp graze/shape/*.hpp graze/query/*.hpp)
  set(graze_arch ARCH_INDEPENDENT)
endif()
set(graze_headers)
while(open)
  list(POP_FRONT open header)
  list(APPEND graze_headers "${header}")
  file(STRINGS "${header}" included REGEX "^ *#include <graze/[^>]+>")
  list(TRANSFORM included REPLACE "^ *#include <([^>]+)>.*" "\\1")
  list(REMOVE_ITEM included ${graze_headers} ${open})
  list(APPEND open ${included})
endwhile()
foreach(header IN LISTS graze_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}")
endforeach()
install(TARGETS graze_geometry EXPORT graze_geometry_targets)
install(EXPORT graze_geometry_targets NAMESPACE graze:: DESTINATION "${graze_package_dir}"
        FILE graze-geometry-targets.cmake)
if(TARGET graze_graze)
  install(TARGETS graze_graze EXPORT graze_graze_targets)
  install(EXPORT graze_graze_targets NAMESPACE graze:: DESTINATION "${graze_package_dir}"
          FILE graze-graze-targets.cmake)
endif()
if(TARGET graze_distributed)
  install(TARGETS graze_distributed EXPORT graze_distributed_targets)
  install(EXPORT graze_distributed_targets NAMESPACE graze:: DESTINATION "${graze_package_dir}"
          FILE graze-distributed-targets.cmake)
  install(FILES cmake/Findgraze_zoltan.cmake DESTINATION "${graze_package_dir}")
endif()
if(TARGET graze_c)
  if(BUILD_SHARED_LIBS)
    set_target_properties(graze_c PROPERTIES INSTALL_RPATH "$ORIGIN")
  endif()
  install(TARGETS graze_c EXPORT graze_c_targets)
  install(EXPORT graze_c_targets NAMESPACE graze:: DESTINATION "${graze_package_dir}" FILE graze-c-targets.cmake)
  install(FILES bindings/c/graze.h bindings/c/graze_types.h bindings/c/graze_scene.h
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
endif()
if(TARGET graze_mpi)
  install(TARGETS graze_mpi)
endif()
if(TARGET graze_cli)
  if(BUILD_SHARED_LIBS)
    set_target_properties(graze_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  endif()
  install(TARGETS graze_cli)
  # The page that `graze view` fills in, if `./dev web` has built it.
  install(FILES "${PROJECT_SOURCE_DIR}/build/web/viewer/report.html" DESTINATION "${CMAKE_INSTALL_DATADIR}/graze" OPTIONAL)
endif()
if(TARGET graze_cli)
  set(share "${PROJECT_SOURCE_DIR}/apps/cli/share")
  install(FILES "${share}/graze.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  install(FILES "${share}/graze.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME graze)
  install(FILES "${share}/graze.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
  install(FILES "${share}/_graze" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
endif()
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
include(graze_pkg_config)

configure_package_config_file(
  cmake/graze-config.cmake.in "${PROJECT_BINARY_DIR}/graze-config.cmake" INSTALL_DESTINATION "${graze_package_dir}"
  NO_SET_AND_CHECK_MACRO)
if(TARGET graze_graze AND GRAZE_COMPRESSION AND NOT BUILD_SHARED_LIBS)
  install(FILES cmake/Findgraze_zstd.cmake DESTINATION "${graze_package_dir}")
endif()
write_basic_package_version_file("${PROJECT_BINARY_DIR}/graze-config-version.cmake" COMPATIBILITY SameMinorVersion ${graze_arch})
install(FILES "${PROJECT_BINARY_DIR}/graze-config.cmake" "${PROJECT_BINARY_DIR}/graze-config-version.cmake"
        DESTINATION "${graze_package_dir}")

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(
    uninstall COMMAND "${CMAKE_COMMAND}" "-DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt" -P
                      "${PROJECT_SOURCE_DIR}/cmake/graze_uninstall.cmake" VERBATIM)
endif()
