/* contact/friction-start.c - the velocities without contact, and the scales of the contacts; round-off.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "contact/friction.h"
#include "core/vec3.h"

/* Round-off of M u over |M| |u|: that of the sums of a row, and of the solution. */
static const double digits = 1e-15;

/* Any rho > 0 does: where M or a block has no sign, the largest of the blocks. A: blocks of M, or
 * of its inverse. */
static void weigh(struct hawser_friction *of, const double (*A)[9], int inverse)
{
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__friction_touch *touch = &of->touch[c];
		const double *n = touch->H, *B = A[touch->node];
		double part = 0.0;

		for (int i = 0; i < 3; i++)
			part += n[i]*(B[3*i]*n[0] + B[3*i + 1]*n[1] + B[3*i + 2]*n[2]);
		touch->rho = !(part > 0.0) ? of->norm : inverse ? 1.0/part : part;
	}
}

int hawser__friction_step(struct hawser_friction *of, const struct hawser__step_law *law)
{
	return of->net ? hawser__contact_net_solve(of->du, of, law)
	               : hawser__contact_chain_solve(of->du, of, law);
}

void hawser__friction_still(struct hawser_friction *of, double (*u)[3])
{
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			u[n][k] = of->of->held && of->of->held[n] & 1U << k ? of->of->right[n][k] : 0.0;
	hawser__friction_defect(of, (const double (*)[3])u);
	weigh(of, of->of->diagonal, 0);
}

int hawser__friction_free(struct hawser_friction *of, double (*u)[3])
{
	hawser__friction_still(of, u);
	if (!hawser__friction_step(of, NULL))
		return 0;
	if (of->net)
		hawser__contact_net_inverse(of);
	else
		hawser__contact_chain_inverse(of);
	weigh(of, (const double (*)[9])of->inverse, 1);
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			of->free[n][k] = u[n][k] += of->du[n][k];
	hawser__friction_defect(of, (const double (*)[3])u);
	return 1;
}

double hawser__friction_roundoff(const struct hawser_friction *of, const double (*u)[3])
{
	double most = 0.0;

	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			most = hawser__larger(most, fabs(u[n][k]));
	return digits*of->norm*most;
}
