/* contact/friction.c - the solver's work space, checks before and after a solution.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/friction.h"
#include "core/names.h"
#include "core/report.h"
#include "core/settle.h"
#include "core/vec3.h"

HAWSER__NAMES(hawser_contact_state_name, enum hawser_contact_state, "open", "stick", "slip")

void hawser_friction_options_settle(struct hawser_friction_options *options)
{
	hawser__settle(&options->tolerance, 1e-10);
	hawser__settle_count(&options->most, 400);
}

int hawser_contact_frame(struct hawser_contact *contact, const double normal[3])
{
	double length = hypot(hypot(normal[0], normal[1]), normal[2]), n[3], t[3];
	int axis;

	if (!(length > 0.0) || !isfinite(length))
		return 0;
	for (int k = 0; k < 3; k++)
		n[k] = normal[k]/length;
	axis = fabs(n[2]) <= 0.9 ? 2 : 0;
	for (int k = 0; k < 3; k++)
		t[k] = (k == axis ? 1.0 : 0.0) - n[axis]*n[k];
	length = hypot(hypot(t[0], t[1]), t[2]);
	for (int k = 0; k < 3; k++) {
		contact->normal[k] = n[k];
		contact->tangent[1][k] = t[k] /= length;
	}
	for (int k = 0; k < 3; k++)
		contact->tangent[0][k] = n[(k + 1)%3]*t[(k + 2)%3] - n[(k + 2)%3]*t[(k + 1)%3];
	return 1;
}

void hawser_friction_clear(struct hawser_friction *solver)
{
	if (!solver)
		return;
	hawser__contact_chain_clear(solver->chain);
	hawser__contact_net_clear(solver->net);
	hawser__hold_clear(&solver->hold);
	free(solver);
}

static int allocate(struct hawser_friction *solver)
{
	size_t n = (size_t)solver->nodes, c = (size_t)solver->most;

	solver->link = hawser__hold(&solver->hold, (size_t)solver->links + 1, sizeof *solver->link);
	solver->first = hawser__hold(&solver->hold, n, sizeof *solver->first);
	solver->touch = hawser__hold(&solver->hold, c + 1, sizeof *solver->touch);
	solver->second = hawser__hold(&solver->hold, c + 1, sizeof *solver->second);
	solver->from = hawser__hold(&solver->hold, c + 1, sizeof *solver->from);
	solver->R = hawser__hold(&solver->hold, n, sizeof *solver->R);
	solver->du = hawser__hold(&solver->hold, n, sizeof *solver->du);
	solver->kept = hawser__hold(&solver->hold, n, sizeof *solver->kept);
	solver->free = hawser__hold(&solver->hold, n, sizeof *solver->free);
	solver->inverse = hawser__hold(&solver->hold, n, sizeof *solver->inverse);
	return !solver->hold.short_of_memory;
}

static enum hawser_status links_good(int nodes, const int (*link)[2], int links,
                                     struct hawser_report *report)
{
	for (int e = 0; e < links; e++)
		if (link[e][0] < 0 || link[e][0] >= nodes || link[e][1] < 0 || link[e][1] >= nodes ||
		    link[e][0] == link[e][1])
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
			                    "link %d joins node %d and node %d; links join two of the nodes 0 to "
			                    "%d", e, link[e][0], link[e][1], nodes - 1);
	return HAWSER_OK;
}

enum hawser_status hawser_friction_open(struct hawser_friction **made, int nodes, const int (*link)[2],
                                        int links, int most_contacts, struct hawser_report *report)
{
	struct hawser_friction *solver;
	enum hawser_status status;

	*made = NULL;
	if (nodes < 1 || links < 0 || most_contacts < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
		                    "%d nodes, %d links, %d contacts: at least one node is needed, and no "
		                    "number may be negative", nodes, links, most_contacts);
	status = links_good(nodes, link, links, report);
	if (status)
		return status;
	solver = calloc(1, sizeof *solver);
	if (!solver)
		return hawser__no_memory(report, "friction");
	*solver = (struct hawser_friction){.nodes = nodes, .links = links, .most = most_contacts};
	if (!allocate(solver))
		status = hawser__no_memory(report, "friction");
	if (!status) {
		if (links)
			memcpy(solver->link, link, (size_t)links*sizeof *link);
		status = hawser__contact_chain_open(&solver->chain, nodes, link, links, report);
		if (!status && !solver->chain)
			status = hawser__contact_net_open(&solver->net, nodes, link, links, report);
	}
	if (status)
		hawser_friction_clear(solver);
	else
		*made = solver;
	return status;
}

static double shift(const struct hawser_contact *contact)
{
	int impact = contact->restitution > 0.0 && contact->before < 0.0 &&
	             contact->before + contact->gap_rate <= 0.0;

	return impact ? contact->restitution*contact->before : contact->gap_rate;
}

static void place(struct hawser_friction *solver, const struct hawser_friction_problem *problem)
{
	solver->corners = 0;
	for (int n = 0; n < solver->nodes; n++)
		solver->first[n] = -1;
	for (int c = problem->contacts - 1; c >= 0; c--) {
		const struct hawser_contact *contact = &problem->contact[c];
		struct hawser__friction_touch *touch = &solver->touch[c];

		touch->node = contact->node;
		touch->next = solver->first[contact->node];
		solver->corners |= touch->next >= 0;
		solver->first[contact->node] = c;
		touch->mu = contact->friction;
		memcpy(touch->H, contact->normal, sizeof contact->normal);
		memcpy(touch->H + 3, contact->tangent, sizeof contact->tangent);
		for (int k = 0; k < 3; k++)
			touch->offset[k] = -(touch->H[3*k]*contact->surface[0] +
			                     touch->H[3*k + 1]*contact->surface[1] +
			                     touch->H[3*k + 2]*contact->surface[2]);
		touch->offset[0] += shift(contact);
	}
}

static double norm(const struct hawser_friction_problem *problem, int nodes)
{
	double most = 0.0;

	for (int n = 0; n < nodes; n++)
		for (int k = 0; k < 9; k++)
			most = hawser__larger(most, fabs(problem->diagonal[n][k]));
	return most;
}

/* Start from the replies, or from no impulse. */
static void begin(struct hawser_friction *solver, const double (*u)[3],
                  const struct hawser_contact_reply *reply, int warm)
{
	for (int c = 0; c < solver->of->contacts; c++)
		memset(solver->touch[c].r, 0, sizeof solver->touch[c].r);
	hawser__friction_follow(solver, u);
	for (int c = 0; c < solver->of->contacts && warm; c++) {
		double *from = solver->from[c];

		memcpy(from, reply[c].impulse, sizeof reply[c].impulse);
		memcpy(from + 3, reply[c].velocity, sizeof reply[c].velocity);
		from[3] += shift(&solver->of->contact[c]);
		if (solver->first[solver->touch[c].node] != c)
			memcpy(solver->touch[c].r, from, sizeof solver->touch[c].r);
	}
}

