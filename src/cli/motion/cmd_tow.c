/* cli/motion/cmd_tow.c - hawser tow: a towed body in time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"
#include "output/drawing/animate.h"
#include "output/structures/structures.h"
#include "output/report/vtk.h"

enum { PATH = 4096 }; /* bytes: the longest path that Linux opens */

struct settings {
	struct cli_common common;
	const char *until, *step, *every, *local, *initial, *state, *vtk, *animate;
	int refine, check, frames;
	double rho_inf;
};
static const struct settings defaults = {.refine = 1, .rho_inf = 0.8,
                                         .frames = HAWSER__ANIMATE_FRAMES};
static const struct cli_option options[] = {
	CLI_TEXT_OPTION(until, "TIME", "end of the motion (that of the path)"),
	CLI_TEXT_OPTION(every, "TIME", "time between rows (a 500th of the motion)"),
	{"check", 0, "", "the motion again with twice as many elements: mesh error", CLI_FLAG(check),
	 .excludes = "initial"},
	CLI_TEXT_OPTION(initial, "FILE", "go on from a state that --state wrote (the steady state)"),
	CLI_TEXT_OPTION(state, "FILE", "write the last state, from which --initial goes on"),
	CLI_HEADING("Steps and mesh"),
	CLI_TEXT_OPTION(step, "TIME", "steps of this length (as the local error allows)"),
	CLI_TEXT_OPTION(local, "LENGTH", "local error of a step (1e-6 of the cable's length)"),
	{"rho-inf", 0, "NUMBER", "of the integration, 0 to 1: what is left of fast oscillations in a step "
	 "(0.8)", CLI_POSITIVE(rho_inf), .most = 1.0},
	{"refine", 0, "N", "elements of the scene times N (1)", CLI_COUNT(refine)},
	CLI_HEADING("Pictures and files"),
	CLI_TEXT_OPTION(vtk, "STEM", "write STEM-00000.vtk and so on, one a row, and STEM.vtk.series"),
	CLI_TEXT_OPTION(animate, "FILE.gif", "write an animation, seen from the towing point"),
	{"frames", 0, "N", "of the animation, at most (100)", CLI_COUNT(frames)},
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"The scene has tow (any path), cable with EA and EI, air or water, and body. The motion begins in",
	"the steady state at the path's first velocity.",
	NULL,
};

struct result {
	const struct settings *settings;
	struct hawser_tow tow;
	struct hawser_tow_motion motion;
	struct cli_progress progress;
	int checked;
	double mesh_error;
};

/* --- fields --- */

#define OF(member) HAWSER__AT(struct hawser_tow_sample, member)
static const struct hawser__field sample_field[] = {
	{"times", "t", "time", OF(t), .unit = HAWSER__SECOND},
	{"top", "top_", "the towing point", OF(top), .unit = HAWSER__METRE, .vector = &cli_axes},
	{NULL, "end_", "the free end of the cable", OF(end), .unit = HAWSER__METRE, .vector = &cli_axes},
	{"body.position", "body_", "the body's centre", OF(body), .unit = HAWSER__METRE,
	 .vector = &cli_axes},
	{"body.attitude", NULL, "[w, x, y, z], quaternions that turn -y into the axis of the ring (of "
	 "others: the cable's direction at its end)", OF(attitude)},
	{"tension_top", "tension_top", "at the towing point", OF(tension_top), .unit = HAWSER__NEWTON,
	 .place = 1},
	{"tilt", "tilt", "angle of the body's axis to the vertical", OF(tilt), .unit = HAWSER__RADIAN},
	{NULL, "tension_end", "in the last element", OF(tension_end), .unit = HAWSER__NEWTON, .place = 1},
	{"length", "length", "unstretched, of the cable", OF(length), .unit = HAWSER__METRE, .place = 1},
	{"energy.kinetic", NULL, "of the motion (J)", OF(kinetic)},
	{"energy.strain", NULL, "of stretch, bending and twist (J)", OF(strain)},
	{"energy.height", NULL, "of the weight, counted from y = 0 (J)", OF(height)},
	{"energy.towed", NULL, "done by the towing point since the beginning (J)", OF(towed)},
	{"energy.air", NULL, "done by the air or the water, and the spring of a joint (J)", OF(air)},
	{"energy.winch", NULL, "done by the winch, with the energy of what it pays out (J)", OF(winch)},
	HAWSER__END,
};
#undef OF
static const struct hawser__list sample_list =
	HAWSER__STORED_ROWS(struct result, motion.sample, motion.samples, sample_field);

#define OF(member) HAWSER__AT(struct hawser_tow_range, member)
static const struct hawser__field range_field[] = {
	{"s", NULL, "unstretched length from the towing point; with a winch its mean over the time", OF(s),
	 .unit = HAWSER__METRE},
	{"least", NULL, "tension over the time", OF(least), .unit = HAWSER__NEWTON},
	{"mean", NULL, "tension over the time", OF(mean), .unit = HAWSER__NEWTON},
	{"most", NULL, "tension over the time", OF(most), .unit = HAWSER__NEWTON},
	{"curvature", NULL, "largest", OF(bent), .unit = HAWSER__PER_M},
	HAWSER__END,
};
#undef OF

