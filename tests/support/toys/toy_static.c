/* SPDX-License-Identifier: Apache-2.0
 * A controller with static state, as most in the field: refuses a second first call in one image,
 * blank-pads its message always, leaves rubbish in aviFAIL's place only if asked to. */
#include <string.h>

#include "core/discon_abi.h"

LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                              char* avcOUTNAME, char* avcMSG);

static int first_calls = 0;
static float steps = 0.0f;

void DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  const size_t capacity = (size_t)avrSWAP[48];
  (void)accINFILE;
  (void)avcOUTNAME;
  memset(avcMSG, ' ', capacity - 1);
  avcMSG[capacity - 1] = '\0';
  *aviFAIL = 0;
  if (avrSWAP[0] == 0.0f && ++first_calls > 1) {
    memcpy(avcMSG, "already loaded", 14);
    *aviFAIL = -1;
  }
  steps += 1.0f;
  avrSWAP[46] = steps;
}
