/* interface_multipliers.c - multipliers that are unknowns: a separate node behind the others, with one unknown.
 *
 * A point at (0.2, -0.1, g) over the square [-1,1]^2, whose normal is z and whose parameters are x and y: residual and
 * tangent are written down by hand. N = multiplier + eps_n g.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

enum { N = 16, LAMBDA = 15, NODES = 5, LD = 20 }; /* unknowns, the last one; nodes with positions; a host's rows */

static const double eps_n = 100.0, eps_t = 100.0, mu = 0.25, at[2] = {0.2, -0.1};

static bench b;

/* An open history, depth and multiplier. */
static int opened(const char *name, double gap, double multiplier)
{
  static const double square[12] = {-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0};
  if (!bench_open(&b, name))
    return 0;
  memcpy(b.x, at, sizeof at);
  b.x[2] = gap;
  memcpy(&b.x[3], square, sizeof square);
  for (int i = 0; i < 3; i++)
    client_special(1, &b.x[3 * NODES + i]); /* not looked at */
  b.u[LAMBDA] = multiplier;
  return 1;
}

static int evaluated(int32_t status)
{
  bench_canary(&b);
  return bench_evaluate(&b) == CTE_SUCCESS && b.a.status == status &&
         b.out.output[CTE_OUTPUT_STATUS] == status && b.out.history_trial[CTE_HISTORY_STATUS] == status;
}

