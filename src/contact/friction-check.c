/* contact/friction-check.c - whether a problem can be solved at all, before it is.
 *
 * Contradiction: contacts of one node leave no velocity if a positive combination of their normals is
 * zero and that of their shifts is negative. Two suffice to tell it along a line, three in a plane,
 * four in space.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>

#include "contact/friction.h"
#include "core/report.h"
#include "core/vec3.h"

/* Of the products of vectors of a frame that should be 0 or 1: far above round-off, and an error of
 * this size turns a force by no more than round-off of positions does. */
static const double orthonormal = 1e-9;
/* Combinations of normals below this are zero. */
static const double parallel = 1e-9;

static int finite_all(const double *x, size_t count)
{
	double sum = 0.0;

	for (size_t i = 0; i < count; i++)
		sum += x[i]*0.0; /* 0, or not a number */
	return sum == 0.0;
}

static int first_not(const double *x, int rows, int width)
{
	for (int i = 0; i < rows; i++)
		if (!finite_all(x + (size_t)width*(size_t)i, (size_t)width))
			return i;
	return -1;
}

static enum hawser_status matrix(const struct hawser_friction *solver,
                                 const struct hawser_friction_problem *problem,
                                 struct hawser_report *report)
{
	int node = first_not(problem->diagonal[0], solver->nodes, 9), right, link;

	if (node >= 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "friction",
		                    "the block of M of node %d is not a number or infinite", node);
	link = solver->links ? first_not(problem->off[0], solver->links, 9) : -1;
	if (link < 0 && solver->links && problem->back)
		link = first_not(problem->back[0], solver->links, 9);
	if (link >= 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "friction",
		                    "the block of M of link %d is not a number or infinite", link);
	right = first_not(problem->right[0], solver->nodes, 3);
	if (right >= 0)
		return hawser__fail(report, HAWSER_ERR_NAN, "friction",
		                    "the right side p of node %d is not a number or infinite", right);
	for (int n = 0; n < solver->nodes && !problem->back; n++) {
		const double *D = problem->diagonal[n];
		double size = fabs(D[0]) + fabs(D[4]) + fabs(D[8]);

		if (fabs(D[1] - D[3]) + fabs(D[2] - D[6]) + fabs(D[5] - D[7]) > orthonormal*size)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
			                    "the block of M of node %d is not symmetric", n);
	}
	return HAWSER_OK;
}

static int framed(const struct hawser_contact *contact)
{
	const double *axis[3] = {contact->normal, contact->tangent[0], contact->tangent[1]};

	for (int i = 0; i < 3; i++)
		for (int j = 0; j <= i; j++)
			if (!(fabs(hawser__dot(axis[i], axis[j]) - (i == j ? 1.0 : 0.0)) <= orthonormal))
				return 0;
	return 1;
}

static enum hawser_status numbers(const struct hawser_contact *contact, int c,
                                  struct hawser_report *report)
{
	const double gap[5] = {contact->gap_rate, contact->before, contact->surface[0],
	                       contact->surface[1], contact->surface[2]};

	if (!framed(contact))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
		                    "contact %d: normal and tangents are not orthogonal unit vectors "
		                    "(normal %g, %g, %g)", c, contact->normal[0], contact->normal[1],
		                    contact->normal[2]);
	if (!(contact->friction >= 0.0) || isinf(contact->friction))
		return hawser__fail(report, isnan(contact->friction) ? HAWSER_ERR_NAN : HAWSER_ERR_ARGUMENT,
		                    "friction",
		                    "contact %d: the friction coefficient is %g; it is 0 or more, and finite: "
		                    "hold the node where it may not slide", c, contact->friction);
	if (!(contact->restitution >= 0.0 && contact->restitution <= 1.0))
		return hawser__fail(report, isnan(contact->restitution) ? HAWSER_ERR_NAN : HAWSER_ERR_ARGUMENT,
		                    "friction",
		                    "contact %d: the coefficient of restitution is %g; it is from 0 to 1", c,
		                    contact->restitution);
	if (!finite_all(gap, 5))
		return hawser__fail(report, HAWSER_ERR_NAN, "friction",
		                    "contact %d: the gap rate (%g m/s), the velocity before (%g m/s) or that "
		                    "of the surface (%g, %g, %g m/s) is not a number or infinite", c, gap[0],
		                    gap[1], gap[2], gap[3], gap[4]);
	return HAWSER_OK;
}

