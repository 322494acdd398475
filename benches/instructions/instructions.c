/* One evaluation of an element in its second step of contact: what callgrind counts (see run.sh).
 *
 *   instructions ELEMENT residual|tangent
 *
 * The first step begins contact, without friction and from the centre. The second moves the slave, so that points
 * project again and friction slides; its call is the one that is counted.
 */
#include <contact_elements.h>
#include <stdio.h>
#include <string.h>

#define NODES 12
#define POINTS 9
#define HISTORY 16
#define UNKNOWNS (3 * NODES)

struct state {
  const char *element;
  int32_t nodes, slaves; /* slaves: nodes that the step moves */
  int32_t interpolated;  /* slave nodes of an interpolated slave, else 0 */
  double x[UNKNOWNS];
  double parameters[20];
};

#define FACET -1, -1, 0, 1, -1, 0, 1, 1, 0.1, -1, 1, 0
/* origin and quaternion of a placed surface, a little turned */
#define PLACED 0.1, 0.2, -0.3, 1, 0.1, 0.2, -0.05
/* positions and tangents of two beams that cross at a right angle, 0.05 too close */
#define SLAVE_BEAM -1, 0, 0.15, 2, 0.1, 0.1, 1, 0.1, 0.15, 2, 0.1, -0.1
#define MASTER_BEAM 0, -1, 0, 0.1, 2, 0.1, 0.1, 1, 0, -0.1, 2, -0.1

static const struct state STATES[] = {
    {"PointQuad4", 5, 1, 0, {0.2, -0.1, -0.05, FACET}, {1000, 0, 1}},
    {"PointQuad4Coulomb", 5, 1, 0, {0.2, -0.1, -0.05, FACET}, {1000, 800, 0.3, 0, 1}},
    {"Quad4Quad4",
     8,
     4,
     0,
     {-0.5, -0.6, -0.05, 0.6, -0.5, -0.04, 0.7, 0.5, -0.06, -0.6, 0.6, -0.05, FACET},
     {1000, 0, 1}},
    {"HermiteHermiteBeams", 8, 4, 0, {SLAVE_BEAM, MASTER_BEAM}, {1000, 0.2}},
    {"PointTorus", 1, 1, 0, {2.38, 0.5, -0.8}, {1000, 0, 1, 2, 0.5, PLACED}},
    {"PointTorusDistance", 1, 1, 0, {2.38, 0.5, -0.8}, {1000, 0, 1, 2, 0.5, PLACED}},
    {"InterpolatedQuad4",
     8,
     4,
     4,
     {-0.5, -0.6, -0.05, 0.6, -0.5, -0.04, 0.7, 0.5, -0.06, -0.6, 0.6, -0.05, FACET},
     {1000, 0, 1}},
    {"PointQuad4Multiplier", 6, 1, 0, {0.2, -0.1, -0.05, FACET}, {1000, 0, 1}},
    {"HermiteHermiteBeamsRolling", 8, 4, 0, {SLAVE_BEAM, MASTER_BEAM}, {1000, 800, 0.3, 10, 0.1, 0.2}},
    {"HermiteHermiteBeamsLargeAngle", 8, 4, 0, {SLAVE_BEAM, MASTER_BEAM}, {1000, 0.2, 1.2, 1.55}},
};

static int32_t result;

/* A call, so that callgrind can tell where to count. */
__attribute__((noinline)) void counted(const cte_element *element, cte_arguments *arguments) {
  result = cte_element_evaluate(element, arguments);
}

static int fail(const char *what, const char *element, const cte_arguments *arguments) {
  fprintf(stderr, "%s: %s, argument %s, entry %d, %s\n", element, what, cte_argument_name(arguments->error_argument),
          (int)arguments->error_index, cte_status_message(arguments->status));
  return 1;
}

static int evaluate(const struct state *state, uint32_t request) {
  int32_t index;
  if (cte_element_find(state->element, (int32_t)strlen(state->element), &index) != CTE_SUCCESS) {
    fprintf(stderr, "%s: no such element\n", state->element);
    return 1;
  }
  const cte_element *element = cte_element_get(index);
  static double f[UNKNOWNS], k[UNKNOWNS * UNKNOWNS], workspace[4096], u[UNKNOWNS];
  static double accepted[POINTS * HISTORY], trial[POINTS * HISTORY];
  const double slave_row[] = {0.3, 0.2, 0.3, 0.2, 1};
  cte_arguments a = CTE_ARGUMENTS_INIT;
  a.request = CTE_RESIDUAL | CTE_HISTORY;
  a.nslave = state->interpolated;
  a.nnode = state->nodes;
  a.x = state->x;
  a.u = u;
  a.parameters = state->parameters;
  a.parameter_count = 20;
  a.slave_row = slave_row;
  a.f = f;
  a.k = k;
  a.workspace = workspace;
  a.workspace_size = 4096;
  cte_element_history_init(element, accepted);
  a.history_accepted = accepted;
  a.history_trial = trial;
  if (strstr(state->element, "Multiplier")) u[3 * (state->nodes - 1)] = -30;
  if (cte_element_evaluate(element, &a) != CTE_SUCCESS) return fail("first step", state->element, &a);
  if (a.closed_points == 0) return fail("no contact in the first step", state->element, &a);
  memcpy(accepted, trial, sizeof accepted);
  for (int node = 0; node < state->slaves; node++) {
    u[3 * node] = 0.03;
    u[3 * node + 1] = 0.02;
    u[3 * node + 2] = -0.01;
  }
  a.request = request | CTE_HISTORY;
  counted(element, &a);
  if (result != CTE_SUCCESS) return fail("second step", state->element, &a);
  if (a.closed_points == 0) return fail("no contact in the second step", state->element, &a);
  printf("%s: %d points closed, %s\n", state->element, (int)a.closed_points, cte_status_message(a.status));
  return 0;
}

int main(int count, char **arguments) {
  if (count == 1) {
    for (size_t i = 0; i < sizeof STATES / sizeof *STATES; i++) printf("%s\n", STATES[i].element);
    return 0;
  }
  for (size_t i = 0; count == 3 && i < sizeof STATES / sizeof *STATES; i++) {
    if (strcmp(STATES[i].element, arguments[1]) == 0) {
      uint32_t tangent = strcmp(arguments[2], "tangent") == 0 ? CTE_TANGENT : 0;
      return evaluate(&STATES[i], CTE_RESIDUAL | tangent);
    }
  }
  fprintf(stderr, "usage: %s [ELEMENT residual|tangent]\n", arguments[0]);
  return 2;
}
