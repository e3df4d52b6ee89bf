# SPDX-License-Identifier: MIT
# Installs BUILD into a prefix of its own, then configures, builds and runs SOURCE against it.
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${log}")
  endif()
endfunction()
file(REMOVE_RECURSE ${WORK})
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS=${FLAGS}")
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${WORK}/build/consumer)
foreach(file IN ITEMS share/man/man1/bankshot.1 share/man/man1/bankshot-solve.1 share/doc/bankshot/format.md
    share/bash-completion/completions/bankshot share/zsh/site-functions/_bankshot share/fish/vendor_completions.d/bankshot.fish)
  file(SIZE ${WORK}/prefix/${file} size)  # fails where it is not there
  if(size LESS 500)
    message(FATAL_ERROR "${file} is empty")
  endif()
endforeach()
# No optimiser in an installed header.
file(GLOB_RECURSE headers ${WORK}/prefix/include/*.hpp)
foreach(header IN LISTS headers)
  file(STRINGS ${header} bad REGEX "#include.*(ceres|nlopt|Eigen|nlohmann|planners/)")
  if(bad)
    message(FATAL_ERROR "${header}: ${bad}")
  endif()
endforeach()
