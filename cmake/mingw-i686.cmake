# SPDX-License-Identifier: Apache-2.0
# 32-bit Windows, for Bladed. Hosts and the loader keep the stack aligned to 4 bytes only, so
# functions align their own. SSE arithmetic gives the results of the 64-bit libraries, which the x87
# unit with its longer registers does not.
set(CMAKE_SYSTEM_PROCESSOR i686)
set(MINGW_TRIPLET i686-w64-mingw32)
include(${CMAKE_CURRENT_LIST_DIR}/mingw-common.cmake)
set(flags "-msse2 -mfpmath=sse -mstackrealign")
set(CMAKE_C_FLAGS_INIT ${flags})
set(CMAKE_CXX_FLAGS_INIT ${flags})
