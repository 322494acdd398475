/* interface_patch.c - cte_patch_evaluate: slave points over the corner of a box, three unit squares.
 *
 * The body surrounds the corner: the floor z = 0 and the walls x = 0 and y = 0 have their normals towards +z, +x and +y,
 * the free space is x, y, z > 0. A point inside the body beyond an edge or the vertex is as deep as it is far from it.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

enum { POINTS = 4, MASTERS = 7, UNKNOWNS = 3 * (POINTS + MASTERS), HISTORY = 5 };

/* Floor, wall x = 0, wall y = 0; master node 0 is the corner. */
static const int32_t facets[12] = {0, 1, 4, 2, 0, 2, 6, 3, 0, 3, 5, 1};
static const double masters[3 * MASTERS] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0,
                                            1.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0};
/* Through the floor, beyond the edge along x, beyond the vertex, and free. */
static const double points[3 * POINTS] = {0.5, 0.5, -0.1, 0.5, -0.03, -0.04, -0.02, -0.01, -0.02, 0.4, 0.4, 0.4};
static const double depth[POINTS] = {0.1, 0.05, 0.03, -0.4};

static double x[UNKNOWNS], parameters[3], f[UNKNOWNS], k[UNKNOWNS * UNKNOWNS], output[POINTS * CTE_OUTPUT_SIZE];
static double history[POINTS * HISTORY], energy, workspace[64];
static cte_patch patch;
static cte_arguments a;

static const cte_element *named(const char *name)
{
  int32_t index = -1;
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS)
    client_check(0, name);
  return cte_element_get(index);
}

static void lay_out(void)
{
  patch = (cte_patch)CTE_PATCH_INIT;
  patch.slave_points = POINTS;
  patch.master_nodes = MASTERS;
  patch.facets = 3;
  patch.facet = named("PointQuad4");
  patch.edge = named("PointLine2Oriented");
  patch.vertex = named("PointPointOriented");
  patch.connectivity = facets;
  memcpy(x, points, sizeof points);
  memcpy(&x[3 * POINTS], masters, sizeof masters);
  parameters[0] = 1000.0; /* eps_n */
  parameters[1] = 0.0;    /* r0 */
  parameters[2] = 1.0;    /* orientation */
  a = (cte_arguments)CTE_ARGUMENTS_INIT;
  a.request = CTE_RESIDUAL | CTE_TANGENT | CTE_OUTPUT | CTE_HISTORY | CTE_ENERGY;
  a.x = x;
  a.parameters = parameters;
  a.parameter_count = 3;
  a.f = f;
  a.k = k;
  a.output = output;
  a.history_trial = history;
  a.energy = &energy;
  a.workspace = workspace;
  a.workspace_size = 64;
}

static void sizes(void)
{
  cte_info info;
  int32_t argument = -1;
  info = (cte_info)CTE_INFO_INIT;
  const int pass = cte_patch_info(&patch, &info, &argument) == CTE_SUCCESS && argument == CTE_ARGUMENT_NONE;
  client_check(pass && info.dimension == 3 && info.unknowns == UNKNOWNS && info.points == POINTS &&
                   info.parameters == 3 && info.history == POINTS * HISTORY && info.workspace <= 64 &&
                   info.symmetric == 1 && info.nodes_minimum == POINTS + MASTERS,
               "patch: sizes");
}

