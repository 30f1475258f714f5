/* Orbits of one full-order model carried over to another: the coordinates move the cable alike, and
 * the counterparts of marks are on the curve that the other model has when it is traced by itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/accuracy.h>

#include "study/accuracy/carry.h"
#include "response/orbit/balance.h"
#include "rom/energy/full_map.h"
#include "study/compare/curve.h"
#include "tests/tap.h"

static struct hawser_report report;
static struct hawser_scene scene;
static struct hawser_statics statics;

/* A slack span under its own weight, loaded in both planes. */
static const char text[] =
	"cable: {EA: 2.4 MN, rho: 2 kg/m}\nspan: {d: 60 m, h: 4 m}\ntension: {sag: 3.85 m}\n"
	"damping: {ratio: 0.02}\nload: {frame: global, per_length: [0, 0.3 N/m, 0.5 N/m]}\n";

static struct hawser_frf_options range(double unit)
{
	return (struct hawser_frf_options){.method = "balance", .from = 0.87*unit, .to = 1.15*unit,
		.tolerance = 1e-6, .step_max = 0.2, .unjudged = 1, .skip_events = 1,
		.samples = HAWSER_NONE};
}

/* What a motion of `of` moves at the probes, and what its coordinates in `to` move. */
static double off(const struct hawser_rom *of, const struct hawser_rom *to, const double *map)
{
	double worst = 0.0, size = 0.0;

	for (int p = 0; p < 3*of->shapes.points; p++) {
		double one = 0.0, other = 0.0;

		for (int j = 0; j < of->n; j++)
			one += cos(2.385*j)/(1 + j)*of->shapes.shape[3*of->shapes.points*j + p];
		for (int k = 0; k < to->n; k++)
			for (int j = 0; j < of->n; j++)
				other += map[k*of->n + j]*cos(2.385*j)/(1 + j)*
				         to->shapes.shape[3*to->shapes.points*k + p];
		worst = fmax(worst, fabs(one - other));
		size = fmax(size, fabs(one));
	}
	return worst/size;
}

static int stop(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	(void)state;
	return 1;
}

/* Root of the sum of squares of the defects of the fast coordinates at y. */
static double fast_defects(struct hawser__balance *balance, const double *y)
{
	int n = balance->base.n;
	double sum = 0.0;

	hawser__balance_evaluate(balance, y, 0);
	for (int i = 0; i < (2*balance->order + 1)*n; i++)
		if (hawser__balance_fast(balance, i%n) && balance->active[(i/n + 1)/2*n + i%n])
			sum += balance->defect[i]*balance->defect[i];
	return sqrt(sum);
}

/* An orbit of another model that is taken as it is stretches the cable; balanced at each sample, the
 * fast coordinates do not. */
static void settle(const struct hawser_rom *rom, const struct hawser__series *from, int n,
                   const double *map)
{
	struct hawser_frf_options options = range(sqrt(rom->K[0]));
	struct hawser__orbit *orbit;
	struct hawser__balance *balance;
	double *y, before, after, omega = from->y[(2*from->order + 1)*n];

	if (!ok(!hawser__balance_method.open(&orbit, rom, &options, &report), "opened: %s", report.message))
		return;
	balance = (struct hawser__balance *)orbit;
	y = calloc((size_t)orbit->size, sizeof *y);
	for (int i = 0; y && i < (2*from->order + 1)*rom->n; i++)
		for (int j = 0; j < n; j++)
			y[i] += map[i%rom->n*n + j]*from->y[i/rom->n*n + j];
	if (ok(y != NULL, "memory")) {
		y[orbit->size - 1] = omega;
		hawser__balance_adopt(balance, y, from->order, 0.0);
		ok(!hawser__balance_arrange(balance, &report), "arranged");
		hawser__balance_evaluate(balance, y, 1);
		before = fast_defects(balance, y);
		ok(!hawser__balance_settle(balance, y, &report), "settled");
		after = fast_defects(balance, y);
		ok(after < 1e-2*before && before > 0.0, "defects along the cable %.1e, of %.1e", after, before);
	}
	free(y);
	orbit->ops->clear(orbit);
}

