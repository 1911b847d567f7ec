// SPDX-License-Identifier: Apache-2.0
// The one symbol a library exports.
#include "core/discon_abi.h"
#include "core/discon_entry.hpp"

extern "C" LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL,
                                                         const char* accINFILE, char* avcOUTNAME,
                                                         char* avcMSG) {
  lac::discon_entry(avrSWAP, aviFAIL, accINFILE, avcOUTNAME, avcMSG);
}
