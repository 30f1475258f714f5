/* bench/judge.c - do reduced models describe the cable? Random cables, against exact energy.
 *
 *   bench/judge [law|exact|backbone [COUNT [SEED [SHOW]]]]
 *
 * law: the four lowest coordinates are held at a quarter, a half and the whole of the larger one of
 * half the sag and a twentieth of the span, in both directions (hawser/law.h). For each kind of model
 * and number of modes: the number of laws; the share whose force is within 1 % of the exact one; the
 * median, the 90 % quantile and the largest relative error of the force; the largest factor of the
 * law (force over stiffness times coordinate, minus 1) from the exact one where that is more than
 * 0.001; the share without an equilibrium of the model, which the error does not contain; the largest
 * error of the exact law by its basis; the median over cables of the first coordinate's range relative
 * to that amplitude. Kinds:
 *
 *    raw       other modes at rest (model.condense: none)
 *    static    other modes follow statically
 *    stretched static; of the lowest modes above the fourth, those are not kept of whose energy a
 *              thousandth or more is axial strain
 *    swings    static; in the plane only the four lowest of the modes are kept
 *    exact     (the one kind of `exact`) the exact energy on the first basis that is tried by default
 *              where the range ends with the fourth mode (`kept`: its coordinates), whatever number of
 *              modes is asked for
 *
 * backbone: about each of the four lowest modes the peak of the response with 5, 9 and 16 modes against
 * that of full order with 14 functions, in amplitude and frequency; peaks on which 10 functions do not
 * agree within 3e-3 are left out, and counted.
 *
 * Cables: sag 1/1000 to 1/4 of the span, EA/H 100 to 1e5, up to 75 degrees, some with masses or with
 * springs. SHOW: laws that are off by more than this part of the force are listed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/clock.h"
#include "bench/estimates.h"
#include "rom/condense/known.h"
#include "rom/energy/law.h"

enum { HELD = 4, PLACES = 6, RAW = 4 };
static const int sizes[] = {3, 5, 9, 16, 24, 32, 40};
static const char *const kinds[] = {"raw", "static", "stretched", "swings", "exact"};
enum { SIZES = sizeof sizes/sizeof *sizes, EXACT = 4, KINDS };
static const double axial = 0.001; /* share of the energy of a mode that is not kept */

struct cable {
	struct hawser_scene scene;
	struct hawser_statics st;
	struct hawser_modes modes;
	char what[160];
};

static void attach(struct hawser_scene *scene, struct chance *chance, double H)
{
	double kind = chance_unit(chance);

	scene->attachments = kind < 0.4 ? 0 : chance_int(chance, 1, 2);
	for (int i = 0; i < scene->attachments; i++) {
		scene->attach[i].at = (i + chance_between(chance, 0.2, 0.8))/scene->attachments;
		if (kind < 0.75)
			scene->attach[i].mass = scene->cable.rho*scene->span.d*chance_log(chance, 0.01, 0.5);
		else
			scene->attach[i].spring[1] = scene->attach[i].spring[2] = H/scene->span.d*
			                                                          chance_log(chance, 0.1, 10.0);
	}
}

static int draw(struct cable *cable, struct chance *chance)
{
	struct hawser_scene *scene = &cable->scene;
	struct hawser_modes_options options = {.n = sizes[SIZES - 1]};
	double sag = chance_log(chance, 1e-3, 0.25), H;
	int failed;

	*cable = (struct cable){.scene = {.g = 9.81}};
	scene->span.d = chance_log(chance, 10.0, 500.0);
	scene->span.h = chance_unit(chance) < 0.3 ? 0.0
	                : scene->span.d*tan(M_PI/180.0*chance_between(chance, -75.0, 75.0));
	scene->cable.rho = chance_log(chance, 0.2, 50.0);
	H = scene->cable.rho*scene->g*hypot(scene->span.d, scene->span.h)/(8.0*sag);
	scene->cable.EA = H*chance_log(chance, 100.0, 1e5);
	scene->tension.given = HAWSER_GIVEN_H;
	scene->tension.value = H;
	scene->model.condense = HAWSER_CONDENSE_STATIC;
	attach(scene, chance, H);
	failed = hawser_statics_scene(&cable->st, scene, NULL) ||
	         hawser_modes_solve(&cable->modes, &cable->st, &options, NULL);
	snprintf(cable->what, sizeof cable->what, "d %.4g m, h %.4g m, sag/d %.3g, EA/H %.3g, %d %s",
	         scene->span.d, scene->span.h, cable->st.sag/scene->span.d, scene->cable.EA/H,
	         scene->attachments,
	         scene->attachments && scene->attach[0].mass > 0.0 ? "masses" : "springs");
	return failed;
}

static void clear(struct cable *cable)
{
	hawser_modes_clear(&cable->modes);
}

