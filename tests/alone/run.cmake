# SPDX-License-Identifier: MIT
# Configures, builds and runs the project beside this file, with the packages hidden that the library does not need.
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${log}")
  endif()
  set(log "${log}" PARENT_SCOPE)
endfunction()
foreach(package IN ITEMS NLopt PkgConfig CLI11 TBB ZLIB Boost Catch2 benchmark)
  list(APPEND hidden -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
file(REMOVE_RECURSE ${WORK})
# Built to run once: not optimised.
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK} -G Ninja -D BANKSHOT=${BANKSHOT}
  -D BANKSHOT_PROGRAM=OFF -D BANKSHOT_NLOPT=OFF ${hidden}
  -D CMAKE_BUILD_TYPE=None -D CMAKE_CXX_FLAGS=-O0 -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
step(${CMAKE_COMMAND} --build ${WORK})
step(${WORK}/alone)
message("${log}")
