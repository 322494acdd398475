/* interface_multiplier_batch.c - a batch of elements with multipliers as unknowns against single calls, bit for bit.
 *
 * A strip of facets with one slave above each, and a node for the multiplier of each, of which the host's system has
 * one row: the other two are in no pattern.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <string.h>

enum {
  CONTACTS = 7,
  N = 16,                           /* unknowns of an element */
  PER = 6,                          /* its nodes */
  SLAVES = 2 * (CONTACTS + 1),      /* first node of the slaves, behind those of the facets */
  MULTIPLIERS = SLAVES + CONTACTS,  /* first node of the multipliers */
  NODES = MULTIPLIERS + CONTACTS,
  ROWS = 3 * NODES,
  HISTORY = 3
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
static int32_t connectivity[CONTACTS][PER];

/* Slaves in the facets, over them, one beside; multipliers of both signs. Entries that are not read are NaN. */
static void lay_out(void)
{
  for (int e = 0; e <= CONTACTS; e++)
    for (int side = 0; side < 2; side++) {
      x[2 * e + side][0] = e;
      x[2 * e + side][1] = side;
    }
  for (int i = 0; i < MULTIPLIERS; i++)
    for (int c = 0; c < 3; c++)
      u[i][c] = 0.02 * (client_random() - 0.5);
  for (int e = 0; e < CONTACTS; e++) {
    const int32_t nodes[PER] = {SLAVES + e, 2 * e, 2 * e + 2, 2 * e + 3, 2 * e + 1, MULTIPLIERS + CONTACTS - 1 - e};
    double *slave = x[SLAVES + e], *node = u[nodes[PER - 1]];
    memcpy(connectivity[e], nodes, sizeof nodes);
    slave[0] = e + (e == 5 ? 1.5 : 0.4);
    slave[1] = 0.6;
    slave[2] = e % 3 == 2 ? 0.1 : -0.05;
    for (int c = 0; c < 3; c++) {
      client_special(1, &x[nodes[PER - 1]][c]);
      client_special(1, &node[c]);
    }
    node[0] = e == 3 ? 20.0 : -4.0 - e; /* contact 3 is pulled open */
    cte_element_history_init(b.element, history_accepted[e]);
  }
}

/* Every contact by itself, from its own dense arrays. */
static int single_calls(void)
{
  static const int32_t status[CONTACTS] = {CTE_STATUS_CLOSED, CTE_STATUS_CLOSED, CTE_STATUS_OPEN, CTE_STATUS_OPEN,
                                           CTE_STATUS_CLOSED, CTE_STATUS_OUTSIDE, CTE_STATUS_CLOSED};
  int pass = 1;
  for (int e = 0; e < CONTACTS; e++) {
    for (int a = 0; a < PER; a++) {
      memcpy(&b.x[3 * a], x[connectivity[e][a]], sizeof x[0]);
      memcpy(&b.u[3 * a], u[connectivity[e][a]], sizeof u[0]);
    }
    b.a.history_accepted = history_accepted[e];
    b.a.f = single.f[e];
    b.a.k = single.k[e];
    b.a.history_trial = single.history_trial[e];
    b.a.output = single.output[e];
    b.a.energy = &single.energy[e];
    pass &= bench_evaluate(&b) == CTE_SUCCESS && b.a.status == status[e];
    single.status[e] = b.a.status;
    single.code[e] = CTE_SUCCESS;
  }
  return pass;
}

static void fresh(void)
{
  batch = (cte_batch)CTE_BATCH_INIT;
  memset(&many, 0x5a, sizeof many);
  batch.request = b.a.request;
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
}

static int evaluated(void)
{
  return cte_element_batch_workspace(b.element, 0) == 0 &&
         cte_element_evaluate_batch(b.element, CONTACTS, &batch) == CTE_SUCCESS && batch.failed == 0;
}

static void arrays(void)
{
  static double dense[2][CONTACTS][PER][3];
  fresh();
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "multiplier batch: gathered by connectivity");
  for (int e = 0; e < CONTACTS; e++)
    for (int a = 0; a < PER; a++) {
      memcpy(dense[0][e][a], x[connectivity[e][a]], sizeof x[0]);
      memcpy(dense[1][e][a], u[connectivity[e][a]], sizeof u[0]);
    }
  fresh();
  batch.connectivity = NULL;
  batch.x = &dense[0][0][0][0];
  batch.u = &dense[1][0][0][0];
  client_check(evaluated() && memcmp(&many, &single, sizeof many) == 0, "multiplier batch: dense arrays");
}

