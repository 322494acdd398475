/* contact_elements_f77.h - the calls for Fortran 77. */
#ifndef CONTACT_ELEMENTS_F77_H
#define CONTACT_ELEMENTS_F77_H

#include "contact_elements_call.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ functions */

/* Everything by address, no CHARACTER arguments, symbols with one trailing underscore. `element` is the
 * element's index; contact_elements.inc has it and the request bits as PARAMETERs, and the order of the
 * parameters. Integers are INTEGER*4, reals REAL*8.
 *
 *   CALL CTE_F77_EVALUATE(ELEMENT, REQUEST, NNODE, NSLAVE, X, U, PARAMS, NPARAMS, HISACC, HISTRI,
 *  1                      SROW, F, K, LDK, OUT, ENERGY, STATUS, CODE)
 *   X(dim,NNODE), U(dim,NNODE), K(LDK,*) column-major. Arrays that the request does not need are not touched.
 *   HISACC must hold a history: of CTE_F77_HISTORY_INIT or of an earlier evaluation.
 *   For interpolated slaves up to 64 slave nodes (more: CTE_ERROR_WORKSPACE); more need the module.
 *   CODE is CTE_ERROR_INDEX for an index that no element has.
 *   CALL CTE_F77_INFO(ELEMENT, NNODE, ISIZES)  ISIZES(1..8) = dimension, nodes_minimum, unknowns,
 *                                              parameters, history, points, projected, symmetric;
 *                                              all -1 for an index or NNODE that does not exist
 *   CALL CTE_F77_HISTORY_INIT(ELEMENT, HISTORY, CODE)
 *   CALL CTE_F77_HISTORY_TRANSFER(FROM, FOUT, FHIST, TO, TOUT, THIST, ARGUM, CODE)  cte_history_transfer;
 *                                              CODE is CTE_ERROR_INDEX for an index that no element has
 *   CALL CTE_F77_HISTORY_AUGMENT(ELEMENT, TRIAL, HIST, ARGUM, CODE)  cte_history_augment; CODE as above
 */
void cte_f77_evaluate_(const int32_t *element, const int32_t *request, const int32_t *nnode, const int32_t *nslave,
                       const double *x, const double *u, const double *parameters, const int32_t *parameter_count,
                       const double *history_accepted, double *history_trial, const double *slave_row, double *f, double *k,
                       const int32_t *ldk, double *output, double *energy, int32_t *status, int32_t *code);
void cte_f77_info_(const int32_t *element, const int32_t *nnode, int32_t *sizes);
void cte_f77_history_init_(const int32_t *element, double *history, int32_t *code);
void cte_f77_history_transfer_(const int32_t *from, const double *from_output, const double *from_history,
                               const int32_t *to, const double *to_output, double *to_history, int32_t *argument,
                               int32_t *code);
void cte_f77_history_augment_(const int32_t *element, const double *trial, double *accepted, int32_t *argument,
                              int32_t *code);

#ifdef __cplusplus
}
#endif
#endif
