/* contact/friction-state.c - where the iteration is: velocities, impulses and what the laws lack there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "contact/friction.h"
#include "core/vec3.h"

/* y = M x for all nodes. */
static void times(double (*y)[3], const struct hawser_friction *of, const double (*x)[3])
{
	for (int n = 0; n < of->nodes; n++)
		for (int i = 0; i < 3; i++) {
			const double *D = of->of->diagonal[n] + 3*i;

			y[n][i] = D[0]*x[n][0] + D[1]*x[n][1] + D[2]*x[n][2];
		}
	for (int e = 0; e < of->links; e++) {
		const double *B = of->of->off[e], *C = of->of->back ? of->of->back[e] : NULL;
		const int a = of->link[e][0], b = of->link[e][1];

		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++) {
				y[a][i] += B[3*i + j]*x[b][j];
				y[b][i] += (C ? C[3*i + j] : B[3*j + i])*x[a][j];
			}
	}
}

/* R = p - M u, and p - u at held directions. */
void hawser__friction_defect(struct hawser_friction *of, const double (*u)[3])
{
	times(of->R, of, u);
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			of->R[n][k] = of->of->right[n][k] -
			              (of->of->held && of->of->held[n] & 1U << k ? u[n][k] : of->R[n][k]);
}

double hawser__friction_balance(double *size, struct hawser_friction *of, const double (*u)[3])
{
	double most = 0.0;

	*size = 0.0;
	for (int c = 0; c < of->of->contacts; c++) {
		const struct hawser__friction_touch *touch = &of->touch[c];

		for (int i = 0; i < 3; i++)
			for (int k = 0; k < 3; k++)
				of->R[touch->node][i] += touch->H[3*k + i]*touch->r[k];
	}
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++) {
			double terms = hawser__larger(fabs(of->of->right[n][k]),
			                              fabs(of->of->diagonal[n][4*k]*u[n][k]));

			if (of->of->held && of->of->held[n] & 1U << k)
				continue;
			most = fabs(of->R[n][k]) <= most ? most : fabs(of->R[n][k]);
			*size = hawser__larger(*size, terms);
		}
	return most;
}

static void rotate(double to[3], const double H[9], const double x[3])
{
	for (int k = 0; k < 3; k++)
		to[k] = H[3*k]*x[0] + H[3*k + 1]*x[1] + H[3*k + 2]*x[2];
}

/* r of the first contact of a node from the force s on it and those of the others. */
static void share(double r[3], const struct hawser_friction *of,
                  const struct hawser__friction_touch *first,
                  const double s[3])
{
	double left[3] = {s[0], s[1], s[2]};

	for (int c = first->next; c >= 0; c = of->touch[c].next) {
		const struct hawser__friction_touch *other = &of->touch[c];

		for (int k = 0; k < 3; k++)
			for (int i = 0; i < 3; i++)
				left[i] -= other->H[3*k + i]*other->r[k];
	}
	rotate(r, first->H, left);
	for (int k = 1; k < 3; k++)
		if (first->fixed & 1U << k)
			r[k] = 0.0;
}

static void follow(struct hawser__friction_touch *touch, const struct hawser_friction *of, int contact,
                   const double (*u)[3])
{
	const int node = touch->node;
	const double *R = of->R[node], s[3] = {-R[0], -R[1], -R[2]};

	rotate(touch->w, touch->H, u[node]);
	for (int k = 0; k < 3; k++)
		touch->w[k] += touch->offset[k];
	if (of->first[node] == contact)
		share(touch->r, of, touch, s);
}

void hawser__friction_follow(struct hawser_friction *of, const double (*u)[3])
{
	for (int c = 0; c < of->of->contacts; c++)
		follow(&of->touch[c], of, c, u);
}

/* Add a contact; error and scale are squares here. */
static void look(struct hawser__friction_where *where, const struct hawser__friction_touch *touch,
                 double sigma)
{
	const double *r = touch->r, *w = touch->w, rho = touch->rho;
	double F[3], one = hawser__touch_law(F, touch, 0.0);

	where->error = one <= where->error ? where->error : one; /* not a number stays */
	where->sum += sigma > 0.0 ? hawser__touch_law(F, touch, sigma) : one;
	where->scale = fmax(where->scale, r[0]*r[0] + r[1]*r[1] + r[2]*r[2]);
	where->scale = fmax(where->scale, rho*rho*(w[0]*w[0] + w[1]*w[1] + w[2]*w[2]));
}

static struct hawser__friction_where looked(struct hawser__friction_where where)
{
	where.error = sqrt(where.error);
	where.scale = where.scale > 0.0 ? sqrt(where.scale) : 1.0;
	return where;
}

struct hawser__friction_where hawser__friction_look(const struct hawser_friction *of, double sigma)
{
	struct hawser__friction_where where = {.sum = 0.0};

	for (int c = 0; c < of->of->contacts; c++)
		look(&where, &of->touch[c], sigma);
	return looked(where);
}

struct hawser__friction_where hawser__friction_arrive(struct hawser_friction *of, double sigma,
                                                      const double (*u)[3])
{
	struct hawser__friction_where where = {.sum = 0.0};

	hawser__friction_defect(of, u);
	for (int c = 0; c < of->of->contacts; c++) {
		follow(&of->touch[c], of, c, u);
		look(&where, &of->touch[c], sigma);
	}
	return looked(where);
}

void hawser__friction_move(struct hawser_friction *of, double (*u)[3], double by)
{
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			u[n][k] += by*of->du[n][k];
	for (int c = 0; c < of->of->contacts && of->corners; c++)
		for (int k = 0; k < 3 && of->first[of->touch[c].node] != c; k++)
			of->touch[c].r[k] += by*of->second[c].dr[k];
}
