/* interface_parts.h - the parts of interface.c. */
#ifndef INTERFACE_PARTS_H
#define INTERFACE_PARTS_H

void interface_layout(void);    /* sizes and offsets of the structs */
void interface_constants(void); /* every number of the header */
void interface_walk(void);      /* every element: description, lookup, evaluation */
void interface_evaluate(void);  /* every field of cte_arguments */
void interface_entries(void);   /* the table and the Fortran 77 entries give the same bits */
void interface_batch(void);     /* batches against single calls */
void interface_friction(void);  /* stick, slip, history of frictional elements */
void interface_transfer(void);  /* histories from element to element */
void interface_multipliers(void);      /* multipliers that are unknowns */
void interface_multiplier_batch(void); /* the same in batches */
void interface_augmented(void);        /* multipliers of the history: Uzawa's iteration */
void interface_project(void);          /* closest points without a start */
void interface_patch(void);            /* facets with their edges and vertices */
void interface_edges(void);            /* edges of solids keep their side */

#endif
