/* interface_augmented.c - multipliers of the history: Uzawa's iteration with known answers, entries, transfer.
 *
 * A point over the fixed square [-1,1]^2, held by a spring k in every direction and pressed by a load. In equilibrium
 * the contact force is known: the spring does not move. A step of the iteration leaves k/(k + eps) of what is missing.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

enum { N = 15, HISTORY = 7, PATH = 5, MULTIPLIER = 6, PLAIN_HISTORY = 4, PLAIN_MULTIPLIER = 3, STEPS = 40 };

static const double eps_n = 100.0, eps_t = 30.0, spring = 50.0; /* [force/length] */

static bench a, b;

static const double square[12] = {-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0};

/* An open history; the slave at a height over the square. */
static int opened(bench *any, const char *name, double height)
{
  if (!bench_open(any, name))
    return 0;
  any->x[0] = 0.2;
  any->x[1] = -0.1;
  any->x[2] = height;
  memcpy(&any->x[3], square, sizeof square);
  if (bench_parameter(any, "eps_t") >= 0)
    bench_set(any, "eps_t", eps_t);
  return 1;
}

/* Equilibrium of the point: spring u + f = load; only the diagonal of K counts. */
static int solved(bench *any, const double load[3])
{
  double residual = 1.0;
  for (int iteration = 0; iteration < 4; iteration++) {
    if (bench_evaluate(any) != CTE_SUCCESS)
      return 0;
    residual = 0.0;
    for (int i = 0; i < 3; i++) {
      const double missing = load[i] - spring * any->u[i] - any->out.f[i];
      residual = fmax(residual, fabs(missing));
      any->u[i] += missing / (spring + any->out.k[i * N + i]);
    }
  }
  return residual < 1e-13;
}

static int augmented(bench *any)
{
  int32_t argument = -1;
  return cte_history_augment(any->element, any->out.history_trial, any->history_accepted, &argument) == CTE_SUCCESS &&
         argument == CTE_ARGUMENT_NONE;
}

static void accept(bench *any)
{
  memcpy(any->history_accepted, any->out.history_trial, (size_t)any->info.history * sizeof any->history_accepted[0]);
}

/* One evaluation: N = multiplier + eps_n g, the multiplier of history_accepted stays. */
static void one_evaluation(void)
{
  int pass = opened(&b, "PointQuad4Augmented", -0.05) && b.info.history == PLAIN_HISTORY && b.info.symmetric == 1 &&
             b.info.unknowns == N && b.info.nodes_minimum == 5;
  b.history_accepted[PLAIN_MULTIPLIER] = -3.0;
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_CLOSED;
  client_check(pass && fabs(b.out.f[2] + 8.0) < 1e-14 &&
                   fabs(b.out.output[CTE_OUTPUT_NORMAL_TRACTION] + 8.0) < 1e-14 &&
                   fabs(b.out.k[2 * N + 2] - eps_n) < 1e-13 && fabs(b.out.energy[0] - 64.0 / (2.0 * eps_n)) < 1e-15,
               "augmented: N = multiplier + eps_n g, energy = N^2/(2 eps_n)");
  client_check(b.out.history_trial[PLAIN_MULTIPLIER] == b.out.output[CTE_OUTPUT_NORMAL_TRACTION],
               "augmented: the new multiplier is N");
  b.u[2] = 0.09;
  client_check(bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_OPEN && b.out.f[2] == 0.0 &&
                   b.out.history_trial[PLAIN_MULTIPLIER] == 0.0,
               "augmented, open: no force, no multiplier");
  b.history_accepted[CTE_HISTORY_STATUS] = CTE_STATUS_CLOSED;
  b.a.request |= CTE_FREEZE_STATE;
  client_check(bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_CLOSED && fabs(b.out.f[2] - 1.0) < 1e-14 &&
                   b.out.history_trial[PLAIN_MULTIPLIER] == 0.0,
               "augmented, CTE_FREEZE_STATE: closed with N > 0, which no multiplier keeps");
}

