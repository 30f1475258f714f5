/* study/map/family.c - the models of a scene over one or two of its keys; see hawser/scene_family.h.
 *
 *    anchor    modes at values of the keys, in the order of the coordinates and with their signs
 *    overlap   integral of Phi_j . Phi_k over the length of the cable, of modes at two values, each as
 *              a function of the fraction of the length
 *
 * Modes are followed from one anchor to the next. A step is halved until each coordinate overlaps with
 * one mode by more than SURE, so that modes that cross keep their coordinates, while those that veer
 * exchange their shapes continuously. Anchors are kept, and the order of the modes at a value depends
 * on the nearest anchor only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/scene_family.h>

#include "core/grow.h"
#include "core/report.h"
#include "modes/grid.h"
#include "modes/label.h"
#include "response/family/smooth.h"
#include "rom/energy/kernel.h"

#define SURE 0.75  /* least overlap by which a mode is recognised: its square is above a half; chosen */
#define LEAST 1e-7 /* least step, relative to the range, that is halved; below it the larger overlap
                    * decides; chosen */
#define EXACT 1e-11 /* tolerance of modes, so that models are smooth functions of the parameter */
enum { PLACES = 96, MORE = 6 };

struct anchor {
	double p[2];
	struct hawser_modes modes;
};

struct scene_family {
	const struct hawser_scene *scene;
	const char *key[2]; /* the second one may be NULL */
	double extent[2];   /* of the ranges */
	struct hawser__keep keep;           /* of models between others, where there is one key */
	int n;
	struct anchor *anchor; /* [anchors] in no order */
	int anchors;
	double *samples; /* [n + modes][PLACES][3] shapes that are compared */
};

static enum hawser_status scene_at(struct hawser_scene *scene, const struct scene_family *family,
                                   const double p[2], struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*scene = *family->scene;
	scene->model.inertia = HAWSER_INERTIA_NONE;
	for (int k = 0; k < 2 && family->key[k] && !status; k++)
		status = hawser_scene_set(scene, family->key[k], p[k], report);
	return status;
}

/* The lowest modes at p. */
static enum hawser_status solve(struct hawser_modes *modes, const struct scene_family *family,
                                const double p[2], int n, struct hawser_report *report)
{
	struct hawser_modes_options options = {.n = n, .tolerance = EXACT};
	struct hawser_statics statics;
	struct hawser_scene scene;
	enum hawser_status status = scene_at(&scene, family, p, report);

	options.basis = scene.model.basis;
	if (!status)
		status = hawser_statics_scene(&statics, &scene, report);
	if (!status)
		status = hawser_modes_solve(modes, &statics, &options, report);
	return status;
}

/* out [modes][PLACES][3], each of length 1. Returns 0 if memory is short. */
static int sample(double *out, const struct hawser_modes *modes)
{
	const struct hawser_grid *grid = &modes->grid;
	int order = grid->order, row = (int)hawser__modes_row(modes), all = 3*PLACES;
	double *weight = malloc((size_t)order*sizeof *weight);

	for (int i = 0; weight && i < PLACES; i++) {
		int e = hawser__grid_weights(weight, grid, (i + 0.5)/PLACES*grid->edge[grid->elements]);

		for (int j = 0; j < modes->n; j++)
			cblas_dgemv(CblasRowMajor, CblasTrans, order, 3, 1.0, modes->shape + (size_t)j*row +
			            (size_t)3*e*order, 3, weight, 1, 0.0, out + (size_t)j*all + 3*i, 1);
	}
	for (int j = 0; weight && j < modes->n; j++)
		cblas_dscal(all, 1.0/cblas_dnrm2(all, out + (size_t)j*all, 1), out + (size_t)j*all, 1);
	free(weight);
	return weight != NULL;
}

/* Which of the modes is each mode of the anchor; negative overlaps change the sign. *least is the
 * smallest overlap. Returns 0 if memory is short. */
static int recognise(int *place, double *sign, double *least, const struct scene_family *family,
                      const struct hawser_modes *anchor, const struct hawser_modes *modes)
{
	unsigned char taken[4*HAWSER_ROM_MAX + MORE] = {0};
	int all = 3*PLACES;
	double *own = family->samples, *other = own + (size_t)all*anchor->n;

	if (!sample(own, anchor) || !sample(other, modes))
		return 0;
	*least = 1.0;
	for (int j = 0; j < anchor->n; j++) {
		double best = -1.0;

		for (int k = 0; k < modes->n; k++) {
			double found = taken[k] ? 0.0 : cblas_ddot(all, own + (size_t)all*j, 1,
			                                           other + (size_t)all*k, 1);

			if (!taken[k] && fabs(found) > best) {
				best = fabs(found);
				sign[j] = found < 0.0 ? -1.0 : 1.0;
				place[j] = k;
			}
		}
		taken[place[j]] = 1;
		*least = fmin(*least, best);
	}
	return 1;
}

static int ascending(const void *a, const void *b)
{
	return *(const int *)a - *(const int *)b;
}

