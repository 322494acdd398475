/* bricks.c - a small finite-element program that calls the contact element as a legacy host would.
 *
 * An upper brick is pushed onto a lower one; four contact elements "PointQuad4" join the upper brick's
 * lower nodes (slaves) to the lower brick's top face (master). Newton with the element's tangent.
 * The host has its own layout: room for NEN nodes with NDF unknowns each per element, right-hand side
 * p = -f, row-major s[NST][NST]. The element writes straight into p and s through unknown_map and strides.
 * bricks.f90 (module) and bricks.f (Fortran 77 entries) are the twins.
 *
 * Reference: the same problem in six independent finite-element programs.
 */
#define _GNU_SOURCE /* feenableexcept */
#include "brick_model.h"
#include "contact_elements.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
  NDM = 3,          /* coordinates of a node */
  NDF = 4,          /* unknowns of a node in this host; the last one is not mechanical */
  NEN = 8,          /* most nodes of an element in this host */
  NST = NDF * NEN,  /* rows of an element matrix */
  CONTACTS = 4,
  CONTACT_NODES = 5,
  CONTACT_UNKNOWNS = 15,
  HISTORY = 16,     /* room for the history of a contact */
  PARAMETERS = 16,  /* room for parameters */
  STEPS = 5,        /* of the push */
  ITERATIONS = 20
};

static const double young = 1000.0;      /* [force/length^2] */
static const double poisson = 0.3;       /* [1] */
static const double eps_n = 1.0e4;       /* [force/length] */
static const double push = -0.05;        /* u_z of the top face [length] */
static const double slide[3] = {0.2, 0.1, 0.0}; /* of the top face after the push [length] */
static const double converged = 5.0e-11; /* norm of the residual [force] */

/* Slave node, then the facet counter-clockwise seen from above, so that its normal is +z. */
static const int contact_node[CONTACTS][CONTACT_NODES] = {
    {8, 4, 5, 6, 7}, {9, 4, 5, 6, 7}, {10, 4, 5, 6, 7}, {11, 4, 5, 6, 7}};

typedef struct contact_set {
  const cte_element *element;
  cte_info info;
  double parameters[PARAMETERS];
  int32_t map[CONTACT_UNKNOWNS]; /* element unknown -> row of the host's element matrix */
  double history_accepted[CONTACTS][HISTORY], history_trial[CONTACTS][HISTORY];
} contact_set;

typedef struct model {
  double x[MODEL_NODES][NDM];
  double u[MODEL_UNKNOWNS];
  int prescribed[MODEL_UNKNOWNS];
  double elastic[MODEL_UNKNOWNS][MODEL_UNKNOWNS]; /* constant: small strain */
  double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS];
  double f[MODEL_UNKNOWNS]; /* internal force, bricks and contact */
} model;

/* Sets the named parameter; 0 when the element has none of that name. */
static int set_parameter(contact_set *contact, const char *wanted, double value)
{
  for (int32_t i = 0; i < contact->info.parameters; i++) {
    const char *name;
    if (cte_element_parameter(contact->element, i, &name, NULL, NULL, NULL, NULL) == CTE_SUCCESS &&
        strcmp(name, wanted) == 0) {
      contact->parameters[i] = value;
      return 1;
    }
  }
  printf("FAIL no parameter %s\n", wanted);
  return 0;
}

/* Where each element unknown stands in the host's element matrix. */
static int make_map(contact_set *contact)
{
  for (int32_t i = 0; i < CONTACT_UNKNOWNS; i++) {
    int32_t node, kind;
    if (cte_element_unknown(contact->element, 0, i, &node, &kind) != CTE_SUCCESS)
      return 0;
    contact->map[i] = node * NDF + (kind - CTE_UNKNOWN_UX);
  }
  return 1;
}

static int contact_start(contact_set *contact)
{
  static const char name[] = "PointQuad4";
  int32_t index, bad;
  memset(contact, 0, sizeof *contact);
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS)
    return 0;
  contact->element = cte_element_get(index);
  contact->info = (cte_info)CTE_INFO_INIT;
  if (cte_element_info(contact->element, 0, &contact->info) != CTE_SUCCESS)
    return 0;
  if (contact->info.unknowns != CONTACT_UNKNOWNS || contact->info.history > HISTORY ||
      contact->info.parameters > PARAMETERS || contact->info.workspace != 0)
    return 0;
  if (!set_parameter(contact, "eps_n", eps_n) || !set_parameter(contact, "r0", 0.0) || !make_map(contact))
    return 0;
  for (int c = 0; c < CONTACTS; c++)
    if (cte_element_history_init(contact->element, contact->history_accepted[c]) != CTE_SUCCESS)
      return 0;
  return cte_element_check_parameters(contact->element, contact->parameters, contact->info.parameters, &bad) ==
         CTE_SUCCESS;
}

/* One contact element in the host's own layout: p = -f, s = +K. */
static int contact_element(contact_set *contact, const model *m, int c, double p[NST], double s[NST][NST])
{
  double xl[NEN][NDM] = {{0.0}}, ul[NEN][NDF] = {{0.0}};
  for (int a = 0; a < CONTACT_NODES; a++)
    for (int i = 0; i < NDM; i++) {
      xl[a][i] = m->x[contact_node[c][a]][i];
      ul[a][i] = m->u[3 * contact_node[c][a] + i];
    }
  memset(p, 0, sizeof(double) * NST);
  memset(s, 0, sizeof(double) * NST * NST);
  cte_arguments a = CTE_ARGUMENTS_INIT;
  a.request = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY;
  a.nnode = CONTACT_NODES;
  a.x = &xl[0][0];
  a.u = &ul[0][0];
  a.x_node_stride = NDM;
  a.u_node_stride = NDF;
  a.parameters = contact->parameters;
  a.parameter_count = contact->info.parameters;
  a.history_accepted = contact->history_accepted[c];
  a.history_trial = contact->history_trial[c];
  a.f = p;
  a.f_scale = -1.0;
  a.k = &s[0][0];
  a.k_row_stride = NST;
  a.k_col_stride = 1;
  a.unknown_map = contact->map;
  const int32_t code = cte_element_evaluate(contact->element, &a);
  if (code != CTE_SUCCESS) {
    char text[256];
    cte_element_message(contact->element, &a, code, text, sizeof text);
    printf("FAIL contact %d: %s\n", c, text);
  }
  return code == CTE_SUCCESS;
}

