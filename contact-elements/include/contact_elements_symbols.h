/* Index and function of every element of the library `cte`; rules: contact_elements.h. */
#ifndef CTE_SYMBOLS_H
#define CTE_SYMBOLS_H

#include "contact_elements.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Two points: discs or balls with r0 = sum of radii. */
#define CTE_POINT_POINT 0
int32_t cte_point_point(cte_arguments *arguments);

/* Point against a straight segment. */
#define CTE_POINT_LINE2 1
int32_t cte_point_line2(cte_arguments *arguments);

/* Point against a quadratic curve. */
#define CTE_POINT_LINE3 2
int32_t cte_point_line3(cte_arguments *arguments);

/* Point against a cubic Hermite curve. */
#define CTE_POINT_HERMITE 3
int32_t cte_point_hermite(cte_arguments *arguments);

/* Point against a quadratic Bezier curve. */
#define CTE_POINT_BEZIER_CURVE2 4
int32_t cte_point_bezier_curve2(cte_arguments *arguments);

/* Point against a cubic Bezier curve. */
#define CTE_POINT_BEZIER_CURVE3 5
int32_t cte_point_bezier_curve3(cte_arguments *arguments);

/* Point against a rational quadratic Bezier curve. */
#define CTE_POINT_RATIONAL_CURVE2 6
int32_t cte_point_rational_curve2(cte_arguments *arguments);

/* Point against a rational cubic Bezier curve. */
#define CTE_POINT_RATIONAL_CURVE3 7
int32_t cte_point_rational_curve3(cte_arguments *arguments);

/* Point against a flat triangle. */
#define CTE_POINT_TRI3 8
int32_t cte_point_tri3(cte_arguments *arguments);

/* Point against a quadratic triangle. */
#define CTE_POINT_TRI6 9
int32_t cte_point_tri6(cte_arguments *arguments);

/* Point against a bilinear facet. */
#define CTE_POINT_QUAD4 10
int32_t cte_point_quad4(cte_arguments *arguments);

/* Point against a biquadratic facet. */
#define CTE_POINT_QUAD9 11
int32_t cte_point_quad9(cte_arguments *arguments);

/* Point against a biquadratic Bezier facet. */
#define CTE_POINT_BEZIER_SURFACE2 12
int32_t cte_point_bezier_surface2(cte_arguments *arguments);

/* Point against a rational biquadratic Bezier facet. */
#define CTE_POINT_RATIONAL_SURFACE2 13
int32_t cte_point_rational_surface2(cte_arguments *arguments);

/* Point against a bilinear facet, power law. */
#define CTE_POINT_QUAD4_POWER_LAW 14
int32_t cte_point_quad4_power_law(cte_arguments *arguments);

/* Point against a bilinear facet, logarithmic barrier. */
#define CTE_POINT_QUAD4_LOG_BARRIER 15
int32_t cte_point_quad4_log_barrier(cte_arguments *arguments);

/* Point against a bilinear facet, linearised on the tangent plane: exact at zero gap only. */
#define CTE_POINT_QUAD4_TANGENT_PLANE 16
int32_t cte_point_quad4_tangent_plane(cte_arguments *arguments);

/* Point against a biquadratic facet, linearised on the tangent plane: exact at zero gap only. */
#define CTE_POINT_QUAD9_TANGENT_PLANE 17
int32_t cte_point_quad9_tangent_plane(cte_arguments *arguments);

/* Point against a bilinear facet, residual only. */
#define CTE_POINT_QUAD4_RESIDUAL 18
int32_t cte_point_quad4_residual(cte_arguments *arguments);

/* Point against a placed rigid plane. */
#define CTE_POINT_PLANE 19
int32_t cte_point_plane(cte_arguments *arguments);

/* Point against a placed rigid cylinder. */
#define CTE_POINT_CYLINDER 20
int32_t cte_point_cylinder(cte_arguments *arguments);

/* Point against a placed rigid sphere. */
#define CTE_POINT_SPHERE 21
int32_t cte_point_sphere(cte_arguments *arguments);

