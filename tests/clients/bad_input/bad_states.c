/* bad_states.c - states without a normal or an area, sizes beyond any memory, batches with one bad contact; see
 * bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CONTACTS = 3, N = 15, UNTOUCHED = -77 };

static bench b;

static int32_t message_contains(int32_t code, const char *word)
{
  char text[256] = "";
  cte_element_message(b.element, &b.a, code, text, sizeof text);
  return client_contains(text, word);
}

/* Cut back as degenerate, nothing written. */
static int degenerate(void)
{
  bench_canary(&b);
  return bench_evaluate(&b) == CTE_CUT_BACK && b.a.status == CTE_STATUS_DEGENERATE && b.a.dt_ratio == 0.5 &&
         b.a.error_index == 0 && b.a.closed_points == 0 && bench_untouched(&b);
}

/* All nodes on the axis, in the centre, at the apex: no distance function but a plane's has a gradient. */
static void axes(void)
{
  for (int32_t index = 0; index < cte_element_count(); index++) {
    if (!bench_index(&b, index, 2) || !client_contains(b.info.name, "Distance"))
      continue;
    if (client_contains(b.info.name, "Plane"))
      client_check(bench_evaluate(&b) == CTE_SUCCESS, b.info.name);
    else
      client_check(degenerate(), b.info.name);
  }
}

/* Slaves without length or area whose measure moves. */
static void no_area(void)
{
  static const char *const name[] = {"Line2Quad4Current", "Quad4Quad4Current", "Quad4CylinderCurrent",
                                     "Line2Line2In2dCurrent"};
  static const double facet[4][3] = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
  for (int i = 0; i < 4; i++) {
    int32_t index = -1;
    if (cte_element_find(name[i], (int32_t)strlen(name[i]), &index) != CTE_SUCCESS || !bench_index(&b, index, 0)) {
      client_check(0, name[i]);
      continue;
    }
    const int d = b.info.dimension, slaves = b.info.slave_nodes;
    for (int a = 0; a < slaves; a++)
      for (int c = 0; c < d; c++)
        b.x[a * d + c] = c == d - 1 ? -0.1 : 0.4;
    for (int a = 0; a < b.info.master_nodes; a++)
      for (int c = 0; c < d; c++)
        b.x[(slaves + a) * d + c] = facet[a][c];
    client_check(degenerate(), name[i]);
  }
}

/* A projection that ends where a tangent vanishes: no normal, and no trap. */
static void folds(void)
{
  static const double curve[8] = {-0.35775198312476275, -0.15996433375403285, 0, 0, 1, 0, 0, 0};
  static const double facet[15] = {0.32448022570461044, 0.8389384679496289, 0.5141999583691359,
                                   -0.9860729075968265, -1.1488143572583795, -0.06259793927893043,
                                   0.892480515409261, -1.0349531116895379, 0.09425299530848862,
                                   -0.9860729075968265, -1.1488143572583795, -0.06259793927893043,
                                   -0.8702644775621593, 0.8918195568025112, 0.11188382990658284};
  static const char *const name[2] = {"PointLine3In2d", "PointQuad4"};
  for (int i = 0; i < 2; i++) {
    int32_t index = -1;
    if (cte_element_find(name[i], (int32_t)strlen(name[i]), &index) != CTE_SUCCESS || !bench_index(&b, index, 0)) {
      client_check(0, name[i]);
      continue;
    }
    memcpy(b.x, i == 0 ? curve : facet, i == 0 ? sizeof curve : sizeof facet);
    b.a.history_accepted = NULL;
    client_check(degenerate(), client_text("a fold", i));
  }
}

/* Forces of a power law that are finite, but too large for a tangent: refused, and no trap. */
static void huge_forces(void)
{
  for (int i = 0; i < 2; i++) {
    if (!bench_open(&b, "PointQuad4PowerLaw"))
      return;
    b.parameters[1] = 7.7;                /* m */
    b.parameters[2] = i == 0 ? 1e30 : 1e9; /* r0 */
    bench_canary(&b);
    const int32_t found = bench_evaluate(&b);
    const int32_t status = i == 0 ? CTE_STATUS_LAW : CTE_STATUS_CLOSED;
    client_check(found == (i == 0 ? CTE_CUT_BACK : CTE_SUCCESS) && b.a.status == status &&
                     (i == 1 || bench_untouched(&b)),
                 client_text("huge forces", i));
  }
}

