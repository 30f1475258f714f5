/* ropeway/transient/transient_step.c - one step of the chain: midpoint rule, with friction as
 * set-valued laws.
 *
 * With mean speeds v of the step, q' = 2 v - q, and the flow into an element e
 *     flow = s (v_behind - v_ahead) (+ speed of the carriage),   tau = alpha - kappa flow
 * (the sag's coordinate is eliminated from its element; kappa has h/2c and loss/c), the rows
 *     (2 M/h)(v - q) = sum of tau + friction
 * are a symmetric positive definite matrix of half bandwidth 3, since the nodes of the two lanes are
 * numbered in pairs.
 *
 * Each node with friction either slides, with the force -sign(q') times its bound, or sticks with
 * q' = 0 and a force within the bound. Guesses from the step before are corrected until all hold: for a
 * matrix whose entries off the diagonal are not positive this policy iteration converges, and friction
 * changes at few nodes in a step. The bounds follow the tensions of the same step. Laws of the end of a
 * step (Moreau-Jean) and means for all else: the balance of energy holds to round-off for any step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/transient/transient.h"

#define SETTLED 1e-9 /* change of a bound over the bound at which it is that of its tensions: far
                      * below the error of a step, above round-off */
enum { BAND = 3, TOGETHER = 20, TRIES = 200 /* solutions of a step: 3 are usual; after TOGETHER one
                                             * law is corrected at a time, which cannot alternate */ };

static double sign_of(int lane)
{
	return lane == HAWSER_ROPEWAY_UP ? 1.0 : -1.0;
}

/* Symmetric matrix, row i and column i - d at [4 i + d]: factored in place, and solved. Returns 0 if it
 * is not positive. */
static int solve(double *a, double *x, int n)
{
	for (int i = 0; i < n; i++) {
		double *row = a + 4*i;

		for (int d = BAND; d >= 1; d--) { /* L_ij D_j, then L_ij */
			int j = i - d;

			if (j < 0)
				continue;
			for (int k = j - 1; k >= 0 && k >= i - BAND && k >= j - BAND; k--)
				row[d] -= row[i - k]*a[4*j + j - k];
		}
		for (int d = 1; d <= BAND && d <= i; d++) {
			double scaled = row[d]/a[4*(i - d)];

			row[0] -= scaled*row[d];
			row[d] = scaled;
			x[i] -= scaled*x[i - d];
		}
		if (!(row[0] > 0.0))
			return 0;
	}
	for (int i = n - 1; i >= 0; i--) {
		x[i] /= a[4*i];
		for (int d = 1; d <= BAND && i + d < n; d++)
			x[i] -= a[4*(i + d) + d]*x[i + d];
	}
	return 1;
}

static void springs(struct hawser__chain *chain)
{
	double h = chain->h;

	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++) {
			int at = lane*(chain->E + 1) + e, k = lane*chain->slow->spans + (e - 1)/chain->m;
			double kappa = (0.5*h + chain->loss)/chain->c[k];
			double alpha = hawser__chain_excess(chain, lane, e);

			if ((e - 1)%chain->m == chain->m/2) {
				double inertia = 2.0*chain->M[k]/h, gamma = chain->gamma[k];
				double g = inertia + 0.5*chain->K[k]*h;
				double b = inertia*chain->sag_q[k] - chain->K[k]*(chain->sag[k] - chain->still[k]);
				double part = 1.0 + kappa*gamma*gamma/g;

				alpha = (alpha + kappa*gamma*b/g)/part;
				kappa /= part;
			}
			chain->alpha[at] = alpha;
			chain->kappa[at] = kappa;
		}
}

static void add(double *band, int i, int j, double value)
{
	band[i >= j ? 4*i + i - j : 4*j + j - i] += value;
}

