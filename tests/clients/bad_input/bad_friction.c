/* bad_friction.c - bad input to frictional elements and to cte_history_transfer; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HISTORY = 6, ANCHOR = 3, PATH = 5, UNTOUCHED = -77 };

static bench b, next;

/* The caller's fault, nothing written. */
static void expect(const char *what, int32_t code, int32_t argument, int32_t index)
{
  char text[256] = "";
  bench_canary(&b);
  const int32_t found = bench_evaluate(&b);
  cte_element_message(b.element, &b.a, found, text, sizeof text);
  const int pass = found == code && b.a.error_argument == argument && b.a.error_index == index &&
                   client_contains(text, cte_argument_name(argument)) && bench_untouched(&b);
  if (!client_check(pass, what))
    printf("     code %d wanted %d, argument %d, index %d wanted %d\n", (int)found, (int)code,
           (int)b.a.error_argument, (int)b.a.error_index, (int)index);
}

/* Cut back as degenerate, nothing written. */
static void expect_degenerate(const char *what)
{
  bench_canary(&b);
  client_check(bench_evaluate(&b) == CTE_CUT_BACK && b.a.status == CTE_STATUS_DEGENERATE && b.a.dt_ratio == 0.5 &&
                   b.a.closed_points == 0 && bench_untouched(&b),
               what);
}

/* A result with finite numbers, or a code and untouched arrays; no trap. */
static int clean(void)
{
  int finite = 1;
  bench_canary(&b);
  if (bench_evaluate(&b) != CTE_SUCCESS)
    return bench_untouched(&b);
  for (int i = 0; i < b.info.unknowns; i++)
    finite &= isfinite(b.out.f[i]) != 0;
  for (int i = 0; i < b.info.unknowns * b.info.unknowns; i++)
    finite &= isfinite(b.out.k[i]) != 0;
  for (int i = 0; i < b.info.history; i++)
    finite &= isfinite(b.out.history_trial[i]) != 0;
  for (int i = 0; i < b.info.points * CTE_OUTPUT_SIZE; i++)
    finite &= isfinite(b.out.output[i]) != 0;
  return finite && isfinite(b.out.energy[0]);
}

/* A bench whose accepted point sticks. */
static int accepted(bench *any, const char *name)
{
  if (!bench_open(any, name) || bench_evaluate(any) != CTE_SUCCESS)
    return 0;
  memcpy(any->history_accepted, any->out.history_trial, (size_t)any->info.history * sizeof any->history_accepted[0]);
  return 1;
}

static void parameters(void)
{
  static const char *const name[] = {"eps_t", "mu", "eps_1", "eps_2", "mu_1", "mu_2"};
  for (int i = 0; i < 6; i++) {
    bench_open(&b, i < 2 ? "PointQuad4Coulomb" : "PointQuad4Orthotropic");
    bench_set(&b, name[i], -0.5);
    expect(client_text("friction, negative parameter", i), CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS,
           bench_parameter(&b, name[i]));
    bench_set(&b, name[i], 0.5);
    client_special(i % CLIENT_SPECIALS, &b.parameters[bench_parameter(&b, name[i])]);
    expect(client_text("friction, no number as parameter", i), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_PARAMETERS,
           bench_parameter(&b, name[i]));
  }
  bench_open(&b, "PointQuad4Orthotropic");
  bench_set(&b, "eps_1", 1e20);
  bench_set(&b, "eps_2", 1e-300);
  bench_canary(&b);
  client_check(bench_evaluate(&b) == CTE_CUT_BACK && b.a.status == CTE_STATUS_LAW && bench_untouched(&b),
               "friction, stiffnesses whose quotient is NaN");
  bench_open(&b, "PointQuad4Orthotropic");
  bench_set(&b, "eps_n", 1e-190);
  b.history_accepted[0] = CTE_STATUS_STICK;
  b.history_accepted[3] = b.history_accepted[1] + 0.25;
  client_check(bench_evaluate(&b) == CTE_SUCCESS && b.a.status == CTE_STATUS_SLIP, "friction, next to no pressure");
}

