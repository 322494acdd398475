/* interface_project.c - cte_element_project: the closest point of the whole domain, found without a start.
 *
 * Mostly over the unit square, whose parameters are 2 x - 1 and 2 y - 1: closest points are written down by hand. The
 * trough z = x^2 over [-1,1]^2 has two feet for a point above its middle.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <math.h>
#include <string.h>

static const double square[12] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0};

static bench b;
static cte_projection found[4];

static int opened(const char *name, int32_t nslave)
{
  int32_t index = -1;
  if (cte_element_find(name, (int32_t)strlen(name), &index) != CTE_SUCCESS || !bench_index(&b, index, nslave))
    return client_check(0, name);
  return 1;
}

/* A point over the unit square, its displacement zero. */
static void point(const char *name, double x, double y, double z)
{
  opened(name, 0);
  b.x[0] = x;
  b.x[1] = y;
  b.x[2] = z;
  memcpy(&b.x[3], square, sizeof square);
}

/* Results filled with a pattern, then the projection. */
static int projected(double reach, double *history)
{
  memset(found, 0x5a, sizeof found);
  return cte_element_project(b.element, &b.a, reach, found, history) == CTE_SUCCESS &&
         b.a.error_argument == CTE_ARGUMENT_NONE && b.a.error_index == 0;
}

static int is(const cte_projection *p, int32_t verdict, int32_t feature, double zeta_1, double zeta_2, double distance)
{
  return p->verdict == verdict && p->feature == feature && fabs(p->zeta[0] - zeta_1) < 1e-12 &&
         fabs(p->zeta[1] - zeta_2) < 1e-12 && fabs(p->distance - distance) < 1e-12;
}

static int same(const cte_projection *a, const cte_projection *other)
{
  return memcmp(a, other, sizeof *a) == 0;
}

/* Beyond a feature the foot is on it; the way there is 0.3, 0.4 or 1.2 along the axes. */
static void on_a_square(void)
{
  static const double edge[4][4] = {
      {0.25, -0.3, -0.5, -1.0}, {1.3, 0.75, 1.0, 0.5}, {0.75, 1.3, 0.5, 1.0}, {-0.3, 0.25, -1.0, -0.5}};
  static const double vertex[4][4] = {
      {-0.3, -0.4, -1.0, -1.0}, {1.3, -0.4, 1.0, -1.0}, {1.3, 1.4, 1.0, 1.0}, {-0.3, 1.4, -1.0, 1.0}};
  point("PointQuad4", 0.25, 0.75, 0.5);
  client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, 0.5, 0.5), "project: inside");
  client_check(fabs(found[0].definiteness - 1.0) < 1e-12 && found[0].boxes > 0 && found[0].steps >= 0,
               "project: definiteness 1 on a plane");
  point("PointQuad4", 0.25, 0.75, -0.5);
  client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, 0.5, 0.5), "project: from below");
  for (int i = 0; i < 4; i++) {
    point("PointQuad4", edge[i][0], edge[i][1], 0.4);
    client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_BOUNDARY, 1 + i, edge[i][2], edge[i][3], 0.5),
                 client_text("project: beyond edge", i));
  }
  for (int i = 0; i < 4; i++) {
    point("PointQuad4", vertex[i][0], vertex[i][1], 1.2);
    client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_BOUNDARY, 5 + i, vertex[i][2], vertex[i][3], 1.3),
                 client_text("project: beyond vertex", i));
  }
}

/* Nothing farther is looked for; a closed projection is found all the same. */
static void reaches(void)
{
  point("PointQuad4", 0.25, 0.75, 0.5);
  int pass = projected(0.0, NULL);
  const cte_projection without = found[0];
  pass = pass && projected(0.6, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, 0.5, 0.5);
  client_check(pass && client_same(found[0].zeta, without.zeta, 2), "project: within the reach");
  client_check(projected(0.4, NULL) && is(&found[0], CTE_VERDICT_BEYOND, 0, 0.0, 0.0, 0.0) &&
                   fabs(found[0].definiteness) <= 0.0,
               "project: beyond the reach");
  bench_open(&b, "PointCylinder");
  b.x[0] = 2.0; /* 1 from the wall of radius 1 */
  client_check(projected(0.0, NULL) && found[0].verdict == CTE_VERDICT_INSIDE &&
                   fabs(found[0].distance - 1.0) < 1e-12 && found[0].boxes == 0,
               "project: a closed projection needs no boxes");
  client_check(projected(0.5, NULL) && found[0].verdict == CTE_VERDICT_BEYOND && fabs(found[0].distance - 1.0) < 1e-12,
               "project: a closed projection beyond the reach");
}

