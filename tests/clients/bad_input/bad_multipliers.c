/* bad_multipliers.c - bad input to elements with multipliers and to cte_history_augment; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { N = 16, LAMBDA = 15, HISTORY = 7, MULTIPLIER = 6, UNTOUCHED = -77 };

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
  return finite && isfinite(b.out.energy[0]);
}

/* A call of cte_history_augment that must not write. */
static int refused(int32_t code, int32_t argument)
{
  static double before[ROOM_HISTORY];
  int32_t named = UNTOUCHED;
  memcpy(before, b.history_accepted, sizeof before);
  const int32_t found = cte_history_augment(b.element, b.out.history_trial, b.history_accepted, &named);
  const int pass = found == code && named == argument && memcmp(before, b.history_accepted, sizeof before) == 0;
  if (!pass)
    printf("     code %d wanted %d, argument %d wanted %d\n", (int)found, (int)code, (int)named, (int)argument);
  return pass;
}

/* Accepted and trial history of a point in contact. */
static int accepted(bench *any, const char *name)
{
  if (!bench_open(any, name) || bench_evaluate(any) != CTE_SUCCESS)
    return 0;
  memcpy(any->history_accepted, any->out.history_trial, (size_t)any->info.history * sizeof any->history_accepted[0]);
  return bench_evaluate(any) == CTE_SUCCESS;
}

static void augment_null(void)
{
  int32_t named[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED};
  accepted(&b, "PointQuad4CoulombAugmented");
  static double kept[ROOM_HISTORY];
  memcpy(kept, b.history_accepted, sizeof kept);
  client_check(cte_history_augment(NULL, b.out.history_trial, b.history_accepted, &named[0]) == CTE_ERROR_NULL &&
                   cte_history_augment(b.element, NULL, b.history_accepted, &named[1]) == CTE_ERROR_NULL &&
                   cte_history_augment(b.element, b.out.history_trial, NULL, &named[2]) == CTE_ERROR_NULL &&
                   named[0] == CTE_ARGUMENT_ELEMENT && named[1] == CTE_ARGUMENT_HISTORY_TRIAL &&
                   named[2] == CTE_ARGUMENT_HISTORY_ACCEPTED && client_same(kept, b.history_accepted, ROOM_HISTORY),
               "augment: each pointer null");
  client_check(cte_history_augment(NULL, NULL, NULL, NULL) == CTE_ERROR_NULL, "augment: argument null");
}

static void augment_elements(void)
{
  static const char *const name[] = {"PointQuad4", "PointQuad4Coulomb", "PointQuad4Multiplier",
                                     "PointQuad4CoulombMultiplier"};
  int32_t index = cte_element_count(), code = UNTOUCHED, named = UNTOUCHED;
  for (int i = 0; i < 4; i++) {
    accepted(&b, name[i]);
    client_check(refused(CTE_ERROR_ELEMENT, CTE_ARGUMENT_ELEMENT),
                 client_text("augment: no multiplier in the history", i));
  }
  cte_f77_history_augment_(&index, b.out.history_trial, b.history_accepted, &named, &code);
  client_check(code == CTE_ERROR_INDEX && named == CTE_ARGUMENT_ELEMENT, "F77 augment, element out of range");
}

/* Entries that no evaluation writes, in the trial history (0) and in the accepted one (1). */
static void augment_values(const char *name)
{
  static double *const array[2] = {b.out.history_trial, b.history_accepted};
  static const int32_t argument[2] = {CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_HISTORY_ACCEPTED};
  static const double no_status[] = {-1.0, 9.0, 2.5, 1e30}, positive[] = {1e-307, 1e-300, 1.0, 1e30};
  for (int which = 0; which < 2; which++) {
    int finite = 1, status = 1, sign = 1;
    accepted(&b, name);
    const int last = b.info.history - 1;
    for (int entry = 0; entry <= last; entry++)
      for (int special = 0; special < CLIENT_SPECIALS; special++) {
        const double kept = array[which][entry];
        client_special(special, &array[which][entry]);
        finite &= refused(CTE_ERROR_NOT_FINITE, argument[which]);
        array[which][entry] = kept;
      }
    const double kept = array[which][last];
    for (int i = 0; i < 4; i++) {
      array[which][last] = positive[i];
      sign &= refused(CTE_ERROR_HISTORY, argument[which]);
    }
    array[which][last] = kept;
    for (int i = 0; i < 4; i++) {
      array[which][0] = no_status[i];
      status &= refused(CTE_ERROR_HISTORY, argument[which]);
    }
    client_check(finite, client_text("augment: no number in history", which));
    client_check(sign, client_text("augment: positive multiplier in history", which));
    client_check(status, client_text("augment: no status in history", which));
  }
}

