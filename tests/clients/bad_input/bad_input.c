/* bad_input.c - every kind of bad input to one evaluation, floating-point traps on.
 *
 * Each case spoils one thing of a sound call and checks: the return code, the argument named, that
 * cte_element_message names it too, and that no byte of the caller's arrays has changed. bad_calls.c does the
 * same for the other functions. bad_input.f90 is the twin.
 */
#define _GNU_SOURCE /* feenableexcept */
#include "bad_calls.h"
#include "client_support.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static bench b; /* too large for some stacks */

/* Evaluates the spoiled bench: the caller's fault. */
static void expect(const char *what, int32_t code, int32_t argument)
{
  char text[256] = "";
  bench_canary(&b);
  const int32_t found = bench_evaluate(&b);
  cte_element_message(b.element, &b.a, found, text, sizeof text);
  const int pass = found == code && b.a.error_argument == argument &&
                   client_contains(text, cte_argument_name(argument)) && bench_untouched(&b);
  if (!client_check(pass, what))
    printf("     code %d wanted %d, argument %d wanted %d, %s, text: %s\n", (int)found, (int)code,
           (int)b.a.error_argument, (int)argument, bench_untouched(&b) ? "untouched" : "arrays written", text);
}

/* Evaluates a state without a projection: to be cut back, as degenerate or not unique. */
static void expect_degenerate(const char *what)
{
  char text[256] = "";
  bench_canary(&b);
  const int32_t found = bench_evaluate(&b);
  cte_element_message(b.element, &b.a, found, text, sizeof text);
  const int named = b.a.status == CTE_STATUS_DEGENERATE || b.a.status == CTE_STATUS_NOT_UNIQUE;
  const int smaller = b.a.dt_ratio > 0.0 && b.a.dt_ratio < 1.0;
  const int pass = found == CTE_CUT_BACK && named && smaller && b.a.error_index == 0 && b.a.closed_points == 0 &&
                   text[0] != '\0' && bench_untouched(&b);
  if (!client_check(pass, what))
    printf("     code %d, status %d, dt_ratio %g, index %d, %s, text: %s\n", (int)found, (int)b.a.status,
           b.a.dt_ratio, (int)b.a.error_index, bench_untouched(&b) ? "untouched" : "arrays written", text);
}

/* All requested outputs are finite. */
static int finite_outputs(void)
{
  int finite = !(b.a.request & CTE_ENERGY) || isfinite(b.out.energy[0]);
  for (int i = 0; i < b.info.unknowns; i++)
    finite &= isfinite(b.out.f[i]) != 0;
  for (int i = 0; i < b.info.unknowns * b.info.unknowns && (b.a.request & CTE_TANGENT); i++)
    finite &= isfinite(b.out.k[i]) != 0;
  for (int i = 0; i < b.info.history; i++)
    finite &= isfinite(b.out.history_trial[i]) != 0;
  for (int i = 0; i < b.info.points * CTE_OUTPUT_SIZE; i++)
    finite &= isfinite(b.out.output[i]) != 0;
  return finite;
}

/* Extreme but not wrong: a result with finite numbers, or a code and untouched arrays. No trap. */
static int clean(void)
{
  bench_canary(&b);
  return bench_evaluate(&b) == CTE_SUCCESS ? finite_outputs() : bench_untouched(&b);
}

static void expect_clean(const char *what)
{
  if (!client_check(clean(), what))
    printf("     status %d\n", (int)b.a.status);
}

