/* response/floquet/monodromy_plan.c - the number of steps per period for multipliers (monodromy.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/floquet/monodromy.h"

#define S HAWSER__NODES
#define TURN 2.6             /* rad of the fastest coordinate per step, from HAWSER__STEP_ERROR and
                              * the goal */
#define AFFORDABLE 2e8       /* largest number of operations of a strict computation; chosen */
#define CHEAP 1e6            /* number of operations up to which a hasty computation condenses
                              * nothing; chosen */
#define HASTY_TURN 3.2       /* TURN of a hasty computation: an error of 3e-9 */
#define HASTY_FOLLOW 4.0     /* least frequency, relative to Omega, of coordinates that it
                              * condenses; chosen */
#define MOST_STEPS 400 /* per period; a strict computation may take more; chosen */
/* In a stiff model the fastest kept coordinate turns by this angle per step, with which the error of
 * the logarithms is about 1e-6. If that takes too many operations, only the relevant coordinates do,
 * and the error of the product (hawser__monodromy.loss) includes the unresolved ones. */
#define STIFF_TURN 4.8
#define RESOLVABLE 2e9       /* number of operations up to which the phases of all kept coordinates are
                              * resolved; chosen */
#define STIFF_LEAST 6.0      /* least frequency, relative to Omega, that is resolved; chosen */
/* Harmonics of the wrong parity, relative to the stiffness, that do not count: above round-off, and far
 * below the errors of multipliers of stiff models. */
#define NO_PART 1e-11

/* Number of steps with which the error becomes a third of the goal; the error falls with h^16. */
int hawser__monodromy_better(const struct hawser__monodromy *monodromy, double goal)
{
	double ratio = pow(fmax(monodromy->error, 1e-300)/(goal/3.0), 1.0/16.0);

	return (int)fmin(monodromy->most, fmax(2, ceil(monodromy->steps*fmin(4.0, ratio))));
}

/* Where the most steps are too few nothing is gained by them. */
int hawser__monodromy_raised(const struct hawser__monodromy *monodromy)
{
	double steps = monodromy->steps*pow(monodromy->loss/HAWSER__NEGLECTED, 1.0/16.0);

	if (!(monodromy->loss > HAWSER__NEGLECTED) || steps > monodromy->most)
		return monodromy->steps;
	return (int)fmin(monodromy->most, ceil(fmax(steps, 1.25*monodromy->steps)));
}

/* Angle of the fastest coordinate in a period, in rad or e-folds, from the sums of the rows. */
static double turn(const struct hawser__variational *system)
{
	int n = system->n;
	size_t n2 = (size_t)n*n;
	double stiff = 0.0, damp = 0.0;
	int order = system->order > system->order_d ? system->order : system->order_d;

	for (int j = 0; j < n; j++) {
		double row = 0.0, row_d = 0.0;

		for (int k = j*n; k < (j + 1)*n; k++) {
			for (int r = 0; r <= 2*system->order; r++)
				row += (r ? 1.0 : 0.5)*fabs(system->K[r*n2 + k]);
			for (int r = 0; r <= 2*system->order_d; r++)
				row_d += (r ? 1.0 : 0.5)*fabs(system->D[r*n2 + k]);
		}
		stiff = fmax(stiff, row);
		damp = fmax(damp, row_d);
	}
	return 2.0*M_PI*fmax((sqrt(stiff) + damp)/system->omega, order);
}

/* Operations of a step of a component of n coordinates. */
static double cost_of(int n)
{
	return 0.7*pow(S*n, 3.0) + 2000.0;
}

void hawser__monodromy_afford(struct hawser__monodromy *monodromy, int widest)
{
	monodromy->most = (int)fmax(MOST_STEPS, AFFORDABLE/cost_of(widest));
}

void hawser__monodromy_limits(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system, int widest)
{
	double steps = turn(system)/TURN;

	monodromy->most = MOST_STEPS;
	monodromy->haste = 0;
	if (!monodromy->finer)
		return;
	hawser__monodromy_afford(monodromy, widest);
	monodromy->haste = monodromy->rough || (monodromy->hasty && steps*cost_of(widest) > CHEAP);
	monodromy->follow = monodromy->haste ? HASTY_FOLLOW
	                    : steps <= monodromy->most ? INFINITY : HAWSER__FOLLOW;
}

/* The number of steps that resolves all phases; fails if it is too large. */
static enum hawser_status strict(struct hawser__monodromy *monodromy,
                                 const struct hawser__variational *system, int stiff,
                                 struct hawser_report *report)
{
	double needed = turn(system)/(stiff || monodromy->rough ? STIFF_TURN
	                              : monodromy->haste ? HASTY_TURN : TURN);