/* Point against a placed rigid cone. */
#define CTE_POINT_CONE 22
int32_t cte_point_cone(cte_arguments *arguments);

/* Point against a placed rigid torus. */
#define CTE_POINT_TORUS 23
int32_t cte_point_torus(cte_arguments *arguments);

/* Point against a placed rigid plane, by its distance function. */
#define CTE_POINT_PLANE_DISTANCE 24
int32_t cte_point_plane_distance(cte_arguments *arguments);

/* Point against a placed rigid cylinder, by its distance function. */
#define CTE_POINT_CYLINDER_DISTANCE 25
int32_t cte_point_cylinder_distance(cte_arguments *arguments);

/* Point against a placed rigid sphere, by its distance function. */
#define CTE_POINT_SPHERE_DISTANCE 26
int32_t cte_point_sphere_distance(cte_arguments *arguments);

/* Point against a placed rigid cone, by its distance function. */
#define CTE_POINT_CONE_DISTANCE 27
int32_t cte_point_cone_distance(cte_arguments *arguments);

/* Point against a placed rigid torus, by its distance function. */
#define CTE_POINT_TORUS_DISTANCE 28
int32_t cte_point_torus_distance(cte_arguments *arguments);

/* Point against a placed rigid circle (a ring of wire). */
#define CTE_POINT_CIRCLE 29
int32_t cte_point_circle(cte_arguments *arguments);

/* Point against a placed rigid helix (a coil of wire). */
#define CTE_POINT_HELIX 30
int32_t cte_point_helix(cte_arguments *arguments);

/* Two straight beams. */
#define CTE_LINE2_LINE2_BEAMS 31
int32_t cte_line2_line2_beams(cte_arguments *arguments);

/* Two quadratic beams. */
#define CTE_LINE3_LINE3_BEAMS 32
int32_t cte_line3_line3_beams(cte_arguments *arguments);

/* Two cubic Hermite beams. */
#define CTE_HERMITE_HERMITE_BEAMS 33
int32_t cte_hermite_hermite_beams(cte_arguments *arguments);

/* A straight beam and a cubic Hermite beam. */
#define CTE_LINE2_HERMITE_BEAMS 34
int32_t cte_line2_hermite_beams(cte_arguments *arguments);

/* Two cubic Bezier beams. */
#define CTE_BEZIER_CURVE3_BEZIER_CURVE3_BEAMS 35
int32_t cte_bezier_curve3_bezier_curve3_beams(cte_arguments *arguments);

/* Two rational quadratic Bezier beams. */
#define CTE_RATIONAL_CURVE2_RATIONAL_CURVE2_BEAMS 36
int32_t cte_rational_curve2_rational_curve2_beams(cte_arguments *arguments);

/* A cubic Hermite beam and a placed rigid circle. */
#define CTE_HERMITE_CIRCLE_BEAMS 37
int32_t cte_hermite_circle_beams(cte_arguments *arguments);

/* Two straight edges of solids. */
#define CTE_LINE2_LINE2_EDGES 38
int32_t cte_line2_line2_edges(cte_arguments *arguments);

/* Two quadratic edges of solids. */
#define CTE_LINE3_LINE3_EDGES 39
int32_t cte_line3_line3_edges(cte_arguments *arguments);

/* Two cubic Hermite edges of solids. */
#define CTE_HERMITE_HERMITE_EDGES 40
int32_t cte_hermite_hermite_edges(cte_arguments *arguments);

/* A straight edge and a cubic Hermite edge. */
#define CTE_LINE2_HERMITE_EDGES 41
int32_t cte_line2_hermite_edges(cte_arguments *arguments);

/* Two cubic Bezier edges of solids. */
#define CTE_BEZIER_CURVE3_BEZIER_CURVE3_EDGES 42
int32_t cte_bezier_curve3_bezier_curve3_edges(cte_arguments *arguments);