static enum hawser_status warm_finite(const struct hawser_contact_reply *reply, int contacts,
                                      struct hawser_report *report)
{
	for (int c = 0; c < contacts; c++)
		for (int k = 0; k < 3; k++)
			if (!isfinite(reply[c].impulse[k]) || !isfinite(reply[c].velocity[k]))
				return hawser__fail(report, HAWSER_ERR_NAN, "friction",
				                    "contact %d: the impulse or velocity to start from is not a number "
				                    "or infinite", c);
	return HAWSER_OK;
}

/* Results: the law is then exact, and its round-off is in the balance. */
static void reply_all(struct hawser_contact_reply *reply, struct hawser_friction_counts *counts,
                      struct hawser_friction *solver)
{
	int *const count[] = {&counts->open, &counts->stick, &counts->slip};

	for (int c = 0; c < solver->of->contacts; c++) {
		struct hawser__friction_touch *touch = &solver->touch[c];
		double F[3];

		(void)hawser__touch_law(F, touch, 0.0);
		reply[c].state = hawser__touch_state(touch);
		for (int k = 0; k < 3; k++) {
			touch->r[k] -= F[k];
			reply[c].impulse[k] = touch->r[k];
			reply[c].velocity[k] = touch->w[k];
		}
		reply[c].velocity[0] -= shift(&solver->of->contact[c]);
		++*count[reply[c].state];
		counts->power -= touch->r[1]*touch->w[1] + touch->r[2]*touch->w[2];
	}
}

