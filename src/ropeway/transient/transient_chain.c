/* ropeway/transient/transient_chain.c - the chain of a ropeway in motion: its nodes, springs and
 * masses, its steady motion, and the bounds of friction.
 *
 * u, q    m, m/s, unstretched rope that has passed a node, and its rate
 * c       m/N, compliance of an element by stretch
 * a       m, amplitude of the change of a span's sag, of the shape sin(pi x/chord)
 * gamma   content of a span per a;  K, M: stiffness and mass of a, N/m, kg. gamma^2/K is the compliance
 *         by sag, exact for slow changes; K = pi^2 T/2l and M half the mass are those of a taut string,
 *         whose first mode has 96/pi^4 = 0.986 of that compliance
 * a0      the same by the statics of the present phase: (content of the span - that of t = 0)/gamma, so
 *         that the sag, which has inertia, follows the carriers; with too little sag to do this,
 * d       m, of each element, has it
 * tau     N, tension above that of the statics
 *
 * An element has the content u(behind) - u(ahead) more than at t = 0, and
 *     tau = -(content - d - gamma a)/c,   M a'' + K (a - a0) = -gamma tau .
 * The sag belongs to the middle element of its span: its coordinate then stays within one row of the
 * equations (transient_step.c), and a wave passes a span in a small part of the period of the sag.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/transient/transient.h"

#define PI 3.14159265358979323846 /* to the digits of a double */
#define STIFF 0.01 /* compliance by sag over that by stretch below which the statics moves the
                    * elements: the coordinate of sag would have to move far for little content */
#define CLOSED 1e-13 /* accepted defect of the loop's content over the length of the first span */
enum { ROUNDS = 50 /* of the steady motion: friction depends on its own tensions by some 1e-3, so
                    * that four are usual */ };

static double sign_of(int lane)
{
	return lane == HAWSER_ROPEWAY_UP ? 1.0 : -1.0;
}

double hawser__chain_excess(const struct hawser__chain *chain, int lane, int e)
{
	int a = hawser__chain_node(chain, lane, e - 1), b = hawser__chain_node(chain, lane, e);
	int k = lane*chain->slow->spans + (e - 1)/chain->m;
	double content = sign_of(lane)*(chain->u[a] - chain->u[b]);

	if (e == 1)
		content += chain->u[1];
	if ((e - 1)%chain->m == chain->m/2)
		content -= chain->gamma[k]*chain->sag[k];
	return -(content - chain->d[lane*(chain->E + 1) + e])/chain->c[k];
}

/* --- masses and statics of a phase --- */

static void add_carrier(struct hawser__chain *chain, int lane, double S, double mass)
{
	const struct hawser__slow *slow = chain->slow;
	double from = 0.0, part;
	int k = 0, e;

	while (k < slow->spans - 1 && S >= from + slow->length[lane*slow->spans + k])
		from += slow->length[lane*slow->spans + k++];
	part = (S - from)/slow->length[lane*slow->spans + k]*chain->m;
	e = (int)fmin(part, chain->m - 1);
	part = fmin(part - e, 1.0);
	e += k*chain->m + 1;
	chain->mass[hawser__chain_node(chain, lane, e - 1)] += (1.0 - part)*mass;
	chain->mass[hawser__chain_node(chain, lane, e)] += part*mass;
	if (e == chain->E)
		chain->top_mass[lane] += part*mass;
}

/* Masses of the nodes at that travel. */
static void chain_masses(struct hawser__chain *chain, double travelled)
{
	const struct hawser__slow *slow = chain->slow;
	const struct hawser_ropeway *rw = chain->rw;

	memcpy(chain->mass, chain->lump, (size_t)chain->N*sizeof *chain->mass);
	for (int lane = 0; lane < 2; lane++) {
		double start = lane ? rw->phase_down - travelled : rw->phase + travelled, total = 0.0;

		chain->top_mass[lane] = 0.5*rw->rho*slow->length[(lane + 1)*slow->spans - 1]/chain->m;
		for (int k = 0; k < slow->spans; k++)
			total += slow->length[lane*slow->spans + k];
		if (!(slow->spacing > 0.0 && chain->loads[lane] > 0.0))
			continue;
		for (double S = start - slow->spacing*floor(start/slow->spacing); S < total; S += slow->spacing)
			add_carrier(chain, lane, S, chain->loads[lane]);
	}
}