static void histories(void)
{
  static const double no_status[] = {-1.0, 9.0, 2.5, 1e30};
  if (!accepted(&b, "PointQuad4Coulomb"))
    client_check(0, "an accepted contact with friction");
  for (int entry = 0; entry < HISTORY; entry++)
    for (int special = 0; special < CLIENT_SPECIALS; special++) {
      const double kept = b.history_accepted[entry];
      client_special(special, &b.history_accepted[entry]);
      expect(client_text("friction, no number in the history, entry", entry), CTE_ERROR_NOT_FINITE,
             CTE_ARGUMENT_HISTORY_ACCEPTED, entry);
      b.history_accepted[entry] = kept;
    }
  const double status = b.history_accepted[0];
  for (int i = 0; i < 4; i++) {
    b.history_accepted[0] = no_status[i];
    expect(client_text("history: no status", i), CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 0);
  }
  b.history_accepted[0] = status;
  b.history_accepted[PATH] = -1e-300;
  expect("history: negative slip path", CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, PATH);
  b.history_accepted[PATH] = 0.0;
  for (int i = 0; i < 2; i++) {
    const double anchor = b.history_accepted[ANCHOR + i];
    b.history_accepted[ANCHOR + i] = i == 0 ? 1e5 : -1e5;
    expect(client_text("history: an anchor far outside", i), CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, ANCHOR + i);
    b.history_accepted[ANCHOR + i] = 1000.0; /* 500 facets away */
    client_check(clean() && b.a.status == CTE_STATUS_SLIP, client_text("history: an anchor outside", i));
    b.history_accepted[ANCHOR + i] = anchor;
  }
  accepted(&b, "PointQuad4");
  b.history_accepted[0] = 9.0;
  client_check(clean(), "without friction any number is a status: it is open");
  b.history_accepted[1] = -1e30;
  expect("history: a projection far outside", CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 1);
}

/* Two contacts, the second with a bad history: it fails alone. */
static void in_a_batch(void)
{
  static double x[2][15], f[2][15], history[2][HISTORY];
  int32_t status[2] = {UNTOUCHED, UNTOUCHED}, code[2] = {UNTOUCHED, UNTOUCHED};
  double untouched;
  cte_batch batch;
  accepted(&b, "PointQuad4Coulomb");
  batch = (cte_batch)CTE_BATCH_INIT;
  memset(f, 0x5a, sizeof f);
  memcpy(&untouched, &f[1][0], sizeof untouched);
  for (int e = 0; e < 2; e++) {
    memcpy(x[e], b.x, sizeof x[e]);
    memcpy(history[e], b.history_accepted, sizeof history[e]);
  }
  history[1][PATH] = -1.0;
  batch.request = CTE_RESIDUAL;
  batch.parameter_count = b.info.parameters;
  batch.x = x[0];
  batch.parameters = b.parameters;
  batch.history_accepted = history[0];
  batch.f = f[0];
  batch.status = status;
  batch.code = code;
  const int32_t found = cte_element_evaluate_batch(b.element, 2, &batch);
  client_check(found == CTE_CUT_BACK && batch.failed == 1 && batch.error_argument == CTE_ARGUMENT_HISTORY_ACCEPTED &&
                   batch.error_index == 1 && code[0] == CTE_SUCCESS && code[1] == CTE_ERROR_HISTORY &&
                   client_same(&f[1][0], &untouched, 1),
               "batch: a bad history fails alone");
}

