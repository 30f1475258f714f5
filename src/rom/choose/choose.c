/* rom/choose/choose.c - selection of the modes that are kept.
 *
 *    f_j, D_j, w_j  load, damping, frequency of mode j
 *    gamma_j        effective cubic coefficient with all other modes condensed, including the
 *                   contribution -10/9 Q_jjj^2/w_j^2 of the quadratic one
 *    A_j            expected largest amplitude of mode j at its resonance: the smaller of f/(D w) and
 *                   the amplitude at which the backbone w + 3/8 gamma A^2/w leaves the range
 *
 * The first measures (weigh.c) result from estimated motions: the linear response at STATIONS
 * frequencies of the range, and each resonance in the range at A_j and A_j/2 on its backbone.
 * Computed orbits replace them later (hawser_choice_weigh).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/names.h"
#include "core/report.h"
#include "rom/build/build.h"
#include "rom/terms/dampers.h"
#include "rom/terms/drag.h"
#include "rom/choose/drive.h"
#include "rom/terms/load.h"
#include "rom/condense/support.h"
#include "rom/choose/weigh.h"

#define ROWS 32 /* phases of a period at which a motion is evaluated: resolves 16 harmonics */
#define STATIONS 9 /* frequencies over the range; chosen */
#define NEGLIGIBLE HAWSER__NEGLIGIBLE

HAWSER__NAMES(hawser_reason_name, enum hawser_reason, [HAWSER_NOT_EXCITED] = "not excited",
	[HAWSER_CONDENSED] = "condensed", [HAWSER_DIRECT] = "direct",
	[HAWSER_PARAMETRIC] = "parametric", [HAWSER_INTERNAL] = "internal",
	[HAWSER_DYNAMIC] = "dynamic")

/* --- estimated motions --- */

static double frequency(const struct hawser_choice *choice, int j)
{
	return sqrt(choice->all.K[j*choice->n + j]);
}

static double load_of(const struct hawser_choice *choice, int j)
{
	return choice->load[j];
}

static double largest_load(const struct hawser_choice *choice)
{
	double largest = 0.0;

	for (int j = 0; j < choice->n; j++)
		largest = fmax(largest, fabs(load_of(choice, j)));
	return largest;
}

static double quad(const struct hawser_choice *choice, int j, int k, int l)
{
	for (int i = 0; i < choice->all.quads; i++) {
		const struct hawser_quad *q = &choice->all.Q[i];

		if (q->j == j && q->k == (k < l ? k : l) && q->l == (k < l ? l : k))
			return q->value;
	}
	return 0.0;
}

static double gamma_of(const struct hawser_choice *choice, int j)
{
	double w = frequency(choice, j), own = quad(choice, j, j, j), sum = -10.0/9.0*own*own/(w*w);

	for (int i = 0; i < choice->all.cubics; i++) {
		const struct hawser_cubic *c = &choice->all.C[i];

		if (c->j == j && c->k == j && c->l == j && c->m == j)
			sum += c->value;
	}
	for (int s = 0; s < choice->n; s++)
		if (s != j)
			sum -= quad(choice, j, j, s)*quad(choice, s, j, j)/pow(frequency(choice, s), 2);
	return sum;
}

/* A_j if the resonance is in the range, and the frequency of its backbone there. */
static double amplitude(double *omega, const struct hawser_choice *choice, int j, double part)
{
	double w = frequency(choice, j), gamma = gamma_of(choice, j);
	double d = choice->all.D[j*choice->n + j], A = fabs(load_of(choice, j))/(d*w);
	double room = (gamma > 0.0 ? choice->to - w : w - choice->from)*8.0/3.0*w/fabs(gamma);

	A = part*fmin(A, sqrt(fmax(room, 0.0)));
	*omega = fmin(fmax(w + 0.375*gamma*A*A/w, choice->from), choice->to);
	return A;
}

/* u[ROWS][n] = Re a_j exp(i tau). */
static void spread(double *u, const struct hawser_choice *choice, const double complex *a)
{
	for (int t = 0; t < ROWS; t++)
		for (int j = 0; j < choice->n; j++)
			u[t*choice->n + j] = creal(a[j]*cexp(I*2.0*M_PI*t/ROWS));
}

