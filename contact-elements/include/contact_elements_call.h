/* contact_elements_call.h - what an element is, and one evaluation of it.
 *
 * The headers are the manual: unit, sign, shape, owner and failure of every item. Background:
 * docs/abi.md, docs/notation.md and docs/interface/.
 *
 * Conventions
 *   Pair         A slave point is projected onto a master: a facet, curve, point or rigid body.
 *   Gap          g > 0 open, g < 0 penetrating [length]. Normal traction N = dW/dg; N < 0 in contact.
 *   Force        f = dW/du, the internal force; K = df/du. A host that wants the right-hand side -f asks
 *                for it with f_scale = -1.
 *   Position     The current position is x + u: reference coordinates plus displacements at the end of the
 *                step.
 *   Unknowns     Node by node, component fastest. Slave nodes come first, then master nodes.
 *   Indices      Count from 0.
 *   Units        Any consistent set. Lengths lie between 1e-30 and 1e30.
 *
 * Rules
 *   Pure         The functions use no globals, allocation, I/O, threads or clock. Any number of threads may
 *                call them. The same input gives the same bits.
 *   Memory       The caller owns all memory; nothing is kept after the return. Arrays are aligned for their
 *                type and do not overlap. Exception: history_accepted and history_trial may be one array.
 *   Structs      Every struct begins with its size as the caller compiled it. Later versions add fields at
 *                the end only. Begin a struct with its initialiser, which sets the size, scales of 1 and
 *                zeros: cte_arguments a = CTE_ARGUMENTS_INIT; later on, in C99,
 *                a = (cte_arguments)CTE_ARGUMENTS_INIT; Layouts are those of 64-bit pointers.
 *   Returns      0: done. > 0: recoverable, see CTE_CUT_BACK. < 0: the caller's fault. Unless the return is 0
 *                no array of the caller is written; cte_batch says what holds for batches.
 *   Sizes        A call has at most 2^30 - 1 unknowns. Counts and strides whose products exceed any memory
 *                are refused.
 *   Traps        The library leaves the floating-point environment alone. It raises no invalid,
 *                divide-by-zero or overflow exception. Exception: a declared expression that divides by zero,
 *                overflows or leaves the domain of ln, sqrt or pow may raise a flag first; the status then
 *                reports it, or the projection goes on inside the domain. Two kinds of built-in elements can
 *                do so: rational geometries (beyond the domain, or with weights below 1e-30) and laws whose
 *                values leave the range of a double.
 */
#ifndef CONTACT_ELEMENTS_CALL_H
#define CONTACT_ELEMENTS_CALL_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ version of the interface */
#define CTE_VERSION_MAJOR 1u
#define CTE_VERSION_MINOR 0u
/* The version compiled against; cte_abi_version() is that of the library in use. */
#define CTE_ABI_VERSION_COMPILED ((CTE_VERSION_MAJOR << 16) | CTE_VERSION_MINOR)

