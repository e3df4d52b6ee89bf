# SPDX-License-Identifier: MIT
# Runs PROGRAMS and fails where one prints what another does not.
foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND ${program} OUTPUT_VARIABLE said)
  if(DEFINED first AND NOT said STREQUAL first)
    message(FATAL_ERROR "${program} printed\n${said}and others\n${first}")
  endif()
  set(first "${said}")
endforeach()