/* An orthotropic law without an axis, and a rope that stands on the surface. */
static void axes(void)
{
  static const double rope[6] = {0.9, 0.0, 0.0, 0.5, 0.0, 0.0};
  static const int place[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
  int32_t index = -1;
  bench_open(&b, "PointQuad4Orthotropic");
  client_check(clean() && b.a.status == CTE_STATUS_STICK, "an axis along the first parameter");
  bench_set(&b, "axis_1", 0.0);
  expect_degenerate("axis_1 = axis_2 = 0");
  bench_set(&b, "axis_2", 1e-300);
  client_check(clean(), "an axis of length 1e-300");
  cte_element_find("Line2CylinderOrthotropic", 24, &index);
  bench_index(&b, index, 0);
  bench_set(&b, "radius", 1.0);
  memcpy(b.x, rope, sizeof rope);
  expect_degenerate("a rope along the normal of a cylinder");
  cte_element_find("Line2Quad9OrthotropicAtPoint", 28, &index);
  bench_index(&b, index, 0);
  b.x[2] = -0.3; /* the line from (0, 0, -0.3) to (0, 0, -0.1) */
  b.x[5] = -0.1;
  for (int a = 0; a < 9; a++)
    for (int k = 0; k < 2; k++)
      b.x[6 + 3 * a + k] = place[a][k];
  expect_degenerate("a rope along the normal of a facet");
  b.x[3] = 0.2;
  client_check(clean() && b.a.status == CTE_STATUS_STICK, "a rope that leans");
}

/* Lengths from far below the least allowed to the largest, with a history that is remembered. */
static void scales(void)
{
  static const double scale[] = {1e-300, 1e-160, 1e-30, 1e-12, 1e12, 1e29};
  static const char *const name[] = {"PointQuad4Coulomb", "PointQuad4Orthotropic", "InterpolatedQuad4Coulomb",
                                     "PointCylinderCoulomb"};
  for (int e = 0; e < 4; e++) {
    int pass = 1;
    for (int i = 0; i < 6; i++) {
      pass &= accepted(&b, name[e]);
      for (int j = 0; j < ROOM_UNKNOWNS; j++)
        b.x[j] *= scale[i];
      b.history_accepted[ANCHOR] += 0.3;
      pass &= clean();
    }
    client_check(pass, name[e]);
  }
}

/* A call of cte_history_transfer that must not write. */
static int refused(int32_t code, int32_t argument)
{
  double before[HISTORY];
  int32_t named = UNTOUCHED;
  memcpy(before, next.out.history_trial, sizeof before);
  const int32_t found = cte_history_transfer(b.element, b.out.output, b.out.history_trial, next.element, next.out.output,
                                             next.out.history_trial, &named);
  const int pass = found == code && named == argument && memcmp(before, next.out.history_trial, sizeof before) == 0;
  if (!pass)
    printf("     code %d wanted %d, argument %d wanted %d\n", (int)found, (int)code, (int)named, (int)argument);
  return pass;
}

/* From a sliding point to the same point of the same facet. */
static void sound(const char *from, const char *to)
{
  accepted(&b, from);
  b.u[0] = 0.05;
  bench_evaluate(&b);
  bench_open(&next, to);
  next.u[0] = 0.05;
  bench_evaluate(&next);
}

static void transfer_null(void)
{
  const char *const facet = "PointQuad4Coulomb";
  double *const history = next.out.history_trial;
  int32_t named[6];
  sound(facet, facet);
  const double *old = b.out.history_trial, *out = b.out.output, kept = history[ANCHOR];
  int pass = cte_history_transfer(NULL, out, old, next.element, out, history, &named[0]) == CTE_ERROR_NULL &&
             cte_history_transfer(b.element, NULL, old, next.element, out, history, &named[1]) == CTE_ERROR_NULL &&
             cte_history_transfer(b.element, out, NULL, next.element, out, history, &named[2]) == CTE_ERROR_NULL &&
             cte_history_transfer(b.element, out, old, NULL, out, history, &named[3]) == CTE_ERROR_NULL &&
             cte_history_transfer(b.element, out, old, next.element, NULL, history, &named[4]) == CTE_ERROR_NULL &&
             cte_history_transfer(b.element, out, old, next.element, out, NULL, &named[5]) == CTE_ERROR_NULL;
  for (int i = 0; i < 6; i++)
    pass &= named[i] == CTE_ARGUMENT_FROM + i;
  client_check(pass && client_same(&kept, &history[ANCHOR], 1), "transfer: each pointer null");
  client_check(cte_history_transfer(NULL, out, old, NULL, out, history, NULL) == CTE_ERROR_NULL,
               "transfer: argument null");
}

static void transfer_values(void)
{
  const char *const facet = "PointQuad4Coulomb";
  static double *const array[4] = {b.out.output, b.out.history_trial, next.out.output, next.out.history_trial};
  static const int32_t name[4] = {CTE_ARGUMENT_FROM_OUTPUT, CTE_ARGUMENT_FROM_HISTORY, CTE_ARGUMENT_TO_OUTPUT,
                                  CTE_ARGUMENT_TO_HISTORY};
  for (int i = 0; i < 4; i++) {
    int pass = 1;
    for (int entry = 0; entry < (i % 2 == 0 ? CTE_OUTPUT_SIZE : HISTORY); entry++) {
      sound(facet, facet);
      client_special(entry % CLIENT_SPECIALS, &array[i][entry]);
      pass &= refused(CTE_ERROR_NOT_FINITE, name[i]);
    }
    client_check(pass, client_text("transfer: no number in array", i));
  }
  sound(facet, facet);
  b.out.history_trial[0] = 2.5;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), "transfer: no status");
  sound(facet, facet);
  b.out.history_trial[PATH] = -1.0;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), "transfer: negative slip path");
  sound(facet, facet);
  b.out.output[CTE_OUTPUT_PROJECTION] += 0.01;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), "transfer: output of another state");
  sound(facet, facet);
  next.out.history_trial[2] -= 0.01;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_TO_HISTORY), "transfer: new history of another state");
}

