# SPDX-License-Identifier: MIT
# The engine of a page without a server, by emscripten: our sources with the header-only halves of the same libraries.
# Only their own folders are shown to the compiler: what else lies beside them is of this machine's C library.
set(headers ${PROJECT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
function(bankshot_headers target header debian)
  string(REGEX REPLACE "/.*" "" folder ${header})
  find_path(${folder}_FOLDER ${header} PATHS /usr/include /usr/local/include PATH_SUFFIXES eigen3 NO_DEFAULT_PATH
    NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ${folder}_FOLDER)
    message(FATAL_ERROR "bankshot needs ${header}: apt-get install ${debian}")
  endif()
  file(CREATE_LINK ${${folder}_FOLDER}/${folder} ${headers}/${folder} SYMBOLIC)
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE ${headers})
  endif()
endfunction()
bankshot_headers(nlohmann_json::nlohmann_json nlohmann/json.hpp nlohmann-json3-dev)
bankshot_headers(fmt::fmt fmt/format.h libfmt-dev)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
bankshot_headers(Eigen3::Eigen Eigen/Core libeigen3-dev)
bankshot_headers(Ceres::ceres ceres/jet.h libceres-dev)
# Exceptions as WebAssembly has them: by way of JavaScript, which is the default, they cost up to seven times.
add_compile_options(-fwasm-exceptions "SHELL:-include \"${PROJECT_SOURCE_DIR}/bindings/javascript/libcxx14.hpp\"")
add_link_options(-fwasm-exceptions)
