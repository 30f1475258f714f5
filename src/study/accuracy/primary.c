/* study/accuracy/primary.c - the closed forms of hawser/primary.h: coefficients from the modulation
 * equations of one mode, peak and folds from scales.c.
 *
 * The modulation equations have the term beta A^2 conj(A) with beta = 3 cubic: for A = a/2 exp(i
 * phi) it is 3/4 cubic a^3. The direct response of other modes causes further monomials. They are
 * neglected as being of higher order: a load that drives the mode to the amplitude a is of third
 * order in a.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/backbone/modulation.h"
#include "study/accuracy/primary.h"
#include "study/accuracy/scales.h"

static const char where[] = "multiple scales";

int hawser_primary_strongest(const struct hawser_rom *rom)
{
	double most = 0.0;
	int best = -1;

	for (int s = 0; s < rom->n; s++) {
		double complex unused;
		double omega = sqrt(fmax(hawser__stiffness(rom, s), 0.0));
		double damping = rom->D[(size_t)s*((size_t)rom->n + 1)];
		double answer = cabs(hawser__load(&unused, rom, s, 1, omega))/(omega*damping);

		if (omega > 0.0 && damping > 0.0 && answer > most*(1.0 + 1e-9)) {
			most = answer;
			best = s;
		}
	}
	return best;
}

double hawser__primary_cubic(const struct hawser_modulation *m)
{
	for (int i = 0; i < m->monomials; i++) {
		const int *factor = m->monomial[i].factor;

		if (factor[0] == 0 && factor[1] == 0 && factor[2] == 1)
			return m->monomial[i].re/3.0;
	}
	return 0.0;
}

static double own_cubic(const struct hawser_rom *rom, int j)
{
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *e = &rom->C[i];

		if (e->j == j && e->k == j && e->l == j && e->m == j)
			return e->value;
	}
	return 0.0;
}

static enum hawser_status check(const struct hawser_primary *primary, struct hawser_report *report)
{
	if (!(primary->damping > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "mode %d has the damping %g: without damping its resonance has no "
		                    "peak (hawser frf --backbone computes its backbone)",
		                    primary->mode + 1, primary->damping);
	if (!(hypot(primary->load[0], primary->load[1]) > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the load has no component on mode %d at the forcing frequency: name "
		                    "another mode, or request a super- or subharmonic resonance",
		                    primary->mode + 1);
	return HAWSER_OK;
}

static void solve(struct hawser_primary *primary)
{
	const struct hawser__resonance resonance = {
		.omega = primary->omega, .c = primary->damping, .cubic = primary->cubic,
		.f = hypot(primary->load[0], primary->load[1]),
	};
	struct hawser__scales scales = hawser__scales_solve(&resonance);

	primary->gamma = 0.375*primary->cubic/primary->omega;
	primary->peak = scales.peak;
	primary->peak_omega = scales.peak_omega;
	primary->folds = scales.folds;
	for (int k = 0; k < scales.folds; k++) {
		primary->fold[k] = scales.fold[k];
		primary->fold_omega[k] = scales.fold_omega[k];
	}
}

enum hawser_status hawser_primary_derive(struct hawser_primary *primary,
                                         const struct hawser_rom *rom,
                                         int mode, struct hawser_report *report)
{
	struct hawser_resonance resonance = {.count = 1, .mode = {mode}, .order = {1}};
	double complex load, unused;
	enum hawser_status status;

	memset(primary, 0, sizeof *primary);
	if (mode < 0 || mode >= rom->n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "mode %d: the model has modes 1 to %d",
		                    mode + 1, rom->n);
	resonance.omega0 = sqrt(fmax(hawser__stiffness(rom, mode), 0.0));
	status = hawser_modulation_derive(&primary->modulation, rom, &resonance, report);
	if (status)
		return status;
	load = 2.0*hawser__load(&unused, rom, mode, 1, resonance.omega0);
	primary->mode = mode;
	primary->omega = resonance.omega0;
	primary->damping = rom->D[(size_t)mode*((size_t)rom->n + 1)];
	primary->load[0] = creal(load);
	primary->load[1] = cimag(load);
	primary->own = own_cubic(rom, mode);
	primary->cubic = hawser__primary_cubic(&primary->modulation);
	status = check(primary, report);
	if (status)
		hawser_primary_clear(primary);
	else
		solve(primary);
	return status;
}

/* What u_j^2 or u_j u_m does in an equation: the coefficient of the term in Q. */
static double quadratic(const struct hawser_rom *rom, int j, int k, int l)
{
	for (int i = 0; i < rom->quads; i++)
		if (rom->Q[i].j == j && rom->Q[i].k == (k < l ? k : l) && rom->Q[i].l == (k < l ? l : k))
			return rom->Q[i].value;
	return 0.0;
}

/* |w^2 - p^2 + i c p| of mode j at the frequency p. */
static double impedance(const struct hawser_rom *rom, int j, double p)
{
	return hypot(hawser__stiffness(rom, j) - p*p, rom->D[(size_t)j*((size_t)rom->n + 1)]*p);
}

/* How far the motion of mode m with the amplitude a at W is beyond that from which on it excites mode j
 * at W/2: by a stiffness c a cos W t. */
static double excited(const struct hawser_rom *rom, int j, int m, double W, double a)
{
	return 0.5*fabs(quadratic(rom, j, j, m))*a/impedance(rom, j, 0.5*W);
}

int hawser__primary_excites(const struct hawser_primary *primary, double W, double a)
{
	const struct hawser_rom *rom = primary->modulation.rom;
	int count = 0;

	for (int j = 0; j < rom->n; j++)
		count += j != primary->mode && excited(rom, j, primary->mode, W, a) > 1.0;
	return count;
}

int hawser_primary_rival(double *strength, const struct hawser_primary *primary,
                         const struct hawser_rom *rom)
{
	double W = primary->omega, a = primary->peak; /* such a rival spoils peak_omega */
	int m = primary->mode, rival = -1;

	*strength = 1.0;
	for (int j = 0; j < rom->n; j++) {
		/* driven by c a^2/2 cos 2 W t */
		double driven = 0.5*fabs(quadratic(rom, j, m, m))*a/impedance(rom, j, 2.0*W);
		double most = hawser__stiffness(rom, j) > W*W ? driven : excited(rom, j, m, W, a);

		if (j != m && most > *strength) {
			*strength = most;
			rival = j;
		}
	}
	return rival;
}

void hawser_primary_clear(struct hawser_primary *primary)
{
	if (!primary)
		return;
	hawser_modulation_clear(&primary->modulation);
	memset(primary, 0, sizeof *primary);
}
