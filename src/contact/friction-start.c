/* contact/friction-start.c - the velocities without contact, and the scales of the contacts; round-off.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "contact/friction.h"

/* Round-off of M u over |M| |u|: that of the sums of a row, and of the solution. */
static const double digits = 1e-15;

static void weigh(struct hawser_friction *of)
{
	for (int c = 0; c < of->of->contacts; c++) {
		struct hawser__friction_touch *touch = &of->touch[c];
		const double *n = touch->H, *A = of->inverse[touch->node];
		double inverse = 0.0;

		for (int i = 0; i < 3; i++)
			inverse += n[i]*(A[3*i]*n[0] + A[3*i + 1]*n[1] + A[3*i + 2]*n[2]);
		/* any rho > 0 does: where M has no sign, that of the block of the node */
		touch->rho = inverse > 0.0 ? 1.0/inverse : of->norm;
	}
}

int hawser__friction_step(struct hawser_friction *of, const struct hawser__step_law *law)
{
	return of->net ? hawser__contact_net_solve(of->du, of, law)
	               : hawser__contact_chain_solve(of->du, of, law);
}

int hawser__friction_free(struct hawser_friction *of, double (*u)[3])
{
	for (int n = 0; n < of->nodes; n++)
		for (int k = 0; k < 3; k++)
			u[n][k] = of->of->held && of->of->held[n] & 1U << k ? of->of->right[n][k] : 0.0;
	hawser__friction_defect(of, (const double (*)[3])u);
	if (!hawser__friction_step(of, NULL))
		return 0;
	if (of->net)
		hawser__contact_net_inverse(of);
	else
		hawser__contact_chain_inverse(of);
	weigh(of);
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
			most = fmax(most, fabs(u[n][k]));
	return digits*of->norm*most;
}
