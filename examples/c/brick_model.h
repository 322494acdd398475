/* brick_model.h - the finite-element program around the contact elements of bricks.c.
 *
 * Two 8-node bricks, small strain, linear elastic, 2x2x2 Gauss points, dense storage. Nothing in here
 * knows about contact. Units: any consistent set. Nodes and unknowns are counted from 0; unknown
 * 3*node + component, row-major matrices. brick_model.f90 is the twin.
 */
#ifndef BRICK_MODEL_H
#define BRICK_MODEL_H

enum {
  BRICK_NODES = 8,                  /* bottom four counter-clockwise seen from above, then the top four */
  BRICK_UNKNOWNS = 3 * BRICK_NODES,
  MODEL_NODES = 2 * BRICK_NODES,    /* lower brick, then upper brick */
  MODEL_UNKNOWNS = 3 * MODEL_NODES
};

/* Reference coordinates [length]: lower brick [0,1]^3, upper brick [0.25,0.75]^2 x [1,1.5]. */
void brick_model_coordinates(double x[MODEL_NODES][3]);

/* Stiffness [force/length] of both bricks. young [force/length^2], poisson [1]. */
void brick_model_stiffness(double x[MODEL_NODES][3], double young, double poisson,
                           double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS]);

/* 1 where the displacement is prescribed: the bottom face (z = 0) and the top face (z = 1.5). */
void brick_model_prescribed(int prescribed[MODEL_UNKNOWNS]);

/* Norm of the residual f [force] over the unknowns that are not prescribed. */
double brick_model_residual(const int prescribed[MODEL_UNKNOWNS], const double f[MODEL_UNKNOWNS]);

/* One step of Newton's method, u -= k^-1 f; prescribed displacements stay. k is destroyed. Returns 1, or 0 when k is
 * singular. */
int brick_model_correct(const int prescribed[MODEL_UNKNOWNS], double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS],
                        const double f[MODEL_UNKNOWNS], double u[MODEL_UNKNOWNS]);

#endif
