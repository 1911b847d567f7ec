# SPDX-License-Identifier: Apache-2.0
# Puts style and scripts into a page and the page into a C++ source, so that the program carries it
# and the parts stay editable.
#   lac_embed_page(<file.cpp> <symbol> PAGE <page.html> STYLES <css>... SCRIPTS <js>...)
# makes that file: const char <symbol>[] in lac::sim. Paths count from the calling folder; the head
# and style of all pages and page_plot.js, page_tables.js come by themselves.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(lac_page_folder ${CMAKE_CURRENT_LIST_DIR} CACHE INTERNAL "")
  function(lac_embed_page output symbol)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "PAGE" "STYLES;SCRIPTS")
    list(TRANSFORM arg_STYLES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    list(TRANSFORM arg_SCRIPTS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    set(page ${CMAKE_CURRENT_SOURCE_DIR}/${arg_PAGE})
    list(PREPEND arg_STYLES ${lac_page_folder}/page_style.css)
    list(PREPEND arg_SCRIPTS ${lac_page_folder}/page_plot.js ${lac_page_folder}/page_tables.js)
    set(embed ${lac_page_folder}/embed_page.cmake)
    set(head ${lac_page_folder}/page_head.html)
    list(JOIN arg_STYLES "|" styles)
    list(JOIN arg_SCRIPTS "|" scripts)
    add_custom_command(OUTPUT ${output} DEPENDS ${embed} ${head} ${page} ${arg_STYLES} ${arg_SCRIPTS}
      COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DSYMBOL=${symbol} -DHEAD=${head} -DPAGE=${page}
              -DSTYLES=${styles} -DSCRIPTS=${scripts} -P ${embed}
      COMMENT "Embedding ${arg_PAGE}" VERBATIM)
  endfunction()
  return()
endif()

function(read_all paths result)
  string(REPLACE "|" ";" files "${paths}")
  foreach(file ${files})
    file(READ ${file} text)
    string(APPEND all "${text}")
  endforeach()
  set(${result} "${all}" PARENT_SCOPE)
endfunction()

file(READ ${PAGE} page)
file(READ ${HEAD} head)
read_all("${STYLES}" style)
read_all("${SCRIPTS}" script)
string(REPLACE "<!-- SPDX-License-Identifier: Apache-2.0 -->\n<!--lac:head-->\n" "${head}" page "${page}")
string(REPLACE "<!--lac:style-->" "${style}" page "${page}")
string(REPLACE "<!--lac:script-->" "\"use strict\";\n${script}" page "${page}")
file(WRITE ${OUTPUT} "// SPDX-License-Identifier: Apache-2.0
// Made by embed_page.cmake.
namespace lac::sim {
extern const char ${SYMBOL}[];
const char ${SYMBOL}[] = R\"lacpage(${page})lacpage\";
}  // namespace lac::sim
")
