/* interface_walk.c - every element of the library: description, unknowns, parameters, lookup, evaluation. */
#include "client_support.h"
#include "interface_parts.h"

#include <stdio.h>
#include <string.h>

enum { NSLAVE = 3, STATES = 6 };

static bench b, alone;

static const uint32_t all_requests = CTE_RESIDUAL | CTE_TANGENT | CTE_HISTORY | CTE_OUTPUT | CTE_ENERGY |
                                     CTE_FREEZE_STATE | CTE_SYMMETRISE | CTE_PROJECTION_GIVEN | CTE_SCREEN |
                                     CTE_CSR_BY_BLOCKS;

/* Anchor and slip path: with friction, whose tangent has no symmetry. */
static int has_slip(const cte_info *info)
{
  return info->history / info->points >= 2 + 2 * info->projected && info->projected > 0 && info->symmetric == 0;
}

/* Edges of solids keep a normal. */
static int keeps_side(const bench *any)
{
  return client_contains(any->info.name, "Edges");
}

/* Entries per point: status and projection; with friction anchor and slip path too, with rolling of two curves five
 * more, of edges three more; a multiplier, where there is none among the unknowns. Else 0. */
static int history_of_point(const bench *any)
{
  const cte_info *info = &any->info;
  const int p = info->projected, entries = info->history / info->points;
  const int plain = 1 + p + (has_slip(info) ? p + 1 : 0);
  const int sides = keeps_side(any) ? 3 : 0;
  const int rolls = has_slip(info) && p == 2 && entries >= plain + 5 ? 5 : 0;
  const int more = entries - plain - rolls - sides;
  return more == 0 || (more == 1 && bench_multipliers(any) == 0) ? entries : 0;
}

/* The numbers of the description agree with each other. */
static int description_sound(const bench *any)
{
  const cte_info *info = &any->info;
  const int interpolated = info->slave_nodes == 0, multipliers = bench_multipliers(any);
  const int positions = (interpolated ? NSLAVE : info->slave_nodes) + info->master_nodes;
  return (info->dimension == 2 || info->dimension == 3) &&
         info->unknowns == positions * info->dimension + multipliers &&
         (multipliers == 0 || multipliers == info->points) &&
         info->nodes_maximum == (interpolated ? 0 : info->nodes_minimum) && info->points >= 1 &&
         info->projected >= 0 && info->projected <= 2 &&
         info->history % info->points == 0 && history_of_point(any) > 0 && (info->requests & CTE_RESIDUAL) &&
         (info->requests & ~all_requests) == 0 && (info->symmetric == 0 || info->symmetric == 1) &&
         info->operations > 0 && info->workspace >= 0 && info->formulation != 0 && info->name[0] != '\0' &&
         info->documentation != NULL;
}

/* A displacement or a change of a tangent vector that the dimension knows; a multiplier where one is expected. */
static int kind_sound(int32_t kind, int is_multiplier)
{
  if (is_multiplier)
    return kind == CTE_UNKNOWN_MULTIPLIER;
  return kind >= CTE_UNKNOWN_UX && kind <= CTE_UNKNOWN_TZ &&
         (b.info.dimension == 3 || (kind != CTE_UNKNOWN_UZ && kind != CTE_UNKNOWN_TZ));
}

/* Every unknown has its place and its kind; multipliers come last, one per node, in order. */
static int unknowns_sound(void)
{
  int32_t node, kind, seen[ROOM_NODES][CTE_UNKNOWN_MULTIPLIER + 1] = {{0}};
  int pass = 1;
  for (int32_t i = 0; i < b.info.unknowns && pass; i++) {
    pass = cte_element_unknown(b.element, b.a.nnode, i, &node, &kind) == CTE_SUCCESS &&
           node == bench_position(&b, i) / b.info.dimension && node < ROOM_NODES &&
           kind_sound(kind, bench_is_multiplier(&b, i));
    pass = pass && seen[node][kind]++ == 0;
  }
  return pass && cte_element_unknown(b.element, b.a.nnode, b.info.unknowns, &node, &kind) == CTE_ERROR_INDEX;
}

/* Names, units and ranges; the plain values of the bench lie inside them. */
static int parameters_sound(void)
{
  int pass = 1;
  int32_t bad = -1;
  for (int32_t i = 0; i < b.info.parameters && pass; i++) {
    const char *name = NULL, *unit = NULL;
    double lower = 1.0, upper = 0.0;
    int32_t closed = -1;
    pass = cte_element_parameter(b.element, i, &name, &unit, &lower, &upper, &closed) == CTE_SUCCESS &&
           cte_element_parameter(b.element, i, NULL, NULL, NULL, NULL, NULL) == CTE_SUCCESS;
    pass = pass && name[0] != '\0' && unit[0] != '\0' && lower < upper && (closed & ~3) == 0 &&
           bench_parameter(&b, name) == i;
  }
  return pass && cte_element_check_parameters(b.element, b.parameters, b.info.parameters, &bad) == CTE_SUCCESS;
}

