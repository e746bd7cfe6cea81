# SPDX-License-Identifier: MIT
# graze.pc and graze_c.pc, for programs that are built without CMake. Their paths are relative to the files themselves, so
# they stay right when an installation is moved, or made with another --prefix.
file(RELATIVE_PATH graze_pc_prefix "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" graze_pc_prefix "${graze_pc_prefix}")
file(RELATIVE_PATH graze_pc_libraries "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_LIBDIR}")
file(RELATIVE_PATH graze_pc_includes "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")

# graze_install_pc(template name)
function(graze_install_pc template name)
  configure_file("${template}" "${PROJECT_BINARY_DIR}/${name}" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

if(TARGET graze_graze)
  # What the CMake targets give to their users; the first two depend on the compiler there.
  set(graze_pc_flags "-ffp-contract=off -DGRAZE_NO_CONTRACTION")
  get_target_property(definitions graze_graze INTERFACE_COMPILE_DEFINITIONS)
  foreach(definition IN LISTS definitions)
    string(APPEND graze_pc_flags " -D${definition}")
  endforeach()
  set(graze_pc_requires)
  if(NOT BUILD_SHARED_LIBS)
    # A program that links a static library must also link the libraries that it uses.
    set(graze_pc_requires "fmt, pugixml, libhwy")
    if(GRAZE_TBB)
      string(APPEND graze_pc_requires ", tbb")
    endif()
    if(GRAZE_COMPRESSION)
      string(APPEND graze_pc_requires ", zlib, libzstd")
    endif()
  endif()
  graze_install_pc(cmake/graze.pc.in graze.pc)
endif()
if(TARGET graze_c)
  graze_install_pc(bindings/c/graze_c.pc.in graze_c.pc)
endif()
