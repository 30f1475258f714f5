/* rom/terms/history_motion.c - supports that move as a table says.
 *
 *    s_i(t)   displacement of end B relative to A (i = 0, 1, 2: along the axes of the plane of the
 *             cable) and of end A (3, 4, 5): splines (history.c), the signals 0 to 5
 *    r        the quasi-static displacement, linear in the s_i (support.c)
 *
 * The terms of the equations are those of support.c and support_energy.c: displacement by s_i,
 * forces of inertia by s_i'' and of damping by s_i', terms of the strain energy by products of up to
 * three s_i.
 * They are made there, with the model; the tables come afterwards and do not change them.
 *
 * s'' of a cubic spline is of second order in the spacing, but its error is that of the second
 * derivative of a function of fourth order, to which a mode that is slower than the rows does not
 * respond otherwise than with that order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/history.h"
#include "rom/condense/support.h"

enum { SIGNALS = HAWSER_MOTION_SIGNALS, COMPONENTS = 2*HAWSER__AXES };
static const char where[] = "history";

enum hawser_status hawser__history_begin(struct hawser_rom *rom, const struct hawser_scene *scene,
                                         const struct hawser_statics *statics,
                                         struct hawser_report *report)
{
	struct hawser_rom_history *history;

	hawser__rom_history_clear(rom);
	history = rom->history = calloc(1, sizeof *history);
	if (history)
		history->signal = calloc(SIGNALS, sizeof *history->signal);
	if (!history || !history->signal)
		return hawser__no_memory(report, where);
	history->moves = 1;
	history->signals = SIGNALS;
	for (int i = 0; i < SIGNALS; i++)
		for (int c = 0; c < COMPONENTS; c++)
			if (scene->support[c/HAWSER__AXES].given[c%HAWSER__AXES])
				history->weight[i][c] = hawser__support_weight(i, c/HAWSER__AXES, c%HAWSER__AXES,
				                                               statics);
	return HAWSER_OK;
}

enum hawser_status hawser__history_take(struct hawser_rom *rom,
                                        const struct hawser_history_factor *factor,
                                        struct hawser_report *report)
{
	struct hawser_ramp_term *term = hawser__history_term(rom, factor);
	struct hawser_harmonic *h = &rom->harmonic[rom->harmonics - 1];

	if (!term)
		return hawser__no_memory(report, where);
	*term = (struct hawser_ramp_term){.f = h->f, .D = h->D, .K = h->K, .answer = h->answer,
		.answer_line = h->answer_line, .quads = h->quads, .Q = h->Q};
	rom->harmonics--;
	rom->history->motions = rom->history->terms;
	return HAWSER_OK;
}

/* Whether a displacement along component c is given. */
static int uses(const struct hawser_rom_history *history, int c)
{
	for (int i = 0; i < SIGNALS; i++)
		if (history->weight[i][c] != 0.0)
			return 1;
	return 0;
}

static enum hawser_status check(const struct hawser_rom *rom, const struct hawser_rom_motion *motion,
                                struct hawser_report *report)
{
	static const char *const name[COMPONENTS] = {"A along x", "A along y", "A along z", "B along x",
		"B along y", "B along z"};

	if (!rom->history || !rom->history->moves || motion->rows < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "a motion of the ends at %d times for a model %s: give two times or more, "
		                    "and a model of a scene whose support has `given`", motion->rows,
		                    rom->history && rom->history->moves ? "with one" : "without one");
	for (int c = 0; c < COMPONENTS; c++)
		if (uses(rom->history, c) != (motion->value[c] != NULL))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "a displacement of end %s is %s by the motion, but not by the scene of "
			                    "the model (given of scene.support): both must have it", name[c],
			                    motion->value[c] ? "given" : "left out");
	return HAWSER_OK;
}

enum hawser_status hawser_rom_motion_set(struct hawser_rom *rom,
                                         const struct hawser_rom_motion *motion,
                                         struct hawser_report *report)
{
	enum hawser_status status = check(rom, motion, report);
	double *value = status ? NULL : malloc((size_t)motion->rows*sizeof *value);

	if (!status && !value)
		status = hawser__no_memory(report, where);
	for (int i = 0; i < SIGNALS && !status; i++) {
		const double *weight = rom->history->weight[i];
		int any = 0;

		memset(value, 0, (size_t)motion->rows*sizeof *value);
		for (int c = 0; c < COMPONENTS; c++) {
			any |= weight[c] != 0.0;
			for (int r = 0; weight[c] != 0.0 && r < motion->rows; r++)
				value[r] += weight[c]*motion->value[c][r];
		}
		if (any)
			status = hawser__history_signal(rom, i, motion->time, value, motion->rows, report);
	}
	free(value);
	return status;
}

/* Of end A, or of end B. */
static double speed(const struct hawser_rom_history *history, double t)
{
	double a = 0.0, b = 0.0;

	for (int axis = 0; axis < HAWSER__AXES; axis++) {
		double of_a = hawser__history_value(history, HAWSER__AXES + axis, t, 1);
		double of_b = of_a + hawser__history_value(history, axis, t, 1);

		a += of_a*of_a;
		b += of_b*of_b;
	}
	return sqrt(fmax(a, b));
}

double hawser_rom_motion_speed(const struct hawser_rom *rom, double time)
{
	const struct hawser_rom_history *history = rom->history;
	double most = 0.0, here;

	if (!history || !history->moves)
		return 0.0;
	for (int i = 0; i < SIGNALS; i++)
		for (int r = 0; r < history->signal[i].rows; r++)
			most = fmax(most, speed(history, history->signal[i].time[r]));
	here = speed(history, time);
	return here > 1e-2*most ? here : 0.0;
}
