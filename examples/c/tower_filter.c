/* SPDX-License-Identifier: Apache-2.0
 *
 * A secondary controller in C, made to be copied: it cleans the tower-top fore-aft acceleration
 * (record 53) for all libraries called after it, by a notch at the blade passing frequency and a
 * low-pass. What it writes is also put into a record of its own, if its input file names one.
 *
 * State is static, the simplest there is: the LAC master loads one private copy of such a library
 * for each turbine. (The C++ example keeps one state per turbine itself.) */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/discon_abi.h"

LAC_DISCON_EXPORT void LAC_DISCON_CALL DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE,
                                              char* avcOUTNAME, char* avcMSG);

/* Records, counted from 1 as in all documents. */
enum {
  STATUS = 1,
  TIME_STEP = 3,
  MESSAGE_CAPACITY = 49,
  IN_FILE_LENGTH = 50,
  TOWER_ACCELERATION = 53,
  EXTENDED_START = 66,
  ARRAY_SIZE = 129
};

static const char kMagic[8] = "TOWERF1";
static const double kPi = 3.14159265358979323846;

/* y = (b0 + b1/z + b2/z^2)/(1 + a1/z + a2/z^2) x */
struct second_order {
  double b0, b1, b2, a1, a2, z1, z2;
};

/* Everything that a checkpoint must bring back, the parameters included: a restarted process is
 * told the name of the checkpoint, not that of the input file. */
static struct {
  char magic[8];
  struct second_order notch, low_pass;
  int signal_record; /* 0: none */
} filter;

static float* record(float* swap, int number) {
  return &swap[number - 1];
}

/* Records that may be touched: 164 with every host, more where the host says so. */
static int known_records(float* swap) {
  const int size = (int)*record(swap, ARRAY_SIZE);
  return *record(swap, EXTENDED_START) == 1001.0F && size > 164 ? size : 164;
}

/* aviFAIL = -1 ends the run; the text, its terminator included, must fit into record 49. */
static void fail(float* swap, int* fail_flag, char* message, const char* format, ...) {
  const float capacity = *record(swap, MESSAGE_CAPACITY);
  va_list arguments;
  *fail_flag = -1;
  if (capacity < 1.0F) return;
  va_start(arguments, format);
  vsnprintf(message, (size_t)capacity, format, arguments);
  va_end(arguments);
}

/* The host counts the terminator in record 50 or not, and may send none: take at most that many
 * characters and stop at the first NUL. 0 if the name does not fit. */
static int copy_name(const char* text, float length, char* name, size_t capacity) {
  size_t n = 0;
  while ((float)n < length && text[n] != '\0') {
    if (n + 1 >= capacity) return 0;
    name[n] = text[n];
    ++n;
  }
  name[n] = '\0';
  return n > 0;
}

/* Looks for the line "value ! key"; gives `fallback` if there is none. */
static double read_number(FILE* file, const char* key, double fallback) {
  char line[512], word[64];
  double value = 0.0;
  rewind(file);
  while (fgets(line, sizeof line, file) != NULL) {
    if (sscanf(line, "%lf ! %63s", &value, word) == 2 && strcmp(word, key) == 0) return value;
  }
  return fallback;
}

/* (s^2 numerator + s_term w s + w^2)/(s^2 + 2 damping w s + w^2), bilinear, exact at w. */
static struct second_order design(double s2, double s_term, double damping, double frequency_Hz,
                                  double time_step_s) {
  const double w = 2.0 * tan(kPi * frequency_Hz * time_step_s) / time_step_s;
  const double c = 2.0 / time_step_s;
  const double scale = c * c + 2.0 * damping * w * c + w * w;
  struct second_order f = {0};
  f.b0 = (s2 * c * c + s_term * w * c + w * w) / scale;
  f.b1 = 2.0 * (w * w - s2 * c * c) / scale;
  f.b2 = (s2 * c * c - s_term * w * c + w * w) / scale;
  f.a1 = 2.0 * (w * w - c * c) / scale;
  f.a2 = (c * c - 2.0 * damping * w * c + w * w) / scale;
  return f;
}

static double filter_step(struct second_order* f, double x) {
  const double y = f->b0 * x + f->z1;
  f->z1 = f->b1 * x - f->a1 * y + f->z2;
  f->z2 = f->b2 * x - f->a2 * y;
  return y;
}