/* ------------------------------------------------------------------ parameters
 * cte_element_parameter gives name, unit and range of each, in the order of cte_arguments.parameters.
 * A slave point carries forces. A slave that is integrated carries forces per length or area: N, T and all
 * penalties are then per length or area too.
 *
 *   eps_n                 penalty: N = eps_n g [force/length]
 *   m                     exponent of the power law N = -eps_n (-g)^m
 *   kappa, d              barrier: its strength [force/length], and the gap at which it begins [length]
 *   r0                    offset: g = L - r0, where L is the distance to the master [length]. 0 for solids,
 *                         half the thickness for shells, the sum of the radii for beams, balls and discs
 *   orientation           side of the master on which L is positive. +1 (or 0): the side of the normal n
 *                         below; -1: the other side. Edges of solids: docs/interface/edges.md
 *   eps_t, mu             friction: stiffness while sticking, T = eps_t s [force/length], and coefficient of
 *                         friction, |T| <= mu |N|
 *   eps_1, eps_2, mu_1, mu_2, axis_1, axis_2   the same along two axes; the first is axis_1 b_1 + axis_2 b_2
 *   c, mu_s, mu_k, decay  adhesion [force]; static and kinetic friction, and the path over which their
 *                         difference falls to 1/e [length]
 *   eps_phi, mu_phi       rolling: moment per angle [force*length]; |M| <= mu_phi |N| [length]
 *   slave_director_x .. master_director_z   directions from which the angles of rolling count
 *   angle_low, angle_high two curves: window of angles over which point and line contact are blended [rad]
 *   eta_1, eta_2, weight  fixed point of the slave, and its integration weight
 *   master_weight_a, slave_weight_a   weights of the nodes of a rational curve or surface
 *   origin, quaternion (2D: direction)   where a rigid master stands and how it is turned
 *   radius, half_angle, major, minor, rise   shape of a rigid master, see docs/notation.md
 *
 * The normal n points to the positive side:
 *   surface               towards the side from which its nodes are counter-clockwise
 *   curve in 2D           to the left of the direction from the first node to the last
 *   rigid body            out of the body
 *   point, curve in 3D    from the master to the slave: the gap has no side and no orientation */

typedef struct cte_element cte_element; /* opaque, immutable, static */

/* ------------------------------------------------------------------ cte_info: what an element is */
typedef struct cte_info {
  uint32_t struct_size;      /* set by CTE_INFO_INIT; all other fields are written */
  int32_t dimension;         /* 2 or 3 */
  int32_t nodes_minimum;     /* nodes in a call */
  int32_t nodes_maximum;     /* 0: no limit (interpolated slaves) */
  int32_t slave_nodes;       /* 0: the call gives their number as nslave */
  int32_t master_nodes;      /* 0: rigid master; the remaining nodes are those of multipliers */
  int32_t unknowns;          /* for the nnode asked about */
  int32_t parameters;        /* number of parameters */
  int32_t history;           /* doubles of history */
  int32_t points;            /* contact points; an output has points * CTE_OUTPUT_SIZE doubles */
  int32_t projected;         /* projected parameters per contact point: 0, 1 or 2 */
  uint32_t requests;         /* request bits offered */
  int32_t symmetric;         /* 1: K is symmetric */
  int32_t operations;        /* arithmetic operations of the point programs in one closed evaluation */
  int64_t workspace;         /* doubles of workspace for the nnode asked about */
  uint64_t formulation;      /* hash: changes when the generated code means something else */
  const char *name;          /* zero-terminated, static */
  const char *documentation; /* zero-terminated, static: the comment of the declaration */
} cte_info;
#define CTE_INFO_INIT {(uint32_t)sizeof(cte_info), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0u, 0, 0, 0, 0u, 0, 0}

