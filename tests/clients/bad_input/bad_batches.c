/* bad_batches.c - bad input to batches; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <stdio.h>
#include <string.h>

enum { CONTACTS = 2, NODES = 6, ROWS = 3 * NODES, UNKNOWNS = 15, ENTRIES = ROWS * ROWS };

/* The arrays a batch writes. */
typedef struct batch_outputs {
  double f[CONTACTS * UNKNOWNS], k[CONTACTS * UNKNOWNS * UNKNOWNS];
  double history_trial[CONTACTS * ROOM_HISTORY], output[CONTACTS * CTE_OUTPUT_SIZE], energy[CONTACTS];
  double global_f[ROWS], csr_values[ENTRIES];
  int32_t status[CONTACTS], code[CONTACTS];
} batch_outputs;

static bench b;
static cte_batch batch;
static batch_outputs out;
static double x[ROWS], u[ROWS], history_accepted[CONTACTS * ROOM_HISTORY];
static int32_t connectivity[CONTACTS * 5];
static int64_t row_start[ROWS + 1], map[CONTACTS * UNKNOWNS * UNKNOWNS];
static int32_t column[ENTRIES];

/* Two slave points (nodes 0 and 1) on one facet (nodes 2 to 5), and a full matrix for a pattern. */
static void lay_out(void)
{
  static const int32_t nodes[CONTACTS * 5] = {0, 2, 3, 4, 5, 1, 2, 3, 4, 5};
  memcpy(connectivity, nodes, sizeof nodes);
  memcpy(&x[3], b.x, 15 * sizeof x[0]);
  memcpy(x, b.x, 3 * sizeof x[0]);
  x[0] += 0.1;
  memset(u, 0, sizeof u);
  memset(history_accepted, 0, sizeof history_accepted);
  for (int i = 0; i <= ROWS; i++)
    row_start[i] = i * ROWS;
  for (int i = 0; i < ENTRIES; i++)
    column[i] = i % ROWS;
}

static void fresh(void)
{
  lay_out();
  batch = (cte_batch)CTE_BATCH_INIT;
  batch.request = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY;
  batch.parameter_count = b.info.parameters;
  batch.x = x;
  batch.u = u;
  batch.connectivity = connectivity;
  batch.global_nodes = NODES;
  batch.parameters = b.parameters;
  batch.history_accepted = history_accepted;
  batch.history_trial = out.history_trial;
  batch.f = out.f;
  batch.k = out.k;
  batch.global_f = out.global_f;
  batch.csr_values = out.csr_values;
  batch.csr_map = map;
  batch.output = out.output;
  batch.energy = out.energy;
  batch.status = out.status;
  batch.code = out.code;
  batch.workspace = b.workspace;
  batch.workspace_size = cte_element_batch_workspace(b.element, 0);
  memset(&out, 0x5a, sizeof out);
}

static int untouched(void)
{
  const unsigned char *byte = (const unsigned char *)&out;
  for (size_t i = 0; i < sizeof out; i++)
    if (byte[i] != 0x5a)
      return 0;
  return 1;
}

static void expect(const char *what, int32_t code, int32_t argument)
{
  const int32_t found = cte_element_evaluate_batch(b.element, CONTACTS, &batch);
  if (!client_check(found == code && batch.error_argument == argument && untouched(), what))
    printf("     code %d wanted %d, argument %d wanted %d, %s\n", (int)found, (int)code,
           (int)batch.error_argument, (int)argument, untouched() ? "untouched" : "arrays written");
}

/* The caller's fault in the last `failed` contacts: either the whole batch is refused and untouched, or
 * those alone have the code. */
static void expect_of_last(const char *what, int32_t code, int32_t argument, int failed)
{
  const int32_t found = cte_element_evaluate_batch(b.element, CONTACTS, &batch);
  const int refused = found == code && untouched();
  int alone = found == CTE_CUT_BACK && batch.failed == failed;
  for (int e = 0; e < CONTACTS; e++)
    alone &= out.code[e] == (e < CONTACTS - failed ? CTE_SUCCESS : code);
  client_check((refused || alone) && batch.error_argument == argument, what);
}

static void null_pointers(void)
{
  fresh();
  batch.x = NULL;
  expect("batch: x null", CTE_ERROR_NULL, CTE_ARGUMENT_X);
  fresh();
  batch.parameters = NULL;
  expect("batch: parameters null", CTE_ERROR_NULL, CTE_ARGUMENT_PARAMETERS);
  fresh();
  batch.status = NULL;
  expect("batch: status null", CTE_ERROR_NULL, CTE_ARGUMENT_STATUS);
  fresh();
  batch.f = batch.global_f = NULL;
  expect("batch: f and global_f null", CTE_ERROR_NULL, CTE_ARGUMENT_F);
  fresh();
  batch.k = batch.csr_values = NULL;
  expect("batch: k and csr_values null", CTE_ERROR_NULL, CTE_ARGUMENT_K);
  fresh();
  batch.csr_map = NULL;
  expect("batch: csr_map null", CTE_ERROR_NULL, CTE_ARGUMENT_CSR);
  batch.request |= CTE_CSR_BY_BLOCKS;
  expect("batch: csr_map of blocks null", CTE_ERROR_NULL, CTE_ARGUMENT_CSR);
  fresh();
  batch.history_trial = NULL;
  expect("batch: history_trial null", CTE_ERROR_NULL, CTE_ARGUMENT_HISTORY_TRIAL);
  fresh();
  batch.output = NULL;
  expect("batch: output null", CTE_ERROR_NULL, CTE_ARGUMENT_OUTPUT);
  fresh();
  batch.energy = NULL;
  expect("batch: energy null", CTE_ERROR_NULL, CTE_ARGUMENT_ENERGY);
}

