/* SPDX-License-Identifier: Apache-2.0
 * What toy_whole is linked to. */
#include "core/discon_abi.h"

LAC_DISCON_EXPORT float toy_part(float x);

float toy_part(float x) {
  return 2.0f * x;
}
