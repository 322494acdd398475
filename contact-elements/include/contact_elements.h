/* contact_elements.h - finite-element contact elements through a C interface.
 *
 * This header is the manual: unit, sign, shape, owner, thread rule and failure of every item.
 *
 * Conventions
 *   Unknowns     node by node, component fastest; slave nodes first, then master nodes.
 *   Force        f = +internal force = dW/du; tangent K = df/du. A host that wants a right-hand
 *                side asks for it with f_scale = -1.
 *   Gap          g > 0 open, g < 0 penetrating [length]. Normal traction N = dW/dg, N < 0 in contact.
 *   Position     current = x + u: x reference coordinates, u displacement at the end of the step.
 *   Units        any consistent set; lengths between 1e-30 and 1e30.
 *   Indices      from 0.
 *
 * Rules
 *   Pure         no globals, allocation, I/O, threads or clock. Every function may be called from
 *                any number of threads; the same input gives the same bits.
 *   Memory       all memory is the caller's; nothing is kept after the return. Arrays are aligned for
 *                their type and do not overlap, but for history_accepted and history_trial, which may be one array.
 *   Traps        the floating-point environment is left alone. No invalid, divide-by-zero or overflow
 *                exception is raised on the way, unless a law, shape function, rigid position or closed
 *                projection of a declaration divides by zero, leaves the domain of ln, sqrt or pow or the
 *                range of a double: then one may be, before the status (law, degenerate, not converged)
 *                says so or the search within the domain goes on. Built in: rational geometries beyond the
 *                domain, where sum of w B may vanish, or with weights below 1e-30, and laws whose values leave
 *                the range of a double.
 *   Growth       every struct begins with its size as the caller compiled it; new fields come at the
 *                end. Begin a struct with its initialiser: cte_arguments a = CTE_ARGUMENTS_INIT; or, later,
 *                a = (cte_arguments)CTE_ARGUMENTS_INIT; (C99). It sets the size, scales of 1 and zeros.
 *   Returns      0 fine; > 0 recoverable (see CTE_CUT_BACK); < 0 the caller's fault. On anything but 0
 *                no array of the caller is written; a batch with CTE_CUT_BACK: see cte_batch.
 *   Sizes        a call has at most 2^30 - 1 unknowns; counts and strides whose products exceed any memory
 *                are refused. Layouts of structs are those of 64-bit pointers.
 */
#ifndef CONTACT_ELEMENTS_H
#define CONTACT_ELEMENTS_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTE_VERSION_MAJOR 1u
#define CTE_VERSION_MINOR 0u
/* The version compiled against; cte_abi_version() is the library's. */
#define CTE_ABI_VERSION_COMPILED ((CTE_VERSION_MAJOR << 16) | CTE_VERSION_MINOR)

/* ------------------------------------------------------------------ return codes */
#define CTE_SUCCESS 0
/* Recoverable: the state cannot be evaluated; redo the increment with a smaller step. The field
 * `status` of cte_arguments says why and `error_index` which contact point. */
#define CTE_CUT_BACK 1
/* The caller's fault; `error_argument` and `error_index` of cte_arguments name the place. */
#define CTE_ERROR_NULL (-1)        /* a required pointer is null */
#define CTE_ERROR_STRUCT_SIZE (-2) /* struct_size is smaller than in version 1.0, or that of 0.1 */
#define CTE_ERROR_NODE_COUNT (-3)  /* nnode or nslave does not fit the element, or gives too many unknowns */
#define CTE_ERROR_PARAMETER (-4)   /* too few parameters, or one outside its range */
#define CTE_ERROR_REQUEST (-5)     /* an unknown bit, or one this element does not offer */
#define CTE_ERROR_WORKSPACE (-6)   /* workspace is smaller than cte_info.workspace */
#define CTE_ERROR_NOT_FINITE (-7)  /* NaN, infinity or a magnitude above 1e30 in an input */
#define CTE_ERROR_INDEX (-8)       /* an index (element, node, map) or number of contacts out of range */
#define CTE_ERROR_NAME (-9)        /* no element of that name */
#define CTE_ERROR_VERSION (-10)    /* the library's major version is another */
#define CTE_ERROR_STRIDE (-11)     /* strides are negative, let entries overlap or exceed any memory */
#define CTE_ERROR_HISTORY (-12)    /* an entry that no evaluation writes: no status, a projection or anchor far outside,
                                    * a negative path, no regime, an angle beyond 1000 rad, no unit normal, a positive multiplier;
                                    * cte_history_transfer: or not that of the output */
#define CTE_ERROR_ELEMENT (-13)    /* cte_history_transfer: nothing to carry, or another kind of element;
                                    * cte_history_augment: no multiplier in the history;
                                    * cte_patch: an element that cannot be the patch's facet, edge or vertex */

/* ------------------------------------------------------------------ arguments named by errors
 * error_index: the node for X and U (as counted in the call); the parameter for PARAMETERS; the bit number
 * for REQUEST; the entry for HISTORY_ACCEPTED, SLAVE_ROW, UNKNOWN_MAP and CONNECTIVITY; 0 for the others. With
 * CTE_CUT_BACK it is the contact point of cte_arguments, the contact of cte_batch. */