void hawser__chain_place(struct hawser__chain *chain, double travelled)
{
	const struct hawser__slow *slow = chain->slow;

	hawser__slow_at(&chain->now, slow, chain->rw->phase + travelled);
	for (int k = 0; k < 2*slow->spans; k++) {
		double grown = chain->now.span[k].content - chain->start.span[k].content;
		double *d = chain->d + k/slow->spans*(chain->E + 1) + k%slow->spans*chain->m + 1;
		int sags = slow->sagging[k] > STIFF*slow->elastic[k];

		if (k%slow->spans == slow->spans - 1)
			grown += 0.5*(chain->now.rest - chain->start.rest);
		chain->still[k] = sags ? grown/chain->gamma[k] : 0.0;
		for (int e = 0; e < chain->m; e++)
			d[e] = sags ? 0.0 : grown/chain->m;
	}
	chain_masses(chain, travelled);
}

/* --- friction --- */

double hawser__chain_pressing(const struct hawser__chain *chain, int lane, int tower, int normal)
{
	const struct hawser__slow *slow = chain->slow;
	const struct hawser__slow_tower *at = &chain->now.tower[lane*slow->towers + tower];
	const double *tension = chain->tension + lane*(chain->E + 1) + (tower + 1)*chain->m;
	int k = lane*slow->spans + tower;

	return (normal ? at->normal : at->pressing) +
	       slow->side[tower]*(0.5*at->turn*(tension[0] + tension[1]) +
	                          chain->press[k]*(chain->sag_middle[k] - chain->still[k]) +
	                          chain->press[k + 1]*(chain->sag_middle[k + 1] - chain->still[k + 1]));
}

void hawser__chain_top(double T[2], const struct hawser__chain *chain)
{
	double rate = chain->rate[2*chain->E];

	for (int lane = 0; lane < 2; lane++)
		T[lane] = chain->now.T_top[lane] + chain->tension[lane*(chain->E + 1) + chain->E] +
		          sign_of(lane)*chain->top_mass[lane]*rate;
}

void hawser__chain_bounds(struct hawser__chain *chain)
{
	const struct hawser__slow *slow = chain->slow;
	const struct hawser_ropeway *rw = chain->rw;
	double T[2];

	chain->bound[0] = rw->bottom_friction*(chain->now.span[0].T_from + chain->tension[1] +
	                                       chain->now.span[slow->spans].T_from +
	                                       chain->tension[chain->E + 2]);
	for (int lane = 0; lane < 2; lane++)
		for (int i = 0; i < slow->towers; i++) {
			double wrap = fabs(chain->now.tower[lane*slow->towers + i].turn);
			double mu = rw->tower[i].friction;
			double part = wrap > 1e-9 ? 2.0*tanh(0.5*mu*wrap)/wrap : mu;

			chain->bound[hawser__chain_node(chain, lane, (i + 1)*chain->m)] =
				fmax(0.0, part*hawser__chain_pressing(chain, lane, i, 1));
		}
	hawser__chain_top(T, chain);
	chain->traction = rw->drive ? tanh(0.5*rw->drive_friction*rw->wrap)*fmax(0.0, T[0] + T[1])
	                            : INFINITY;
}

/* --- memory --- */

static enum hawser_status allot(struct hawser__chain *chain, struct hawser_report *report)
{
	size_t n = (size_t)chain->N, e = 2*((size_t)chain->E + 1), k = 2*(size_t)chain->slow->spans;
	struct {
		double **to;
		size_t count;
	} part[] = {{&chain->u, n}, {&chain->q, n}, {&chain->sag, k}, {&chain->sag_q, k}, {&chain->d, e},
		{&chain->tension, e}, {&chain->mass, n}, {&chain->rate, n}, {&chain->solved, n},
		{&chain->sag_middle, k}, {&chain->sag_solved, k}, {&chain->still, k}, {&chain->bound, n},
		{&chain->band, 4*n}, {&chain->rhs, n}, {&chain->alpha, e}, {&chain->kappa, e},
		{&chain->c, k}, {&chain->gamma, k},
		{&chain->K, k}, {&chain->M, k}, {&chain->press, k}, {&chain->lump, n}};

	for (size_t i = 0; i < sizeof part/sizeof *part; i++) {
		*part[i].to = calloc(part[i].count, sizeof **part[i].to);
		if (!*part[i].to)
			return hawser__no_memory(report, "transient");
	}
	chain->state = calloc(n, sizeof *chain->state);
	return chain->state ? HAWSER_OK : hawser__no_memory(report, "transient");
}