static void null_pointers(void)
{
  bench_open(&b, "PointQuad4");
  b.a.x = NULL;
  expect("x null", CTE_ERROR_NULL, CTE_ARGUMENT_X);
  bench_open(&b, "PointQuad4");
  b.a.parameters = NULL;
  expect("parameters null", CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS);
  bench_open(&b, "PointQuad4");
  b.a.f = NULL;
  expect("f null with CTE_RESIDUAL", CTE_ERROR_NULL, CTE_ARGUMENT_F);
  bench_open(&b, "PointQuad4");
  b.a.k = NULL;
  expect("k null with CTE_TANGENT", CTE_ERROR_NULL, CTE_ARGUMENT_K);
  bench_open(&b, "PointQuad4");
  b.a.history_trial = NULL;
  expect("history_trial null with CTE_HISTORY", CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_TRIAL);
  bench_open(&b, "PointQuad4");
  b.a.output = NULL;
  expect("output null with CTE_OUTPUT", CTE_ERROR_NULL, CTE_ARGUMENT_OUTPUT);
  bench_open(&b, "PointQuad4");
  b.a.energy = NULL;
  expect("energy null with CTE_ENERGY", CTE_ERROR_NULL, CTE_ARGUMENT_ENERGY);
  bench_open(&b, "PointQuad4");
  b.a.request |= CTE_PROJECTION_GIVEN;
  b.a.history_accepted = NULL;
  expect("history_accepted null with CTE_PROJECTION_GIVEN", CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_ACCEPTED);
  bench_open(&b, "PointQuad4");
  b.a.request |= CTE_FREEZE_STATE;
  b.a.history_accepted = NULL;
  expect("history_accepted null with CTE_FREEZE_STATE", CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_ACCEPTED);
  bench_open(&b, "InterpolatedQuad4");
  b.a.slave_row = NULL;
  expect("slave_row null", CTE_ERROR_NULL, CTE_ARGUMENT_SLAVE_ROW);
  bench_open(&b, "PointQuad4");
  b.element = NULL;
  expect("element null", CTE_ERROR_NULL, CTE_ARGUMENT_ELEMENT);
}

/* Nothing beyond the caller's struct may be written, so no scalar is. */
static void struct_sizes(void)
{
  const uint32_t size[4] = {0, 8, sizeof(cte_arguments) - 1, 312}; /* the last: that of interface 0.1 */
  for (int i = 0; i < 4; i++) {
    char text[256] = "";
    bench_open(&b, "PointQuad4");
    b.a.struct_size = size[i];
    const cte_arguments before = b.a;
    bench_canary(&b);
    const int32_t found = bench_evaluate(&b);
    cte_element_message(b.element, &b.a, found, text, sizeof text);
    client_check(found == CTE_ERROR_STRUCT_SIZE && memcmp(&before, &b.a, sizeof before) == 0 &&
                     bench_untouched(&b) && client_contains(text, cte_argument_name(CTE_ARGUMENT_STRUCT_SIZE)),
                 client_text("struct_size", (long)size[i]));
  }
}

static void counts(void)
{
  const int32_t nnode[3] = {4, 6, -1};
  const int32_t nslave[2] = {0, -1};
  const uint32_t unknown[2] = {1024u, 0x80000000u};
  for (int i = 0; i < 3; i++) {
    bench_open(&b, "PointQuad4");
    b.a.nnode = nnode[i];
    expect(client_text("nnode", nnode[i]), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE);
  }
  bench_open(&b, "PointQuad4");
  b.a.nslave = 2;
  expect("nslave for an element with its own slave nodes", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE);
  for (int i = 0; i < 2; i++) {
    bench_open(&b, "InterpolatedQuad4");
    b.a.nslave = nslave[i];
    b.a.nnode = 0;
    expect(client_text("interpolated nslave", nslave[i]), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE);
  }
  bench_open(&b, "InterpolatedQuad4");
  bench_canary(&b);
  b.a.nslave = INT32_MAX; /* more unknowns than an int32_t counts */
  b.a.nnode = 0;
  client_check(bench_evaluate(&b) < 0 && bench_untouched(&b), "interpolated nslave: the largest integer");
  for (int i = 0; i < 2; i++) {
    bench_open(&b, "PointQuad4");
    b.a.request |= unknown[i];
    expect(client_text("unknown request bit", (long)unknown[i]), CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST);
  }
}

static void workspace(void)
{
  bench_open(&b, "InterpolatedQuad4");
  if (b.info.workspace == 0)
    return;
  b.a.workspace = NULL;
  expect("workspace null", CTE_ERROR_NULL, CTE_ARGUMENT_WORKSPACE);
  bench_open(&b, "InterpolatedQuad4");
  b.a.workspace_size = b.info.workspace - 1;
  expect("workspace too small", CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE);
}