/* Row of an element's unknown in the host's system: node * dimension + component, of multipliers component 0. */
static int row_of(int e, int unknown)
{
  return unknown < N - 1 ? 3 * connectivity[e][unknown / 3] + unknown % 3 : 3 * connectivity[e][PER - 1];
}

/* Pattern of all contacts: [rows][...] sorted. */
static void pattern(int64_t row_start[ROWS + 1], int32_t column[ROWS * ROWS])
{
  static char together[ROWS][ROWS];
  int64_t entries = 0;
  for (int e = 0; e < CONTACTS; e++)
    for (int i = 0; i < N; i++)
      for (int j = 0; j < N; j++)
        together[row_of(e, i)][row_of(e, j)] = 1;
  for (int row = 0; row < ROWS; row++) {
    row_start[row] = entries;
    for (int col = 0; col < ROWS; col++)
      if (together[row][col])
        column[entries++] = col;
  }
  row_start[ROWS] = entries;
}

/* The same sums by hand, element after element. */
static void assemble(double global_f[ROWS], double global_k[ROWS][ROWS])
{
  for (int e = 0; e < CONTACTS; e++)
    for (int i = 0; i < N; i++) {
      global_f[row_of(e, i)] += single.f[e][i];
      for (int j = 0; j < N; j++)
        global_k[row_of(e, i)][row_of(e, j)] += single.k[e][i * N + j];
    }
}

/* The first entry of each block and the distance of its rows give every place of the map; a multiplier has one row. */
static int same_places(int64_t map[CONTACTS][N][N], int64_t blocks[CONTACTS][PER][PER + 1])
{
  int pass = 1;
  for (int e = 0; e < CONTACTS; e++) {
    for (int i = 0; i < N; i++)
      for (int j = 0; j < N; j++) {
        const int64_t *node = blocks[e][i / 3];
        pass &= map[e][i][j] == node[j / 3] + i % 3 * node[PER] + j % 3;
      }
    pass &= blocks[e][PER - 1][PER] == 0;
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
  for (int e = 0; e < CONTACTS; e++)
    for (int c = 1; c < 3; c++)
      pass &= global_f[1][3 * (MULTIPLIERS + e) + c] == 1.0;
  return pass;
}

static void other_outputs(void)
{
  client_check(memcmp(many.history_trial, single.history_trial, sizeof many.history_trial) == 0 &&
                   memcmp(many.output, single.output, sizeof many.output) == 0 &&
                   memcmp(many.energy, single.energy, sizeof many.energy) == 0,
               "multiplier batch: scattered, the other outputs");
}

/* Into values of the host, by either map. */
static void scattered(void)
{
  static double global_f[2][ROWS], global_k[ROWS][ROWS];
  static int64_t row_start[ROWS + 1], map[CONTACTS][N][N], blocks[CONTACTS][PER][PER + 1];
  static int32_t column[ROWS * ROWS];
  pattern(row_start, column);
  int pass = row_start[3 * MULTIPLIERS + 2] == row_start[3 * MULTIPLIERS + 1] &&
             cte_csr_map(b.element, CONTACTS, 0, &connectivity[0][0], ROWS, row_start, column, &map[0][0][0]) ==
                 CTE_SUCCESS;
  client_check(pass, "multiplier batch: csr_map with one row per multiplier");
  pass = pass &&
         cte_csr_blocks(b.element, CONTACTS, 0, &connectivity[0][0], ROWS, row_start, column, &blocks[0][0][0]) ==
             CTE_SUCCESS &&
         same_places(map, blocks);
  client_check(pass, "multiplier batch: csr_blocks, the places of csr_map");
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
  client_check(scatters(row_start, column, global_f, global_k),
               "multiplier batch: scattered into vector and CSR matrix");
  other_outputs();
  fresh();
  batch.csr_map = &blocks[0][0][0];
  batch.request |= CTE_CSR_BY_BLOCKS;
  client_check(scatters(row_start, column, global_f, global_k), "multiplier batch: scattered by blocks of nodes");
  other_outputs();
}

void interface_multiplier_batch(void)
{
  if (!bench_open(&b, "PointQuad4Multiplier"))
    return;
  lay_out();
  client_check(b.info.history == HISTORY && single_calls(), "multiplier batch: the single calls");
  arrays();
  scattered();
}
