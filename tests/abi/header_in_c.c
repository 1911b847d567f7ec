/* SPDX-License-Identifier: Apache-2.0
 * The contract's header as a C program sees it. */
#include "core/discon_abi.h"

void my_discon(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG);
int lac_statuses_in_c(const int** values);

void my_discon(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME,
               char* avcMSG) {
  (void)accINFILE;
  (void)avcOUTNAME;
  (void)avcMSG;
  *aviFAIL = (int)avrSWAP[0];
}

int lac_statuses_in_c(const int** values) {
  static const int all[] = {LAC_STATUS_STORE,      LAC_STATUS_RESTORE, LAC_STATUS_RESTART,
                            LAC_STATUS_CHECKPOINT, LAC_STATUS_LAST,    LAC_STATUS_FIRST,
                            LAC_STATUS_STEP};
  LacDisconFunction function = my_discon;
  float swap = 5.0f;
  int fail = 0;
  function(&swap, &fail, "", 0, 0);
  *values = all;
  return fail == 5 ? (int)(sizeof all / sizeof all[0]) : -1;
}
