/* interface_constants.c - every number of contact_elements.h, and the texts that belong to them. */
#include "client_support.h"
#include "interface_parts.h"

#include <stdio.h>
#include <string.h>

typedef struct constant {
  const char *name;
  int64_t found, expected;
} constant;

#define CONSTANT(name, expected) {#name, (int64_t)(name), expected}

static void compare(const char *what, const constant *constants, size_t count)
{
  int pass = 1;
  for (size_t i = 0; i < count; i++)
    if (constants[i].found != constants[i].expected) {
      printf("     %s is %ld\n", constants[i].name, (long)constants[i].found);
      pass = 0;
    }
  client_check(pass, client_text(what, (long)count));
}

#define COMPARE(what, constants) compare(what, constants, sizeof constants / sizeof constants[0])

/* Every constant of the list has a distinct text. */
static void texts(const char *what, const constant *constants, size_t count, const char *(*text)(int32_t))
{
  int pass = 1;
  for (size_t i = 0; i < count; i++) {
    const char *own = text((int32_t)constants[i].found);
    pass &= own != NULL && own[0] != '\0' && strcmp(own, text(9999)) != 0;
    for (size_t j = 0; j < i && pass; j++)
      pass &= strcmp(own, text((int32_t)constants[j].found)) != 0;
  }
  client_check(pass, what);
}

static void codes(void)
{
  static const constant list[] = {
      CONSTANT(CTE_SUCCESS, 0),           CONSTANT(CTE_CUT_BACK, 1),          CONSTANT(CTE_ERROR_NULL, -1),
      CONSTANT(CTE_ERROR_STRUCT_SIZE, -2), CONSTANT(CTE_ERROR_NODE_COUNT, -3), CONSTANT(CTE_ERROR_PARAMETER, -4),
      CONSTANT(CTE_ERROR_REQUEST, -5),    CONSTANT(CTE_ERROR_WORKSPACE, -6),  CONSTANT(CTE_ERROR_NOT_FINITE, -7),
      CONSTANT(CTE_ERROR_INDEX, -8),      CONSTANT(CTE_ERROR_NAME, -9),       CONSTANT(CTE_ERROR_VERSION, -10),
      CONSTANT(CTE_ERROR_STRIDE, -11),    CONSTANT(CTE_ERROR_HISTORY, -12),   CONSTANT(CTE_ERROR_ELEMENT, -13)};
  COMPARE("return codes", list);
  texts("texts of the return codes", list, sizeof list / sizeof list[0], cte_code_message);
}

static void arguments(void)
{
  static const constant list[] = {
      CONSTANT(CTE_ARGUMENT_NONE, 0),         CONSTANT(CTE_ARGUMENT_STRUCT_SIZE, 1),
      CONSTANT(CTE_ARGUMENT_REQUEST, 2),      CONSTANT(CTE_ARGUMENT_NNODE, 3),
      CONSTANT(CTE_ARGUMENT_NSLAVE, 4),       CONSTANT(CTE_ARGUMENT_X, 5),
      CONSTANT(CTE_ARGUMENT_U, 6),            CONSTANT(CTE_ARGUMENT_PARAMETERS, 7),
      CONSTANT(CTE_ARGUMENT_HISTORY_ACCEPTED, 8),  CONSTANT(CTE_ARGUMENT_HISTORY_TRIAL, 9),
      CONSTANT(CTE_ARGUMENT_SLAVE_ROW, 10),   CONSTANT(CTE_ARGUMENT_F, 11),
      CONSTANT(CTE_ARGUMENT_K, 12),           CONSTANT(CTE_ARGUMENT_K_STRIDE, 13),
      CONSTANT(CTE_ARGUMENT_UNKNOWN_MAP, 14), CONSTANT(CTE_ARGUMENT_SCALE, 15),
      CONSTANT(CTE_ARGUMENT_OUTPUT, 16),      CONSTANT(CTE_ARGUMENT_ENERGY, 17),
      CONSTANT(CTE_ARGUMENT_WORKSPACE, 18),   CONSTANT(CTE_ARGUMENT_ELEMENT, 19),
      CONSTANT(CTE_ARGUMENT_INFO, 20),        CONSTANT(CTE_ARGUMENT_ELEMENT_NAME, 21),
      CONSTANT(CTE_ARGUMENT_BATCH, 22),       CONSTANT(CTE_ARGUMENT_CONNECTIVITY, 23),
      CONSTANT(CTE_ARGUMENT_CSR, 24),         CONSTANT(CTE_ARGUMENT_STATUS, 25),
      CONSTANT(CTE_ARGUMENT_FROM, 26),        CONSTANT(CTE_ARGUMENT_FROM_OUTPUT, 27),
      CONSTANT(CTE_ARGUMENT_FROM_HISTORY, 28), CONSTANT(CTE_ARGUMENT_TO, 29),
      CONSTANT(CTE_ARGUMENT_TO_OUTPUT, 30),   CONSTANT(CTE_ARGUMENT_TO_HISTORY, 31),
      CONSTANT(CTE_ARGUMENT_REACH, 32),       CONSTANT(CTE_ARGUMENT_RESULT, 33),
      CONSTANT(CTE_ARGUMENT_PATCH, 34),       CONSTANT(CTE_ARGUMENT_FACETS, 35),
      CONSTANT(CTE_ARGUMENT_FACET, 36),       CONSTANT(CTE_ARGUMENT_EDGE, 37),
      CONSTANT(CTE_ARGUMENT_VERTEX, 38),      CONSTANT(CTE_ARGUMENT_THREADS, 39)};
  COMPARE("arguments", list);
  texts("names of the arguments", list, sizeof list / sizeof list[0], cte_argument_name);
  client_check(strcmp(cte_argument_name(CTE_ARGUMENT_PARAMETERS), "parameters") == 0,
               "an argument's name is the name of the field");
}

