/* client_support.c - see client_support.h. */
#include "client_support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

int client_failures = 0;

int client_check(int pass, const char *what)
{
  printf("%s %s\n", pass ? "PASS" : "FAIL", what);
  client_failures += !pass;
  return pass;
}

const char *client_text(const char *what, long number)
{
  static char text[128];
  snprintf(text, sizeof text, "%s %ld", what, number);
  return text;
}

double client_random(void)
{
  static int64_t state = 1;
  state = (state * 1103515245 + 12345) % 2147483648;
  return (double)state / 2147483648.0;
}

const char *const client_special_name[CLIENT_SPECIALS] = {"NaN", "signalling NaN", "+infinity", "-infinity",
                                                         "1e300"};

void client_special(int number, double *value)
{
  static const uint64_t bits[CLIENT_SPECIALS] = {UINT64_C(0x7ff8000000000000), UINT64_C(0x7ff4000000000000),
                                                 UINT64_C(0x7ff0000000000000), UINT64_C(0xfff0000000000000),
                                                 UINT64_C(0x7e37e43c8800759c)};
  memcpy(value, &bits[number], sizeof *value);
}

int client_same(const double *a, const double *b, long n)
{
  return memcmp(a, b, (size_t)n * sizeof *a) == 0;
}

int client_near(const double *a, const double *b, long n, double tolerance)
{
  double largest = 0.0, difference = 0.0;
  for (long i = 0; i < n; i++) {
    largest = fmax(largest, fabs(b[i]));
    difference = fmax(difference, fabs(a[i] - b[i]));
  }
  return difference <= tolerance * largest;
}

int client_contains(const char *text, const char *word)
{
  return strstr(text, word) != NULL;
}

/* A value inside the parameter's range: 100 for the penalty, 1/4 for coefficients of friction, 1 for the first
 * component of an axis and for the upper end of a window of angles, else the first of 0, 1, 1/2 that fits. */
static double plain_value(const char *name, double lower, double upper, int32_t closed)
{
  const double candidate[3] = {0.0, 1.0, 0.5};
  if (strcmp(name, "eps_n") == 0)
    return 100.0; /* [force/length] */
  if (strncmp(name, "mu", 2) == 0)
    return 0.25;
  if (strcmp(name, "axis_1") == 0 || strcmp(name, "angle_high") == 0)
    return 1.0;
  for (int i = 0; i < 3; i++)
    if ((candidate[i] > lower || ((closed & 1) && candidate[i] == lower)) &&
        (candidate[i] < upper || ((closed & 2) && candidate[i] == upper)))
      return candidate[i];
  return lower + (upper - lower) / 2.0;
}

static int plain_parameters(bench *b)
{
  for (int32_t i = 0; i < b->info.parameters; i++) {
    const char *name, *unit;
    double lower, upper;
    int32_t closed;
    if (cte_element_parameter(b->element, i, &name, &unit, &lower, &upper, &closed) != CTE_SUCCESS)
      return 0;
    b->parameters[i] = plain_value(name, lower, upper, closed);
  }
  return 1;
}

static void fill_arguments(bench *b, int32_t nslave)
{
  cte_arguments *a = &b->a;
  *a = (cte_arguments)CTE_ARGUMENTS_INIT;
  a->request = b->info.requests & (CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY);
  a->nslave = nslave;
  a->nnode = nslave > 0 ? nslave + b->info.nodes_minimum - 1 : 0;
  a->x = b->x;
  a->u = b->u;
  a->parameters = b->parameters;
  a->parameter_count = b->info.parameters;
  a->history_accepted = b->history_accepted;
  a->history_trial = b->out.history_trial;
  a->slave_row = nslave > 0 ? b->row : NULL;
  a->f = b->out.f;
  a->k = b->out.k;
  a->output = b->out.output;
  a->energy = b->out.energy;
  a->workspace = b->workspace;
  a->workspace_size = b->info.workspace;
}

