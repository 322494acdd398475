/* contact_elements_f77.h - the calls for Fortran 77 and later fixed-form hosts.
 *
 * Rules
 *   Arguments    Everything is handed over by address. No argument is a CHARACTER. Symbols end with one underscore.
 *                Integers are default integers of 4 bytes, INTEGER*8 where it says so; reals are REAL*8.
 *                An array that the request does not need is not touched: any variable will do.
 *   Constants    contact_elements.inc has the indices of the elements, the order of their parameters and the numbers of
 *                the headers as PARAMETERs: CTE_POINT_QUAD4, CTE_RESIDUAL, CTE_ERROR_NULL, CTE_OUTPUT_GAP, ...
 *   Indices      Count from 0, as everywhere in the interface: elements, nodes, unknowns and entries. Declare
 *                OUT(0:CTE_OUTPUT_SIZE-1,*), ISIZES(0:CTE_F77_SIZES-1), ISTATE(0:CTE_F77_STATES-1), ...
 *   ELEMENT      Index of an element. CODE is CTE_ERROR_INDEX for an index that no element has.
 *   CODE         Return code. The meaning of every code is that of the function of the same name in the other headers.
 *   Histories    HISACC is the accepted history, HISTRI the trial history. HISACC must hold a history: all zeros, that of
 *                CTE_F77_HISTORY_INIT, or that of an earlier call.
 *   LDX, LDU     Leading dimensions: X(LDX,nodes), U(LDU,nodes). 0: the dimension of the element.
 *   NPARAM       Entries of PARAMS.
 *   MAPPED, MAP  MAPPED = 1: MAP holds the row of the host for each unknown, from 0. MAPPED = 0: MAP is not read.
 *   FSCALE, KSCALE   Factors of F and K. 1: +f and +K; a host that wants the right-hand side takes FSCALE = -1.
 *   F, K         F(rows) and K(LDK,rows), column-major. CTE_F77_BATCH has another layout, see there.
 *   WORK, NWORK  Workspace of ISIZES(CTE_F77_SIZE_WORKSPACE) doubles; NWORK = 0 where that is 0. */
#ifndef CONTACT_ELEMENTS_F77_H
#define CONTACT_ELEMENTS_F77_H

#include "contact_elements_call.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ ISIZES: what an element is, see cte_info */
#define CTE_F77_SIZE_DIMENSION 0
#define CTE_F77_SIZE_NODES_MINIMUM 1
#define CTE_F77_SIZE_NODES_MAXIMUM 2
#define CTE_F77_SIZE_SLAVE_NODES 3
#define CTE_F77_SIZE_MASTER_NODES 4
#define CTE_F77_SIZE_UNKNOWNS 5
#define CTE_F77_SIZE_PARAMETERS 6
#define CTE_F77_SIZE_HISTORY 7
#define CTE_F77_SIZE_POINTS 8
#define CTE_F77_SIZE_PROJECTED 9
#define CTE_F77_SIZE_REQUESTS 10
#define CTE_F77_SIZE_SYMMETRIC 11
#define CTE_F77_SIZE_WORKSPACE 12
#define CTE_F77_SIZES 13

/* ------------------------------------------------------------------ ISTATE: outcome of a call */
#define CTE_F77_STATE_STATUS 0   /* CTE_STATUS_*; of a batch 0 */
#define CTE_F77_STATE_CLOSED 1   /* closed contact points; of a batch the contacts that failed */
#define CTE_F77_STATE_ARGUMENT 2 /* CTE_ARGUMENT_* that is wrong */
#define CTE_F77_STATE_INDEX 3    /* node, entry or contact point, see CTE_ARGUMENT_* */
#define CTE_F77_STATES 4

/* ------------------------------------------------------------------ IPATCH: what a patch is, see cte_patch */
#define CTE_F77_PATCH_SLAVE_POINTS 0
#define CTE_F77_PATCH_MASTER_NODES 1
#define CTE_F77_PATCH_FACETS 2
#define CTE_F77_PATCH_FACET 3  /* index of an element */
#define CTE_F77_PATCH_EDGE 4   /* likewise; -1: no transition to edges */
#define CTE_F77_PATCH_VERTEX 5 /* likewise; -1: no transition to vertices */
#define CTE_F77_PATCHES 6

/* ------------------------------------------------------------------ PROJ: a global projection, see cte_projection */
#define CTE_F77_PROJECTION_ZETA 0 /* two entries */
#define CTE_F77_PROJECTION_DISTANCE 2
#define CTE_F77_PROJECTION_DEFINITE 3
#define CTE_F77_PROJECTION_VERDICT 4 /* CTE_VERDICT_* as a number, as the following ones */
#define CTE_F77_PROJECTION_FEATURE 5
#define CTE_F77_PROJECTION_BOXES 6
#define CTE_F77_PROJECTION_STEPS 7
#define CTE_F77_PROJECTIONS 8