/* Part of the energy of mode j by strain along the cable. */
static double axial_share(const struct hawser_modes *modes, int j)
{
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0;

	for (int p = 0; p < grid->points; p++)
		sum += grid->weight[p]*pow(modes->slope[((size_t)j*(size_t)grid->points + (size_t)p)*3], 2);
	return sum/modes->statics.epsilon/pow(modes->mode[j].omega, 2);
}

/* The model of a kind of the n lowest modes. */
static int build(struct hawser_rom *rom, const struct cable *cable, int kind, int n)
{
	struct hawser_scene scene = cable->scene;
	struct hawser_modes subset = {.n = 0};
	int kept[64], count = 0, in_plane = 0, failed;

	for (int j = 0; j < n; j++) {
		int out = cable->modes.mode[j].plane == HAWSER_OUT_OF_PLANE;

		in_plane += !out;
		if (kind < 2 || j < HELD || (kind == 2 ? axial_share(&cable->modes, j) < axial
		                                       : out || in_plane <= HELD))
			kept[count++] = j;
	}
	scene.model.condense = kind == 0 ? HAWSER_CONDENSE_NONE : HAWSER_CONDENSE_STATIC;
	failed = hawser_modes_select(&subset, &cable->modes, kept, count, NULL) ||
	         hawser_rom_build(rom, &subset, &scene, NULL);
	hawser_modes_clear(&subset);
	return failed;
}

/* --- static laws --- */

struct cell {
	struct ratios error, range;
	int laws, within, lost;
	double factor, exact; /* largest factor of the law; largest error of the exact one */
	double kept;          /* sum of the numbers of coordinates */
};

static void add(struct ratios *to, double value)
{
	if (to->count == to->capacity) {
		to->capacity = 2*to->capacity + 64;
		to->ratio = realloc(to->ratio, (size_t)to->capacity*sizeof *to->ratio);
		if (!to->ratio)
			exit(4);
	}
	to->ratio[to->count++] = value;
}

static void note(struct cell *cell, const struct hawser_law_point *point, const struct cable *cable,
                 const char *which, double show)
{
	double error = fabs(point->model - point->exact)/fabs(1.0 + point->exact);

	if (point->end == HAWSER_LAW_SLACK || point->end == HAWSER_LAW_NO_EXACT)
		return;
	cell->laws++;
	cell->exact = fmax(cell->exact, point->error/fabs(1.0 + point->exact));
	if (point->end == HAWSER_LAW_NO_MODEL) {
		cell->lost++;
		return;
	}
	cell->within += error <= 0.01;
	add(&cell->error, error);
	if (fabs(point->exact) > 1e-3)
		cell->factor = fmax(cell->factor, fabs(point->model/point->exact));
	if (show > 0.0 && error > show)
		printf("    %s at %.3g m: %.4g, exactly %.4g; %s\n", which, point->amplitude, point->model,
		       point->exact, cable->what);
}

/* In place of the law of the model: that of `full`. */
static void replace(struct hawser_law_point *point, int count, const struct hawser_rom *rom,
                    const struct hawser_rom *full, int j)
{
	int twin = hawser__twin(rom, j, full), held = abs(twin) - 1;
	struct hawser__relax relax;

	if (hawser__relax_new(&relax, full))
		exit(4);
	for (int i = 0; i < full->n; i++)
		if (i != held)
			relax.freed[relax.frees++] = i;
	for (int i = 0; i < count; i++) {
		double u = twin > 0 ? point[i].u : -point[i].u, tension[2];

		memset(relax.y, 0, (size_t)full->n*sizeof *relax.y);
		if (point[i].end == HAWSER_LAW_NO_MODEL)
			point[i].end = HAWSER_LAW_FOUND;
		if (!point[i].end &&
		    (!twin || !hawser__law_force(&point[i].model, tension, &relax, held, u)))
			point[i].end = HAWSER_LAW_NO_MODEL;
	}
	hawser__relax_clear(&relax);
}

/* The first basis of the exact energy for the lowest modes. */
static int first_basis(struct hawser_rom *full, const struct cable *cable)
{
	const struct hawser_accuracy_bases of = {.modes = &cable->modes, .scene = &cable->scene,
		.to = cable->modes.mode[HELD - 1].omega, .accuracy = 0.01, .most = 24};
	int functions = 0;

	return hawser_accuracy_basis(full, &functions, &of, 0, NULL) || full->n == 0;
}