/* The last of four points is bad: the others stay as they were. */
static void augment_points(void)
{
  int32_t index = -1;
  cte_element_find("Quad4Quad4CoulombAugmented", 26, &index);
  if (!bench_index(&b, index, 0)) {
    client_check(0, "Quad4Quad4CoulombAugmented");
    return;
  }
  memcpy(b.out.history_trial, b.history_accepted, sizeof b.history_accepted);
  for (int point = 0; point < 4; point++)
    b.out.history_trial[point * HISTORY + MULTIPLIER] = point == 3 ? 1.0 : -1.0;
  client_check(refused(CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_TRIAL), "augment: the last of four points is bad");
}

static void histories(const char *name)
{
  static const double positive[] = {1e-307, 1.0};
  accepted(&b, name);
  const int last = b.info.history - 1;
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    client_special(special, &b.history_accepted[last]);
    expect(client_text("history: no number as multiplier", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_HISTORY_ACCEPTED,
           last);
  }
  for (int i = 0; i < 2; i++) {
    b.history_accepted[last] = positive[i];
    expect(client_text("history: positive multiplier", i), CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, last);
  }
  b.history_accepted[last] = -0.0;
  client_check(clean(), "history: a multiplier of minus zero");
  b.history_accepted[0] = 2.5;
  expect("history with a multiplier: no status", CTE_ERROR_HISTORY, CTE_ARGUMENT_HISTORY_ACCEPTED, 0);
}

/* In u of the node; x and the other components are not read. */
static void unknowns(void)
{
  int pass = 1;
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    bench_open(&b, "PointQuad4Multiplier");
    client_special(special, &b.u[LAMBDA]);
    expect(client_text("no number as multiplier", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_U, 5);
    b.u[LAMBDA] = -1.0;
    for (int i = 0; i < 3; i++)
      client_special(special, &b.x[LAMBDA + i]);
    client_special(special, &b.u[LAMBDA + 1]);
    client_special(special, &b.u[LAMBDA + 2]);
    pass &= clean() && b.a.status == CTE_STATUS_CLOSED;
  }
  client_check(pass, "no number in x and the rest of u of a multiplier's node");
  int32_t index = -1;
  cte_element_find("Quad4Quad4Multiplier", 20, &index);
  if (!bench_index(&b, index, 0))
    return;
  for (int node = 8; node < 12; node++) {
    client_special(0, &b.u[3 * node]);
    expect(client_text("no number as multiplier, node", node), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_U, node);
    b.u[3 * node] = 0.0;
  }
}

