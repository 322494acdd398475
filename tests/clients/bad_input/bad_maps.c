/* bad_maps.c - bad input to both scatter maps, and patterns that only one of them takes; see bad_input.c. */
#include "bad_calls.h"
#include "client_support.h"

#include <stdio.h>
#include <string.h>

enum {
  CONTACTS = 2,
  ROWS = 18, /* of six nodes */
  N = 15,    /* unknowns of an element, of five nodes */
  ENTRIES = ROWS * ROWS,
  ROOM = CONTACTS * 16 * 16,
  UNTOUCHED = -77
};

typedef int32_t map_function(const cte_element *, int64_t, int32_t, const int32_t *, int64_t, const int64_t *,
                             const int32_t *, int64_t *);
static map_function *const make[2] = {cte_csr_map, cte_csr_blocks};
static const int size[2] = {N * N, 5 * 6}; /* of the map of one contact */

static bench b;
static int which; /* of both functions */
static int32_t connectivity[CONTACTS * 5], column[2 * ENTRIES];
static int64_t row_start[ROWS + 1], map[ROOM];

static void check(int pass, const char *what)
{
  char text[128];
  snprintf(text, sizeof text, "%s: %s", which == 0 ? "csr_map" : "csr_blocks", what);
  client_check(pass, text);
}

static void clear_map(void)
{
  for (int i = 0; i < ROOM; i++)
    map[i] = UNTOUCHED;
}

/* Two slave points (nodes 0 and 1) on one facet (nodes 2 to 5). A full matrix for a pattern; rows whose bit is in
 * `without` have no column 3, of node 1, which the first contact has no use for; those in `longer` have one more
 * behind. */
static void lay_out(unsigned without, unsigned longer)
{
  static const int32_t nodes[CONTACTS * 5] = {0, 2, 3, 4, 5, 1, 2, 3, 4, 5};
  int64_t entries = 0;
  memcpy(connectivity, nodes, sizeof nodes);
  for (int row = 0; row < ROWS; row++) {
    row_start[row] = entries;
    for (int col = 0; col < ROWS; col++)
      if (col != 3 || !(without >> row & 1u))
        column[entries++] = col;
    if (longer >> row & 1u)
      column[entries++] = ROWS;
  }
  row_start[ROWS] = entries;
  clear_map();
}

/* The code of one call. */
static int32_t mapped(int64_t n, int32_t nslave, int64_t rows)
{
  return make[which](b.element, n, nslave, connectivity, rows, row_start, column, map);
}

/* The first numbers of the map are positions, all others as they were. */
static int written(int numbers)
{
  int pass = 1;
  for (int i = 0; i < ROOM; i++)
    pass &= i < numbers ? map[i] >= 0 && map[i] < row_start[ROWS] : map[i] == UNTOUCHED;
  return pass;
}

/* The pattern is refused for both contacts, and nothing written. */
static int refused(void)
{
  return mapped(CONTACTS, 0, ROWS) == CTE_ERROR_INDEX && written(0);
}

static void null_pointers(void)
{
  const cte_element *e = b.element;
  map_function *const made = make[which];
  lay_out(0, 0);
  check(made(NULL, CONTACTS, 0, connectivity, ROWS, row_start, column, map) == CTE_ERROR_NULL &&
            made(e, CONTACTS, 0, NULL, ROWS, row_start, column, map) == CTE_ERROR_NULL &&
            made(e, CONTACTS, 0, connectivity, ROWS, NULL, column, map) == CTE_ERROR_NULL &&
            made(e, CONTACTS, 0, connectivity, ROWS, row_start, NULL, map) == CTE_ERROR_NULL &&
            made(e, CONTACTS, 0, connectivity, ROWS, row_start, column, NULL) == CTE_ERROR_NULL,
        "each pointer null");
  check(made(e, 0, 0, NULL, 0, NULL, NULL, NULL) == CTE_SUCCESS, "no contacts");
  check(made(NULL, 0, 0, NULL, 0, NULL, NULL, NULL) == CTE_ERROR_NULL, "no contacts, element null");
  check(written(0), "each pointer null, map untouched");
}