HAWSER__GIVEN(was_checked, struct result, of->checked)

HAWSER__GIVEN(sheds, struct result, of->motion.frequency > 0.0)

#define OF(member) HAWSER__AT(struct result, member)
static const struct hawser__field field[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(sample_list)},
	{"range", NULL, "of each element over the time",
	 HAWSER__STORED(struct result, motion.range, motion.elements, range_field)},
	{"closure", NULL, "energy that the steps have lost or made, over the largest energy",
	 OF(motion.closure)},
	{"momentum_closure", NULL, "largest gap of the momentum, over the largest momentum",
	 OF(motion.momentum)},
	{"step_error", NULL, "sum of the local errors of all steps", OF(motion.step_error),
	 .unit = HAWSER__METRE},
	{"mesh_error", NULL, "with --check: largest change of the body's place with twice the elements "
	 "and segments of a ring", OF(mesh_error), .unit = HAWSER__METRE, .given = was_checked},
	{"interrupted", NULL, "whether the user ended the run",
	 HAWSER__FLAG_AT(struct result, motion.interrupted)},
	{"raised", NULL, "elements whose EI was raised to 1 % of T h^2, as it is below that",
	 OF(motion.raised)},
	{"steps", NULL, "of the integration", OF(motion.steps)},
	{"rejected", NULL, "steps that were made again, shorter", OF(motion.rejected)},
	{"iterations", NULL, "of Newton's method", OF(motion.iterations)},
	{"shedding", NULL, "largest frequency of vortex shedding (Hz)", OF(motion.frequency),
	 .given = sheds},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_tow_listing[] = {
	{"Columns of the table:", sample_field, 0},
	{"Keys of JSON:", field, 1},
	{NULL, NULL, 0},
};

/* --- the result --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(&result->settings->common, "tow", "geometrically exact rod, generalised-alpha",
	                   NULL, 0);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_tow_motion *m = &result->motion;
	double tilt = 0.0, at = 0.0, most = 0.0, when = 0.0;

	for (int i = 0; i < m->samples; i++) {
		if (m->sample[i].tilt > tilt) {
			tilt = m->sample[i].tilt;
			at = m->sample[i].t;
		}
		if (m->sample[i].tension_top > most) {
			most = m->sample[i].tension_top;
			when = m->sample[i].t;
		}
	}
	hawser__table_comment(table, "g = %.10g m/s^2, %s %.6g kg/m^3", result->tow.g,
	                      result->tow.water.density > 0.0 ? "water" : "air", result->tow.density);
	hawser__table_comment(table, "%d elements, %ld steps, of these %ld again; shortest %.3g s",
	                      m->elements, m->steps, m->rejected, m->shortest);
	hawser__table_comment(table, "of the rows: largest tilt = %.6g rad at t = %.6g s, largest "
	                      "tension at the towing point = %.6g N at t = %.6g s", tilt, at, most, when);
	hawser__table_comment(table, "sum of local errors %.1e m; energy closes to %.1e of the largest, "
	                      "momentum to %.1e", m->step_error, m->closure, m->momentum);
	if (m->raised)
		hawser__table_comment(table, "EI is below 1 %% of T h^2 in %d of %d elements and was raised to "
		                      "that: give cable.segments.elements more to see its effect", m->raised,
		                      m->elements);
	if (m->interrupted)
		hawser__table_comment(table, "interrupted at t = %.9g s", m->sample[m->samples - 1].t);
	if (result->checked)
		hawser__table_comment(table, "mesh error %.2e m", result->mesh_error);
	if (m->frequency > 0.0)
		hawser__table_comment(table, "vortex shedding up to %.6g Hz", m->frequency);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_tow_motion(path, &result->motion, report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &sample_list, .fields = field, .draw = draw};

/* --- VTK --- */

static enum hawser_status write_vtk(const struct result *result, struct hawser_report *report)
{
	const struct hawser_tow_motion *m = &result->motion;
	const char *stem = result->settings->vtk;
	double *time = calloc((size_t)m->samples, sizeof *time);
	enum hawser_status status = time ? HAWSER_OK : hawser__no_memory(report, "tow");

	for (int i = 0; i < m->samples && !status; i++) {
		char path[PATH], title[64];
		struct hawser__vtk vtk = {.title = title, .points = m->elements + 1, .lines = m->elements};

		time[i] = m->sample[i].t;
		vtk.x = (const double (*)[3])(m->shape + (size_t)i*((size_t)m->elements + 1));
		snprintf(title, sizeof title, "hawser tow, t = %.9g s", time[i]);
		snprintf(path, sizeof path, "%s-%05d.vtk", stem, i);
		status = hawser__vtk_write(path, &vtk, report);
	}
	if (!status)
		status = hawser__vtk_series(stem, time, m->samples, report);
	free(time);
	return status;
}