/* The linear response with mode `peak` (or -1) at its own amplitude; no other amplitude exceeds
 * `most`. */
static enum hawser_status guess(struct hawser_choice *choice, double *u, double complex *a, int peak,
                                double most, double omega, int whole,
                                struct hawser_report *report)
{
	enum hawser_status status = hawser__respond(&choice->all, a, omega, report);

	if (status)
		return status;
	for (int j = 0; j < choice->n; j++)
		if (cabs(a[j]) > most)
			a[j] *= most/cabs(a[j]);
	if (peak >= 0)
		a[peak] = -I*most;
	spread(u, choice, a);
	return hawser__weigh(choice, u, ROWS, omega, 0.5*(choice->to - choice->from)/(STATIONS - 1),
	                     whole, HAWSER__BY_PLANE, 0, NULL, report);
}

static enum hawser_status guess_all(struct hawser_choice *choice, struct hawser_report *report)
{
	double *u = malloc((size_t)ROWS*(size_t)choice->n*sizeof *u), most = 0.0, omega;
	double complex *a = malloc((size_t)choice->n*sizeof *a);
	double floor = NEGLIGIBLE*largest_load(choice);
	enum hawser_status status = u && a ? HAWSER_OK : hawser__no_memory(report, "choose");

	for (int j = 0; !status && j < choice->n; j++) {
		double w = frequency(choice, j), A;

		if (fabs(load_of(choice, j)) <= floor || w < choice->from || w > choice->to)
			continue;
		A = amplitude(&omega, choice, j, 1.0);
		most = fmax(most, A);
		if (A > 0.0)
			status = guess(choice, u, a, j, A, omega, 1, report);
		A = amplitude(&omega, choice, j, 0.5);
		if (!status && A > 0.0)
			status = guess(choice, u, a, j, A, omega, 1, report);
	}
	for (int i = 0; !status && i < STATIONS; i++) {
		omega = choice->from + i*(choice->to - choice->from)/(STATIONS - 1);
		status = guess(choice, u, a, -1, most > 0.0 ? most : HUGE_VAL, omega,
		               most == 0.0, report);
	}
	free(u);
	free(a);
	return status;
}

/* --- the choice --- */

static enum hawser_status check(const struct hawser_modes *modes, const struct hawser_scene *scene,
                                double from, double to, double accuracy,
                                struct hawser_report *report)
{
	enum hawser_status status = hawser__rom_real(modes, report);

	if (status)
		return status;
	if (modes->statics.elastic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "modes are not weighed with support.A.stiffness and support.B.stiffness: "
		                    "give model.modes as a number, and compare with more");
	if (modes->statics.bending.EI > 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "modes are not weighed with cable.EI: give model.modes as a number, and "
		                    "compare with more");
	if (modes->stroke)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "modes are not weighed with absorbers of attach: give model.modes as a "
		                    "number, and compare with more");
	if (hawser__has_dampers(&modes->statics))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "modes are not weighed with dampers of attach, whose shapes are "
		                    "coordinates too: give model.modes as a number, and compare with more");
	if (!(from > 0.0) || !(to > 0.0) || !isfinite(from) || !isfinite(to) || from == to)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "frequency range from %.9g to %.9g rad/s: both ends must be "
		                    "positive, finite and different", from/modes->time_unit,
		                    to/modes->time_unit);
	if (!(accuracy > 0.0 && accuracy < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "accuracy %g: it is a part, between 0 and 1 (0.01 is 1 %%)",
		                    accuracy);
	for (int i = 0; i < scene->loads; i++)
		if (scene->piece[i].harmonic != 1)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
			                    "loads.%d.harmonic is %d: modes are weighed with loads of the "
			                    "frequency Omega only; give model.modes as a number", i,
			                    scene->piece[i].harmonic);
	if (!hawser__loaded(scene) && !(modes->statics.motion.swing > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "the scene has no load along the cable: which modes matter, a load and a "
		                    "range of frequencies decide; give one, or model.modes as a number");
	return HAWSER_OK;
}

/* Start with the modes that the load excites; the measures then decide. */
static enum hawser_status driven(struct hawser_choice *choice, struct hawser_report *report)
{
	double floor = NEGLIGIBLE*largest_load(choice);
	int any = 0;