/* ------------------------------------------------------------------ cte_arguments: one evaluation */
typedef struct cte_arguments {
  /* what every call sets */
  uint32_t struct_size;           /* set by CTE_ARGUMENTS_INIT */
  uint32_t request;               /* what to compute: CTE_RESIDUAL | ... */
  int32_t nnode;                  /* nodes in this call; 0: the element's own number */
  int32_t parameter_count;        /* entries of parameters */
  const double *x;                /* reference coordinates [node][component] [length] */
  const double *u;                /* displacements at the end of the step, same shape; null: zero */
  const double *parameters;       /* [parameter_count], see above */
  const double *history_accepted; /* [cte_info.history]; null: the projection starts from the centre, and
                                   * contact with friction begins here. CTE_ERROR_NULL with
                                   * CTE_FREEZE_STATE, CTE_PROJECTION_GIVEN and edges of orientation 0 */
  double *history_trial;          /* [cte_info.history]; may be the same array as history_accepted */
  double *f;                      /* residual: entry i goes to f[row(i)], row(i) = unknown_map ? unknown_map[i] : i */
  double *k;                      /* tangent: entry (i,j) goes to k[row(i)*k_row_stride + row(j)*k_col_stride] */
  /* what some calls set */
  double *output;                 /* [points][CTE_OUTPUT_SIZE] */
  double *energy;                 /* [1] contact energy [force*length] */
  double f_scale;                 /* f is multiplied by it; CTE_ARGUMENTS_INIT sets 1, and 0 gives zeros */
  double k_scale;                 /* K is multiplied by it, likewise */
  int64_t k_row_stride;           /* both 0: row-major and dense, that is 1 + the largest row, and 1 */
  int64_t k_col_stride;
  const int32_t *unknown_map;     /* row of the host for each unknown, all different (not checked); null: i */
  int64_t x_node_stride;          /* doubles from node to node in x, at least dimension; 0: dimension */
  int64_t u_node_stride;          /* the same in u */
  const double *slave_row;        /* interpolated slaves: shape functions at the slave point [nslave], then its
                                   * weight */
  double *workspace;              /* [cte_info.workspace]; may be null where that is 0, else CTE_ERROR_NULL */
  int64_t workspace_size;         /* doubles in workspace; too few: CTE_ERROR_WORKSPACE */
  int32_t nslave;                 /* interpolated slaves: number of slave nodes; else 0 or the element's own */
  int32_t padding;                /* not read */
  const double *u_old;            /* displacements at the start of the step: for friction where contact begins;
                                   * not read yet */
  const double *v;                /* velocities: for viscous terms; not read yet */
  double dt;                      /* length of the step: for viscous terms; not read yet */
  /* what every call writes, except when arguments is null or of a wrong struct_size */
  double dt_ratio;                /* 1; with CTE_CUT_BACK 0.5, a wish for a smaller step */
  int32_t status;                 /* CTE_STATUS_* of the element */
  int32_t closed_points;          /* number of closed contact points */
  int32_t error_argument;         /* CTE_ARGUMENT_*, see the end of this header; 0 when the return is 0 */
  int32_t error_index;            /* node, entry or contact point, see there */
} cte_arguments;
#define CTE_ARGUMENTS_INIT {(uint32_t)sizeof(cte_arguments), 0u, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.0, 1.0, \
                            0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.0, 0.0, 0, 0, 0, 0}

/* ------------------------------------------------------------------ request bits: what to compute */
#define CTE_RESIDUAL 1u         /* write f */
#define CTE_TANGENT 2u          /* write k */
#define CTE_HISTORY 4u          /* write history_trial */
#define CTE_OUTPUT 8u           /* write output */
#define CTE_ENERGY 16u          /* write energy (elements whose law declares W) */
#define CTE_FREEZE_STATE 32u    /* Keep each point's state from history_accepted regardless of the gap (for line
                                 * searches): CLOSED, STICK, SLIP stay in contact, everything else stays open.
                                 * Points outside remain outside. Friction: docs/interface/friction.md */
#define CTE_SYMMETRISE 64u      /* write (K + K^T)/2; with friction this is not the exact tangent */
#define CTE_PROJECTION_GIVEN 128u /* history_accepted holds the projection itself: no iteration */
#define CTE_SCREEN 256u         /* batches only, see cte_batch */
#define CTE_CSR_BY_BLOCKS 512u  /* batches only: csr_map comes from cte_csr_blocks */

/* ------------------------------------------------------------------ status of a contact point
 * The element's status is that of its worst point, in the order open < outside < closed, stick < slip < the
 * failures 5 to 8, which return CTE_CUT_BACK. Elements with friction report STICK and SLIP, never CLOSED. */
#define CTE_STATUS_OPEN 0          /* no contact: f, k and energy are zero, but for an unknown multiplier */
#define CTE_STATUS_CLOSED 1        /* in contact, without friction */
#define CTE_STATUS_STICK 2         /* in contact, held by its anchor */
#define CTE_STATUS_SLIP 3          /* in contact, sliding: the tangential force is at its bound */
#define CTE_STATUS_OUTSIDE 4       /* the projection lies beyond an edge or vertex of the master: as open */
#define CTE_STATUS_NOT_CONVERGED 5 /* the projection did not converge */
#define CTE_STATUS_NOT_UNIQUE 6    /* the projection is not unique: focal surface, axis or parallel tangents */
#define CTE_STATUS_DEGENERATE 7    /* An area or length is zero; L = 0 where the gap has no side; the point is on
                                    * the axis or at the centre of a distance function; the gap is NaN; an axis
                                    * of friction has no length or is normal to the master. Rolling: a curve has
                                    * no curvature, or a director no length or the direction of its curve */