/* ------------------------------------------------------------------ INTO: where a batch puts f and K; their sum */
#define CTE_F77_INTO_OWN 1    /* contact by contact into F and K */
#define CTE_F77_INTO_GLOBAL 2 /* added to GLOBF and CSRVAL */

/* ------------------------------------------------------------------ functions */

/* CALL CTE_F77_FIND(NAME, NNAME, ELEMENT, CODE)
 * Finds the index of an element. NAME(NNAME) holds the name as codes of characters, NAME(I) = ICHAR(TEXT(I:I)); trailing
 * blanks are ignored. ELEMENT stays as it was unless CODE is 0. */
void cte_f77_find_(const int32_t *name, const int32_t *length, int32_t *element, int32_t *code);

/* CALL CTE_F77_INFO(ELEMENT, NNODE, ISIZES, CODE)
 * Describes an element. NNODE: nodes of a call; 0: the minimum. All sizes are -1 unless CODE is 0. */
void cte_f77_info_(const int32_t *element, const int32_t *nnode, int32_t *sizes, int32_t *code);

/* CALL CTE_F77_MESSAGE(ELEMENT, CODE, ISTATE, ITEXT, NTEXT, LENGTH)
 * Says what went wrong in the last call. ITEXT(NTEXT) gets the message as codes of characters, with blanks behind it:
 * TEXT(I:I) = CHAR(ITEXT(I)). LENGTH: length needed. ELEMENT may be any index. After CTE_F77_HISTORY_TRANSFER and
 * others with ARGUM put ISTATE(CTE_F77_STATE_ARGUMENT) = ARGUM and the others 0. */
void cte_f77_message_(const int32_t *element, const int32_t *code, const int32_t *state, int32_t *text,
                      const int32_t *size, int32_t *length);

/* CALL CTE_F77_EVALUATE(ELEMENT, REQUEST, NNODE, NSLAVE, X, LDX, U, LDU, PARAMS, NPARAM, HISACC, HISTRI, SROW,
 *1     MAPPED, MAP, FSCALE, KSCALE, F, K, LDK, OUT, ENERGY, WORK, NWORK, ISTATE, CODE)
 * Evaluates one element. NNODE 0: its own number. SROW(NSLAVE+1): interpolated slaves, see cte_arguments.slave_row. */
void cte_f77_evaluate_(const int32_t *element, const int32_t *request, const int32_t *nnode, const int32_t *nslave,
                       const double *x, const int32_t *ldx, const double *u, const int32_t *ldu,
                       const double *parameters, const int32_t *parameter_count, const double *history_accepted,
                       double *history_trial, const double *slave_row, const int32_t *mapped, const int32_t *map,
                       const double *f_scale, const double *k_scale, double *f, double *k, const int32_t *ldk,
                       double *output, double *energy, double *workspace, const int32_t *workspace_size,
                       int32_t *state, int32_t *code);

/* CALL CTE_F77_PROJECT(ELEMENT, NNODE, NSLAVE, X, LDX, U, LDU, PARAMS, NPARAM, SROW, REACH, PROJ, HISACC,
 *1     ISTATE, CODE)
 * Finds the closest points over the whole domain of the master. PROJ(0:CTE_F77_PROJECTIONS-1,points). HISACC becomes the
 * initial history at these projections. ISTATE: argument and index alone. */
void cte_f77_project_(const int32_t *element, const int32_t *nnode, const int32_t *nslave, const double *x,
                      const int32_t *ldx, const double *u, const int32_t *ldu, const double *parameters,
                      const int32_t *parameter_count, const double *slave_row, const double *reach, double *result,
                      double *history, int32_t *state, int32_t *code);

/* CALL CTE_F77_PATCH_INFO(IPATCH, CONN, REACH, ISIZES, ARGUM, CODE)
 * Gives the sizes of a patch's call. CONN(nodes of a facet, facets): master nodes, from 0. REACH 0: no limit. ARGUM:
 * what is wrong, CTE_ARGUMENT_*. All sizes are -1 unless CODE is 0. */
void cte_f77_patch_info_(const int32_t *numbers, const int32_t *connectivity, const double *reach, int32_t *sizes,
                         int32_t *argument, int32_t *code);

/* CALL CTE_F77_PATCH_EVALUATE(IPATCH, CONN, REACH, REQUEST, NNODE, X, LDX, U, LDU, PARAMS, NPARAM, HISACC, HISTRI,
 *1     MAPPED, MAP, FSCALE, KSCALE, F, K, LDK, OUT, ENERGY, WORK, NWORK, ISTATE, CODE)
 * Evaluates a patch. The other arguments are those of CTE_F77_EVALUATE with the shapes of cte_patch. */
