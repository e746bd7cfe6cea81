# SPDX-License-Identifier: MIT
# graze::zoltan: Zoltan, from its header and library alone. The CMake package of Debian's Trilinos asks for packages that
# Zoltan's recursive coordinate bisection does not use.
if(NOT TARGET graze::zoltan)
  find_path(graze_zoltan_INCLUDE_DIR zoltan.h PATH_SUFFIXES trilinos)
  find_library(graze_zoltan_LIBRARY NAMES trilinos_zoltan zoltan)
  mark_as_advanced(graze_zoltan_INCLUDE_DIR graze_zoltan_LIBRARY)
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(graze_zoltan REQUIRED_VARS graze_zoltan_LIBRARY graze_zoltan_INCLUDE_DIR)
  if(graze_zoltan_FOUND)
    add_library(graze::zoltan UNKNOWN IMPORTED)
    set_target_properties(graze::zoltan PROPERTIES IMPORTED_LOCATION "${graze_zoltan_LIBRARY}"
                                                   INTERFACE_INCLUDE_DIRECTORIES "${graze_zoltan_INCLUDE_DIR}")
  endif()
endif()
