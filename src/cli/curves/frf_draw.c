/* cli/curves/frf_draw.c - the curves in the picture of a frequency response. With probes: z and y at
 * mid-span and where else it moves most, one panel each, without panels in which nothing moves, and the
 * largest stroke of an absorber in one of its own. Without probes: the first coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_cover.h"
#include "cli/curves/frf_over.h"
#include "cli/curves/frf_picture.h"
#include "cli/frame/view.h"
#include "cli/model/made.h"
#include "core/append.h"
#include "core/order.h"
#include "core/report.h"

enum { label_size = CLI_FRF_LABEL };

/* A panel whose amplitudes are below this fraction of the largest amplitude shows round-off. */
static const double visible = 1e-9;
/* If the ratio of large to small amplitudes exceeds this, a linear axis hides the small ones. */
static const double log_ratio = 100.0;
/* Least motion of a joint that is drawn, over that of a place on a cable that moves more. Chosen. */
static const double enough = 0.5;
/* Amplitudes of mirrored probes differ by less than this, relative: the orbits' errors. */
static const double same = 1e-6;

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

static void add_curve(struct cli_frf_picture *of, const char *name, int panel, int source)
{
	struct cli_frf_curve *curve = &of->curve[of->curves++];

	name_probe(curve->label, name);
	curve->panel = panel;
	curve->source = source;
}

static double largest(const double *rows, int count, int stride, int source)
{
	double most = 0.0;
	int i;

	for (i = 0; i < count; i++)
		most = fmax(most, rows[(size_t)i*(size_t)stride + (size_t)source]);
	return most;
}

static void name_panel(struct cli_frf_picture *of, int panel, const char *what)
{
	const char *unit = of->y.unit;

	snprintf(of->panel[panel], label_size, "Amplitude of %s%s%s%s", what,
	         *unit ? " (" : "", unit, *unit ? ")" : "");
}

static int is_stroke(const char *name)
{
	return strncmp(name, "stroke_", 7) == 0;
}

/* The absorber with the largest stroke in a panel of its own, by the component that is largest. */
static void choose_stroke(struct cli_frf_picture *of)
{
	const struct hawser_rom_shapes *shapes = &of->result->model->rom.shapes;
	const struct hawser_frf *frf = of->result->frf;
	int panel = of->panels, stride = 3*frf->probes, source = -1;
	double most = 0.0;
	char name[label_size], what[64];

	for (int k = 0; k < stride; k++)
		if (is_stroke(shapes->name[k/3]) &&
		    largest(frf->probe, frf->points, stride, k) > most) {
			most = largest(frf->probe, frf->points, stride, k);
			source = k;
		}
	if (source < 0)
		return;
	add_curve(of, shapes->name[source/3], panel, source);
	plain(name, shapes->name[source/3]);
	snprintf(what, sizeof what, "{/:Italic %c}, %.30s", "xyz"[source % 3], name);
	name_panel(of, panel, what);
	of->panels++;
}

static const char *const axis_name[] = {"{/:Italic x}", "{/:Italic y}", "{/:Italic z}"};

/* Largest amplitude of y or z. */
static double motion_of(const struct cli_frf_picture *of, int probe)
{
	const struct hawser_frf *frf = of->result->frf;

	return fmax(largest(frf->probe, frf->points, 3*frf->probes, 3*probe + 1),
	            largest(frf->probe, frf->points, 3*frf->probes, 3*probe + 2));
}

/* Of the first probes the one, but for `drawn`, that moves most; the first of equal ones (a quarter of
 * a span before three quarters). -1: there is none. */
static int moves_most(const struct cli_frf_picture *of, int probes, int drawn)
{
	double most = -1.0;
	int at = -1;

	for (int p = 0; p < probes; p++) {
		double size = motion_of(of, p);

		if (p == drawn || is_stroke(of->result->model->rom.shapes.name[p]) ||
		    size <= most*(1.0 + same))
			continue;
		most = size;
		at = p;
	}
	return at;
}

/* The same of all probes, or of the joints of a net, which have names that its user knows. */
static int drawn_first(const struct cli_frf_picture *of, int drawn)
{
	const struct cli_made *made = of->result->model->made;
	int most = moves_most(of, of->result->frf->probes, drawn);
	int joint = made ? moves_most(of, made->joints, drawn) : -1;

	return joint >= 0 && motion_of(of, joint) > enough*motion_of(of, most) ? joint : most;
}

/* The middle of a span, since others move with it, and the probe that moves most of the others; of a
 * ropeway, whose probes are the middles of its spans, the two that move most; of a net the
 * joints, if they do not move much less. */