#define CTE_ARGUMENT_NONE 0
#define CTE_ARGUMENT_STRUCT_SIZE 1
#define CTE_ARGUMENT_REQUEST 2
#define CTE_ARGUMENT_NNODE 3
#define CTE_ARGUMENT_NSLAVE 4
#define CTE_ARGUMENT_X 5
#define CTE_ARGUMENT_U 6
#define CTE_ARGUMENT_PARAMETERS 7
#define CTE_ARGUMENT_HISTORY_ACCEPTED 8
#define CTE_ARGUMENT_HISTORY_TRIAL 9
#define CTE_ARGUMENT_SLAVE_ROW 10
#define CTE_ARGUMENT_F 11
#define CTE_ARGUMENT_K 12
#define CTE_ARGUMENT_K_STRIDE 13
#define CTE_ARGUMENT_UNKNOWN_MAP 14
#define CTE_ARGUMENT_SCALE 15
#define CTE_ARGUMENT_OUTPUT 16
#define CTE_ARGUMENT_ENERGY 17
#define CTE_ARGUMENT_WORKSPACE 18
#define CTE_ARGUMENT_ELEMENT 19
#define CTE_ARGUMENT_INFO 20
#define CTE_ARGUMENT_ELEMENT_NAME 21
#define CTE_ARGUMENT_BATCH 22
#define CTE_ARGUMENT_CONNECTIVITY 23
#define CTE_ARGUMENT_CSR 24
#define CTE_ARGUMENT_STATUS 25
#define CTE_ARGUMENT_FROM 26 /* those of cte_history_transfer */
#define CTE_ARGUMENT_FROM_OUTPUT 27
#define CTE_ARGUMENT_FROM_HISTORY 28
#define CTE_ARGUMENT_TO 29
#define CTE_ARGUMENT_TO_OUTPUT 30
#define CTE_ARGUMENT_TO_HISTORY 31
#define CTE_ARGUMENT_REACH 32 /* those of cte_element_project */
#define CTE_ARGUMENT_RESULT 33
#define CTE_ARGUMENT_PATCH 34 /* those of cte_patch */
#define CTE_ARGUMENT_FACETS 35
#define CTE_ARGUMENT_FACET 36
#define CTE_ARGUMENT_EDGE 37
#define CTE_ARGUMENT_VERTEX 38
#define CTE_ARGUMENT_THREADS 39 /* that of cte_element_evaluate_batch_threads */

/* ------------------------------------------------------------------ what is wanted: request bits */
#define CTE_RESIDUAL 1u        /* write f */
#define CTE_TANGENT 2u         /* write k */
#define CTE_HISTORY 4u         /* write history_trial */
#define CTE_OUTPUT 8u          /* write output */
#define CTE_ENERGY 16u         /* write energy (elements whose law declares W) */
#define CTE_FREEZE_STATE 32u   /* status CLOSED, STICK or SLIP in history_accepted: in contact, any other: open, whatever
                                * the gap (line search); a projection outside stays outside. With friction STICK
                                * sticks and SLIP slides, whatever the bound; without slip or bound, and after
                                * CLOSED, the law decides. With rolling each curve rolls or not as the regime
                                * in history_accepted says. Needs history_accepted. */
#define CTE_SYMMETRISE 64u     /* write (K + K^T)/2; with friction no longer the exact tangent */
#define CTE_PROJECTION_GIVEN 128u /* history_accepted holds the projection itself: no iteration. Needs history_accepted. */
#define CTE_SCREEN 256u /* batches: a contact that is open wherever on its facet the projection lies need not be
                         * projected. Nothing changes but what is known of such a contact: status OPEN, also where
                         * the projection lies outside or fails; in output a lower bound of the gap, the projection
                         * as in history_accepted (without: the middle) and zeros; in history_trial status OPEN and that
                         * projection; its history is not looked at unless asked for. How many are left out depends
                         * on the processor. No effect on one call, with CTE_FREEZE_STATE or CTE_PROJECTION_GIVEN.
                         * Points against segments in 2D, flat triangles and bilinear facets, penalty */
#define CTE_CSR_BY_BLOCKS 512u /* batches: csr_map is of cte_csr_blocks. No effect on one call */

/* ------------------------------------------------------------------ status of a contact point
 * The element's status is the one of its worst point, in the order
 * open < outside < closed, stick < slip < the failures. Elements with a tangential law report STICK and
 * SLIP, never CLOSED; the others CLOSED. */
#define CTE_STATUS_OPEN 0           /* no contact: f, k and energy are zero, but for an unknown multiplier */
#define CTE_STATUS_CLOSED 1         /* in contact, without friction */
#define CTE_STATUS_STICK 2          /* in contact, held by its anchor */
#define CTE_STATUS_SLIP 3           /* in contact, sliding: the tangential force is at its bound */
#define CTE_STATUS_OUTSIDE 4        /* the projection lies beyond the master's edge or vertex: as open */
#define CTE_STATUS_NOT_CONVERGED 5  /* the projection did not converge: CTE_CUT_BACK */
#define CTE_STATUS_NOT_UNIQUE 6     /* the projection is not unique (focal surface, parallel tangents, axis): CTE_CUT_BACK */
#define CTE_STATUS_DEGENERATE 7     /* zero area or length, L = 0 in codimension 2 or 3, the axis or centre of a
                                     * distance function, a gap that is no number, an axis of friction of length
                                     * zero or normal to the master; with rolling a curve without curvature, a
                                     * director of length zero or along its curve: CTE_CUT_BACK */
#define CTE_STATUS_LAW 8            /* the gap is outside the normal law's domain (barrier passed), its N, N' or W
                                     * there is no number or beyond 1e90, or the values of the tangential law
                                     * are no numbers: CTE_CUT_BACK */

