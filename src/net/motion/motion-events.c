/* net/motion/motion-events.c - cables that part, and winches, in the time steps of a mesh.
 *
 * A cable parts at a node of its mesh: one of the elements there gets a node of its own, with the
 * same place and velocity, so that the mass of each half goes with its element; momentum and
 * energy do not change. A step ends at the time, or where the tension of an element there comes to
 * its bound, which is found by shorter trial steps. Bodies and supports stay with the old node.
 *
 * A winch changes the unstretched length of all elements of a cable by the same part, between the
 * steps and at their middle (a symmetric splitting, of order 2), while all nodes stay where they
 * are. Its work is what the energy of the net changes by: of an element under the tension T,
 * strain e, it is -T*(1 + e/2)*dL0; its material comes from the winch, at rest, and with the
 * height that is has there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-contact.h"
#include "net/motion/motion-events.h"

/* Of the tension at which a cable parts: the step ends within this of it. */
static const double AT = 1e-9;
enum { CUTS = 60 }; /* of a step, where a tension jumps beyond its bound */

void hawser__events_clear(struct hawser__motion_events *events)
{
	if (!events)
		return;
	free(events->spare);
	free(events->parted); /* with tension */
	free(events->length0); /* with before */
	free(events);
}

/* The node of the mesh where a cable parts, as the end of the element that leaves it. */
static int place_of(int *side, const struct hawser__mesh *mesh,
                    const struct hawser_net_failure *failure)
{
	int first = mesh->first[failure->cable], n = mesh->first[failure->cable + 1] - first;
	int at = (int)lround(failure->part*n);

	*side = at == n;
	return first + (at == n ? n - 1 : at);
}

void hawser__events_spare(struct hawser__mesh *mesh, const struct hawser_net *net)
{
	for (int i = 0; i < net->failures; i++) {
		int side, element = place_of(&side, mesh, &net->failure[i]);

		memcpy(mesh->q[mesh->nodes + i], mesh->q[mesh->end[element][side]], sizeof *mesh->q);
		for (int k = 0; k < 3; k++)
			mesh->unknown[mesh->nodes + i][k] = -1;
	}
	mesh->nodes += net->failures;
}

/* What cables and winches do in time is known by the schemes with steps, from the beginning on. */
static enum hawser_status possible(const struct hawser__motion *motion, const struct hawser_net *net,
                                   const char *initial, struct hawser_report *report)
{
	const char *name = net->name ? net->name : "the net";

	if (motion->scheme->advance)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the scheme %s does not know "
		                    "failures and winches: take energy, or leave these sections out", name,
		                    motion->scheme->shown.name);
	if (initial)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: with failures or winches a motion "
		                    "begins at the equilibrium: leave them, or the state %s, out", name,
		                    initial);
	return HAWSER_OK;
}

enum hawser_status hawser__events_open(struct hawser__motion *motion, const struct hawser_net *net,
                                       const int still[3], const char *initial,
                                       struct hawser_report *report)
{
	size_t failures = (size_t)net->failures + 1;
	struct hawser__motion_events *events;
	enum hawser_status status;

	if (!net->failures && !net->winches)
		return HAWSER_OK;
	status = possible(motion, net, initial, report);
	if (status)
		return status;
	events = calloc(1, sizeof *events);
	if (!events)
		return hawser__no_memory(report, "net");
	motion->events = events;
	events->net = net;
	memcpy(events->still, still, sizeof events->still);
	events->spare = calloc(failures, sizeof *events->spare);
	events->parted = calloc(2*failures, sizeof *events->parted);
	events->length0 = calloc(2*(size_t)net->winches + 1, sizeof *events->length0);
	if (!events->spare || !events->parted || !events->length0)
		return hawser__no_memory(report, "net");
	events->tension = events->parted + failures;
	events->before = events->length0 + net->winches;
	for (int i = 0; i < net->failures; i++) {
		events->spare[i] = motion->nodes - net->failures + i;
		events->parted[i] = events->tension[i] = NAN;
	}
	for (int i = 0; i < net->winches; i++)
		events->length0[i] = events->before[i] = net->cable[net->winch[i].cable].value;
	return HAWSER_OK;
}

/* --- cables that part --- */

double hawser__events_next(const struct hawser__motion *motion, double end)
{
	const struct hawser__motion_events *events = motion->events;

	for (int i = 0; events && i < events->net->failures; i++) {
		const struct hawser_net_failure *failure = &events->net->failure[i];

		if (isnan(events->parted[i]) && failure->tension == 0.0 && failure->time >= motion->t)
			end = fmin(end, failure->time);
	}
	return end;
}

