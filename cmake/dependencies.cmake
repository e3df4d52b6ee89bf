# SPDX-License-Identifier: MIT
# Finds each library, or says which Debian package holds it.

function(bankshot_need package version debian)
  find_package(${package} ${version} QUIET ${ARGN})
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "bankshot needs ${package} >= ${version}: apt-get install ${debian}")
  endif()
  foreach(variable IN ITEMS FOUND VERSION INCLUDE_DIRS)
    set(${package}_${variable} "${${package}_${variable}}" PARENT_SCOPE)
  endforeach()
endfunction()

# The simulator's library.
bankshot_need(nlohmann_json 3.10 nlohmann-json3-dev GLOBAL)
bankshot_need(fmt 8 libfmt-dev)
# The planners' library.
bankshot_need(Eigen3 3.4 libeigen3-dev NO_MODULE)
bankshot_need(Ceres 2.1 libceres-dev)
if(BANKSHOT_NLOPT)
  # NLopt is packaged twice under one CMake name (C and C++), so ask for the target.
  find_package(NLopt 2.7 QUIET)
  if(NOT TARGET NLopt::nlopt)
    find_package(PkgConfig QUIET)
    if(PkgConfig_FOUND)
      pkg_check_modules(nlopt QUIET IMPORTED_TARGET nlopt>=2.7)
    endif()
    if(NOT TARGET PkgConfig::nlopt)
      message(FATAL_ERROR "bankshot needs NLopt >= 2.7: apt-get install libnlopt-dev")
    endif()
    add_library(NLopt::nlopt ALIAS PkgConfig::nlopt)
  endif()
else()
  message(STATUS "bankshot: no planners nlopt-*; tests, benchmarks and the report leave them out (BANKSHOT_NLOPT is off)")
endif()
# The program and the bindings; of Boost headers only, for 50 digits and for the integrators that `report`
# compares with.
if(BANKSHOT_PROGRAM OR BANKSHOT_C OR BANKSHOT_PYTHON)
  bankshot_need(CLI11 2.1 libcli11-dev)
  bankshot_need(Boost 1.74 libboost-dev)
endif()
if(BANKSHOT_PROGRAM)
  bankshot_need(TBB 2021 libtbb-dev)
  bankshot_need(ZLIB 1.2 zlib1g-dev)
  # `serve`.
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(httplib QUIET IMPORTED_TARGET cpp-httplib>=0.11)
  endif()
  if(NOT httplib_FOUND)
    message(FATAL_ERROR "bankshot needs cpp-httplib >= 0.11: apt-get install libcpp-httplib-dev pkg-config")
  endif()
  # Makes PNG of pictures; without it the program writes SVG alone.
  pkg_check_modules(rsvg QUIET IMPORTED_TARGET librsvg-2.0>=2.52)
  if(NOT rsvg_FOUND)
    message(STATUS "bankshot: no --png (apt-get install librsvg2-dev)")
  endif()
endif()
