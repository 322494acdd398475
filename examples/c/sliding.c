/* sliding.c - a block pressed onto another and pushed along it, with friction: stick, slip, and back.
 *
 * The bricks of brick_model.h; four elements "PointQuad4Coulomb" join the upper brick's lower nodes to the lower
 * brick's top face. The same steps are run with three tangents: the exact one, the one that leaves out the gap
 * (of "PointQuad4CoulombTangentPlane"; the residual stays the exact one, so the solution is the same), and the
 * exact one made symmetric. Printed are the residual norms, iterations and orders of convergence.
 * sliding.f90 is the twin.
 */
#define _GNU_SOURCE /* feenableexcept */
#include "brick_model.h"
#include "contact_elements.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
  CONTACTS = 4,
  NODES = 5,
  N = 3 * NODES,     /* unknowns of a contact */
  HISTORY = 6,       /* status, projection, anchor, slip path */
  SLIP_PATH = 5,     /* the last of them */
  PARAMETERS = 5,
  PRESSING = 2,      /* steps */
  PUSHING = 5,
  RETURNING = 5,
  STEPS = PRESSING + PUSHING + RETURNING,
  ITERATIONS = 60,
  VARIANTS = 3
};

enum variant { EXACT, TANGENT_PLANE, SYMMETRISED };

static const char *const variant_name[VARIANTS] = {"exact", "tangent plane", "symmetrised"};

static const double young = 1000.0;      /* [force/length^2] */
static const double poisson = 0.3;       /* [1] */
static const double friction = 0.3;      /* coefficient [1] */
static const double stiffness = 300.0;   /* normal and tangential penalty [force/length] */
static const double converged = 5.0e-11; /* norm of the residual [force] */

/* Displacement of the top face in a step [length]. */
static const double press[3] = {0.0, 0.0, -0.1}, push[3] = {0.05, 0.025, 0.0}, back[3] = {-0.08, -0.04, 0.0};

typedef struct contact_set {
  enum variant variant;
  const cte_element *element, *tangent_plane;
  double parameters[PARAMETERS];
  double history_accepted[CONTACTS][HISTORY], history_trial[CONTACTS][HISTORY];
  double output[CONTACTS][CTE_OUTPUT_SIZE];
  int32_t status[CONTACTS];
} contact_set;

typedef struct model {
  double x[MODEL_NODES][3];
  double u[MODEL_UNKNOWNS];
  int prescribed[MODEL_UNKNOWNS];
  double elastic[MODEL_UNKNOWNS][MODEL_UNKNOWNS]; /* constant: small strain */
  double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS];
  double f[MODEL_UNKNOWNS];
} model;

/* What a run leaves behind. */
typedef struct record {
  int iterations[STEPS], sliding[STEPS]; /* sliding: contacts */
  double order[STEPS], u[STEPS][MODEL_UNKNOWNS];
} record;

static const cte_element *element_of(const char *name)
{
  int32_t index = -1;
  cte_info info = CTE_INFO_INIT;
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS)
    return NULL;
  const cte_element *element = cte_element_get(index);
  const int fits = cte_element_info(element, 0, &info) == CTE_SUCCESS && info.unknowns == N &&
                   info.history == HISTORY && info.parameters == PARAMETERS && info.symmetric == 0;
  return fits ? element : NULL;
}

static int contact_start(contact_set *contact, enum variant variant)
{
  const double parameters[PARAMETERS] = {stiffness, stiffness, friction, 0.0, 1.0}; /* r0, orientation */
  memset(contact, 0, sizeof *contact);
  contact->variant = variant;
  contact->element = element_of("PointQuad4Coulomb");
  contact->tangent_plane = element_of("PointQuad4CoulombTangentPlane");
  memcpy(contact->parameters, parameters, sizeof parameters);
  for (int c = 0; c < CONTACTS; c++)
    if (contact->element == NULL || contact->tangent_plane == NULL ||
        cte_element_history_init(contact->element, contact->history_accepted[c]) != CTE_SUCCESS)
      return 0;
  return 1;
}

/* Slave, then the facet counter-clockwise seen from above, so that its normal is +z. */
static int node_of(int c, int a)
{
  return a == 0 ? BRICK_NODES + c : 3 + a;
}

