/* interface_friction.c - friction as documented: where contact begins, stick, slip, history, freezing.
 *
 * A point on a flat facet, |N| = 5 at a depth of 0.05, eps_t = 50, mu = 1/4: slip begins at |T| = 1.25.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

enum { N = 15, HISTORY = 6, ANCHOR = 3, PATH = 5 };

static const double eps_n = 100.0, eps_t = 50.0; /* [force/length] */

static bench b, plain;

/* An open history; the slave in the middle of the facet. */
static int opened(bench *any, const char *name)
{
  static const double x[N] = {0.2, -0.1, -0.05, -1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0};
  if (!bench_open(any, name))
    return 0;
  memcpy(any->x, x, sizeof x);
  return 1;
}

static int evaluated(int32_t status)
{
  bench_canary(&b);
  return bench_evaluate(&b) == CTE_SUCCESS && b.a.status == status &&
         b.out.output[CTE_OUTPUT_STATUS] == status && b.out.history_trial[CTE_HISTORY_STATUS] == status;
}

static void move(double x, double y)
{
  b.u[0] = x;
  b.u[1] = y;
}

static void accept(void)
{
  memcpy(b.history_accepted, b.out.history_trial, HISTORY * sizeof b.history_accepted[0]);
}

/* The friction on the slave, T_1 d_1 + T_2 d_2, is (x, y, 0); f holds it with the other sign. */
static int friction_is(double x, double y)
{
  const double *out = b.out.output, *t = &out[CTE_OUTPUT_TANGENTIAL_TRACTION];
  const double *b_1 = &out[CTE_OUTPUT_TANGENTS], *n = &out[CTE_OUTPUT_NORMAL];
  const double expected[3] = {x, y, 0.0}, length = sqrt(b_1[0] * b_1[0] + b_1[1] * b_1[1] + b_1[2] * b_1[2]);
  double found[3], on_slave[3];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    found[i] = (t[0] * b_1[i] + t[1] * (n[j] * b_1[k] - n[k] * b_1[j])) / length; /* d_2 = n x d_1 */
    on_slave[i] = out[CTE_OUTPUT_NORMAL_TRACTION] * n[i] - b.out.f[i];
  }
  return client_near(found, expected, 3, 1e-12) && client_near(on_slave, expected, 3, 1e-12);
}

static double asymmetry(void)
{
  double largest = 0.0;
  for (int i = 0; i < N; i++)
    for (int j = 0; j < i; j++)
      largest = fmax(largest, fabs(b.out.k[i * N + j] - b.out.k[j * N + i]));
  return largest;
}

static void begins(void)
{
  static double history[HISTORY];
  client_check(b.info.history == HISTORY && b.info.symmetric == 0 && b.info.projected == 2,
               "friction: history of 2 + 2 P entries, no symmetry");
  int pass = opened(&plain, "PointQuad4") && bench_evaluate(&plain) == CTE_SUCCESS && evaluated(CTE_STATUS_STICK);
  const double *t = &b.out.output[CTE_OUTPUT_TANGENTIAL_TRACTION], *h = b.out.history_trial;
  client_check(pass && t[0] == 0.0 && t[1] == 0.0 && client_near(b.out.f, plain.out.f, N, 1e-14) &&
                   client_near(b.out.k, plain.out.k, N * N, 1e-14),
               "friction begins: no tangential force, no tangential stiffness");
  client_check(client_same(&h[CTE_HISTORY_PROJECTION], &h[ANCHOR], 2) && h[PATH] == 0.0 &&
                   client_same(&h[CTE_HISTORY_PROJECTION], &b.out.output[CTE_OUTPUT_PROJECTION], 2),
               "friction begins: the anchor is the projection");
  memcpy(history, h, sizeof history);
  b.a.history_accepted = NULL;
  client_check(evaluated(CTE_STATUS_STICK) && client_same(history, b.out.history_trial, HISTORY),
               "friction begins without history_accepted too");
  b.a.history_accepted = b.history_accepted;
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_OUTSIDE;
  b.history_accepted[ANCHOR] = 0.9;
  client_check(evaluated(CTE_STATUS_STICK) && client_same(history, b.out.history_trial, HISTORY),
               "friction begins where the history says outside");
  client_check(plain.info.history == 3 && plain.out.output[CTE_OUTPUT_TANGENTIAL_TRACTION] == 0.0 &&
                   client_same(&plain.out.output[CTE_OUTPUT_TANGENTS], &b.out.output[CTE_OUTPUT_TANGENTS], 6),
               "without friction: tangents in the output, no tangential force");
}