/* Exchange modes i and j. */
static void exchange(struct hawser_modes *modes, int i, int j)
{
	size_t row = 3*(size_t)modes->grid.points, strokes = (size_t)modes->statics.attachments;
	struct hawser_mode mode = modes->mode[i];

	modes->mode[i] = modes->mode[j];
	modes->mode[j] = mode;
	for (size_t k = 0; k < row; k++) {
		double shape = modes->shape[i*row + k], slope = modes->slope[i*row + k];

		modes->shape[i*row + k] = modes->shape[j*row + k];
		modes->slope[i*row + k] = modes->slope[j*row + k];
		modes->shape[j*row + k] = shape;
		modes->slope[j*row + k] = slope;
	}
	for (size_t k = 0; modes->stroke && k < strokes; k++) {
		double stroke = modes->stroke[i*strokes + k];

		modes->stroke[i*strokes + k] = modes->stroke[j*strokes + k];
		modes->stroke[j*strokes + k] = stroke;
	}
}

static void reverse(struct hawser_modes *modes, int j)
{
	size_t row = 3*(size_t)modes->grid.points, strokes = (size_t)modes->statics.attachments;

	for (size_t k = 0; k < row; k++) {
		modes->shape[j*row + k] *= -1.0;
		modes->slope[j*row + k] *= -1.0;
	}
	for (size_t k = 0; modes->stroke && k < strokes; k++)
		modes->stroke[j*strokes + k] *= -1.0;
	for (int c = 0; c < 3; c++)
		modes->mode[j].participation[c] *= -1.0;
}

/* The modes place[n] of `all` in this order and with these signs. */
static enum hawser_status arrange(struct hawser_modes *modes, const struct hawser_modes *all,
                                  const int *place, const double *sign, int n,
                                  struct hawser_report *report)
{
	int kept[HAWSER_ROM_MAX];
	enum hawser_status status;

	memcpy(kept, place, (size_t)n*sizeof *kept);
	qsort(kept, (size_t)n, sizeof *kept, ascending);
	if ((status = hawser_modes_select(modes, all, kept, n, report)))
		return status;
	for (int j = 0; j < n; j++) {
		int i = j;

		while (kept[i] != place[j])
			i++;
		if (i != j) {
			exchange(modes, i, j);
			kept[i] = kept[j];
			kept[j] = place[j];
		}
		if (sign[j] < 0.0)
			reverse(modes, j);
	}
	return HAWSER_OK;
}

static enum hawser_status add_anchor(struct scene_family *family, const double p[2],
                                     const struct hawser_modes *modes, struct hawser_report *report)
{
	if (hawser__more(&family->anchor, family->anchors, sizeof *family->anchor))
		return hawser__no_memory(report, "frf");
	family->anchor[family->anchors++] = (struct anchor){{p[0], p[1]}, *modes};
	return HAWSER_OK;
}

/* Relative to the ranges. */
static double distance(const struct scene_family *family, const double a[2], const double b[2])
{
	double sum = 0.0;

	for (int k = 0; k < 2 && family->key[k]; k++)
		sum += fabs(a[k] - b[k])/family->extent[k];
	return sum;
}

static const struct anchor *nearest(const struct scene_family *family, const double p[2])
{
	const struct anchor *best = family->anchor;

	for (int i = 1; i < family->anchors; i++)
		if (distance(family, family->anchor[i].p, p) < distance(family, best->p, p))
			best = &family->anchor[i];
	return best;
}

/* The modes at p in the order of the coordinates, from the nearest anchor; *sure is 0 if they could not
 * be recognised. They are sought among a few modes beyond their number, then among twice as many. */
static enum hawser_status recognised(struct hawser_modes *modes, int *sure,
                                     const struct scene_family *family, const double p[2],
                                     struct hawser_report *report)
{
	const struct anchor *anchor = nearest(family, p);
	int place[HAWSER_ROM_MAX] = {0};
	double sign[HAWSER_ROM_MAX], least = 0.0;
	struct hawser_modes all = {.n = 0};
	enum hawser_status status = HAWSER_OK;

	for (int times = 1; !status && least < SURE && times <= 2; times++) {
		hawser_modes_clear(&all);
		status = solve(&all, family, p, times*family->n + MORE, report);
		if (!status && !recognise(place, sign, &least, family, &anchor->modes, &all))
			status = hawser__no_memory(report, "frf");
	}
	*sure = least >= SURE || distance(family, p, anchor->p) <= LEAST;
	if (!status)
		status = arrange(modes, &all, place, sign, family->n, report);
	hawser_modes_clear(&all);
	return status;
}

/* The modes at p, with anchors on the way from the nearest one. */
static enum hawser_status modes_at(struct hawser_modes *modes, struct scene_family *family,
                                   const double p[2], struct hawser_report *report)
{
	for (;;) {
		double at[2] = {p[0], p[1]};
		enum hawser_status status;
		int sure;

		while (!(status = recognised(modes, &sure, family, at, report)) && !sure) {
			const double *back = nearest(family, at)->p;

			hawser_modes_clear(modes);
			for (int k = 0; k < 2; k++)
				at[k] = 0.5*(at[k] + back[k]);
		}
		if (status || (at[0] == p[0] && at[1] == p[1]))
			return status;
		if ((status = add_anchor(family, at, modes, report))) {
			hawser_modes_clear(modes);
			return status;
		}
	}
}