static void struct_sizes(void)
{
  const uint32_t size[4] = {0, 8, sizeof batch - 1, 336}; /* the last: that of interface 0.1 */
  for (int i = 0; i < 4; i++) {
    fresh();
    batch.struct_size = size[i];
    const cte_batch before = batch;
    const int32_t found = cte_element_evaluate_batch(b.element, CONTACTS, &batch);
    client_check(found == CTE_ERROR_STRUCT_SIZE && memcmp(&before, &batch, sizeof batch) == 0 && untouched(),
                 client_text("batch: struct_size", (long)size[i]));
  }
}

static void counts(void)
{
  const int32_t wrong_node[4] = {-1, NODES, INT32_MAX, INT32_MIN};
  for (int i = 0; i < 4; i++) {
    fresh();
    connectivity[7] = wrong_node[i];
    expect(client_text("batch: connectivity", (long)wrong_node[i]), CTE_ERROR_INDEX, CTE_ARGUMENT_CONNECTIVITY);
  }
  fresh();
  batch.request |= 1024u;
  expect("batch: unknown request bit", CTE_ERROR_REQUEST, CTE_ARGUMENT_REQUEST);
  fresh();
  batch.nslave = 2;
  expect("batch: nslave", CTE_ERROR_NODE_COUNT, CTE_ARGUMENT_NSLAVE);
  fresh();
  batch.parameter_count = b.info.parameters - 1;
  expect_of_last("batch: one parameter too few", CTE_ERROR_PARAMETER, CTE_ARGUMENT_PARAMETERS, 2);
  fresh();
  if (batch.workspace_size > 0) {
    batch.workspace_size--;
    expect("batch: workspace too small", CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE);
  }
  fresh();
  client_check(cte_element_evaluate_batch(b.element, -1, &batch) < 0 && untouched(), "batch: -1 contacts");
  client_check(cte_element_evaluate_batch(NULL, CONTACTS, &batch) == CTE_ERROR_NULL && untouched(),
               "batch: element null");
  client_check(cte_element_evaluate_batch_threads(b.element, CONTACTS, &batch, -1) == CTE_ERROR_INDEX &&
                   batch.error_argument == CTE_ARGUMENT_THREADS && untouched(),
               "batch: -1 threads");
}

static void strides(void)
{
  fresh();
  batch.connectivity = NULL;
  batch.global_f = batch.csr_values = NULL;
  batch.x_element_stride = 15;
  batch.x_node_stride = -3;
  batch.x_component_stride = 1;
  expect("batch: x stride negative", CTE_ERROR_STRIDE, CTE_ARGUMENT_X);
  batch.x_node_stride = 3;
  batch.u_element_stride = -15;
  batch.u_node_stride = 3;
  batch.u_component_stride = 1;
  expect("batch: u stride negative", CTE_ERROR_STRIDE, CTE_ARGUMENT_U);
  fresh();
  batch.f_element_stride = UNKNOWNS - 1;
  expect("batch: f overlaps", CTE_ERROR_STRIDE, CTE_ARGUMENT_F);
  fresh();
  batch.f_element_stride = -UNKNOWNS;
  expect("batch: f stride negative", CTE_ERROR_STRIDE, CTE_ARGUMENT_F);
  fresh();
  batch.k_element_stride = UNKNOWNS * UNKNOWNS - 1;
  expect("batch: k overlaps", CTE_ERROR_STRIDE, CTE_ARGUMENT_K_STRIDE);
}

static void not_finite(void)
{
  for (int special = 0; special < CLIENT_SPECIALS; special++) {
    fresh();
    client_special(special, &x[4]); /* node 1: the slave of the second contact */
    expect_of_last(client_text("batch: not finite in x", special), CTE_ERROR_NOT_FINITE, CTE_ARGUMENT_X, 1);
  }
}

void bad_batches(void)
{
  if (!bench_open(&b, "PointQuad4"))
    return;
  lay_out();
  client_check(cte_csr_map(b.element, CONTACTS, 0, connectivity, ROWS, row_start, column, map) == CTE_SUCCESS,
               "csr_map of the sound batch");
  fresh();
  client_check(cte_element_evaluate_batch(b.element, CONTACTS, &batch) == CTE_SUCCESS, "the sound batch");
  null_pointers();
  struct_sizes();
  counts();
  strides();
  not_finite();
}
