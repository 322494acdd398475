/* contact_elements_batch.h - many contacts of one element in one call. Conventions: contact_elements_call.h.
 * Background, times and how to choose: docs/batches.md. */
#ifndef CONTACT_ELEMENTS_BATCH_H
#define CONTACT_ELEMENTS_BATCH_H

#include "contact_elements_call.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ cte_batch
 * Coordinates  Two layouts.
 *   arrays       Entry (contact e, node a, component c) of x stands at x[e*x_element_stride + a*x_node_stride +
 *                c*x_component_stride]; u likewise. Strides 0, 0, 0: [element][node][component], dense. Node and
 *                component stride 0, 0: dense within a contact. Other zeros are CTE_ERROR_STRIDE.
 *   connectivity x and u are global arrays of global_nodes nodes; node a of contact e is their node
 *                connectivity[e*nnode + a]. The element stride is not read.
 * Outputs      Per contact in f and k, or added to global arrays (these need connectivity), or both:
 *                global_f[unknown] += f, csr_values[csr_map[...]] += K.
 * Order        The contacts are evaluated one after the other, so sums are reproducible. Each contact has the same
 *              bits as by cte_element_evaluate.
 * Failures     A fault of one contact (values, parameters, state) fails that contact alone: its code says why, its
 *              slots of f, k, history_trial, output and energy are not written, and nothing of it is added. The
 *              others are valid, and the batch returns CTE_CUT_BACK. A fault of the batch (< 0: pointers, counts,
 *              strides, connectivity, workspace) leaves everything unwritten. n = 0 is fine with any pointers.
 * CTE_SCREEN   A contact that is open wherever on its facet the projection lies need not be projected. f, K, energy
 *              and sums stay the same; less is known of such a contact: its status is OPEN, also where the projection
 *              lies outside or fails; output has a lower bound of the gap, the projection of history_accepted (the
 *              centre without one) and zeros; history_trial has status OPEN and that projection. Its history is read
 *              only where history_trial or output asks for it. How many contacts are left out depends on the
 *              processor. It has no effect with CTE_FREEZE_STATE or CTE_PROJECTION_GIVEN. Offered by penalty
 *              elements of a point and a segment in 2D, a flat triangle or a bilinear facet. */
typedef struct cte_batch {
  /* what every call sets */
  uint32_t struct_size;           /* set by CTE_BATCH_INIT */
  uint32_t request;               /* CTE_RESIDUAL | ..., for all contacts */
  int32_t parameter_count;        /* entries of one set of parameters */
  int32_t nslave;                 /* interpolated slaves: slave nodes of every contact; else 0 or the element's own */
  const double *x;                /* reference coordinates [length] */
  const double *u;                /* displacements [length]; null: zero */
  const double *parameters;       /* [parameter_count], or one set per contact */
  const double *history_accepted; /* [n][history]; may be null */
  double *history_trial;          /* [n][history] */
  int32_t *status;                /* [n] CTE_STATUS_*; required */
  int32_t *code;                  /* [n] return code of each contact; may be null */
  /* gathered from global arrays and added to them */
  const int32_t *connectivity;    /* [n][nnode]; null: array layout */
  int64_t global_nodes;           /* nodes of x and u; the connectivity is checked against it */
  double *global_f;               /* [global_nodes*dimension], unknown = node*dimension + component */
  double *csr_values;             /* the values of a sparse matrix in CSR form */
  const int64_t *csr_map;         /* [n][unknowns][unknowns], made once by cte_csr_map; with CTE_CSR_BY_BLOCKS
                                   * [n][nnode][nnode + 1], made once by cte_csr_blocks */
  /* contact by contact */
  double *f;                      /* [n][unknowns]; may be null when global_f is given */
  double *k;                      /* [n][unknowns][unknowns], row-major; may be null when csr_values is given */
  double *output;                 /* [n][points][CTE_OUTPUT_SIZE] */
  double *energy;                 /* [n] contact energy [force*length] */
  /* what some calls set */
  double f_scale, k_scale;        /* CTE_BATCH_INIT sets 1, and 0 gives zeros */
  int64_t x_element_stride, x_node_stride, x_component_stride;
  int64_t u_element_stride, u_node_stride, u_component_stride;
  int64_t parameter_element_stride; /* at least parameter_count; 0: one set for all contacts */
  int64_t f_element_stride;       /* at least unknowns; 0: unknowns */
  int64_t k_element_stride;       /* at least unknowns^2; 0: unknowns^2 */
  const double *slave_row;        /* interpolated slaves: [n][nslave + 1] */
  double *workspace;              /* [cte_element_batch_workspace]; may be null where that is 0 */
  int64_t workspace_size;         /* doubles in workspace */
  /* what every call writes, except when batch is null or of a wrong struct_size */
  int64_t failed;                 /* contacts with a code other than 0 */
  int32_t error_argument;         /* argument of the batch's fault, or of the first failing contact's */
  int32_t error_index;            /* with CTE_CUT_BACK the first failing contact, else see CTE_ARGUMENT_* */
} cte_batch;
#define CTE_BATCH_INIT {(uint32_t)sizeof(cte_batch), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.0, 1.0, \
                        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}

