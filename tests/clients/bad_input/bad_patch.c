/* bad_patch.c - bad input to cte_patch_info and cte_patch_evaluate; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <stdio.h>
#include <string.h>

enum { POINTS = 2, UNKNOWNS = 3 * (POINTS + 4), UNTOUCHED = -77 };

static int32_t facet[4];
static double x[UNKNOWNS], u[UNKNOWNS], parameters[3], history_accepted[5 * POINTS], workspace[6 * POINTS];
static double f[UNKNOWNS], k[UNKNOWNS * UNKNOWNS], output[POINTS * CTE_OUTPUT_SIZE], history_trial[5 * POINTS], energy[1];
static cte_patch patch;
static cte_arguments a;

static const cte_element *named(const char *name)
{
  int32_t index = -1;
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS)
    client_check(0, name);
  return cte_element_get(index);
}

/* Two points below a unit square. */
static void lay_out(void)
{
  static const double plain[UNKNOWNS] = {0.25, 0.25, -0.1, 1.5, 0.5, -0.1, 0.0, 0.0, 0.0,
                                         1.0,  0.0,  0.0,  1.0, 1.0, 0.0,  0.0, 1.0, 0.0};
  patch = (cte_patch)CTE_PATCH_INIT;
  patch.slave_points = POINTS;
  patch.master_nodes = 4;
  patch.facets = 1;
  patch.facet = named("PointQuad4");
  patch.edge = named("PointLine2Oriented");
  patch.vertex = named("PointPointOriented");
  patch.connectivity = facet;
  for (int32_t i = 0; i < 4; i++)
    facet[i] = i;
  memcpy(x, plain, sizeof plain);
  memset(u, 0, sizeof u);
  memset(history_accepted, 0, sizeof history_accepted);
  parameters[0] = 1000.0;
  parameters[1] = 0.0;
  parameters[2] = 1.0;
  a = (cte_arguments)CTE_ARGUMENTS_INIT;
  a.request = CTE_RESIDUAL | CTE_TANGENT | CTE_OUTPUT | CTE_HISTORY | CTE_ENERGY;
  a.x = x;
  a.u = u;
  a.parameters = parameters;
  a.parameter_count = 3;
  a.history_accepted = history_accepted;
  a.f = f;
  a.k = k;
  a.output = output;
  a.history_trial = history_trial;
  a.energy = energy;
  a.workspace = workspace;
  a.workspace_size = 6 * POINTS;
}

static int blank(const void *memory, size_t size)
{
  const unsigned char *byte = memory;
  for (size_t i = 0; i < size; i++)
    if (byte[i] != 0x5a)
      return 0;
  return 1;
}

static void expect(const char *what, int32_t code, int32_t argument, int32_t index)
{
  memset(f, 0x5a, sizeof f);
  memset(k, 0x5a, sizeof k);
  memset(output, 0x5a, sizeof output);
  memset(history_trial, 0x5a, sizeof history_trial);
  memset(energy, 0x5a, sizeof energy);
  a.error_argument = UNTOUCHED;
  a.error_index = UNTOUCHED;
  const int32_t given = cte_patch_evaluate(&patch, &a);
  const int pass = given == code && a.error_argument == argument && a.error_index == index && blank(f, sizeof f) &&
                   blank(k, sizeof k) && blank(output, sizeof output) && blank(history_trial, sizeof history_trial) &&
                   blank(energy, sizeof energy);
  if (!pass)
    printf("     code %d wanted %d, argument %d wanted %d, index %d wanted %d\n", (int)given, (int)code,
           (int)a.error_argument, (int)argument, (int)a.error_index, (int)index);
  client_check(pass, what);
  lay_out();
}

static void null_pointers(void)
{
  client_check(cte_patch_evaluate(&patch, NULL) == CTE_ERROR_NULL, "patch: arguments null");
  client_check(cte_patch_evaluate(NULL, &a) == CTE_ERROR_NULL && a.error_argument == CTE_ARGUMENT_PATCH,
               "patch: null");
  patch.facet = NULL;
  expect("patch: facet null", CTE_ERROR_NULL, CTE_ARGUMENT_FACET, 0);
  patch.connectivity = NULL;
  expect("patch: connectivity null", CTE_ERROR_NULL, CTE_ARGUMENT_CONNECTIVITY, 0);
  a.x = NULL;
  expect("patch: x null", CTE_ERROR_NULL, CTE_ARGUMENT_X, 0);
  a.parameters = NULL;
  expect("patch: parameters null", CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS, 0);
  a.workspace = NULL;
  expect("patch: workspace null", CTE_ERROR_NULL, CTE_ARGUMENT_WORKSPACE, 0);
  a.f = NULL;
  expect("patch: f null", CTE_ERROR_NULL, CTE_ARGUMENT_F, 0);
  a.history_accepted = NULL;
  a.request |= CTE_FREEZE_STATE;
  expect("patch: frozen without history", CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_ACCEPTED, 0);
}

