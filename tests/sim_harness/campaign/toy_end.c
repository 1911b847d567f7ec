/* SPDX-License-Identifier: Apache-2.0
 * A controller that ends its process in the way its input file says: crash, exit, hang, fail; or
 * flies on with constant demands. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/discon_abi.h"

LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                              char* avcOUTNAME, char* avcMSG);

static void end(const char* how, int* aviFAIL, char* avcMSG) {
  if (strcmp(how, "crash") == 0) abort();
  if (strcmp(how, "exit") == 0) exit(3);
  while (strcmp(how, "hang") == 0) {
  }
  if (strcmp(how, "fail") == 0) {
    *aviFAIL = -1;
    strcpy(avcMSG, "the toy had enough");
  }
}

void DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  char how[16] = "";
  (void)avcOUTNAME;
  *aviFAIL = 0;
  avrSWAP[44] = 0.26f;
  avrSWAP[46] = 43000.0f;
  if (avrSWAP[1] == 1.0f) {
    FILE* file = fopen(accINFILE, "r");
    if (file == NULL || fscanf(file, "%15s", how) != 1) *aviFAIL = -1;
    if (file != NULL) fclose(file);
    end(how, aviFAIL, avcMSG);
  }
}
