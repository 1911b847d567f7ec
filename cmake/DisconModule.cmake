# SPDX-License-Identifier: Apache-2.0
# Helpers that keep the CMakeLists files a table of contents.

# Everything that a host or a master can load, and what such a library has beside its module.
add_custom_target(lac_libraries)
set(LAC_DISCON_EXPORT ${CMAKE_SOURCE_DIR}/core/discon_export.cpp)
if(MINGW)
  list(APPEND LAC_DISCON_EXPORT ${CMAKE_SOURCE_DIR}/core/discon_unload_windows.cpp)
endif()

# add_discon_module(<name> SOURCES...): the library liblac_<name>.so (.dll) that a host loads.
# It carries its own copy of the shared core and of the C++ runtime and exports DISCON alone; no
# symbol is shared with other libraries, so the loader really drops it at dlclose. The equations are
# a static library lac_<name>_core beside it, so that tests reach them without the C boundary.
function(add_discon_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;ENTRY" ${ARGN})
  add_library(lac_${name}_core STATIC ${ARG_SOURCES})
  target_link_libraries(lac_${name}_core PUBLIC lac_core)
  add_library(lac_${name} MODULE ${ARG_ENTRY} ${LAC_DISCON_EXPORT})
  target_link_libraries(lac_${name} PRIVATE lac_${name}_core)
  set_target_properties(lac_${name} PROPERTIES
    PREFIX "lib"
    LINK_DEPENDS ${CMAKE_SOURCE_DIR}/cmake/exports.map)
  if(NOT WIN32)  # there nothing is exported but what is declared so, and nothing stays undefined
    target_link_options(lac_${name} PRIVATE
      -Wl,-z,defs -Wl,--version-script=${CMAKE_SOURCE_DIR}/cmake/exports.map)
  endif()
  if(LAC_SANITIZE)
    target_link_options(lac_${name} PRIVATE -Wl,-z,undefs)  # the runtime is in the host program
  else()
    target_link_options(lac_${name} PRIVATE -static-libstdc++ -static-libgcc)
    target_compile_definitions(lac_${name} PRIVATE LAC_OWN_CXX_RUNTIME)
  endif()
  add_dependencies(lac_libraries lac_${name})
  install(TARGETS lac_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# lac_test(<area>/<file> LIBS...): tests/<area>/<file>_test.cpp as one CTest entry per file.
function(lac_test path)
  string(REPLACE "/" "_" name ${path})
  add_executable(${name}_test ${CMAKE_SOURCE_DIR}/tests/${path}_test.cpp)
  target_link_libraries(${name}_test PRIVATE ${ARGN} lac_test_support GTest::gmock GTest::gtest_main)
  set_target_properties(${name}_test PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(WIN32)
    target_compile_options(${name}_test PRIVATE -O0)  # built beside Linux; what is tested keeps -O2
  endif()
  add_test(NAME ${path} COMMAND ${name}_test)
endfunction()
