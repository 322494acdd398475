/* bad_project.c - bad input to cte_element_project; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { UNTOUCHED = -77 };

static bench b;
static cte_projection found[ROOM_POINTS];
static double history[ROOM_HISTORY];

static void fill(void)
{
  memset(found, 0x5a, sizeof found);
  memset(history, 0x5a, sizeof history);
  b.a.error_argument = UNTOUCHED;
  b.a.error_index = UNTOUCHED;
}

static int untouched(void)
{
  const unsigned char *result = (const unsigned char *)found, *start = (const unsigned char *)history;
  for (size_t i = 0; i < sizeof found; i++)
    if (result[i] != 0x5a)
      return 0;
  for (size_t i = 0; i < sizeof history; i++)
    if (start[i] != 0x5a)
      return 0;
  return 1;
}

/* The caller's fault, nothing written. */
static int refused(double reach, int32_t code, int32_t argument, int32_t index)
{
  char text[256] = "";
  fill();
  const int32_t given = cte_element_project(b.element, &b.a, reach, found, history);
  cte_element_message(b.element, &b.a, given, text, sizeof text);
  const int pass = given == code && b.a.error_argument == argument && b.a.error_index == index && untouched() &&
                   client_contains(text, cte_argument_name(argument));
  if (!pass)
    printf("     code %d wanted %d, argument %d wanted %d, index %d wanted %d\n", (int)given, (int)code,
           (int)b.a.error_argument, (int)argument, (int)b.a.error_index, (int)index);
  return pass;
}

static void expect(const char *what, int32_t code, int32_t argument, int32_t index)
{
  client_check(refused(0.0, code, argument, index), what);
}

/* A result with finite numbers, or a code and nothing written; no trap. */
static int clean(void)
{
  int pass = 1;
  fill();
  if (cte_element_project(b.element, &b.a, 0.0, found, history) != CTE_SUCCESS)
    return b.a.error_argument != CTE_ARGUMENT_NONE && untouched();
  for (int i = 0; i < b.info.points; i++)
    pass &= isfinite(found[i].zeta[0]) && isfinite(found[i].zeta[1]) && isfinite(found[i].distance) &&
            isfinite(found[i].definiteness) && found[i].verdict >= CTE_VERDICT_INSIDE &&
            found[i].verdict <= CTE_VERDICT_UNDECIDED && found[i].distance >= 0.0;
  for (int i = 0; i < b.info.history; i++)
    pass &= isfinite(history[i]) != 0;
  return pass;
}

static void null_pointers(void)
{
  bench_open(&b, "PointQuad4");
  fill();
  client_check(cte_element_project(b.element, NULL, 0.0, found, history) == CTE_ERROR_NULL && untouched(),
               "project: arguments null");
  client_check(cte_element_project(NULL, &b.a, 0.0, found, history) == CTE_ERROR_NULL &&
                   b.a.error_argument == CTE_ARGUMENT_ELEMENT && b.a.error_index == 0 && untouched(),
               "project: element null");
  client_check(cte_element_project(b.element, &b.a, 0.0, NULL, history) == CTE_ERROR_NULL &&
                   b.a.error_argument == CTE_ARGUMENT_RESULT && b.a.error_index == 0 && untouched(),
               "project: result null");
  client_check(cte_element_project(NULL, NULL, 0.0, NULL, NULL) == CTE_ERROR_NULL, "project: everything null");
  b.a.x = NULL;
  expect("project: x null", CTE_ERROR_NULL, CTE_ARGUMENT_X, 0);
  bench_open(&b, "PointQuad4");
  b.a.parameters = NULL;
  expect("project: parameters null", CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS, 0);
  bench_open(&b, "InterpolatedQuad4");
  b.a.slave_row = NULL;
  expect("project: slave_row null", CTE_ERROR_NULL, CTE_ARGUMENT_SLAVE_ROW, 0);
}

/* Arguments that cannot be read are not written either. */
static void struct_sizes(void)
{
  const uint32_t size[4] = {0, 8, (uint32_t)sizeof b.a - 1, 312}; /* the last: that of interface 0.1 */
  bench_open(&b, "PointQuad4");
  for (int i = 0; i < 4; i++) {
    b.a.struct_size = size[i];
    fill();
    client_check(cte_element_project(b.element, &b.a, 0.0, found, history) == CTE_ERROR_STRUCT_SIZE &&
                     b.a.error_argument == UNTOUCHED && untouched(),
                 client_text("project: struct_size", i));
  }
}

static void reaches(void)
{
  static const double below_or_above[] = {-1.0, -1e-300, -1e30, 1.1e30};
  bench_open(&b, "PointQuad4");
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    double reach;
    if (special == 1)
      continue; /* signalling_reach */
    client_special(special, &reach);
    client_check(refused(reach, CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_REACH, 0),
                 client_text("project: no number as reach", special));
  }
  for (int i = 0; i < 4; i++)
    client_check(refused(below_or_above[i], CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_REACH, 0),
                 client_text("project: reach below 0 or above 1e30", i));
  fill();
  client_check(cte_element_project(b.element, &b.a, -0.0, found, history) == CTE_SUCCESS,
               "project: a reach of minus zero");
}

