/* contact/friction-state.c - where the iteration is: velocities, impulses and what the laws lack there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "contact/friction.h"

/* y = M x for all nodes. */
static void times(double (*y)[3], const struct hawser_friction *of, const double (*x)[3])
{
	for (int n = 0; n < of->nodes; n++)
		for (int i = 0; i < 3; i++) {
			const double *D = of->of->diagonal[n] + 3*i;

			y[n][i] = D[0]*x[n][0] + D[1]*x[n][1] + D[2]*x[n][2];
		}
	for (int e = 0; e < of->links; e++) {
		const double *B = of->of->off[e];
		const int a = of->link[e][0], b = of->link[e][1];

		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++) {
				y[a][i] += B[3*i + j]*x[b][j];
				y[b][i] += B[3*j + i]*x[a][j];
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
	hawser__friction_defect(of, u);
	for (int c = 0; c < of->of->contacts; c++) {
		const struct hawser__touch *touch = &of->touch[c];

		for (int i = 0; i < 3; i++)
			for (int k = 0; k < 3; k++)
				of->R[touch->node][i] += touch->H[3*k + i]*touch->r[k];
	}
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++) {
			double terms = fmax(fabs(of->of->right[n][k]), fabs(of->of->diagonal[n][4*k]*u[n][k]));

			if (of->of->held && of->of->held[n] & 1U << k)
				continue;
			most = fabs(of->R[n][k]) <= most ? most : fabs(of->R[n][k]);
			*size = fmax(*size, terms);
		}
	return most;
}

static void rotate(double to[3], const double H[9], const double x[3])
{
	for (int k = 0; k < 3; k++)
		to[k] = H[3*k]*x[0] + H[3*k + 1]*x[1] + H[3*k + 2]*x[2];
}

/* r of the first contact of a node from the force s on it and those of the others. */
static void share(double r[3], const struct hawser_friction *of, const struct hawser__touch *first,
                  const double s[3], int steps)
{
	double left[3] = {s[0], s[1], s[2]};

	for (int c = first->next; c >= 0; c = of->touch[c].next) {
		const struct hawser__touch *other = &of->touch[c];
		const double *impulse = steps ? other->dr : other->r;

		for (int k = 0; k < 3; k++)
			for (int i = 0; i < 3; i++)
				left[i] -= other->H[3*k + i]*impulse[k];
	}
	rotate(r, first->H, left);
	for (int k = 1; k < 3; k++)
		if (first->fixed & 1U << k)
			r[k] = 0.0;
}

/* r and w of all contacts, as u has them. */
void hawser__friction_follow(struct hawser_friction *of, const double (*u)[3])
{
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__touch *touch = &of->touch[c];
		const int node = touch->node;

		rotate(touch->w, touch->H, u[node]);
		for (int k = 0; k < 3; k++)
			touch->w[k] += touch->offset[k];
		if (of->first[node] == c) {
			const double s[3] = {-of->R[node][0], -of->R[node][1], -of->R[node][2]};

			share(touch->r, of, touch, s, 0);
		}
	}
}

/* Sum of F^2; with derivatives too. */
double hawser__friction_laws(struct hawser_friction *of, double sigma, int derivatives)
{
	double sum = 0.0;

	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__touch *touch = &of->touch[c];

		hawser__touch_law(touch, sigma, derivatives);
		for (int k = 0; k < 3; k++)
			sum += touch->F[k]*touch->F[k];
	}
	return sum;
}

/* G, CrH and CuH of a step from u, where the law is taken at r and w; these become those of u. */
void hawser__friction_linearise(struct hawser_friction *of, const double (*u)[3], int elsewhere)
{
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__touch *touch = &of->touch[c];

		memcpy(touch->G, touch->F, sizeof touch->G);
		if (elsewhere) {
			memcpy(touch->dr, touch->r, sizeof touch->dr);
			memcpy(touch->dw, touch->w, sizeof touch->dw);
		}
		for (int i = 0; i < 3; i++)
			for (int j = 0; j < 3; j++) {
				double r = 0.0, w = 0.0;

				for (int k = 0; k < 3; k++) {
					r += touch->Cr[3*i + k]*touch->H[3*k + j];
					w += touch->Cu[3*i + k]*touch->H[3*k + j];
				}
				touch->CrH[3*i + j] = r;
				touch->CuH[3*i + j] = w;
			}
	}
	if (!elsewhere)
		return;
	hawser__friction_follow(of, u);
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__touch *touch = &of->touch[c];

		for (int i = 0; i < 3; i++)
			for (int k = 0; k < 3; k++)
				touch->G[i] += touch->Cr[3*i + k]*(touch->r[k] - touch->dr[k]) +
				               touch->Cu[3*i + k]*(touch->w[k] - touch->dw[k]);
	}
}

void hawser__friction_steps(struct hawser_friction *of)
{
	times(of->Mdu, of, (const double (*)[3])of->du);
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__touch *touch = &of->touch[c];

		rotate(touch->dw, touch->H, of->du[touch->node]);
	}
	for (int c = 0; c < of->of->contacts; c++)
		if (of->first[of->touch[c].node] == c)
			share(of->touch[c].dr, of, &of->touch[c], of->Mdu[of->touch[c].node], 1);
}

void hawser__friction_move(struct hawser_friction *of, double (*u)[3], double by)
{
	for (int c = 0; c < of->of->contacts; c++)
		for (int k = 0; k < 3; k++) {
			of->touch[c].r[k] += by*of->touch[c].dr[k];
			of->touch[c].w[k] += by*of->touch[c].dw[k];
		}
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			u[n][k] += by*of->du[n][k];
}
