/* SPDX-License-Identifier: MIT
 *
 * The C interface of bankshot. It takes JSON and returns JSON as the program prints it (docs/format.md). Many launches
 * of one scene use plain structs instead. Link with libbankshot (pkg-config bankshot).
 *
 * Every function may be called from any thread at any time, and none throws or ends the program. The caller owns what a
 * function returns and releases it with bankshot_free or bankshot_scene_free. Texts are UTF-8; lengths are in bytes and
 * exclude the terminating 0. Units are SI. Angles are in degrees in JSON and in radians in structs.
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

/* Raised whenever a program built against an older version would no longer work. */
#define BANKSHOT_ABI_VERSION 1

BANKSHOT_API int bankshot_abi_version(void);     /* version of the loaded library */
BANKSHOT_API const char* bankshot_version(void); /* such as "0.1.0"; do not free it */

typedef enum bankshot_status {
  BANKSHOT_DONE = 0,      /* success; the values equal the program's exit codes */
  BANKSHOT_NOTHING = 1,   /* no shot, or a claim does not hold; the text gives details */
  BANKSHOT_BAD_INPUT = 2, /* the text is {"path": "/ball/at", "reason": "..."} */
  BANKSHOT_NO_MEMORY = 3  /* there is no text */
} bankshot_status;

/* A text and its length. Free it with bankshot_free(text.data). */
typedef struct bankshot_text {
  char* data;
  size_t length;
} bankshot_text;

/* `flags` holds command-line flags in the server's form: "all&path&budget=500&noise=league". NULL means none. */

/* Solves a puzzle; the text is what `bankshot solve --json` prints. */
BANKSHOT_API bankshot_status bankshot_solve(const char* puzzle, size_t length, const char* flags,
                                            bankshot_text* answer);
/* Simulates a shot; the text is what `bankshot simulate --json` prints, or CSV with the flag csv (and rate=HZ). */
BANKSHOT_API bankshot_status bankshot_simulate(const char* shot, size_t length, const char* flags, bankshot_text* path);
/* Maps the starts from which a puzzle can be solved: CSV, or a picture with the flag svg; grid=NX,NY. */
BANKSHOT_API bankshot_status bankshot_map(const char* puzzle, size_t length, const char* flags, bankshot_text* map);
/* Checks every claim of an answer in 50 digits: {"holds": true, "checked": 14, "failed": [{"claim": ...}]}. */
BANKSHOT_API bankshot_status bankshot_verify(const char* puzzle, size_t puzzle_length, const char* answer,
                                             size_t answer_length, bankshot_text* report);
/* Returns the JSON Schema of "puzzle", "shot", "answer" or "recording". */
BANKSHOT_API bankshot_status bankshot_schema(const char* document, bankshot_text* schema);

/* Frees a text that a function above returned; NULL is allowed. */
BANKSHOT_API void bankshot_free(char* data);

/* A prepared scene, for many fast simulations. It is read from a `simulate` document, whose own shot is not used. */
typedef struct bankshot_scene bankshot_scene;

/* Returns NULL if the document is invalid; `error`, unless NULL, is then {"path": ..., "reason": ...}. */
BANKSHOT_API bankshot_scene* bankshot_scene_new(const char* shot, size_t length, bankshot_text* error);
BANKSHOT_API void bankshot_scene_free(bankshot_scene* scene);

typedef struct bankshot_launch {
  double speed, angle;     /* m/s; radians, anticlockwise from +x */
  double top, side, masse; /* spin, in units of natural roll */
} bankshot_launch;

typedef enum bankshot_end_kind {
  BANKSHOT_END_REST = 0,
  BANKSHOT_END_UNTIL = 1, /* a limit of the scene's `until`: time, cushions or length */
  BANKSHOT_END_POCKETED = 2,
  BANKSHOT_END_EVENTS = 3, /* too many events */
  BANKSHOT_END_INVALID = 4 /* invalid launch: a number is not finite, the speed is not above 0, or the physics
                              does not model the spin */
} bankshot_end_kind;

/* The final state of the cue ball. */
typedef struct bankshot_end {
  double time, length; /* s; length of its path [m] */
  double x, y;         /* m */
  double vx, vy;       /* m/s */
  double wx, wy, wz;   /* rad/s */
  int32_t cushions;    /* number of cushion contacts */
  int32_t kind;        /* bankshot_end_kind */
  int32_t pocket;      /* index in the table's order; -1 means none */
  int32_t reserved;
} bankshot_end;

/* Writes the end of `launches[i]` to `ends[i]`, using this many threads (0 means one per core). */
BANKSHOT_API bankshot_status bankshot_simulate_many(const bankshot_scene* scene, const bankshot_launch* launches,
                                                    size_t count, bankshot_end* ends, int threads);

#ifdef __cplusplus
}
#endif

#endif /* BANKSHOT_BANKSHOT_H */
