/* SPDX-License-Identifier: Apache-2.0
 *
 * The contract between a host and a controller library, as every Bladed-style host speaks it.
 * Valid C11 and C++; hosts, libraries and tests include this one file.
 *
 * One function, five pointers, C linkage, no return value. All memory belongs to the caller.
 *
 *   avrSWAP     float array, called "records" and counted from 1 (record n is avrSWAP[n-1]).
 *               Address may change from call to call. Length: see known_array_size() in
 *               swap_view.hpp; 164 records may always be touched.
 *   aviFAIL     set by the library: 0 fine; > 0 warning, text in avcMSG, the run goes on;
 *               < 0 failure, text in avcMSG, the host ends the run.
 *   accINFILE   input file of the library, record 50 characters (with or without the NUL).
 *               At statuses -8 and -9: the checkpoint file.
 *   avcOUTNAME  root name for the library's output files, record 51 characters; may be written
 *               only if record 64 (its capacity) is larger than the text.
 *   avcMSG      at most record 49 characters including the NUL.
 *   Strings are valid during the call only; bytes behind the first NUL are undefined.
 *
 * Order of calls for one turbine, never two at once (different turbines: any thread, any time):
 *
 *   FIRST [once; may allocate, read files]
 *     -> STEP ... STEP [real time: no allocation, no files, no locks]
 *     -> LAST [once; may write files]
 *   CHECKPOINT may come between two STEPs; RESTART replaces FIRST in a new process;
 *   STORE / RESTORE keep and bring back the state in memory between two STEPs.
 *   Any other status is ignored: nothing is read, written or advanced.
 */
#ifndef LAC_CORE_DISCON_ABI_H
#define LAC_CORE_DISCON_ABI_H

#if defined(_WIN32)
#define LAC_DISCON_EXPORT __declspec(dllexport)
#define LAC_DISCON_CALL __cdecl
#else
#define LAC_DISCON_EXPORT __attribute__((visibility("default")))
#define LAC_DISCON_CALL
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Record 1. */
enum LacDisconStatus {
  LAC_STATUS_STORE = -11,     /* keep the state in memory */
  LAC_STATUS_RESTORE = -10,   /* go back to the state kept last */
  LAC_STATUS_RESTART = -9,    /* first call of a process that continues from a checkpoint */
  LAC_STATUS_CHECKPOINT = -8, /* write the state to the file accINFILE */
  LAC_STATUS_LAST = -1,
  LAC_STATUS_FIRST = 0,
  LAC_STATUS_STEP = 1
};

typedef void(LAC_DISCON_CALL* LacDisconFunction)(float* avrSWAP, int* aviFAIL,
                                                 const char* accINFILE, char* avcOUTNAME,
                                                 char* avcMSG);

/* A library may be called for several turbines of one process, from several threads at once, and
 * for several runs one after another, if it keeps all its data per turbine. One that does says so
 * by defining this constant as 1, and the master then opens its file once:
 *
 *   const int LAC_DISCON_REENTRANT = 1;
 *
 * A library without it is taken to have static data (Fortran: SAVE, module variables): each
 * turbine and each run gets a copy of the file in memory. Start-up code of the library runs in
 * each copy, once more in the original, and before any call. */
extern LAC_DISCON_EXPORT const int LAC_DISCON_REENTRANT;

#ifdef __cplusplus
}
#endif

#endif
