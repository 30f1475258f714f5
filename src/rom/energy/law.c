/* rom/energy/law.c - static law of a coordinate: of a reduced model, and of the cable.
 *
 *   u     the coordinate held, scaled;  K  its stiffness at rest
 *   R     its restoring force with all other coordinates at the minimum of the energy, of the model
 *         or of a full-order basis with the exact energy;  the law is R/(K u) - 1
 *   step  the last Newton step of the others, which relax.c does not make
 *
 * Held at u, the error of R is of the first order in that of the other coordinates, with stiffnesses
 * of the order of EA as coefficients, so that R includes the effect of the last step. Each law is
 * relative to its own K, since the K of a basis differs from that of the modes by its error.
 *
 * The relaxed coordinates of the cable are those that symmetry moves: with a mode in the plane of a
 * plane cable, those out of it stay at rest. In tension the energy is convex, so that the minimum is
 * the only one. Where the cable is slack it is not, and the law of a real cable would be another one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/energy/exact.h"
#include "rom/energy/law.h"
#include "rom/condense/known.h"

/* Functions per component of the bases; chosen. The largest that a model may have is 33. */
static const int functions[HAWSER__LAW_BASES] = {16, 24, 32};
enum { FIRST_BENT = 1, /* with bending stiffness: its layers at held ends need more */
       PARTS = 16 };   /* steps to the amplitude where one step finds no minimum; chosen */
#define LOOSE 0.05     /* least tension, of the largest one, of a cable that is slack elsewhere or
                        * nearly so, where no minimum is found; chosen */
#define SETTLED 1e-3   /* `exact` may still move by this with a larger basis, of the force */

void hawser__law_close(struct hawser__law *law)
{
	hawser__relax_clear(&law->model);
	for (int b = 0; b < HAWSER__LAW_BASES; b++) {
		hawser__relax_clear(&law->exact[b]);
		hawser_rom_clear(&law->full[b]);
		free(law->strain[b]);
	}
}

enum hawser_status hawser__law_open(struct hawser__law *law, const struct hawser_rom *rom,
                                    const struct hawser_statics *statics,
                                    struct hawser_report *report)
{
	*law = (struct hawser__law){.rom = rom, .statics = statics};
	if (rom->exact || !rom->range || rom->line.points == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "law",
		                    "the static law is that of a model of a span's modes, with quadratic and "
		                    "cubic terms: build it from the scene, with model.energy: quartic");
	return hawser__relax_new(&law->model, rom) ? hawser__no_memory(report, "law") : HAWSER_OK;
}

int hawser__law_is_mode(const struct hawser_rom *rom, int j)
{
	return rom->range[j].largest > 0.0;
}

int hawser__law_even(const struct hawser__law *law)
{
	const struct hawser_rom_exact *exact = law->full[law->basis].exact;

	for (int i = 0; i < exact->other; i++)
		if (exact->index[i] == law->twin)
			return 0;
	return exact->other > 0;
}

static enum hawser_status make_basis(struct hawser__law *law, int b, struct hawser_report *report)
{
	enum hawser_status status;

	if (law->full[b].n > 0)
		return HAWSER_OK;
	status = hawser_rom_build_full(&law->full[b], law->statics, NULL, functions[b], report);
	if (status)
		return status;
	law->strain[b] = malloc((size_t)law->full[b].exact->points*sizeof *law->strain[b]);
	return hawser__relax_new(&law->exact[b], &law->full[b]) || !law->strain[b]
	       ? hawser__no_memory(report, "law") : HAWSER_OK;
}

static void free_others(struct hawser__relax *relax, int held)
{
	relax->frees = 0;
	for (int i = 0; i < relax->N; i++)
		if (i != held)
			relax->freed[relax->frees++] = i;
}

/* The coordinates that the held one moves by symmetry. */
static void free_exact(struct hawser__law *law)
{
	struct hawser__relax *relax = &law->exact[law->basis];
	const struct hawser_rom_exact *exact = law->full[law->basis].exact;

	memset(relax->y, 0, (size_t)relax->N*sizeof *relax->y);
	free_others(relax, law->twin);
	if (exact->other == 0 || hawser__law_even(law))
		return;
	relax->frees = 0;
	for (int i = 0; i < exact->in; i++)
		if (exact->index[i] != law->twin)
			relax->freed[relax->frees++] = exact->index[i];
}