static void counts(void)
{
  const int32_t many[3] = {INT32_MAX, 1 << 30, ((1 << 30) - 1) / 3 - 3};
  cte_info info;
  for (int i = 0; i < 3; i++) {
    info = (cte_info)CTE_INFO_INIT;
    if (!bench_open(&b, "InterpolatedQuad4"))
      return;
    client_check(cte_element_info(b.element, many[i] - (i == 0 ? 0 : -4), &info) == CTE_ERROR_NODE_COUNT,
                 client_text("info of too many nodes", many[i]));
    client_check(cte_element_batch_workspace(b.element, many[i]) == CTE_ERROR_NODE_COUNT,
                 client_text("batch workspace of too many slave nodes", many[i]));
    bench_canary(&b);
    b.a.nslave = many[i];
    b.a.nnode = 0;
    client_check(bench_evaluate(&b) == CTE_ERROR_NODE_COUNT && b.a.error_argument == CTE_ARGUMENT_NSLAVE &&
                     bench_untouched(&b),
                 client_text("too many slave nodes", many[i]));
  }
  client_check(cte_element_info(b.element, many[2] + 3, &info) == CTE_SUCCESS &&
                   info.unknowns == 3 * (many[2] + 3) && info.workspace > info.unknowns,
               "info of as many nodes as possible");
  client_check(cte_element_batch_workspace(NULL, 0) == CTE_ERROR_NULL, "batch workspace of element null");
}

static void strides(void)
{
  const int64_t far = INT64_MAX;
  if (!bench_open(&b, "PointQuad4"))
    return;
  bench_canary(&b);
  b.a.x_node_stride = far;
  client_check(bench_evaluate(&b) == CTE_ERROR_STRIDE && b.a.error_argument == CTE_ARGUMENT_X &&
                   bench_untouched(&b),
               "x_node_stride beyond any memory");
  b.a.x_node_stride = 2;
  client_check(bench_evaluate(&b) == CTE_ERROR_STRIDE && b.a.error_argument == CTE_ARGUMENT_X, "x_node_stride 2");
  b.a.x_node_stride = 0;
  b.a.u_node_stride = far / 8;
  client_check(bench_evaluate(&b) == CTE_ERROR_STRIDE && b.a.error_argument == CTE_ARGUMENT_U &&
                   bench_untouched(&b),
               "u_node_stride beyond any memory");
  b.a.u_node_stride = 0;
  b.a.k_row_stride = far;
  b.a.k_col_stride = 1;
  client_check(bench_evaluate(&b) == CTE_ERROR_STRIDE && b.a.error_argument == CTE_ARGUMENT_K_STRIDE &&
                   bench_untouched(&b),
               "k_row_stride beyond any memory");
}

/* The scalars say what was wrong, whatever is wrong. */
static void scalars(void)
{
  if (!bench_open(&b, "PointQuad4"))
    return;
  const cte_element *element = b.element;
  b.element = NULL;
  b.a.dt_ratio = 7.0;
  b.a.status = b.a.closed_points = b.a.error_argument = b.a.error_index = UNTOUCHED;
  client_check(bench_evaluate(&b) == CTE_ERROR_NULL && b.a.dt_ratio == 1.0 && b.a.status == CTE_STATUS_OPEN &&
                   b.a.closed_points == 0 && b.a.error_argument == CTE_ARGUMENT_ELEMENT && b.a.error_index == 0,
               "element null: the scalars");
  b.element = element;
  client_check(message_contains(CTE_ERROR_NULL, cte_argument_name(CTE_ARGUMENT_ELEMENT)), "element null: the text");
  client_special(0, &b.u[7]);
  client_check(bench_evaluate(&b) == CTE_ERROR_NOT_FINITE && b.a.error_index == 2, "u: the index is the node");
  b.u[7] = 0.0;
  client_special(0, &b.x[14]);
  client_check(bench_evaluate(&b) == CTE_ERROR_NOT_FINITE && b.a.error_index == 4, "x: the index is the node");
}

/* A struct of 8 bytes: nothing beyond them may be read (a memory checker looks at this). */
static void short_struct(void)
{
  char text[256] = "";
  uint32_t *head = malloc(8);
  if (head == NULL)
    return;
  head[0] = 8;
  head[1] = 0;
  cte_arguments *a = (void *)head;
  client_check(cte_element_evaluate(b.element, a) == CTE_ERROR_STRUCT_SIZE &&
                   cte_element_message(b.element, a, CTE_ERROR_STRUCT_SIZE, text, sizeof text) > 0 &&
                   client_contains(text, "struct_size"),
               "message with a short struct");
  free(head);
}

