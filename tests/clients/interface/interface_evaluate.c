/* interface_evaluate.c - every field of cte_arguments, on PointQuad4 and InterpolatedQuad4. */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { N = 15, LD = 24 }; /* unknowns of PointQuad4; leading dimension of a larger host matrix */

static const double eps_n = 100.0; /* of the bench [force/length] */

static bench b, reference; /* the reference is evaluated once, dense and row-major */

/* Opens a bench and evaluates after the caller's change; true when it succeeds. */
static int evaluated(void)
{
  bench_canary(&b);
  return bench_evaluate(&b) == CTE_SUCCESS;
}

static double k_of(const bench *any, int i, int j)
{
  return any->out.k[i * N + j];
}

static int same_as_reference(void)
{
  return client_same(b.out.f, reference.out.f, N) && client_same(b.out.k, reference.out.k, N * N) &&
         client_same(b.out.history_trial, reference.out.history_trial, b.info.history) &&
         client_same(b.out.output, reference.out.output, CTE_OUTPUT_SIZE) &&
         client_same(b.out.energy, reference.out.energy, 1);
}

/* Output, energy and scalars of a closed point against each other. */
static void outputs(void)
{
  bench_open(&reference, "PointQuad4");
  bench_canary(&reference);
  const int pass = bench_evaluate(&reference) == CTE_SUCCESS;
  const double *out = reference.out.output, *normal = &out[CTE_OUTPUT_NORMAL];
  const double gap = out[CTE_OUTPUT_GAP], traction = out[CTE_OUTPUT_NORMAL_TRACTION];
  const cte_arguments *a = &reference.a;
  double total[3] = {0.0}, slave = 0.0;
  for (int i = 0; i < N; i++)
    total[i % 3] += reference.out.f[i];
  for (int i = 0; i < 3; i++)
    slave = fmax(slave, fabs(reference.out.f[i] - traction * normal[i]));
  client_check(pass && a->status == CTE_STATUS_CLOSED && a->closed_points == 1 && a->dt_ratio == 1.0 &&
                   a->error_argument == CTE_ARGUMENT_NONE && a->error_index == 0,
               "closed: status and scalars");
  client_check(out[CTE_OUTPUT_STATUS] == CTE_STATUS_CLOSED && out[CTE_OUTPUT_WEIGHT] == 1.0 &&
                   out[CTE_OUTPUT_FEATURE] == 0.0 && out[CTE_OUTPUT_ITERATIONS] >= 1.0 &&
                   fabs(out[CTE_OUTPUT_PROJECTION]) < 1.0 && fabs(out[CTE_OUTPUT_PROJECTION + 1]) < 1.0,
               "closed: output");
  client_check(gap < -0.05 && gap > -0.15 && fabs(traction - eps_n * gap) < 1e-12 && normal[2] > 0.9 &&
                   fabs(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] - 1.0) < 1e-14,
               "closed: gap, N = eps_n g, unit normal out of the master");
  client_check(fabs(reference.out.energy[0] - eps_n * gap * gap / 2.0) < 1e-14, "closed: energy = eps_n g^2/2");
  client_check(slave < 1e-12 && fabs(total[0]) + fabs(total[1]) + fabs(total[2]) < 1e-12,
               "closed: slave force = N n, forces in balance");
  client_check(reference.out.history_trial[0] == CTE_STATUS_CLOSED &&
                   client_same(&reference.out.history_trial[1], &out[CTE_OUTPUT_PROJECTION], 2),
               "closed: history = status, projection");
  bench_open(&b, "PointQuad4");
  client_check(evaluated() && same_as_reference(), "same input, same bits");
}

/* Row-major, column-major, and a larger host matrix through a map. */
static void layouts(void)
{
  static double host_k[LD * LD], host_f[LD];
  int32_t map[N];
  int pass = 1;
  bench_open(&b, "PointQuad4");
  b.a.k_row_stride = 1;
  b.a.k_col_stride = N;
  pass = evaluated();
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      pass &= client_same(&b.out.k[i + j * N], &reference.out.k[i * N + j], 1);
  client_check(pass, "column-major K");
  for (int i = 0; i < N; i++)
    map[i] = LD - 1 - (4 * (i / 3) + i % 3); /* four rows per node, in reverse */
  memset(host_k, 0x5a, sizeof host_k);
  memset(host_f, 0x5a, sizeof host_f);
  bench_open(&b, "PointQuad4");
  b.a.unknown_map = map;
  b.a.k_row_stride = LD;
  b.a.k_col_stride = 1;
  b.a.k = host_k;
  b.a.f = host_f;
  pass = evaluated();
  for (int i = 0; i < N; i++) {
    pass &= client_same(&host_f[map[i]], &reference.out.f[i], 1);
    memset(&host_f[map[i]], 0x5a, sizeof host_f[0]);
    for (int j = 0; j < N; j++) {
      pass &= client_same(&host_k[map[i] * LD + map[j]], &reference.out.k[i * N + j], 1);
      memset(&host_k[map[i] * LD + map[j]], 0x5a, sizeof host_k[0]);
    }
  }
  client_check(pass, "K and f through unknown_map into larger arrays");
  for (int i = 1; i < LD * LD; i++)
    pass &= client_same(&host_k[i], &host_k[0], 1) && client_same(&host_f[i % LD], &host_k[0], 1);
  client_check(pass, "the rest of the larger arrays untouched");
}