/* The power p for which the damping of a mode is proportional to omega^p, from mode j and the highest
 * mode that is kept or known: 0 for damping by mass, 1 for damping ratios, 2 for damping by
 * stiffness. */
static double damping_power(const struct hawser_rom *rom, int j)
{
	const struct hawser_rom_known *known = &rom->known;
	size_t step = (size_t)rom->n + 1, own = (size_t)j*step;
	double K = rom->K[own], D = rom->D[own];

	for (int i = 0; i < rom->n + known->modes; i++) {
		const double *of = i < rom->n ? &rom->K[(size_t)i*step] : &known->K[i - rom->n];

		if (*of > K && (i >= rom->n || hawser__law_is_mode(rom, i))) {
			K = *of;
			D = i < rom->n ? rom->D[(size_t)i*step] : known->D[i - rom->n];
		}
	}
	return D > 0.0 && K > rom->K[own] ? 2.0*log(D/rom->D[own])/log(K/rom->K[own]) : 0.0;
}

enum hawser_status hawser__law_hold(struct hawser__law *law, int *found, int j, int first,
                                    struct hawser_report *report)
{
	int b = first == 0 && law->statics->bending.EI > 0.0 ? FIRST_BENT : first, twin = 0;
	enum hawser_status status = HAWSER_OK;

	*found = 0;
	for (; !twin && b < HAWSER__LAW_BASES; b++) {
		status = make_basis(law, b, report);
		if (status)
			return status;
		twin = hawser__twin(law->rom, j, &law->full[b]);
		law->basis = b;
	}
	if (!twin)
		return HAWSER_OK;
	*found = 1;
	law->j = j;
	law->power = damping_power(law->rom, j);
	law->twin = abs(twin) - 1;
	law->sign = twin > 0 ? 1.0 : -1.0;
	free_others(&law->model, j);
	free_exact(law);
	return HAWSER_OK;
}

/* In equal steps of the coordinate. */
static int walk(struct hawser__relax *relax, int held, double u, int parts)
{
	relax->y[held] = u/parts;
	hawser__relax_place(relax);
	for (int k = 1; hawser__relax(relax, fabs(u)); k++) {
		if (k == parts)
			return 1;
		hawser__relax_along(relax, held, u/parts);
	}
	return 0;
}

/* From the second-order state, or else in steps. */
static int relax_to(struct hawser__relax *relax, int held, double u)
{
	return walk(relax, held, u, 1) || walk(relax, held, u, PARTS);
}

int hawser__law_force(double *law, double tension[2], struct hawser__relax *relax, int held, double u)
{
	const double *T = relax->T + (size_t)held*(size_t)relax->N;
	double K = relax->rom->K[(size_t)held*((size_t)relax->N + 1)], R;

	*law = tension[0] = tension[1] = NAN;
	if (!relax_to(relax, held, u)) {
		(void)hawser_rom_tensions(relax->rom, &tension[0], &tension[1], relax->y);
		return 0;
	}
	R = relax->R[held];
	for (int i = 0; i < relax->frees; i++) {
		R += T[relax->freed[i]]*relax->step[i];
		relax->y[relax->freed[i]] += relax->step[i];
	}
	*law = R/(K*u) - 1.0;
	(void)hawser_rom_tensions(relax->rom, &tension[0], &tension[1], relax->y);
	return isfinite(*law);
}

/* In the state of the present basis, also one that is no minimum. */
static int slack(const struct hawser__law *law)
{
	const struct hawser_rom_exact *exact = law->full[law->basis].exact;
	double *strain = law->strain[law->basis], least = 0.0;

	hawser__exact_strain(exact, strain, law->exact[law->basis].y, NULL);
	for (int p = 0; p < exact->points; p++)
		least = fmin(least, strain[p]);
	return least < 0.0;
}

