# SPDX-License-Identifier: MIT
# Whether the file OBJECT leaves the queries of AnyShape to graze::graze. NM lists its symbols.
execute_process(COMMAND "${NM}" --undefined-only --demangle "${OBJECT}" OUTPUT_VARIABLE undefined COMMAND_ERROR_IS_FATAL ANY)
foreach(query contact manifold distance shape_cast time_of_impact ray_cast)
  if(NOT undefined MATCHES " graze::${query}<")
    message(FATAL_ERROR "${OBJECT} has compiled graze::${query} of AnyShape, which is in the library")
  endif()
endforeach()
