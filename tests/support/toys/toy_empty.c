/* SPDX-License-Identifier: Apache-2.0
 * A controller in C that does nothing, under two names. */
#include "core/discon_abi.h"

LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                              char* avcOUTNAME, char* avcMSG);
LAC_DISCON_EXPORT void LAC_DISCON_CALL my_controller(float* avrSWAP, int* aviFAIL,
                                                     const char* accINFILE, char* avcOUTNAME,
                                                     char* avcMSG);

void DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  (void)avrSWAP;
  (void)accINFILE;
  (void)avcOUTNAME;
  *aviFAIL = 0;
  avcMSG[0] = '\0';
}

void my_controller(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME,
                   char* avcMSG) {
  DISCON(avrSWAP, aviFAIL, accINFILE, avcOUTNAME, avcMSG);
  avrSWAP[46] = 4711.0f;
}
