# SPDX-License-Identifier: Apache-2.0
# cmake -DFROM=page.html -DTO=page_template.cc -DNAME=built_page_template -P embed_page.cmake: the bytes of a text file as
# a C++ function of that name.
file(READ "${FROM}" page)
string(FIND "${page}" "@@QUOIN_TITLE@@" title)
string(FIND "${page}" "<!--@@QUOIN_SCENE@@-->" scene)
string(FIND "${page}" ")page\"" end)
if(title LESS 0 OR scene LESS 0 OR end GREATER_EQUAL 0)
  message(FATAL_ERROR "${FROM}: not a page of the view")
endif()
file(WRITE "${TO}" "#include <string_view>
namespace quoin {
std::string_view ${NAME}();
std::string_view ${NAME}() { return R\"page(${page})page\"; }
}  // namespace quoin
")