static void compare(struct hawser_rom *rom, const double *map)
{
	struct hawser_frf_options options = range(sqrt(rom[1].K[0])), finer = options;
	struct hawser__orbits orbits = {.n = 0};
	struct hawser__trace_watch watch = hawser__orbits_watch(&orbits);
	struct hawser_frf frf[3];
	struct hawser__drawn_curve curve[3];
	double apart = 1.0, carried = 0.0, again = 1.0, peaks = 0.0;
	int marks = 0, lost = 1, *mark;

	finer.step_max = 0.01; /* a curve is off between its points */
	if (!ok(!hawser__frf_trace(&frf[0], &rom[0], &options, &watch, &report) &&
	        !hawser_frf_trace(&frf[1], &rom[1], &finer, &report), "both traced: %s", report.message))
		return;
	ok(orbits.count == frf[0].points, "%d orbits of %d points", orbits.count, frf[0].points);
	mark = calloc((size_t)frf[0].points, sizeof *mark);
	for (int k = 0; k < 2; k++)
		ok(!hawser__curve_copy(&curve[k], &frf[k], &report), "curve");
	ok(mark && !hawser__curve_marks(mark, &marks, &curve[0], &report) && marks > 8 &&
	   2*marks < frf[0].points, "%d marks of %d points", marks, frf[0].points);
	ok(!hawser__carry(&frf[2], &lost, &rom[1], &orbits, mark, marks, map, &options, &report) && !lost &&
	   frf[2].points == marks, "%d counterparts, lost %d: %s", frf[2].points, lost, report.message);
	ok(!hawser__curve_copy(&curve[2], &frf[2], &report) &&
	   !hawser__curve_points_distance(&carried, &curve[0], NULL, NULL, &curve[2], 0, &report) &&
	   !hawser__curve_points_distance(&peaks, &curve[0], mark, NULL, &curve[2], 0, &report) &&
	   !hawser__curve_distance(&apart, &curve[0], &curve[1], &report) &&
	   !hawser__curve_points_distance(&again, &curve[1], NULL, NULL, &curve[2], 0, &report),
	   "distances");
	/* the curves also differ by what is between their points; three times the distance is stated */
	ok(carried < 1.1*apart && apart < 2.0*carried, "%.3e by marks, %.3e by curves", carried, apart);
	ok(peaks > carried && peaks < 2.0*apart, "%.3e with the change of peaks", peaks);
	settle(&rom[1], &orbits.item[frf[0].points/2], orbits.n, map);
	ok(again < 0.1*apart, "counterparts are %.1e off the curve of their model", again);
	for (int k = 0; k < 3; k++) {
		hawser__curve_clear(&curve[k]);
		hawser_frf_clear(&frf[k]);
	}
	rom[1].harmonic[0].f[0] *= 3.0;
	rom[1].harmonic[0].f[1] *= 3.0;
	ok(!hawser__carry(&frf[2], &lost, &rom[1], &orbits, mark, marks, map, &options, &report) && lost,
	   "with another load there is none nearby");
	hawser_frf_clear(&frf[2]);
	options.progress.function = stop;
	ok(!hawser__carry(&frf[2], &lost, &rom[1], &orbits, mark, marks, map, &options, &report) && lost &&
	   frf[2].end == HAWSER_END_INTERRUPTED, "and a stop is told from that");
	hawser_frf_clear(&frf[2]);
	hawser__orbits_clear(&orbits);
	free(mark);
}

/* A peak of height 1 and half-width 1, and one that is higher and shifted: the height is read between
 * counterparts none of which is at the top. */
static void heights(void)
{
	enum { POINTS = 41, MARKS = 3 };
	const double higher = 1e-3, shift = 0.015;
	double arc[POINTS], value[4*POINTS] = {0.0}, beside[4*MARKS] = {0.0}, distance = 0.0;
	const int mark[MARKS] = {18, 20, 22};
	struct hawser__drawn_curve curve = {.points = POINTS, .width = 3, .arc = arc, .value = value};
	struct hawser__drawn_curve other = {.points = MARKS, .width = 3, .arc = arc, .value = beside};

	for (int i = 0; i < POINTS; i++) {
		arc[i] = 0.1*(i - 20) - 0.037;
		value[4*i] = 1e-3*arc[i];
		value[4*i + 3] = 1.0/(1.0 + arc[i]*arc[i]);
	}
	for (int k = 0; k < MARKS; k++) {
		double s = arc[mark[k]];

		beside[4*k] = 1e-3*s;
		beside[4*k + 3] = (1.0 + higher)/(1.0 + (s - shift)*(s - shift));
	}
	/* nearest to the top the two differ by a third of that */
	ok(!hawser__curve_points_distance(&distance, &curve, mark, NULL, &other, 0, &report),
	   "distance");
	ok(fabs(distance/higher - 1.0) < 0.15, "peak higher by %.3g, read %.3g", higher, distance);
}

