/* SPDX-License-Identifier: Apache-2.0
 * What the libraries of Guo's chain do with their lidar block, in few lines and with static data:
 * entry LDP puts the mean of the last two speeds of the first gate behind the block, entry FFP
 * delays it by DELAY steps of a buffer filled with the first value, and takes 0.02 rad per m/s.
 * Both take every status for a step, as theirs; what they cannot survive (-9) ends the process. */
#include <math.h>
#include <stdlib.h>

#include "core/discon_abi.h"

enum { DELAY = 4 };

LAC_DISCON_EXPORT void LAC_DISCON_CALL LDP(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                           char* avcOUTNAME, char* avcMSG);
LAC_DISCON_EXPORT void LAC_DISCON_CALL FFP(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                           char* avcOUTNAME, char* avcMSG);

static float older = 0.0f;
static float buffer[DELAY];
static float last_pitch = 0.0f;

void LDP(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  float* block = avrSWAP + lroundf(avrSWAP[62]) - 1;
  float* results = block + 3 + lroundf(block[2]) + 6;
  (void)accINFILE, (void)avcOUTNAME, (void)avcMSG;
  if (avrSWAP[0] == -9.0f) abort();
  if (block[0] == 1.0f) {
    if (older == 0.0f) older = block[3];
    results[0] = 0.5f * (older + block[3]);
    older = block[3];
  }
  *aviFAIL = 0;
}

void FFP(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  float* block = avrSWAP + lroundf(avrSWAP[62]) - 1;
  float* results = block + 3 + lroundf(block[2]) + 6;
  float pitch = 0.0f;
  int i = 0;
  (void)accINFILE, (void)avcOUTNAME, (void)avcMSG;
  if (avrSWAP[0] == -9.0f) abort();
  for (i = DELAY - 1; i > 0; --i) buffer[i] = avrSWAP[0] == 0.0f ? results[0] : buffer[i - 1];
  buffer[0] = results[0];
  pitch = 0.02f * buffer[DELAY - 1];
  results[1] = buffer[DELAY - 1];
  results[2] = avrSWAP[0] == 0.0f ? 0.0f : (pitch - last_pitch) / avrSWAP[2];
  results[3] = results[0];
  last_pitch = pitch;
  *aviFAIL = 0;
}
