# SPDX-License-Identifier: MIT
# Runs PROGRAM, with ARGUMENTS if given, and compares its standard output with the file EXPECTED; also the
# file WRITTEN, if given, with the PICTURE in the repository.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE actual RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${result}")
endif()
file(READ ${EXPECTED} expected)
if(NOT actual STREQUAL expected)
  message(FATAL_ERROR "The output is not that of ${EXPECTED}:\n${actual}")
endif()
if(WRITTEN)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WRITTEN} ${PICTURE} RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${PICTURE} is not what is drawn now: ${WRITTEN}; examples/run.sh writes it anew")
  endif()
endif()