/* Two straight beams, linearised on the tangent plane. */
#define CTE_LINE2_LINE2_BEAMS_TANGENT_PLANE 43
int32_t cte_line2_line2_beams_tangent_plane(cte_arguments *arguments);

/* Line contact of two straight beams: integrated along the slave. */
#define CTE_LINE2_LINE2_LINE_CONTACT 44
int32_t cte_line2_line2_line_contact(cte_arguments *arguments);

/* Line contact of two cubic Hermite beams: integrated along the slave. */
#define CTE_HERMITE_HERMITE_LINE_CONTACT 45
int32_t cte_hermite_hermite_line_contact(cte_arguments *arguments);

/* A straight edge on a bilinear facet. */
#define CTE_LINE2_QUAD4 46
int32_t cte_line2_quad4(cte_arguments *arguments);

/* A cubic Hermite curve on a bilinear facet. */
#define CTE_HERMITE_QUAD4 47
int32_t cte_hermite_quad4(cte_arguments *arguments);

/* A quadratic edge on a biquadratic facet. */
#define CTE_LINE3_QUAD9 48
int32_t cte_line3_quad9(cte_arguments *arguments);

/* A straight edge on a bilinear facet, force per current length. */
#define CTE_LINE2_QUAD4_CURRENT 49
int32_t cte_line2_quad4_current(cte_arguments *arguments);

/* A rational quadratic curve on a placed rigid torus. */
#define CTE_RATIONAL_CURVE2_TORUS 50
int32_t cte_rational_curve2_torus(cte_arguments *arguments);

/* One point of a straight edge, given at run time, on a bilinear facet. */
#define CTE_LINE2_QUAD4_AT_POINT 51
int32_t cte_line2_quad4_at_point(cte_arguments *arguments);

/* One point of a cubic Hermite curve, given at run time, on a bilinear facet. */
#define CTE_HERMITE_QUAD4_AT_POINT 52
int32_t cte_hermite_quad4_at_point(cte_arguments *arguments);

/* One point of a quadratic edge, given at run time, on a biquadratic facet. */
#define CTE_LINE3_QUAD9_AT_POINT 53
int32_t cte_line3_quad9_at_point(cte_arguments *arguments);

/* Flat triangle on flat triangle. */
#define CTE_TRI3_TRI3 54
int32_t cte_tri3_tri3(cte_arguments *arguments);

/* Quadratic triangle on quadratic triangle. */
#define CTE_TRI6_TRI6 55
int32_t cte_tri6_tri6(cte_arguments *arguments);

/* Bilinear facet on bilinear facet. */
#define CTE_QUAD4_QUAD4 56
int32_t cte_quad4_quad4(cte_arguments *arguments);

/* Biquadratic facet on biquadratic facet. */
#define CTE_QUAD9_QUAD9 57
int32_t cte_quad9_quad9(cte_arguments *arguments);

/* Quadratic triangle on biquadratic facet. */
#define CTE_TRI6_QUAD9 58
int32_t cte_tri6_quad9(cte_arguments *arguments);

/* Bilinear facet on bilinear facet, traction per current area. */
#define CTE_QUAD4_QUAD4_CURRENT 59
int32_t cte_quad4_quad4_current(cte_arguments *arguments);

/* One point of a bilinear facet, given at run time, on a bilinear facet, linearised on the tangent plane. */
#define CTE_QUAD4_QUAD4_AT_POINT_TANGENT_PLANE 60
int32_t cte_quad4_quad4_at_point_tangent_plane(cte_arguments *arguments);

/* Rational biquadratic facet on rational biquadratic facet. */
#define CTE_RATIONAL_SURFACE2_RATIONAL_SURFACE2 61
int32_t cte_rational_surface2_rational_surface2(cte_arguments *arguments);

/* Bilinear facet on a placed rigid sphere, by its distance function. */
#define CTE_QUAD4_SPHERE_DISTANCE 62
int32_t cte_quad4_sphere_distance(cte_arguments *arguments);