int bench_index(bench *b, int32_t index, int32_t nslave)
{
  memset(b, 0, sizeof *b);
  b->element = cte_element_get(index);
  b->info = (cte_info)CTE_INFO_INIT;
  if (b->element == NULL || cte_element_info(b->element, 0, &b->info) != CTE_SUCCESS)
    return 0;
  if (b->info.slave_nodes != 0)
    nslave = 0;
  else if (cte_element_info(b->element, nslave + b->info.nodes_minimum - 1, &b->info) != CTE_SUCCESS)
    return 0;
  if (b->info.unknowns > ROOM_UNKNOWNS || b->info.parameters > ROOM_PARAMETERS ||
      b->info.history > ROOM_HISTORY || b->info.points > ROOM_POINTS || b->info.workspace > ROOM_WORKSPACE)
    return 0;
  if (!plain_parameters(b) || cte_element_history_init(b->element, b->history_accepted) != CTE_SUCCESS)
    return 0;
  b->row[0] = 1.0;
  b->row[nslave] = 1.0;
  fill_arguments(b, nslave);
  return 1;
}

int bench_multipliers(const bench *b)
{
  const int slaves = b->info.slave_nodes > 0 ? b->info.slave_nodes : 1;
  return b->info.nodes_minimum - slaves - b->info.master_nodes;
}

int bench_is_multiplier(const bench *b, int unknown)
{
  return unknown >= b->info.unknowns - bench_multipliers(b);
}

int bench_position(const bench *b, int unknown)
{
  const int first = b->info.unknowns - bench_multipliers(b);
  return bench_is_multiplier(b, unknown) ? first + (unknown - first) * b->info.dimension : unknown;
}

int bench_parameter(const bench *b, const char *name)
{
  for (int32_t i = 0; i < b->info.parameters; i++) {
    const char *found;
    if (cte_element_parameter(b->element, i, &found, NULL, NULL, NULL, NULL) == CTE_SUCCESS &&
        strcmp(found, name) == 0)
      return i;
  }
  return -1;
}

void bench_set(bench *b, const char *name, double value)
{
  const int i = bench_parameter(b, name);
  if (i >= 0)
    b->parameters[i] = value;
  else
    client_check(0, name);
}

/* Closed by about 0.1 [length]; slave first. */
static void place(bench *b, const char *name)
{
  static const double facet[15] = {0.55, 0.4, 0.9, 0.0, 0.0, 1.0, 1.0, 0.0, 1.02, 1.0, 1.0, 0.99, 0.0, 1.0, 1.03};
  static const double line[9] = {0.5, 0.1, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0};
  static const double balls[6] = {0.1, 0.0, 0.0, 0.0, 0.0, 0.0};
  static const double tube[3] = {0.9, 0.0, 0.3};
  if (client_contains(name, "Quad4"))
    memcpy(b->x, facet, sizeof facet);
  else if (client_contains(name, "Line2"))
    memcpy(b->x, line, sizeof line);
  else if (client_contains(name, "Cylinder"))
    memcpy(b->x, tube, sizeof tube);
  else
    memcpy(b->x, balls, sizeof balls);
  if (client_contains(name, "Cylinder"))
    bench_set(b, "radius", 1.0);
  else if (!client_contains(name, "Quad4"))
    bench_set(b, "r0", 0.2); /* sum of the radii [length] */
}

int bench_open(bench *b, const char *name)
{
  int32_t index = -1;
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS || !bench_index(b, index, 1) ||
      b->info.dimension != 3)
    return client_check(0, name);
  place(b, name);
  return 1;
}

void bench_canary(bench *b)
{
  memset(&b->out, 0x5a, sizeof b->out);
}

int bench_untouched(const bench *b)
{
  const unsigned char *byte = (const unsigned char *)&b->out;
  for (size_t i = 0; i < sizeof b->out; i++)
    if (byte[i] != 0x5a)
      return 0;
  return 1;
}

int32_t bench_evaluate(bench *b)
{
  return cte_element_evaluate(b->element, &b->a);
}