/* ------------------------------------------------------------------ functions */

/* Doubles of workspace that a batch needs, or CTE_ERROR_NULL or CTE_ERROR_NODE_COUNT. */
int64_t cte_element_batch_workspace(const cte_element *element, int32_t nslave);

/* Evaluates n contacts of one element. Returns 0; CTE_CUT_BACK: some contacts failed, see status and code; < 0: the
 * batch was refused. n below 0 or beyond any memory: CTE_ERROR_INDEX. */
int32_t cte_element_evaluate_batch(const cte_element *element, int64_t n, cte_batch *batch);

/* Does the same with the same bits on several threads: at most so many, and at most one per processor; 0: one per
 * processor; below 0: CTE_ERROR_INDEX, CTE_ARGUMENT_THREADS. The usual library is built without threads and evaluates
 * on the calling thread. One built with the feature `threads`
 *   keeps its threads from the first call on, in the default floating-point environment;
 *   allocates for the time of the call: a word per node of global_nodes when there are sums, and per thread a workspace
 *   and what it has to add to entries of other threads, at most some 32 MB for each contact point;
 *   needs a csr_map of cte_csr_map or cte_csr_blocks for a pattern whose rows do not share places, else two threads
 *   would add to one place at once.
 * If allocation fails at the start, one thread does the work. If it fails midway, the call returns
 * CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE, and all outputs are undefined. */
int32_t cte_element_evaluate_batch_threads(const cte_element *element, int64_t n, cte_batch *batch, int32_t threads);

/* Makes the scatter map of n contacts once: the place in the CSR values of every entry of every element matrix.
 * row_start [rows + 1] and column [row_start[rows]], sorted within each row, count from 0; rows = global_nodes *
 * dimension. map: [n][unknowns][unknowns], written only when every entry was found. Returns 0; CTE_ERROR_INDEX: an
 * entry is missing from the pattern, or n or rows is below 0 or beyond any memory; CTE_ERROR_NODE_COUNT: nslave does
 * not fit, see cte_batch; CTE_ERROR_NULL, with n = 0 for the element alone. */
int32_t cte_csr_map(const cte_element *element, int64_t n, int32_t nslave, const int32_t *connectivity,
                    int64_t rows, const int64_t *row_start, const int32_t *column, int64_t *map);

/* Makes the smaller map of CTE_CSR_BY_BLOCKS, which has one place for every pair of nodes (PointQuad4: 30 numbers
 * instead of 225). For node a it holds the places of the entries in the row of its first unknown and the column of the
 * first unknown of every node b, then the distance between the rows of node a (0 for the only row of a multiplier).
 * It needs a pattern in which all rows of a node have the same columns, and in them the columns of a node stand side by
 * side, as meshes with all unknowns of a node together have. Otherwise it returns CTE_ERROR_INDEX; cte_csr_map takes
 * every pattern. map: [n][nnode][nnode + 1], written only when every entry was found. */
int32_t cte_csr_blocks(const cte_element *element, int64_t n, int32_t nslave, const int32_t *connectivity,
                       int64_t rows, const int64_t *row_start, const int32_t *column, int64_t *map);

#ifdef __cplusplus
}
#endif
#endif