/* Bilinear facet on a placed rigid cylinder, traction per current area. */
#define CTE_QUAD4_CYLINDER_CURRENT 63
int32_t cte_quad4_cylinder_current(cte_arguments *arguments);

/* One point of a flat triangle, given at run time, on a flat triangle. */
#define CTE_TRI3_TRI3_AT_POINT 64
int32_t cte_tri3_tri3_at_point(cte_arguments *arguments);

/* One point of a quadratic triangle, given at run time, on a quadratic triangle. */
#define CTE_TRI6_TRI6_AT_POINT 65
int32_t cte_tri6_tri6_at_point(cte_arguments *arguments);

/* One point of a bilinear facet, given at run time, on a bilinear facet. */
#define CTE_QUAD4_QUAD4_AT_POINT 66
int32_t cte_quad4_quad4_at_point(cte_arguments *arguments);

/* One point of a biquadratic facet, given at run time, on a biquadratic facet. */
#define CTE_QUAD9_QUAD9_AT_POINT 67
int32_t cte_quad9_quad9_at_point(cte_arguments *arguments);

/* One point of a quadratic triangle, given at run time, on a biquadratic facet. */
#define CTE_TRI6_QUAD9_AT_POINT 68
int32_t cte_tri6_quad9_at_point(cte_arguments *arguments);

/* A point of any discretisation against a bilinear facet: shape row and weight come at run time. */
#define CTE_INTERPOLATED_QUAD4 69
int32_t cte_interpolated_quad4(cte_arguments *arguments);

/* A point of any discretisation against a flat triangle. */
#define CTE_INTERPOLATED_TRI3 70
int32_t cte_interpolated_tri3(cte_arguments *arguments);

/* A point of any discretisation against a cubic Hermite curve. */
#define CTE_INTERPOLATED_HERMITE 71
int32_t cte_interpolated_hermite(cte_arguments *arguments);

/* A point of any discretisation against a point. */
#define CTE_INTERPOLATED_POINT 72
int32_t cte_interpolated_point(cte_arguments *arguments);

/* A point of any discretisation against a placed rigid plane. */
#define CTE_INTERPOLATED_PLANE 73
int32_t cte_interpolated_plane(cte_arguments *arguments);

/* A point of any discretisation against a placed rigid torus. */
#define CTE_INTERPOLATED_TORUS 74
int32_t cte_interpolated_torus(cte_arguments *arguments);

/* A point of any discretisation against a placed rigid sphere, by its distance function. */
#define CTE_INTERPOLATED_SPHERE_DISTANCE 75
int32_t cte_interpolated_sphere_distance(cte_arguments *arguments);

/* Two points in the plane. */
#define CTE_POINT_POINT2D 76
int32_t cte_point_point2d(cte_arguments *arguments);

/* Point against a straight segment in the plane, signed gap along its left normal. */
#define CTE_POINT_LINE2_IN2D 77
int32_t cte_point_line2_in2d(cte_arguments *arguments);

/* Point against a quadratic segment in the plane. */
#define CTE_POINT_LINE3_IN2D 78
int32_t cte_point_line3_in2d(cte_arguments *arguments);

/* Point against a cubic Hermite curve in the plane. */
#define CTE_POINT_HERMITE_IN2D 79
int32_t cte_point_hermite_in2d(cte_arguments *arguments);

/* Point against a rational quadratic Bezier curve in the plane. */
#define CTE_POINT_RATIONAL_CURVE2_IN2D 80
int32_t cte_point_rational_curve2_in2d(cte_arguments *arguments);

/* Straight segment on straight segment in the plane. */
#define CTE_LINE2_LINE2_IN2D 81
int32_t cte_line2_line2_in2d(cte_arguments *arguments);

/* Straight segment on straight segment in the plane, traction per current length. */
#define CTE_LINE2_LINE2_IN2D_CURRENT 82
int32_t cte_line2_line2_in2d_current(cte_arguments *arguments);

/* Point against a placed rigid circle in the plane. */
#define CTE_POINT_CIRCLE2D 83
int32_t cte_point_circle2d(cte_arguments *arguments);

