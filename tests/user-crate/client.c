/* client.c - the elements of this crate from C: tangents against central differences, balance of force.
 *
 * Tolerances: K against the difference quotient of f, 1e-6 of the largest entry (step 1e-6 [length]: truncation
 * about 1e-10, cancellation about 1e-9); forces against N n dA, 1e-12 of the largest force.
 */
#include "rail.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NODES = 16, UNKNOWNS = 3 * NODES, PARAMETERS = 32, POINTS = 16, HISTORY = 64 };

/* One contact: what a host keeps for it. */
typedef struct contact {
  const char *name;
  const cte_element *element;
  int32_t (*evaluate)(cte_arguments *); /* the element's own symbol */
  cte_info info;
  cte_arguments a;
  double x[UNKNOWNS], u[UNKNOWNS], parameters[PARAMETERS], history[HISTORY], row[NODES];
  double f[UNKNOWNS], k[UNKNOWNS * UNKNOWNS], output[POINTS * CTE_OUTPUT_SIZE], energy;
  double workspace[1 << 14];
} contact;

static contact contacts[7];
static int count, failures;

static void check(int pass, const contact *c, const char *what)
{
  printf("%s %s: %s\n", pass ? "PASS" : "FAIL", c->name, what);
  failures += !pass;
}

static void set(contact *c, const char *wanted, double value)
{
  const char *name = NULL;
  for (int32_t i = 0; i < c->info.parameters; i++)
    if (rail_element_parameter(c->element, i, &name, NULL, NULL, NULL, NULL) == CTE_SUCCESS &&
        strcmp(name, wanted) == 0) {
      c->parameters[i] = value;
      return;
    }
  check(0, c, wanted);
}

/* A new contact of the element at `index`, which should be called `name`; nslave: of interpolated slaves. */
static contact *open(int32_t index, const char *name, int32_t (*evaluate)(cte_arguments *), int32_t nslave)
{
  contact *c = &contacts[count++];
  int32_t found = -1;
  cte_arguments *a = &c->a;
  c->name = name;
  c->evaluate = evaluate;
  c->element = rail_element_get(index);
  c->info = (cte_info)CTE_INFO_INIT;
  check(rail_element_find(name, (int32_t)strlen(name), &found) == CTE_SUCCESS && found == index, c, "found");
  check(rail_element_info(c->element, nslave, &c->info) == CTE_SUCCESS && c->info.unknowns <= UNKNOWNS &&
            c->info.parameters <= PARAMETERS && c->info.points <= POINTS && c->info.history <= HISTORY &&
            c->info.workspace <= (int64_t)(sizeof c->workspace / sizeof *c->workspace),
        c, "described");
  check(rail_element_history_init(c->element, c->history) == CTE_SUCCESS, c, "history");
  *a = (cte_arguments)CTE_ARGUMENTS_INIT;
  a->nslave = nslave;
  a->nnode = nslave;
  a->parameter_count = c->info.parameters;
  a->x = c->x;
  a->u = c->u;
  a->parameters = c->parameters;
  a->history_accepted = c->history;
  a->slave_row = nslave > 0 ? c->row : NULL;
  a->f = c->f;
  a->k = c->k;
  a->output = c->output;
  a->energy = &c->energy;
  a->workspace = c->workspace;
  a->workspace_size = c->info.workspace;
  return c;
}

/* Nodes of a facet from `first` on: corners, and with `middles` the middles of the sides, bulged by `bulge`. */
static void facet(contact *c, int first, int middles, double half, double z, double bulge)
{
  static const double xi[8][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int a = 0; a < (middles ? 8 : 4); a++) {
    double *x = &c->x[3 * (first + a)];
    x[0] = half * xi[a][0];
    x[1] = half * xi[a][1];
    x[2] = z + (a < 4 ? 0.0 : bulge);
  }
}

/* Displacements that leave nothing symmetric. */
static void shake(contact *c, double size)
{
  for (int i = 0; i < c->info.unknowns; i++)
    c->u[i] = size * sin(1.0 + 2.7 * i);
}

static void softened(contact *c)
{
  set(c, "p", 3.0);
  set(c, "c", 0.1);
}