static void hold(struct cell *cell, const struct cable *cable, int kind, int n, double show)
{
	double most = fmax(0.5*cable->st.sag, 0.05*cable->st.span.d), reached[160] = {0.0};
	static const double part[PLACES] = {0.25, 0.5, 1.0, -0.25, -0.5, -1.0};
	struct hawser_rom rom = {.n = 0}, full = {.n = 0};
	char which[96];

	if (build(&rom, cable, kind == EXACT ? 1 : kind, n) ||
	    (kind == EXACT && first_basis(&full, cable))) {
		hawser_rom_clear(&rom);
		return;
	}
	cell->kept += kind == EXACT ? full.n : rom.n;
	for (int j = 0; j < HELD && j < rom.n && rom.range[j].largest > 0.0; j++) {
		struct hawser_law_point point[PLACES];

		for (int i = 0; i < PLACES; i++)
			point[i] = (struct hawser_law_point){.amplitude = part[i]*most};
		snprintf(which, sizeof which, "%s %d: %s", kinds[kind], n, rom.label[j]);
		if (hawser_law_trace(point, PLACES, &rom, &cable->st, j, NULL))
			continue;
		if (kind == EXACT)
			replace(point, PLACES, &rom, &full, j);
		for (int i = 0; i < PLACES; i++)
			note(cell, &point[i], cable, which, show);
	}
	hawser_rom_clear(&full);
	if (kind == EXACT) {
		hawser_rom_clear(&rom);
		return;
	}
	reached[0] = most/rom.range[0].largest;
	if (!hawser_law_range(&rom, &cable->st, reached, NULL) && rom.range[0].end)
		add(&cell->range, rom.range[0].amplitude/most);
	hawser_rom_clear(&rom);
}

static int models_of(int kind)
{
	return kind == EXACT ? 1 : kind == 0 ? RAW : SIZES;
}

static void judge_laws(int count, uint64_t seed, double show, int first)
{
	static struct cell cell[KINDS][SIZES];
	int drawn = 0;

	for (int i = 0; i < count; i++) {
		struct chance chance = chance_at(seed, 48, (uint64_t)i);
		struct cable cable;

		if (!draw(&cable, &chance)) {
			drawn++;
			for (int k = first; k < KINDS; k++)
				for (int m = 0; m < models_of(k); m++)
					hold(&cell[k][m], &cable, k, k == EXACT ? HELD : sizes[m], show);
		}
		clear(&cable);
	}
	printf("static laws of %d cables, seed %llu\n%-9s %5s %6s %6s %8s %8s %8s %8s %8s %6s %8s %6s\n",
	       drawn, (unsigned long long)seed, "kind", "modes", "kept", "laws", "within", "50 %", "90 %",
	       "largest", "factor", "lost", "exact", "range");
	for (int k = first; k < KINDS; k++)
		for (int m = 0; m < models_of(k); m++) {
			struct cell *c = &cell[k][m];
			double laws = fmax(c->laws, 1.0);

			printf("%-9s %5d %6.1f %6d %7.1f%% %8.1e %8.1e %8.1e %8.2g %5.1f%% %8.1e %6.2f\n", kinds[k],
			       sizes[m], c->kept/fmax(drawn, 1.0), c->laws, 100.0*c->within/laws,
			       tally_quantile(&c->error, 0.5), tally_quantile(&c->error, 0.9),
			       tally_quantile(&c->error, 1.0), c->factor, 100.0*c->lost/laws, c->exact,
			       tally_quantile(&c->range, 0.5));
			free(c->error.ratio);
			free(c->range.ratio);
		}
}

/* --- backbones --- */

static const int few[] = {5, 9, 16};
enum { FEW = sizeof few/sizeof *few, FUNCTIONS = 10, MORE = 14 };
/* difference of peaks of full order with FUNCTIONS and with MORE functions; chosen */
static const double settled = 3e-3;

struct peak {
	double omega, size;
};

/* The largest peak of a component at mid-span. */
static int peak_of(struct peak *peak, int *axis, const struct hawser_rom *rom, double from, double to)
{
	struct hawser_frf_options options = {.from = from, .to = to, .samples = HAWSER_NONE,
		.max_points = 400, .end_at_slack = 1, .step_max = 0.03};
	struct hawser_landmark *mark = NULL;
	struct hawser_frf frf = {.n = 0};
	int count = 0, failed, only = *axis;

	*peak = (struct peak){NAN, 0.0};
	failed = hawser_frf_trace(&frf, rom, &options, NULL) || frf.end != HAWSER_END_RANGE ||
	         hawser_landmarks(&mark, &count, &frf, NULL, NULL);
	for (int i = 0; !failed && i < count; i++)
		if (mark[i].kind == HAWSER_LANDMARK_PEAK && mark[i].probe == 1 && mark[i].size > peak->size &&
		    (only < 0 || mark[i].axis == only)) {
			*peak = (struct peak){mark[i].omega, mark[i].size};
			*axis = mark[i].axis;
		}
	free(mark);
	hawser_frf_clear(&frf);
	return failed || !(peak->size > 0.0);
}

/* A load with which mode j moves by about `part` of the larger one of half the sag and a twentieth of
 * the span; damping so that the peak is inside the range. */