/* Coordinates with a larger node stride; arguments that are not used. */
static void inputs(void)
{
  bench_open(&b, "PointQuad4");
  for (int a = 4; a >= 0; a--)
    memmove(&b.x[7 * a], &b.x[3 * a], 3 * sizeof b.x[0]);
  b.a.x_node_stride = 7;
  b.a.u_node_stride = 4;
  client_check(evaluated() && same_as_reference(), "x_node_stride, u_node_stride");
  bench_open(&b, "PointQuad4");
  b.a.u = NULL;
  client_check(evaluated() && same_as_reference(), "u null is zero");
  b.a.u_old = b.u;
  b.a.v = b.u;
  b.a.dt = 0.7;
  b.a.nnode = 5;
  client_check(evaluated() && same_as_reference(), "arguments that are not read yet");
  b.a.history_accepted = NULL;
  client_check(evaluated() && same_as_reference(), "history_accepted null starts at the centre");
  bench_open(&b, "PointQuad4");
  memcpy(b.u, b.x, sizeof b.x);
  memset(b.x, 0, sizeof b.x);
  client_check(evaluated() && client_near(b.out.k, reference.out.k, N * N, 1e-13) &&
                   client_near(b.out.f, reference.out.f, N, 1e-13),
               "x + u is the position");
}

static void scales(void)
{
  int pass = 1;
  bench_open(&b, "PointQuad4");
  b.a.f_scale = -1.0;
  b.a.k_scale = -0.5;
  pass = evaluated();
  for (int i = 0; i < N; i++)
    pass &= b.out.f[i] == -reference.out.f[i];
  for (int i = 0; i < N * N; i++)
    pass &= b.out.k[i] == -0.5 * reference.out.k[i];
  client_check(pass, "f_scale -1, k_scale -1/2");
  b.a.f_scale = 1.0;
  b.a.k_scale = 1.0;
  client_check(evaluated() && same_as_reference(), "scales of 1 are those of CTE_ARGUMENTS_INIT");
  b.a.f_scale = 0.0;
  b.a.k_scale = 0.0;
  pass = evaluated();
  for (int i = 0; i < N; i++)
    pass &= b.out.f[i] == 0.0;
  for (int i = 0; i < N * N; i++)
    pass &= b.out.k[i] == 0.0;
  client_check(pass, "scales of 0 give zeros");
  bench_open(&b, "PointQuad4");
  b.a.request |= CTE_SYMMETRISE;
  pass = evaluated() && client_same(b.out.f, reference.out.f, N);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      pass &= k_of(&b, i, j) == 0.5 * (k_of(&reference, i, j) + k_of(&reference, j, i));
  client_check(pass, "CTE_SYMMETRISE writes (K + K^T)/2");
}

static void history(void)
{
  bench_open(&b, "PointQuad4");
  memcpy(b.out.history_trial, b.history_accepted, sizeof b.history_accepted);
  b.a.history_accepted = b.out.history_trial;
  client_check(bench_evaluate(&b) == CTE_SUCCESS && client_same(b.out.f, reference.out.f, N) &&
                   client_same(b.out.k, reference.out.k, N * N) &&
                   client_same(b.out.history_trial, reference.out.history_trial, b.info.history),
               "history_accepted and history_trial the same array");
  bench_open(&b, "PointQuad4");
  b.a.request &= ~CTE_HISTORY;
  bench_canary(&b);
  const double canary = b.out.history_trial[0];
  client_check(bench_evaluate(&b) == CTE_SUCCESS && client_same(b.out.history_trial, &canary, 1),
               "history_trial untouched without CTE_HISTORY");
  bench_open(&b, "PointQuad4");
  memcpy(b.history_accepted, reference.out.history_trial, sizeof b.history_accepted);
  b.a.request |= CTE_PROJECTION_GIVEN;
  client_check(evaluated() && b.out.output[CTE_OUTPUT_ITERATIONS] == 0.0 &&
                   client_near(b.out.f, reference.out.f, N, 1e-13) &&
                   client_near(b.out.k, reference.out.k, N * N, 1e-13),
               "CTE_PROJECTION_GIVEN takes the projection of history_accepted");
}