/* Length paid out up to time t by a winch of given speed. */
static double paid_out(const struct hawser_net_winch *winch, double t)
{
	double q = winch->rise > 0.0 ? t/winch->rise : 1.0;

	if (q >= 1.0)
		return winch->speed*(t - 0.5*winch->rise);
	return winch->speed*winch->rise*(0.5*q*q + (cos(2.0*M_PI*q) - 1.0)/(4.0*M_PI*M_PI));
}

/* Unstretched length of the cable before the step (end 0) and after it, over that within it: by its
 * winch, or 1. */
static double ratio_of(const struct hawser__motion *motion, int cable, int end, double h)
{
	const struct hawser__motion_events *events = motion->events;

	for (int i = 0; i < events->net->winches; i++) {
		const struct hawser_net_winch *winch = &events->net->winch[i];
		double now = events->length0[i], before = events->before[i];

		if (winch->cable != cable)
			continue;
		if (end && !(winch->tension > 0.0))
			return (events->net->cable[cable].value + paid_out(winch, motion->t + h))/now;
		return end ? 2.0 - before/now : before/now;
	}
	return 1.0;
}

/* Tension of an element at the end of a trial step, or before it. */
static double trial_tension(const struct hawser__motion *motion, int element, int end, double h)
{
	const struct hawser__motion_element *el = &motion->element[element];
	const struct hawser__mesh *mesh = motion->mesh;
	double L0 = mesh->length0[element]*ratio_of(motion, mesh->cable[element], end, h);
	double T = mesh->EA[element]*((end ? el->l1 : el->l)/L0 - 1.0);

	if (end && T > 0.0)
		T += el->c*(el->p1 - fmax(el->p, 0.0))/h;
	return fmax(T, 0.0);
}

/* The largest tension of the elements of the cable at the place; end: 0 before, 1 after the step.
 * */
static double tension_at(const struct hawser__motion *motion, int number, int end, double h)
{
	const struct hawser__mesh *mesh = motion->mesh;
	const struct hawser_net_failure *failure = &motion->events->net->failure[number];
	int side, element = place_of(&side, mesh, failure);
	double T = trial_tension(motion, element, end, h);

	if (side == 0 && element > mesh->first[failure->cable])
		T = fmax(T, trial_tension(motion, element - 1, end, h));
	return T;
}

int hawser__events_fits(struct hawser__motion *motion, double h)
{
	struct hawser__motion_events *events = motion->events;
	double least = 1.0;

	events->over = 0;
	for (int i = 0; i < events->net->failures; i++) {
		double bound = events->net->failure[i].tension, T0, T1;

		if (!(bound > 0.0) || !isnan(events->parted[i]))
			continue;
		T1 = tension_at(motion, i, 1, h);
		if (T1 < bound*(1.0 - AT))
			continue;
		events->over = i + 1;
		events->tension[i] = T1;
		T0 = tension_at(motion, i, 0, h);
		if (T1 > bound*(1.0 + AT) && T0 < bound && events->cuts < CUTS)
			least = fmin(least, (bound - T0)/(T1 - T0));
	}
	events->cut = least < 1.0 ? least*h : 0.0;
	events->cuts += least < 1.0;
	return least >= 1.0;
}

/* The contacts of the mesh, where a part of the node `from` is the node `to` now. */
static enum hawser_status touch_anew(struct hawser__motion *motion, int from, int to,
                                     struct hawser_report *report)
{
	struct hawser__motion_contact before = *motion->contact;
	enum hawser_status status;

	for (int i = 0; i < motion->mesh->touches; i++) /* which are of the same nodes in the new list */
		memcpy(motion->mesh->touch[i].friction, before.touch[i].T, sizeof before.touch[i].T);
	hawser__contact_clear(motion->contact);
	motion->contact = NULL;
	status = hawser__touch_again(motion->mesh, motion->events->net, report);
	if (!status)
		status = hawser__contact_open(motion, before.restitution, report);
	if (status)
		return status;
	for (int i = 0; i < motion->mesh->touches; i++)
		motion->mesh->touch[i].r = 0.0; /* those of the equilibrium: now the gaps tell */
	if (motion->bed)
		hawser__bed_part(motion, from, to);
	hawser__contact_begin(motion);
	motion->contact->friction = before.friction;
	motion->contact->impacts = before.impacts;
	motion->contact->surfaces = before.surfaces;
	motion->contact->apart = before.apart;
	motion->contact->laws = before.laws;
	return HAWSER_OK;
}

/* Loads of the mesh anew, from its lengths and ends: their change goes to the constant forces. Returns
 * the energy of the change, which comes from a place, J. */
static double load_anew(struct hawser__motion *motion, const double place[3])
{
	struct hawser__mesh *mesh = motion->mesh;
	double energy = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double x = motion->reference[i][k] + motion->u[i][k] - place[k];

			motion->base[i][k] -= mesh->force[i][k];
			energy += mesh->force[i][k]*x;
		}
	hawser__mesh_load(mesh, motion->events->net);
	if (motion->water)
		hawser__water_still(motion);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double x = motion->reference[i][k] + motion->u[i][k] - place[k];

			motion->base[i][k] += mesh->force[i][k];
			energy -= mesh->force[i][k]*x;
		}
	return energy;
}