/* Internal force and tangent of bricks and contacts at m->u. */
static int assemble(contact_set *contact, model *m)
{
  memcpy(m->k, m->elastic, sizeof m->k);
  for (int i = 0; i < MODEL_UNKNOWNS; i++) {
    m->f[i] = 0.0;
    for (int j = 0; j < MODEL_UNKNOWNS; j++)
      m->f[i] += m->elastic[i][j] * m->u[j];
  }
  for (int c = 0; c < CONTACTS; c++) {
    double p[NST], s[NST][NST];
    if (!contact_element(contact, m, c, p, s))
      return 0;
    for (int row = 0; row < CONTACT_NODES * NDF; row++) {
      if (row % NDF == NDF - 1)
        continue;
      const int i = 3 * contact_node[c][row / NDF] + row % NDF;
      m->f[i] -= p[row];
      for (int col = 0; col < CONTACT_NODES * NDF; col++)
        if (col % NDF != NDF - 1)
          m->k[i][3 * contact_node[c][col / NDF] + col % NDF] += s[row][col];
    }
  }
  return 1;
}

/* Newton iterations; residual[] receives the norms [force]. Returns their number, 0 on failure. */
static int newton(contact_set *contact, model *m, int step, double residual[ITERATIONS])
{
  for (int it = 0; it < ITERATIONS; it++) {
    if (!assemble(contact, m))
      return 0;
    residual[it] = brick_model_residual(m->prescribed, m->f);
    printf("step %d iteration %d residual %.3e\n", step, it, residual[it]);
    if (residual[it] < converged)
      return it + 1;
    if (!brick_model_correct(m->prescribed, m->k, m->f, m->u))
      return 0;
  }
  return 0;
}

/* Quadratic: each residual is less than its predecessor's square times a constant [1/force], up to
 * rounding. */
static int quadratic(const double residual[ITERATIONS], int count)
{
  const double constant = 2.0;
  int pass = count > 0;
  for (int it = 1; it < count; it++)
    if (residual[it] > constant * residual[it - 1] * residual[it - 1] + converged)
      pass = 0;
  printf("%s quadratic convergence, %d iterations\n", pass ? "PASS" : "FAIL", count);
  return pass;
}

/* Ten digits; the reference itself is rounded to the digits given. */
static int agrees(const char *what, double value, double reference)
{
  const int pass = fabs(value - reference) <= 1.0e-10 * fabs(reference);
  printf("%s %-28s %.11e reference %.11e\n", pass ? "PASS" : "FAIL", what, value, reference);
  return pass;
}

static int compare(const model *m)
{
  int pass = 1;
  pass &= agrees("reaction z at (0,0,0)", m->f[2], 4.53720508167);
  pass &= agrees("u_x of (0,0,1)", m->u[3 * 4], -3.5390199637e-3);
  pass &= agrees("u_y of (0,0,1)", m->u[3 * 4 + 1], -3.5390199637e-3);
  pass &= agrees("u_z of (0,0,1)", m->u[3 * 4 + 2], -1.6515426497e-2);
  pass &= agrees("u_z of (0.25,0.25,1)", m->u[3 * 8 + 2], -1.6969147005e-2);
  return pass;
}

/* One step: the upper brick first moves along rigidly, so there is no strain and the contact, whose gap
 * is zero in the beginning, is closed in the first iteration. */
static int step(contact_set *contact, model *m, int number, const double move[3])
{
  double residual[ITERATIONS];
  for (int node = BRICK_NODES; node < MODEL_NODES; node++)
    for (int i = 0; i < 3; i++)
      m->u[3 * node + i] += move[i];
  const int count = newton(contact, m, number, residual);
  memcpy(contact->history_accepted, contact->history_trial, sizeof contact->history_accepted); /* the step is accepted */
  return quadratic(residual, count);
}

/* The push in equal steps, compared with the reference. Its facet stays flat, which makes it almost
 * linear; the slide after it has no reference, but warps the facet and moves the slaves on it. */
static int run(contact_set *contact, model *m)
{
  const double down[3] = {0.0, 0.0, push / STEPS};
  int pass = 1;
  for (int number = 1; number <= STEPS; number++)
    pass &= step(contact, m, number, down);
  pass &= compare(m);
  pass &= step(contact, m, STEPS + 1, slide);
  return pass;
}

int main(void)
{
  static contact_set contact;
  static model m;
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  setvbuf(stdout, NULL, _IOLBF, 0); /* a trap must not swallow what came before */
  if (!contact_start(&contact)) {
    printf("FAIL the contact element is not as expected\n");
    return 1;
  }
  brick_model_coordinates(m.x);
  brick_model_prescribed(m.prescribed);
  brick_model_stiffness(m.x, young, poisson, m.elastic);
  const int pass = run(&contact, &m);
  printf("%s bricks\n", pass ? "PASS" : "FAIL");
  return pass ? 0 : 1;
}
