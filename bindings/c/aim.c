/* SPDX-License-Identifier: MIT
 *
 * Solves a one-cushion shot into a corner, checks the answer in 50 digits, and simulates a thousand launches around it.
 *   cc aim.c $(pkg-config --cflags --libs bankshot) -o aim
 */
#include <bankshot/bankshot.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char puzzle[] =
    "{\"table\": \"pool-9ft\", \"ball\": {\"at\": [0.635, 0.40]}, \"target\": {\"pocket\": \"bottom-right\"},"
    " \"cushions\": [\"top\"], \"speed\": [0.2, 8]}";
static const char scene_text[] =
    "{\"table\": \"pool-9ft\", \"ball\": {\"at\": [0.635, 0.40]}, \"shot\": {\"speed\": 2, \"angle\": 0}}";

/* Returns the number after "key": in JSON text. A real program would use a JSON library. */
static double number(const char* text, const char* key) {
  const char* at = strstr(text, key);
  return at ? strtod(at + strlen(key), NULL) : 0;
}

int main(void) {
  enum { many = 1000 };
  static bankshot_launch launches[many];
  static bankshot_end ends[many];
  bankshot_text answer = {NULL, 0}, report = {NULL, 0};
  bankshot_scene* scene = NULL;
  double speed, angle;
  int i, fell = 0;

  if (bankshot_abi_version() != BANKSHOT_ABI_VERSION) return 3;
  if (bankshot_solve(puzzle, strlen(puzzle), "no-timing", &answer) != BANKSHOT_DONE) {
    fprintf(stderr, "%s", answer.data ? answer.data : "no memory\n");
    bankshot_free(answer.data);
    return 1;
  }
  speed = number(answer.data, "\"speed\":");
  angle = number(answer.data, "\"angle\":");
  printf("aim %.3f degrees, speed %.3f m/s, success %.2f\n", angle, speed, number(answer.data, "\"success\":"));

  if (bankshot_verify(puzzle, strlen(puzzle), answer.data, answer.length, &report) == BANKSHOT_DONE)
    printf("every claim of it holds\n");
  bankshot_free(report.data);
  bankshot_free(answer.data);

  scene = bankshot_scene_new(scene_text, strlen(scene_text), NULL);
  if (!scene) return 1;
  for (i = 0; i < many; ++i) {
    launches[i].speed = speed;
    launches[i].angle = (angle + (i - many / 2) * 0.001) * 3.14159265358979323846 / 180;
  }
  bankshot_simulate_many(scene, launches, many, ends, 0);
  for (i = 0; i < many; ++i) fell += ends[i].kind == BANKSHOT_END_POCKETED;
  printf("of %d aims within half a degree %d fall into a pocket\n", many, fell);
  bankshot_scene_free(scene);
  return 0;
}
