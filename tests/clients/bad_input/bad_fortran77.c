/* bad_fortran77.c - the Fortran 77 entries with a null address in the place of every argument: a code, and the name
 * of the argument where the entry has one to give; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <string.h>

enum {
  UNKNOWNS = 15,
  ARGUMENTS = 40,
  UNTOUCHED = -77,
  ACCEPTED = -1, /* null is allowed there, or not looked at */
  UNSEEN = -2    /* the code itself */
};

static bench b;

/* One contact of InterpolatedQuad4 with one slave node. */
static int32_t element, request, code, found, zero = 0, one = 1, nslave = 1, nodes = 5, unknowns = UNKNOWNS;
static int32_t room, into = CTE_F77_INTO_GLOBAL, statuses, codes, length = 10;
static int32_t map[UNKNOWNS], sizes[CTE_F77_SIZES], state[CTE_F77_STATES];
static int32_t patch[CTE_F77_PATCHES], facet[4] = {0, 1, 2, 3}, contact[5] = {0, 1, 2, 3, 4};
static int32_t name[10], column[UNKNOWNS * UNKNOWNS];
static int64_t place[UNKNOWNS * UNKNOWNS], new_place[UNKNOWNS * UNKNOWNS], row_start[UNKNOWNS + 1];
static double scale = 1.0, reach = 0.0, sum_f[UNKNOWNS], sum_k[UNKNOWNS * UNKNOWNS];

static void evaluate(void *const p[])
{
  cte_f77_evaluate_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], p[13],
                    p[14], p[15], p[16], p[17], p[18], p[19], p[20], p[21], p[22], p[23], p[24], p[25]);
}

static void project(void *const p[])
{
  cte_f77_project_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], p[13],
                   p[14]);
}

static void patch_info(void *const p[])
{
  cte_f77_patch_info_(p[0], p[1], p[2], p[3], p[4], p[5]);
}

static void patch_evaluate(void *const p[])
{
  cte_f77_patch_evaluate_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12],
                          p[13], p[14], p[15], p[16], p[17], p[18], p[19], p[20], p[21], p[22], p[23], p[24],
                          p[25]);
}

static void batch(void *const p[])
{
  cte_f77_batch_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], p[12], p[13],
                 p[14], p[15], p[16], p[17], p[18], p[19], p[20], p[21], p[22], p[23], p[24], p[25], p[26],
                 p[27], p[28], p[29], p[30], p[31]);
}

static void find(void *const p[])
{
  cte_f77_find_(p[0], p[1], p[2], p[3]);
}

static void info(void *const p[])
{
  cte_f77_info_(p[0], p[1], p[2], p[3]);
}

static void csr_map(void *const p[])
{
  cte_f77_csr_map_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]);
}

static void csr_blocks(void *const p[])
{
  cte_f77_csr_blocks_(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]);
}

/* Nothing of the caller's arrays has changed. */
static int untouched(void)
{
  int pass = bench_untouched(&b) && found == UNTOUCHED;
  for (int i = 0; i < UNKNOWNS; i++)
    pass &= sum_f[i] == 0.0 && new_place[i] == UNTOUCHED;
  for (int i = 0; i < UNKNOWNS * UNKNOWNS; i++)
    pass &= sum_k[i] == 0.0;
  return pass;
}

static void fresh(void)
{
  bench_canary(&b);
  code = found = UNTOUCHED;
  for (int i = 0; i < CTE_F77_STATES; i++)
    state[i] = UNTOUCHED;
  for (int i = 0; i < UNKNOWNS * UNKNOWNS; i++) {
    sum_k[i] = 0.0;
    new_place[i] = UNTOUCHED;
  }
  for (int i = 0; i < UNKNOWNS; i++)
    sum_f[i] = 0.0;
}

/* Each of the addresses null in turn. */
static void nulls(const char *what, void (*door)(void *const *), void *const p[], const int32_t expected[], size_t count)
{
  void *q[ARGUMENTS];
  for (size_t i = 0; i < count; i++) {
    int pass;
    memcpy(q, p, count * sizeof p[0]);
    q[i] = NULL;
    fresh();
    door(q);
    if (expected[i] == ACCEPTED)
      pass = code == CTE_SUCCESS;
    else if (expected[i] == UNSEEN)
      pass = code == UNTOUCHED;
    else
      pass = code == CTE_ERROR_NULL && untouched() &&
             (expected[i] == CTE_ARGUMENT_NONE || state[CTE_F77_STATE_ARGUMENT] == expected[i]);
    client_check(pass, client_text(what, (long)i));
  }
}