static void statuses(void)
{
  static const constant list[] = {CONSTANT(CTE_STATUS_OPEN, 0),
                                  CONSTANT(CTE_STATUS_CLOSED, 1),
                                  CONSTANT(CTE_STATUS_STICK, 2),
                                  CONSTANT(CTE_STATUS_SLIP, 3),
                                  CONSTANT(CTE_STATUS_OUTSIDE, 4),
                                  CONSTANT(CTE_STATUS_NOT_CONVERGED, 5),
                                  CONSTANT(CTE_STATUS_NOT_UNIQUE, 6),
                                  CONSTANT(CTE_STATUS_DEGENERATE, 7),
                                  CONSTANT(CTE_STATUS_LAW, 8)};
  COMPARE("statuses", list);
  texts("texts of the statuses", list, sizeof list / sizeof list[0], cte_status_message);
}

static void others(void)
{
  static const constant requests[] = {CONSTANT(CTE_RESIDUAL, 1),      CONSTANT(CTE_TANGENT, 2),
                                      CONSTANT(CTE_HISTORY, 4),       CONSTANT(CTE_OUTPUT, 8),
                                      CONSTANT(CTE_ENERGY, 16),       CONSTANT(CTE_FREEZE_STATE, 32),
                                      CONSTANT(CTE_SYMMETRISE, 64),   CONSTANT(CTE_PROJECTION_GIVEN, 128),
                                      CONSTANT(CTE_SCREEN, 256),      CONSTANT(CTE_CSR_BY_BLOCKS, 512)};
  static const constant kinds[] = {CONSTANT(CTE_UNKNOWN_UX, 1), CONSTANT(CTE_UNKNOWN_UY, 2),
                                   CONSTANT(CTE_UNKNOWN_UZ, 3), CONSTANT(CTE_UNKNOWN_TX, 4),
                                   CONSTANT(CTE_UNKNOWN_TY, 5), CONSTANT(CTE_UNKNOWN_TZ, 6),
                                   CONSTANT(CTE_UNKNOWN_MULTIPLIER, 7)};
  static const constant outputs[] = {
      CONSTANT(CTE_OUTPUT_STATUS, 0),     CONSTANT(CTE_OUTPUT_GAP, 1),        CONSTANT(CTE_OUTPUT_NORMAL_TRACTION, 2),
      CONSTANT(CTE_OUTPUT_WEIGHT, 3),     CONSTANT(CTE_OUTPUT_PROJECTION, 4), CONSTANT(CTE_OUTPUT_NORMAL, 6),
      CONSTANT(CTE_OUTPUT_ITERATIONS, 9), CONSTANT(CTE_OUTPUT_FEATURE, 10),
      CONSTANT(CTE_OUTPUT_TANGENTIAL_TRACTION, 11),
      CONSTANT(CTE_OUTPUT_TANGENTS, 13),  CONSTANT(CTE_OUTPUT_ANGLES, 19),    CONSTANT(CTE_OUTPUT_MOMENTS, 21),
      CONSTANT(CTE_OUTPUT_SIZE, 23)};
  static const constant histories[] = {CONSTANT(CTE_HISTORY_STATUS, 0), CONSTANT(CTE_HISTORY_PROJECTION, 1)};
  static const constant verdicts[] = {CONSTANT(CTE_VERDICT_INSIDE, 0), CONSTANT(CTE_VERDICT_BOUNDARY, 1),
                                      CONSTANT(CTE_VERDICT_NOT_UNIQUE, 2), CONSTANT(CTE_VERDICT_BEYOND, 3),
                                      CONSTANT(CTE_VERDICT_UNDECIDED, 4)};
  static const constant versions[] = {CONSTANT(CTE_VERSION_MAJOR, 1), CONSTANT(CTE_VERSION_MINOR, 0),
                                      CONSTANT(CTE_ABI_VERSION_COMPILED, 65536)};
  COMPARE("request bits", requests);
  COMPARE("kinds of unknowns", kinds);
  COMPARE("entries of the output", outputs);
  COMPARE("entries of the history", histories);
  COMPARE("verdicts", verdicts);
  COMPARE("version numbers", versions);
  client_check(cte_abi_version() >> 16 == CTE_VERSION_MAJOR && cte_abi_version() >= CTE_ABI_VERSION_COMPILED,
               "the library is no older than the header");
}

void interface_constants(void)
{
  codes();
  arguments();
  statuses();
  others();
}