static void sticks(void)
{
  static double anchor[2];
  accept();
  memcpy(anchor, &b.history_accepted[ANCHOR], sizeof anchor);
  move(0.01, -0.02);
  client_check(evaluated(CTE_STATUS_STICK) && friction_is(-0.5, 1.0), "stick: T = eps_t s, against the motion");
  client_check(client_same(anchor, &b.out.history_trial[ANCHOR], 2) && b.out.history_trial[PATH] == 0.0 &&
                   !client_same(anchor, &b.out.history_trial[CTE_HISTORY_PROJECTION], 2),
               "stick: the anchor stays");
  client_check(fabs(b.out.energy[0] - eps_n * 0.05 * 0.05 / 2.0 - 1.25 / (2.0 * eps_t)) < 1e-14,
               "stick: energy = W + T^2/(2 eps_t)");
}

/* |s| = 0.05, trial force 2.5: half of the slip stays elastic, half is slid. */
static void slides(void)
{
  static double first[N];
  move(0.03, -0.04);
  client_check(evaluated(CTE_STATUS_SLIP) && friction_is(-0.75, 1.0), "slip: |T| = mu |N| against the slip");
  client_check(fabs(b.out.history_trial[PATH] - 0.025) < 1e-14 &&
                   fabs(b.out.history_trial[1] - b.out.history_trial[ANCHOR] - 0.015) < 1e-14 &&
                   fabs(b.out.history_trial[2] - b.out.history_trial[ANCHOR + 1] + 0.02) < 1e-14,
               "slip: the anchor follows at the elastic distance, the path grows");
  client_check(asymmetry() > 0.1, "slip: K is not symmetric");
  memcpy(first, b.out.f, sizeof first);
  client_check(evaluated(CTE_STATUS_SLIP) && client_same(first, b.out.f, N), "no evaluation reads history_trial");
  accept();
  bench_canary(&b);
  client_check(bench_evaluate(&b) == CTE_SUCCESS && client_near(b.out.f, first, N, 1e-13) &&
                   fabs(b.out.history_trial[PATH] - 0.025) < 1e-14,
               "slip accepted: the same force at the same place");
  move(0.02, -0.04);
  client_check(evaluated(CTE_STATUS_STICK) && friction_is(-0.25, 1.0), "turned back: elastic from the bound");
}

static void frozen(void)
{
  opened(&b, "PointQuad4Coulomb");
  bench_set(&b, "eps_t", eps_t);
  evaluated(CTE_STATUS_STICK);
  accept();
  b.a.request |= CTE_FREEZE_STATE;
  move(0.03, -0.04);
  client_check(evaluated(CTE_STATUS_STICK) && friction_is(-1.5, 2.0), "CTE_FREEZE_STATE: sticks beyond the bound");
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_CLOSED;
  client_check(evaluated(CTE_STATUS_SLIP) && friction_is(-0.75, 1.0), "CTE_FREEZE_STATE: closed, the law decides");
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_SLIP;
  move(0.003, -0.004);
  client_check(evaluated(CTE_STATUS_SLIP) && friction_is(-0.75, 1.0), "CTE_FREEZE_STATE: slides below the bound");
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_OPEN;
  client_check(evaluated(CTE_STATUS_OPEN) && b.out.f[2] == 0.0, "CTE_FREEZE_STATE: open");
}

/* Two points of one element: the one that is remembered slides, the other one begins. */
static void rank(void)
{
  static const double x[8] = {0.0, -0.1, 1.0, -0.1, -1.0, 0.0, 2.0, 0.0};
  int32_t index = -1;
  cte_element_find("Line2Line2Coulomb2d", 19, &index);
  if (!bench_index(&b, index, 0)) {
    client_check(0, "Line2Line2Coulomb2d");
    return;
  }
  memcpy(b.x, x, sizeof x);
  int pass = evaluated(CTE_STATUS_STICK) && b.a.closed_points == 2 && b.info.history == 8;
  memcpy(b.history_accepted, b.out.history_trial, 4 * sizeof b.history_accepted[0]);
  bench_set(&b, "eps_t", 1000.0);
  b.u[0] = b.u[2] = 0.1;
  bench_canary(&b);
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.out.history_trial[0] == CTE_STATUS_SLIP &&
         b.out.history_trial[4] == CTE_STATUS_STICK && b.a.status == CTE_STATUS_SLIP && b.a.closed_points == 2;
  client_check(pass, "the status of an element: slip before stick");
}

void interface_friction(void)
{
  if (!opened(&b, "PointQuad4Coulomb"))
    return;
  bench_set(&b, "eps_t", eps_t);
  begins();
  sticks();
  slides();
  frozen();
  rank();
}
