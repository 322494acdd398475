/* contact_elements.h - finite-element contact elements through a C interface. It includes all of these:
 *
 *   contact_elements_call.h    begin here: conventions, parameters, one evaluation, statuses, messages
 *   contact_elements_batch.h   many contacts of one element: strides, sums into a sparse matrix, threads
 *   contact_elements_pairs.h   which pair is in contact: projection, patches; histories that change pairs
 *   contact_elements_table.h   all functions in one table, for hosts that load the library at run time
 *   contact_elements_f77.h     the calls for Fortran 77
 *
 * contact_elements_symbols.h has one function and one index for every built-in element.
 */
#ifndef CONTACT_ELEMENTS_H
#define CONTACT_ELEMENTS_H

#include "contact_elements_batch.h"
#include "contact_elements_call.h"
#include "contact_elements_f77.h"
#include "contact_elements_pairs.h"
#include "contact_elements_table.h"

#endif