static void load(struct cable *cable, int j, double part)
{
	struct hawser_scene *scene = &cable->scene;
	const struct hawser_statics *st = &cable->st;
	double w = cable->modes.mode[j].omega, most = fmax(0.5*st->sag, 0.05*st->span.d);
	double size = part*0.01*w*w*most/st->span.d*st->H/st->span.d;

	scene->damping.kind = HAWSER_DAMPING_RATIO;
	scene->damping.ratio = 0.005;
	scene->load.present = 1;
	scene->load.frame = HAWSER_FRAME_GLOBAL;
	scene->load.extent[1] = 0.7;
	for (int i = 0; i < 3; i++)
		scene->load.per_length[i] = i == 0 ? 0.0 : size;
	scene->model.inertia = HAWSER_INERTIA_AUTO;
}

/* The peak at full order; returns 1 if it is not known. */
static int full_peak(struct peak *truth, int *axis, const struct cable *cable, double from, double to)
{
	struct peak peak[2];
	int failed = 0;

	*axis = -1;
	for (int k = 0; !failed && k < 2; k++) {
		struct hawser_rom full = {.n = 0};

		failed = hawser_rom_build_full(&full, &cable->st, &cable->scene, k ? MORE : FUNCTIONS,
		                               NULL) || peak_of(&peak[k], axis, &full, from, to);
		hawser_rom_clear(&full);
	}
	if (!failed)
		*truth = peak[1];
	return failed || !(fabs(peak[0].size/peak[1].size - 1.0) < settled);
}

static void compare(struct ratios size[FEW], struct ratios omega[FEW], int *unknown,
                    struct cable *cable, int j, double show)
{
	double w = cable->modes.mode[j].omega, from = 0.97*w, to = 1.04*w;
	struct peak truth, found;
	int axis;

	if (full_peak(&truth, &axis, cable, from, to)) {
		(*unknown)++;
	} else {
		for (int k = 0; k < FEW; k++) {
			struct hawser_rom rom = {.n = 0};

			if (!build(&rom, cable, 1, few[k]) && !peak_of(&found, &axis, &rom, from, to)) {
				double off = fabs(found.size/truth.size - 1.0);
				double shift = fabs(found.omega/truth.omega - 1.0);

				add(&size[k], off);
				add(&omega[k], shift);
				if (show > 0.0 && off > show)
					printf("    %d modes, mode %d: %.3g m, %.2g in amplitude, %.2g in frequency; %s\n",
					       few[k], j + 1, truth.size*cable->st.span.d, off, shift, cable->what);
			}
			hawser_rom_clear(&rom);
		}
	}
}

static void judge_backbones(int count, uint64_t seed, double show)
{
	static struct ratios size[FEW], omega[FEW];
	int unknown = 0;

	for (int i = 0; i < count; i++) {
		struct chance chance = chance_at(seed, 49, (uint64_t)i);
		struct cable cable;
		double part = 0.0;

		if (!draw(&cable, &chance))
			for (int j = 0; j < HELD; j++) {
				part = chance_log(&chance, 0.02, 0.5);
				load(&cable, j, part);
				compare(size, omega, &unknown, &cable, j, show);
			}
		clear(&cable);
	}
	printf("peaks of the first %d modes, %d cables, seed %llu; %d not known\n"
	       "%5s %6s | %8s %8s %8s | %8s %8s %8s\n", HELD, count, (unsigned long long)seed, unknown,
	       "modes", "peaks", "size 50", "90 %", "largest", "Omega 50", "90 %", "largest");
	for (int k = 0; k < FEW; k++) {
		printf("%5d %6d | %8.1e %8.1e %8.1e | %8.1e %8.1e %8.1e\n", few[k], size[k].count,
		       tally_quantile(&size[k], 0.5), tally_quantile(&size[k], 0.9),
		       tally_quantile(&size[k], 1.0), tally_quantile(&omega[k], 0.5),
		       tally_quantile(&omega[k], 0.9), tally_quantile(&omega[k], 1.0));
		free(size[k].ratio);
		free(omega[k].ratio);
	}
}

int main(int argc, char **argv)
{
	const char *which = argc > 1 ? argv[1] : "law";
	int count = argc > 2 ? atoi(argv[2]) : 40;
	uint64_t seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
	double show = argc > 4 ? atof(argv[4]) : 0.0, start = clock_secs();

	setvbuf(stdout, NULL, _IOLBF, 0); /* full order takes minutes */
	if (strcmp(which, "law") == 0 || strcmp(which, "exact") == 0)
		judge_laws(count, seed, show, which[0] == 'e' ? EXACT : 0);
	else if (strcmp(which, "backbone") == 0)
		judge_backbones(count, seed, show);
	else
		fprintf(stderr, "judge: law, exact or backbone\n");
	printf("%.0f s\n", clock_secs() - start);
	return 0;
}