static enum hawser_status make_model(void *context, struct hawser_rom *rom, const double p[2],
                                     struct hawser_report *report)
{
	struct scene_family *family = context;
	struct hawser_modes modes;
	struct hawser_scene scene;
	enum hawser_status status = scene_at(&scene, family, p, report);

	*rom = (struct hawser_rom){.n = 0};
	if (status || (status = modes_at(&modes, family, p, report)))
		return status;
	status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	return status;
}

static enum hawser_status model_of_two(void *context, const struct hawser_rom **rom,
                                       const double p[2], struct hawser_report *report)
{
	struct scene_family *family = context;

	return hawser__keep_model(&family->keep, rom, p, report);
}

static enum hawser_status model(void *context, const struct hawser_rom **rom, double p,
                                struct hawser_report *report)
{
	return model_of_two(context, rom, (double[2]){p, 0.0}, report);
}

static void end(void *context)
{
	struct scene_family *family = context;

	for (int i = 0; family && i < family->anchors; i++)
		hawser_modes_clear(&family->anchor[i].modes);
	if (family) {
		hawser__keep_clear(&family->keep);
		free(family->anchor);
		free(family->samples);
	}
	free(family);
}

void hawser_scene_family_close(struct hawser_rom_family *closed)
{
	end(closed->context);
	*closed = (struct hawser_rom_family){0.0, NULL, NULL};
}

/* The first anchor: the lowest modes. */
static enum hawser_status begin(struct scene_family *family, const double at[2],
                                struct hawser_report *report)
{
	struct hawser_modes all, modes;
	int place[HAWSER_ROM_MAX];
	double sign[HAWSER_ROM_MAX];
	enum hawser_status status = solve(&all, family, at, family->n + MORE, report);

	if (status)
		return status;
	for (int j = 0; j < family->n; j++) {
		place[j] = j;
		sign[j] = 1.0;
	}
	status = arrange(&modes, &all, place, sign, family->n, report);
	hawser_modes_clear(&all);
	if (!status && (status = add_anchor(family, at, &modes, report)))
		hawser_modes_clear(&modes);
	return status;
}

static enum hawser_status make(struct scene_family **made, const struct hawser_scene *scene,
                               const char *const key[2], const double extent[2], const double at[2],
                               struct hawser_report *report)
{
	struct scene_family *family;
	enum hawser_status status = HAWSER_OK;
	double unused;

	*made = NULL;
	for (int k = 0; k < 2 && key[k] && !status; k++)
		status = hawser_scene_get(scene, &unused, key[k], report);
	if (status)
		return status;
	if (scene->model.modes == HAWSER_MODES_AUTO || scene->model.energy == HAWSER_ENERGY_EXACT)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "%s as a parameter needs a model of a given number of modes with the "
		                    "energy to fourth order: set model.modes and model.energy", key[0]);
	if (!(family = calloc(1, sizeof *family)))
		return hawser__no_memory(report, "frf");
	*made = family;
	*family = (struct scene_family){.scene = scene, .key = {key[0], key[1]},
		.extent = {extent[0] > 0.0 ? extent[0] : 1.0, extent[1] > 0.0 ? extent[1] : 1.0},
		.keep = {.make = make_model, .context = family},
		.n = scene->model.modes};
	family->samples = calloc((size_t)(3*family->n + MORE)*3*PLACES, sizeof(double));
	return family->samples ? begin(family, at, report) : hawser__no_memory(report, "frf");
}

enum hawser_status hawser_scene_family_open(struct hawser_rom_family *opened,
                                            const struct hawser_scene *scene, const char *key,
                                            double from, double to, double at, double omega,
                                            struct hawser_report *report)
{
	struct scene_family *family;
	enum hawser_status status = make(&family, scene, (const char *[2]){key, NULL},
	                                 (double[2]){fabs(to - from), 1.0}, (double[2]){at, 0.0}, report);

	if (!status) {
		family->keep.from = from;
		family->keep.to = to;
	}
	*opened = (struct hawser_rom_family){omega, model, family};
	if (status)
		hawser_scene_family_close(opened);
	return status;
}

enum hawser_status hawser_scene_plane_open(struct hawser_rom_plane *opened,
                                           const struct hawser_scene *scene,
                                           const char *const key[2], const double from[2],
                                           const double to[2], const double at[2], double omega,
                                           struct hawser_report *report)
{
	struct scene_family *family;
	double extent[2] = {fabs(to[0] - from[0]), fabs(to[1] - from[1])};
	enum hawser_status status = make(&family, scene, key, extent, at, report);

	*opened = (struct hawser_rom_plane){omega, model_of_two, family, end};
	if (status)
		hawser_plane_close(opened);
	return status;
}
