/* interface_transfer.c - the elastic slip is carried along when a sliding point passes from one facet to the next.
 *
 * Facet A is the square [-1,1]^2. Facet B joins it at x = 1, coplanar or turned about that edge; its nodes are
 * counted from another corner and it is a parallelogram, so nothing but the slip in space is common to both.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

enum { N = 15, HISTORY = 6, ANCHOR = 3, PATH = 5 };

static const double eps_t = 50.0;              /* [force/length] */
static const double start[3] = {0.85, 0.3, -0.05}; /* of the slave [length] */

static bench a, b, line; /* the two facets, and a segment in the plane */

static void facet(bench *any, const double nodes[12], const double history[HISTORY])
{
  bench_open(any, "PointQuad4Coulomb");
  memcpy(any->x, start, sizeof start);
  memcpy(&any->x[3], nodes, 12 * sizeof any->x[0]);
  bench_set(any, "eps_t", eps_t);
  if (history != NULL)
    memcpy(any->history_accepted, history, HISTORY * sizeof history[0]);
}

static const double square[12] = {-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0};

/* Facet A with the point accepted at start + move, sliding; 0 on failure. */
static int slid(double x, double y)
{
  facet(&a, square, NULL);
  int pass = bench_evaluate(&a) == CTE_SUCCESS;
  memcpy(a.history_accepted, a.out.history_trial, HISTORY * sizeof a.history_accepted[0]);
  a.u[0] = x;
  a.u[1] = y;
  pass = pass && bench_evaluate(&a) == CTE_SUCCESS && a.a.status == CTE_STATUS_SLIP;
  return pass;
}

/* Facet B, turned up by an angle, evaluated at the displacements of A with an open history. */
static int neighbour(double angle)
{
  const double c = cos(angle), s = sin(angle);
  const double nodes[12] = {1.0, 1.0, 0.0, 1.0, -1.0, 0.0, 1.0 + 3.0 * c, -0.6, 3.0 * s, 1.0 + 3.0 * c, 1.4, 3.0 * s};
  facet(&b, nodes, NULL);
  memcpy(b.u, a.u, 3 * sizeof b.u[0]);
  return bench_evaluate(&b) == CTE_SUCCESS;
}

static int32_t transferred(int32_t *argument)
{
  return cte_history_transfer(a.element, a.out.output, a.out.history_trial, b.element, b.out.output, b.out.history_trial,
                              argument);
}

/* s = sum_i b_i (projection - anchor)^i, from output and history. */
static void slip_of(const bench *any, double s[3])
{
  const double *tangents = &any->out.output[CTE_OUTPUT_TANGENTS], *h = any->out.history_trial;
  for (int k = 0; k < 3; k++)
    s[k] = tangents[k] * (h[1] - h[ANCHOR]) + tangents[3 + k] * (h[2] - h[ANCHOR + 1]);
}