/* A search up to `to` that may take so many seconds, as counted; `step` of its response. */
static void search(struct hawser_accuracy *accuracy, double unit, double to, double bearable,
                   double step)
{
	struct hawser_accuracy_options options = {.accuracy = 0.01, .agreed = 1, .partial = 1,
		.bearable = bearable, .expected = 100,
		.frf = {.from = 0.87*unit, .to = to*unit, .step_max = step}};

	ok(!hawser_accuracy_exact(accuracy, &statics, &scene, &options, &report), "%.3g s: %s", bearable,
	   report.message);
}

/* How far `part` is from the curve of `whole`, both below their folds, at mid-span across the plane. */
static double distance_of(const struct hawser_frf *part, const struct hawser_frf *whole)
{
	int step = 3*part->probes;
	double distance = 0.0;

	for (int i = 0, k = 0; i < part->points; i++) {
		double w = part->point[i].omega, at, amplitude;

		while (k + 2 < whole->points && whole->point[k + 1].omega < w)
			k++;
		at = (w - whole->point[k].omega)/(whole->point[k + 1].omega - whole->point[k].omega);
		amplitude = (1.0 - at)*whole->probe[(size_t)k*step + 2] +
		            at*whole->probe[((size_t)k + 1)*step + 2];
		distance = fmax(distance, fabs(part->probe[(size_t)i*step + 2]/amplitude - 1.0));
	}
	return part->points > 0 ? distance : 1.0;
}

/* The range ends where more of it would take too long; what there is of it is right. */
static void search_parts(double unit)
{
	struct hawser_accuracy whole, part, none, dear;
	double distance;

	search(&whole, unit, 1.15, 100.0, 0.0);
	search(&part, unit, 1.15, 0.4, 0.0);
	search(&none, unit, 1.15, 0.01, 0.0);
	search(&dear, unit, 0.92, 0.25, 2e-4);
	ok(whole.reached && isnan(whole.until), "the whole range");
	ok(part.reached && part.until > 0.9*unit && part.until < 1.14*unit && part.frf.points > 0 &&
	   fabs(part.frf.point[part.frf.points - 1].omega - part.until) < 1e-9, "a part, to %.3f of %.3f",
	   part.until/unit, 1.15);
	ok(!none.reached && none.costly && none.frf.points < 24 && none.foreseen > 0.01,
	   "none of it: %.2g s are foreseen", none.foreseen);
	distance = distance_of(&part.frf, &whole.frf);
	ok(distance < 0.02, "the same response, up to %.1e", distance);
	ok(dear.reached && dear.until > 0.87*unit && dear.until < 0.92*unit &&
	   dear.traced.to == dear.until && dear.frf.end == HAWSER_END_RANGE && dear.frf.points > 24,
	   "a response that takes more than its draft foretold ends with what there is, %d points to "
	   "%.4f of 0.92", dear.frf.points, dear.until/unit);
	distance = distance_of(&dear.frf, &whole.frf);
	ok(distance < 0.02, "which is the same response, up to %.1e", distance);
	hawser_accuracy_clear(&whole);
	hawser_accuracy_clear(&part);
	hawser_accuracy_clear(&none);
	hawser_accuracy_clear(&dear);
}

/* A trace that knows the orbits of its curve passes them again, with less work. */
static void pass_again(const struct hawser_rom *rom, const struct hawser_frf *first,
                       const struct hawser__orbits *orbits, const struct hawser_frf_options *options)
{
	const struct hawser__trace_watch watch = {.known = orbits};
	struct hawser_frf frf;
	double off = 0.0;
	int last;

	ok(!hawser__frf_trace(&frf, rom, options, &watch, &report), "passed again: %s", report.message);
	last = frf.points - 1;
	ok(frf.points <= first->points && frf.points > 8 &&
	   fabs(frf.point[last].omega/first->point[first->points - 1].omega - 1.0) < 1e-12,
	   "%d points where %d were", frf.points, first->points);
	ok(frf.cost.flows < 0.7*first->cost.flows, "by %.0f Jacobians in place of %.0f",
	   (double)frf.cost.flows, (double)first->cost.flows);
	for (int c = 0; c < 3*frf.probes; c++)
		off = fmax(off, fabs(frf.probe[(size_t)last*3*frf.probes + c]/
		                     first->probe[((size_t)first->points - 1)*3*first->probes + c] - 1.0));
	ok(off < 1e-4, "the same motion at the end, up to %.1e", off);
	hawser_frf_clear(&frf);
}