#define CTE_STATUS_LAW 8           /* The gap is outside the normal law's domain (barrier passed); N, N' or W is
                                    * NaN or exceeds 1e90; a value of the tangential law is NaN */

/* ------------------------------------------------------------------ kinds of unknowns */
#define CTE_UNKNOWN_UX 1         /* displacement x [length] */
#define CTE_UNKNOWN_UY 2
#define CTE_UNKNOWN_UZ 3
#define CTE_UNKNOWN_TX 4         /* change of the tangent vector d rho/d xi of a Hermite curve, x [length] */
#define CTE_UNKNOWN_TY 5
#define CTE_UNKNOWN_TZ 6
#define CTE_UNKNOWN_MULTIPLIER 7 /* multiplier of a contact point [as N]: the only unknown of its node. In u it is
                                  * the first component of the node; x of that node is not read */

/* ------------------------------------------------------------------ output of one contact point
 * output[point * CTE_OUTPUT_SIZE + entry]: */
#define CTE_OUTPUT_STATUS 0          /* CTE_STATUS_* as a number */
#define CTE_OUTPUT_GAP 1             /* gap g [length]; 0 where the projection failed */
#define CTE_OUTPUT_NORMAL_TRACTION 2 /* N [force, or force per length or area]; 0 where not closed */
#define CTE_OUTPUT_WEIGHT 3          /* integration weight times Jacobian, 1 for points; 0 where not closed */
#define CTE_OUTPUT_PROJECTION 4      /* two entries: projected parameters, slave curve first */
#define CTE_OUTPUT_NORMAL 6          /* three entries: unit normal */
#define CTE_OUTPUT_ITERATIONS 9      /* Newton iterations of the projection */
#define CTE_OUTPUT_FEATURE 10        /* 0 inside, else what the projection lies beyond, see below */
#define CTE_OUTPUT_TANGENTIAL_TRACTION 11 /* two entries: T_1, T_2 [as N]. T_1 d_1 + T_2 d_2 is the friction on the
                                 * slave (on curved masters at zero gap; f has it at any gap). d_1 points along
                                 * b_1, or along the first axis of an orthotropic law; d_2 = n x d_1. T_2 = 0
                                 * with one projected parameter; both 0 without friction or contact */
#define CTE_OUTPUT_TANGENTS 13       /* six entries: b_1, b_2 [length per unit of the projected parameter]. For a
                                 * slave curve its tangent, for the master minus its tangent; else 0 */
#define CTE_OUTPUT_ANGLES 19         /* two entries: phi_1, phi_2 [rad], see docs/interface/rolling.md; 0 without
                                 * rolling or contact */
#define CTE_OUTPUT_MOMENTS 21        /* two entries: moments M_1, M_2 about the slave's and the master's curve
                                 * [N times length per rad]; 0 without rolling or contact */
#define CTE_OUTPUT_SIZE 23
/* CTE_OUTPUT_FEATURE
 *   quadrilateral    1 + edge: 0 between corners 0 and 1 (eta low), 1 between 1 and 2, 2 between 2 and 3, 3
 *                    between 3 and 0. 5 + corner: 0 to 3, counter-clockwise in (xi, eta) from (low, low). The
 *                    corners are the first nodes; of 3 x 3 Bezier controls they are 0, 2, 8, 6.
 *   triangle         1 + edge: 0 between corners 0 and 1, 1 between 1 and 2, 2 between 2 and 0. 5 + corner.
 *   curve            5 lower end, 6 upper end.
 *   curve to curve   1, 2 lower and upper end of the slave; 3, 4 of the master. Beyond both:
 *                    5 + slave end + 2 * master end, an end being 0 (lower) or 1 (upper). */