/* As if the input had been x for ever: no transient at the start. */
static void settle(struct second_order* f, double x) {
  f->z2 = (f->b2 - f->a2) * x;
  f->z1 = (f->b1 - f->a1) * x + f->z2;
}

/* Each step: no memory, no files. */
static void step(float* swap) {
  float* acceleration = record(swap, TOWER_ACCELERATION);
  if (!isfinite(*acceleration)) return;
  *acceleration =
      (float)filter_step(&filter.low_pass, filter_step(&filter.notch, (double)*acceleration));
  if (filter.signal_record > 0) *record(swap, filter.signal_record) = *acceleration;
}

static void start(float* swap, int* fail_flag, const char* name, char* message) {
  const double time_step_s = (double)*record(swap, TIME_STEP);
  const double x = (double)*record(swap, TOWER_ACCELERATION);
  FILE* file = fopen(name, "r");
  if (file == NULL) {
    fail(swap, fail_flag, message, "tower_filter: %s cannot be opened", name);
    return;
  }
  const double notch_Hz = read_number(file, "NotchFrequency", -1.0);
  const double low_pass_Hz = read_number(file, "LowPassFrequency", -1.0);
  filter.signal_record = (int)read_number(file, "SignalRecord", 0.0);
  fclose(file);

  const double nyquist_Hz = 0.5 / time_step_s;
  if (notch_Hz <= 0.0 || low_pass_Hz <= 0.0 || notch_Hz >= nyquist_Hz ||
      low_pass_Hz >= nyquist_Hz) {
    fail(swap, fail_flag, message,
         "tower_filter: %s: expected NotchFrequency and LowPassFrequency between 0 and %g Hz", name,
         nyquist_Hz);
  } else if (filter.signal_record < 0 || filter.signal_record > known_records(swap)) {
    fail(swap, fail_flag, message,
         "tower_filter: %s: found SignalRecord %d, expected 0 (none) to %d", name,
         filter.signal_record, known_records(swap));
  } else {
    memcpy(filter.magic, kMagic, sizeof kMagic);
    filter.notch = design(1.0, 0.0, 0.2, notch_Hz, time_step_s);
    filter.low_pass = design(0.0, 0.0, 0.7, low_pass_Hz, time_step_s);
    settle(&filter.notch, x);
    settle(&filter.low_pass, x);
    step(swap);
  }
}

/* -8 and -9: save or load, and touch nothing else. */
static void save(float* swap, int* fail_flag, const char* name, char* message) {
  FILE* file = fopen(name, "wb");
  const int written = file != NULL && fwrite(&filter, sizeof filter, 1, file) == 1;
  if ((file != NULL && fclose(file) != 0) || !written) {
    fail(swap, fail_flag, message, "tower_filter: %s cannot be written", name);
  }
}

static void load(float* swap, int* fail_flag, const char* name, char* message) {
  FILE* file = fopen(name, "rb");
  const int complete = file != NULL && fread(&filter, sizeof filter, 1, file) == 1;
  if (file != NULL) fclose(file);
  if (!complete || memcmp(filter.magic, kMagic, sizeof kMagic) != 0) {
    fail(swap, fail_flag, message, "tower_filter: %s is not a checkpoint of this library", name);
  }
}

void DISCON(float* avrSWAP, int* aviFAIL, const char* accINFILE, char* avcOUTNAME, char* avcMSG) {
  const int status = (int)lroundf(*record(avrSWAP, STATUS));
  char name[2048];
  (void)avcOUTNAME; /* writes no file of its own */
  *aviFAIL = 0;
  if (status == LAC_STATUS_STEP) {
    step(avrSWAP);
  } else if (status == LAC_STATUS_FIRST || status == LAC_STATUS_CHECKPOINT ||
             status == LAC_STATUS_RESTART) {
    if (!copy_name(accINFILE, *record(avrSWAP, IN_FILE_LENGTH), name, sizeof name)) {
      fail(avrSWAP, aviFAIL, avcMSG, "tower_filter: the file name is empty or too long");
    } else if (status == LAC_STATUS_FIRST) {
      start(avrSWAP, aviFAIL, name, avcMSG);
    } else if (status == LAC_STATUS_CHECKPOINT) {
      save(avrSWAP, aviFAIL, name, avcMSG);
    } else {
      load(avrSWAP, aviFAIL, name, avcMSG);
    }
  }
  /* -1: nothing to give back. All other statuses: not known, nothing is done. */
}
