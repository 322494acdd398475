/* bad_calls.h - the parts of bad_input.c that are not about one evaluation. */
#ifndef BAD_CALLS_H
#define BAD_CALLS_H

void bad_calls(void);   /* lookup, description, history, messages, table, the Fortran 77 call */
void bad_fortran77(void); /* null addresses to the Fortran 77 entries */
void bad_states(void);  /* states without a normal or an area, sizes beyond any memory */
void bad_batches(void); /* batches */
void bad_maps(void);    /* their scatter maps */
void bad_friction(void); /* frictional elements and the transfer of their history */
void bad_multipliers(void); /* elements with multipliers, unknown or of the history */
void bad_project(void); /* global projections */
void bad_patch(void); /* facets with their edges and vertices */

#endif