	if (needed > monodromy->most)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "floquet",
		                    "multipliers at Omega %.9g need about %.0f steps a period for %d "
		                    "coordinates, and %d are the most: the fastest coordinate, or the "
		                    "strongest damping, is too far above Omega; keep fewer modes",
		                    system->omega, needed, system->n, monodromy->most);
	monodromy->steps = (monodromy->haste ? 1 : monodromy->finer)*(int)fmax(fmax(ceil(needed), 2),
	                                              stiff ? 3*monodromy->steps : 0);
	monodromy->steps += monodromy->more*(monodromy->steps/4 + 1);
	return HAWSER_OK;
}

/* Steps that resolve the relevant frequencies, and those of all kept coordinates unless this is too
 * expensive, as where nothing could be condensed. */
static void plan_stiff(struct hawser__monodromy *monodromy, const struct hawser__variational *system)
{
	double turns = fmax(STIFF_LEAST, hawser__monodromy_pace(monodromy, system)/system->omega);
	double all = 2.0*M_PI/STIFF_TURN*fmax(turns, monodromy->top/system->omega);

	monodromy->resolved = all*cost_of(system->n) < RESOLVABLE;
	monodromy->steps = (int)fmin(monodromy->most,
	                             ceil(monodromy->resolved ? all : 2.0*M_PI/STIFF_TURN*turns));
	if (monodromy->resolved && monodromy->phases > monodromy->steps) /* fewer along the branch */
		monodromy->steps = (monodromy->phases - (monodromy->phases + 15)/16)/2*2;
}

enum hawser_status hawser__monodromy_plan(struct hawser__monodromy *monodromy,
                                          const struct hawser__variational *system,
                                          struct hawser_report *report)
{
	int stiff = monodromy->fastest < INFINITY && !monodromy->haste;

	if (stiff)
		plan_stiff(monodromy, system);
	if (monodromy->sharper) /* unresolved coordinates of a stiff model need more steps */
		monodromy->steps += !stiff ? monodromy->steps/3 + 1
		                    : monodromy->resolved ? monodromy->steps : 3*monodromy->steps;
	return monodromy->finer ? strict(monodromy, system, stiff, report) : HAWSER_OK;
}

double hawser__monodromy_stiff_error(const struct hawser__monodromy *monodromy)
{
	return monodromy->steps*HAWSER__STEP_ERROR*pow(STIFF_TURN, 17.0);
}

/* Largest coefficient of entry e of a series, of the harmonics of one parity. */
static double of_parity(const double *series, int n, int order, int e, int parity)
{
	double most = 0.0;

	for (int r = 0; r <= 2*order; r++)
		if ((r + 1)/2%2 == parity)
			most = fmax(most, fabs(series[(size_t)r*n*n + e]));
	return most;
}

/* Of coordinates p and q of the component, whether harmonics of this parity couple them. */
static int couples(const struct hawser__variational *system, const struct hawser__component *c, int p,
                   int q, int parity)
{
	int n = c->n, i = c->member[p], j = c->member[q];
	double both = sqrt(fabs(system->K[(size_t)i*(n + 1)]*system->K[(size_t)j*(n + 1)]));

	return of_parity(system->K, n, system->order, i*n + j, parity) +
	       system->omega*of_parity(system->D, n, system->order_d, i*n + j, parity) > NO_PART*both;
}

/* Sets the signs of the coordinates that p is coupled with. Returns their number, or -1 where they
 * contradict. */
static int spread_sign(int *sign, const struct hawser__variational *system,
                       const struct hawser__component *c, int p)
{
	int count = 0;

	for (int q = 0; q < c->w; q++)
		for (int parity = 0; parity < 2; parity++) {
			int as = parity ? -sign[p] : sign[p];

			if (sign[q] == as || !(couples(system, c, p, q, parity) ||
			                       couples(system, c, q, p, parity)))
				continue;
			if (sign[q] != 0)
				return -1;
			sign[q] = as;
			count++;
		}
	return count;
}

int hawser__monodromy_repeats(int *sign, const struct hawser__variational *system,
                              const struct hawser__component *c)
{
	for (int p = 0; p < c->w; p++)
		sign[p] = 0;
	for (int first = 0; first < c->w; first++) {
		int more = sign[first] == 0;

		if (more)
			sign[first] = 1;
		while (more) {
			more = 0;
			for (int p = 0; p < c->w; p++) {
				int count = sign[p] != 0 ? spread_sign(sign, system, c, p) : 0;

				if (count < 0)
					return 0;
				more += count;
			}
		}
	}
	return 1;
}
