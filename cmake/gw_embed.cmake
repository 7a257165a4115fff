# Embeds text files as functions. For example, `style()` returns the content of style.css.
#
#   gw_embed(<target> NAMESPACE <namespace> FILES <file>…)
#
# The target is a new object library. Each file becomes one of its sources, which is made again when the file changes. The function
# `std::string_view <name of the file>()` returns a newline followed by the bytes of the file, so
# that a text between tags begins on a line of its own. The caller declares the function.
#
# The script part (cmake -P) writes one such source. A literal contains at most kPart bytes, because
# some compilers accept no more than 16 kB. It ends at the end of a line, so that no character is
# split.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  include_guard()
  set(gw_embed_script ${CMAKE_CURRENT_LIST_FILE})

  function(gw_embed target)
    cmake_parse_arguments(arg "" "NAMESPACE" "FILES" ${ARGN})
    set(sources "")
    foreach(file IN LISTS arg_FILES)
      cmake_path(GET file STEM name)
      set(made ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
      add_custom_command(
        OUTPUT ${made}
        COMMAND ${CMAKE_COMMAND} -DFILE=${file} -DNAME=${name} -DNAMESPACE=${arg_NAMESPACE}
                -DMADE=${made} -P ${gw_embed_script}
        DEPENDS ${file} ${gw_embed_script}
        COMMENT "Embedding ${name}"
        VERBATIM)
      list(APPEND sources ${made})
    endforeach()
    add_library(${target} OBJECT ${sources})
    gw_target(${target})
  endfunction()
  return()
endif()

set(kPart 8000)
file(READ "${FILE}" text)
string(FIND "${text}" ")gw\"" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "${FILE} holds the end of a literal: )gw\"")
endif()
set(literals "")
string(LENGTH "${text}" left)
while(left GREATER 0)
  string(SUBSTRING "${text}" 0 ${kPart} part)
  if(left GREATER kPart)
    string(FIND "${part}" "\n" last REVERSE)
    if(last EQUAL -1)
      message(FATAL_ERROR "${FILE} has a line of more than ${kPart} bytes")
    endif()
    math(EXPR length "${last} + 1")
    string(SUBSTRING "${part}" 0 ${length} part)
  else()
    set(length ${left})
  endif()
  string(APPEND literals "\n    R\"gw(${part})gw\"")
  string(SUBSTRING "${text}" ${length} -1 text)
  string(LENGTH "${text}" left)
endwhile()
cmake_path(GET FILE FILENAME source)
file(WRITE "${MADE}" "// Made from ${source} by cmake/gw_embed.cmake.
#include <string_view>

namespace ${NAMESPACE} {

std::string_view ${NAME}();

std::string_view ${NAME}() {
  return \"\\n\"${literals};
}

}  // namespace ${NAMESPACE}
")