/* The cable and, as its last point, the body's centre, less the place of the towing point. */
static enum hawser_status animate(const struct result *result, struct hawser_report *report)
{
	const struct hawser_tow_motion *m = &result->motion;
	int points = m->elements + 2;
	double (*x)[3] = calloc((size_t)m->samples*(size_t)points, sizeof *x);
	double *time = calloc((size_t)m->samples, sizeof *time);
	double (*top)[3] = calloc((size_t)m->samples, sizeof *top);
	enum hawser_status status = x && time && top ? HAWSER_OK : hawser__no_memory(report, "tow");

	for (int i = 0; i < m->samples && !status; i++) {
		double (*shape)[3] = m->shape + (size_t)i*((size_t)m->elements + 1);

		time[i] = m->sample[i].t;
		memcpy(top[i], shape[0], sizeof top[i]);
		for (int n = 0; n < points; n++)
			for (int k = 0; k < 3; k++)
				x[(size_t)i*(size_t)points + (size_t)n][k] =
					(n <= m->elements ? shape[n][k] : m->sample[i].body[k]) - shape[0][k];
	}
	if (!status)
		status = hawser__animate(result->settings->animate, &(struct hawser__animation){
			.time = time, .x = (const double (*)[3])x, .rows = m->samples, .points = points,
			.frames = result->settings->frames, .note = "seen from the towing point",
			.water = result->tow.water.density > 0.0 ? &result->tow.water : NULL,
			.origin = (const double (*)[3])top}, report);
	free(x);
	free(top);
	free(time);
	return status;
}

/* --- the command --- */

static int progress(void *data, double t, double until)
{
	struct result *result = data;

	cli_progress_show(&result->progress, "tow: %.4g s of %.4g s", t, until);
	return cli_interrupted();
}

/* Again with twice the elements and segments of a ring, and the largest change of the body's place. */
static enum hawser_status check(struct result *result, struct hawser_tow_options set,
                                struct hawser_report *report)
{
	struct hawser_tow_motion fine;
	struct hawser_tow twice = result->tow;
	enum hawser_status status;

	set.refine *= 2;
	twice.body.ring.segments = 2*(twice.body.ring.segments > 0 ? twice.body.ring.segments
	                                                           : HAWSER_RING_SEGMENTS);
	status = hawser_tow_move(&fine, &twice, &set, report);
	for (int i = 0; !status && i < fine.samples; i++) {
		const double *a = fine.sample[i].body, *b = result->motion.sample[i].body;
		double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], off = sqrt(x*x + y*y + z*z);

		result->mesh_error = off > result->mesh_error ? off : result->mesh_error;
	}
	result->checked = !status;
	hawser_tow_motion_clear(&fine);
	return status;
}

static enum hawser_status quantities(struct hawser_tow_options *set, const struct settings *s,
                                     struct hawser_report *report)
{
	enum hawser_status status = cli_quantity(&set->until, s->until, "s", CLI_ABOVE_ZERO, "tow",
	                                         "until", report);

	if (!status)
		status = cli_quantity(&set->step, s->step, "s", CLI_ABOVE_ZERO, "tow", "step", report);
	if (!status)
		status = cli_quantity(&set->every, s->every, "s", CLI_ABOVE_ZERO, "tow", "every", report);
	if (!status)
		status = cli_quantity(&set->tolerance, s->local, "m", CLI_ABOVE_ZERO, "tow", "local", report);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *s = context;
	struct result result = {.settings = s, .progress = {.quiet = s->common.quiet}};
	struct hawser_tow_options set = {.refine = s->refine, .rho_inf = s->rho_inf, .progress = progress,
	                                 .data = &result, .initial = s->initial};
	const struct cli_output state = {"state", s->state};
	enum hawser_status status = cli_outputs_check_with(&s->common, &state, 1, report);

	if (!status)
		status = hawser__file_check(s->state, report);
	if (!status)
		status = hawser__animate_check(s->animate, "tow", report);
	if (!status)
		status = quantities(&set, s, report);
	if (!status)
		status = cli_read_tow(&result.tow, &s->common, report);
	if (!status)
		status = hawser_tow_move(&result.motion, &result.tow, &set, report);
	if (!status && s->check && !result.motion.interrupted)
		status = check(&result, set, report);
	cli_progress_end(&result.progress);
	if (!status && s->state)
		status = hawser_tow_state_write(&result.motion, s->state, report);
	if (!status)
		status = cli_show(&s->common, &showing, &result, report);
	if (!status && s->vtk)
		status = write_vtk(&result, report);
	if (!status && s->animate)
		status = animate(&result, report);
	hawser_tow_motion_clear(&result.motion);
	hawser_tow_clear(&result.tow);
	return status;
}

const struct cli_command cli_tow = {
	"tow", "SCENE", "Towed body in time: places, tension, tilt, energy", notes, options, &defaults,
	sizeof(struct settings), 1, run, cli_tow_listing,
	.takes = CLI_TOW,
};