void hawser__law_exact(struct hawser__law *law, struct hawser_law_point *point)
{
	double u = law->sign*point->u;

	int found = hawser__law_force(&point->exact, point->tension, &law->exact[law->basis], law->twin, u);

	point->functions = functions[law->basis];
	/* in tension there is always a minimum, and it is found */
	if (slack(law) || point->tension[0] < (found ? 0.0 : LOOSE*point->tension[1]))
		point->end = HAWSER_LAW_SLACK;
	else if (!found)
		point->end = HAWSER_LAW_NO_EXACT;
}

/* Sum of the squares of the coordinates that are relaxed, times that power of their frequency over that
 * of the held one. */
static double moved(const struct hawser__relax *relax, int held, double power)
{
	size_t N = (size_t)relax->N;
	const double *K = relax->rom->K;
	double sum = 0.0;

	for (size_t i = 0; i < N; i++)
		if (i != (size_t)held)
			sum += relax->y[i]*relax->y[i]*pow(K[i*(N + 1)]/K[(size_t)held*(N + 1)], 0.5*power);
	return sum;
}

void hawser__law_at(struct hawser__law *law, struct hawser_law_point *point)
{
	const struct hawser__relax *exact = &law->exact[law->basis];
	double lacks[2];

	point->u = point->amplitude/law->rom->range[law->j].largest;
	point->error = NAN;
	point->end = HAWSER_LAW_FOUND;
	hawser__law_exact(law, point);
	if (!hawser__law_force(&point->model, point->model_tension, &law->model, law->j, point->u) &&
	    !point->end)
		point->end = HAWSER_LAW_NO_MODEL;
	for (int k = 0; k < 2; k++) {
		lacks[k] = moved(exact, law->twin, k*law->power) - moved(&law->model, law->j, k*law->power);
		lacks[k] = fmax(lacks[k], 0.0)/(point->u*point->u);
	}
	point->inertia = 2.0*lacks[0];
	point->damping = lacks[1];
}

static enum hawser_status check(const struct hawser_law_point *point, int count,
                                const struct hawser_rom *rom, int j, struct hawser_report *report)
{
	if (j < 0 || j >= rom->n || !hawser__law_is_mode(rom, j))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "law",
		                    "coordinate %d is no mode of the cable: a model of %d coordinates has "
		                    "those from 0 on that are labelled as modes", j, rom->n);
	for (int i = 0; i < count; i++)
		if (!isfinite(point[i].amplitude) || point[i].amplitude == 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "law",
			                    "amplitude %g m: hold the coordinate at a finite amplitude other "
			                    "than 0", point[i].amplitude);
	return HAWSER_OK;
}

/* One basis more; 1: `exact` has settled at all points. */
static int refine(struct hawser__law *law, struct hawser_law_point *point, int count)
{
	int settled = 1;

	for (int i = 0; i < count; i++) {
		double before = point[i].exact;
		enum hawser_law_end end = point[i].end;

		point[i].end = HAWSER_LAW_FOUND;
		hawser__law_exact(law, &point[i]);
		if (!point[i].end && end == HAWSER_LAW_NO_MODEL)
			point[i].end = end;
		point[i].error = fabs(point[i].exact - before);
		settled &= point[i].end == HAWSER_LAW_SLACK ||
		           point[i].error <= SETTLED*fabs(1.0 + point[i].exact);
	}
	return settled;
}

enum hawser_status hawser_law_trace(struct hawser_law_point *point, int count,
                                    const struct hawser_rom *rom,
                                    const struct hawser_statics *statics, int j,
                                    struct hawser_report *report)
{
	struct hawser__law law;
	enum hawser_status status = hawser__law_open(&law, rom, statics, report);
	int found = 0, settled = 0;

	if (!status)
		status = check(point, count, rom, j, report);
	if (!status)
		status = hawser__law_hold(&law, &found, j, 0, report);
	for (int i = 0; found && i < count; i++)
		hawser__law_at(&law, &point[i]);
	while (!status && found && !settled && law.basis + 1 < HAWSER__LAW_BASES) {
		status = hawser__law_hold(&law, &found, j, law.basis + 1, report);
		settled = !status && found && refine(&law, point, count);
	}
	if (!status && !found)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "law",
		                      "no basis of up to %d functions a component resolves the mode of "
		                      "coordinate %d: hold a lower one", functions[HAWSER__LAW_BASES - 1], j);
	hawser__law_close(&law);
	return status;
}
