# SPDX-License-Identifier: MIT
# For Doxygen: the comment between the licence and #pragma once becomes the documentation of the file, word by word.
NR == 1 { print "/** \\file"; next }
NR == 2 && /^\/\/$/ { page = 1; print "\\verbatim"; next }
NR == 2 { print "*/ " $0; next }
/^#pragma once/ && page { print "\\endverbatim */ " $0; page = 0; next }
page { sub(/^\/\/ ?/, ""); gsub(/\*\//, "* /"); gsub(/\/\*/, "/ *") }
{ print }