/* A held direction of a contact's node has to be a tangent, along which the surface does not move. */
static enum hawser_status held(unsigned *fixed, const struct hawser_contact *contact, int c,
                               unsigned mask, struct hawser_report *report)
{
	*fixed = 0;
	for (int k = 0; k < 3; k++) {
		int along = fabs(contact->tangent[0][k]) >= 1.0 - orthonormal ? 1
			: fabs(contact->tangent[1][k]) >= 1.0 - orthonormal ? 2 : 0;

		if (!(mask & 1U << k))
			continue;
		if (!along || contact->surface[k] != 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
			                    "contact %d: direction %c of node %d is held; a contact there needs a "
			                    "tangent along it, and a surface that does not move along it", c,
			                    "xyz"[k], contact->node);
		*fixed |= 1U << along;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__friction_check(struct hawser_friction *solver,
                                          const struct hawser_friction_problem *problem,
                                          struct hawser_report *report)
{
	enum hawser_status status;

	if (problem->contacts < 0 || problem->contacts > solver->most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
		                    "%d contacts: the solver was opened for at most %d", problem->contacts,
		                    solver->most);
	status = matrix(solver, problem, report);
	for (int c = 0; c < problem->contacts && !status; c++) {
		const struct hawser_contact *contact = &problem->contact[c];

		if (contact->node < 0 || contact->node >= solver->nodes)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
			                    "contact %d: node %d is none of the nodes 0 to %d", c, contact->node,
			                    solver->nodes - 1);
		status = numbers(contact, c, report);
		if (!status)
			status = held(&solver->touch[c].fixed, contact, c,
			              problem->held ? problem->held[contact->node] : 0U, report);
	}
	return status;
}

/* The null vector x [count] of the normals, positive; 0 if there is none. */
static int balanced(double x[4], const double *const n[4], int count)
{
	double A[4][4], size = 0.0, rest[3] = {0.0};

	for (int i = 0; i < count; i++)
		for (int j = 0; j < count; j++)
			A[i][j] = hawser__dot(n[i], n[j]);
	/* x[0] = 1, and the others by elimination in the Gram matrix. */
	for (int i = 1; i < count; i++)
		x[i] = -A[i][0];
	for (int j = 1; j < count; j++)
		for (int i = j + 1; i < count; i++) {
			double factor = A[j][j] > parallel ? A[i][j]/A[j][j] : 0.0;

			for (int k = j; k < count; k++)
				A[i][k] -= factor*A[j][k];
			x[i] -= factor*x[j];
		}
	for (int i = count - 1; i > 0; i--) {
		for (int k = i + 1; k < count; k++)
			x[i] -= A[i][k]*x[k];
		if (A[i][i] <= parallel)
			return 0; /* fewer of them are parallel already */
		x[i] /= A[i][i];
	}
	x[0] = 1.0;
	for (int i = 0; i < count; i++) {
		if (x[i] <= 0.0)
			return 0;
		size += x[i];
		for (int k = 0; k < 3; k++)
			rest[k] += x[i]*n[i][k];
	}
	return sqrt(hawser__dot(rest, rest)) <= parallel*size;
}

/* Contacts of a node, at most HAWSER_CONTACTS_AT_NODE, that the bits of `chosen` name. */
static int contradict(const struct hawser_friction *solver, const int *c, unsigned chosen)
{
	const double *n[4];
	double x[4], sum = 0.0, shifts = 0.0;
	int at[4], count = 0;

	for (int i = 0; i < HAWSER_CONTACTS_AT_NODE; i++)
		if (chosen & 1U << i) {
			n[count] = solver->touch[c[i]].H;
			at[count++] = c[i];
		}
	if (count < 2 || !balanced(x, n, count))
		return 0;
	for (int i = 0; i < count; i++) {
		sum += x[i]*solver->touch[at[i]].offset[0];
		shifts += x[i]*fabs(solver->touch[at[i]].offset[0]);
	}
	return sum < -parallel*shifts;
}

enum hawser_status hawser__friction_room(const struct hawser_friction *solver, int node,
                                         struct hawser_report *report)
{
	int c[HAWSER_CONTACTS_AT_NODE], count = 0;

	for (int at = solver->first[node]; at >= 0; at = solver->touch[at].next) {
		if (count == HAWSER_CONTACTS_AT_NODE)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
			                    "node %d has more than %d contacts", node, HAWSER_CONTACTS_AT_NODE);
		c[count++] = at;
	}
	if (solver->net && count > 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
		                    "node %d has %d contacts: where the links form no chains, a node may have "
		                    "one", node, count);
	for (unsigned chosen = 3; count > 1 && chosen < 1U << count; chosen++)
		if (contradict(solver, c, chosen))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "friction",
			                    "the contacts of node %d contradict each other: no velocity keeps the "
			                    "node out of all its obstacles, which leave it no room", node);
	return HAWSER_OK;
}
