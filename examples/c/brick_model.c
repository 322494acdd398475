/* brick_model.c - see brick_model.h. Formulas: any text on finite elements, e.g. Hughes, The Finite
 * Element Method, sections 3.3 (trilinear brick), 3.8 (Gauss rule), 3.10 (B matrix). */
#include "brick_model.h"

#include <math.h>
#include <string.h>

/* Corners of the parent cube [-1,1]^3 in node order. */
static const double corner[BRICK_NODES][3] = {
    {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};

void brick_model_coordinates(double x[MODEL_NODES][3])
{
  static const double low[2][3] = {{0.0, 0.0, 0.0}, {0.25, 0.25, 1.0}};
  static const double edge[2] = {1.0, 0.5};
  for (int brick = 0; brick < 2; brick++)
    for (int a = 0; a < BRICK_NODES; a++)
      for (int i = 0; i < 3; i++)
        x[brick * BRICK_NODES + a][i] = low[brick][i] + edge[brick] * (1.0 + corner[a][i]) / 2.0;
}

void brick_model_prescribed(int prescribed[MODEL_UNKNOWNS])
{
  for (int node = 0; node < MODEL_NODES; node++)
    for (int i = 0; i < 3; i++)
      prescribed[3 * node + i] = node < 4 || node >= MODEL_NODES - 4;
}

/* Inverse of a 3x3 matrix; returns the determinant. */
static double invert(double m[3][3], double inverse[3][3])
{
  double determinant = 0.0;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      inverse[j][i] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                      m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
  for (int j = 0; j < 3; j++)
    determinant += m[0][j] * inverse[j][0];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      inverse[i][j] /= determinant;
  return determinant;
}

/* dN_a/dx_i [1/length] at the parent point p; returns the Jacobian determinant [length^3]. */
static double shape_gradient(double x[BRICK_NODES][3], const double p[3], double gradient[BRICK_NODES][3])
{
  double parent[BRICK_NODES][3], jacobian[3][3] = {{0.0}}, inverse[3][3];
  for (int a = 0; a < BRICK_NODES; a++)
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      parent[a][i] = corner[a][i] * (1.0 + corner[a][j] * p[j]) * (1.0 + corner[a][k] * p[k]) / 8.0;
    }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      for (int a = 0; a < BRICK_NODES; a++)
        jacobian[i][j] += parent[a][i] * x[a][j]; /* dx_j/dp_i */
  const double determinant = invert(jacobian, inverse);
  for (int a = 0; a < BRICK_NODES; a++)
    for (int i = 0; i < 3; i++) {
      gradient[a][i] = 0.0;
      for (int j = 0; j < 3; j++)
        gradient[a][i] += inverse[i][j] * parent[a][j];
    }
  return determinant;
}

/* One Gauss point of an isotropic brick:
 * k_(ai)(bj) += (lambda g_ai g_bj + mu g_aj g_bi + mu delta_ij g_a.g_b) dV,  g = shape gradient. */
static void add_point(double g[BRICK_NODES][3], double lambda, double mu, double volume, int first,
                      double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS])
{
  for (int a = 0; a < BRICK_NODES; a++)
    for (int b = 0; b < BRICK_NODES; b++) {
      const double dot = g[a][0] * g[b][0] + g[a][1] * g[b][1] + g[a][2] * g[b][2];
      for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
          k[first + 3 * a + i][first + 3 * b + j] +=
              volume * (lambda * g[a][i] * g[b][j] + mu * g[a][j] * g[b][i] + (i == j ? mu * dot : 0.0));
    }
}

void brick_model_stiffness(double x[MODEL_NODES][3], double young, double poisson,
                           double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS])
{
  const double mu = young / (2.0 * (1.0 + poisson));
  const double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double gauss = 1.0 / sqrt(3.0); /* 2-point rule, weights 1 */
  memset(k, 0, sizeof(double) * MODEL_UNKNOWNS * MODEL_UNKNOWNS);
  for (int brick = 0; brick < 2; brick++)
    for (int q = 0; q < 8; q++) {
      const double p[3] = {gauss * corner[q][0], gauss * corner[q][1], gauss * corner[q][2]};
      double g[BRICK_NODES][3];
      const double volume = shape_gradient(&x[brick * BRICK_NODES], p, g);
      add_point(g, lambda, mu, volume, brick * BRICK_UNKNOWNS, k);
    }
}

/* Brings the row with the largest entry of a column to the diagonal. */
static void pivot(double a[MODEL_UNKNOWNS][MODEL_UNKNOWNS], double b[MODEL_UNKNOWNS], int column)
{
  int best = column;
  for (int row = column + 1; row < MODEL_UNKNOWNS; row++)
    if (fabs(a[row][column]) > fabs(a[best][column]))
      best = row;
  if (best == column)
    return;
  for (int j = 0; j < MODEL_UNKNOWNS; j++) {
    const double keep = a[column][j];
    a[column][j] = a[best][j];
    a[best][j] = keep;
  }
  const double keep = b[column];
  b[column] = b[best];
  b[best] = keep;
}

/* Solves a x = b by Gauss elimination with partial pivoting; a is destroyed, b becomes x.
 * Returns 0, or 1 when a pivot is zero. */
static int solve(double a[MODEL_UNKNOWNS][MODEL_UNKNOWNS], double b[MODEL_UNKNOWNS])
{
  for (int column = 0; column < MODEL_UNKNOWNS; column++) {
    pivot(a, b, column);
    if (a[column][column] == 0.0)
      return 1;
    for (int row = column + 1; row < MODEL_UNKNOWNS; row++) {
      const double factor = a[row][column] / a[column][column];
      for (int j = column; j < MODEL_UNKNOWNS; j++)
        a[row][j] -= factor * a[column][j];
      b[row] -= factor * b[column];
    }
  }
  for (int row = MODEL_UNKNOWNS - 1; row >= 0; row--) {
    for (int j = row + 1; j < MODEL_UNKNOWNS; j++)
      b[row] -= a[row][j] * b[j];
    b[row] /= a[row][row];
  }
  return 0;
}

double brick_model_residual(const int prescribed[MODEL_UNKNOWNS], const double f[MODEL_UNKNOWNS])
{
  double sum = 0.0;
  for (int i = 0; i < MODEL_UNKNOWNS; i++)
    if (!prescribed[i])
      sum += f[i] * f[i];
  return sqrt(sum);
}

int brick_model_correct(const int prescribed[MODEL_UNKNOWNS], double k[MODEL_UNKNOWNS][MODEL_UNKNOWNS],
                        const double f[MODEL_UNKNOWNS], double u[MODEL_UNKNOWNS])
{
  double b[MODEL_UNKNOWNS];
  for (int i = 0; i < MODEL_UNKNOWNS; i++) {
    b[i] = prescribed[i] ? 0.0 : -f[i];
    if (prescribed[i])
      for (int j = 0; j < MODEL_UNKNOWNS; j++)
        k[i][j] = i == j ? 1.0 : 0.0;
  }
  if (solve(k, b) != 0)
    return 0;
  for (int i = 0; i < MODEL_UNKNOWNS; i++)
    u[i] += b[i];
  return 1;
}
