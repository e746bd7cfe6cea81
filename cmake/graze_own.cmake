# SPDX-License-Identifier: MIT
# Compiles a target like graze's own sources: C++20 without extensions, all warnings. Everything is PRIVATE, so nothing
# affects projects that use graze.
function(graze_own target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 reports an overlapping copy for `"text" + std::string` (GCC bug 105651, fixed in 13).
      target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
    if(GRAZE_WERROR)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()

# The same for code that is compiled once and run often; a build without optimised tests may still optimise it.
function(graze_own_often_run target)
  graze_own(${target})
  target_compile_options(${target} PRIVATE ${GRAZE_OFTEN_RUN_OPTIONS})
endfunction()