static void parameters(void)
{
  char text[256] = "";
  const int32_t missing[3] = {0, -1, 1}; /* 1: one too few */
  for (int i = 0; i < 3; i++) {
    bench_open(&b, "PointQuad4");
    b.a.parameter_count = missing[i] == 1 ? b.info.parameters - 1 : missing[i];
    expect(client_text("parameter_count", b.a.parameter_count), CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS);
  }
  bench_open(&b, "PointQuad4");
  bench_set(&b, "eps_n", -1.0);
  expect("eps_n negative", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS);
  cte_element_message(b.element, &b.a, CTE_ERROR_PARAMETER, text, sizeof text);
  client_check(b.a.error_index == bench_parameter(&b, "eps_n") && client_contains(text, "eps_n"),
               "eps_n negative: named in index and text");
  bench_open(&b, "PointCylinder");
  bench_set(&b, "radius", -1.0);
  expect("radius negative", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS);
}

static void not_finite(void)
{
  static const char *const place[] = {"x",         "u",            "history_accepted", "eps_n",
                                      "slave_row", "slave weight", "f_scale",  "k_scale"};
  static const int32_t argument[] = {CTE_ARGUMENT_X,          CTE_ARGUMENT_U,         CTE_ARGUMENT_HISTORY_ACCEPTED,
                                     CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_SLAVE_ROW,
                                     CTE_ARGUMENT_SCALE,      CTE_ARGUMENT_SCALE};
  for (int i = 0; i < 8; i++)
    for (int special = 0; special < CLIENT_SPECIALS; special++) {
      char what[64];
      if (!bench_open(&b, "InterpolatedQuad4"))
        return;
      double *const eps_n = &b.parameters[bench_parameter(&b, "eps_n")];
      double *const spoiled[] = {&b.x[4],   &b.u[5],   &b.history_accepted[1], eps_n,
                                 &b.row[0], &b.row[1], &b.a.f_scale,   &b.a.k_scale};
      client_special(special, spoiled[i]);
      snprintf(what, sizeof what, "%s in %s", client_special_name[special], place[i]);
      expect(what, CTE_ERROR_NOT_FINITE, argument[i]);
    }
}

