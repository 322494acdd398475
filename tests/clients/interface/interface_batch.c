/* interface_batch.c - batches in every layout against single calls, bit for bit.
 *
 * A strip of facets with one slave point above each; some are closed, some open, one is outside.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <stdio.h>
#include <string.h>

enum {
  CONTACTS = 7,
  N = 15,                                  /* unknowns of an element */
  STRIP_NODES = 2 * (CONTACTS + 1),        /* nodes of the facets */
  NODES = STRIP_NODES + CONTACTS,          /* and the slaves */
  ROWS = 3 * NODES,
  HISTORY = 3,
  REQUEST = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY
};

typedef struct results {
  double f[CONTACTS][N], k[CONTACTS][N * N];
  double history_trial[CONTACTS][HISTORY], output[CONTACTS][CTE_OUTPUT_SIZE], energy[CONTACTS];
  int32_t status[CONTACTS], code[CONTACTS];
} results;

static bench b;
static cte_batch batch;
static results single, many;
static double x[NODES][3], u[NODES][3], history_accepted[CONTACTS][HISTORY];
static int32_t connectivity[CONTACTS][5];
static double workspace[ROOM_WORKSPACE];

static void lay_out(void)
{
  for (int i = 0; i < NODES; i++)
    for (int c = 0; c < 3; c++)
      u[i][c] = 0.02 * (client_random() - 0.5);
  for (int e = 0; e <= CONTACTS; e++)
    for (int side = 0; side < 2; side++) {
      double *node = x[2 * e + side];
      node[0] = e;
      node[1] = side;
      node[2] = 0.0;
    }
  for (int e = 0; e < CONTACTS; e++) {
    const int32_t nodes[5] = {STRIP_NODES + e, 2 * e, 2 * e + 2, 2 * e + 3, 2 * e + 1};
    double *slave = x[STRIP_NODES + e];
    memcpy(connectivity[e], nodes, sizeof nodes);
    slave[0] = e + (e == 5 ? 1.5 : 0.4);
    slave[1] = 0.6;
    slave[2] = e % 3 == 2 ? 0.1 : -0.05;
    cte_element_history_init(b.element, history_accepted[e]);
  }
}

/* Every contact by itself, from its own dense arrays. */
static int single_calls(void)
{
  int pass = 1;
  for (int e = 0; e < CONTACTS; e++) {
    for (int a = 0; a < 5; a++) {
      memcpy(&b.x[3 * a], x[connectivity[e][a]], sizeof x[0]);
      memcpy(&b.u[3 * a], u[connectivity[e][a]], sizeof u[0]);
    }
    b.a.history_accepted = history_accepted[e];
    b.a.f = single.f[e];
    b.a.k = single.k[e];
    b.a.history_trial = single.history_trial[e];
    b.a.output = single.output[e];
    b.a.energy = &single.energy[e];
    pass &= bench_evaluate(&b) == CTE_SUCCESS;
    single.status[e] = b.a.status;
    single.code[e] = CTE_SUCCESS;
  }
  return pass && single.status[0] == CTE_STATUS_CLOSED && single.status[2] == CTE_STATUS_OPEN &&
         single.status[5] == CTE_STATUS_OUTSIDE;
}

/* One call has no scatter map: the bit that says which changes nothing. */
static void one_call(void)
{
  const int last = CONTACTS - 1;
  b.a.request |= CTE_CSR_BY_BLOCKS;
  b.a.f = many.f[last];
  b.a.k = many.k[last];
  client_check(bench_evaluate(&b) == CTE_SUCCESS && client_same(many.f[last], single.f[last], N) &&
                   client_same(many.k[last], single.k[last], N * N),
               "CTE_CSR_BY_BLOCKS has no effect on one call");
}