void cte_f77_patch_evaluate_(const int32_t *numbers, const int32_t *connectivity, const double *reach,
                             const int32_t *request, const int32_t *nnode, const double *x, const int32_t *ldx,
                             const double *u, const int32_t *ldu, const double *parameters,
                             const int32_t *parameter_count, const double *history_accepted, double *history_trial,
                             const int32_t *mapped, const int32_t *map, const double *f_scale, const double *k_scale,
                             double *f, double *k, const int32_t *ldk, double *output, double *energy,
                             double *workspace, const int32_t *workspace_size, int32_t *state, int32_t *code);

/* CALL CTE_F77_BATCH(ELEMENT, N, REQUEST, NSLAVE, NGLOB, CONN, X, LDX, U, LDU, PARAMS, NPARAM, LDP, HISACC, HISTRI,
 *1     SROW, INTO, FSCALE, KSCALE, F, K, GLOBF, CSRVAL, CSRMAP, OUT, ENERGY, ISTAT, ICODE, WORK, NWORK,
 *2     ISTATE, CODE)
 * Evaluates N contacts of one element, see cte_batch.
 *   NGLOB, CONN   NGLOB = 0: X(LDX,nodes,N), U(LDU,nodes,N), and CONN is not read. Else X(LDX,NGLOB), U(LDU,NGLOB) are
 *                 global arrays, and CONN(nodes,N) has the nodes of each contact, from 0
 *   LDP           0: PARAMS(NPARAM) for all contacts; else PARAMS(LDP,N)
 *   F, K          F(unknowns,N), and K(unknowns,unknowns,N) with the row of the tangent as its second index: K(J,I,E) is
 *                 dF(I,E)/du(J)
 *   GLOBF         GLOBF(dimension*NGLOB), added to
 *   CSRVAL, CSRMAP   values of a sparse matrix, added to at the places of CSRMAP, INTEGER*8: that of CTE_F77_CSR_MAP,
 *                 or with CTE_CSR_BY_BLOCKS that of CTE_F77_CSR_BLOCKS
 *   ISTAT, ICODE  status and code of each contact (N); HISACC, HISTRI, SROW, OUT, ENERGY: contact after contact */
void cte_f77_batch_(const int32_t *element, const int32_t *n, const int32_t *request, const int32_t *nslave,
                    const int32_t *global_nodes, const int32_t *connectivity, const double *x, const int32_t *ldx,
                    const double *u, const int32_t *ldu, const double *parameters, const int32_t *parameter_count,
                    const int32_t *ldp, const double *history_accepted, double *history_trial,
                    const double *slave_row, const int32_t *into, const double *f_scale, const double *k_scale,
                    double *f, double *k, double *global_f, double *csr_values, const int64_t *csr_map,
                    double *output, double *energy, int32_t *statuses, int32_t *codes, double *workspace,
                    const int32_t *workspace_size, int32_t *state, int32_t *code);

/* CALL CTE_F77_CSR_MAP(ELEMENT, N, NSLAVE, CONN, NROWS, ROWST, COLUMN, MAP, CODE)
 * Makes the scatter map of N contacts, see cte_csr_map. ROWST(NROWS+1) and MAP(unknowns,unknowns,N) are INTEGER*8;
 * rows, columns and places count from 0. */
void cte_f77_csr_map_(const int32_t *element, const int32_t *n, const int32_t *nslave, const int32_t *connectivity,
                      const int32_t *rows, const int64_t *row_start, const int32_t *column, int64_t *map,
                      int32_t *code);

/* CALL CTE_F77_CSR_BLOCKS(ELEMENT, N, NSLAVE, CONN, NROWS, ROWST, COLUMN, MAP, CODE)
 * Makes the smaller map of CTE_CSR_BY_BLOCKS, see cte_csr_blocks: MAP(nodes+1,nodes,N). */
void cte_f77_csr_blocks_(const int32_t *element, const int32_t *n, const int32_t *nslave,
                         const int32_t *connectivity, const int32_t *rows, const int64_t *row_start,
                         const int32_t *column, int64_t *map, int32_t *code);

/* CALL CTE_F77_HISTORY_INIT(ELEMENT, HISACC, CODE)
 * Writes an initial history. */
void cte_f77_history_init_(const int32_t *element, double *history, int32_t *code);

/* CALL CTE_F77_HISTORY_TRANSFER(FROM, FOUT, FHIST, TO, TOUT, THIST, ARGUM, CODE)
 * Carries the history of a contact point to a neighbouring element, see cte_history_transfer. */
void cte_f77_history_transfer_(const int32_t *from, const double *from_output, const double *from_history,
                               const int32_t *to, const double *to_output, double *to_history, int32_t *argument,
                               int32_t *code);

/* CALL CTE_F77_HISTORY_AUGMENT(ELEMENT, HISTRI, HISACC, ARGUM, CODE)
 * Does one step of Uzawa's iteration, see cte_history_augment. */
void cte_f77_history_augment_(const int32_t *element, const double *trial, double *accepted, int32_t *argument,
                              int32_t *code);

#ifdef __cplusplus
}
#endif
#endif
