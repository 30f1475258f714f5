/* cli/curves/frf_draw.c - the curves in the picture of a frequency response. With probes: z and y at
 * quarter and mid-span, one panel each, without panels in which nothing moves, and the largest stroke
 * of an absorber in one of its own. Without probes: the first coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_cover.h"
#include "cli/curves/frf_over.h"
#include "cli/curves/frf_tori.h"
#include "cli/frame/view.h"
#include "core/report.h"

enum { most_panels = 3, most_curves = 6, label_size = 192 };

/* A panel whose amplitudes are below this fraction of the largest amplitude shows round-off. */
static const double visible = 1e-9;
/* If the ratio of large to small amplitudes exceeds this, a linear axis hides the small ones. */
static const double log_ratio = 100.0;

struct picture {
	struct hawser__response response;
	struct hawser__axis x, y;
	double per_omega, per_length; /* shown units per unit of the model */
	struct hawser__response_curve curve[most_curves];
	struct hawser__response_sweep sweep[2];
	struct hawser__response_overlay overlay[CLI_OVERLAYS];
	const char *panel_label[most_panels];
	char label[most_curves][label_size], panel[most_panels][label_size];
	int source[most_curves]; /* index into a row of probes (3*p + c), or of coordinates */
	double *store;           /* all arrays with the length of the curve */
	int *unstable;
	int probed; /* 1: the curves are of probes */
	struct hawser__response_event *event;
	struct hawser__response_peak *peak; /* with room for the curves of all branches */
	double *natural, *gap;
	struct hawser__response_torus *torus; /* [response.tori] */
};

/* Names come from files: only letters, digits and blanks are written to the script. */
static void plain(char *label, const char *name)
{
	int i;

	/* cppcheck-suppress arrayIndexOutOfBoundsCond ; a name ends with a zero */
	for (i = 0; i < label_size - 1 && name[i]; i++)
		label[i] = isalnum((unsigned char)name[i]) ? name[i] : '-';
	label[i] = '\0';
}

static void name_probe(char *label, const char *name)
{
	plain(label, name);
	if (strcmp(name, "mid") == 0 || strcmp(name, "quarter") == 0 ||
	    strcmp(name, "three_quarter") == 0)
		snprintf(label + strlen(label), label_size - strlen(label), "-span");
}

void cli_probe_label(char *label, size_t size, char component, const char *probe, const char *unit)
{
	char name[label_size + 8];

	name_probe(name, probe);
	snprintf(label, size, "Amplitude of {/:Italic %c}, %.20s%s", component, name, unit);
}

static int probe_named(const struct hawser_rom_shapes *shapes, const char *name, int otherwise)
{
	int p;

	for (p = 0; p < shapes->points; p++)
		if (strcmp(shapes->name[p], name) == 0)
			return p;
	return otherwise < shapes->points ? otherwise : shapes->points - 1;
}

static void add_curve(struct picture *picture, const char *name, int panel, int source)
{
	struct hawser__response *response = &picture->response;
	int k = response->curves++;

	name_probe(picture->label[k], name);
	picture->curve[k].label = picture->label[k];
	picture->curve[k].panel = panel;
	picture->source[k] = source;
}

static double largest(const double *rows, int count, int stride, int source)
{
	double most = 0.0;
	int i;

	for (i = 0; i < count; i++)
		most = fmax(most, rows[(size_t)i*(size_t)stride + (size_t)source]);
	return most;
}

static void name_panel(struct picture *picture, int panel, const char *what)
{
	const char *unit = picture->y.unit;

	snprintf(picture->panel[panel], label_size, "Amplitude of %s%s%s%s", what,
	         *unit ? " (" : "", unit, *unit ? ")" : "");
}

