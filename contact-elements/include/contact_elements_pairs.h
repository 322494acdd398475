/* contact_elements_pairs.h - which pair is in contact: global projection, patches of facets, and histories that pass
 * from one element to another. Conventions: contact_elements_call.h. */
#ifndef CONTACT_ELEMENTS_PAIRS_H
#define CONTACT_ELEMENTS_PAIRS_H

#include "contact_elements_call.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ cte_projection: result of a global projection */
#define CTE_VERDICT_INSIDE 0     /* one closest point, inside the domain or free on its boundary */
#define CTE_VERDICT_BOUNDARY 1   /* one closest point, held by the boundary: `feature` as in CTE_OUTPUT_FEATURE */
#define CTE_VERDICT_NOT_UNIQUE 2 /* at least two closest points (zeta is one), or definiteness is not positive */
#define CTE_VERDICT_BEYOND 3     /* nothing within the reach: zeta, distance, definiteness are 0 but for closed
                                  * projections */
#define CTE_VERDICT_UNDECIDED 4  /* 20000 boxes did not suffice; zeta is the best point found */
/* Arrays of it are handed over, so it will not grow; it has no struct_size and needs no initialiser. */
typedef struct cte_projection {
  double zeta[2];      /* projected parameters, slave curve first; 0 beyond their number */
  double distance;     /* |r|, without r0 [length]; 0, whatever the reach, for points and distance functions */
  double definiteness; /* least eigenvalue of F relative to the metric. > 0: the projection exists and is unique
                        * nearby; 1 on flat masters, 0 on the focal surface */
  int32_t verdict;     /* CTE_VERDICT_* */
  int32_t feature;     /* 0 inside */
  int32_t boxes;       /* boxes of parameters looked at; 0 with a closed projection */
  int32_t steps;       /* Newton steps, all together */
} cte_projection;

/* ------------------------------------------------------------------ cte_patch: facets that share edges and vertices
 * Each slave point takes part in one pair, that of the closest point of the whole patch: with a facet, or with the edge
 * or vertex that several facets share. Force and energy stay continuous where the pair changes. The search is part of
 * the call. Theory: docs/theory/transition.md.
 *
 * Elements     All have a point slave, one dimension, one normal law, a penalty and no friction.
 *   facet        a surface (3D) or a curve (2D, 3D): PointQuad4, PointTri6, PointLine2In2d, PointLine2, ...
 *   edge         of surfaces: the curve that bounds the facet, with `gap: oriented`. PointLine2Oriented belongs to
 *                PointQuad4 and PointTri3, PointLine3Oriented to PointQuad9 and PointTri6. It is checked that its
 *                shape functions are the facet's on each edge. Null: beyond an edge the point is outside
 *   vertex       PointPointOriented, PointPointOriented2d; PointPoint for curves in 3D. Null: likewise
 * Orientation  All normals point to one side: two facets run along a shared edge in opposite directions. The gap to an
 *              edge or vertex is -|r| - r0 inside the body, else |r| - r0. Inside is the negative side of the facets
 *              that meet there, by the sum of their normals weighted with their angles.
 * Equal ones   Of equally near facets that of the history is taken.
 *
 * In cte_arguments
 *   nnode             0 or all: slave_points + master_nodes
 *   x, u              of all nodes, slave points first
 *   parameters        those of the facet (law, r0, orientation), then for rational facets a weight per master node
 *   history_accepted  5 entries per slave point: status, number of the facet from 1 (0: none), feature, two
 *                     parameters. All 0 to begin with; null likewise
 *   f, k, unknown_map of all nodes
 *   output            one row per slave point; projection and feature are those on the facet
 *   workspace         cte_info.workspace of cte_patch_info
 *   request           the bits of cte_info.requests. CTE_FREEZE_STATE keeps open and closed, not the pair
 *   error_index       with CTE_CUT_BACK the slave point */
typedef struct cte_patch {
  uint32_t struct_size;        /* set by CTE_PATCH_INIT */
  int32_t slave_points;
  int32_t master_nodes;
  int32_t facets;
  const cte_element *facet;
  const int32_t *connectivity; /* [facets][master nodes of a facet]: master nodes, from 0 */
  const cte_element *edge;     /* null: no transition to edges */
  const cte_element *vertex;   /* null: no transition to vertices */
  double reach;                /* farther facets are not looked for [length]; 0: no limit */
} cte_patch;
#define CTE_PATCH_INIT {(uint32_t)sizeof(cte_patch), 0, 0, 0, 0, 0, 0, 0, 0.0}