/* ------------------------------------------------------------------ kinds of unknowns */
#define CTE_UNKNOWN_UX 1      /* displacement x [length] */
#define CTE_UNKNOWN_UY 2
#define CTE_UNKNOWN_UZ 3
#define CTE_UNKNOWN_TX 4      /* change of a tangent vector of a Hermite curve, d rho / d xi, x [length] */
#define CTE_UNKNOWN_TY 5
#define CTE_UNKNOWN_TZ 6
#define CTE_UNKNOWN_MULTIPLIER 7 /* multiplier of a contact point [as N]: the only unknown of its node, in u the
                                  * first component of the node; x of that node is not looked at */

/* ------------------------------------------------------------------ output of one contact point
 * With CTE_OUTPUT, output[point * CTE_OUTPUT_SIZE + entry]: */
#define CTE_OUTPUT_STATUS 0     /* CTE_STATUS_* as a number */
#define CTE_OUTPUT_GAP 1        /* gap g [length]; 0 where the projection failed */
#define CTE_OUTPUT_NORMAL_TRACTION 2 /* N, 0 where not closed [force, or force per length or area] */
#define CTE_OUTPUT_WEIGHT 3     /* integration weight times Jacobian (1 for points), 0 where not closed */
#define CTE_OUTPUT_PROJECTION 4 /* two entries: projected parameters (slave curve first for curve to curve) */
#define CTE_OUTPUT_NORMAL 6     /* three entries: unit normal */
#define CTE_OUTPUT_ITERATIONS 9 /* Newton iterations of the projection */
#define CTE_OUTPUT_FEATURE 10   /* 0 inside, else what the projection lies beyond, see below */
#define CTE_OUTPUT_TANGENTIAL_TRACTION 11 /* two entries: T_1, T_2, units as N; T_1 d_1 + T_2 d_2 is the friction
                                 * on the slave (on curved masters at zero gap; f has it at any gap). 0 without
                                 * friction and where not in contact. d_1: along b_1, or the axis of an
                                 * orthotropic law in the tangent plane; d_2 = n x d_1. One projected
                                 * parameter: T_2 = 0 */
#define CTE_OUTPUT_TANGENTS 13  /* six entries: b_1, b_2 in the global frame [length per unit of the projected
                                 * parameter]: of a slave curve its tangent, of the master minus its tangent.
                                 * 0 where there are fewer, third entries 0 in 2D */
#define CTE_OUTPUT_ANGLES 19    /* two entries: phi_1, phi_2 [rad], see Rolling below. 0 without rolling and where not
                                 * in contact, as the moments */
#define CTE_OUTPUT_MOMENTS 21   /* two entries: M_1, M_2 about the slave's and the master's curve [N times length per
                                 * rad] */
#define CTE_OUTPUT_SIZE 23
/* CTE_OUTPUT_FEATURE
 *   quadrilaterals   1 + edge: 0 between nodes 0 and 1 (eta low), 1 between 1 and 2, 2 between 2 and 3,
 *                    3 between 3 and 0; 5 + vertex: corner 0..3, counter-clockwise in (xi, eta). Corner 0 is
 *                    (low, low); corners are the first nodes, of 3 x 3 Bezier controls 0, 2, 8, 6.
 *   triangles        1 + edge: 0 between 0 and 1, 1 between 1 and 2, 2 between 2 and 0; 5 + vertex 0..2.
 *   curves           5 lower end, 6 upper end.
 *   curve to curve   1, 2 lower, upper end of the slave; 3, 4 of the master; beyond both
 *                    5 + slave end + 2 * master end (end 0 lower, 1 upper). */