static void declare(void)
{
  contact *c = open(RAIL_POINT_QUAD8, "PointQuad8", rail_point_quad8, 0);
  softened(c);
  set(c, "orientation", 1.0);
  c->x[0] = 0.2;
  c->x[1] = -0.3;
  facet(c, 1, 1, 1.0, 0.0, 0.05);
  shake(c, 0.02);

  c = open(RAIL_POINT_WHEEL_TREAD, "PointWheelTread", rail_point_wheel_tread, 0);
  set(c, "eps_n", 50.0);
  set(c, "radius", 0.45);
  set(c, "conicity", 0.05);
  set(c, "hollow", 0.3);
  set(c, "origin_z", 0.44);
  set(c, "quaternion_w", cos(1.5)); /* turned by 3 rad: the tread near angle 0 lies below */
  set(c, "quaternion_y", sin(1.5));
  shake(c, 0.01);

  c = open(RAIL_QUAD8_RAIL_HEAD, "Quad8RailHead", rail_quad8_rail_head, 0);
  softened(c);
  set(c, "crown", 0.3);
  set(c, "origin_y", 0.02);
  facet(c, 0, 1, 0.1, -0.01, 0.005);
  shake(c, 0.004);

  c = open(RAIL_QUAD4_QUAD8, "Quad4Quad8", rail_quad4_quad8, 0);
  set(c, "eps_n", 50.0);
  set(c, "orientation", 1.0);
  facet(c, 0, 0, 0.6, -0.05, 0.0);
  facet(c, 4, 1, 1.0, 0.0, 0.02);
  shake(c, 0.01);

  c = open(RAIL_INTERPOLATED_TORUS, "InterpolatedTorus", rail_interpolated_torus, 3);
  softened(c);
  set(c, "major", 1.0);
  set(c, "minor", 0.3);
  for (int a = 0; a < 3; a++) {
    c->x[3 * a] = 0.9 + 0.1 * a;
    c->x[3 * a + 1] = 0.2 - 0.1 * a;
    c->x[3 * a + 2] = 0.27;
    c->row[a] = 1.0 / 3.0;
  }
  c->row[3] = 0.7; /* weight */
  shake(c, 0.01);

  c = open(RAIL_POINT_QUAD8_WORN, "PointQuad8Worn", rail_point_quad8_worn, 0);
  softened(c);
  set(c, "k", 40.0);
  set(c, "m", 0.4);
  set(c, "q", 5.0);
  set(c, "d", 0.1);
  set(c, "orientation", 1.0);
  c->x[0] = 0.2;
  c->x[1] = -0.3;
  facet(c, 1, 1, 1.0, 0.0, 0.05);
  shake(c, 0.02);

  c = open(RAIL_CONTACT_WIRES, "ContactWires", rail_contact_wires, 0);
  set(c, "eps_n", 50.0);
  set(c, "eps_t", 40.0);
  set(c, "mu", 0.2);
  set(c, "r", 2.0);
  set(c, "lever", 0.1);
  set(c, "turn", 0.4);
  set(c, "r0", 0.3);
  set(c, "slave_director_z", 1.0);
  set(c, "master_director_x", 0.6);
  set(c, "master_director_z", 0.8);
  c->x[0] = -1.0;
  c->x[3] = 1.0;
  c->x[2] = c->x[5] = 0.27;
  c->x[7] = -1.0;
  c->x[10] = 1.0;
  shake(c, 0.01);
}

static int has_friction(const contact *c)
{
  return c->info.history > c->info.points * (1 + c->info.projected);
}

static int32_t evaluate(contact *c, uint32_t request)
{
  c->a.request = request;
  return c->evaluate(&c->a);
}

/* Largest difference between K and the central differences of f, relative to the largest entry of K. */
static double tangent_error(contact *c)
{
  static double k[UNKNOWNS * UNKNOWNS];
  const double h = 1e-6;
  const int n = c->info.unknowns;
  double difference = 0.0, largest = 0.0, minus[UNKNOWNS];
  memcpy(k, c->k, sizeof k);
  for (int j = 0; j < n; j++) {
    const double u = c->u[j];
    c->u[j] = u - h;
    failures += evaluate(c, CTE_RESIDUAL) != CTE_SUCCESS;
    memcpy(minus, c->f, sizeof minus);
    c->u[j] = u + h;
    failures += evaluate(c, CTE_RESIDUAL) != CTE_SUCCESS;
    c->u[j] = u;
    for (int i = 0; i < n; i++) {
      difference = fmax(difference, fabs((c->f[i] - minus[i]) / (2.0 * h) - k[i * n + j]));
      largest = fmax(largest, fabs(k[i * n + j]));
    }
  }
  return largest > 0.0 ? difference / largest : HUGE_VAL;
}