static void assemble(struct hawser__chain *chain)
{
	memset(chain->band, 0, 4*(size_t)chain->N*sizeof *chain->band);
	for (int i = 0; i < chain->N; i++) {
		chain->band[4*i] = 2.0*chain->mass[i]/chain->h;
		chain->rhs[i] = chain->band[4*i]*chain->q[i];
	}
	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++) {
			int node[3] = {hawser__chain_node(chain, lane, e - 1),
			               hawser__chain_node(chain, lane, e), 1};
			int at = lane*(chain->E + 1) + e, count = e == 1 && chain->carriage > 0.0 ? 3 : 2;
			double s = sign_of(lane), part[3] = {s, -s, 1.0};

			for (int i = 0; i < count; i++) {
				chain->rhs[node[i]] += chain->alpha[at]*part[i];
				for (int j = 0; j <= i; j++)
					add(chain->band, node[i], node[j], chain->kappa[at]*part[i]*part[j]);
			}
		}
}

/* The mean speed of node i is given. */
static void hold(struct hawser__chain *chain, int i, double v)
{
	for (int d = 1; d <= BAND; d++) {
		if (i - d >= 0) {
			chain->rhs[i - d] -= chain->band[4*i + d]*v;
			chain->band[4*i + d] = 0.0;
		}
		if (i + d < chain->N) {
			chain->rhs[i + d] -= chain->band[4*(i + d) + d]*v;
			chain->band[4*(i + d) + d] = 0.0;
		}
	}
	chain->band[4*i] = 1.0;
	chain->rhs[i] = v;
}

/* The rows with the laws as they are guessed. */
static void impose(struct hawser__chain *chain)
{
	int top = 2*chain->E;
	double h = chain->h, wheel = chain->wheel_mass;

	chain->rhs[top] -= chain->now.force;
	if (chain->at_drive.rope) {
		chain->rhs[top] += chain->at_drive.rope*chain->traction;
	} else if (chain->at_drive.motor) {
		chain->band[4*top] += 2.0*wheel/h;
		chain->rhs[top] += wheel*(chain->q[top] + chain->wheel)/h +
		                   chain->at_drive.motor*chain->motor_most;
	}
	for (int i = 0; i < chain->N; i++)
		if (chain->bound[i] > 0.0 && chain->state[i])
			chain->rhs[i] -= chain->state[i]*chain->bound[i];
	for (int i = 0; i < chain->N; i++)
		if (chain->bound[i] > 0.0 && !chain->state[i])
			hold(chain, i, 0.5*chain->q[i]);
	if (!chain->at_drive.rope && !chain->at_drive.motor)
		hold(chain, top, 0.5*(chain->q[top] + chain->reference));
	if (!(chain->carriage > 0.0))
		hold(chain, 1, 0.0);
}

/* Tensions, coordinates of sag and accelerations of the solved speeds. */
static void recover(struct hawser__chain *chain)
{
	double h = chain->h;

	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++) {
			int a = hawser__chain_node(chain, lane, e - 1), b = hawser__chain_node(chain, lane, e);
			int at = lane*(chain->E + 1) + e, k = lane*chain->slow->spans + (e - 1)/chain->m;
			double flow = sign_of(lane)*(chain->solved[a] - chain->solved[b]) +
			              (e == 1 ? chain->solved[1] : 0.0);

			chain->tension[at] = chain->alpha[at] - chain->kappa[at]*flow;
			if ((e - 1)%chain->m != chain->m/2)
				continue;
			chain->sag_solved[k] = (2.0*chain->M[k]/h*chain->sag_q[k] -
			                        chain->K[k]*(chain->sag[k] - chain->still[k]) -
			                        chain->gamma[k]*chain->tension[at]) /
			                       (2.0*chain->M[k]/h + 0.5*chain->K[k]*h);
			chain->sag_middle[k] = chain->sag[k] + 0.5*h*chain->sag_solved[k];
		}
	for (int i = 0; i < chain->N; i++)
		chain->rate[i] = 2.0*(chain->solved[i] - chain->q[i])/h;
}

/* Force on a node by the tensions beside it. */
static double pulled(const struct hawser__chain *chain, int i)
{
	int n = chain->E + 1;

	if (i == 0)
		return chain->tension[1] - chain->tension[n + 1];
	if (i == 2*chain->E)
		return chain->tension[n + chain->E] - chain->tension[chain->E];
	return sign_of(i%2)*(chain->tension[i%2*n + i/2 + 1] - chain->tension[i%2*n + i/2]);
}