static int choose_points(int point[2], const struct cli_frf_picture *of)
{
	const struct hawser_rom_shapes *shapes = &of->result->model->rom.shapes;
	int second = 0;

	while (second < shapes->points && strcmp(shapes->name[second], "mid") != 0)
		second++;
	if (second == shapes->points)
		second = drawn_first(of, -1);
	point[0] = drawn_first(of, second);
	point[1] = second;
	if (point[0] < 0)
		point[0] = second;
	return point[0] < 0 ? 0 : point[0] == point[1] ? 1 : 2;
}

static void choose_probes(struct cli_frf_picture *of)
{
	const struct hawser_rom_shapes *shapes = &of->result->model->rom.shapes;
	const struct hawser_frf *frf = of->result->frf;
	int point[2], probes = choose_points(point, of), stride = 3*frf->probes, c, p;
	double most[3] = {0.0, 0.0, 0.0};

	for (c = 1; c < 3; c++)
		for (p = 0; p < probes; p++)
			most[c] = fmax(most[c], largest(frf->probe, frf->points, stride, 3*point[p] + c));
	for (c = 2; c > 0; c--) {
		int panel = of->panels;

		if (most[c] <= visible*most[3 - c])
			continue;
		name_panel(of, panel, axis_name[c]);
		for (p = 0; p < probes; p++)
			add_curve(of, shapes->name[point[p]], panel, 3*point[p] + c);
		of->panels++;
	}
	choose_stroke(of);
}

static void choose_coordinates(struct cli_frf_picture *of)
{
	int n = of->result->model->rom.n, k;
	char name[32];

	for (k = 0; k < n && k < CLI_FRF_PANELS; k++) {
		snprintf(name, sizeof name, "{/:Italic u}_{%d}", k + 1);
		name_panel(of, k, name);
		add_curve(of, "", k, k);
	}
	of->panels = k;
}

/* By the 5th and 95th percentiles of the drawn values. `work` is overwritten. */
static int wants_log(const char *scale, double *work, size_t count)
{
	size_t zeros = 0;

	if (strcmp(scale, "auto") != 0)
		return strcmp(scale, "log") == 0;
	if (hawser__picture_logarithmic('y', NULL)) /* the user's range has 0 or less */
		return 0;
	qsort(work, count, sizeof *work, hawser__ascending);
	while (zeros < count && !(work[zeros] > 0.0))
		zeros++;
	count -= zeros;
	work += zeros;
	return count > 0 && work[count - 1 - count/20] > log_ratio*work[count/20];
}

static int is_logarithmic(const struct cli_frf_picture *of)
{
	const struct cli_over *over = of->result->over;
	int points = of->result->frf->points, logarithmic;
	double *work;

	if (over && over->omega == 0.0 && strcmp(of->result->scale, "auto") == 0)
		return 0; /* equilibria, out of which cycles grow */
	work = malloc((size_t)(of->curves*points + 1)*sizeof *work);

	if (!work)
		return 0;
	for (int c = 0; c < of->curves; c++)
		for (int i = 0; i < points; i++)
			work[c*points + i] = cli_frf_amplitude(of, c, i);
	logarithmic = wants_log(of->result->scale, work, (size_t)(of->curves*points));
	free(work);
	return logarithmic;
}

void cli_frf_range(double *least, double *most, const struct cli_frf_picture *of, int panel, double low,
                   double high)
{
	*least = INFINITY;
	*most = 0.0;
	for (int c = 0; c < of->curves; c++)
		for (int i = 0; of->curve[c].panel == panel && i < of->result->frf->points; i++) {
			double x = cli_frf_x(of, i), a = cli_frf_amplitude(of, c, i);

			if (x < low || x > high)
				continue;
			*most = fmax(*most, a);
			*least = fmin(*least, a);
		}
}

/* The vertical axis of a panel; a linear one begins at zero. */
static struct hawser__panel_axis amplitudes(const struct cli_frf_picture *of, int panel)
{
	struct hawser__panel_axis axis = {&of->y, .tics = 6, .zero = 1, .open = 1};
	double least = INFINITY, most = 0.0;

	for (int c = 0; c < of->curves; c++)
		for (int i = 0; of->curve[c].panel == panel && i < of->result->frf->points; i++) {
			double a = cli_frf_amplitude(of, c, i);

			most = fmax(most, a);
			least = a > 0.0 ? fmin(least, a) : least;
		}
	if (of->logarithmic && least < most)
		axis = (struct hawser__panel_axis){&of->y, fmax(0.8*least, 1e-12*most), 1.5*most, .tics = 6,
		                                   .logarithmic = 1};
	return axis;
}

/* Labels of the natural frequencies above the panel. Labels that would overlap are joined: "ω_1,
 * ω_2". A label that would extend beyond the picture is aligned with the end of the panel. */