static void evaluate_nulls(void)
{
  void *p[] = {
      &element, &request, &zero, &nslave, b.x, &zero, b.u, &zero, b.parameters, &b.info.parameters,
      b.history_accepted, b.out.history_trial, b.row, &one, map, &scale, &scale, b.out.f, b.out.k, &unknowns,
      b.out.output, b.out.energy, b.workspace, &room, state, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_NNODE, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_X,
      CTE_ARGUMENT_X, ACCEPTED, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, ACCEPTED,
      CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_UNKNOWN_MAP,
      CTE_ARGUMENT_SCALE, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_F, CTE_ARGUMENT_K, CTE_ARGUMENT_K_STRIDE,
      CTE_ARGUMENT_OUTPUT, CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_WORKSPACE, CTE_ARGUMENT_WORKSPACE, ACCEPTED,
      UNSEEN};
  nulls("F77 evaluate", evaluate, p, expected, sizeof expected / sizeof expected[0]);
}

static void project_nulls(void)
{
  void *p[] = {
      &element, &zero, &nslave, b.x, &zero, b.u, &zero, b.parameters, &b.info.parameters, b.row, &reach,
      b.out.output, b.out.history_trial, state, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_NNODE, CTE_ARGUMENT_NSLAVE, CTE_ARGUMENT_X, CTE_ARGUMENT_X, ACCEPTED,
      CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_SLAVE_ROW,
      CTE_ARGUMENT_REACH, CTE_ARGUMENT_RESULT, ACCEPTED, ACCEPTED, UNSEEN};
  nulls("F77 project", project, p, expected, sizeof expected / sizeof expected[0]);
}

static void patch_info_nulls(void)
{
  void *p[] = {
      patch, facet, &reach, sizes, &state[CTE_F77_STATE_ARGUMENT], &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_PATCH, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_REACH, CTE_ARGUMENT_INFO, ACCEPTED, UNSEEN};
  nulls("F77 patch_info", patch_info, p, expected, sizeof expected / sizeof expected[0]);
}

static void patch_evaluate_nulls(void)
{
  void *p[] = {
      patch, facet, &reach, &request, &zero, b.x, &zero, b.u, &zero, b.parameters, &b.info.parameters,
      b.history_accepted, b.out.history_trial, &one, map, &scale, &scale, b.out.f, b.out.k, &unknowns,
      b.out.output, b.out.energy, b.workspace, &room, state, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_PATCH, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_REACH, CTE_ARGUMENT_REQUEST,
      CTE_ARGUMENT_NNODE, CTE_ARGUMENT_X, CTE_ARGUMENT_X, ACCEPTED, CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS,
      CTE_ARGUMENT_PARAMETERS, ACCEPTED, CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_UNKNOWN_MAP,
      CTE_ARGUMENT_UNKNOWN_MAP, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_SCALE, CTE_ARGUMENT_F, CTE_ARGUMENT_K,
      CTE_ARGUMENT_K_STRIDE, CTE_ARGUMENT_OUTPUT, CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_WORKSPACE,
      CTE_ARGUMENT_WORKSPACE, ACCEPTED, UNSEEN};
  nulls("F77 patch_evaluate", patch_evaluate, p, expected, sizeof expected / sizeof expected[0]);
}

static void batch_nulls(void)
{
  void *p[] = {
      &element, &one, &request, &nslave, &nodes, contact, b.x, &zero, b.u, &zero, b.parameters,
      &b.info.parameters, &zero, b.history_accepted, b.out.history_trial, b.row, &into, &scale, &scale,
      b.out.f, b.out.k, sum_f, sum_k, place, b.out.output, b.out.energy, &statuses, &codes, b.workspace,
      &room, state, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_ELEMENT, CTE_ARGUMENT_BATCH, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_NSLAVE,
      CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_CONNECTIVITY, CTE_ARGUMENT_X, CTE_ARGUMENT_X, ACCEPTED,
      CTE_ARGUMENT_U, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, CTE_ARGUMENT_PARAMETERS, ACCEPTED,
      CTE_ARGUMENT_HISTORY_TRIAL, CTE_ARGUMENT_SLAVE_ROW, CTE_ARGUMENT_REQUEST, CTE_ARGUMENT_SCALE,
      CTE_ARGUMENT_SCALE, ACCEPTED, ACCEPTED, CTE_ARGUMENT_F, CTE_ARGUMENT_K, CTE_ARGUMENT_CSR,
      CTE_ARGUMENT_OUTPUT, CTE_ARGUMENT_ENERGY, CTE_ARGUMENT_STATUS, ACCEPTED, CTE_ARGUMENT_WORKSPACE,
      CTE_ARGUMENT_WORKSPACE, ACCEPTED, UNSEEN};
  nulls("F77 batch", batch, p, expected, sizeof expected / sizeof expected[0]);
}

static void find_nulls(void)
{
  void *p[] = {
      name, &length, &found, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, UNSEEN};
  nulls("F77 find", find, p, expected, sizeof expected / sizeof expected[0]);
}