/* Counts, strides and maps that leave out the multiplier. */
static void layouts(void)
{
  static const int64_t k_stride[][2] = {{15, 1}, {1, 15}};
  static const int32_t nnode[] = {5, 7};
  int32_t map[N];
  for (int i = 0; i < 2; i++) {
    bench_open(&b, "PointQuad4Multiplier");
    b.a.k_row_stride = k_stride[i][0];
    b.a.k_col_stride = k_stride[i][1];
    expect(client_text("k strides too small for the multiplier", i), CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0);
    bench_open(&b, "PointQuad4Multiplier");
    b.a.nnode = nnode[i];
    expect(client_text("multiplier, nnode", nnode[i]), CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  }
  bench_open(&b, "InterpolatedQuad4Multiplier");
  b.a.nnode = 5;
  expect("interpolated, no node for the multiplier", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NNODE, 0);
  for (int i = 0; i < N; i++)
    map[i] = i;
  bench_open(&b, "PointQuad4Multiplier");
  b.a.unknown_map = map;
  map[LAMBDA] = -1;
  expect("unknown_map negative for the multiplier", CTE_ERROR_INDEX, CTE_ARGUMENT_UNKNOWN_MAP, LAMBDA);
  map[LAMBDA] = 20;
  b.a.k_row_stride = 20;
  b.a.k_col_stride = 1;
  expect("unknown_map beyond the row stride for the multiplier", CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0);
}

static double x[2][6][3], u[2][6][3], f[2][N], k[2][N * N];
static int32_t status[2], code[2], connectivity[2][6];

/* Two contacts on nodes of their own, gathered by connectivity. */
static cte_batch fresh(void)
{
  cte_batch batch;
  batch = (cte_batch)CTE_BATCH_INIT;
  memset(f, 0x5a, sizeof f);
  bench_open(&b, "PointQuad4Multiplier");
  for (int e = 0; e < 2; e++) {
    memcpy(x[e], b.x, sizeof x[e]);
    memcpy(u[e], b.u, sizeof u[e]);
    code[e] = UNTOUCHED;
    for (int a = 0; a < 6; a++)
      connectivity[e][a] = 6 * e + a;
  }
  batch.request = CTE_RESIDUAL | CTE_TANGENT;
  batch.parameter_count = b.info.parameters;
  batch.x = &x[0][0][0];
  batch.u = &u[0][0][0];
  batch.connectivity = &connectivity[0][0];
  batch.global_nodes = 12;
  batch.parameters = b.parameters;
  batch.f = &f[0][0];
  batch.k = &k[0][0];
  batch.status = status;
  batch.code = code;
  return batch;
}

/* Refuses the batch, touching nothing. */
static void refuse(const char *what, cte_batch *batch, int32_t wanted, int32_t argument, int32_t index)
{
  const int32_t found = cte_element_evaluate_batch(b.element, 2, batch);
  if (!client_check(found == wanted && batch->error_argument == argument && batch->error_index == index &&
                        code[0] == UNTOUCHED,
                    what))
    printf("     code %d wanted %d, argument %d, index %d\n", (int)found, (int)wanted, (int)batch->error_argument,
           (int)batch->error_index);
}

static void batches(void)
{
  double untouched;
  cte_batch batch = fresh();
  batch.f_element_stride = LAMBDA;
  refuse("batch: f stride too small for the multiplier", &batch, CTE_ERROR_STRIDE, CTE_ARGUMENT_F, 0);
  batch = fresh();
  batch.k_element_stride = N * N - 1;
  refuse("batch: k stride too small for the multiplier", &batch, CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE, 0);
  batch = fresh();
  connectivity[1][5] = 12;
  refuse("batch: the multiplier's node out of range", &batch, CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY, 11);
  batch = fresh();
  client_special(0, &u[1][5][0]);
  memcpy(&untouched, &f[1][0], sizeof untouched);
  const int32_t found = cte_element_evaluate_batch(b.element, 2, &batch);
  client_check(found == CTE_CUT_BACK && batch.failed == 1 && batch.error_argument == CTE_ARGUMENT_U &&
                   batch.error_index == 1 && code[0] == CTE_SUCCESS && code[1] == CTE_ERROR_NOT_FINITE &&
                   client_same(&f[1][LAMBDA], &untouched, 1),
               "batch: a bad multiplier fails alone");
}

/* Lengths and multipliers from far below the least allowed to the largest. */
static void scales(void)
{
  static const double scale[] = {1e-300, 1e-160, 1e-30, 1e-12, 1e12, 1e29};
  static const char *const name[] = {"PointQuad4Multiplier",       "PointQuad4CoulombMultiplier",
                                     "InterpolatedQuad4Multiplier", "PointQuad4Augmented",
                                     "PointQuad4CoulombAugmented"};
  for (int e = 0; e < 5; e++) {
    int pass = 1;
    for (int i = 0; i < 36; i++) {
      bench_open(&b, name[e]);
      for (int j = 0; j < ROOM_UNKNOWNS; j++)
        b.x[j] *= scale[i % 6];
      if (e < 3)
        b.u[LAMBDA] = -scale[i / 6];
      else
        b.history_accepted[b.info.history - 1] = -scale[i / 6];
      pass &= clean();
      b.x[2] *= 2.0; /* far over the facet */
      pass &= clean();
    }
    client_check(pass, name[e]);
  }
}

/* From every kind of history to every other: with slip, with slip and multiplier, with multiplier, without both. */
static void transfer(void)
{
  static const char *const name[] = {"PointQuad4Coulomb",   "PointQuad4CoulombMultiplier", "PointQuad4CoulombAugmented",
                                     "PointQuad4Augmented", "PointQuad4",                  "PointQuad4Multiplier"};
  static const int kind[] = {0, 0, 1, 2, 3, 3};
  for (int from = 0; from < 6; from++)
    for (int to = 0; to < 6; to++) {
      double before[HISTORY];
      int32_t named = UNTOUCHED;
      const int32_t argument = kind[from] < 3 ? CTE_ARGUMENT_TO : CTE_ARGUMENT_FROM;
      if (kind[from] == kind[to] && kind[from] < 3)
        continue;
      accepted(&b, name[from]);
      accepted(&next, name[to]);
      memcpy(before, next.out.history_trial, sizeof before);
      const int32_t found = cte_history_transfer(b.element, b.out.output, b.out.history_trial, next.element,
                                                 next.out.output, next.out.history_trial, &named);
      client_check(found == CTE_ERROR_ELEMENT && named == argument &&
                       memcmp(before, next.out.history_trial, sizeof before) == 0,
                   client_text("transfer to another kind of history", 10 * from + to));
    }
}

void bad_multipliers(void)
{
  augment_null();
  augment_elements();
  augment_values("PointQuad4Augmented");
  augment_values("PointQuad4CoulombAugmented");
  augment_points();
  histories("PointQuad4Augmented");
  histories("PointQuad4CoulombAugmented");
  unknowns();
  layouts();
  batches();
  scales();
  transfer();
}