static void strides(void)
{
  static const int64_t k_stride[][2] = {{-15, 1}, {15, -1}, {1, 1}, {3, 1}, {1, 14}, {0, 1}, {1, 0}};
  int32_t map[15];
  for (int i = 0; i < 7; i++) {
    bench_open(&b, "PointQuad4");
    b.a.k_row_stride = k_stride[i][0];
    b.a.k_col_stride = k_stride[i][1];
    expect(client_text("k strides negative or overlapping", i), CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE);
  }
  bench_open(&b, "PointQuad4");
  b.a.x_node_stride = -3;
  expect("x_node_stride negative", CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
  bench_open(&b, "PointQuad4");
  b.a.u_node_stride = -3;
  expect("u_node_stride negative", CTE_ERROR_STRIDE, CTE_ARGUMENT_U);
  for (int i = 0; i < 15; i++)
    map[i] = i;
  map[3] = -1;
  bench_open(&b, "PointQuad4");
  b.a.unknown_map = map;
  expect("unknown_map negative", CTE_ERROR_INDEX, CTE_ARGUMENT_UNKNOWN_MAP);
  client_check(b.a.error_index == 3, "unknown_map negative: entry 3");
  map[3] = 40;
  b.a.k_row_stride = 15;
  b.a.k_col_stride = 1;
  expect("unknown_map beyond the row stride", CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE);
}

/* Copies the coordinates of node `from` to node `to`. */
static void coincide(int to, int from)
{
  memcpy(&b.x[3 * to], &b.x[3 * from], 3 * sizeof b.x[0]);
}

static void degenerate_facets(void)
{
  bench_open(&b, "PointQuad4");
  for (int node = 2; node <= 4; node++)
    coincide(node, 1);
  expect_degenerate("facet: all nodes equal");
  for (int node = 1; node <= 4; node++) {
    const double on_line[3] = {0.3 * node, 0.0, 1.0};
    memcpy(&b.x[3 * node], on_line, sizeof on_line);
  }
  expect_degenerate("facet: all nodes on a line");
  bench_open(&b, "PointQuad4");
  coincide(2, 1);
  expect_clean("facet: neighbouring nodes coincide");
  coincide(0, 1);
  expect_clean("facet: the slave on the coincident nodes");
  bench_open(&b, "PointQuad4");
  coincide(3, 1);
  expect_clean("facet: opposite nodes coincide");
  coincide(4, 2);
  expect_degenerate("facet: both pairs of opposite nodes coincide");
}

static void degenerate_distances(void)
{
  const double axis[3] = {0.0, 0.0, 0.3}, on_line[3] = {0.5, 0.0, 0.0};
  bench_open(&b, "PointCylinder");
  memcpy(b.x, axis, sizeof axis);
  expect_degenerate("slave on the axis of a cylinder");
  bench_open(&b, "PointCylinderDistance");
  memcpy(b.x, axis, sizeof axis);
  expect_degenerate("slave on the axis of a cylinder given by its distance");
  bench_open(&b, "PointLine2");
  memcpy(b.x, on_line, sizeof on_line);
  expect_degenerate("L = 0 against a line");
  bench_open(&b, "PointLine2");
  coincide(2, 1);
  expect_degenerate("line of length zero");
  bench_open(&b, "PointPoint");
  coincide(0, 1);
  expect_degenerate("L = 0 between points");
}

/* Lengths from far below the least allowed to the largest. */
static void scales(void)
{
  static const double scale[] = {1e-300, 1e-160, 1e-30, 1e-12, 1e12, 1e29};
  static const long exponent[] = {-300, -160, -30, -12, 12, 29};
  static const char *const name[] = {"PointQuad4", "InterpolatedQuad4", "PointLine2", "PointPoint",
                                     "PointCylinder"};
  for (int e = 0; e < 5; e++)
    for (int i = 0; i < 6; i++) {
      char what[64];
      bench_open(&b, name[e]);
      for (int j = 0; j < ROOM_UNKNOWNS; j++)
        b.x[j] *= scale[i];
      snprintf(what, sizeof what, "%s, lengths times ten to the power", name[e]);
      expect_clean(client_text(what, exponent[i]));
    }
}

/* Every element: all nodes in one place, random nodes and multipliers of every size, a NaN in every unknown. */
static void every_element(void)
{
  static const double scale[] = {0.0, 1e-300, 1e-160, 1e-30, 1e-12, 1.0, 1e12, 1e29};
  for (int32_t index = 0; index < cte_element_count(); index++) {
    int pass = bench_index(&b, index, 2) && clean();
    for (int i = 0; i < 8 && pass; i++)
      for (int shift = 0; shift < 2; shift++) {
        for (int j = 0; j < b.info.unknowns; j++) {
          const double value = scale[i] * (client_random() - 0.5 * shift);
          if (bench_is_multiplier(&b, j))
            b.u[bench_position(&b, j)] = -value;
          else
            b.x[j] = value + (i == 0 ? 1.0 : 0.0);
        }
        pass &= clean();
      }
    for (int j = 0; j < b.info.unknowns && pass; j++) {
      client_special(j % CLIENT_SPECIALS, &b.u[bench_position(&b, j)]);
      bench_canary(&b);
      pass = bench_evaluate(&b) == CTE_ERROR_NOT_FINITE && b.a.error_argument == CTE_ARGUMENT_U &&
             bench_untouched(&b);
      b.u[bench_position(&b, j)] = 0.0;
    }
    client_check(pass, b.info.name != NULL ? b.info.name : "an element");
  }
}

int main(void)
{
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  setvbuf(stdout, NULL, _IOLBF, 0); /* a trap must not swallow what came before */
  null_pointers();
  struct_sizes();
  counts();
  workspace();
  parameters();
  not_finite();
  strides();
  degenerate_facets();
  degenerate_distances();
  scales();
  every_element();
  bad_calls();
  bad_fortran77();
  bad_batches();
  bad_maps();
  bad_states();
  bad_friction();
  bad_multipliers();
  bad_project();
  bad_patch();
  printf("%s bad_input, %d failures\n", client_failures ? "FAIL" : "PASS", client_failures);
  return client_failures ? 1 : 0;
}