static void info_nulls(void)
{
  void *p[] = {
      &element, &zero, sizes, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, UNSEEN};
  nulls("F77 info", info, p, expected, sizeof expected / sizeof expected[0]);
}

static void csr_map_nulls(void)
{
  void *p[] = {
      &element, &one, &nslave, contact, &unknowns, row_start, column, new_place, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE,
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, UNSEEN};
  nulls("F77 csr_map", csr_map, p, expected, sizeof expected / sizeof expected[0]);
}

static void csr_blocks_nulls(void)
{
  void *p[] = {
      &element, &one, &nslave, contact, &unknowns, row_start, column, new_place, &code};
  static const int32_t expected[] = {
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE,
      CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, CTE_ARGUMENT_NONE, UNSEEN};
  nulls("F77 csr_blocks", csr_blocks, p, expected, sizeof expected / sizeof expected[0]);
}

/* An index that no element has, in every place that takes one. */
static void indices(void)
{
  int32_t wrong = cte_element_count(), argument = UNTOUCHED;
  fresh();
  patch[CTE_F77_PATCH_EDGE] = wrong;
  cte_f77_patch_info_(patch, facet, &reach, sizes, &argument, &code);
  client_check(code == CTE_ERROR_INDEX && argument == CTE_ARGUMENT_EDGE && sizes[CTE_F77_SIZE_POINTS] == -1,
               "F77 patch_info, edge");
  patch[CTE_F77_PATCH_EDGE] = -1;
  patch[CTE_F77_PATCH_FACET] = -1;
  cte_f77_patch_info_(patch, facet, &reach, sizes, &argument, &code);
  client_check(code == CTE_ERROR_INDEX && argument == CTE_ARGUMENT_FACET, "F77 patch_info, facet");
  cte_f77_info_(&wrong, &zero, sizes, &code);
  client_check(code == CTE_ERROR_INDEX && sizes[CTE_F77_SIZE_UNKNOWNS] == -1, "F77 info, element");
  cte_f77_csr_map_(&wrong, &one, &nslave, contact, &unknowns, row_start, column, new_place, &code);
  client_check(code == CTE_ERROR_INDEX && untouched(), "F77 csr_map, element");
  name[0] = 400;
  cte_f77_find_(name, &length, &found, &code);
  client_check(code == CTE_ERROR_NAME && found == UNTOUCHED, "F77 find, no character");
  length = -1;
  cte_f77_find_(name, &length, &found, &code);
  client_check(code == CTE_ERROR_NAME && found == UNTOUCHED, "F77 find, length");
}

/* Messages take anything. */
static void messages(void)
{
  int32_t text[8], size = 8, needed = UNTOUCHED, none = -5;
  code = CTE_ERROR_NULL;
  for (int i = 0; i < 8; i++)
    text[i] = UNTOUCHED;
  cte_f77_message_(NULL, NULL, NULL, NULL, NULL, NULL);
  state[CTE_F77_STATE_ARGUMENT] = CTE_ARGUMENT_NONE;
  cte_f77_message_(&none, &code, state, text, &size, &needed);
  client_check(needed > 8 && text[0] == 'a' && text[7] == 'r', "F77 message cut");
  size = -1;
  text[0] = UNTOUCHED;
  cte_f77_message_(&element, &code, state, text, &size, &needed);
  client_check(text[0] == UNTOUCHED && needed > 8, "F77 message of size -1");
}

void bad_fortran77(void)
{
  if (!bench_open(&b, "InterpolatedQuad4") || cte_element_find("InterpolatedQuad4", 17, &element) != CTE_SUCCESS)
    return;
  request = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY;
  room = (int32_t)b.info.workspace;
  for (int i = 0; i < UNKNOWNS; i++) {
    map[i] = i;
    row_start[i + 1] = UNKNOWNS * (i + 1);
    for (int j = 0; j < UNKNOWNS; j++) {
      place[UNKNOWNS * i + j] = UNKNOWNS * i + j;
      column[UNKNOWNS * i + j] = j;
    }
  }
  for (int i = 0; i < 10; i++)
    name[i] = "PointQuad4"[i];
  evaluate_nulls();
  project_nulls();
  batch_nulls();
  find_nulls();
  info_nulls();
  csr_map_nulls();
  csr_blocks_nulls();
  /* a slave point and a facet: the same nodes */
  patch[CTE_F77_PATCH_SLAVE_POINTS] = 1;
  patch[CTE_F77_PATCH_MASTER_NODES] = 4;
  patch[CTE_F77_PATCH_FACETS] = 1;
  cte_element_find("PointQuad4", 10, &patch[CTE_F77_PATCH_FACET]);
  patch[CTE_F77_PATCH_EDGE] = patch[CTE_F77_PATCH_VERTEX] = -1;
  patch_info_nulls();
  patch_evaluate_nulls();
  indices();
  messages();
}