/* ------------------------------------------------------------------ functions */

/* Finds the closest points over the whole domain of the master, for all contact points of an element. No start is
 * needed, and the result is certified: interval arithmetic excludes boxes of parameters until one point is left. It
 * costs some thousand evaluations and serves starts and lost contacts.
 *   arguments  read: nnode, nslave, x, u and their strides, parameters, slave_row; written: error_argument, error_index
 *   reach      farther points are not looked for [length]; 0: no limit
 *   result     [points]
 *   history    null, or room for the element's history. It becomes the initial history at these projections; as
 *              history_accepted of a first evaluation it leaves 1 to 3 Newton steps
 * Returns 0; CTE_ERROR_NULL, _STRUCT_SIZE, _NODE_COUNT, _PARAMETER, _STRIDE; CTE_ERROR_NOT_FINITE: x, u, slave_row, or
 * reach (also below 0); CTE_ERROR_ELEMENT: a geometry of more than 32 nodes or 2048 operations. Nothing is written on an
 * error that is found before the first contact point. */
int32_t cte_element_project(const cte_element *element, cte_arguments *arguments, double reach, cte_projection *result,
                            double *history);

/* Gives the sizes of a patch's call, as cte_element_info does of an element's; points and slave_nodes are its slave
 * points. argument (may be null): what is wrong, CTE_ARGUMENT_*. Returns 0; CTE_ERROR_NULL, _STRUCT_SIZE, _NODE_COUNT;
 * CTE_ERROR_INDEX: connectivity; CTE_ERROR_NOT_FINITE: reach; CTE_ERROR_ELEMENT: not the facet's edge or vertex. */
int32_t cte_patch_info(const cte_patch *patch, cte_info *info, int32_t *argument);

/* Evaluates a patch. Codes and the scalars at the end of *arguments are those of cte_element_evaluate. Unless the
 * return is 0 nothing else is written but the workspace. Every facet is looked at for every slave point; near ones are
 * searched. */
int32_t cte_patch_evaluate(const cte_patch *patch, cte_arguments *arguments);

/* Carries a history from an element to its neighbour when the projection of a contact point passes there, so that the
 * tangential force does not jump. One contact point of each element:
 *   from_history  its accepted history
 *   from_output   the output of that state [CTE_OUTPUT_SIZE]
 *   to_history    in: from an evaluation of `to` at the same displacements, begun with an initial history; status
 *                 outside is fine. out: the accepted history of the point on `to`
 *   to_output     the output of that evaluation [CTE_OUTPUT_SIZE]
 *   argument      may be null. CTE_ARGUMENT_FROM to CTE_ARGUMENT_TO_HISTORY, or NONE with 0
 * What is carried: docs/interface/friction.md. Where from_history is not in contact nothing is carried: the call
 * returns 0, and to_history stays.
 * Returns 0; CTE_ERROR_NULL; CTE_ERROR_NOT_FINITE; CTE_ERROR_HISTORY: no possible history, or projections of history and
 * output differ; CTE_ERROR_ELEMENT: the elements have no friction, multiplier or side to carry, or differ in kind,
 * dimension or number of projected parameters; CTE_CUT_BACK: tangents or normal span no plane, normals are opposite, the
 * slip lies across the curve, or the anchor far outside. Unless the return is 0 to_history stays as it was, and contact
 * on `to` begins there. */
int32_t cte_history_transfer(const cte_element *from, const double *from_output, const double *from_history,
                             const cte_element *to, const double *to_output, double *to_history, int32_t *argument);

/* Does one step of Uzawa's iteration for all contact points of an augmented element: docs/interface/multipliers.md.
 *   trial     history_trial of the converged evaluation with history_accepted = accepted
 *   accepted  in: the state at the start of the step. out: the same with the multipliers of trial and, with friction
 *             where the point was and is in contact, the anchor from which the tangential force of trial acts without
 *             slip in this step
 *   argument  may be null. CTE_ARGUMENT_ELEMENT, HISTORY_TRIAL (trial), HISTORY_ACCEPTED (accepted), or NONE with 0
 * Then solve the step again with it. Returns 0; CTE_ERROR_NULL, _NOT_FINITE, _HISTORY; CTE_ERROR_ELEMENT: the history has
 * no multiplier. Unless the return is 0 accepted stays as it was. */
int32_t cte_history_augment(const cte_element *element, const double *trial, double *accepted, int32_t *argument);

#ifdef __cplusplus
}
#endif
#endif