/* Strain energy of an element. */
static double strain_energy(const struct hawser__motion *motion, int element)
{
	const struct hawser__motion_element *el = &motion->element[element];
	double d[3], p, L0 = motion->mesh->length0[element];

	for (int k = 0; k < 3; k++)
		d[k] = el->D[k] + motion->u[el->b][k] - motion->u[el->a][k];
	p = fmax(hawser__norm(d) - L0, 0.0);
	return 0.5*motion->mesh->EA[element]/L0*p*p;
}

/* Of a cable without mass nothing moves at the loose end: the element goes, its strain energy is
 * lost. */
static void remove_element(struct hawser__motion *motion, int element)
{
	struct hawser__motion_element *el = &motion->element[element];
	double lost = strain_energy(motion, element), before;

	hawser__motion_energies(motion);
	before = motion->energy.potential;
	for (int k = 0; k < 3; k++) {
		motion->base[el->a][k] -= el->F_ref[k];
		motion->base[el->b][k] += el->F_ref[k];
		el->F_ref[k] = 0.0;
	}
	el->k = el->c = motion->mesh->EA[element] = 0.0;
	hawser__motion_energies(motion);
	motion->events->offset += before - lost - motion->energy.potential;
	motion->energy.potential = before - lost;
	motion->energy.dissipated += lost;
}

/* The element's end `side` gets the node `to` of its own. */
static enum hawser_status separate(struct hawser__motion *motion, int element, int side, int to,
                                   struct hawser_report *report)
{
	struct hawser__mesh *mesh = motion->mesh;
	struct hawser__motion_element *el = &motion->element[element];
	double (*part[])[3] = {motion->reference, motion->u, motion->v, motion->a};
	int from = mesh->end[element][side];
	enum hawser_status status;

	for (size_t i = 0; i < sizeof part/sizeof *part; i++)
		memcpy(part[i][to], part[i][from], sizeof *part[i]);
	memcpy(mesh->q[to], mesh->q[from], sizeof *mesh->q);
	mesh->end[element][side] = to;
	*(side ? &el->b : &el->a) = to;
	load_anew(motion, mesh->q[from]);
	for (int k = 0; k < 3; k++) {
		motion->base[to][k] += side ? -el->F_ref[k] : el->F_ref[k];
		motion->base[from][k] -= side ? -el->F_ref[k] : el->F_ref[k];
		mesh->unknown[to][k] = motion->events->still[k] || !(mesh->rho[element] > 0.0) ? -1 : 0;
	}
	if (!(mesh->rho[element] > 0.0))
		remove_element(motion, element);
	hawser__mesh_number(mesh);
	hawser__blocks_clear(motion->blocks);
	status = hawser__blocks_open(&motion->blocks, mesh, report);
	if (!status && motion->contact)
		status = touch_anew(motion, from, to, report);
	return status ? status : hawser__motion_restart(motion, report);
}

enum hawser_status hawser__events_part(struct hawser__motion *motion, struct hawser_report *report)
{
	struct hawser__motion_events *events = motion->events;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < events->net->failures && !status; i++) {
		const struct hawser_net_failure *failure = &events->net->failure[i];
		int side, element = place_of(&side, motion->mesh, failure);

		if (!isnan(events->parted[i]) ||
		    (failure->tension > 0.0 ? events->due != i + 1 : failure->time > motion->t))
			continue;
		events->parted[i] = motion->t;
		if (failure->tension == 0.0)
			events->tension[i] = tension_at(motion, i, 1, fmax(motion->past_h, DBL_MIN));
		status = separate(motion, element, side, events->spare[i], report);
	}
	events->due = 0;
	return status;
}

void hawser__events_places(double (*x)[3], const struct hawser__motion *motion)
{
	const struct hawser__motion_events *events = motion->events;

	for (int i = 0; events && i < events->net->failures; i++) {
		int side, element = place_of(&side, motion->mesh, &events->net->failure[i]);

		if (isnan(events->parted[i]))
			memcpy(x[events->spare[i]], x[motion->mesh->end[element][side]], sizeof *x);
	}
}

/* --- winches --- */

/* The length that a winch which holds a tension has after dt: by its speed at the middle, for a
 * tension that changes with the length alone. */