static void constants(struct hawser__chain *chain)
{
	const struct hawser__slow *slow = chain->slow;
	const struct hawser_ropeway *rw = chain->rw;

	for (int k = 0; k < 2*slow->spans; k++) {
		double chord = slow->chord[k], T = slow->tension[k];
		int lane = k/slow->spans, first = k%slow->spans*chain->m;

		chain->c[k] = slow->elastic[k]/chain->m;
		chain->K[k] = PI*PI*T/(2.0*chord);
		chain->M[k] = 0.5*slow->mass[k];
		chain->gamma[k] = sqrt(slow->sagging[k]*chain->K[k]);
		chain->press[k] = PI*sqrt(1.5)*T/chord; /* N/m, at an end of the span: of a parabola */
		for (int e = first; e < first + chain->m; e++) {
			double half = 0.5*rw->rho*slow->length[k]/chain->m;

			chain->lump[hawser__chain_node(chain, lane, e)] += half;
			chain->lump[hawser__chain_node(chain, lane, e + 1)] += half;
		}
	}
	for (int k = 0; k < 2*slow->towers; k++)
		chain->lump[hawser__chain_node(chain, k/slow->towers, (k%slow->towers + 1)*chain->m)] +=
			slow->sheaves[k];
	chain->lump[0] += rw->rho*PI*rw->bottom_radius;
	if (rw->bottom_inertia > 0.0)
		chain->lump[0] += rw->bottom_inertia/(rw->bottom_radius*rw->bottom_radius);
	chain->lump[2*chain->E] += rw->rho*PI*rw->top_radius;
	chain->wheel_mass = rw->top_inertia > 0.0 ? rw->top_inertia/(rw->top_radius*rw->top_radius) : 0.0;
	chain->lump[1] = chain->carriage = rw->tension <= HAWSER_ROPEWAY_T0 ? rw->carriage : 0.0;
}

enum hawser_status hawser__chain_open(struct hawser__chain *chain, const struct hawser_ropeway *rw,
                                      const struct hawser__slow *slow,
                                      const struct hawser_transient_options *options,
                                      struct hawser_report *report)
{
	enum hawser_status status;

	*chain = (struct hawser__chain){.rw = rw, .slow = slow, .m = options->elements, .h = options->step,
	                                .motor_most = INFINITY};
	chain->E = slow->spans*chain->m;
	chain->N = 2*chain->E + 1;
	for (int lane = 0; lane < 2; lane++)
		chain->loads[lane] = rw->load_case[options->load_case].mass[lane];
	status = allot(chain, report);
	if (!status)
		status = hawser__slow_now_open(&chain->now, slow, report);
	if (!status)
		status = hawser__slow_now_open(&chain->start, slow, report);
	if (!status)
		constants(chain);
	if (!status && options->damping > 0.0) {
		double length = 0.0;

		for (int k = 0; k < 2*slow->spans; k++)
			length += slow->length[k];
		chain->loss = options->damping*length*sqrt(rw->rho/rw->EA)/PI; /* 2 ratio/omega */
	}
	return status;
}

void hawser__chain_clear(struct hawser__chain *chain)
{
	double *part[] = {chain->u, chain->q, chain->sag, chain->sag_q, chain->d, chain->tension,
		chain->mass, chain->rate, chain->solved, chain->sag_middle, chain->sag_solved, chain->still,
		chain->bound, chain->band, chain->rhs, chain->alpha, chain->kappa, chain->c, chain->gamma,
		chain->K, chain->M, chain->press, chain->lump};

	for (size_t i = 0; i < sizeof part/sizeof *part; i++)
		free(part[i]);
	free(chain->state);
	hawser__slow_now_clear(&chain->now);
	hawser__slow_now_clear(&chain->start);
	memset(chain, 0, sizeof *chain);
}

/* --- steady motion --- */

/* Tensions of the rope that runs, from its friction and the excess at the bottom station; the content
 * that these tensions take from the loop, m. */
static double steady_tensions(struct hawser__chain *chain, double bottom)
{
	int spans = chain->slow->spans;
	double taken = 0.0;

	for (int lane = 0; lane < 2; lane++) {
		double tau = bottom + sign_of(lane)*0.5*chain->bound[0];

		for (int e = 1; e <= chain->E; e++) {
			int k = lane*spans + (e - 1)/chain->m;

			chain->tension[lane*(chain->E + 1) + e] = tau;
			if ((e - 1)%chain->m == chain->m/2) {
				chain->sag[k] = chain->sag_middle[k] = -chain->gamma[k]*tau/chain->K[k];
				taken -= chain->gamma[k]*chain->sag[k];
			}
			taken += chain->c[k]*tau;
			if (e < chain->E)
				tau += sign_of(lane)*chain->bound[hawser__chain_node(chain, lane, e)];
		}
	}
	return taken;
}

