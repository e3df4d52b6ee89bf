/* SPDX-License-Identifier: MIT
 *
 * bankshot in C: JSON in, JSON out, as the program prints it (docs/format.md); and, for many launches of one scene,
 * plain structs. Link with libbankshot (pkg-config bankshot).
 *
 * Every function may be called from any thread at any time, and none throws or ends the program. What a function hands
 * out belongs to the caller, who gives it back with bankshot_free or bankshot_scene_free. Texts are UTF-8, lengths are
 * in bytes and without the 0 that stands behind each text. SI units; angles in JSON in degrees, in structs in radians.
 */
#ifndef BANKSHOT_BANKSHOT_H
#define BANKSHOT_BANKSHOT_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define BANKSHOT_API
#else
#define BANKSHOT_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever a program that was built with an older one would no longer work. */
#define BANKSHOT_ABI_VERSION 1

BANKSHOT_API int bankshot_abi_version(void);     /* of the library that is loaded */
BANKSHOT_API const char* bankshot_version(void); /* "0.1.0"; not to be freed */

typedef enum bankshot_status {
  BANKSHOT_DONE = 0,      /* as the program's exit codes: */
  BANKSHOT_NOTHING = 1,   /* no shot, or a claim that does not hold; the text says so */
  BANKSHOT_BAD_INPUT = 2, /* the text is {"path": "/ball/at", "reason": "..."} */
  BANKSHOT_NO_MEMORY = 3  /* there is no text */
} bankshot_status;

/* A text and its length. Free it with bankshot_free(text.data). */
typedef struct bankshot_text {
  char* data;
  size_t length;
} bankshot_text;

/* `flags` as the server takes them, names and values of the command line: "all&path&budget=500&noise=league". NULL: none. */

/* A puzzle; the text is what `bankshot solve --json` prints. */
BANKSHOT_API bankshot_status bankshot_solve(const char* puzzle, size_t length, const char* flags,
                                            bankshot_text* answer);
/* A shot; as `bankshot simulate --json`, or with the flag csv (and rate=HZ) a table. */
BANKSHOT_API bankshot_status bankshot_simulate(const char* shot, size_t length, const char* flags, bankshot_text* path);
/* From where on the table a puzzle's shot can be made: CSV, or with the flag svg a picture; grid=NX,NY. */
BANKSHOT_API bankshot_status bankshot_map(const char* puzzle, size_t length, const char* flags, bankshot_text* map);
/* Every claim of an answer held against 50 digits: {"holds": true, "checked": 14, "failed": [{"claim": ...}]}. */
BANKSHOT_API bankshot_status bankshot_verify(const char* puzzle, size_t puzzle_length, const char* answer,
                                             size_t answer_length, bankshot_text* report);
/* The JSON Schema of "puzzle", "shot" or "answer". */
BANKSHOT_API bankshot_status bankshot_schema(const char* document, bankshot_text* schema);

/* What the functions above handed out; NULL is allowed. */
BANKSHOT_API void bankshot_free(char* data);

/* The hot path. A scene is a `simulate` document; its shot counts only where a launch is missing. */
typedef struct bankshot_scene bankshot_scene;

/* NULL where the document is wrong; then `error`, unless NULL, is {"path": ..., "reason": ...}. */
BANKSHOT_API bankshot_scene* bankshot_scene_new(const char* shot, size_t length, bankshot_text* error);
BANKSHOT_API void bankshot_scene_free(bankshot_scene* scene);

typedef struct bankshot_launch {
  double speed, angle;     /* m/s; radians, anticlockwise from +x */
  double top, side, masse; /* spin, in units of natural roll */
} bankshot_launch;

typedef enum bankshot_end_kind {
  BANKSHOT_END_REST = 0,
  BANKSHOT_END_UNTIL = 1, /* time, cushions or length of the scene's `until` */
  BANKSHOT_END_POCKETED = 2,
  BANKSHOT_END_EVENTS = 3, /* too many of them */
  BANKSHOT_END_INVALID = 4 /* the launch is no launch: a number that is not finite, a speed that is not above 0, or spin
                              in physics that have none */
} bankshot_end_kind;

/* How the cue ball ends. */
typedef struct bankshot_end {
  double time, length; /* s, m of its path */
  double x, y;         /* m */
  double vx, vy;       /* m/s */
  double wx, wy, wz;   /* rad/s */
  int32_t cushions;    /* bounces */
  int32_t kind;        /* bankshot_end_kind */
  int32_t pocket;      /* which, in the order of the table; -1: none */
  int32_t reserved;
} bankshot_end;

/* `ends[i]` for `launches[i]`, on so many threads (0: one for each core). */
BANKSHOT_API bankshot_status bankshot_simulate_many(const bankshot_scene* scene, const bankshot_launch* launches,
                                                    size_t count, bankshot_end* ends, int threads);

#ifdef __cplusplus
}
#endif

#endif /* BANKSHOT_BANKSHOT_H */