/* Where nothing is projected: x is 0.1 within the wall, 0.9 from the axis; the points are 0.1 apart. */
static void nothing_projected(void)
{
  bench_open(&b, "PointPoint");
  client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, 0.0, 0.0, 0.0),
               "project: a point has nothing to project");
  bench_open(&b, "PointCylinderDistance");
  client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, 0.0, 0.0, 0.0),
               "project: a distance function has nothing to project");
  client_check(projected(0.5, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, 0.0, 0.0, 0.0),
               "project: a distance function within the reach");
}

/* The history is the initial one at the foot, from which an evaluation has little to do. */
static void histories(void)
{
  double initial[6];
  bench_open(&b, "PointQuad4Coulomb");
  cte_element_history_init(b.element, initial);
  bench_canary(&b);
  int pass = projected(0.0, b.history_accepted);
  memcpy(&initial[1], found[0].zeta, 2 * sizeof initial[0]);
  memcpy(&initial[3], found[0].zeta, 2 * sizeof initial[0]);
  client_check(pass && client_same(b.history_accepted, initial, 6), "project: projection and anchor of the history");
  client_check(bench_untouched(&b), "project: nothing else is written");
  pass = bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_STICK &&
         client_near(&b.out.output[CTE_OUTPUT_PROJECTION], found[0].zeta, 2, 1e-12) &&
         fabs(fabs(b.out.output[CTE_OUTPUT_GAP]) - found[0].distance) < 1e-12;
  client_check(pass && b.out.output[CTE_OUTPUT_ITERATIONS] <= 3.0, "project: at most 3 iterations from there");
}

/* Four points of a facet that lies half beside the other: the evaluation knows the same features. */
static void four_points(void)
{
  double history[12];
  int pass = opened("Quad4Quad4", 0), inside = 0;
  memcpy(&b.x[12], square, sizeof square);
  for (int a = 0; a < 4; a++) {
    b.x[3 * a] = square[3 * a] + 0.5;
    b.x[3 * a + 1] = square[3 * a + 1];
    b.x[3 * a + 2] = 0.3;
  }
  b.a.history_accepted = NULL;
  pass = pass && b.info.points == 4 && projected(0.0, history) && bench_evaluate(&b) == CTE_SUCCESS;
  for (int i = 0; i < 4 && pass; i++) {
    const double *output = &b.out.output[i * CTE_OUTPUT_SIZE];
    const int beyond = output[CTE_OUTPUT_FEATURE] > 0.0;
    const double zeta_1 = beyond ? 1.0 : output[CTE_OUTPUT_PROJECTION];
    const double side = beyond ? 0.5 / sqrt(3.0) : 0.0; /* from the edge x = 1 */
    pass = is(&found[i], beyond ? CTE_VERDICT_BOUNDARY : CTE_VERDICT_INSIDE, beyond ? 2 : 0, zeta_1,
              output[CTE_OUTPUT_PROJECTION + 1], sqrt(0.09 + side * side)) &&
           client_same(&history[3 * i + 1], found[i].zeta, 2) && fabs(history[3 * i]) <= 0.0;
    inside += !beyond;
  }
  client_check(pass && inside == 2, "project: four points, two beyond the edge");
}

/* 3/4 of one node and 1/4 of another; and a row that does not sum to one. */
static void interpolated(void)
{
  static const double slave[6] = {0.0, 0.5, 0.3, 1.0, 0.5, 0.3}, row[3] = {0.75, 0.25, 2.0};
  int pass = opened("InterpolatedQuad4", 2);
  memcpy(b.x, slave, sizeof slave);
  memcpy(&b.x[6], square, sizeof square);
  memcpy(b.row, row, sizeof row);
  client_check(pass && projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, 0.0, 0.3),
               "project: interpolated slave");
  b.row[0] = 0.25;
  client_check(projected(0.0, NULL) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, -0.5, 0.15),
               "project: a row that does not sum to one");
}

/* Neither x nor u of the multiplier's node is read. */
static void multiplier(void)
{
  double history[3];
  point("PointQuad4Multiplier", 0.25, 0.75, 0.5);
  for (int i = 15; i < 18; i++)
    client_special(1, &b.x[i]);
  client_check(projected(0.0, history) && is(&found[0], CTE_VERDICT_INSIDE, 0, -0.5, 0.5, 0.5) &&
                   client_same(&history[1], found[0].zeta, 2) && fabs(history[0]) <= 0.0,
               "project: x of a multiplier's node is not looked at");
}