/* Height 0.1 of the spring, load -10: the spring takes 5, the contact -5. */
static void normal(void)
{
  static const double load[3] = {0.0, 0.0, -10.0}, exact = -5.0;
  const double rate = spring / (spring + eps_n);
  double before = -exact, multiplier[STEPS];
  int pass = opened(&b, "PointQuad4Augmented", 0.1), stays = 1;
  for (int step = 0; step < STEPS; step++) {
    pass = pass && solved(&b, load) && augmented(&b);
    multiplier[step] = b.history_accepted[PLAIN_MULTIPLIER];
    pass = pass && fabs(multiplier[step] - exact - rate * before) < 1e-12;
    before = multiplier[step] - exact;
    stays &= b.history_accepted[CTE_HISTORY_STATUS] == CTE_STATUS_OPEN;
  }
  client_check(pass, "Uzawa: the multiplier's error shrinks by k/(k + eps_n)");
  client_check(fabs(before) < 1e-13 && fabs(b.out.output[CTE_OUTPUT_GAP]) < 1e-14, "Uzawa: N is the load's, no gap");
  client_check(stays, "Uzawa: the status of the start of the step stays");
  pass = opened(&a, "PointQuad4Augmented", 0.1);
  for (int step = 0; step < STEPS; step++) {
    pass = pass && solved(&a, load);
    accept(&a);
    pass = pass && fabs(a.history_accepted[PLAIN_MULTIPLIER] - multiplier[step]) < 1e-12;
  }
  client_check(pass && a.history_accepted[CTE_HISTORY_STATUS] == CTE_STATUS_CLOSED,
               "Uzawa: accepting alone makes one iteration per step");
}

/* Iterates until the gap is gone. */
static int held(bench *any, const double load[3])
{
  int pass = 1;
  for (int step = 0; step < STEPS; step++)
    pass = pass && solved(any, load) && augmented(any);
  return pass && solved(any, load);
}

/* Pressed, accepted, then pulled by less than mu |N| = 1.25: the slip of the step vanishes under the load. */
static void tangential(void)
{
  static const double press[3] = {0.0, 0.0, -10.0}, pull[3] = {0.8, -0.3, -10.0};
  const double rate = spring / (spring + eps_t);
  double before[2] = {0.0}, accepted[HISTORY];
  int pass = opened(&b, "PointQuad4CoulombAugmented", 0.1) && b.info.history == HISTORY && held(&b, press), path = 1;
  accept(&b);
  memcpy(accepted, b.history_accepted, sizeof accepted);
  client_check(pass && accepted[CTE_HISTORY_STATUS] == CTE_STATUS_STICK && fabs(accepted[MULTIPLIER] + 5.0) < 1e-13,
               "Uzawa with friction: pressed, N is the load's");
  for (int step = 0; step < STEPS; step++) {
    pass = pass && solved(&b, pull) && b.a.status == CTE_STATUS_STICK && augmented(&b);
    for (int i = 0; i < 2; i++) {
      const double expected = step == 0 ? pull[i] / (spring + eps_t) : rate * before[i];
      pass = pass && fabs(b.u[i] - expected) < 1e-12;
      before[i] = b.u[i];
    }
    path &= b.history_accepted[PATH] == 0.0 && b.out.history_trial[PATH] == 0.0;
  }
  client_check(pass, "Uzawa with friction: the slip of the step shrinks by k/(k + eps_t)");
  client_check(path && client_same(accepted, b.history_accepted, CTE_HISTORY_PROJECTION + 2),
               "Uzawa with friction: slip path, status and projection stay");
  client_check(client_near(b.out.f, pull, 2, 1e-7) && fabs(b.u[0]) + fabs(b.u[1]) < 1e-8,
               "Uzawa with friction: the traction is the load's, no slip");
  const double *t = &b.out.output[CTE_OUTPUT_TANGENTIAL_TRACTION];
  client_check(fabs(t[0] * t[0] + t[1] * t[1] - 0.73) < 1e-7, "Uzawa with friction: |T| is the load's");
  accept(&b);
  double force[3];
  memcpy(force, b.out.f, sizeof force);
  client_check(bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_STICK &&
                   client_near(b.out.f, force, 2, 1e-12),
               "Uzawa with friction: accepted, the same traction");
}

/* Pulled by more than the bound, held in place: the traction stays at mu |N|, the iteration adds nothing to it. */
static void sliding(void)
{
  double first[HISTORY];
  int pass = opened(&b, "PointQuad4CoulombAugmented", -0.05) && bench_evaluate(&b) == CTE_SUCCESS;
  accept(&b);
  b.history_accepted[MULTIPLIER] = -5.0;
  b.u[0] = 0.3;
  b.u[2] = 0.05; /* no gap */
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_SLIP && fabs(b.out.f[0] - 1.25) < 1e-13;
  memcpy(first, b.out.history_trial, sizeof first);
  pass = pass && augmented(&b) && bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_SLIP &&
         fabs(b.out.f[0] - 1.25) < 1e-13;
  client_check(pass, "Uzawa with friction, sliding: the traction stays at its bound");
  client_check(fabs(b.out.history_trial[1] - b.out.history_trial[3] - (first[1] - first[3])) < 1e-14,
               "Uzawa with friction, sliding: the elastic slip stays");
}

