# SPDX-License-Identifier: MIT
# A source file that holds the page's files: cmake -DOUT=page.cpp -DFOLDER=page -P embed.cmake
# As numbers, since compilers need not take strings of more than 65,536 characters.
file(GLOB names RELATIVE ${FOLDER} ${FOLDER}/*.html ${FOLDER}/*.css ${FOLDER}/*.js ${FOLDER}/*.svg)
list(SORT names)
set(types_html "text/html; charset=utf-8")
set(types_css "text/css")
set(types_js "text/javascript")
set(types_svg "image/svg+xml")
set(arrays "")
set(list "")
set(n 0)
foreach(name IN LISTS names)
  file(READ ${FOLDER}/${name} bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(REPLACE "0x0a," "0x0a,\n" bytes "${bytes}")
  string(REGEX REPLACE ".*\\." "" extension ${name})
  set(path /${name})
  if(name STREQUAL index.html)
    set(path /)
  endif()
  string(APPEND arrays "constexpr unsigned char file_${n}[] = {\n${bytes}};\n")
  string(APPEND list "    {\"${path}\", \"${types_${extension}}\", text(file_${n})},\n")
  math(EXPR n "${n} + 1")
endforeach()
file(WRITE ${OUT} "// Written by cmake/embed.cmake.
#include \"app/serve/page.hpp\"

#include <array>
#include <cstddef>

namespace bankshot::app::serve {
namespace {

${arrays}
template <std::size_t N>
std::string_view text(const unsigned char (&bytes)[N]) {
  return {reinterpret_cast<const char*>(bytes), N};
}

}  // namespace

std::span<const PageFile> page_files() {
  static const std::array<PageFile, ${n}> files{{
${list}  }};
  return files;
}

}  // namespace bankshot::app::serve
")
