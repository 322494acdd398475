/* interface_edges.c - edges of solids: the history keeps the side on which they were.
 *
 * The slave runs along y at height z, the master along x at height 0.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <string.h>

enum { N = 12, HISTORY = 6, SIDE = 3 };

static const double eps_n = 1000.0; /* [force/length] */

static bench a, b; /* an edge, and the next one of its chain */

/* The slave at (0.9, 0, z) against the master from x to x + 2, nothing remembered. */
static void edges(bench *any, double x, double z)
{
  int32_t index = -1;
  const double nodes[N] = {0.9, -1.0, z, 0.9, 1.0, z, x, 0.0, 0.0, x + 2.0, 0.0, 0.0};
  if (cte_element_find("Line2Line2Edges", 15, &index) != CTE_SUCCESS || !bench_index(any, index, 0)) {
    client_check(0, "Line2Line2Edges");
    return;
  }
  memcpy(any->x, nodes, sizeof nodes);
  memset(any->u, 0, N * sizeof any->u[0]);
  bench_set(any, "eps_n", eps_n);
  bench_set(any, "r0", 0.0);
  bench_set(any, "orientation", 0.0);
  cte_element_history_init(any->element, any->history_accepted);
}

/* Lifts the slave, evaluates, accepts. */
static int lifted(bench *any, double z)
{
  any->u[2] = any->u[5] = z;
  if (bench_evaluate(any) != CTE_SUCCESS)
    return 0;
  memcpy(any->history_accepted, any->out.history_trial, HISTORY * sizeof any->history_accepted[0]);
  return 1;
}

static void crossing(void)
{
  for (int from = 0; from < 2; from++) {
    const double side = from == 0 ? 1.0 : -1.0;
    edges(&a, -1.0, 0.125 * side);
    int pass = a.info.history == HISTORY && lifted(&a, 0.0) && a.a.status == CTE_STATUS_OPEN &&
               a.history_accepted[SIDE + 2] == side;
    client_check(pass, client_text("edges apart, side", from));
    pass = lifted(&a, -0.1875 * side) && a.a.status == CTE_STATUS_CLOSED && a.out.output[1] == -0.0625 &&
           a.out.f[2] + a.out.f[5] == -eps_n * 0.0625 * side && a.history_accepted[SIDE + 2] == side;
    client_check(pass, client_text("edges crossed, side", from));
  }
}

/* The crossing continues on the next segment of the chain. */
static void chain(void)
{
  int32_t argument = -1;
  edges(&a, -1.0, 0.125);
  edges(&b, 1.0, 0.125);
  int pass = lifted(&a, 0.0) && lifted(&a, -0.1875);
  b.u[2] = b.u[5] = -0.1875;
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_OUTSIDE &&
         cte_history_transfer(a.element, a.out.output, a.out.history_trial, b.element, b.out.output, b.out.history_trial,
                              &argument) == CTE_SUCCESS;
  memcpy(b.history_accepted, b.out.history_trial, HISTORY * sizeof b.history_accepted[0]);
  b.u[0] = b.u[3] = 0.5;
  pass = pass && argument == CTE_ARGUMENT_NONE && bench_evaluate(&b) == CTE_SUCCESS &&
         b.a.status == CTE_STATUS_CLOSED && b.out.output[1] == -0.0625;
  client_check(pass, "edges: the side goes along a chain");
}

static void refused(void)
{
  edges(&a, -1.0, 0.125);
  a.a.history_accepted = NULL;
  bench_canary(&a);
  int pass = bench_evaluate(&a) == CTE_ERROR_NULL && a.a.error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED &&
             bench_untouched(&a);
  client_check(pass, "edges without orientation and history");
  bench_set(&a, "orientation", 1.0);
  pass = bench_evaluate(&a) == CTE_SUCCESS;
  client_check(pass, "edges with orientation, without history");
  edges(&a, -1.0, 0.125);
  a.history_accepted[SIDE] = 0.5;
  bench_canary(&a);
  pass = bench_evaluate(&a) == CTE_ERROR_HISTORY && a.a.error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED &&
         a.a.error_index == SIDE && bench_untouched(&a);
  client_check(pass, "edges with a normal that is none");
  edges(&a, -1.0, 0.125);
  a.history_accepted[SIDE] = 1.0;
  bench_canary(&a);
  pass = bench_evaluate(&a) == CTE_CUT_BACK && a.a.status == CTE_STATUS_NOT_UNIQUE && bench_untouched(&a);
  client_check(pass, "edges that turned by a right angle");
}

void interface_edges(void)
{
  crossing();
  chain();
  refused();
}
