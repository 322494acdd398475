/* bad_calls.c - bad input to lookup, description, history, messages, the table and the Fortran 77 entries;
 * see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <stdio.h>
#include <string.h>

enum { UNTOUCHED = -77 }; /* what an output holds before the call */

static bench b;

/* One call whose only output is an integer: its code, and the integer as it was. */
static void expect(const char *what, int32_t found, int32_t code, int32_t integer)
{
  const int pass = found == code && integer == UNTOUCHED;
  if (!client_check(pass, what))
    printf("     code %d wanted %d, output %d\n", (int)found, (int)code, (int)integer);
}

static void lookup(void)
{
  static const char *const name[] = {"NoSuchElement", "pointquad4", "PointQuad", "PointQuad4x", "    ", ""};
  int32_t index = UNTOUCHED;
  for (int i = 0; i < 6; i++)
    expect(client_text("unknown element name", i), cte_element_find(name[i], (int32_t)strlen(name[i]), &index),
           CTE_ERROR_NAME, index);
  expect("name of length -1", cte_element_find("PointQuad4", -1, &index), CTE_ERROR_NAME, index);
  expect("name null", cte_element_find(NULL, 4, &index), CTE_ERROR_NULL, index);
  expect("index of find null", cte_element_find("PointQuad4", 10, NULL), CTE_ERROR_NULL, index);
  client_check(cte_element_get(-1) == NULL && cte_element_get(cte_element_count()) == NULL &&
                   cte_element_get(INT32_MAX) == NULL && cte_element_get(INT32_MIN) == NULL,
               "element index out of range");
}

static void description(void)
{
  cte_info info = CTE_INFO_INIT, before;
  const uint32_t size[4] = {0, 8, sizeof info - 1, 152}; /* the last: that of interface 0.1 */
  const int32_t nnode[3] = {4, 6, -1};
  client_check(cte_element_info(b.element, 0, NULL) == CTE_ERROR_NULL, "info null");
  client_check(cte_element_info(NULL, 0, &info) == CTE_ERROR_NULL, "info of element null");
  for (int i = 0; i < 4; i++) {
    info.struct_size = size[i];
    before = info;
    client_check(cte_element_info(b.element, 0, &info) == CTE_ERROR_STRUCT_SIZE &&
                     memcmp(&before, &info, sizeof info) == 0,
                 client_text("info struct_size", (long)size[i]));
  }
  info.struct_size = sizeof info;
  before = info;
  for (int i = 0; i < 3; i++)
    client_check(cte_element_info(b.element, nnode[i], &info) == CTE_ERROR_NODE_COUNT &&
                     memcmp(&before, &info, sizeof info) == 0,
                 client_text("info nnode", nnode[i]));
}

static void unknowns(void)
{
  int32_t node = UNTOUCHED, kind = UNTOUCHED;
  const int32_t index[4] = {-1, 15, INT32_MAX, INT32_MIN};
  for (int i = 0; i < 4; i++)
    expect(client_text("unknown index", (long)index[i]), cte_element_unknown(b.element, 0, index[i], &node, &kind),
           CTE_ERROR_INDEX, node == UNTOUCHED ? kind : node);
  expect("unknown of nnode 4", cte_element_unknown(b.element, 4, 0, &node, &kind), CTE_ERROR_NODE_COUNT, node);
  expect("unknown of element null", cte_element_unknown(NULL, 0, 0, &node, &kind), CTE_ERROR_NULL, node);
  expect("unknown: node null", cte_element_unknown(b.element, 0, 0, NULL, &kind), CTE_ERROR_NULL, kind);
  expect("unknown: kind null", cte_element_unknown(b.element, 0, 0, &node, NULL), CTE_ERROR_NULL, node);
}

static void parameters(void)
{
  int32_t closed = UNTOUCHED, bad = UNTOUCHED;
  double history[ROOM_HISTORY];
  const int32_t index[2] = {-1, b.info.parameters};
  for (int i = 0; i < 2; i++)
    expect(client_text("parameter index", index[i]),
           cte_element_parameter(b.element, index[i], NULL, NULL, NULL, NULL, &closed), CTE_ERROR_INDEX, closed);
  expect("parameter of element null", cte_element_parameter(NULL, 0, NULL, NULL, NULL, NULL, &closed),
         CTE_ERROR_NULL, closed);
  expect("check_parameters null", cte_element_check_parameters(b.element, NULL, b.info.parameters, &bad),
         CTE_ERROR_NULL, bad);
  expect("check_parameters of element null",
         cte_element_check_parameters(NULL, b.parameters, b.info.parameters, &bad), CTE_ERROR_NULL, bad);
  client_check(cte_element_check_parameters(b.element, b.parameters, 0, &bad) == CTE_ERROR_PARAMETER,
               "check_parameters: none given");
  for (int i = 0; i < CLIENT_SPECIALS; i++) {
    const int eps_n = bench_parameter(&b, "eps_n");
    client_special(i, &b.parameters[eps_n]);
    const int32_t code = cte_element_check_parameters(b.element, b.parameters, b.info.parameters, &bad);
    client_check(code == CTE_ERROR_NOT_FINITE && bad == eps_n, client_text("check_parameters: special value", i));
    b.parameters[eps_n] = 100.0;
  }
  bench_set(&b, "eps_n", -1.0);
  client_check(cte_element_check_parameters(b.element, b.parameters, b.info.parameters, &bad) ==
                       CTE_ERROR_PARAMETER &&
                   bad == bench_parameter(&b, "eps_n"),
               "check_parameters: eps_n negative");
  bench_set(&b, "eps_n", 100.0);
  client_check(cte_element_history_init(b.element, NULL) == CTE_ERROR_NULL, "history_init null");
  client_check(cte_element_history_init(NULL, history) == CTE_ERROR_NULL, "history_init of element null");
}