/* Each entry in turn; error_index is the node of x and u, the entry of the row. */
static int spoiled(double *values, int count, int per_index, int32_t argument)
{
  int pass = 1;
  for (int i = 0; i < count; i++)
    for (int special = 0; special < CLIENT_SPECIALS; special++) {
      const double kept = values[i];
      client_special(special, &values[i]);
      pass &= refused(0.0, CTE_ERROR_NOT_FINITE, argument, i / per_index);
      values[i] = kept;
    }
  return pass;
}

static void not_finite(void)
{
  static const char *const name[] = {"PointQuad4", "PointQuad4Coulomb", "PointLine2", "PointPoint",
                                     "InterpolatedQuad4"};
  for (int e = 0; e < 5; e++) {
    bench_open(&b, name[e]);
    client_check(spoiled(b.x, b.info.unknowns, 3, CTE_ARGUMENT_X), client_text("project: no number in x, element", e));
    client_check(spoiled(b.u, b.info.unknowns, 3, CTE_ARGUMENT_U), client_text("project: no number in u, element", e));
  }
  client_check(spoiled(b.row, 1, 1, CTE_ARGUMENT_SLAVE_ROW), "project: no number in slave_row");
  bench_open(&b, "PointQuad4");
  const int eps_n = bench_parameter(&b, "eps_n");
  int pass = 1;
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    client_special(special, &b.parameters[eps_n]);
    pass &= refused(0.0, CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_PARAMETERS, eps_n);
  }
  client_check(pass, "project: no number as parameter");
  b.parameters[eps_n] = -1.0;
  expect("project: parameter out of range", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, eps_n);
}

static void counts(void)
{
  static const int32_t nnode[] = {4, 6, -1, INT32_MAX, INT32_MIN};
  static const int64_t stride[] = {-3, 2, 1, INT64_MAX, INT64_MIN, INT64_C(1) << 61};
  for (int i = 0; i < 5; i++) {
    bench_open(&b, "PointQuad4");
    b.a.nnode = nnode[i];
    expect(client_text("project: nnode", nnode[i]), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  }
  b.a.nnode = 0;
  b.a.nslave = 2;
  expect("project: nslave", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE, 0);
  bench_open(&b, "InterpolatedQuad4");
  b.a.nslave = 0;
  expect("project: nslave of an interpolated slave", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE, 0);
  bench_open(&b, "PointQuad4");
  b.a.parameter_count = 0;
  expect("project: no parameters", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 0);
  for (int i = 0; i < 6; i++) {
    bench_open(&b, "PointQuad4");
    b.a.x_node_stride = stride[i];
    expect(client_text("project: x_node_stride", i), CTE_ERROR_STRIDE, CTE_ARGUMENT_X, 0);
    bench_open(&b, "PointQuad4");
    b.a.u_node_stride = stride[i];
    expect(client_text("project: u_node_stride", i), CTE_ERROR_STRIDE, CTE_ARGUMENT_U, 0);
  }
}

static void random_nodes(double scale, double shift)
{
  const int positions = b.info.unknowns - bench_multipliers(&b);
  for (int j = 0; j < positions; j++)
    b.x[j] = scale * (client_random() - 0.5) + shift;
}

/* Every element: random nodes of every size, a NaN in x. */
static void every_element(void)
{
  static const double scale[] = {1e-30, 1.0, 1e29};
  for (int32_t e = 0; e < cte_element_count(); e++) {
    int pass = bench_index(&b, e, 2);
    for (int i = 0; i < 3; i++) {
      random_nodes(scale[i], 0.0);
      pass = pass && clean();
    }
    client_special(0, &b.x[0]);
    pass = pass && refused(0.0, CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_X, 0);
    client_check(pass, client_text("project: element", e));
  }
}

/* All nodes in one place, or nearly: tangents of length zero. */
static void one_place(void)
{
  static const char *const name[] = {"PointPoint", "PointQuad4", "PointQuad9", "PointTri3",
                                     "Line2Line2Beams", "PointHermite"};
  for (int e = 0; e < 6; e++) {
    int32_t index = -1;
    cte_element_find(name[e], (int32_t)strlen(name[e]), &index);
    int pass = bench_index(&b, index, 0);
    random_nodes(0.0, 1.0);
    pass = pass && clean();
    random_nodes(1e-300, 0.0);
    client_check(pass && clean(), client_text("project: all nodes in one place", e));
  }
}

/* By value: a comparison of it would trap. */
static void signalling_reach(void)
{
  double reach;
  bench_open(&b, "PointQuad4");
  client_special(1, &reach);
  client_check(refused(reach, CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_REACH, 0), "project: signalling NaN as reach");
}

void bad_project(void)
{
  null_pointers();
  struct_sizes();
  reaches();
  not_finite();
  counts();
  every_element();
  one_place();
  signalling_reach();
}
