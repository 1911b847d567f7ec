# SPDX-License-Identifier: Apache-2.0
# Settings every target shares: language, warnings, hidden symbols, output folders, sanitizers.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

option(LAC_WERROR "Warnings are errors, as in the project's own checks" OFF)
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${LAC_WERROR}>:-Werror>)
if(LAC_SANITIZE)
  add_compile_options(-fsanitize=${LAC_SANITIZE} -fno-omit-frame-pointer -UNDEBUG)
  add_link_options(-fsanitize=${LAC_SANITIZE})
endif()
if(MINGW)
  # The run-time libraries of GCC go inside: hosts have none beside them. Equal sources give equal
  # files.
  add_link_options(-static -Wl,--no-insert-timestamp $<$<CONFIG:Release>:-s>)
endif()

include(GNUInstallDirs)
include_directories(${CMAKE_SOURCE_DIR})