static int all_zero(const double *values, int n)
{
  int zero = 1;
  for (int i = 0; i < n; i++)
    zero &= values[i] == 0.0;
  return zero;
}

static int nothing_written_but_zero(void)
{
  return all_zero(b.out.f, N) && all_zero(b.out.k, N * N) && b.out.energy[0] == 0.0 && b.a.closed_points == 0;
}

static void states(void)
{
  bench_open(&b, "PointQuad4");
  b.x[2] = 1.2; /* the slave above the facet */
  client_check(evaluated() && b.a.status == CTE_STATUS_OPEN && nothing_written_but_zero() &&
                   b.out.output[CTE_OUTPUT_GAP] > 0.1 && b.out.history_trial[0] == CTE_STATUS_OPEN,
               "open: zeros");
  b.a.request |= CTE_FREEZE_STATE;
  b.history_accepted[0] = CTE_STATUS_CLOSED;
  client_check(evaluated() && b.a.status == CTE_STATUS_CLOSED &&
                   fabs(b.out.output[CTE_OUTPUT_NORMAL_TRACTION] - eps_n * b.out.output[CTE_OUTPUT_GAP]) < 1e-12 &&
                   b.out.f[2] > 1.0,
               "CTE_FREEZE_STATE: closed in spite of its gap");
  b.x[2] = 0.9;
  b.history_accepted[0] = CTE_STATUS_OPEN;
  client_check(evaluated() && b.a.status == CTE_STATUS_OPEN && nothing_written_but_zero(),
               "CTE_FREEZE_STATE: open in spite of its gap");
  bench_open(&b, "PointQuad4");
  b.x[0] = 1.5; /* beside the facet, half way along an edge */
  client_check(evaluated() && b.a.status == CTE_STATUS_OUTSIDE && nothing_written_but_zero() &&
                   b.out.output[CTE_OUTPUT_FEATURE] >= 1.0 && b.out.output[CTE_OUTPUT_FEATURE] <= 4.0,
               "outside: an edge");
  b.x[1] = 1.6; /* off a corner */
  client_check(evaluated() && b.a.status == CTE_STATUS_OUTSIDE && nothing_written_but_zero() &&
                   b.out.output[CTE_OUTPUT_FEATURE] >= 5.0 && b.out.output[CTE_OUTPUT_FEATURE] <= 8.0,
               "outside: a vertex");
}

/* A slave point given by its shape row: alone, weighted, and shared by two nodes. */
static void interpolated(void)
{
  int pass;
  bench_open(&b, "InterpolatedQuad4");
  client_check(evaluated() && client_near(b.out.f, reference.out.f, N, 1e-13) &&
                   client_near(b.out.k, reference.out.k, N * N, 1e-13),
               "slave_row [1], weight 1 is the point element");
  b.row[1] = 2.0;
  pass = evaluated() && b.out.output[CTE_OUTPUT_WEIGHT] == 2.0;
  for (int i = 0; i < N; i++)
    b.out.f[i] /= 2.0;
  client_check(pass && client_near(b.out.f, reference.out.f, N, 1e-13), "weight 2 doubles the force");
  int32_t index = -1;
  cte_element_find("InterpolatedQuad4", 17, &index);
  pass = bench_index(&b, index, 2) && b.info.unknowns == N + 3;
  memcpy(b.x, reference.x, 3 * sizeof b.x[0]);
  memcpy(&b.x[3], reference.x, N * sizeof b.x[0]);
  b.row[0] = b.row[1] = 0.5;
  pass = pass && evaluated();
  for (int i = 0; i < 3; i++)
    b.out.f[3 + i] += b.out.f[i];
  client_check(pass && client_near(&b.out.f[3], reference.out.f, N, 1e-13), "slave_row [1/2, 1/2] shares the force");
}

/* A caller compiled with a later header: its struct is longer. */
static void growth(void)
{
  struct later {
    cte_arguments a;
    double more[4];
  } later;
  memset(&later, 0x5a, sizeof later);
  bench_open(&b, "PointQuad4");
  bench_canary(&b);
  later.a = b.a;
  later.a.struct_size = sizeof later;
  const struct later before = later;
  client_check(cte_element_evaluate(b.element, &later.a) == CTE_SUCCESS && same_as_reference() &&
                   later.a.struct_size == sizeof later &&
                   memcmp(before.more, later.more, sizeof later.more) == 0,
               "a longer struct of a later header");
}

void interface_evaluate(void)
{
  outputs();
  layouts();
  inputs();
  scales();
  history();
  states();
  interpolated();
  growth();
}
