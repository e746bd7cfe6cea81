# SPDX-License-Identifier: MIT
# Implements find_package for Emscripten, for which no packages exist; header-only libraries work from any machine. Each
# package's headers are reached through a separate link, because their folder also contains the headers of the host's C
# library, which Emscripten must not use.
set(GRAZE_HEADERS_FROM "/usr/include" CACHE PATH "Where the headers of the libraries that graze uses are installed")
set(GRAZE_PUGIXML_SOURCE "" CACHE PATH "pugixml's source folder, that with pugixml.cpp")

function(graze_headers_of package target)
  if(TARGET ${target})
    return()
  endif()
  set(folder "${CMAKE_BINARY_DIR}/headers/${package}")
  file(MAKE_DIRECTORY "${folder}")
  foreach(name IN LISTS ARGN)
    if(NOT EXISTS "${GRAZE_HEADERS_FROM}/${name}")
      message(FATAL_ERROR "${GRAZE_HEADERS_FROM}/${name} does not exist; install the headers of ${package}, or set "
                          "GRAZE_HEADERS_FROM to their folder")
    endif()
    file(CREATE_LINK "${GRAZE_HEADERS_FROM}/${name}" "${folder}/${name}" SYMBOLIC)
  endforeach()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${folder}")
endfunction()

function(graze_compile_pugixml)
  if(TARGET pugixml::pugixml)
    return()
  endif()
  if(NOT EXISTS "${GRAZE_PUGIXML_SOURCE}/pugixml.cpp")
    message(FATAL_ERROR "GRAZE_PUGIXML_SOURCE must name the folder with pugixml.cpp; it is \"${GRAZE_PUGIXML_SOURCE}\"")
  endif()
  add_library(graze_pugixml STATIC "${GRAZE_PUGIXML_SOURCE}/pugixml.cpp")
  add_library(pugixml::pugixml ALIAS graze_pugixml)
  target_include_directories(graze_pugixml SYSTEM PUBLIC "${GRAZE_PUGIXML_SOURCE}")
endfunction()

macro(graze_provide_package method package)
  if("${package}" STREQUAL glm)
    graze_headers_of(glm glm::glm glm)
  elseif("${package}" STREQUAL fmt)
    graze_headers_of(fmt fmt::fmt fmt)
    set_property(TARGET fmt::fmt PROPERTY INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY)
  elseif("${package}" STREQUAL nlohmann_json)
    graze_headers_of(nlohmann_json nlohmann_json::nlohmann_json nlohmann)
  elseif("${package}" STREQUAL FastFloat)
    graze_headers_of(FastFloat FastFloat::fast_float fast_float)
  elseif("${package}" STREQUAL hwy)
    graze_headers_of(hwy hwy::hwy hwy)
    # The instruction set is fixed at compile time, so Highway's run-time dispatch is not linked.
    set_property(TARGET hwy::hwy PROPERTY INTERFACE_COMPILE_DEFINITIONS HWY_COMPILE_ONLY_STATIC)
    # All vector code is Highway's: em++ 3.1.6 vectorises adjacent doubles itself, sometimes incorrectly (at -O2,
    # time_of_impact reported contact of two points that pass each other at a distance).
    set_property(TARGET hwy::hwy PROPERTY INTERFACE_COMPILE_OPTIONS -msimd128 -fno-slp-vectorize)
  elseif("${package}" STREQUAL pugixml)
    graze_compile_pugixml()
  endif()
  set(${package}_FOUND TRUE)
endmacro()

cmake_language(SET_DEPENDENCY_PROVIDER graze_provide_package SUPPORTED_METHODS FIND_PACKAGE)