/* ------------------------------------------------------------------ history of one contact point
 * cte_info.history = points * entries per point. P projected parameters:
 *   without friction  1 + P    status, projection
 *   with friction     2 + 2 P  status, projection [P], anchor [P], slip path [length]
 *   with rolling      11       as with friction (P = 2), then phi0_1, phi0_2, path_1, path_2 [rad], regime: which
 *                              curves roll, 0 none, 1 the slave's, 2 the master's, 3 both
 *   edges             three more: the unit normal (two curves with a signed gap)
 *   augmented         one more at the end: the multiplier [as N], never positive
 * history_accepted is the accepted state: the last converged step. history_trial is a trial; no evaluation reads it. When the
 * step is accepted the host copies history_trial over history_accepted, all of it; when it is cut back the host drops history_trial.
 *
 * Friction. The slip s = sum_i b_i (projection - anchor)^i of the accepted anchor gives the force: elastic while
 * it sticks, at its bound while it slides. Where contact begins (status open or outside in history_accepted, or
 * history_accepted null) the anchor is the projection: T = 0 and no tangential stiffness in this step, which alone
 * would let a body float; the next accepted step holds it. While sticking the anchor stays; on sliding
 * history_trial has the anchor from which the force is elastic again, and the slip path has grown by what slid.
 * The force is a function of the displacements at the end of the step and of history_accepted, not of the path of the
 * iterations. K is its derivative and is not symmetric (cte_info.symmetric 0): a host needs a solver for general
 * matrices. The element's energy is W + sum t_q^2/(2 e_q) (with rolling + sum M_c^2/(2 eps_phi)), what is stored: with friction f is not its derivative,
 * so a line search has to look at f. A step that reverses the slip begins at the bound, where rounding decides
 * between stick and slip: a first iteration with CTE_FREEZE_STATE and STICK in the place of SLIP in a copy of
 * history_accepted takes the elastic tangent. When the projection passes to a neighbouring element:
 * cte_history_transfer.
 *
 * Edges of solids (two curves with a signed gap). The normal is the unit vector along +-b_1 x b_2. On which side the
 * edges are is part of the history: the sign that keeps the remembered normal, also where b_1 x b_2 turns about because
 * the edges turned through parallel. So edges that have crossed are closed with a negative gap, not open on the other
 * side. Nothing remembered (cte_element_history_init): the parameter orientation, +1 or -1; with 0 the side on which
 * they are, gap + r0 >= 0, which supposes that they begin apart (CTE_ERROR_NULL without history_accepted). Beyond an end the
 * side is that of gap + r0 >= 0. A normal that turns by 84 degrees and more between two accepted states is refused
 * (CTE_STATUS_NOT_UNIQUE) up to 96 degrees; beyond, the side is lost: smaller steps.
 *
 * Rolling (elements with a law of rolling: curve to curve at a distance). phi_c is the angle of the shortest distance,
 * from curve c to the other, about the tangent of curve c, from its principal normal towards its binormal, in
 * (-pi, pi]; with `director: given` from the director's part across the curve instead. M_c follows phi_c - phi0_c,
 * taken in (-pi, pi], by the law of rolling, phi0_c and path_c as anchor and slip path of friction: M = 0 where
 * contact begins. The status is that of friction; the regime tells which curves roll and is what CTE_FREEZE_STATE
 * goes by. f is M_1 dphi_1 + M_2 dphi_2 in addition. Directors are directions in the current configuration, held
 * in f and K: the host turns them with its bodies, and whatever carries one takes the moment M_c, which the forces f
 * alone do not balance. Principal normals turn with the nodes: there f balances.
 *
 * Multipliers, c = N' of the law, a linear spring. The point is closed where N = multiplier + c g < 0, and this N
 * is the traction everywhere (output, bound of friction, energy).
 *   augmented   the multiplier of history_accepted is fixed during an evaluation; history_trial holds N (0 where open). Uzawa's
 *               iteration: solve, cte_history_augment, solve again ... until the gaps are small, then accept. A
 *               host that only accepts makes one iteration per step.
 *   unknown     one node per contact point behind all others, with one unknown. Its residual is weight * g where
 *               closed, -weight * multiplier / c where open or outside: continuous at the switch. K has zeros on
 *               the diagonal there: a solver for indefinite matrices. */
#define CTE_HISTORY_STATUS 0     /* CTE_STATUS_* as a number */
#define CTE_HISTORY_PROJECTION 1 /* P entries; then, with friction, P entries of the anchor and the slip path;
                                  * then, with rolling, phi0_1, phi0_2, path_1, path_2, regime; then of edges the
                                  * normal [3]; a multiplier last */

typedef struct cte_element cte_element; /* opaque, immutable, static */

/* ------------------------------------------------------------------ cte_info: what an element is */
typedef struct cte_info {
  uint32_t struct_size;      /* in: sizeof(cte_info) */
  int32_t dimension;         /* 2 or 3 */
  int32_t nodes_minimum;     /* nodes in a call; maximum 0: no limit (interpolated slaves) */
  int32_t nodes_maximum;
  int32_t slave_nodes;       /* 0: given in the call as nslave */
  int32_t master_nodes;      /* 0: rigid master; the nodes left over are those of multipliers */
  int32_t unknowns;          /* for the nnode asked about */
  int32_t parameters;        /* number of parameters */
  int32_t history;           /* doubles of history */
  int32_t points;            /* contact points; outputs: points * CTE_OUTPUT_SIZE doubles */
  int32_t projected;         /* projected parameters per contact point: 0, 1 or 2 */
  uint32_t requests;         /* request bits offered */
  int32_t symmetric;         /* 1: K is symmetric */
  int32_t operations;        /* arithmetic operations of one closed evaluation of the point programs */
  int64_t workspace;         /* doubles of workspace for the nnode asked about */
  uint64_t formulation;      /* hash of the formulation: changes when the generated code means something else */
  const char *name;          /* zero-terminated, static */
  const char *documentation; /* zero-terminated, static: the declaration's comment */
} cte_info;
#define CTE_INFO_INIT {(uint32_t)sizeof(cte_info), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0u, 0, 0, 0, 0u, 0, 0}