/* By name, with blanks behind it, cut by its length. */
static int lookup_sound(int32_t index)
{
  char padded[200];
  int32_t found = -1, exact = -1;
  const int32_t length = (int32_t)strlen(b.info.name);
  memset(padded, ' ', sizeof padded);
  memcpy(padded, b.info.name, (size_t)length);
  return cte_element_find(padded, sizeof padded, &found) == CTE_SUCCESS && found == index &&
         cte_element_find(padded, length, &exact) == CTE_SUCCESS && exact == index &&
         cte_element_get(index) == b.element;
}

/* Initial history: open, projection and anchor at the centre, no slip, no multiplier. */
static int history_sound(void)
{
  int pass = 1;
  const int entries = history_of_point(&b), p = b.info.projected, slip = has_slip(&b.info);
  const int plain = 1 + p + (slip ? p + 1 : 0);
  for (int32_t point = 0; point < b.info.points; point++) {
    const double *h = &b.history_accepted[point * entries];
    pass &= h[CTE_HISTORY_STATUS] == CTE_STATUS_OPEN;
    if (entries > plain)
      pass &= h[plain] == 0.0;
    if (slip)
      pass &= client_same(&h[CTE_HISTORY_PROJECTION], &h[CTE_HISTORY_PROJECTION + p], p) && h[1 + 2 * p] == 0.0;
  }
  return pass;
}

/* Outputs full of signalling NaN: they are written, never read. */
static void poison(bench *any)
{
  double *values = (double *)&any->out;
  for (size_t i = 0; i < sizeof any->out / sizeof(double); i++)
    client_special(1, &values[i]);
}

/* The same state with one request bit; the struct with the outputs is the copy's own. */
static int32_t evaluate_alone(uint32_t request)
{
  memcpy(&alone, &b, sizeof b);
  alone.a.request = request;
  alone.a.f = alone.out.f;
  alone.a.k = alone.out.k;
  poison(&alone);
  return bench_evaluate(&alone);
}

/* Random nodes, random multipliers, most of which press. */
static void randomise(void)
{
  for (int i = 0; i < b.info.unknowns; i++)
    if (bench_is_multiplier(&b, i))
      b.u[bench_position(&b, i)] = 0.25 - client_random();
    else
      b.x[i] = client_random();
}

/* Residual alone: the bits of the joint call. Tangent alone: the same to rounding. */
static int evaluation_sound(void)
{
  const long n = b.info.unknowns;
  int pass = 1;
  for (int state = 0; state < STATES && pass; state++) {
    randomise();
    poison(&b);
    const int32_t code = bench_evaluate(&b);
    pass = code == CTE_SUCCESS || code == CTE_CUT_BACK;
    pass = pass && evaluate_alone(CTE_RESIDUAL) == code && alone.a.status == b.a.status;
    if (code == CTE_SUCCESS)
      pass = pass && client_same(alone.out.f, b.out.f, n);
    if (!(b.info.requests & CTE_TANGENT))
      continue;
    pass = pass && evaluate_alone(CTE_TANGENT) == code;
    if (code == CTE_SUCCESS && pass)
      pass = client_near(alone.out.k, b.out.k, n * n, 1e-13);
  }
  return pass;
}

/* An all-zero history begins as the initial one does. */
static int zeros_sound(void)
{
  int pass = 1;
  for (int state = 0; state < STATES && pass; state++) {
    randomise();
    poison(&b);
    const int32_t code = bench_evaluate(&b);
    memcpy(&alone, &b, sizeof b);
    memset(alone.history_accepted, 0, sizeof alone.history_accepted);
    alone.a.history_accepted = alone.history_accepted;
    alone.a.request = CTE_RESIDUAL;
    alone.a.f = alone.out.f;
    poison(&alone);
    pass = bench_evaluate(&alone) == code && alone.a.status == b.a.status &&
           (code != CTE_SUCCESS || client_same(alone.out.f, b.out.f, b.info.unknowns));
  }
  return pass;
}

/* Bits that the element does not offer are refused. */
static int refusal_sound(void)
{
  int pass = 1;
  for (uint32_t bit = 1; bit <= CTE_CSR_BY_BLOCKS; bit *= 2)
    if (!(b.info.requests & bit)) {
      b.a.request |= bit;
      pass &= bench_evaluate(&b) == CTE_ERROR_REQUEST && b.a.error_argument == CTE_ARGUMENT_REQUEST;
      b.a.request &= ~bit;
    }
  return pass;
}

static void check(int pass, const char *what)
{
  char text[200];
  snprintf(text, sizeof text, "%s: %s", b.info.name, what);
  client_check(pass, text);
}

void interface_walk(void)
{
  const int32_t count = cte_element_count();
  client_check(count > 0, "there are elements");
  for (int32_t index = 0; index < count; index++) {
    if (!bench_index(&b, index, NSLAVE)) {
      client_check(0, client_text("layout of element", index));
      continue;
    }
    check(description_sound(&b), "description");
    check(unknowns_sound(), "unknowns");
    check(parameters_sound(), "parameters");
    check(lookup_sound(index), "lookup by name");
    check(history_sound(), "initial history");
    check(evaluation_sound(), "residual alone, tangent alone, both");
    check(zeros_sound(), "history of zeros");
    check(refusal_sound(), "bits not offered");
  }
}