static void label_naturals(struct cli_frf_picture *of)
{
	double width = 0.045*(of->high - of->low), end, omega;
	int count = of->result->over ? 0 : of->result->model->naturals;

	for (int k = 0, next; k < count; k = next) {
		char text[160] = "";

		omega = of->result->model->natural[k]*of->per_omega;
		next = k + 1;
		if (omega < of->low || omega > of->high)
			continue;
		for (end = omega + width; next < count && end < INFINITY; next++, end += width) {
			double at = of->result->model->natural[next]*of->per_omega;

			if (at > of->high || at >= end)
				break;
		}
		for (int j = k; j < next; j++)
			hawser__append(text, sizeof text, ", ", "ω_{%d}",
			                cli_natural_number(of->result->model, j));
		hawser__figure_above(&of->figure, end > of->high + 0.5*width ? of->high : omega,
		                     end > of->high + 0.5*width ? "right offset 1.5,0.6 tc rgb '#505050'"
		                     : "left offset -0.5,0.6 tc rgb '#505050'", text);
	}
}

/* A part of the abscissa on coloured ground. */
static void draw_ground(struct cli_frf_picture *of, double from, double to, const char *colour)
{
	fprintf(of->figure.out.script, "set object rectangle from first %.12g, graph 0 to first %.12g, "
	        "graph 1 behind fc rgb '%s' fs solid noborder\n", from/of->x.per, to/of->x.per, colour);
}

/* From the top of the picture down to `bottom`, both as parts of its height. */
static void draw_panels(struct cli_frf_picture *of, double bottom)
{
	static const char gap_colour[] = "#f3dede";
	const struct cli_frf_result *result = of->result;
	double top = 1.0 - 0.8/of->figure.out.height, tall = (top - bottom)/of->panels;

	for (int k = 0; k < of->panels; k++) {
		double base = top - tall*(k + 1);

		hawser__figure_panel(&of->figure, &(struct hawser__panel_frame){0.13, 0.965, base,
			base + tall - (k ? 0.45/of->figure.out.height : 0.0), .title = of->panel[k],
			.x = {&of->x, of->low, of->high, .tics = 10, .bare = k + 1 < of->panels},
			.y = amplitudes(of, k)});
		for (int i = 0; i < result->gaps; i++)
			draw_ground(of, result->gap[2*i]*of->per_omega, result->gap[2*i + 1]*of->per_omega,
			            gap_colour);
		for (int i = 0; i < of->details; i++)
			draw_ground(of, of->detail[i].from, of->detail[i].to, "#ececec");
		if (k == 0)
			label_naturals(of);
		cli_frf_curves(of, k);
	}
	if (result->gaps > 0)
		hawser__legend_add(&of->figure.legend, "no branch found", "with lines lw 8 lc rgb '%s'",
		                   gap_colour);
}

/* Entries of the legend that are of all curves. */
static void add_entries(struct cli_frf_picture *of)
{
	const struct hawser_frf *frf = of->result->frf;
	int unstable = 0;

	for (int c = 0; c < of->curves && of->curve[c].panel == 0; c++)
		if (*of->curve[c].label)
			hawser__legend_add(&of->figure.legend, of->curve[c].label, "with lines lt %d", c % 2 + 1);
	hawser__legend_once(&of->figure.legend, "stable", "with lines lt 7");
	for (int i = 0; i < frf->points; i++)
		unstable |= frf->point[i].unstable > 0;
	if (unstable)
		hawser__legend_once(&of->figure.legend, "unstable",
		                    "with lines lt 7 lw 1 " HAWSER__UNSTABLE_DASH);
}

/* branch [points]: see struct cli_frf_picture. */
static enum hawser_status draw(const char *path, const struct cli_frf_result *result,
                               const int *branch, struct hawser_report *report)
{
	struct cli_frf_picture of = {.result = result, .branch = branch};
	double from = result->from, to = result->to, room = HAWSER__LEGEND_CM, height;
	enum hawser_status status;

	of.x = cli_frf_axis(result->model);
	of.y = cli_model_axis(result->model, "", "m");
	of.per_omega = cli_per_omega(result->model);
	if (result->over)
		of.x = cli_axis(result->over->axis.key, result->over->axis.unit, result->over->axis.to);
	of.per_length = cli_per_length(result->model);
	if (result->frf->probes > 0)
		choose_probes(&of);
	of.probed = of.panels > 0;
	if (of.panels == 0)
		choose_coordinates(&of);
	of.low = result->over ? fmin(result->over->from, result->over->to) : fmin(from, to)*of.per_omega;
	of.high = result->over ? fmax(result->over->from, result->over->to) : fmax(from, to)*of.per_omega;
	of.logarithmic = is_logarithmic(&of);
	cli_frf_crowds(&of);
	height = room + 0.65 + 5.6*of.panels + cli_frf_details_cm(&of);
	status = hawser__figure_begin(&of.figure, path, 17.0, height, report);
	if (status)
		return status;
	add_entries(&of);
	draw_panels(&of, (room + cli_frf_details_cm(&of))/height);
	cli_frf_draw_details(&of, room);
	return hawser__figure_finish(&of.figure, report);
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
