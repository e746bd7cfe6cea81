# SPDX-License-Identifier: MIT
# Includes Emscripten's own toolchain file, wherever em++ is installed.
find_program(GRAZE_EMXX em++ REQUIRED)
file(REAL_PATH "${GRAZE_EMXX}" graze_emxx)
cmake_path(GET graze_emxx PARENT_PATH graze_emscripten)
include("${graze_emscripten}/cmake/Modules/Platform/Emscripten.cmake")