/* ------------------------------------------------------------------ cte_arguments: one evaluation */
typedef struct cte_arguments {
  /* what every call sets */
  uint32_t struct_size;           /* sizeof(cte_arguments): set by CTE_ARGUMENTS_INIT */
  uint32_t request;               /* CTE_RESIDUAL | ... */
  int32_t nnode;                  /* nodes in this call; 0: the element's own number */
  int32_t parameter_count;        /* entries of parameters */
  const double *x;                /* reference coordinates [node][component] [length] */
  const double *u;                /* displacements at the end of the step, same shape; null: zero */
  const double *parameters;       /* in the order of cte_element_parameter */
  const double *history_accepted; /* accepted history; null: the projection starts from the centre, and contact with
                                   * friction begins here (CTE_ERROR_NULL with CTE_FREEZE_STATE or
                                   * CTE_PROJECTION_GIVEN, and for edges with orientation 0) */
  double *history_trial;          /* trial history; may be the same array as history_accepted */
  double *f;                      /* residual; entry i goes to f[unknown_map ? unknown_map[i] : i] */
  double *k;                      /* tangent; entry (i,j) goes to k[row(i)*k_row_stride + row(j)*k_col_stride] */
  double *output;                 /* [points][CTE_OUTPUT_SIZE] */
  double *energy;                 /* [1] contact energy [force*length] */
  /* what some calls set */
  double f_scale;                 /* f is multiplied by it; CTE_ARGUMENTS_INIT sets 1 */
  double k_scale;                 /* K is multiplied by it; CTE_ARGUMENTS_INIT sets 1 */
  int64_t k_row_stride;           /* 0 with k_col_stride 0: row-major, dense: 1 + the largest host row */
  int64_t k_col_stride;
  const int32_t *unknown_map;     /* element unknown -> host row, all different (not checked); null: identity */
  int64_t x_node_stride;          /* doubles from node to node in x, at least dimension; 0: dimension */
  int64_t u_node_stride;          /* the same in u; 0: dimension */
  const double *slave_row;        /* interpolated slaves: shape functions of the slave point [nslave], then its weight */
  double *workspace;              /* [cte_info.workspace]; null allowed where that is 0, else CTE_ERROR_NULL */
  int64_t workspace_size;         /* doubles in workspace; too few: CTE_ERROR_WORKSPACE */
  int32_t nslave;                 /* interpolated slaves: number of slave nodes; else 0 or the element's own number */
  int32_t padding;                /* not read */
  const double *u_old;            /* displacements at the start of the step; not read yet */
  const double *v;                /* velocities; not read yet */
  double dt;                      /* length of the step; not read yet */
  /* what every call writes */
  double dt_ratio;                /* 1, or a wish for a smaller step (0.5) with CTE_CUT_BACK */
  int32_t status;                 /* CTE_STATUS_* of the element */
  int32_t closed_points;          /* how many contact points are closed */
  int32_t error_argument;         /* CTE_ARGUMENT_* with a return other than 0 */
  int32_t error_index;            /* node, entry or contact point, see CTE_ARGUMENT_* */
} cte_arguments;
#define CTE_ARGUMENTS_INIT {(uint32_t)sizeof(cte_arguments), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.0, 1.0, 0, 0, 0, 0, 0, \
                            0, 0, 0, 0, 0, 0, 0, 0.0, 0.0, 0, 0, 0, 0}

/* ------------------------------------------------------------------ cte_batch: many contacts of one element
 * Array layout: entry (contact e, node a, component c) of x stands at
 * x[e*x_element_stride + a*x_node_stride + c*x_component_stride]; u likewise. Strides 0,0,0 mean
 * [element][node][component], dense; node and component stride 0,0 mean dense within a contact. Other
 * zeros are CTE_ERROR_STRIDE. With `connectivity` the coordinates are gathered from global arrays instead:
 * node a of contact e is node connectivity[e*nnode + a] of x and u; the element stride is not used.
 * Outputs: f and k per contact (dense, f_element_stride, k_element_stride; 0: dense), and/or scattered:
 * global_f[unknown] += and csr_values[csr_map[e*unknowns^2 + i*unknowns + j]] += , see cte_csr_map; with
 * CTE_CSR_BY_BLOCKS the smaller map of cte_csr_blocks. Both need connectivity.
 * The contacts are evaluated one after the other in order, so sums are reproducible, with the same bits as
 * by cte_element_evaluate.
 * A fault of one contact (values, parameters, state) fails that contact alone: its code says why
 * (cte_code_message), its own slots of f, k, history_trial, output and energy are not written and nothing of it
 * is added; the others are valid and the batch returns CTE_CUT_BACK. A fault of the batch (< 0: pointers,
 * counts, strides, connectivity, workspace) leaves everything unwritten. n = 0 is fine, with any pointers. */
typedef struct cte_batch {
  /* what every call sets */
  uint32_t struct_size;           /* sizeof(cte_batch): set by CTE_BATCH_INIT */
  uint32_t request;
  int32_t parameter_count;
  int32_t nslave;                 /* interpolated slaves: slave nodes of every contact; else 0 or the element's own */
  const double *x;
  const double *u;                /* null: zero */
  const double *parameters;
  const double *history_accepted; /* [n][history], null allowed */
  double *history_trial;          /* [n][history] */
  int32_t *status;                /* [n] required: CTE_STATUS_* */
  int32_t *code;                  /* [n] or null: return code of each contact */
  /* gathered from and added to the host's global arrays */
  const int32_t *connectivity;    /* [n][nnode], null: array layout */
  int64_t global_nodes;           /* with connectivity: nodes in x and u, for checking */
  double *global_f;               /* [global_nodes*dimension]: node*dimension + component; added to */
  double *csr_values;             /* the caller's CSR values; added to */
  const int64_t *csr_map;         /* [n][unknowns][unknowns], made once by cte_csr_map; with CTE_CSR_BY_BLOCKS
                                   * [n][nnode][nnode + 1], made once by cte_csr_blocks */
  /* contact by contact */
  double *f;                      /* [n][unknowns], null allowed when global_f is given */
  double *k;                      /* [n][unknowns][unknowns] row-major, null allowed when csr_values is given */
  double *output;                 /* [n][points][CTE_OUTPUT_SIZE] */
  double *energy;                 /* [n] */
  /* what some calls set */
  double f_scale, k_scale;        /* CTE_BATCH_INIT sets 1 */
  int64_t x_element_stride, x_node_stride, x_component_stride;
  int64_t u_element_stride, u_node_stride, u_component_stride;
  int64_t parameter_element_stride; /* 0: one set for all; else at least parameter_count */
  int64_t f_element_stride;       /* at least unknowns; 0: unknowns */
  int64_t k_element_stride;       /* at least unknowns^2; 0: unknowns^2 */
  const double *slave_row;        /* [n][nslave + 1] */
  double *workspace;              /* [cte_element_batch_workspace]; null allowed where that is 0 */
  int64_t workspace_size;
  /* what every call writes */
  int64_t failed;                 /* contacts with a code other than 0 */
  int32_t error_argument;         /* argument of the batch's fault, or of the first failing contact's */
  int32_t error_index;            /* with CTE_CUT_BACK the first failing contact, else see CTE_ARGUMENT_* */
} cte_batch;
#define CTE_BATCH_INIT {(uint32_t)sizeof(cte_batch), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.0, 1.0, \
                        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}