/* Check what Newton's method calls solved, and hand it on. */
static enum hawser_status answer(double (*u)[3], struct hawser_contact_reply *reply,
                                 struct hawser_friction_counts *counts, struct hawser_friction *solver,
                                 const struct hawser_friction_options *options,
                                 struct hawser_report *report)
{
	const double (*at)[3] = (const double (*)[3])u;
	const struct hawser__friction_where where = hawser__friction_look(solver, 0.0);
	double size, most;
	const double allowed = options->tolerance + hawser__friction_roundoff(solver, at)/where.scale;

	counts->residual = where.error/where.scale;
	if (!(counts->residual <= allowed))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "friction", counts->iterations,
		                       counts->residual, "contact and friction: the residual is %.2e after %d "
		                       "iterations, more than the tolerance %.2e", counts->residual,
		                       counts->iterations, options->tolerance);
	reply_all(reply, counts, solver);
	most = hawser__friction_balance(&size, solver, at);
	counts->balance = size > 0.0 ? most/size : 0.0;
	return HAWSER_OK;
}

/* What the velocities are without contact is not asked where the replies lead to the solution, but
 * for a symmetric M, which may have no sign. */
static enum hawser_status iterate(double (*u)[3], const struct hawser_contact_reply *reply,
                                  struct hawser_friction_counts *counts, struct hawser_friction *solver,
                                  const struct hawser_friction_options *options,
                                  struct hawser_report *report)
{
	const double (*at)[3] = (const double (*)[3])u;
	int asked = !(options->warm && solver->of->back), good = 1;

	if (asked)
		good = hawser__friction_free(solver, u);
	else
		hawser__friction_still(solver, u);
	begin(solver, at, reply, options->warm);
	if (good && options->warm && hawser__friction_warm(solver, u, counts, options))
		return HAWSER_OK;
	if (!(asked ? good : hawser__friction_free(solver, u)))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "friction",
		                    "the matrix M of the nodes is not positive definite: a node has no mass, "
		                    "or the stiffness of the step is negative; give every node mass, or make "
		                    "the step shorter");
	return hawser__friction_newton(solver, u, counts, options, report);
}

enum hawser_status hawser_friction_solve(struct hawser_friction *solver, double (*u)[3],
                                         struct hawser_contact_reply *reply,
                                         struct hawser_friction_counts *counts,
                                         const struct hawser_friction_problem *problem,
                                         const struct hawser_friction_options *given,
                                         struct hawser_report *report)
{
	struct hawser_friction_options options = {0};
	enum hawser_status status = hawser__friction_check(solver, problem, report);

	if (given)
		options = *given;
	hawser_friction_options_settle(&options);
	memset(counts, 0, sizeof *counts);
	if (!status && options.warm)
		status = warm_finite(reply, problem->contacts, report);
	if (status)
		return status;
	solver->of = problem;
	place(solver, problem);
	for (int n = 0; n < solver->nodes && !status; n++)
		status = hawser__friction_room(solver, n, report);
	if (status)
		return status;
	solver->norm = norm(problem, solver->nodes);
	status = iterate(u, reply, counts, solver, &options, report);
	return status ? status : answer(u, reply, counts, solver, &options, report);
}