/* Point against a placed rigid circle in the plane, by its distance function. */
#define CTE_POINT_CIRCLE_DISTANCE2D 84
int32_t cte_point_circle_distance2d(cte_arguments *arguments);

/* A point of any discretisation against a placed rigid circle in the plane, by its distance function. */
#define CTE_INTERPOLATED_CIRCLE_DISTANCE2D 85
int32_t cte_interpolated_circle_distance2d(cte_arguments *arguments);

/* Point against a flat triangle, Coulomb friction. */
#define CTE_POINT_TRI3_COULOMB 86
int32_t cte_point_tri3_coulomb(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction. */
#define CTE_POINT_QUAD4_COULOMB 87
int32_t cte_point_quad4_coulomb(cte_arguments *arguments);

/* Point against a biquadratic facet, Coulomb friction. */
#define CTE_POINT_QUAD9_COULOMB 88
int32_t cte_point_quad9_coulomb(cte_arguments *arguments);

/* Point against a biquadratic Bezier facet, Coulomb friction. */
#define CTE_POINT_BEZIER_SURFACE2_COULOMB 89
int32_t cte_point_bezier_surface2_coulomb(cte_arguments *arguments);

/* Point against a rational biquadratic Bezier facet, Coulomb friction. */
#define CTE_POINT_RATIONAL_SURFACE2_COULOMB 90
int32_t cte_point_rational_surface2_coulomb(cte_arguments *arguments);

/* Point against a placed rigid plane, Coulomb friction. */
#define CTE_POINT_PLANE_COULOMB 91
int32_t cte_point_plane_coulomb(cte_arguments *arguments);

/* Point against a placed rigid cylinder, Coulomb friction. */
#define CTE_POINT_CYLINDER_COULOMB 92
int32_t cte_point_cylinder_coulomb(cte_arguments *arguments);

/* Point against a placed rigid torus, Coulomb friction. */
#define CTE_POINT_TORUS_COULOMB 93
int32_t cte_point_torus_coulomb(cte_arguments *arguments);

/* Point against a cubic Hermite curve, Coulomb friction along it. */
#define CTE_POINT_HERMITE_COULOMB 94
int32_t cte_point_hermite_coulomb(cte_arguments *arguments);

/* Point against a placed rigid helix, Coulomb friction along it. */
#define CTE_POINT_HELIX_COULOMB 95
int32_t cte_point_helix_coulomb(cte_arguments *arguments);

/* Two straight beams, Coulomb friction. */
#define CTE_LINE2_LINE2_BEAMS_COULOMB 96
int32_t cte_line2_line2_beams_coulomb(cte_arguments *arguments);

/* Two cubic Hermite beams, Coulomb friction. */
#define CTE_HERMITE_HERMITE_BEAMS_COULOMB 97
int32_t cte_hermite_hermite_beams_coulomb(cte_arguments *arguments);

/* Two straight edges of solids, Coulomb friction. */
#define CTE_LINE2_LINE2_EDGES_COULOMB 98
int32_t cte_line2_line2_edges_coulomb(cte_arguments *arguments);

/* Two cubic Hermite edges, Coulomb friction. */
#define CTE_HERMITE_HERMITE_EDGES_COULOMB 99
int32_t cte_hermite_hermite_edges_coulomb(cte_arguments *arguments);

/* Cubic Hermite curve on a bilinear facet: pulling friction along the curve, dragging friction across. */
#define CTE_HERMITE_QUAD4_ORTHOTROPIC 100
int32_t cte_hermite_quad4_orthotropic(cte_arguments *arguments);

/* One point of a cubic Hermite curve on a bilinear facet: pulling friction along the curve, dragging */
/* friction across. */
#define CTE_HERMITE_QUAD4_ORTHOTROPIC_AT_POINT 101
int32_t cte_hermite_quad4_orthotropic_at_point(cte_arguments *arguments);

/* One point of a cubic Hermite curve on a bilinear facet, friction by the curve's own form, which is the one on */
/* the tangent plane. */
#define CTE_HERMITE_QUAD4_ORTHOTROPIC_AT_POINT_TANGENT_PLANE 102
int32_t cte_hermite_quad4_orthotropic_at_point_tangent_plane(cte_arguments *arguments);

/* One point of a straight line on a biquadratic facet: pulling friction along the line, dragging friction */
/* across. */
#define CTE_LINE2_QUAD9_ORTHOTROPIC_AT_POINT 103
int32_t cte_line2_quad9_orthotropic_at_point(cte_arguments *arguments);

/* Straight rope segment on a placed rigid cylinder: pulling friction along it, dragging friction across. */
#define CTE_LINE2_CYLINDER_ORTHOTROPIC 104
int32_t cte_line2_cylinder_orthotropic(cte_arguments *arguments);

/* Bilinear facet on bilinear facet, Coulomb friction. */
#define CTE_QUAD4_QUAD4_COULOMB 105
int32_t cte_quad4_quad4_coulomb(cte_arguments *arguments);

/* One point of a bilinear facet on a bilinear facet, Coulomb friction. */
#define CTE_QUAD4_QUAD4_COULOMB_AT_POINT 106
int32_t cte_quad4_quad4_coulomb_at_point(cte_arguments *arguments);

/* Bilinear facet on bilinear facet, Coulomb friction, area of the current configuration. */
#define CTE_QUAD4_QUAD4_COULOMB_CURRENT 107
int32_t cte_quad4_quad4_coulomb_current(cte_arguments *arguments);

/* Slave of any discretisation on a bilinear facet, Coulomb friction. */
#define CTE_INTERPOLATED_QUAD4_COULOMB 108
int32_t cte_interpolated_quad4_coulomb(cte_arguments *arguments);

/* Slave of any discretisation on a placed rigid cylinder, Coulomb friction. */
#define CTE_INTERPOLATED_CYLINDER_COULOMB 109
int32_t cte_interpolated_cylinder_coulomb(cte_arguments *arguments);

/* Point against a bilinear facet, tied while in contact. */
#define CTE_POINT_QUAD4_STICK 110
int32_t cte_point_quad4_stick(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction with adhesion. */
#define CTE_POINT_QUAD4_COULOMB_ADHESIVE 111
int32_t cte_point_quad4_coulomb_adhesive(cte_arguments *arguments);

/* Point against a bilinear facet, static and kinetic friction. */
#define CTE_POINT_QUAD4_COULOMB_STATIC_KINETIC 112
int32_t cte_point_quad4_coulomb_static_kinetic(cte_arguments *arguments);

/* Point against a bilinear facet, orthotropic friction along axes that the facet convects. */
#define CTE_POINT_QUAD4_ORTHOTROPIC 113
int32_t cte_point_quad4_orthotropic(cte_arguments *arguments);

/* Point against a placed rigid plane, orthotropic friction along axes of the plane. */
#define CTE_POINT_PLANE_ORTHOTROPIC 114
int32_t cte_point_plane_orthotropic(cte_arguments *arguments);

/* Point against a bilinear facet, power law and Coulomb friction. */
#define CTE_POINT_QUAD4_POWER_LAW_COULOMB 115
int32_t cte_point_quad4_power_law_coulomb(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction on the tangent plane: exact at zero gap only. */
#define CTE_POINT_QUAD4_COULOMB_TANGENT_PLANE 116
int32_t cte_point_quad4_coulomb_tangent_plane(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction, residual only. */
#define CTE_POINT_QUAD4_COULOMB_RESIDUAL 117
int32_t cte_point_quad4_coulomb_residual(cte_arguments *arguments);

/* Point against a straight segment in the plane, Coulomb friction. */
#define CTE_POINT_LINE2_COULOMB2D 118
int32_t cte_point_line2_coulomb2d(cte_arguments *arguments);

/* Point against a quadratic curve in the plane, Coulomb friction. */
#define CTE_POINT_LINE3_COULOMB2D 119
int32_t cte_point_line3_coulomb2d(cte_arguments *arguments);

/* Point against a placed rigid circle in the plane, Coulomb friction. */
#define CTE_POINT_CIRCLE_COULOMB2D 120
int32_t cte_point_circle_coulomb2d(cte_arguments *arguments);

/* Straight segment on straight segment in the plane, Coulomb friction. */
#define CTE_LINE2_LINE2_COULOMB2D 121
int32_t cte_line2_line2_coulomb2d(cte_arguments *arguments);

/* Point against a bilinear facet, augmented by a multiplier of the history. */
#define CTE_POINT_QUAD4_AUGMENTED 122
int32_t cte_point_quad4_augmented(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction, augmented by a multiplier of the history. */
#define CTE_POINT_QUAD4_COULOMB_AUGMENTED 123
int32_t cte_point_quad4_coulomb_augmented(cte_arguments *arguments);

/* Two cubic Hermite beams, augmented by a multiplier of the history. */
#define CTE_HERMITE_HERMITE_BEAMS_AUGMENTED 124
int32_t cte_hermite_hermite_beams_augmented(cte_arguments *arguments);

/* Bilinear facet on bilinear facet, Coulomb friction, augmented by multipliers of the history. */
#define CTE_QUAD4_QUAD4_COULOMB_AUGMENTED 125
int32_t cte_quad4_quad4_coulomb_augmented(cte_arguments *arguments);

/* Bilinear facet on bilinear facet, traction per current area, augmented by multipliers of the history. */
#define CTE_QUAD4_QUAD4_CURRENT_AUGMENTED 126
int32_t cte_quad4_quad4_current_augmented(cte_arguments *arguments);

/* A point of any discretisation against a placed rigid sphere, by its distance function, augmented by a multiplier */
/* of the history. */
#define CTE_INTERPOLATED_SPHERE_DISTANCE_AUGMENTED 127
int32_t cte_interpolated_sphere_distance_augmented(cte_arguments *arguments);

/* Point against a bilinear facet with a multiplier as unknown. */
#define CTE_POINT_QUAD4_MULTIPLIER 128
int32_t cte_point_quad4_multiplier(cte_arguments *arguments);

/* Point against a bilinear facet, Coulomb friction, with a multiplier as unknown. */
#define CTE_POINT_QUAD4_COULOMB_MULTIPLIER 129
int32_t cte_point_quad4_coulomb_multiplier(cte_arguments *arguments);

/* Point against a placed rigid cylinder, Coulomb friction, with a multiplier as unknown. */
#define CTE_POINT_CYLINDER_COULOMB_MULTIPLIER 130
int32_t cte_point_cylinder_coulomb_multiplier(cte_arguments *arguments);

/* Two cubic Hermite beams with a multiplier as unknown. */
#define CTE_HERMITE_HERMITE_BEAMS_MULTIPLIER 131
int32_t cte_hermite_hermite_beams_multiplier(cte_arguments *arguments);

/* Bilinear facet on bilinear facet with a multiplier as unknown at every integration point. */
#define CTE_QUAD4_QUAD4_MULTIPLIER 132
int32_t cte_quad4_quad4_multiplier(cte_arguments *arguments);

/* Slave of any discretisation on a bilinear facet with a multiplier as unknown. */
#define CTE_INTERPOLATED_QUAD4_MULTIPLIER 133
int32_t cte_interpolated_quad4_multiplier(cte_arguments *arguments);

/* Point against a straight segment in the plane, Coulomb friction, with a multiplier as unknown. */
#define CTE_POINT_LINE2_COULOMB_MULTIPLIER2D 134
int32_t cte_point_line2_coulomb_multiplier2d(cte_arguments *arguments);

/* Hermite curve against Hermite curve (beams), Coulomb friction and rolling resistance: moments about both curves, */
/* angles from their principal normals. */
#define CTE_HERMITE_HERMITE_BEAMS_ROLLING 135
int32_t cte_hermite_hermite_beams_rolling(cte_arguments *arguments);

/* Hermite curve against Hermite curve (beams), Coulomb friction and rolling resistance: angles from directors given at */
/* run time. */
#define CTE_HERMITE_HERMITE_BEAMS_ROLLING_DIRECTOR 136
int32_t cte_hermite_hermite_beams_rolling_director(cte_arguments *arguments);

/* Straight segment against straight segment (beams), Coulomb friction and rolling resistance: angles from directors */
/* given at run time. */
#define CTE_LINE2_LINE2_BEAMS_ROLLING 137
int32_t cte_line2_line2_beams_rolling(cte_arguments *arguments);

/* Point against a vertex of a body: distance with a side. */
#define CTE_POINT_POINT_ORIENTED 138
int32_t cte_point_point_oriented(cte_arguments *arguments);

/* Point against a straight edge of a body: distance with a side. */
#define CTE_POINT_LINE2_ORIENTED 139
int32_t cte_point_line2_oriented(cte_arguments *arguments);

/* Point against a parabolic edge of a body: distance with a side. */
#define CTE_POINT_LINE3_ORIENTED 140
int32_t cte_point_line3_oriented(cte_arguments *arguments);

/* Point against a quadratic Bezier edge of a body: distance with a side. */
#define CTE_POINT_BEZIER_CURVE2_ORIENTED 141
int32_t cte_point_bezier_curve2_oriented(cte_arguments *arguments);

/* Point against a quadratic rational edge of a body: distance with a side. */
#define CTE_POINT_RATIONAL_CURVE2_ORIENTED 142
int32_t cte_point_rational_curve2_oriented(cte_arguments *arguments);

/* Point against a corner of a body in the plane: distance with a side. */
#define CTE_POINT_POINT_ORIENTED2D 143
int32_t cte_point_point_oriented2d(cte_arguments *arguments);

/* Two straight beams at large angles: point contact, weighted by the angle. */
#define CTE_LINE2_LINE2_BEAMS_LARGE_ANGLE 144
int32_t cte_line2_line2_beams_large_angle(cte_arguments *arguments);

/* Two straight beams at small angles: line contact, weighted by the angle. */
#define CTE_LINE2_LINE2_LINE_CONTACT_SMALL_ANGLE 145
int32_t cte_line2_line2_line_contact_small_angle(cte_arguments *arguments);

/* Two cubic Hermite beams at large angles: point contact, weighted by the angle. */
#define CTE_HERMITE_HERMITE_BEAMS_LARGE_ANGLE 146
int32_t cte_hermite_hermite_beams_large_angle(cte_arguments *arguments);

/* Two cubic Hermite beams at small angles: line contact, weighted by the angle. */
#define CTE_HERMITE_HERMITE_LINE_CONTACT_SMALL_ANGLE 147
int32_t cte_hermite_hermite_line_contact_small_angle(cte_arguments *arguments);

/* One point of a straight beam on a straight beam at small angles: line contact with a rule of the host, weighted by */
/* the angle. */
#define CTE_LINE2_LINE2_LINE_CONTACT_SMALL_ANGLE_AT_POINT 148
int32_t cte_line2_line2_line_contact_small_angle_at_point(cte_arguments *arguments);

/* One point of a cubic Hermite beam on a cubic Hermite beam at small angles: line contact with a rule of the host, */
/* weighted by the angle. */
#define CTE_HERMITE_HERMITE_LINE_CONTACT_SMALL_ANGLE_AT_POINT 149
int32_t cte_hermite_hermite_line_contact_small_angle_at_point(cte_arguments *arguments);

/* Straight beam against rational quadratic beam at large angles: point contact, power law, weighted by the angle. */
#define CTE_LINE2_RATIONAL_CURVE2_BEAMS_LARGE_ANGLE 150
int32_t cte_line2_rational_curve2_beams_large_angle(cte_arguments *arguments);

#ifdef __cplusplus
}
#endif
#endif