/* ------------------------------------------------------------------ cte_projection: a global projection
 * verdict:
 *   CTE_VERDICT_INSIDE      one closest point, inside the domain or free on its boundary
 *   CTE_VERDICT_BOUNDARY    one closest point, held by the boundary: feature as in CTE_OUTPUT_FEATURE
 *   CTE_VERDICT_NOT_UNIQUE  two closest points at least (zeta is one of them), or definiteness not positive
 *   CTE_VERDICT_BEYOND      nothing within the reach; zeta, distance and definiteness are 0 but for closed projections
 *   CTE_VERDICT_UNDECIDED   20000 boxes did not suffice; zeta is the best point found */
#define CTE_VERDICT_INSIDE 0
#define CTE_VERDICT_BOUNDARY 1
#define CTE_VERDICT_NOT_UNIQUE 2
#define CTE_VERDICT_BEYOND 3
#define CTE_VERDICT_UNDECIDED 4
typedef struct cte_projection {
  double zeta[2];      /* projected parameters, slave curve first; 0 beyond their number */
  double distance;     /* |r|, without r0 [length]; 0, whatever the reach, for points and distance functions as master */
  double definiteness; /* least eigenvalue of F relative to the metric: > 0 where the projection exists and is unique
                        * nearby, 1 on flat masters, 0 on the focal surface */
  int32_t verdict;
  int32_t feature;     /* 0 inside */
  int32_t boxes;       /* boxes of parameters looked at; 0 with a closed projection */
  int32_t steps;       /* Newton steps, all together */
} cte_projection;

/* ------------------------------------------------------------------ cte_patch: facets that share edges and vertices
 * Each slave point takes part in one pair, that of the closest point of the whole patch: with a facet, or with the edge
 * or the vertex that several facets share. Force and energy are continuous where the pair changes; the search is part
 * of the call. Elements, all of one dimension and normal law, penalty without friction, slave: point:
 *   facet   a surface (3D) or a curve (2D, 3D): PointQuad4, PointTri6, PointLine2In2d, PointLine2 ...
 *   edge    surfaces: the curve that bounds the facet (checked: its shape functions are the facet's on each edge), with
 *           gap: oriented: PointLine2Oriented for PointQuad4 and PointTri3, PointLine3Oriented for PointQuad9 and
 *           PointTri6 ... null: beyond an edge the point is outside, as with the facet alone
 *   vertex  PointPointOriented, PointPointOriented2d; PointPoint for curves in 3D. null: likewise
 * Where two facets share an edge they run along it in opposite directions: all normals point to the same side. Inside
 * the body (negative side of the facets that meet, by the sum of their normals times their angles) the gap to an edge or
 * vertex is -|r| - r0, outside and at the rim of the patch |r| - r0.
 *
 * In cte_arguments: nnode (0 or all), x, u [slave_points + master_nodes] nodes, slave points first; parameters: those
 * of the facet (law, r0, orientation), then for rational facets a weight per master node; history_accepted may be null;
 * f, k, unknown_map: of all nodes; output: one row per slave point, projection and feature those on the facet;
 * workspace: cte_info.workspace. Request bits: cte_info.requests. FREEZE_STATE keeps open and closed, not the pair.
 * History, 5 entries per slave point: status, number of the facet from 1 (0: none), feature, two parameters; all 0 to
 * begin with. Of equally near facets that of the history is taken. CTE_CUT_BACK: error_index is the slave point. */
typedef struct cte_patch {
  uint32_t struct_size;        /* sizeof(cte_patch): set by CTE_PATCH_INIT */
  int32_t slave_points;
  int32_t master_nodes;
  int32_t facets;
  const cte_element *facet;
  const int32_t *connectivity; /* [facets][facet's master nodes]: master nodes, from 0 */
  const cte_element *edge;     /* null: no transition to edges */
  const cte_element *vertex;   /* null: no transition to vertices */
  double reach;                /* nothing farther is looked for [length]; 0: no limit */
} cte_patch;
#define CTE_PATCH_INIT {(uint32_t)sizeof(cte_patch), 0, 0, 0, 0, 0, 0, 0, 0.0}

/* ------------------------------------------------------------------ functions */

/* Version of the interface of the library in use: major << 16 | minor. */
uint32_t cte_abi_version(void);

/* Number of elements. */
int32_t cte_element_count(void);

/* Element by index 0 .. count-1; null outside. Indices never change within a major version. */
const cte_element *cte_element_get(int32_t index);

/* Index of an element by name; name need not be zero-terminated, trailing blanks are ignored (Fortran).
 * Returns 0, CTE_ERROR_NULL or CTE_ERROR_NAME. */
int32_t cte_element_find(const char *name, int32_t length, int32_t *index);