/* Force and tangent of a contact. `elastic`: it holds to its anchor if it was in contact, whatever the bound. */
static int contact_element(contact_set *contact, const model *m, int c, int elastic, double f[N], double k[N][N])
{
  double x[N], u[N], history[HISTORY];
  for (int i = 0; i < N; i++) {
    x[i] = m->x[node_of(c, i / 3)][i % 3];
    u[i] = m->u[3 * node_of(c, i / 3) + i % 3];
  }
  memcpy(history, contact->history_accepted[c], sizeof history);
  elastic = elastic && history[CTE_HISTORY_STATUS] != CTE_STATUS_OPEN;
  if (elastic)
    history[CTE_HISTORY_STATUS] = CTE_STATUS_STICK;
  cte_arguments a = CTE_ARGUMENTS_INIT;
  a.request = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | (elastic ? CTE_FREEZE_STATE : 0u) |
              (contact->variant == SYMMETRISED ? CTE_SYMMETRISE : 0u);
  a.x = x;
  a.u = u;
  a.parameters = contact->parameters;
  a.parameter_count = PARAMETERS;
  a.history_accepted = history;
  a.history_trial = contact->history_trial[c];
  a.output = contact->output[c];
  a.f = f;
  a.k = &k[0][0];
  int32_t code = cte_element_evaluate(contact->element, &a);
  contact->status[c] = a.status;
  if (code == CTE_SUCCESS && contact->variant == TANGENT_PLANE) {
    a.request = CTE_TANGENT | (elastic ? CTE_FREEZE_STATE : 0u);
    code = cte_element_evaluate(contact->tangent_plane, &a);
  }
  if (code != CTE_SUCCESS)
    printf("FAIL contact %d: %s\n", c, cte_code_message(code));
  return code == CTE_SUCCESS;
}

/* Internal force and tangent of bricks and contacts at m->u. */
static int assemble(contact_set *contact, model *m, int elastic)
{
  memcpy(m->k, m->elastic, sizeof m->k);
  for (int i = 0; i < MODEL_UNKNOWNS; i++) {
    m->f[i] = 0.0;
    for (int j = 0; j < MODEL_UNKNOWNS; j++)
      m->f[i] += m->elastic[i][j] * m->u[j];
  }
  for (int c = 0; c < CONTACTS; c++) {
    double f[N], k[N][N];
    if (!contact_element(contact, m, c, elastic, f, k))
      return 0;
    for (int i = 0; i < N; i++) {
      const int row = 3 * node_of(c, i / 3) + i % 3;
      m->f[row] += f[i];
      for (int j = 0; j < N; j++)
        m->k[row][3 * node_of(c, j / 3) + j % 3] += k[i][j];
    }
  }
  return 1;
}

/* Newton iterations, the first with the elastic tangent: a step that turns back begins at the bound, where the
 * tangent of sliding knows no way back. Prints the norms [force]. Returns their number, 0 on failure. */
static int newton(contact_set *contact, model *m)
{
  for (int it = 0; it < ITERATIONS; it++) {
    if (!assemble(contact, m, it == 0))
      return 0;
    const double norm = brick_model_residual(m->prescribed, m->f);
    if (contact->variant != SYMMETRISED)
      printf(" %.1e", norm);
    if (it > 0 && norm < converged)
      return it + 1;
    if (!brick_model_correct(m->prescribed, m->k, m->f, m->u))
      return 0;
  }
  return 0;
}

/* The residual after one iteration from `distance` off the solution [force]; -1 where a contact changes its
 * status on the way, or something fails. */
static double residual_from(contact_set *contact, model *m, double distance)
{
  int32_t status[CONTACTS];
  memcpy(status, contact->status, sizeof status);
  for (int i = 0; i < MODEL_UNKNOWNS; i++)
    if (!m->prescribed[i])
      m->u[i] += distance * sin(i + 1.0);
  int pass = assemble(contact, m, 0) && memcmp(status, contact->status, sizeof status) == 0 && brick_model_correct(m->prescribed, m->k, m->f, m->u);
  pass = pass && assemble(contact, m, 0) && memcmp(status, contact->status, sizeof status) == 0;
  return pass ? brick_model_residual(m->prescribed, m->f) : -1.0;
}

/* Order of convergence at the solution: how that residual falls when the distance is halved; -1 where the branch
 * is left. The model and the trial history stay as they are. */
static double order_at(contact_set *contact, model *m)
{
  static model near;
  contact_set trial;
  double norm[2];
  for (int i = 0; i < 2; i++) {
    trial = *contact;
    near = *m;
    norm[i] = residual_from(&trial, &near, i == 0 ? 1.0e-3 : 5.0e-4);
  }
  return norm[0] > 0.0 && norm[1] > 0.0 ? log2(norm[0] / norm[1]) : -1.0;
}

/* Coulomb's law at the accepted state: |T| = mu |N| and a longer path where it slides, |T| <= mu |N| and the old
 * anchor where it sticks. Returns the number of sliding contacts, -1 where the law is broken. */
static int sliding_contacts(const contact_set *contact)
{
  int count = 0;
  for (int c = 0; c < CONTACTS; c++) {
    const double *out = contact->output[c], *t = &out[CTE_OUTPUT_TANGENTIAL_TRACTION];
    const double bound = friction * fabs(out[CTE_OUTPUT_NORMAL_TRACTION]), force = sqrt(t[0] * t[0] + t[1] * t[1]);
    const double slid = contact->history_trial[c][SLIP_PATH] - contact->history_accepted[c][SLIP_PATH];
    const int slips = contact->status[c] == CTE_STATUS_SLIP;
    if (slips ? fabs(force - bound) > 1e-12 * bound || slid <= 0.0 : force > bound || slid != 0.0)
      return -1;
    count += slips;
  }
  return count;
}