/* Force of friction on node i. */
static double friction(const struct hawser__chain *chain, int i)
{
	if (!(chain->bound[i] > 0.0))
		return 0.0;
	return chain->state[i] ? -chain->state[i]*chain->bound[i]
	                       : chain->mass[i]*chain->rate[i] - pulled(chain, i);
}

/* Forces at the drive and the bullwheel's speed at the end of the step. */
static double drive(struct hawser__chain *chain)
{
	int top = 2*chain->E;
	double next = 2.0*chain->solved[top] - chain->q[top], wheel = chain->reference, h = chain->h;

	chain->drive = chain->at_drive.rope
		? chain->at_drive.rope*chain->traction
		: chain->mass[top]*chain->rate[top] - pulled(chain, top) + chain->now.force;
	if (!chain->at_drive.motor) {
		chain->motor = chain->drive + chain->wheel_mass*(wheel - chain->wheel)/h;
		return wheel;
	}
	chain->motor = chain->at_drive.motor*chain->motor_most;
	if (!chain->at_drive.rope) {
		chain->drive = chain->motor - chain->wheel_mass*(next - chain->wheel)/h;
		return next;
	}
	return chain->wheel + h*(chain->motor - chain->drive)/chain->wheel_mass;
}

static int side(double value)
{
	return value > 0.0 ? 1 : -1;
}

/* Correct the laws of the drive; returns the number of corrections. */
static int correct_drive(struct hawser__chain *chain)
{
	int top = 2*chain->E;
	double next = 2.0*chain->solved[top] - chain->q[top], wheel = drive(chain);
	struct hawser__drive_state *at = &chain->at_drive, before = *at;

	if (at->motor && at->motor*(chain->reference - wheel) < 0.0)
		at->motor = 0;
	else if (!at->motor && fabs(chain->motor) > chain->motor_most)
		at->motor = side(chain->motor);
	if (at->rope && at->rope*(wheel - next) < 0.0)
		at->rope = 0;
	else if (!at->rope && fabs(chain->drive) > chain->traction)
		at->rope = side(chain->drive);
	if (at->rope && at->motor && !(chain->wheel_mass > 0.0)) { /* the weaker of two in series slips */
		if (chain->motor_most < chain->traction)
			at->rope = 0;
		else
			at->motor = 0;
	}
	return at->rope != before.rope || at->motor != before.motor;
}

/* Correct all laws, or the first that does not hold. */
static int correct(struct hawser__chain *chain, int one)
{
	int changes = correct_drive(chain);

	for (int i = 0; i < chain->N && !(one && changes); i++) {
		double next = 2.0*chain->solved[i] - chain->q[i], force = friction(chain, i);
		int before = chain->state[i];

		if (!(chain->bound[i] > 0.0))
			continue;
		if (before && before*next < 0.0)
			chain->state[i] = 0;
		else if (!before && fabs(force) > chain->bound[i])
			chain->state[i] = -side(force);
		changes += chain->state[i] != before;
	}
	return changes;
}

/* Bounds of the tensions that were found, if they differ from those of the solution: 1 if so. */
static int follow(struct hawser__chain *chain)
{
	double traction = chain->traction, *before = chain->rhs;
	int moved;

	memcpy(before, chain->bound, (size_t)chain->N*sizeof *before);
	hawser__chain_bounds(chain);
	moved = chain->at_drive.rope && fabs(chain->traction - traction) > SETTLED*traction;
	for (int i = 0; i < chain->N && !moved; i++)
		moved = fabs(chain->bound[i] - before[i]) > SETTLED*before[i];
	if (moved)
		return 1;
	memcpy(chain->bound, before, (size_t)chain->N*sizeof *before);
	chain->traction = traction;
	return 0;
}

/* Power that the rope loses by its rate of strain, W. */
static double lost(const struct hawser__chain *chain)
{
	double sum = 0.0;

	for (int lane = 0; lane < 2 && chain->loss > 0.0; lane++)
		for (int e = 1; e <= chain->E; e++) {
			int a = hawser__chain_node(chain, lane, e - 1), b = hawser__chain_node(chain, lane, e);
			int k = lane*chain->slow->spans + (e - 1)/chain->m;
			double flow = sign_of(lane)*(chain->solved[a] - chain->solved[b]) +
			              (e == 1 ? chain->solved[1] : 0.0);

			if ((e - 1)%chain->m == chain->m/2)
				flow -= chain->gamma[k]*chain->sag_solved[k];
			sum += chain->loss/chain->c[k]*flow*flow;
		}
	return sum;
}

