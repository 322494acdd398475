/* contact_elements_table.h - all functions in one table, for hosts that load the library at run time (dlopen). */
#ifndef CONTACT_ELEMENTS_TABLE_H
#define CONTACT_ELEMENTS_TABLE_H

#include "contact_elements_batch.h"
#include "contact_elements_call.h"
#include "contact_elements_pairs.h"

#ifdef __cplusplus
extern "C" {
#endif

/* cte_api_table: `element_get` is cte_element_get, and so on. */
typedef struct cte_api_table {
  uint32_t struct_size; /* in: set by CTE_API_TABLE_INIT; out: that of the library */
  uint32_t version;     /* of the library, as cte_abi_version */
  int32_t (*element_count)(void);
  const cte_element *(*element_get)(int32_t);
  int32_t (*element_find)(const char *, int32_t, int32_t *);
  int32_t (*element_info)(const cte_element *, int32_t, cte_info *);
  int32_t (*element_unknown)(const cte_element *, int32_t, int32_t, int32_t *, int32_t *);
  int32_t (*element_parameter)(const cte_element *, int32_t, const char **, const char **, double *, double *, int32_t *);
  int32_t (*element_check_parameters)(const cte_element *, const double *, int32_t, int32_t *);
  int32_t (*element_history_init)(const cte_element *, double *);
  int32_t (*element_evaluate)(const cte_element *, cte_arguments *);
  int64_t (*element_batch_workspace)(const cte_element *, int32_t);
  int32_t (*element_evaluate_batch)(const cte_element *, int64_t, cte_batch *);
  int32_t (*csr_map)(const cte_element *, int64_t, int32_t, const int32_t *, int64_t, const int64_t *, const int32_t *,
                     int64_t *);
  const char *(*code_message)(int32_t);
  const char *(*status_message)(int32_t);
  const char *(*argument_name)(int32_t);
  int32_t (*element_message)(const cte_element *, const cte_arguments *, int32_t, char *, int32_t);
  int32_t (*history_transfer)(const cte_element *, const double *, const double *, const cte_element *, const double *,
                              double *, int32_t *);
  int32_t (*history_augment)(const cte_element *, const double *, double *, int32_t *);
  int32_t (*element_project)(const cte_element *, cte_arguments *, double, cte_projection *, double *);
  int32_t (*patch_info)(const cte_patch *, cte_info *, int32_t *);
  int32_t (*patch_evaluate)(const cte_patch *, cte_arguments *);
  int32_t (*element_evaluate_batch_threads)(const cte_element *, int64_t, cte_batch *, int32_t);
  int32_t (*csr_blocks)(const cte_element *, int64_t, int32_t, const int32_t *, int64_t, const int64_t *,
                        const int32_t *, int64_t *);
} cte_api_table;
#define CTE_API_TABLE_INIT {(uint32_t)sizeof(cte_api_table), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, \
                            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}

/* ------------------------------------------------------------------ functions */

/* Fills *table. major: CTE_VERSION_MAJOR of this header; CTE_ERROR_VERSION when the library's differs. */
int32_t cte_api(uint32_t major, cte_api_table *table);

#ifdef __cplusplus
}
#endif
#endif