/* One step: pressing moves the upper brick rigidly, so that the contact, whose gap is zero in the beginning, is
 * closed in the first iteration; pushing moves its top face alone. */
static int step(contact_set *contact, model *m, int number, record *r)
{
  const double *move = number < PRESSING ? press : number < PRESSING + PUSHING ? push : back;
  const int first = number < PRESSING ? BRICK_NODES : MODEL_NODES - 4;
  for (int node = first; node < MODEL_NODES; node++)
    for (int i = 0; i < 3; i++)
      m->u[3 * node + i] += move[i];
  if (contact->variant != SYMMETRISED)
    printf("step %2d %s:", number + 1, variant_name[contact->variant]);
  r->iterations[number] = newton(contact, m);
  if (contact->variant != SYMMETRISED)
    printf("\n");
  r->order[number] = order_at(contact, m);
  r->sliding[number] = sliding_contacts(contact);
  memcpy(r->u[number], m->u, sizeof m->u);
  memcpy(contact->history_accepted, contact->history_trial, sizeof contact->history_accepted); /* the step is accepted */
  return r->iterations[number] > 0 && r->sliding[number] >= 0;
}

static int run(enum variant variant, record *r)
{
  static model m;
  contact_set contact;
  memset(&m, 0, sizeof m);
  brick_model_coordinates(m.x);
  brick_model_prescribed(m.prescribed);
  brick_model_stiffness(m.x, young, poisson, m.elastic);
  int pass = contact_start(&contact, variant);
  for (int number = 0; number < STEPS && pass; number++)
    pass = step(&contact, &m, number, r);
  printf("%s %s tangent: every step converged, Coulomb's law holds\n", pass ? "PASS" : "FAIL", variant_name[variant]);
  return pass;
}

/* The sum of the iterations, and the largest difference between the displacements of two runs [length]. */
static int total(const record *r)
{
  int sum = 0;
  for (int number = 0; number < STEPS; number++)
    sum += r->iterations[number];
  return sum;
}

static double difference(const record *a, const record *b)
{
  double largest = 0.0;
  for (int number = 0; number < STEPS; number++)
    for (int i = 0; i < MODEL_UNKNOWNS; i++)
      largest = fmax(largest, fabs(a->u[number][i] - b->u[number][i]));
  return largest;
}

static int check(int pass, const char *what)
{
  printf("%s %s\n", pass ? "PASS" : "FAIL", what);
  return pass;
}

static int compare(const record r[VARIANTS])
{
  int quadratic = 1;
  printf("step  sliding  iterations: exact, tangent plane, symmetrised  order\n");
  for (int number = 0; number < STEPS; number++) {
    printf("%4d %8d %18d %14d %12d  %5.2f %5.2f %5.2f\n", number + 1, r[EXACT].sliding[number],
           r[EXACT].iterations[number], r[TANGENT_PLANE].iterations[number], r[SYMMETRISED].iterations[number],
           r[EXACT].order[number], r[TANGENT_PLANE].order[number], r[SYMMETRISED].order[number]);
    quadratic &= r[EXACT].order[number] >= 1.9 && r[EXACT].iterations[number] <= 8;
  }
  printf("total %25d %14d %12d\n", total(&r[EXACT]), total(&r[TANGENT_PLANE]), total(&r[SYMMETRISED]));
  const int *sliding = r[EXACT].sliding, turn = PRESSING + PUSHING;
  int pass = check(quadratic, "exact tangent: order at least 1.9, at most 8 iterations");
  pass &= check(sliding[turn - 1] == CONTACTS && sliding[turn] == 0 && sliding[STEPS - 1] == CONTACTS,
                "slides, sticks when it is turned back, slides the other way");
  pass &= check(difference(&r[EXACT], &r[TANGENT_PLANE]) < 1e-9 && difference(&r[EXACT], &r[SYMMETRISED]) < 1e-9,
                "the solution does not depend on the tangent");
  return check(total(&r[EXACT]) < total(&r[TANGENT_PLANE]) && total(&r[EXACT]) < total(&r[SYMMETRISED]),
               "the exact tangent needs the fewest iterations") &
         pass;
}

int main(void)
{
  static record records[VARIANTS];
  int pass = 1;
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  setvbuf(stdout, NULL, _IOLBF, 0); /* a trap must not swallow what came before */
  for (int variant = 0; variant < VARIANTS; variant++)
    pass &= run(variant, &records[variant]);
  pass = check(compare(records) && pass, "sliding");
  return pass ? 0 : 1;
}