/* The absorber with the largest stroke in a panel of its own, by the component that is largest. */
static void choose_stroke(struct picture *picture, const struct cli_frf_result *result)
{
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	const struct hawser_frf *frf = result->frf;
	int panel = picture->response.panels, stride = 3*frf->probes, source = -1;
	double most = 0.0;
	char name[label_size], what[64];

	for (int k = 0; k < stride; k++)
		if (strncmp(shapes->name[k/3], "stroke_", 7) == 0 &&
		    largest(frf->probe, frf->points, stride, k) > most) {
			most = largest(frf->probe, frf->points, stride, k);
			source = k;
		}
	if (source < 0)
		return;
	add_curve(picture, shapes->name[source/3], panel, source);
	plain(name, shapes->name[source/3]);
	snprintf(what, sizeof what, "{/:Italic %c}, %.30s", "xyz"[source % 3], name);
	name_panel(picture, panel, what);
	picture->response.panels++;
}

static const char *const axis_name[] = {"{/:Italic x}", "{/:Italic y}", "{/:Italic z}"};

static void choose_probes(struct picture *picture, const struct cli_frf_result *result)
{
	const struct hawser_rom_shapes *shapes = &result->model->rom.shapes;
	const struct hawser_frf *frf = result->frf;
	int point[2] = {probe_named(shapes, "quarter", 0), probe_named(shapes, "mid", 1)};
	int probes = point[0] == point[1] ? 1 : 2, stride = 3*frf->probes, c, p;
	double most[3] = {0.0, 0.0, 0.0};

	for (c = 1; c < 3; c++)
		for (p = 0; p < probes; p++)
			most[c] = fmax(most[c], largest(frf->probe, frf->points, stride, 3*point[p] + c));
	for (c = 2; c > 0; c--) {
		int panel = picture->response.panels;

		if (most[c] <= visible*most[3 - c])
			continue;
		name_panel(picture, panel, axis_name[c]);
		for (p = 0; p < probes; p++)
			add_curve(picture, shapes->name[point[p]], panel, 3*point[p] + c);
		picture->response.panels++;
	}
	choose_stroke(picture, result);
}

static void choose_coordinates(struct picture *picture, const struct cli_frf_result *result)
{
	int n = result->model->rom.n, k;
	char name[32];

	for (k = 0; k < n && k < most_panels; k++) {
		snprintf(name, sizeof name, "{/:Italic u}_{%d}", k + 1);
		name_panel(picture, k, name);
		add_curve(picture, "", k, k);
	}
	picture->response.panels = k;
}