static void counts(void)
{
  const int64_t far = INT64_MAX;
  lay_out(0, 0);
  check(mapped(CONTACTS, 2, ROWS) == CTE_ERROR_NODE_COUNT, "nslave");
  check(mapped(CONTACTS, -1, ROWS) == CTE_ERROR_NODE_COUNT, "nslave negative");
  check(mapped(far, 0, ROWS) == CTE_ERROR_INDEX && mapped(far / 64, 0, ROWS) == CTE_ERROR_INDEX &&
            mapped(CONTACTS, 0, far) == CTE_ERROR_INDEX,
        "sizes beyond any memory");
  check(mapped(-1, 0, ROWS) == CTE_ERROR_INDEX && mapped(CONTACTS, 0, -1) == CTE_ERROR_INDEX, "sizes negative");
  check(mapped(CONTACTS, 0, ROWS - 3) == CTE_ERROR_INDEX, "node beyond the rows");
  connectivity[7] = -1;
  check(mapped(CONTACTS, 0, ROWS) == CTE_ERROR_INDEX, "connectivity -1");
  connectivity[7] = INT32_MAX;
  check(mapped(CONTACTS, 0, ROWS) == CTE_ERROR_INDEX, "connectivity far out");
  check(written(0), "counts, map untouched");
}

/* The second contact has not all it needs: nothing is written of the first one either. */
static void patterns(void)
{
  const int64_t wrong[4] = {-1, INT64_MIN, INT64_MAX, 0};
  int pass = 1;
  lay_out(0, 0);
  column[ENTRIES - 1] = ROWS; /* entry (last, last) is missing now */
  check(refused(), "entry missing from the pattern");
  lay_out(1u << 4, 0); /* entry (4, 3) of the slave with itself */
  check(refused(), "entry missing in the middle of a row");
  for (int i = 0; i < 4; i++) {
    lay_out(0, 0);
    row_start[4] = wrong[i];
    pass &= refused();
    lay_out(0, 0);
    row_start[ROWS] = wrong[i];
    pass &= refused();
  }
  check(pass, "row_start of no matrix");
}

/* All entries are there, and blocks of the same shape in all rows of a node, or not. */
static void shapes(void)
{
  static const unsigned shape[6][2] = {{0, 0}, {7, 0}, {2, 0}, {1, 1}, {4, 0}, {0, 1}};
  for (int i = 0; i < 6; i++) {
    lay_out(shape[i][0], shape[i][1]);
    const int taken = which == 0 || i < 2; /* by blocks: none but rows with the same columns */
    const int32_t found = mapped(1, 0, ROWS);
    check(found == (taken ? CTE_SUCCESS : CTE_ERROR_INDEX) && written(taken ? size[which] : 0),
          client_text("shape of a node's rows", i));
  }
}

/* Nodes of their own for two contacts; without and with the rows and columns of multipliers. */
static void multipliers(void)
{
  int32_t nodes[12];
  int64_t start[37] = {0}, entries = 0;
  if (!bench_open(&b, "PointQuad4Multiplier"))
    return;
  clear_map();
  for (int a = 0; a < 12; a++)
    nodes[a] = a;
  check(make[which](b.element, 2, 0, nodes, 36, start, column, map) == CTE_ERROR_INDEX && written(0),
        "no entries for multipliers");
  for (int row = 0; row < 36; row++) { /* of each contact 15 rows, one of the multiplier, two without entries */
    start[row] = entries;
    for (int j = 0; j < 16 && row % 18 < 16; j++)
      column[entries++] = row / 18 * 18 + j;
  }
  start[36] = entries;
  check(make[which](b.element, 2, 0, nodes, 36, start, column, map) == CTE_SUCCESS && map[0] == 0 &&
            map[which == 0 ? 511 : 82] == 511 && (which == 0 || (map[81] == 508 && map[83] == 0)),
        "one row and column for each multiplier");
  clear_map();
  column[255] = 16; /* a multiplier with itself */
  check(make[which](b.element, 2, 0, nodes, 36, start, column, map) == CTE_ERROR_INDEX && written(0),
        "a multiplier without its entry on the diagonal");
}

void bad_maps(void)
{
  for (which = 0; which < 2; which++) {
    if (!bench_open(&b, "PointQuad4"))
      return;
    lay_out(0, 0);
    check(mapped(CONTACTS, 0, ROWS) == CTE_SUCCESS && written(CONTACTS * size[which]), "the sound pattern");
    null_pointers();
    counts();
    patterns();
    shapes();
    multipliers();
  }
}