static void fresh(void)
{
  batch = (cte_batch)CTE_BATCH_INIT;
  memset(&many, 0x5a, sizeof many);
  batch.request = REQUEST;
  batch.parameter_count = b.info.parameters;
  batch.x = &x[0][0];
  batch.u = &u[0][0];
  batch.connectivity = &connectivity[0][0];
  batch.global_nodes = NODES;
  batch.parameters = b.parameters;
  batch.history_accepted = &history_accepted[0][0];
  batch.history_trial = &many.history_trial[0][0];
  batch.f = &many.f[0][0];
  batch.k = &many.k[0][0];
  batch.output = &many.output[0][0];
  batch.energy = many.energy;
  batch.status = many.status;
  batch.code = many.code;
  batch.workspace = workspace;
  batch.workspace_size = cte_element_batch_workspace(b.element, 0);
}

static int evaluated(void)
{
  return batch.workspace_size <= ROOM_WORKSPACE &&
         cte_element_evaluate_batch(b.element, CONTACTS, &batch) == CTE_SUCCESS && batch.failed == 0 &&
         batch.error_argument == CTE_ARGUMENT_NONE;
}

static void gathered(void)
{
  fresh();
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "batch: gathered by connectivity");
  for (int32_t threads = 0; threads < 3; threads++) {
    fresh();
    client_check(cte_element_evaluate_batch_threads(b.element, CONTACTS, &batch, threads) == CTE_SUCCESS &&
                     batch.failed == 0 && memcmp(&many, &single, sizeof many) == 0,
                 "batch: by threads");
  }
  fresh();
  batch.x_node_stride = batch.u_node_stride = 1; /* component by component */
  batch.x_component_stride = batch.u_component_stride = NODES;
  double by_component[2][3][NODES];
  for (int i = 0; i < NODES; i++)
    for (int c = 0; c < 3; c++) {
      by_component[0][c][i] = x[i][c];
      by_component[1][c][i] = u[i][c];
    }
  batch.x = &by_component[0][0][0];
  batch.u = &by_component[1][0][0];
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "batch: gathered, components apart");
}

/* Dense [element][node][component], then the element index fastest. */
static void arrays(void)
{
  static double dense[2][CONTACTS][5][3], fastest[2][5][3][CONTACTS];
  for (int e = 0; e < CONTACTS; e++)
    for (int a = 0; a < 5; a++)
      for (int c = 0; c < 3; c++) {
        fastest[0][a][c][e] = dense[0][e][a][c] = x[connectivity[e][a]][c];
        fastest[1][a][c][e] = dense[1][e][a][c] = u[connectivity[e][a]][c];
      }
  fresh();
  batch.connectivity = NULL;
  batch.x = &dense[0][0][0][0];
  batch.u = &dense[1][0][0][0];
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "batch: dense arrays");
  fresh();
  batch.connectivity = NULL;
  batch.x = &fastest[0][0][0][0];
  batch.u = &fastest[1][0][0][0];
  batch.x_element_stride = batch.u_element_stride = 1;
  batch.x_node_stride = batch.u_node_stride = 3 * CONTACTS;
  batch.x_component_stride = batch.u_component_stride = CONTACTS;
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "batch: element index fastest");
}

/* Every contact its own penalty: a factor 2 in every other one, which is exact. */
static void own_parameters(void)
{
  static double parameters[CONTACTS][ROOM_PARAMETERS];
  const int eps_n = bench_parameter(&b, "eps_n");
  fresh();
  for (int e = 0; e < CONTACTS; e++) {
    memcpy(parameters[e], b.parameters, sizeof b.parameters);
    parameters[e][eps_n] *= 1 + e % 2;
  }
  batch.parameters = &parameters[0][0];
  batch.parameter_element_stride = ROOM_PARAMETERS;
  const int pass = evaluated();
  for (int e = 1; e < CONTACTS; e += 2) {
    for (int i = 0; i < N; i++)
      many.f[e][i] /= 2.0;
    for (int i = 0; i < N * N; i++)
      many.k[e][i] /= 2.0;
    many.output[e][CTE_OUTPUT_NORMAL_TRACTION] /= 2.0;
    many.energy[e] /= 2.0;
  }
  client_check(pass && memcmp(&many, &single, sizeof many) == 0, "batch: own parameters");
}