static void transfer_elements(void)
{
  const char *const facet = "PointQuad4Coulomb";
  int32_t index = -1, code = UNTOUCHED, named = UNTOUCHED;
  sound("PointQuad4", facet);
  client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_FROM), "transfer: from an element without friction");
  sound(facet, "PointQuad4");
  client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_TO), "transfer: to an element without friction");
  cte_element_find("PointLine2Coulomb2d", 19, &index);
  sound(facet, facet);
  bench_index(&next, index, 0);
  client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_TO), "transfer: from 3D to 2D");
  index = cte_element_count();
  cte_f77_history_transfer_(&index, b.out.output, b.out.history_trial, &index, next.out.output, next.out.history_trial, &named,
                            &code);
  client_check(code == CTE_ERROR_INDEX && named == CTE_ARGUMENT_FROM, "F77 transfer, element out of range");
}

/* Outputs that no facet has. */
static void transfer_planes(void)
{
  const char *const facet = "PointQuad4Coulomb";
  double *const tangents = &b.out.output[CTE_OUTPUT_TANGENTS];
  double *const new_tangents = &next.out.output[CTE_OUTPUT_TANGENTS];
  sound(facet, facet);
  memset(tangents, 0, 3 * sizeof tangents[0]);
  client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_FROM_OUTPUT), "transfer: a tangent of length zero");
  sound(facet, facet);
  memcpy(&new_tangents[3], new_tangents, 3 * sizeof new_tangents[0]);
  client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), "transfer: parallel tangents");
  sound(facet, facet);
  for (int k = 0; k < 3; k++)
    next.out.output[CTE_OUTPUT_NORMAL + k] *= 2.0;
  client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), "transfer: no unit normal");
  sound(facet, facet);
  for (int k = 0; k < 3; k++)
    next.out.output[CTE_OUTPUT_NORMAL + k] = -b.out.output[CTE_OUTPUT_NORMAL + k];
  client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), "transfer: opposite normals");
  sound(facet, facet);
  for (int k = 0; k < 6; k++)
    new_tangents[k] *= 1e-29;
  for (int k = 0; k < 6; k++)
    tangents[k] = k == 1 || k == 3 ? 1e29 : 0.0;
  b.out.history_trial[ANCHOR] = -900.0;
  client_check(refused(CTE_CUT_BACK, CTE_ARGUMENT_TO_OUTPUT), "transfer: an anchor beyond 1e30");
  b.out.history_trial[ANCHOR] = -1e29;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_FROM_HISTORY), "transfer: from an anchor far outside");
}

void bad_friction(void)
{
  parameters();
  histories();
  in_a_batch();
  axes();
  scales();
  transfer_null();
  transfer_values();
  transfer_elements();
  transfer_planes();
}