/* Describes an element. nnode: nodes of a call (matters for interpolated slaves; 0: the minimum).
 * CTE_ERROR_NODE_COUNT when it does not fit the element or gives too many unknowns. */
int32_t cte_element_info(const cte_element *element, int32_t nnode, cte_info *info);

/* Unknown `index` of a call with nnode nodes: its node and its kind (CTE_UNKNOWN_*). */
int32_t cte_element_unknown(const cte_element *element, int32_t nnode, int32_t index, int32_t *node, int32_t *kind);

/* Parameter `index`: name and unit (static, zero-terminated) and range. Any output may be null.
 * A range is closed at a bound when the corresponding bit of *closed is set (1 lower, 2 upper). */
int32_t cte_element_parameter(const cte_element *element, int32_t index, const char **name, const char **unit,
                              double *lower, double *upper, int32_t *closed);

/* Checks count parameters. 0, or CTE_ERROR_PARAMETER / CTE_ERROR_NOT_FINITE with the first bad one in *index. Of the
 * window of an element that acts at some angles of two curves, angle_high must exceed angle_low by 1e-6 rad. */
int32_t cte_element_check_parameters(const cte_element *element, const double *parameters, int32_t count, int32_t *index);

/* Writes the initial history: open, projection and anchor at the centre, slip path 0, angles and their paths 0. */
int32_t cte_element_history_init(const cte_element *element, double *history);

/* Takes an elastic slip along when the projection of a contact point passes from one element to its neighbour,
 * so that the tangential force does not jump. One contact point of each element:
 *   from_history  its accepted history, from_output the output of that state ([CTE_OUTPUT_SIZE])
 *   to_history    in: from an evaluation of `to` at the same displacements with the history of
 *                 cte_element_history_init; to_output is of the same call. Beyond the edge of `to` (status
 *                 outside) is fine. out: status, anchor, slip path, normal of edges and multiplier are those of
 *                 from_history, as `to` counts them.
 * The slip s of from_history is turned from the tangent plane of `from` into that of `to` by the smallest rotation
 * between the normals, which keeps its length; the anchor is the projection minus the parameters of s. Then
 * to_history is the accepted history of the point on `to`. With the same tangential law and parameters on both
 * elements the force keeps its length, and on coplanar elements its direction. Convected axes are those of
 * each element. Where both elements have a law of rolling, angles and their paths go along unchanged: they are about
 * the curves, which both elements must run through in the same sense. Where from_history is not in contact nothing is
 * to be carried: 0, to_history stays.
 * argument (may be null): CTE_ARGUMENT_FROM .. TO_HISTORY, or NONE with 0. CTE_ERROR_NULL; CTE_ERROR_ELEMENT:
 * neither tangential law nor augmented nor edges, or the kinds, dimensions or numbers of projected parameters differ;
 * CTE_ERROR_NOT_FINITE;
 * CTE_ERROR_HISTORY: no history, or projection in history and output differ; CTE_CUT_BACK: tangents or normal
 * span no plane, normals opposite, a slip across the curve, an anchor far outside. On anything but 0 to_history is as it was: contact on
 * `to` begins anew. */
int32_t cte_history_transfer(const cte_element *from, const double *from_output, const double *from_history,
                             const cte_element *to, const double *to_output, double *to_history, int32_t *argument);

/* One step of Uzawa's iteration, all contact points of an element:
 *   trial     history_trial of the converged evaluation with history_accepted = accepted
 *   accepted  in: the state at the start of the step; out: with the multipliers of trial and, where the point was and
 *             is in contact with friction, the anchor from which the tangential force of trial is there at no slip
 *             in this step. Status, projection and slip path stay those of the start of the step.
 * Then solve the step again with accepted as history_accepted. argument (may be null): CTE_ARGUMENT_ELEMENT, HISTORY_TRIAL
 * (trial), HISTORY_ACCEPTED (accepted), or NONE with 0. CTE_ERROR_NULL, CTE_ERROR_NOT_FINITE, CTE_ERROR_HISTORY,
 * CTE_ERROR_ELEMENT: the history has no multiplier. On anything but 0 accepted is as it was. */
int32_t cte_history_augment(const cte_element *element, const double *trial, double *accepted, int32_t *argument);

/* Closest points over the whole domain of the master, for all contact points of the element. No start is needed, and
 * the result is certified: boxes of parameters are excluded by interval arithmetic until one point is left. Read are
 * nnode, nslave, x, u and their strides, parameters and slave_row of *arguments; written are its error_argument and
 * error_index. reach: nothing farther is looked for [length]; 0: no limit. result: [points]. history: null, or the
 * element's history, which then is the initial one at these projections (history_accepted of a first evaluation, which from
 * there takes 1 to 3 Newton steps). Costs some thousand times an evaluation: for starts and lost contacts.
 * 0; CTE_ERROR_NULL, _STRUCT_SIZE, _NODE_COUNT, _PARAMETER, _NOT_FINITE (x, u, slave_row; reach: also below 0),
 * _STRIDE; CTE_ERROR_ELEMENT: a geometry of more than 32 nodes or 2048 operations. On errors found before the first
 * contact point nothing is written. */
int32_t cte_element_project(const cte_element *element, cte_arguments *arguments, double reach, cte_projection *result,
                            double *history);

/* Sizes of a patch's call, as cte_element_info: points and slave_nodes are its slave points. argument (may be null): what
 * is wrong, CTE_ARGUMENT_*. CTE_ERROR_NULL, _STRUCT_SIZE, _NODE_COUNT, _INDEX (connectivity), _NOT_FINITE (reach),
 * CTE_ERROR_ELEMENT: not the facet's edge or vertex. */