/* Room between the outputs of two elements, scaled. */
static void spaced(void)
{
  static double f[CONTACTS][N + 2], k[CONTACTS][N * N + 3];
  int pass;
  fresh();
  batch.f = &f[0][0];
  batch.k = &k[0][0];
  batch.f_element_stride = N + 2;
  batch.k_element_stride = N * N + 3;
  batch.f_scale = -1.0;
  batch.k_scale = -0.5;
  memset(f, 0x5a, sizeof f);
  memset(k, 0x5a, sizeof k);
  const double canary = f[0][0];
  pass = evaluated();
  for (int e = 0; e < CONTACTS; e++) {
    for (int i = 0; i < N; i++)
      pass &= f[e][i] == -single.f[e][i];
    for (int i = 0; i < N * N; i++)
      pass &= k[e][i] == -0.5 * single.k[e][i];
    pass &= client_same(&f[e][N + 1], &canary, 1) && client_same(&k[e][N * N + 2], &canary, 1);
  }
  client_check(pass, "batch: output strides, f_scale -1, k_scale -1/2");
  batch.f_scale = 0.0;
  batch.k_scale = 0.0;
  pass = evaluated();
  for (int e = 0; e < CONTACTS; e++) {
    for (int i = 0; i < N; i++)
      pass &= f[e][i] == 0.0;
    for (int i = 0; i < N * N; i++)
      pass &= k[e][i] == 0.0;
  }
  client_check(pass, "batch: scales of 0 give zeros");
}

/* Pattern of all contacts: [rows][...] sorted. */
static void pattern(int64_t row_start[ROWS + 1], int32_t column[ROWS * ROWS])
{
  static char together[NODES][NODES];
  int64_t entries = 0;
  for (int e = 0; e < CONTACTS; e++)
    for (int a = 0; a < 5; a++)
      for (int c = 0; c < 5; c++)
        together[connectivity[e][a]][connectivity[e][c]] = 1;
  for (int row = 0; row < ROWS; row++) {
    row_start[row] = entries;
    for (int col = 0; col < ROWS; col++)
      if (together[row / 3][col / 3])
        column[entries++] = col;
  }
  row_start[ROWS] = entries;
}

/* The same sums by hand, element after element. */
static void assemble(double global_f[ROWS], double global_k[ROWS][ROWS])
{
  for (int e = 0; e < CONTACTS; e++)
    for (int i = 0; i < N; i++) {
      const int row = 3 * connectivity[e][i / 3] + i % 3;
      global_f[row] += single.f[e][i];
      for (int j = 0; j < N; j++)
        global_k[row][3 * connectivity[e][j / 3] + j % 3] += single.k[e][i * N + j];
    }
}

/* The first entry of each block and the distance of its rows give every place of the map. */
static int same_places(int64_t map[CONTACTS][N][N], int64_t blocks[CONTACTS][5][6])
{
  int pass = 1;
  for (int e = 0; e < CONTACTS; e++)
    for (int i = 0; i < N; i++)
      for (int j = 0; j < N; j++) {
        const int64_t *node = blocks[e][i / 3];
        pass &= map[e][i][j] == node[j / 3] + i % 3 * node[5] + j % 3;
      }
  return pass;
}

/* The batch into values of the host, which are to be those of global_k and the first row of global_f. */
static int scatters(const int64_t row_start[ROWS + 1], const int32_t column[ROWS * ROWS], double global_f[2][ROWS],
                    double global_k[ROWS][ROWS])
{
  static double values[ROWS * ROWS];
  for (int i = 0; i < ROWS; i++)
    global_f[1][i] = 1.0;
  for (int64_t i = 0; i < row_start[ROWS]; i++)
    values[i] = 2.0;
  batch.f = batch.k = NULL;
  batch.global_f = global_f[1];
  batch.csr_values = values;
  int pass = evaluated() && client_same(global_f[0], global_f[1], ROWS);
  for (int row = 0; row < ROWS; row++)
    for (int64_t i = row_start[row]; i < row_start[row + 1]; i++)
      pass &= client_same(&values[i], &global_k[row][column[i]], 1);
  return pass;
}