/* Depth, force and place of every point; what is in balance. */
static void forces(void)
{
  static const double facet[POINTS] = {1.0, 1.0, 1.0, 1.0}, feature[POINTS] = {0.0, 1.0, 5.0, 0.0};
  int pass = cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  client_check(pass && a.status == CTE_STATUS_CLOSED && a.closed_points == 3, "patch: three points are closed");
  double stored = 0.0;
  for (int i = 0; i < POINTS; i++) {
    const double *row = &output[i * CTE_OUTPUT_SIZE], *own = &history[i * HISTORY];
    client_check(fabs(row[CTE_OUTPUT_GAP] + depth[i]) < 1e-14, client_text("patch: gap of point", i));
    if (depth[i] > 0.0) {
      const double size = sqrt(f[3 * i] * f[3 * i] + f[3 * i + 1] * f[3 * i + 1] + f[3 * i + 2] * f[3 * i + 2]);
      client_check(fabs(size - 1000.0 * depth[i]) < 1e-11, client_text("patch: force of point", i));
      client_check(fabs(own[1] - facet[i]) <= 0.0 && fabs(own[2] - feature[i]) <= 0.0,
                   client_text("patch: place of point", i));
      stored += 500.0 * depth[i] * depth[i];
    } else {
      client_check(fabs(f[3 * i]) <= 0.0 && fabs(own[0]) <= 0.0, client_text("patch: no force of point", i));
    }
  }
  client_check(fabs(energy - stored) < 1e-12, "patch: energy");
  pass = 1;
  for (int c = 0; c < 3; c++) {
    double sum = 0.0;
    for (int i = c; i < UNKNOWNS; i += 3)
      sum += f[i];
    pass &= fabs(sum) < 1e-11;
  }
  client_check(pass, "patch: balance");
  pass = 1;
  for (int i = 0; i < UNKNOWNS; i++)
    for (int j = 0; j < i; j++)
      pass &= fabs(k[i * UNKNOWNS + j] - k[j * UNKNOWNS + i]) < 1e-10;
  client_check(pass, "patch: symmetric");
}

/* Residual alone gives the same bits; map, scale and column-major storage put them elsewhere. */
static void layouts(void)
{
  static double apart[2 * UNKNOWNS], wide[4 * UNKNOWNS * UNKNOWNS], single[UNKNOWNS], all[UNKNOWNS];
  static int32_t map[UNKNOWNS];
  lay_out();
  int pass = cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  memcpy(all, f, sizeof all);
  a.request = CTE_RESIDUAL;
  a.f = single;
  pass = pass && cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  client_check(pass && client_same(single, all, UNKNOWNS), "patch: residual alone");
  lay_out();
  for (int i = 0; i < UNKNOWNS; i++)
    map[i] = 2 * i + 1;
  a.unknown_map = map;
  a.f = apart;
  a.k = wide;
  a.k_row_stride = 1;
  a.k_col_stride = 2 * UNKNOWNS;
  a.f_scale = -1.0;
  a.k_scale = 2.0;
  pass = cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  for (int i = 0; i < UNKNOWNS && pass; i++) {
    pass = fabs(apart[map[i]] + f[i]) <= 0.0 && fabs(apart[2 * i]) <= 0.0;
    for (int j = 0; j < UNKNOWNS && pass; j++)
      pass = fabs(wide[map[i] + 2 * UNKNOWNS * map[j]] - 2.0 * k[i * UNKNOWNS + j]) <= 0.0;
  }
  client_check(pass, "patch: map, strides and scales");
}

/* Without lower pairs the points beyond are outside; beyond the reach there is nothing. */
static void without(void)
{
  lay_out();
  patch.edge = NULL;
  patch.vertex = NULL;
  client_check(cte_patch_evaluate(&patch, &a) == CTE_SUCCESS && a.closed_points == 1 &&
                   fabs(output[CTE_OUTPUT_SIZE] - CTE_STATUS_OUTSIDE) <= 0.0,
               "patch: facets alone");
  lay_out();
  patch.reach = 0.04;
  client_check(cte_patch_evaluate(&patch, &a) == CTE_SUCCESS && a.closed_points == 1 &&
                   fabs(output[0] - CTE_STATUS_OUTSIDE) <= 0.0,
               "patch: beyond the reach");
}

/* The same arrays as history, and a state that stays closed. */
static void histories(void)
{
  static double first[UNKNOWNS];
  lay_out();
  memset(history, 0, sizeof history);
  a.history_accepted = history;
  int pass = cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  memcpy(first, f, sizeof first);
  pass = pass && cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  client_check(pass && client_same(first, f, UNKNOWNS), "patch: history in place");
  x[2] = 0.1; /* above the floor now */
  a.request = CTE_RESIDUAL | CTE_FREEZE_STATE;
  pass = cte_patch_evaluate(&patch, &a) == CTE_SUCCESS;
  client_check(pass && a.closed_points == 3 && fabs(f[2] - 100.0) < 1e-11, "patch: frozen");
}

void interface_patch(void)
{
  lay_out();
  sizes();
  forces();
  layouts();
  without();
  histories();
}