/* To the end of the step. */
static void advance(struct hawser__chain *chain)
{
	int top = 2*chain->E;
	double h = chain->h, wheel = drive(chain), mean = 0.5*(wheel + chain->wheel);

	for (int i = 0; i < chain->N; i++)
		chain->dissipated -= h*friction(chain, i)*chain->solved[i];
	chain->dissipated += h*chain->drive*(mean - chain->solved[top]) + h*lost(chain);
	chain->work += h*chain->motor*mean;
	chain->slow_work -= h*chain->now.force*chain->solved[top];
	if (chain->at_drive.rope)
		chain->slip += h*fabs(mean - chain->solved[top]);
	for (int i = 0; i < chain->N; i++) {
		chain->u[i] += h*chain->solved[i];
		chain->q[i] = chain->bound[i] > 0.0 && !chain->state[i] ? 0.0
		                                                        : 2.0*chain->solved[i] - chain->q[i];
	}
	if (!chain->at_drive.rope && !chain->at_drive.motor)
		chain->q[top] = chain->reference;
	for (int k = 0; k < 2*chain->slow->spans; k++) {
		chain->sag[k] += h*chain->sag_solved[k];
		chain->sag_q[k] = 2.0*chain->sag_solved[k] - chain->sag_q[k];
	}
	chain->wheel = wheel;
	chain->t += h;
	chain->steps++;
}

double hawser__chain_kinetic(const struct hawser__chain *chain, const double *mass)
{
	double sum = chain->wheel_mass*chain->wheel*chain->wheel;

	for (int i = 0; i < chain->N; i++)
		sum += mass[i]*chain->q[i]*chain->q[i];
	for (int k = 0; k < 2*chain->slow->spans; k++)
		sum += chain->M[k]*chain->sag_q[k]*chain->sag_q[k];
	return 0.5*sum;
}

double hawser__chain_stored(const struct hawser__chain *chain)
{
	double sum = 0.0;

	for (int lane = 0; lane < 2; lane++)
		for (int e = 1; e <= chain->E; e++) {
			double tau = hawser__chain_excess(chain, lane, e);

			sum += chain->c[lane*chain->slow->spans + (e - 1)/chain->m]*tau*tau;
		}
	for (int k = 0; k < 2*chain->slow->spans; k++) {
		double from = chain->sag[k] - chain->still[k];

		sum += chain->K[k]*from*from;
	}
	return 0.5*sum;
}

enum hawser_status hawser__chain_step(struct hawser__chain *chain, struct hawser_report *report)
{
	int top = 2*chain->E, tries = 0, changes = 1;
	double stored = hawser__chain_stored(chain), kinetic = hawser__chain_kinetic(chain, chain->mass);

	hawser__chain_place(chain, chain->u[top] + 0.5*chain->h*chain->q[top]);
	kinetic = hawser__chain_kinetic(chain, chain->mass) - kinetic;
	chain->exchanged += kinetic;
	chain->slow_work += kinetic + hawser__chain_stored(chain) - stored;
	springs(chain);
	while (changes && tries++ < TRIES) {
		assemble(chain);
		impose(chain);
		memcpy(chain->solved, chain->rhs, (size_t)chain->N*sizeof *chain->solved);
		if (!solve(chain->band, chain->solved, chain->N))
			return hawser__fail_at(report, HAWSER_ERR_NAN, "transient", (int)chain->steps, NAN,
			                       "t = %.6g s: the equations of a step are not positive", chain->t);
		recover(chain);
		changes = correct(chain, tries > TOGETHER);
		changes += follow(chain);
		chain->solves++;
	}
	if (changes)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "transient", TRIES, NAN,
		                       "t = %.6g s: after %d solutions the friction of a step is not settled: "
		                       "give a shorter --step", chain->t, TRIES);
	advance(chain);
	return HAWSER_OK;
}
