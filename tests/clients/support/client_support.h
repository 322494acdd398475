/* client_support.h - one contact on a bench: what bad_input.c and interface.c share.
 *
 * A bench holds an element, its arguments and every array they point to, in a state that evaluates
 * without complaint; a test changes one thing. client_support.f90 is the twin.
 */
#ifndef CLIENT_SUPPORT_H
#define CLIENT_SUPPORT_H

#include "contact_elements.h"

enum {
  ROOM_NODES = 64,
  ROOM_UNKNOWNS = 3 * ROOM_NODES,
  ROOM_PARAMETERS = 64,
  ROOM_POINTS = 64,
  ROOM_HISTORY = 8 * ROOM_POINTS, /* with friction and a multiplier 3 + 2 * 2 per point; with rolling 11, one point */
  ROOM_WORKSPACE = 1 << 18
};

/* The arrays an evaluation writes. */
typedef struct bench_outputs {
  double f[ROOM_UNKNOWNS];
  double k[ROOM_UNKNOWNS * ROOM_UNKNOWNS];
  double history_trial[ROOM_HISTORY];
  double output[ROOM_POINTS * CTE_OUTPUT_SIZE];
  double energy[1];
} bench_outputs;

typedef struct bench {
  const cte_element *element;
  cte_info info;
  cte_arguments a;
  double x[ROOM_UNKNOWNS], u[ROOM_UNKNOWNS];
  double parameters[ROOM_PARAMETERS];
  double history_accepted[ROOM_HISTORY];
  double row[ROOM_NODES + 1]; /* interpolated slaves: [1, 0, ...], weight 1 */
  bench_outputs out;
  double workspace[ROOM_WORKSPACE];
} bench;

/* Failures so far, of all checks. */
extern int client_failures;

/* Prints "PASS what" or "FAIL what" and counts; returns pass. */
int client_check(int pass, const char *what);

/* Name and number in one text, for client_check; the text lasts until the next call. */
const char *client_text(const char *what, long number);

/* Deterministic numbers in [0,1): the same sequence in C and Fortran. */
double client_random(void);

/* Lays out element number `index` with a plain state: parameters inside their ranges, no displacement, all
 * coordinates zero, everything requested that is offered. Returns 0 when the element cannot be laid out. */
int bench_index(bench *b, int32_t index, int32_t nslave);

/* The same by name for the elements with a known closed state: PointQuad4, InterpolatedQuad4, PointLine2,
 * PointPoint, PointCylinder, PointCylinderDistance, with friction on Quad4, Line2, Cylinder, with multipliers (zero)
 * on Quad4. Failure is counted. */
int bench_open(bench *b, const char *name);

/* Nodes of multipliers, behind all others; position of an unknown in x and u, which have room for every component of
 * every node, and whether it is a multiplier. */
int bench_multipliers(const bench *b);
int bench_position(const bench *b, int unknown);
int bench_is_multiplier(const bench *b, int unknown);

/* Index of a named parameter, -1 if it does not exist; sets it. */
int bench_parameter(const bench *b, const char *name);
void bench_set(bench *b, const char *name, double value);

/* Fills the outputs with a pattern; tells whether every byte of it is still there. */
void bench_canary(bench *b);
int bench_untouched(const bench *b);

/* Evaluates; both arrays are equal bit for bit, or to a tolerance relative to the largest entry of b; text
 * contains word. */
int32_t bench_evaluate(bench *b);
int client_same(const double *a, const double *b, long n);
int client_near(const double *a, const double *b, long n, double tolerance);
int client_contains(const char *text, const char *word);

/* A quiet NaN, a signalling NaN, +infinity, -infinity, 1e300: number 0..4, made without arithmetic. */
enum { CLIENT_SPECIALS = 5 };
void client_special(int number, double *value);
extern const char *const client_special_name[CLIENT_SPECIALS];

#endif