int32_t cte_patch_info(const cte_patch *patch, cte_info *info, int32_t *argument);

/* Evaluates a patch. Codes and the scalars at the end of *arguments as cte_element_evaluate; on anything but 0 nothing
 * else is written but the workspace. Time: every facet is looked at for every slave point, near ones are searched. */
int32_t cte_patch_evaluate(const cte_patch *patch, cte_arguments *arguments);

/* Evaluates one element. The scalars at the end of *arguments (dt_ratio .. error_index) are written always
 * but when arguments is null or its struct_size too small; a null element is CTE_ARGUMENT_ELEMENT. */
int32_t cte_element_evaluate(const cte_element *element, cte_arguments *arguments);

/* Doubles of workspace that a batch needs; CTE_ERROR_NULL or CTE_ERROR_NODE_COUNT. */
int64_t cte_element_batch_workspace(const cte_element *element, int32_t nslave);

/* Evaluates n contacts of one element. 0: all fine; CTE_CUT_BACK: some failed, see status and code; < 0:
 * nothing was written but failed, error_argument and error_index (not even those when batch is null or its
 * struct_size too small). n < 0, or too many for any memory: CTE_ERROR_INDEX. */
int32_t cte_element_evaluate_batch(const cte_element *element, int64_t n, cte_batch *batch);

/* The same with the same bits by at most so many threads, and at most one per processor; 0: one per processor. < 0:
 * CTE_ERROR_INDEX, CTE_ARGUMENT_THREADS. A library built without threads, the usual one, evaluates on the calling
 * thread. One built with them keeps its threads from the first call on, in the default floating-point environment;
 * takes memory for the time of the call (a word per node of global_nodes with sums; each thread a workspace and what it
 * has to add to entries of others, at most some 32 MB for each contact point); needs a csr_map of cte_csr_map or
 * cte_csr_blocks, of a pattern whose rows stand one behind the other: a place that two rows share would be added to by
 * two threads at once. Memory that runs out half-way: CTE_ERROR_WORKSPACE, CTE_ARGUMENT_WORKSPACE; all outputs are
 * undefined then. */
int32_t cte_element_evaluate_batch_threads(const cte_element *element, int64_t n, cte_batch *batch, int32_t threads);

/* Makes the scatter map of n elements once: position in the CSR values of every entry of every element
 * matrix. row_start [rows+1], column [row_start[rows]] sorted within each row, rows = global_nodes *
 * dimension; numbers from 0. CTE_ERROR_INDEX when an entry is missing from the pattern, n or rows < 0 or beyond any
 * memory, CTE_ERROR_NODE_COUNT for nslave: as in cte_batch; CTE_ERROR_NULL, with n = 0 for the element alone.
 * map: [n][unknowns][unknowns], written only when everything was found. */
int32_t cte_csr_map(const cte_element *element, int64_t n, int32_t nslave, const int32_t *connectivity,
                    int64_t rows, const int64_t *row_start, const int32_t *column, int64_t *map);

/* The same for CTE_CSR_BY_BLOCKS, with a place for every pair of nodes (PointQuad4: 30 numbers instead of 225):
 * position of the entry in the row of the first unknown of node a and the column of that of node b, for every b;
 * behind these how far the rows of node a are apart (0: the row of a multiplier is alone). Needs what meshes with all
 * unknowns of a node side by side have: rows of a node with the same columns, in them the columns of a node one after
 * another. Where it is not so: CTE_ERROR_INDEX, and cte_csr_map serves. map: [n][nnode][nnode + 1], written only when
 * everything was found. */
int32_t cte_csr_blocks(const cte_element *element, int64_t n, int32_t nslave, const int32_t *connectivity,
                       int64_t rows, const int64_t *row_start, const int32_t *column, int64_t *map);

/* What a return code means; static, never null. */
const char *cte_code_message(int32_t code);

/* What a status means; static, never null. */
const char *cte_status_message(int32_t status);

/* The name of an argument (CTE_ARGUMENT_*); static, never null. */
const char *cte_argument_name(int32_t argument);

/* Writes "argument `parameters`, entry 1 (eps_n): a parameter is outside its range ..." for the outcome of
 * the last evaluation with *arguments. Zero-terminated, cut to size. Returns the length needed. Element and
 * arguments may be null. For a contact of a batch: cte_code_message(code[e]). */
int32_t cte_element_message(const cte_element *element, const cte_arguments *arguments, int32_t code, char *text, int32_t size);

/* For hosts that dlopen: the functions above in one table. */
typedef struct cte_api_table {
  uint32_t struct_size;
  uint32_t version;
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
  int32_t (*csr_map)(const cte_element *, int64_t, int32_t, const int32_t *, int64_t, const int64_t *, const int32_t *, int64_t *);
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
#define CTE_API_TABLE_INIT {(uint32_t)sizeof(cte_api_table), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}

/* Fills *table. major: CTE_VERSION_MAJOR of this header. CTE_ERROR_VERSION when the library's differs. */
int32_t cte_api(uint32_t major, cte_api_table *table);

/* ------------------------------------------------------------------ Fortran 77
 * Everything by address, no CHARACTER arguments, symbols with one trailing underscore. `element` is the
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

/* Element symbols: one per element, int32_t NAME(cte_arguments *), see contact_elements_symbols.h. */

#ifdef __cplusplus
}
#endif
#endif