static void other_outputs(void)
{
  client_check(memcmp(many.history_trial, single.history_trial, sizeof many.history_trial) == 0 &&
                   memcmp(many.output, single.output, sizeof many.output) == 0 &&
                   memcmp(many.energy, single.energy, sizeof many.energy) == 0,
               "batch: scattered, the other outputs");
}

/* Into values of the host, by either map. */
static void scattered(void)
{
  static double global_f[2][ROWS], global_k[ROWS][ROWS];
  static int64_t row_start[ROWS + 1], map[CONTACTS][N][N], blocks[CONTACTS][5][6];
  static int32_t column[ROWS * ROWS];
  pattern(row_start, column);
  int pass = cte_csr_map(b.element, CONTACTS, 0, &connectivity[0][0], ROWS, row_start, column, &map[0][0][0]) ==
             CTE_SUCCESS;
  client_check(pass, "csr_map");
  pass = pass &&
         cte_csr_blocks(b.element, CONTACTS, 0, &connectivity[0][0], ROWS, row_start, column, &blocks[0][0][0]) ==
             CTE_SUCCESS &&
         same_places(map, blocks);
  client_check(pass, "csr_blocks: the places of csr_map");
  if (!pass)
    return;
  for (int row = 0; row < ROWS; row++) {
    global_f[0][row] = 1.0; /* what the host has already */
    for (int64_t i = row_start[row]; i < row_start[row + 1]; i++)
      global_k[row][column[i]] = 2.0;
  }
  assemble(global_f[0], global_k);
  fresh();
  batch.csr_map = &map[0][0][0];
  client_check(scatters(row_start, column, global_f, global_k), "batch: scattered into vector and CSR matrix");
  other_outputs();
  fresh();
  batch.csr_map = &blocks[0][0][0];
  batch.request |= CTE_CSR_BY_BLOCKS;
  client_check(scatters(row_start, column, global_f, global_k), "batch: scattered by blocks of nodes");
  other_outputs();
}

/* One contact that cannot be evaluated leaves the others valid. */
static void one_failure(void)
{
  fresh();
  double kept[3];
  memcpy(kept, x[STRIP_NODES + 1], sizeof kept);
  static double dense[CONTACTS][5][3], shift[CONTACTS][5][3];
  for (int e = 0; e < CONTACTS; e++)
    for (int a = 0; a < 5; a++) {
      memcpy(dense[e][a], x[connectivity[e][a]], sizeof kept);
      memcpy(shift[e][a], u[connectivity[e][a]], sizeof kept);
    }
  for (int a = 1; a < 5; a++) { /* the facet of contact 1 shrinks to a point */
    memcpy(dense[1][a], dense[1][1], sizeof kept);
    memcpy(shift[1][a], shift[1][1], sizeof kept);
  }
  batch.connectivity = NULL;
  batch.x = &dense[0][0][0];
  batch.u = &shift[0][0][0];
  const int32_t code = cte_element_evaluate_batch(b.element, CONTACTS, &batch);
  int pass = code == CTE_CUT_BACK && batch.failed == 1 && many.code[1] == CTE_CUT_BACK &&
             (many.status[1] == CTE_STATUS_DEGENERATE || many.status[1] == CTE_STATUS_NOT_UNIQUE);
  for (int e = 0; e < CONTACTS; e++)
    if (e != 1)
      pass &= many.code[e] == CTE_SUCCESS && many.status[e] == single.status[e] &&
              client_same(many.f[e], single.f[e], N) && client_same(many.k[e], single.k[e], N * N) &&
              client_same(many.history_trial[e], single.history_trial[e], HISTORY);
  client_check(pass, "batch: one contact fails, the others are valid");
}

void interface_batch(void)
{
  if (!bench_open(&b, "PointQuad4"))
    return;
  lay_out();
  client_check(b.info.history == HISTORY && single_calls(), "batch: the single calls");
  one_call();
  gathered();
  arrays();
  own_parameters();
  spaced();
  scattered();
  one_failure();
  fresh();
  client_check(cte_element_evaluate_batch(b.element, 0, &batch) == CTE_SUCCESS && batch.failed == 0,
               "batch: no contacts");
}