static void counts(void)
{
  patch.struct_size = 8;
  expect("patch: struct_size", CTE_ERROR_STRUCT_SIZE, CTE_ARGUMENT_PATCH, 0);
  patch.struct_size = 120;
  expect("patch: struct_size of interface 0.1", CTE_ERROR_STRUCT_SIZE, CTE_ARGUMENT_PATCH, 0);
  patch.slave_points = 0;
  expect("patch: no slave points", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE, 0);
  patch.master_nodes = -1;
  expect("patch: no master nodes", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  patch.facets = 0;
  expect("patch: no facets", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_FACETS, 0);
  patch.slave_points = 2147483647;
  expect("patch: too many unknowns", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  a.nnode = 5;
  expect("patch: nnode", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  facet[2] = 4;
  expect("patch: no such node", CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 2);
  facet[3] = -1;
  expect("patch: negative node", CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 3);
  a.workspace_size = 6 * POINTS - 1;
  expect("patch: small workspace", CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE, 0);
  a.request |= CTE_PROJECTION_GIVEN;
  expect("patch: no projection can be given", CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST, 7);
  a.k_row_stride = -1;
  expect("patch: stride", CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0);
}

static void elements(void)
{
  patch.facet = named("PointQuad4Coulomb");
  expect("patch: friction", CTE_ERROR_ELEMENT, CTE_ARGUMENT_FACET, 0);
  patch.facet = named("Quad4Quad4");
  expect("patch: no point as slave", CTE_ERROR_ELEMENT, CTE_ARGUMENT_FACET, 0);
  patch.edge = named("PointLine2");
  expect("patch: an edge without sides", CTE_ERROR_ELEMENT, CTE_ARGUMENT_EDGE, 0);
  patch.edge = named("PointLine3Oriented");
  expect("patch: the edge of another facet", CTE_ERROR_ELEMENT, CTE_ARGUMENT_EDGE, 0);
  patch.vertex = named("PointPoint");
  expect("patch: a vertex without sides", CTE_ERROR_ELEMENT, CTE_ARGUMENT_VERTEX, 0);
  patch.vertex = named("PointPointOriented2d");
  expect("patch: a vertex of the plane", CTE_ERROR_ELEMENT, CTE_ARGUMENT_VERTEX, 0);
}

static void numbers(void)
{
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    client_special(special, &x[4]);
    expect(client_text("patch: no number in x", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_X, 1);
    client_special(special, &u[17]);
    expect(client_text("patch: no number in u", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_U, 5);
    client_special(special, &parameters[1]);
    expect(client_text("patch: no number in parameters", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_PARAMETERS, 1);
    client_special(special, &history_accepted[7]);
    expect(client_text("patch: no number in history_accepted", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_HISTORY_ACCEPTED, 7);
  }
  parameters[0] = 0.0;
  expect("patch: eps_n", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 0);
  a.parameter_count = 2;
  expect("patch: too few parameters", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 2);
  history_accepted[5] = 17.0;
  expect("patch: no status", CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 5);
  history_accepted[6] = 2.0;
  expect("patch: no such facet", CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 6);
  patch.reach = -1.0;
  expect("patch: negative reach", CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_REACH, 0);
}

static void info(void)
{
  cte_info sizes;
  int32_t argument = UNTOUCHED;
  memset(&sizes, 0x5a, sizeof sizes);
  sizes.struct_size = sizeof sizes;
  client_check(cte_patch_info(&patch, NULL, &argument) == CTE_ERROR_NULL && argument == CTE_ARGUMENT_INFO,
               "patch: info null");
  sizes.struct_size = 8;
  client_check(cte_patch_info(&patch, &sizes, &argument) == CTE_ERROR_STRUCT_SIZE && argument == CTE_ARGUMENT_INFO,
               "patch: info's struct_size");
  sizes.struct_size = 152;
  client_check(cte_patch_info(&patch, &sizes, &argument) == CTE_ERROR_STRUCT_SIZE && argument == CTE_ARGUMENT_INFO,
               "patch: info's struct_size of interface 0.1");
  patch.facets = 0;
  sizes.struct_size = sizeof sizes;
  client_check(cte_patch_info(&patch, &sizes, &argument) == CTE_ERROR_NODE_COUNT && argument == CTE_ARGUMENT_FACETS &&
                   cte_patch_info(NULL, &sizes, NULL) == CTE_ERROR_NULL,
               "patch: info of no patch");
}

/* All nodes in one place: a facet without an area has no normal. */
static void degenerate(void)
{
  for (int i = 6; i < UNKNOWNS; i++)
    x[i] = 0.0;
  const int32_t code = cte_patch_evaluate(&patch, &a);
  int pass = code == CTE_SUCCESS || code == CTE_CUT_BACK;
  for (int i = 0; i < UNKNOWNS && pass && code == CTE_SUCCESS; i++)
    pass = f[i] - f[i] <= 0.0;
  client_check(pass, "patch: a facet without an area");
  lay_out();
}

void bad_patch(void)
{
  lay_out();
  null_pointers();
  counts();
  elements();
  numbers();
  degenerate();
  info();
}