/* s_A and s_A,i of slave and corners: + on the slave, - the shape function on the master. */
static void rows(double s[NODES], double ds[2][NODES])
{
  static const double corner[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  s[0] = 1.0;
  ds[0][0] = ds[1][0] = 0.0;
  for (int a = 0; a < 4; a++) {
    const double along = 1.0 + corner[a][0] * at[0], across = 1.0 + corner[a][1] * at[1];
    s[a + 1] = -along * across / 4.0;
    ds[0][a + 1] = -corner[a][0] * across / 4.0;
    ds[1][a + 1] = -along * corner[a][1] / 4.0;
  }
}

/* R = N s_A n and g; K = eps_n s_A s_B n n + N times the second variation of the gap, n s_A beside it. */
static void closed_by_hand(double gap, double multiplier, double f[N], double k[N * N])
{
  const double traction = multiplier + eps_n * gap;
  double s[NODES], ds[2][NODES];
  rows(s, ds);
  memset(f, 0, N * sizeof f[0]);
  memset(k, 0, N * N * sizeof k[0]);
  f[LAMBDA] = gap;
  for (int a = 0; a < NODES; a++) {
    const int row = 3 * a;
    f[row + 2] = traction * s[a];
    k[(row + 2) * N + LAMBDA] = k[LAMBDA * N + row + 2] = s[a];
    for (int c = 0; c < NODES; c++) {
      const int column = 3 * c;
      k[(row + 2) * N + column + 2] =
          eps_n * s[a] * s[c] - traction * gap * (ds[0][a] * ds[0][c] + ds[1][a] * ds[1][c]);
      for (int i = 0; i < 2; i++) {
        k[(row + i) * N + column + 2] = traction * s[a] * ds[i][c];
        k[(row + 2) * N + column + i] = traction * ds[i][a] * s[c];
      }
    }
  }
}

/* -multiplier/eps_n and -1/eps_n, all else zero. */
static int open_by_hand(double multiplier)
{
  double f[N] = {0.0}, k[N * N] = {0.0};
  f[LAMBDA] = -multiplier / eps_n;
  k[LAMBDA * N + LAMBDA] = -1.0 / eps_n;
  int zeros = b.out.output[CTE_OUTPUT_NORMAL_TRACTION] == 0.0 && b.a.closed_points == 0;
  for (int i = 0; i < N * N; i++)
    zeros &= (k[i] == 0.0) == (b.out.k[i] == 0.0);
  for (int i = 0; i < N; i++)
    zeros &= (f[i] == 0.0) == (b.out.f[i] == 0.0);
  return zeros && client_near(b.out.f, f, N, 1e-15) && client_near(b.out.k, k, N * N, 1e-15) &&
         fabs(b.out.energy[0] + multiplier * multiplier / (2.0 * eps_n)) < 1e-16;
}

static int is_closed_by_hand(double gap, double multiplier)
{
  static double f[N], k[N * N];
  closed_by_hand(gap, multiplier, f, k);
  return client_near(b.out.f, f, N, 1e-14) && client_near(b.out.k, k, N * N, 1e-14) &&
         b.out.k[LAMBDA * N + LAMBDA] == 0.0 && b.a.closed_points == 1;
}

static void described(void)
{
  int32_t node = -1, kind = -1;
  if (!opened("PointQuad4Multiplier", -0.05, -3.0))
    return;
  client_check(b.info.nodes_minimum == NODES + 1 && b.info.nodes_maximum == NODES + 1 && b.info.slave_nodes == 1 &&
                   b.info.master_nodes == 4 && b.info.unknowns == N && b.info.history == 3 && b.info.symmetric == 1,
               "multiplier: one node and one unknown more, the history of a plain element");
  client_check(cte_element_unknown(b.element, 0, LAMBDA, &node, &kind) == CTE_SUCCESS && node == NODES &&
                   kind == CTE_UNKNOWN_MULTIPLIER &&
                   cte_element_unknown(b.element, 0, LAMBDA + 1, &node, &kind) == CTE_ERROR_INDEX,
               "multiplier: the last unknown, on the last node");
}

static void closed_and_open(void)
{
  int pass = opened("PointQuad4Multiplier", -0.05, -3.0) && evaluated(CTE_STATUS_CLOSED);
  client_check(pass && is_closed_by_hand(-0.05, -3.0), "multiplier, closed: f and K by hand");
  client_check(fabs(b.out.output[CTE_OUTPUT_NORMAL_TRACTION] + 8.0) < 1e-14 &&
                   fabs(b.out.output[CTE_OUTPUT_GAP] + 0.05) < 1e-16 && b.out.output[CTE_OUTPUT_WEIGHT] == 1.0 &&
                   fabs(b.out.energy[0] - (64.0 - 9.0) / (2.0 * eps_n)) < 1e-15,
               "multiplier, closed: N = multiplier + eps_n g, energy = (N^2 - multiplier^2)/(2 eps_n)");
  pass = opened("PointQuad4Multiplier", 0.02, -3.0) && evaluated(CTE_STATUS_CLOSED);
  client_check(pass && is_closed_by_hand(0.02, -3.0), "multiplier, a gap held closed by the multiplier");
  pass = opened("PointQuad4Multiplier", -0.02, 3.0) && evaluated(CTE_STATUS_OPEN);
  client_check(pass && open_by_hand(3.0), "multiplier, a depth opened by the multiplier");
  pass = opened("PointQuad4Multiplier", 0.05, -3.0) && evaluated(CTE_STATUS_OPEN);
  client_check(pass && open_by_hand(-3.0), "multiplier, open: f = -multiplier/eps_n, K = -1/eps_n, all else zero");
  pass = opened("PointQuad4Multiplier", -0.05, -3.0);
  b.x[0] = 1.5;
  client_check(pass && evaluated(CTE_STATUS_OUTSIDE) && open_by_hand(-3.0), "multiplier, outside: as open");
  b.a.u = NULL;
  b.x[0] = at[0];
  client_check(evaluated(CTE_STATUS_CLOSED) && is_closed_by_hand(-0.05, 0.0), "multiplier, u null: no multiplier");
}

/* At N = 0: just closed, just open, and both states at the switch itself. */
static void continuous(void)
{
  static const double gap[2] = {0.05, -0.05};
  for (int i = 0; i < 2; i++) {
    const double zero = -eps_n * gap[i], step = 1e-9;
    static double closed[N], open[N];
    int pass = opened("PointQuad4Multiplier", gap[i], zero - step) && evaluated(CTE_STATUS_CLOSED);
    memcpy(closed, b.out.f, sizeof closed);
    b.u[LAMBDA] = zero + step;
    pass = pass && evaluated(CTE_STATUS_OPEN);
    memcpy(open, b.out.f, sizeof open);
    for (int j = 0; j < N; j++)
      pass &= fabs(closed[j] - open[j]) < 1.1 * step;
    client_check(pass && fabs(open[LAMBDA] - gap[i]) < step, client_text("multiplier, f is continuous at N = 0:", i));
  }
}

static void frozen(void)
{
  int pass = opened("PointQuad4Multiplier", 0.05, -3.0);
  b.a.request |= CTE_FREEZE_STATE;
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_CLOSED;
  client_check(pass && evaluated(CTE_STATUS_CLOSED) && is_closed_by_hand(0.05, -3.0),
               "multiplier, CTE_FREEZE_STATE: closed in spite of N > 0");
  pass = opened("PointQuad4Multiplier", -0.05, -3.0);
  b.a.request |= CTE_FREEZE_STATE;
  client_check(pass && evaluated(CTE_STATUS_OPEN) && open_by_hand(-3.0),
               "multiplier, CTE_FREEZE_STATE: open in spite of N < 0");
}

/* A host with four rows per node: the multiplier is the fourth of the slave. Column-major, scaled. */
static void mapped(double gap, int32_t status, const char *what)
{
  static double f[N], k[N * N], host_f[LD], host_k[LD * LD];
  int32_t map[N];
  int pass = opened("PointQuad4Multiplier", gap, -3.0) && evaluated(status);
  memcpy(f, b.out.f, sizeof f);
  memcpy(k, b.out.k, sizeof k);
  for (int i = 0; i < LAMBDA; i++)
    map[i] = 4 * (i / 3) + i % 3;
  map[LAMBDA] = 3;
  memset(host_f, 0x5a, sizeof host_f);
  memset(host_k, 0x5a, sizeof host_k);
  const double canary = host_f[0];
  b.a.unknown_map = map;
  b.a.f = host_f;
  b.a.k = host_k;
  b.a.k_row_stride = 1;
  b.a.k_col_stride = LD;
  b.a.f_scale = -1.0;
  b.a.k_scale = -0.5;
  pass = pass && evaluated(status);
  for (int i = 0; i < N; i++) {
    pass &= host_f[map[i]] == -f[i];
    for (int j = 0; j < N; j++)
      pass &= host_k[map[i] + map[j] * LD] == -0.5 * k[i * N + j];
  }
  for (int row = 7; row < LD; row += 4) /* the masters have no fourth row */
    for (int i = 0; i < LD; i++)
      pass &= client_same(&host_k[row + i * LD], &canary, 1) && client_same(&host_k[i + row * LD], &canary, 1) &&
              client_same(&host_f[row], &canary, 1);
  client_check(pass, what);
}

/* Slip of 0.05 at N = -8: |T| = mu |N| = 2 along (0.6, -0.8), which grows with the multiplier. */
static void friction(void)
{
  static const double force[3] = {1.2, -1.6, -8.0}, column[3] = {-0.15, 0.2, 1.0}, row[3] = {0.0, 0.0, 1.0};
  double found[2][3];
  int pass = opened("PointQuad4CoulombMultiplier", -0.05, -3.0);
  bench_set(&b, "eps_t", eps_t);
  bench_set(&b, "mu", mu);
  pass = pass && b.info.history == 6 && b.info.symmetric == 0 && evaluated(CTE_STATUS_STICK);
  memcpy(b.history_accepted, b.out.history_trial, 6 * sizeof b.history_accepted[0]);
  b.u[0] = 0.03;
  b.u[1] = -0.04;
  pass = pass && evaluated(CTE_STATUS_SLIP);
  for (int i = 0; i < 3; i++) {
    found[0][i] = b.out.k[i * N + LAMBDA];
    found[1][i] = b.out.k[LAMBDA * N + i];
  }
  client_check(pass && client_near(b.out.f, force, 3, 1e-14) && fabs(b.out.f[LAMBDA] + 0.05) < 1e-16,
               "multiplier with friction: the bound is mu |N|");
  client_check(client_near(found[0], column, 3, 1e-14) && client_near(found[1], row, 3, 1e-14) &&
                   b.out.k[LAMBDA * N + LAMBDA] == 0.0,
               "multiplier with friction: the column has the bound's change, the row has not");
}

/* Four points of a parallel square of area 1: each has its multiplier, in order; the third is pulled open. */
static void several(void)
{
  enum { FIRST = 24, ALL = 28 };
  static const double multiplier[4] = {-1.0, -2.0, 20.0, -4.0}, corner[4][2] = {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
  int32_t index = -1;
  double total = 0.0, weight = 0.25, traction = 0.0;
  cte_element_find("Quad4Quad4Multiplier", 20, &index);
  int pass = bench_index(&b, index, 0) && b.info.unknowns == ALL && b.info.nodes_minimum == 12;
  for (int a = 0; a < 4; a++)
    for (int i = 0; i < 2; i++) {
      b.x[3 * a + i] = 2.0 * corner[a][i] - 0.5;
      b.x[3 * (4 + a) + i] = 4.0 * corner[a][i] - 1.0;
      b.x[3 * a + 2] = -0.05;
      b.u[bench_position(&b, FIRST + a)] = multiplier[a];
    }
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.closed_points == 3 && b.a.status == CTE_STATUS_CLOSED;
  for (int q = 0; q < 4; q++) {
    const int open = q == 2, row = FIRST + q;
    double column = 0.0;
    for (int a = 0; a < 4; a++)
      column += b.out.k[(3 * a + 2) * ALL + row];
    pass = pass && fabs(b.out.f[row] - weight * (open ? -0.2 : -0.05)) < 1e-16 &&
           fabs(b.out.k[row * ALL + row] + (open ? weight / eps_n : 0.0)) < 1e-17 &&
           fabs(column - (open ? 0.0 : weight)) < 1e-15;
    traction += open ? 0.0 : weight * (multiplier[q] - 5.0);
  }
  for (int a = 0; a < 4; a++)
    total += b.out.f[3 * a + 2];
  client_check(pass && fabs(total - traction) < 1e-14, "multiplier, four points: each its own, in order");
}

/* Two slave nodes that share the point, weight 2. */
static void interpolated(void)
{
  enum { LAST = 18, ALL = 19 };
  int32_t index = -1, node = -1, kind = -1;
  static double point[3 * NODES];
  opened("PointQuad4Multiplier", -0.05, -3.0);
  memcpy(point, b.x, sizeof point);
  cte_element_find("InterpolatedQuad4Multiplier", 27, &index);
  int pass = bench_index(&b, index, 2) && b.info.unknowns == ALL && b.a.nnode == 7 &&
             cte_element_unknown(b.element, 7, LAST, &node, &kind) == CTE_SUCCESS && node == 6 &&
             kind == CTE_UNKNOWN_MULTIPLIER;
  memcpy(b.x, point, 3 * sizeof point[0]);
  memcpy(&b.x[3], point, sizeof point);
  b.row[0] = b.row[1] = 0.5;
  b.row[2] = 2.0;
  b.u[LAST] = -3.0;
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_CLOSED;
  client_check(pass && fabs(b.out.f[LAST] + 0.1) < 1e-16 && fabs(b.out.f[2] + 8.0) < 1e-14 &&
                   fabs(b.out.f[5] + 8.0) < 1e-14 && fabs(b.out.k[2 * ALL + LAST] - 1.0) < 1e-15 &&
                   fabs(b.out.k[LAST * ALL + 5] - 1.0) < 1e-15,
               "multiplier, interpolated: behind slave and master nodes, times the weight");
}

void interface_multipliers(void)
{
  described();
  closed_and_open();
  continuous();
  frozen();
  mapped(-0.05, CTE_STATUS_CLOSED, "multiplier, closed: host rows, column-major, scales");
  mapped(0.05, CTE_STATUS_OPEN, "multiplier, open: host rows, column-major, scales");
  friction();
  several();
  interpolated();
}