/* Other layouts of the same numbers give the same bits; what stands between the nodes is not read. */
static void layouts(void)
{
  static double x[25], u[20];
  cte_api_table api = CTE_API_TABLE_INIT;
  bench_open(&b, "PointQuad4");
  for (int i = 0; i < 15; i++)
    b.u[i] = 0.01 * i;
  int pass = projected(0.0, NULL);
  const cte_projection dense = found[0];
  pass = pass && cte_api(CTE_VERSION_MAJOR, &api) == CTE_SUCCESS;
  memset(found, 0x5a, sizeof found);
  pass = pass && api.element_project(b.element, &b.a, 0.0, found, NULL) == CTE_SUCCESS;
  client_check(pass && same(&found[0], &dense), "table: element_project");
  for (int i = 0; i < 25; i++)
    client_special(1, &x[i]);
  for (int i = 0; i < 20; i++)
    client_special(1, &u[i]);
  for (int a = 0; a < 5; a++) {
    memcpy(&x[5 * a], &b.x[3 * a], 3 * sizeof x[0]);
    memcpy(&u[4 * a], &b.u[3 * a], 3 * sizeof u[0]);
  }
  b.a.x = x;
  b.a.u = u;
  b.a.x_node_stride = 5;
  b.a.u_node_stride = 4;
  client_check(projected(0.0, NULL) && same(&found[0], &dense), "project: strides");
  point("PointQuad4", 0.25, 0.75, 0.5);
  pass = projected(0.0, NULL);
  const cte_projection zero = found[0];
  b.a.u = NULL;
  b.a.nnode = 5;
  b.a.request = 0;
  client_check(pass && projected(0.0, NULL) && same(&found[0], &zero), "project: u null, no request");
  b.x[0] -= 0.125; /* exact */
  for (int a = 1; a < 5; a++)
    b.x[3 * a] -= 0.125;
  for (int a = 0; a < 5; a++)
    b.u[3 * a] = 0.125;
  b.a.u = b.u;
  client_check(projected(0.0, NULL) && same(&found[0], &zero), "project: x + u is the position");
}

/* A point at (x, 0.2, 1) above the trough z = x^2; nodes: corners, middles of edges, centre. */
static void trough(double x)
{
  static const double at[9][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {0.0, -1.0},
                                  {1.0, 0.0},   {0.0, 1.0},  {-1.0, 0.0}, {0.0, 0.0}};
  opened("PointQuad9", 0);
  b.x[0] = x;
  b.x[1] = 0.2;
  b.x[2] = 1.0;
  for (int a = 0; a < 9; a++) {
    b.x[3 + 3 * a] = at[a][0];
    b.x[4 + 3 * a] = at[a][1];
    b.x[5 + 3 * a] = at[a][0] * at[a][0];
  }
}

/* The feet are where 2 z^3 - z - x = 0; of the three the middle one is the farthest. */
static void troughs(void)
{
  static const double side[2] = {0.05, -0.05};
  trough(0.0);
  client_check(projected(0.0, NULL) && found[0].verdict == CTE_VERDICT_NOT_UNIQUE &&
                   fabs(fabs(found[0].zeta[0]) - sqrt(0.5)) < 1e-7 && fabs(found[0].zeta[1] - 0.2) < 1e-7 &&
                   fabs(found[0].distance - sqrt(0.75)) < 1e-9,
               "project: two feet in a trough");
  for (int i = 0; i < 2; i++) {
    trough(side[i]);
    const int pass = projected(0.0, b.history_accepted);
    const double z = found[0].zeta[0], slope = 1.0 + 4.0 * z * z;
    client_check(pass && found[0].verdict == CTE_VERDICT_INSIDE && z * side[i] > 0.0 &&
                     fabs(2.0 * z * z * z - z - side[i]) < 1e-12 && fabs(found[0].zeta[1] - 0.2) < 1e-12,
                 client_text("project: the nearer foot in a trough", i));
    client_check(fabs(found[0].definiteness - (6.0 * z * z - 1.0) / slope) < 1e-12,
                 client_text("project: definiteness in a trough", i));
    client_check(bench_evaluate(&b) == CTE_SUCCESS && b.out.output[CTE_OUTPUT_ITERATIONS] <= 3.0 &&
                     client_near(&b.out.output[CTE_OUTPUT_PROJECTION], found[0].zeta, 2, 1e-12),
                 client_text("project: an evaluation stays at the nearer foot", i));
  }
}

void interface_project(void)
{
  on_a_square();
  reaches();
  nothing_projected();
  histories();
  four_points();
  interpolated();
  multiplier();
  layouts();
  troughs();
}