	choice->planar = 1;
	for (int j = 0; j < choice->n; j++) {
		int drives = fabs(load_of(choice, j)) > floor;

		choice->mode[j].kept = drives;
		any |= drives;
		choice->planar &= !drives || choice->modes->mode[j].plane == HAWSER_IN_PLANE;
	}
	if (any)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
	                    "neither the load nor the changes of speed drive any of the lowest %d "
	                    "modes: give the load another direction or extent", choice->n);
}

static int rank(const struct hawser_choice *choice, int a, int b)
{
	double x = choice->mode[a].measure, y = choice->mode[b].measure;

	return x > y || (x == y && a < b);
}

static void sort(struct hawser_choice *choice)
{
	for (int i = 0; i < choice->n; i++) {
		int k = i;

		for (; k > 0 && rank(choice, i, choice->order[k - 1]); k--)
			choice->order[k] = choice->order[k - 1];
		choice->order[k] = i;
	}
}

enum hawser_reason hawser_choice_reason(const struct hawser_choice *choice, int j)
{
	const struct hawser_choice_mode *mode = &choice->mode[j];

	if (mode->kept)
		return mode->reason;
	return mode->measure > NEGLIGIBLE ? HAWSER_CONDENSED : HAWSER_NOT_EXCITED;
}

/* Keep up to `count` more modes, the first ones, until the rest is within the accuracy. */
static int keep_more(struct hawser_choice *choice, int count, double accuracy)
{
	int added = 0;

	sort(choice);
	for (int i = 0; i < choice->n && added < count && hawser_choice_rest(choice) > accuracy; i++) {
		struct hawser_choice_mode *mode = &choice->mode[choice->order[i]];

		if (mode->kept || !(mode->measure > NEGLIGIBLE))
			continue;
		mode->kept = 1;
		added++;
	}
	return added;
}

int hawser_choice_raise(struct hawser_choice *choice, double accuracy)
{
	return keep_more(choice, INT_MAX, accuracy);
}

int hawser_choice_add(struct hawser_choice *choice, int count)
{
	return keep_more(choice, count, -INFINITY);
}

int hawser_choice_first(struct hawser_choice *choice, int count)
{
	for (int j = 0; j < choice->n; j++)
		choice->mode[j].kept = 0;
	return hawser_choice_add(choice, count);
}

int hawser_choice_kept(int *kept, const struct hawser_choice *choice)
{
	int count = 0;

	for (int j = 0; j < choice->n; j++)
		if (choice->mode[j].kept)
			kept[count++] = j;
	return count;
}

double hawser_choice_rest(const struct hawser_choice *choice)
{
	double sum = 0.0;

	for (int j = 0; j < choice->n; j++)
		if (!choice->mode[j].kept)
			sum += choice->mode[j].measure;
	return sum;
}

void hawser_choice_forget(struct hawser_choice *choice)
{
	choice->largest = choice->truncation = choice->energy = choice->followed = 0.0;
	for (int j = 0; j < choice->n; j++) {
		struct hawser_choice_mode *mode = &choice->mode[j];

		/* the reason for a kept mode stays until a motion gives another one: a mode that can become
		 * unstable is at rest in most motions */
		mode->measure = 0.0;
		if (!mode->kept)
			*mode = (struct hawser_choice_mode){.partner = -1};
	}
}

enum hawser_status hawser_choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                       int rows, double omega, int whole,
                                       struct hawser_report *report)
{
	return hawser__choice_weigh(choice, coordinate, rows, omega, whole, HAWSER__BY_PLANE,
	                            HAWSER__BY_PLANE, NULL, report);
}

enum hawser_status hawser__choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                        int rows, double omega, int whole, unsigned counted,
                                        unsigned peaks, const struct hawser__orbit_of *orbit,
                                        struct hawser_report *report)
{
	double *u = calloc((size_t)(rows > 0 ? rows : 1)*(size_t)choice->n, sizeof *u);
	enum hawser_status status;