/* Every point of an element of several by itself; the table and the Fortran 77 entry give the same bits. */
static void entries(void)
{
  static double trial[ROOM_HISTORY], fresh[ROOM_HISTORY], expected[ROOM_HISTORY], history[ROOM_HISTORY];
  int32_t index = -1, argument = -1, code = -1;
  cte_api_table api = CTE_API_TABLE_INIT;
  int pass = cte_api(CTE_VERSION_MAJOR, &api) == CTE_SUCCESS &&
             cte_element_find("Quad4Quad4CoulombAugmented", 26, &index) == CTE_SUCCESS && bench_index(&b, index, 0) &&
             b.info.points == 4 && b.info.history == 4 * HISTORY;
  for (int i = 0; i < b.info.history; i++) {
    const double value = 0.1 * (client_random() - 1.0);
    trial[i] = i % HISTORY == PATH ? -value : i % HISTORY == 0 ? i / HISTORY : value;
    fresh[i] = i % HISTORY == PATH ? -value : i % HISTORY == 0 ? CTE_STATUS_STICK : 2.0 * value;
  }
  memcpy(expected, fresh, sizeof fresh);
  for (int point = 0; point < 4; point++) { /* open, closed: no friction there; stick, slip */
    double *to = &expected[point * HISTORY];
    const double *from = &trial[point * HISTORY];
    to[MULTIPLIER] = from[MULTIPLIER];
    for (int i = 1; i <= 2 && point >= 2; i++)
      to[2 + i] = to[i] - (from[i] - from[2 + i]);
  }
  memcpy(history, fresh, sizeof fresh);
  pass = pass && cte_history_augment(b.element, trial, history, NULL) == CTE_SUCCESS;
  client_check(pass && client_same(history, expected, b.info.history), "augment: every point by itself");
  memcpy(history, fresh, sizeof fresh);
  pass = pass && api.history_augment(b.element, trial, history, &argument) == CTE_SUCCESS;
  client_check(pass && argument == CTE_ARGUMENT_NONE && client_same(history, expected, b.info.history),
               "table: history_augment");
  memcpy(history, fresh, sizeof fresh);
  argument = -1;
  cte_f77_history_augment_(&index, trial, history, &argument, &code);
  client_check(code == CTE_SUCCESS && argument == CTE_ARGUMENT_NONE &&
                   client_same(history, expected, b.info.history),
               "F77 history_augment");
}

/* A point on the edge x = 1 goes to the coplanar facet beyond it: the force is the same. */
static void transfer(const char *name, int32_t status, const char *what)
{
  int32_t argument = -1;
  int pass = opened(&a, name, -0.02);
  a.x[0] = 0.96;
  const int last = a.info.history - 1;
  pass = pass && bench_evaluate(&a) == CTE_SUCCESS;
  accept(&a);
  a.history_accepted[last] = -4.0;
  a.u[0] = 0.04;
  a.u[1] = 0.003;
  pass = pass && bench_evaluate(&a) == CTE_SUCCESS && a.a.status == status && fabs(a.out.history_trial[last] + 6.0) < 1e-14;
  accept(&a); /* the state at its end */
  a.u[2] = 0.02;
  pass = pass && bench_evaluate(&a) == CTE_SUCCESS && a.a.status == status;
  pass = pass && opened(&b, name, -0.02);
  b.x[0] = 0.96;
  for (int node = 1; node < 5; node++)
    b.x[3 * node] += 2.0;
  memcpy(b.u, a.u, 3 * sizeof b.u[0]);
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS &&
         cte_history_transfer(a.element, a.out.output, a.out.history_trial, b.element, b.out.output, b.out.history_trial,
                              &argument) == CTE_SUCCESS;
  client_check(pass && argument == CTE_ARGUMENT_NONE && b.out.history_trial[0] == status &&
                   client_same(&b.out.history_trial[last], &a.out.history_trial[last], 1) &&
                   client_same(&b.out.history_trial[1], &b.out.output[CTE_OUTPUT_PROJECTION], 2),
               what);
  accept(&b);
  pass = pass && bench_evaluate(&b) == CTE_SUCCESS;
  client_check(pass && client_near(b.out.f, a.out.f, 3, 1e-13) && fabs(b.out.f[2] + 6.0) < 1e-13,
               "transfer of a multiplier: the force does not jump");
}

void interface_augmented(void)
{
  one_evaluation();
  normal();
  tangential();
  sliding();
  entries();
  transfer("PointQuad4Augmented", CTE_STATUS_CLOSED, "transfer of a multiplier: status and multiplier go along");
  transfer("PointQuad4CoulombAugmented", CTE_STATUS_STICK, "transfer of a multiplier with friction: they go along");
}