/* Each orbit of a stiff cable is its own counterpart in its own model, also where nothing is known of
 * its harmonics but itself: those along the cable are small, but stretch it. */
static void carry_to_itself(void)
{
	static const char stiff[] =
		"cable: {EA: 243 MN, rho: 3.7 kg/m}\nspan: {d: 95 m, h: -256 m}\ntension: {H: 24.7 kN}\n"
		"damping: {ratio: 0.0033}\nload: {frame: local, per_length: [0, 0.32 N/m, 0.36 N/m]}\n";
	struct hawser__orbits orbits = {.n = 0};
	struct hawser__trace_watch watch = hawser__orbits_watch(&orbits);
	struct hawser_frf_options options;
	struct hawser_scene steep;
	struct hawser_statics at_rest;
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	double *same = NULL;
	int found = 0, tried = 0;
	FILE *stream = tmpfile();

	if (!ok(stream && fputs(stiff, stream) >= 0 && !fseek(stream, 0, SEEK_SET) &&
	        !hawser_scene_read(&steep, stream, "stiff", NULL, 0, &report) &&
	        !hawser_statics_scene(&at_rest, &steep, &report) &&
	        !hawser_rom_build_full(&rom, &at_rest, &steep, 8, &report), "stiff: %s", report.message))
		return;
	options = range(sqrt(rom.K[0]));
	same = calloc((size_t)rom.n*(size_t)rom.n, sizeof *same);
	for (int j = 0; same && j < rom.n; j++)
		same[j*(rom.n + 1)] = 1.0;
	ok(same && !hawser__frf_trace(&frf, &rom, &options, &watch, &report) && frf.points > 8,
	   "traced: %s", report.message);
	for (int i = 0; same && i < orbits.count; i += orbits.count/8 + 1, tried++) {
		struct hawser_frf one;
		int lost = 1;

		found += !hawser__carry(&one, &lost, &rom, &orbits, &i, 1, same, &options, &report) && !lost &&
		         fabs(one.point[0].omega/frf.point[i].omega - 1.0) < 1e-4;
		hawser_frf_clear(&one);
	}
	ok(tried > 4 && found == tried, "%d of %d orbits are found in their own model", found, tried);
	pass_again(&rom, &frf, &orbits, &options);
	hawser_frf_clear(&frf);
	hawser__orbits_clear(&orbits);
	hawser_rom_clear(&rom);
	hawser_scene_clear(&steep);
	free(same);
	fclose(stream);
}

CASE(property_carry)
{
	struct hawser_rom rom[2] = {{.n = 0}};
	double *map = NULL;
	int rows = 0, columns = 0;
	double apart;
	FILE *stream;

	stream = tmpfile();
	if (!ok(stream && fputs(text, stream) >= 0 && !fseek(stream, 0, SEEK_SET) &&
	        !hawser_scene_read(&scene, stream, "span", NULL, 0, &report) &&
	        !hawser_statics_scene(&statics, &scene, &report) &&
	        !hawser_rom_build_full(&rom[0], &statics, &scene, 6, &report) &&
	        !hawser_rom_build_full(&rom[1], &statics, &scene, 8, &report) &&
	        !hawser__full_map(&map, &rows, &columns, &statics, 6, 8, &report), "models: %s",
	        report.message))
		return done_testing();
	ok(rows == rom[1].n && columns == rom[0].n, "map %d by %d", rows, columns);
	apart = off(&rom[0], &rom[1], map);
	ok(apart < 1e-8, "displacements at the probes differ by %.1e", apart);
	compare(rom, map);
	search_parts(sqrt(rom[1].K[0]));
	carry_to_itself();
	heights();
	free(map);
	fclose(stream);
	for (int k = 0; k < 2; k++)
		hawser_rom_clear(&rom[k]);
	return done_testing();
}
