# SPDX-License-Identifier: MIT
# What a release needs. The version is that of project(); these files repeat it for other tools.
foreach(file pyproject.toml bindings/javascript/package.json CITATION.cff)
  file(STRINGS ${file} repeated REGEX "version\"?[:=]? *=? *\"?${PROJECT_VERSION}\"?,?$")
  if(NOT repeated)
    message(FATAL_ERROR "${file} repeats another version than ${PROJECT_VERSION}")
  endif()
endforeach()

# Two Debian packages, which cmake/package.sh makes: `bankshot` holds the program and libbankshot, `libbankshot-dev` the
# headers and static libraries.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the bankshot authors <bankshot@users.noreply.github.com>")
set(CPACK_PACKAGE_VENDOR "the bankshot authors")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME bankshot)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}
 It finds the launch speed and angle that carry a ball by the cushions asked to
 a pocket or a place, and says what to play and where the cue ball stops.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libbankshot-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "bankshot (= ${PROJECT_VERSION}), libeigen3-dev, libceres-dev, libnlopt-dev, libfmt-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION} (headers and static libraries)
 For C++ by find_package(bankshot), for C by pkg-config.")
include(CPack)
cpack_add_component(program)
cpack_add_component(development DEPENDS program)