static void messages(void)
{
  static const int32_t odd[4] = {-999, 999, INT32_MIN, INT32_MAX};
  char text[8] = "#######";
  for (int i = 0; i < 4; i++)
    client_check(cte_code_message(odd[i]) != NULL && cte_status_message(odd[i]) != NULL &&
                     cte_argument_name(odd[i]) != NULL,
                 client_text("messages for", (long)odd[i]));
  client_check(cte_element_evaluate(b.element, NULL) == CTE_ERROR_NULL, "arguments null");
  client_check(cte_element_evaluate_batch(b.element, 1, NULL) == CTE_ERROR_NULL, "batch null");
  client_check(cte_element_message(NULL, NULL, CTE_ERROR_NULL, text, sizeof text) > 0 && text[7] == '\0',
               "message of element and arguments null");
  memset(text, '#', sizeof text);
  client_check(cte_element_message(b.element, &b.a, CTE_ERROR_NULL, text, 4) > 0 && text[3] == '\0' &&
                   text[4] == '#',
               "message cut to size 4");
  memset(text, '#', sizeof text);
  client_check(cte_element_message(b.element, &b.a, CTE_ERROR_NULL, text, 0) > 0 && text[0] == '#' &&
                   cte_element_message(b.element, &b.a, CTE_ERROR_NULL, text, -1) > 0 && text[0] == '#' &&
                   cte_element_message(b.element, &b.a, CTE_ERROR_NULL, NULL, 8) > 0,
               "message of size 0, -1, text null: the length alone");
}

static void table(void)
{
  cte_api_table api = CTE_API_TABLE_INIT, before;
  const uint32_t size[3] = {0, 8, sizeof api - 1};
  const uint32_t major[3] = {0, CTE_VERSION_MAJOR + 1, UINT32_MAX};
  client_check(cte_api(CTE_VERSION_MAJOR, NULL) == CTE_ERROR_NULL, "table null");
  for (int i = 0; i < 3; i++) {
    api.struct_size = size[i];
    before = api;
    client_check(cte_api(CTE_VERSION_MAJOR, &api) == CTE_ERROR_STRUCT_SIZE &&
                     memcmp(&before, &api, sizeof api) == 0,
                 client_text("table struct_size", (long)size[i]));
  }
  api.struct_size = sizeof api;
  before = api;
  for (int i = 0; i < 3; i++)
    client_check(cte_api(major[i], &api) == CTE_ERROR_VERSION && memcmp(&before, &api, sizeof api) == 0,
                 client_text("table of major version", (long)major[i]));
}

/* One call of the Fortran 77 entry with the bench's arrays. */
static int32_t evaluate_77(int32_t element, int32_t request, int32_t nnode, int32_t ldk)
{
  const int32_t zero = 0;
  const double one = 1.0;
  int32_t state[CTE_F77_STATES], code = UNTOUCHED;
  bench_canary(&b);
  cte_f77_evaluate_(&element, &request, &nnode, &zero, b.x, &zero, b.u, &zero, b.parameters, &b.info.parameters,
                    b.history_accepted, b.out.history_trial, b.row, &zero, NULL, &one, &one, b.out.f, b.out.k, &ldk,
                    b.out.output, b.out.energy, b.workspace, &zero, state, &code);
  return code;
}

static void fortran_77(void)
{
  const int32_t request = CTE_RESIDUAL | CTE_TANGENT;
  int32_t index = 0, wrong[2] = {-1, cte_element_count()}, code;
  double history[ROOM_HISTORY];
  cte_element_find("PointQuad4", 10, &index);
  for (int i = 0; i < 2; i++) {
    client_check(evaluate_77(wrong[i], request, 5, 15) == CTE_ERROR_INDEX && bench_untouched(&b),
                 client_text("F77 evaluate, element", wrong[i]));
    code = UNTOUCHED;
    cte_f77_history_init_(&wrong[i], history, &code);
    client_check(code == CTE_ERROR_INDEX, client_text("F77 history_init, element", wrong[i]));
  }
  client_check(evaluate_77(index, 1024, 5, 15) == CTE_ERROR_REQUEST && bench_untouched(&b), "F77 request 1024");
  client_check(evaluate_77(index, request, 4, 15) == CTE_ERROR_NODE_COUNT && bench_untouched(&b), "F77 nnode 4");
  client_check(evaluate_77(index, request, 5, 14) == CTE_ERROR_STRIDE && bench_untouched(&b), "F77 ldk 14");
  client_check(evaluate_77(index, request, 5, -15) == CTE_ERROR_STRIDE && bench_untouched(&b), "F77 ldk -15");
  client_special(1, &b.u[2]);
  client_check(evaluate_77(index, request, 5, 15) == CTE_ERROR_NOT_FINITE && bench_untouched(&b), "F77 u NaN");
}

void bad_calls(void)
{
  lookup();
  if (!bench_open(&b, "PointQuad4"))
    return;
  description();
  unknowns();
  parameters();
  messages();
  table();
  fortran_77();
}