/* ------------------------------------------------------------------ history of one contact point
 * A history has cte_info.history = points * entries per point doubles. With P projected parameters:
 *   without friction  1 + P    status, projection [P]
 *   with friction     2 + 2 P  status, projection [P], anchor [P], slip path [length]
 *   with rolling      11       as with friction (P = 2), then phi0_1, phi0_2, path_1, path_2 [rad] and the regime:
 *                              0 no curve rolls, 1 the slave's, 2 the master's, 3 both
 *   edges of solids   3 more   the unit normal that tells the side
 *   augmented         1 more   the multiplier [as N], never positive; always the last entry
 * history_accepted is the accepted history: that of the last converged step. history_trial is a proposal that no
 * evaluation reads. To accept a step the host copies history_trial over history_accepted, all of it. To cut a
 * step back it drops history_trial.
 * An all-zero history is a valid beginning for every element: nothing has been in contact, and the projection starts
 * from the centre of the domain, as with the history that cte_element_history_init writes.
 * Rules of each kind: docs/interface/friction.md, edges.md, rolling.md, multipliers.md. */
#define CTE_HISTORY_STATUS 0     /* CTE_STATUS_* as a number */
#define CTE_HISTORY_PROJECTION 1 /* P entries, then the others in the order above */

/* ------------------------------------------------------------------ return codes */
#define CTE_SUCCESS 0
#define CTE_CUT_BACK 1             /* Recoverable: the state cannot be evaluated. Redo the increment with a smaller
                                    * step. `status` says why, `error_index` at which contact point */
#define CTE_ERROR_NULL (-1)        /* a required pointer is null */
#define CTE_ERROR_STRUCT_SIZE (-2) /* struct_size is smaller than in version 1.0, or that of 0.1 */
#define CTE_ERROR_NODE_COUNT (-3)  /* nnode or nslave does not fit the element, or gives too many unknowns */
#define CTE_ERROR_PARAMETER (-4)   /* a parameter is missing or outside its range */
#define CTE_ERROR_REQUEST (-5)     /* an unknown request bit, or one that this element does not offer */
#define CTE_ERROR_WORKSPACE (-6)   /* the workspace is smaller than cte_info.workspace */
#define CTE_ERROR_NOT_FINITE (-7)  /* an input is NaN, infinite or beyond 1e30 */
#define CTE_ERROR_INDEX (-8)       /* an index (element, node, map) or a number of contacts is out of range */
#define CTE_ERROR_NAME (-9)        /* no element has that name */
#define CTE_ERROR_VERSION (-10)    /* the library has another major version */
#define CTE_ERROR_STRIDE (-11)     /* strides are negative, let entries overlap or exceed any memory */
#define CTE_ERROR_HISTORY (-12)    /* The history could not come from this library: invalid status or regime,
                                    * projection or anchor out of range, negative path, an angle beyond 1000 rad,
                                    * non-unit normal, positive multiplier. In cte_history_transfer also: history
                                    * and output belong to different states */
#define CTE_ERROR_ELEMENT (-13)    /* the element is of the wrong kind for cte_history_transfer, cte_history_augment,
                                    * cte_element_project or its place in a cte_patch */

/* ------------------------------------------------------------------ functions */

/* Version of the interface of the library in use: major << 16 | minor. */
uint32_t cte_abi_version(void);

/* Number of elements. */
int32_t cte_element_count(void);

/* The element at an index from 0 to count - 1; null outside. Indices never change within a major version. */
const cte_element *cte_element_get(int32_t index);

/* Finds the index of an element by its name. The name need not be zero-terminated; trailing blanks are ignored
 * (Fortran). Returns 0, CTE_ERROR_NULL or CTE_ERROR_NAME. */
int32_t cte_element_find(const char *name, int32_t length, int32_t *index);