static cte_batch batch;
static double x[CONTACTS * N], f[CONTACTS * N], k[CONTACTS * N * N];
static int32_t status[CONTACTS], code[CONTACTS];

static void fresh(void)
{
  batch = (cte_batch)CTE_BATCH_INIT;
  for (int e = 0; e < CONTACTS; e++)
    memcpy(&x[e * N], b.x, N * sizeof x[0]);
  memset(f, 0x5a, sizeof f);
  memset(k, 0x5a, sizeof k);
  for (int e = 0; e < CONTACTS; e++)
    status[e] = code[e] = UNTOUCHED;
  batch.request = CTE_RESIDUAL | CTE_TANGENT;
  batch.parameter_count = b.info.parameters;
  batch.x = x;
  batch.parameters = b.parameters;
  batch.f = f;
  batch.k = k;
  batch.status = status;
  batch.code = code;
}

/* Refuses n contacts, touching nothing. */
static void refuse(const char *what, int64_t n, int32_t wanted, int32_t argument)
{
  const int32_t found = cte_element_evaluate_batch(b.element, n, &batch);
  const int untouched = status[0] == UNTOUCHED && code[0] == UNTOUCHED;
  if (!client_check(found == wanted && batch.error_argument == argument && batch.failed == 0 && untouched, what))
    printf("     code %d wanted %d, argument %d wanted %d\n", (int)found, (int)wanted, (int)batch.error_argument,
           (int)argument);
}

static void batch_sizes(void)
{
  const int64_t far = INT64_MAX;
  fresh();
  refuse("batch: contacts beyond any memory", far, CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
  refuse("batch: -1 contacts", -1, CTE_ERROR_INDEX, CTE_ARGUMENT_BATCH);
  fresh();
  batch.f_element_stride = far;
  refuse("batch: f stride beyond any memory", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_F);
  fresh();
  batch.k_element_stride = far / 2;
  refuse("batch: k stride beyond any memory", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE);
  fresh();
  batch.parameter_element_stride = b.info.parameters - 1;
  refuse("batch: parameters overlap", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_PARAMETERS);
  fresh();
  batch.x_node_stride = batch.x_component_stride = batch.x_element_stride = far;
  refuse("batch: x strides beyond any memory", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
  fresh();
  batch.x_node_stride = 3;
  refuse("batch: x strides half given", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
  fresh();
  batch.x_element_stride = N - 1;
  refuse("batch: x overlaps", CONTACTS, CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
}

/* The second contact is the first to fail; its slots stay as they were. */
static void batch_failures(void)
{
  double canary;
  memset(&canary, 0x5a, sizeof canary);
  fresh();
  client_special(0, &x[N + 4]);
  client_special(0, &x[2 * N]);
  const int32_t found = cte_element_evaluate_batch(b.element, CONTACTS, &batch);
  client_check(found == CTE_CUT_BACK && batch.failed == 2 && batch.error_argument == CTE_ARGUMENT_X &&
                   batch.error_index == 1,
               "batch: the first failing contact");
  client_check(code[0] == CTE_SUCCESS && status[0] == CTE_STATUS_CLOSED && code[1] == CTE_ERROR_NOT_FINITE &&
                   code[2] == CTE_ERROR_NOT_FINITE,
               "batch: a code for each");
  int same = !client_same(&f[0], &canary, 1) && !client_same(&k[0], &canary, 1);
  for (int i = N; i < CONTACTS * N; i++)
    same &= client_same(&f[i], &canary, 1);
  for (int i = N * N; i < CONTACTS * N * N; i++)
    same &= client_same(&k[i], &canary, 1);
  client_check(same, "batch: slots of failing contacts untouched");
  batch.x = batch.parameters = NULL;
  batch.status = NULL;
  client_check(cte_element_evaluate_batch(b.element, 0, &batch) == CTE_SUCCESS && batch.failed == 0,
               "batch: no contacts, no arrays");
  batch.error_argument = UNTOUCHED;
  client_check(cte_element_evaluate_batch(NULL, 0, &batch) == CTE_ERROR_NULL &&
                   batch.error_argument == CTE_ARGUMENT_ELEMENT,
               "batch: element null is named");
}

void bad_states(void)
{
  axes();
  no_area();
  folds();
  huge_forces();
  counts();
  strides();
  scalars();
  if (!bench_open(&b, "PointQuad4"))
    return;
  short_struct();
  batch_sizes();
  batch_failures();
}
