# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=<file.cpp> -P embed_page.cmake: puts style and scripts into the page and the
# page into a C++ source, so that the program carries it and the parts stay editable.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(READ ${here}/report_page.html page)
file(READ ${here}/report_page.css style)
set(script "\"use strict\";\n")
foreach(part report_plot report_traces report_trace_input report_spectra)
  file(READ ${here}/${part}.js text)
  string(APPEND script "${text}")
endforeach()
string(REPLACE "<!--lac:style-->" "${style}" page "${page}")
string(REPLACE "<!--lac:script-->" "${script}" page "${page}")
file(WRITE ${OUTPUT} "// SPDX-License-Identifier: Apache-2.0
// Made by embed_page.cmake.
namespace lac::sim {
extern const char kReportPage[];
const char kReportPage[] = R\"lacpage(${page})lacpage\";
}  // namespace lac::sim
")
