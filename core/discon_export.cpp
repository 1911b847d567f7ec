// SPDX-License-Identifier: Apache-2.0
// What a library exports: its entry, and that it keeps its state per turbine.
#include <cstddef>  // says whose C++ runtime it is: __GLIBCXX__

#include "core/discon_abi.h"
#include "core/discon_entry.hpp"

const int LAC_DISCON_REENTRANT = 1;

#if defined(_WIN32) && defined(__i386__)
// Hosts align the stack to 4 bytes there, GCC's code needs 16.
#define LAC_ALIGN_STACK __attribute__((force_align_arg_pointer))
#else
#define LAC_ALIGN_STACK
#endif

extern "C" LAC_ALIGN_STACK LAC_DISCON_EXPORT void LAC_DISCON_CALL
DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  lac::discon_entry(avrSWAP, aviFAIL, accINFILE, avcOUTNAME, avcMSG);
}

#if defined(LAC_OWN_CXX_RUNTIME) && defined(__GLIBCXX__)
namespace __gnu_cxx {
void __freeres();  // NOLINT(bugprone-reserved-identifier): so it is called
}
// The runtime inside the library reserves 71 KiB for exceptions without memory, and leaves them
// behind when the library is unloaded: so much for each run of a host that loads anew.
__attribute__((destructor)) static void give_back_reserve() {
  __gnu_cxx::__freeres();
}
#endif