/* Describes an element. nnode: nodes of a call (matters for interpolated slaves; 0: the minimum). Returns 0,
 * CTE_ERROR_NULL, CTE_ERROR_STRUCT_SIZE or, when nnode does not fit, CTE_ERROR_NODE_COUNT. */
int32_t cte_element_info(const cte_element *element, int32_t nnode, cte_info *info);

/* Gives node and kind (CTE_UNKNOWN_*) of the unknown `index` of a call with nnode nodes. */
int32_t cte_element_unknown(const cte_element *element, int32_t nnode, int32_t index, int32_t *node, int32_t *kind);

/* Gives name and unit (static, zero-terminated) and range of the parameter `index`. Any output may be null.
 * Bits of *closed: 1 the lower bound is allowed, 2 the upper bound is. */
int32_t cte_element_parameter(const cte_element *element, int32_t index, const char **name, const char **unit,
                              double *lower, double *upper, int32_t *closed);

/* Checks parameters. Returns 0, or CTE_ERROR_PARAMETER or CTE_ERROR_NOT_FINITE with the first bad one in *index.
 * Where an element blends over a window of angles, angle_high must exceed angle_low by 1e-6 rad. */
int32_t cte_element_check_parameters(const cte_element *element, const double *parameters, int32_t count,
                                     int32_t *index);

/* Writes an initial history: open, projection and anchor at the centre of the domain, all else 0. */
int32_t cte_element_history_init(const cte_element *element, double *history);

/* Evaluates one element. A null element is reported as CTE_ARGUMENT_ELEMENT. */
int32_t cte_element_evaluate(const cte_element *element, cte_arguments *arguments);

/* Says what a return code means; static, never null. */
const char *cte_code_message(int32_t code);

/* Says what a status means; static, never null. */
const char *cte_status_message(int32_t status);

/* Gives the name of an argument (CTE_ARGUMENT_*); static, never null. */
const char *cte_argument_name(int32_t argument);

/* Writes what went wrong in the last evaluation with *arguments: "PointQuad4: argument `parameters`, entry 0
 * (eps_n): a parameter is outside its range". The text is zero-terminated and cut to size. Returns the length
 * needed. Element and arguments may be null. For a contact of a batch use cte_code_message(code[e]). */
int32_t cte_element_message(const cte_element *element, const cte_arguments *arguments, int32_t code, char *text,
                            int32_t size);

/* ------------------------------------------------------------------ arguments named by errors
 * error_index: the node for X and U (as counted in the call); the parameter for PARAMETERS; the bit number for
 * REQUEST; the entry for HISTORY_ACCEPTED, SLAVE_ROW, UNKNOWN_MAP and CONNECTIVITY; 0 for the others. With
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
#define CTE_ARGUMENT_BATCH 22 /* the number of contacts of a batch */
#define CTE_ARGUMENT_CONNECTIVITY 23
#define CTE_ARGUMENT_CSR 24
#define CTE_ARGUMENT_STATUS 25
#define CTE_ARGUMENT_FROM 26 /* cte_history_transfer */
#define CTE_ARGUMENT_FROM_OUTPUT 27
#define CTE_ARGUMENT_FROM_HISTORY 28
#define CTE_ARGUMENT_TO 29
#define CTE_ARGUMENT_TO_OUTPUT 30
#define CTE_ARGUMENT_TO_HISTORY 31
#define CTE_ARGUMENT_REACH 32 /* cte_element_project and cte_patch */
#define CTE_ARGUMENT_RESULT 33
#define CTE_ARGUMENT_PATCH 34 /* cte_patch */
#define CTE_ARGUMENT_FACETS 35
#define CTE_ARGUMENT_FACET 36
#define CTE_ARGUMENT_EDGE 37
#define CTE_ARGUMENT_VERTEX 38
#define CTE_ARGUMENT_THREADS 39 /* cte_element_evaluate_batch_threads */

#ifdef __cplusplus
}
#endif
#endif