static double held_length(const struct hawser__motion *motion, int number, double dt)
{
	const struct hawser__motion_events *events = motion->events;
	const struct hawser_net_winch *winch = &events->net->winch[number];
	const struct hawser__mesh *mesh = motion->mesh;
	int element = winch->end ? mesh->first[winch->cable + 1] - 1 : mesh->first[winch->cable];
	const struct hawser__motion_element *el = &motion->element[element];
	double d[3], l, T, gain = winch->limit/(HAWSER_NET_WINCH_BAND*winch->tension), speed;
	double stiff = mesh->EA[element]/events->length0[number];

	for (int k = 0; k < 3; k++)
		d[k] = el->D[k] + motion->u[el->b][k] - motion->u[el->a][k];
	l = hawser__norm(d);
	T = fmax(mesh->EA[element]*(l/mesh->length0[element] - 1.0), 0.0);
	speed = gain*(T - winch->tension)/(1.0 + 0.5*gain*stiff*dt);
	return events->length0[number] + dt*fmin(fmax(speed, -winch->limit), winch->limit);
}

/* An element of another unstretched length: its constants, and its force in the reference. */
static void lengthen(struct hawser__motion *motion, int element, double L0)
{
	struct hawser__motion_element *el = &motion->element[element];
	struct hawser__mesh *mesh = motion->mesh;

	mesh->length0[element] = L0;
	el->p_ref = el->l_ref - L0;
	el->k = mesh->EA[element]/L0;
	el->c = el->k*mesh->axial[element];
	el->m = mesh->rho[element]*L0;
	el->drag = mesh->alpha*L0;
	for (int k = 0; k < 3; k++) {
		double F = el->l_ref > 0.0 ? el->k*fmax(el->p_ref, 0.0)*el->D[k]/el->l_ref : 0.0;

		motion->base[el->a][k] += F - el->F_ref[k];
		motion->base[el->b][k] -= F - el->F_ref[k];
		el->F_ref[k] = F;
	}
}

/* Returns what strain and constant loads get. */
static double wind(struct hawser__motion *motion, int number, double length0)
{
	const struct hawser_net_winch *winch = &motion->events->net->winch[number];
	const struct hawser__mesh *mesh = motion->mesh;
	int first = mesh->first[winch->cable], last = mesh->first[winch->cable + 1] - 1;
	int node = mesh->end[winch->end ? last : first][winch->end];
	double place[3], ratio = length0/motion->events->length0[number], more = 0.0;

	for (int k = 0; k < 3; k++)
		place[k] = motion->reference[node][k] + motion->u[node][k];
	for (int e = first; e <= last; e++) {
		more -= strain_energy(motion, e);
		lengthen(motion, e, mesh->length0[e]*ratio);
		more += strain_energy(motion, e);
	}
	motion->events->length0[number] = length0;
	return more + load_anew(motion, place);
}

void hawser__events_wind(struct hawser__motion *motion, double t)
{
	struct hawser__motion_events *events = motion->events;
	double work = 0.0, before, potential;

	events->cut = 0.0; /* of a step that has failed */
	if (!events->net->winches)
		return;
	hawser__motion_energies(motion);
	before = motion->energy.kinetic;
	potential = motion->energy.potential;
	for (int i = 0; i < events->net->winches; i++) {
		const struct hawser_net_winch *winch = &events->net->winch[i];
		double all = events->net->cable[winch->cable].value;

		work += wind(motion, i, winch->tension > 0.0 ? held_length(motion, i, t - events->wound)
		                                             : all + paid_out(winch, t));
	}
	events->wound = t;
	hawser__motion_energies(motion);
	events->offset += potential + work - motion->energy.potential;
	motion->energy.potential = potential + work;
	motion->energy.work += work + motion->energy.kinetic - before;
}

void hawser__events_finish(struct hawser__motion *motion)
{
	struct hawser__motion_events *events = motion->events;

	events->due = events->over;
	events->cuts = 0;
	hawser__events_wind(motion, motion->t);
	for (int i = 0; i < events->net->winches; i++)
		events->before[i] = events->length0[i];
}

int hawser__events_due(const struct hawser__motion *motion)
{
	return motion->events && motion->events->due > 0;
}

enum hawser_status hawser__events_result(struct hawser_net_motion *to,
                                         const struct hawser__motion *motion,
                                         struct hawser_report *report)
{
	const struct hawser__motion_events *events = motion->events;

	to->failures = events->net->failures;
	to->winches = events->net->winches;
	to->failure = calloc((size_t)to->failures + 1, sizeof *to->failure);
	to->winch = calloc((size_t)to->winches + 1, sizeof *to->winch);
	if (!to->failure || !to->winch)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < to->failures; i++)
		to->failure[i] = (struct hawser_net_parted){events->net->failure[i].cable, events->parted[i],
		                                            events->tension[i]};
	for (int i = 0; i < to->winches; i++)
		to->winch[i] = (struct hawser_net_wound){events->net->winch[i].cable, events->length0[i]};
	return HAWSER_OK;
}