	if (!u)
		return hawser__no_memory(report, "choose");
	if (rows < 8) {
		free(u);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "choose",
		                    "%d samples of a period: give 8 at least", rows);
	}
	for (int t = 0; t < rows; t++)
		for (int j = 0; j < choice->n; j++)
			if (choice->mode[j].kept)
				u[(size_t)t*choice->n + j] = *coordinate++;
	status = hawser__weigh(choice, u, rows, omega, 0.0, whole, counted, peaks, orbit, report);
	free(u);
	return status;
}

static enum hawser_status allocate(struct hawser_choice *choice, struct hawser_report *report)
{
	size_t n = (size_t)choice->n;

	choice->mode = calloc(n, sizeof *choice->mode);
	choice->order = calloc(n, sizeof *choice->order);
	choice->load = calloc(n, sizeof *choice->load);
	choice->twin = calloc(n, sizeof *choice->twin);
	return choice->mode && choice->order && choice->load && choice->twin
	       ? HAWSER_OK : hawser__no_memory(report, "choose");
}

/* What drives the modes of choice->all. */
static enum hawser_status excite(struct hawser_choice *choice, struct hawser_report *report)
{
	enum hawser_status status = hawser__drives(&choice->all, choice->load, report);

	return status ? status : driven(choice, report);
}

enum hawser_status hawser_choice_of(struct hawser_choice *choice, struct hawser_rom *all,
                                    const struct hawser_modes *modes, double from, double to,
                                    struct hawser_report *report)
{
	enum hawser_status status;

	*choice = (struct hawser_choice){.n = all->n, .modes = modes, .from = fmin(from, to),
		.to = fmax(from, to), .all = *all, .answered = 1};
	*all = (struct hawser_rom){.n = 0};
	status = allocate(choice, report);
	if (!status)
		status = excite(choice, report);
	if (status)
		hawser_choice_clear(choice);
	return status;
}

enum hawser_status hawser__choice_begin(struct hawser_choice *choice,
                                        const struct hawser_modes *modes,
                                        const struct hawser_scene *scene, double from, double to,
                                        double accuracy, int guesses, struct hawser_report *report)
{
	struct hawser_scene condensing = *scene; /* its `name` is owned by the caller */
	enum hawser_status status = check(modes, scene, from, to, accuracy, report);

	*choice = (struct hawser_choice){.n = modes->n, .modes = modes, .from = fmin(from, to),
		.to = fmax(from, to)};
	if (status)
		return status;
	condensing.model.condense = HAWSER_CONDENSE_STATIC;
	condensing.model.inertia = HAWSER_INERTIA_NONE; /* the coordinates of this model are modes only */
	status = allocate(choice, report);
	if (!status)
		status = hawser_rom_build(&choice->all, modes, &condensing, report);
	if (!status)
		status = excite(choice, report);
	if (!status && guesses)
		status = guess_all(choice, report);
	/* not before: in estimated motions, which are not orbits, the truncation error has no meaning */
	if (!status)
		status = hawser__choice_resolve(choice, scene, report);
	if (status)
		hawser_choice_clear(choice);
	return status;
}

enum hawser_status hawser_choose(struct hawser_choice *choice, const struct hawser_modes *modes,
                                 const struct hawser_scene *scene, double from, double to,
                                 double accuracy, struct hawser_report *report)
{
	enum hawser_status status;

	*choice = (struct hawser_choice){.n = 0};
	if (hawser__support_moves(scene))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "the choice of modes does not know the motion of supports: give their "
		                    "number (model.modes), and increase it until the result does not change");
	if (scene->damping.drag > 0.0)
		return hawser__drag_refuse(NULL, "the choice of modes (model.modes: auto)", report);
	status = hawser__choice_begin(choice, modes, scene, from, to, accuracy, 1, report);
	if (status)
		return status;
	for (int j = 0; j < choice->n; j++)
		choice->mode[j].kept = 0;
	if (!hawser_choice_raise(choice, accuracy))
		hawser_choice_add(choice, 1);
	return HAWSER_OK;
}

void hawser_choice_clear(struct hawser_choice *choice)
{
	if (!choice)
		return;
	hawser_rom_clear(&choice->all);
	hawser_rom_clear(&choice->exact);
	free(choice->mode);
	free(choice->order);
	free(choice->load);
	free(choice->twin);
	*choice = (struct hawser_choice){0};
}
