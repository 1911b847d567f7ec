/* SPDX-License-Identifier: Apache-2.0
 * A controller that needs another library: twice the number of its calls goes to the torque
 * demand. */
#include "core/discon_abi.h"

LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                              char* avcOUTNAME, char* avcMSG);
float toy_part(float x);

static float calls = 0.0f;

void DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  (void)accINFILE;
  (void)avcOUTNAME;
  (void)avcMSG;
  calls += 1.0f;
  avrSWAP[46] = toy_part(calls);
  *aviFAIL = 0;
}