/* Contact with friction begins, is accepted, and slides. */
static void slide(contact *c)
{
  c->a.history_trial = c->history;
  check(evaluate(c, CTE_HISTORY) == CTE_SUCCESS && c->a.status == CTE_STATUS_STICK, c, "begins");
  c->u[0] += 0.3;
}

/* Its history, taken to the same element at the same place, is the same history. */
static void carry(contact *c)
{
  double old[HISTORY], new[HISTORY], output[CTE_OUTPUT_SIZE];
  const int n = c->info.history;
  c->a.history_trial = old;
  memcpy(output, c->output, sizeof output);
  int pass = evaluate(c, CTE_HISTORY) == CTE_SUCCESS;
  memcpy(new, old, sizeof new);
  new[1 + c->info.projected] += 0.1;
  new[n - 1] = 0.0;
  pass = pass && rail_history_transfer(c->element, output, old, c->element, output, new, NULL) == CTE_SUCCESS;
  for (int i = 0; i < n; i++)
    pass = pass && fabs(new[i] - old[i]) < 1e-14;
  check(pass, c, "history carried");
}

/* The slave nodes feel the sum of N n dA over the contact points (and friction); with the master nodes, nothing is
 * left. */
static int balanced(const contact *c)
{
  const int slaves = c->a.nslave > 0 ? c->a.nslave : c->info.slave_nodes;
  const int nodes = c->info.unknowns / 3;
  int pass = 1;
  for (int i = 0; i < 3; i++) {
    double expected = 0.0, slave = 0.0, all = 0.0, largest = 0.0;
    for (int p = 0; p < c->info.points; p++) {
      const double *output = &c->output[p * CTE_OUTPUT_SIZE];
      expected += output[CTE_OUTPUT_NORMAL_TRACTION] * output[CTE_OUTPUT_WEIGHT] * output[CTE_OUTPUT_NORMAL + i];
    }
    for (int a = 0; a < nodes; a++) {
      all += c->f[3 * a + i];
      slave += a < slaves ? c->f[3 * a + i] : 0.0;
    }
    for (int j = 0; j < c->info.unknowns; j++)
      largest = fmax(largest, fabs(c->f[j]));
    pass = pass && (has_friction(c) || fabs(slave - expected) <= 1e-12 * largest);
    pass = pass && fabs(nodes > slaves ? all : 0.0) <= 1e-12 * largest;
  }
  return pass;
}

static void examine(contact *c)
{
  int32_t index = -1;
  char text[256];
  check(rail_element_check_parameters(c->element, c->parameters, c->info.parameters, &index) == CTE_SUCCESS, c,
        "parameters");
  if (has_friction(c))
    slide(c);
  const int32_t code = evaluate(c, CTE_RESIDUAL | CTE_TANGENT | CTE_OUTPUT | CTE_ENERGY);
  rail_element_message(c->element, &c->a, code, text, sizeof text);
  check(code == CTE_SUCCESS, c, code == CTE_SUCCESS ? "evaluated" : text);
  check(c->a.status == (has_friction(c) ? CTE_STATUS_SLIP : CTE_STATUS_CLOSED) && c->a.closed_points == c->info.points,
        c, rail_status_message(c->a.status));
  check(c->energy > 0.0, c, "energy");
  check(balanced(c), c, "balance of force");
  if (has_friction(c))
    carry(c);
  const double error = tangent_error(c);
  check(error <= 1e-6, c, "K = df/du");
  printf("     %d points closed, tangent error %.1e\n", (int)c->a.closed_points, error);
}

int main(void)
{
  declare();
  for (int i = 0; i < count; i++)
    examine(&contacts[i]);
  failures += rail_element_count() != count || rail_abi_version() != CTE_ABI_VERSION_COMPILED;
  printf("%s\n", failures == 0 ? "all passed" : "some failed");
  return failures != 0;
}