/* Travels of the nodes that belong to the tensions. */
static void steady_travels(struct hawser__chain *chain)
{
	double top;

	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++) {
			int a = hawser__chain_node(chain, lane, e - 1), b = hawser__chain_node(chain, lane, e);
			int k = lane*chain->slow->spans + (e - 1)/chain->m;
			double content = -chain->c[k]*chain->tension[lane*(chain->E + 1) + e];

			if ((e - 1)%chain->m == chain->m/2)
				content += chain->gamma[k]*chain->sag[k];
			if (e == 1)
				content -= chain->u[1];
			chain->u[b] = chain->u[a] - sign_of(lane)*content;
		}
	top = chain->u[2*chain->E];
	for (int i = 0; i < chain->N; i++)
		chain->u[i] -= i == 1 ? 0.0 : top;
}

/* The smaller of two slopes, or 0 if their signs differ. */
static double limited(double a, double b)
{
	return a*b > 0.0 ? fabs(a) < fabs(b) ? a : b : 0.0;
}

/* Speeds of the nodes and of the sag that belong to statics whose phase changes as the rope runs: from
 * the phases before and behind. The statics has kinks where carriers reach batteries, and jumps where
 * they leave stations at which the rope is inclined: the smaller difference has none of them. */
static void steady_speeds(struct hawser__chain *chain, double speed)
{
	const struct hawser__slow *slow = chain->slow;
	double step = slow->spacing/slow->phases, *flow = chain->alpha, sum = 0.0, top;
	size_t elements = 2*((size_t)chain->E + 1);

	for (int i = 0; i < chain->N; i++)
		chain->q[i] = i == 1 ? 0.0 : speed;
	if (!(speed > 0.0 && step > 0.0))
		return;
	hawser__chain_place(chain, step);
	memcpy(flow, chain->d, elements*sizeof *flow);
	memcpy(chain->sag_q, chain->still, 2*(size_t)slow->spans*sizeof *chain->sag_q);
	hawser__chain_place(chain, -step);
	for (size_t i = 0; i < elements; i++)
		flow[i] = speed*limited(flow[i], -chain->d[i])/step; /* both are 0 at t = 0 */
	for (int k = 0; k < 2*slow->spans; k++) {
		int at = k/slow->spans*(chain->E + 1) + k%slow->spans*chain->m + chain->m/2 + 1;

		chain->sag_q[k] = speed*limited(chain->sag_q[k], -chain->still[k])/step;
		flow[at] += chain->gamma[k]*chain->sag_q[k];
	}
	hawser__chain_place(chain, 0.0);
	for (size_t i = 0; i < elements; i++)
		sum += flow[i];
	chain->q[1] = chain->carriage > 0.0 ? 0.5*sum : 0.0;
	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++)
			chain->q[hawser__chain_node(chain, lane, e)] =
				chain->q[hawser__chain_node(chain, lane, e - 1)] -
				sign_of(lane)*(flow[lane*(chain->E + 1) + e] - (e == 1 ? chain->q[1] : 0.0));
	top = chain->q[2*chain->E] - speed;
	for (int i = 0; i < chain->N; i++)
		chain->q[i] -= i == 1 ? 0.0 : top;
}

enum hawser_status hawser__chain_begin(struct hawser__chain *chain, double speed,
                                       struct hawser_report *report)
{
	double bottom = 0.0, taken = 0.0, flexible = 0.0;

	hawser__slow_at(&chain->start, chain->slow, chain->rw->phase);
	hawser__chain_place(chain, 0.0);
	for (int k = 0; k < 2*chain->slow->spans; k++)
		flexible += chain->slow->elastic[k] + chain->slow->sagging[k];
	for (int i = 0; i < ROUNDS; i++) {
		double before = taken;

		if (speed > 0.0)
			hawser__chain_bounds(chain);
		taken = steady_tensions(chain, bottom);
		if (i > 1 && fabs(taken - (chain->carriage > 0.0 ? before : 0.0)) <=
		             CLOSED*chain->slow->length[0])
			break;
		if (!(chain->carriage > 0.0))
			bottom -= taken/flexible;
	}
	if (!isfinite(taken))
		return hawser__fail(report, HAWSER_ERR_NAN, "transient", "the tensions of the running rope "
		                    "are not numbers");
	chain->u[1] = chain->carriage > 0.0 ? -0.5*taken : 0.0;
	steady_travels(chain);
	hawser__chain_bounds(chain);
	steady_speeds(chain, speed);
	for (int i = 0; i < chain->N; i++)
		chain->state[i] = speed > 0.0;
	chain->wheel = chain->reference = speed;
	chain->drive = chain->motor = chain->now.force + chain->tension[chain->E] -
	                              chain->tension[2*chain->E + 1];
	return HAWSER_OK;
}