static double length(const double v[3])
{
  return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* On the common edge both facets hold the point: the force before is the force after. */
static void on_the_edge(void)
{
  int32_t argument = -1;
  double before[3], trial[HISTORY];
  int pass = slid(0.15, 0.05) && neighbour(0.0) && transferred(&argument) == CTE_SUCCESS;
  client_check(pass && argument == CTE_ARGUMENT_NONE && b.out.history_trial[0] == CTE_STATUS_SLIP &&
                   client_same(&b.out.history_trial[PATH], &a.out.history_trial[PATH], 1),
               "transfer: status and slip path go along");
  memcpy(before, a.out.f, sizeof before);
  memcpy(trial, b.out.history_trial, sizeof trial);
  memcpy(b.history_accepted, trial, sizeof trial);
  pass = bench_evaluate(&b) == CTE_SUCCESS;
  client_check(pass && client_near(b.out.f, before, 3, 1e-13), "transfer on the edge: the force does not jump");
}

/* The accepted point is on A, the step ends on B: the force is that of one large plane, mu |N| along the elastic
 * slip before plus the slip of the step. */
static void across(void)
{
  double s[3], expected[3], size;
  int pass = slid(0.12, 0.05);
  slip_of(&a, s);
  pass = pass && neighbour(0.0) && b.a.status == CTE_STATUS_OUTSIDE && transferred(NULL) == CTE_SUCCESS;
  memcpy(b.history_accepted, b.out.history_trial, HISTORY * sizeof b.history_accepted[0]);
  b.u[0] += 0.2;
  b.u[1] -= 0.1;
  s[0] -= 0.2; /* s is against the motion of the slave */
  s[1] += 0.1;
  size = length(s);
  for (int k = 0; k < 3; k++)
    expected[k] = -1.25 * s[k] / size - (k == 2 ? 5.0 : 0.0); /* mu |N| = 1.25, N = -5 along z */
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_SLIP;
  client_check(pass && client_near(b.out.f, expected, 3, 1e-13), "transfer across the edge: as on one plane");
  client_check(fabs(b.out.history_trial[PATH] - a.out.history_trial[PATH] - (size - 0.025)) < 1e-13,
               "transfer across the edge: the path goes on");
}

/* Turned about the y axis: the length is kept, the part along the edge too, and the rest stays in the facet. */
static void turned(void)
{
  static const double angle[3] = {0.3, -0.7, 1.5};
  int pass = 1;
  for (int i = 0; i < 3; i++) {
    double old[3], new[3], normal = 0.0;
    pass = pass && slid(0.12, 0.05) && neighbour(angle[i]) && transferred(NULL) == CTE_SUCCESS;
    slip_of(&a, old);
    slip_of(&b, new);
    for (int k = 0; k < 3; k++)
      normal += new[k] * b.out.output[CTE_OUTPUT_NORMAL + k];
    pass = pass && fabs(length(new) / length(old) - 1.0) < 1e-13 && fabs(new[1] / old[1] - 1.0) < 1e-13 &&
           fabs(new[0] / old[0] - cos(angle[i])) < 1e-13 && fabs(normal) < 1e-15;
  }
  client_check(pass, "transfer to a turned facet: the slip turns along, |s| is kept");
}

/* A segment of the plane evaluated with an open history; normal upwards. */
static int segment(bench *any, const double ends[4], double orientation)
{
  int32_t index = -1;
  static const double slave[2] = {0.95, -0.02};
  cte_element_find("PointLine2Coulomb2d", 19, &index);
  if (!bench_index(any, index, 0))
    return 0;
  memcpy(any->x, slave, sizeof slave);
  memcpy(&any->x[2], ends, 4 * sizeof any->x[0]);
  bench_set(any, "eps_t", eps_t);
  bench_set(any, "orientation", orientation);
  return bench_evaluate(any) == CTE_SUCCESS;
}

/* In the plane: from a segment to the next one, turned up by 0.4, also one that runs backwards. */
static void in_the_plane(void)
{
  const double first[4] = {-1.0, 0.0, 1.0, 0.0}, c = cos(0.4), s = sin(0.4);
  const double next[2][4] = {{1.0, 0.0, 1.0 + c, s}, {1.0 + c, s, 1.0, 0.0}};
  int pass = segment(&line, first, 1.0);
  memcpy(line.history_accepted, line.out.history_trial, 4 * sizeof line.history_accepted[0]);
  line.u[0] = 0.004;
  pass = pass && bench_evaluate(&line) == CTE_SUCCESS && line.a.status == CTE_STATUS_STICK;
  for (int i = 0; i < 2; i++) {
    pass = pass && segment(&b, next[i], i == 0 ? 1.0 : -1.0);
    b.u[0] = 0.004;
    pass = pass && bench_evaluate(&b) == CTE_SUCCESS &&
           cte_history_transfer(line.element, line.out.output, line.out.history_trial, b.element, b.out.output,
                                b.out.history_trial, NULL) == CTE_SUCCESS;
    const double moved = b.out.history_trial[1] - b.out.history_trial[2], *b_1 = &b.out.output[CTE_OUTPUT_TANGENTS];
    pass = pass && fabs(b_1[0] * moved + 0.004 * c) < 1e-15 && fabs(b_1[1] * moved + 0.004 * s) < 1e-15;
  }
  client_check(pass, "transfer in the plane, also to a segment that runs backwards");
}

/* Through the table and through the Fortran 77 entry; and nothing to carry. */
static void entries(void)
{
  double fresh[HISTORY], expected[HISTORY];
  int32_t index = -1, argument = -1, code = -1;
  cte_api_table api = CTE_API_TABLE_INIT;
  cte_element_find("PointQuad4Coulomb", 17, &index);
  int pass = cte_api(CTE_VERSION_MAJOR, &api) == CTE_SUCCESS && slid(0.12, 0.05) && neighbour(0.3);
  memcpy(fresh, b.out.history_trial, sizeof fresh);
  pass = pass && transferred(NULL) == CTE_SUCCESS;
  memcpy(expected, b.out.history_trial, sizeof expected);
  memcpy(b.out.history_trial, fresh, sizeof fresh);
  pass = pass && api.history_transfer(a.element, a.out.output, a.out.history_trial, b.element, b.out.output,
                                      b.out.history_trial, NULL) == CTE_SUCCESS;
  client_check(pass && client_same(b.out.history_trial, expected, HISTORY), "table: history_transfer");
  memcpy(b.out.history_trial, fresh, sizeof fresh);
  cte_f77_history_transfer_(&index, a.out.output, a.out.history_trial, &index, b.out.output, b.out.history_trial, &argument,
                            &code);
  client_check(code == CTE_SUCCESS && argument == CTE_ARGUMENT_NONE && client_same(b.out.history_trial, expected, HISTORY),
               "F77 history_transfer");
  memcpy(b.out.history_trial, fresh, sizeof fresh);
  a.out.history_trial[CTE_HISTORY_STATUS] = CTE_STATUS_OPEN;
  client_check(transferred(&argument) == CTE_SUCCESS && client_same(b.out.history_trial, fresh, HISTORY),
               "transfer of an open point: nothing to carry");
}

void interface_transfer(void)
{
  on_the_edge();
  across();
  turned();
  in_the_plane();
  entries();
}