static int compare(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* By the 5th and 95th percentiles of the drawn values. `work` is overwritten. */
static int wants_log(const char *scale, double *work, size_t count)
{
	size_t zeros = 0;

	if (strcmp(scale, "auto") != 0)
		return strcmp(scale, "log") == 0;
	if (hawser__picture_logarithmic('y', NULL)) /* the user's range has 0 or less */
		return 0;
	qsort(work, count, sizeof *work, compare);
	while (zeros < count && !(work[zeros] > 0.0))
		zeros++;
	count -= zeros;
	work += zeros;
	return count > 0 && work[count - 1 - count/20] > log_ratio*work[count/20];
}

static void copy_curves(struct picture *picture, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	const double *rows = frf->probes > 0 ? frf->probe : frf->coordinate;
	int stride = frf->probes > 0 ? 3*frf->probes : frf->n, k, i;
	double length = picture->per_length, *out = picture->store;

	for (i = 0; i < frf->points; i++) {
		out[i] = result->over ? frf->point[i].parameter/picture->x.per
		                      : frf->point[i].omega*picture->per_omega;
		picture->unstable[i] = frf->point[i].unstable;
	}
	picture->response.omega = out;
	for (k = 0; k < picture->response.curves; k++) {
		out += frf->points;
		picture->curve[k].amplitude = out;
		for (i = 0; i < frf->points; i++)
			out[i] = length*rows[(size_t)i*(size_t)stride + (size_t)picture->source[k]];
	}
}

static void copy_events(struct picture *picture, const struct cli_frf_result *result)
{
	const struct hawser_frf *frf = result->frf;
	int k;

	for (k = 0; k < frf->events; k++) {
		const struct hawser_frf_event *event = &frf->event[k];
		int next = event->after + 1 < frf->points ? event->after + 1 : event->after;
		double whole = frf->point[next].arc - frf->point[event->after].arc;
		double part = event->arc - frf->point[event->after].arc;

		picture->event[k].kind = event->kind;
		picture->event[k].omega = result->over ? event->parameter/picture->x.per
		                                       : event->omega*picture->per_omega;
		picture->event[k].after = event->after;
		picture->event[k].fraction = whole > 0.0 ? fmin(fmax(part/whole, 0.0), 1.0) : 0.0;
	}
	for (k = 0; k < result->model->naturals; k++)
		picture->natural[k] = result->model->natural[k]*picture->per_omega;
	for (k = 0; k < 2*result->gaps; k++)
		picture->gap[k] = result->gap[k]*picture->per_omega;
}

/* The located peaks of the curves shown. */
static void copy_peaks(struct picture *picture, const struct cli_frf_result *result)
{
	struct hawser__response *response = &picture->response;
	double length = picture->per_length;

	for (int i = 0; i < result->peaks; i++) {
		const struct hawser_landmark *peak = &result->peak[i];
		int source = peak->probe < 0 ? peak->axis : 3*peak->probe + peak->axis;

		for (int k = 0; k < response->curves && peak->kind == HAWSER_LANDMARK_PEAK; k++)
			if (picture->source[k] == source && (peak->probe >= 0) == picture->probed)
				picture->peak[response->peaks++] = (struct hawser__response_peak){
					k, peak->omega*picture->per_omega, length*peak->size};
	}
	response->peak = picture->peak;
}

/* Needs room for (curves + 1) rows of each sweep after the curves in `store`. */
static void copy_sweeps(struct picture *picture, const struct cli_frf_result *result, double *out)
{
	double length = picture->per_length;
	int s, k, i;

	for (s = 0; s < result->sweeps; s++) {
		const struct hawser_sweep *run = &result->sweep[s].run;
		const double *rows = run->probes > 0 ? run->probe : run->coordinate;
		int stride = run->probes > 0 ? 3*run->probes : run->n;

		picture->sweep[s].label = result->sweep[s].direction > 0 ? "up-sweep" : "down-sweep";
		picture->sweep[s].points = run->points;
		picture->sweep[s].omega = out;
		for (i = 0; i < run->points; i++)
			*out++ = run->omega[i]*picture->per_omega;
		picture->sweep[s].amplitude = out;
		for (k = 0; k < picture->response.curves; k++)
			for (i = 0; i < run->points; i++)
				*out++ = length*rows[(size_t)i*(size_t)stride + (size_t)picture->source[k]];
	}
}

/* The same of the overlays. */
static void copy_overlays(struct picture *picture, const struct cli_frf_result *result, double *out)
{
	double length = picture->per_length;

	for (int s = 0; s < result->overlays; s++) {
		const struct cli_overlay *from = &result->overlay[s];
		int probed = result->frf->probes > 0 && picture->probed;
		const double *rows = probed ? from->probe : from->coordinate;
		int stride = probed ? 3*result->frf->probes : result->frf->n;

		picture->overlay[s] = (struct hawser__response_overlay){from->label, from->points, out,
		                                                        out + from->points,
		                                                        from->beside};
		for (int i = 0; i < from->points; i++)
			*out++ = from->omega[i]*picture->per_omega;
		for (int k = 0; k < picture->response.curves; k++)
			for (int i = 0; i < from->points; i++)
				*out++ = length*rows[(size_t)i*(size_t)stride + (size_t)picture->source[k]];
	}
}

static int allocate(struct picture *picture, const struct cli_frf_result *result)
{
	size_t points = (size_t)result->frf->points, rows = (size_t)picture->response.curves + 1;
	size_t total = points;
	int s;

	for (s = 0; s < result->sweeps; s++)
		total += (size_t)result->sweep[s].run.points;
	for (s = 0; s < result->overlays; s++)
		total += (size_t)result->overlay[s].points;
	picture->store = calloc(rows*total + 1, sizeof *picture->store);
	picture->unstable = calloc(points + 1, sizeof *picture->unstable);
	picture->event = calloc((size_t)result->frf->events + 1, sizeof *picture->event);
	picture->peak = calloc((size_t)(result->peaks + 1)*most_curves, sizeof *picture->peak);
	picture->natural = calloc((size_t)result->model->naturals + 1, sizeof *picture->natural);
	picture->gap = calloc(2*(size_t)result->gaps + 1, sizeof *picture->gap);
	return picture->store && picture->unstable && picture->event && picture->peak &&
	       picture->natural && picture->gap;
}

static enum hawser_status fill(struct picture *picture, const struct cli_frf_result *result)
{
	struct hawser__response *response = &picture->response;
	size_t drawn = (size_t)response->curves*(size_t)result->frf->points;
	double *work = malloc((drawn + 1)*sizeof *work);
	size_t sweep_points = 0;

	if (!work)
		return HAWSER_ERR_MEMORY;
	copy_curves(picture, result);
	copy_events(picture, result);
	copy_peaks(picture, result);
	copy_sweeps(picture, result, picture->store + drawn + result->frf->points);
	for (int s = 0; s < result->sweeps; s++)
		sweep_points += (size_t)result->sweep[s].run.points;
	copy_overlays(picture, result, picture->store + drawn + result->frf->points
	                               + sweep_points*((size_t)response->curves + 1));
	memcpy(work, picture->store + result->frf->points, drawn*sizeof *work);
	response->logarithmic = wants_log(result->scale, work, drawn);
	free(work);
	response->points = result->frf->points;
	response->events = result->frf->events;
	response->naturals = result->over ? 0 : result->model->naturals;
	response->sweeps = result->sweeps;
	response->x_title = picture->x.title;
	response->unstable = picture->unstable;
	response->curve = picture->curve;
	response->event = picture->event;
	response->natural = picture->natural;
	response->gap = picture->gap;
	response->gaps = result->gaps;
	response->sweep = picture->sweep;
	response->overlays = result->overlays;
	response->overlay = picture->overlay;
	response->panel_label = picture->panel_label;
	response->from = result->over ? result->over->from/picture->x.per
	                              : result->from*picture->per_omega;
	response->to = result->over ? result->over->to/picture->x.per : result->to*picture->per_omega;
	return HAWSER_OK;
}

/* branch [points]: see struct hawser__response. */
static enum hawser_status draw(const char *path, const struct cli_frf_result *result,
                               const int *branch, struct hawser_report *report)
{
	struct picture picture = {.store = NULL, .response = {.branch = branch}};
	enum hawser_status status;
	int k;

	picture.x = cli_frf_axis(result->model);
	picture.y = cli_model_axis(result->model, "", "m");
	picture.per_omega = cli_per_omega(result->model)/picture.x.per;
	if (result->over)
		picture.x = cli_axis(result->over->axis.key, result->over->axis.unit,
		                     result->over->axis.to);
	picture.per_length = cli_per_length(result->model)/picture.y.per;
	for (k = 0; k < most_panels; k++)
		picture.panel_label[k] = picture.panel[k];
	if (result->frf->probes > 0)
		choose_probes(&picture, result);
	picture.probed = picture.response.panels > 0;
	if (picture.response.panels == 0)
		choose_coordinates(&picture, result);
	picture.response.tori = result->curves;
	if (!allocate(&picture, result) || fill(&picture, result) ||
	    cli_tori_draw(&picture.torus, result, picture.source, picture.response.curves, picture.probed,
	                  picture.per_omega, picture.per_length))
		status = hawser__no_memory(report, "picture");
	else {
		picture.response.torus = picture.torus;
		status = hawser__plot_frf(path, &picture.response, report);
	}
	cli_tori_undraw(picture.torus, result->curves);
	free(picture.store);
	free(picture.unstable);
	free(picture.event);
	free(picture.peak);
	free(picture.natural);
	free(picture.gap);
	return status;
}

enum hawser_status cli_frf_draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct cli_frf_result *result = context;
	struct cli_frf_result all;
	struct cli_joined joined;
	enum hawser_status status;

	if (result->others == 0)
		return draw(path, result, NULL, report);
	all = *result;
	status = cli_frf_join(&joined, result) ? hawser__no_memory(report, "picture") : HAWSER_OK;
	all.frf = &joined.frf;
	all.peak = joined.peak;
	all.peaks = joined.peaks;
	if (!status)
		status = draw(path, &all, joined.branch, report);
	cli_joined_clear(&joined);
	return status;
}
