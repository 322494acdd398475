/* interface_entries.c - the same evaluation through cte_api_table and through the Fortran 77 entries. */
#include "client_support.h"
#include "interface_parts.h"

#include <string.h>

enum { N = 15, LDK = 20 };

static bench b, reference;

static int same_as_reference(void)
{
  return client_same(b.out.f, reference.out.f, N) && client_same(b.out.k, reference.out.k, N * N) &&
         client_same(b.out.history_trial, reference.out.history_trial, b.info.history) &&
         client_same(b.out.output, reference.out.output, CTE_OUTPUT_SIZE) &&
         client_same(b.out.energy, reference.out.energy, 1);
}

/* Lookup and description through the table. */
static int described(const cte_api_table *api, int32_t index)
{
  const char *name = NULL, *own = NULL;
  int32_t found = -1, node[2] = {-1, -2}, kind[2] = {-1, -2}, bad = -1;
  double history[ROOM_HISTORY];
  cte_info info = CTE_INFO_INIT;
  int pass = api->element_count() == cte_element_count() && api->element_get(index) == b.element &&
             api->element_find("PointQuad4", 10, &found) == CTE_SUCCESS && found == index &&
             api->element_info(b.element, 0, &info) == CTE_SUCCESS && memcmp(&info, &b.info, sizeof info) == 0;
  pass = pass && api->element_unknown(b.element, 0, 7, &node[0], &kind[0]) == CTE_SUCCESS &&
         cte_element_unknown(b.element, 0, 7, &node[1], &kind[1]) == CTE_SUCCESS && node[0] == node[1] &&
         kind[0] == kind[1];
  pass = pass && api->element_parameter(b.element, 1, &name, NULL, NULL, NULL, NULL) == CTE_SUCCESS &&
         cte_element_parameter(b.element, 1, &own, NULL, NULL, NULL, NULL) == CTE_SUCCESS && name == own;
  pass = pass &&
         api->element_check_parameters(b.element, b.parameters, b.info.parameters, &bad) == CTE_SUCCESS &&
         api->element_history_init(b.element, history) == CTE_SUCCESS;
  return pass && api->element_batch_workspace(b.element, 0) == cte_element_batch_workspace(b.element, 0);
}

static void table(int32_t index)
{
  cte_api_table api;
  char text[2][128];
  api = (cte_api_table)CTE_API_TABLE_INIT;
  if (!client_check(cte_api(CTE_VERSION_MAJOR, &api) == CTE_SUCCESS && api.version == cte_abi_version() &&
                        api.struct_size == sizeof api,
                    "cte_api"))
    return;
  client_check(described(&api, index), "table: lookup and description");
  bench_canary(&b);
  client_check(api.element_evaluate(b.element, &b.a) == CTE_SUCCESS && same_as_reference(), "table: evaluate");
  b.a.f = NULL;
  const int32_t code = api.element_evaluate(b.element, &b.a);
  const int32_t length = api.element_message(b.element, &b.a, code, text[0], sizeof text[0]);
  client_check(length == cte_element_message(b.element, &b.a, code, text[1], sizeof text[1]) &&
                   length == (int32_t)strlen(text[0]) && strcmp(text[0], text[1]) == 0,
               "table: message");
  client_check(strcmp(api.code_message(code), cte_code_message(code)) == 0 &&
                   strcmp(api.status_message(CTE_STATUS_LAW), cte_status_message(CTE_STATUS_LAW)) == 0 &&
                   strcmp(api.argument_name(CTE_ARGUMENT_F), cte_argument_name(CTE_ARGUMENT_F)) == 0,
               "table: texts");
  client_check(api.element_evaluate_batch(NULL, 0, NULL) == CTE_ERROR_NULL &&
                   api.element_evaluate_batch_threads(NULL, 0, NULL, 0) == CTE_ERROR_NULL &&
                   api.csr_map(NULL, 0, 0, NULL, 0, NULL, NULL, NULL) == CTE_ERROR_NULL &&
                   api.csr_blocks(NULL, 0, 0, NULL, 0, NULL, NULL, NULL) == CTE_ERROR_NULL,
               "table: batch, csr_map and csr_blocks");
}

/* One call of the Fortran 77 entry with the bench's arrays but for k; -1 where it is not closed. */
static int32_t called_77(int32_t index, int32_t request, double *k)
{
  const int32_t nnode = 5, zero = 0, ldk = LDK;
  const double one = 1.0;
  int32_t state[CTE_F77_STATES] = {-1, -1, -1, -1}, code = -1;
  bench_canary(&b);
  cte_f77_evaluate_(&index, &request, &nnode, &zero, b.x, &zero, b.u, &zero, b.parameters, &b.info.parameters,
                    b.history_accepted, b.out.history_trial, b.row, &zero, NULL, &one, &one, b.out.f, k, &ldk,
                    b.out.output, b.out.energy, b.workspace, &zero, state, &code);
  return state[CTE_F77_STATE_STATUS] == CTE_STATUS_CLOSED && state[CTE_F77_STATE_CLOSED] == 1 ? code : -1;
}

/* K comes column-major with a leading dimension. */
static void evaluate_77(int32_t index)
{
  static double k[LDK * N];
  int pass = called_77(index, CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY, k) == CTE_SUCCESS;
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++)
      b.out.k[i * N + j] = k[i + j * LDK];
  client_check(pass && same_as_reference(), "F77 evaluate");
  pass = called_77(index, CTE_RESIDUAL, b.out.k) == CTE_SUCCESS;
  const double untouched = b.out.k[0];
  client_check(pass && client_same(b.out.f, reference.out.f, N) && client_same(b.out.history_trial, &untouched, 1) &&
                   client_same(b.out.output, &untouched, 1) && client_same(b.out.energy, &untouched, 1) &&
                   client_same(&b.out.k[N], &untouched, 1),
               "F77 residual alone touches nothing else");
}

static void others_77(int32_t index)
{
  const int32_t nnode = 0;
  const int32_t expected[CTE_F77_SIZES] = {b.info.dimension,    b.info.nodes_minimum, b.info.nodes_maximum,
                                           b.info.slave_nodes,  b.info.master_nodes,  b.info.unknowns,
                                           b.info.parameters,   b.info.history,       b.info.points,
                                           b.info.projected,    (int32_t)b.info.requests, b.info.symmetric,
                                           (int32_t)b.info.workspace};
  int32_t sizes[CTE_F77_SIZES] = {0}, code = -1;
  double history[ROOM_HISTORY];
  cte_f77_info_(&index, &nnode, sizes, &code);
  client_check(code == CTE_SUCCESS && memcmp(sizes, expected, sizeof sizes) == 0, "F77 info");
  memset(history, 0x5a, sizeof history);
  code = -1;
  cte_f77_history_init_(&index, history, &code);
  client_check(code == CTE_SUCCESS && client_same(history, b.history_accepted, b.info.history), "F77 history_init");
}

void interface_entries(void)
{
  int32_t index = -1;
  if (!bench_open(&reference, "PointQuad4") || !bench_open(&b, "PointQuad4"))
    return;
  cte_element_find("PointQuad4", 10, &index);
  bench_evaluate(&reference);
  table(index);
  evaluate_77(index);
  others_77(index);
}
