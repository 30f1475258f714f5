/* bench/plan.c - estimates of a plan against results: points, time and error of the fidelities of
 * scenes, over 0.6 to 3.3 times the first frequency.
 *
 * Verifies first: the sizes must be those planned. Errors are those of the frequencies of each
 * component's largest peak against the last fidelity of the list; times are processor times. Status
 * 1 if the estimated time of a condensed model is wrong by more than a factor of 3.
 *
 *   plan SCENE...
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/hawser.h>

enum { rows = 5 };
static const char list[] = "raw 5, condensed 5, condensed 9, condensed 12, condensed 16";

struct job {
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_frf_options options;
	struct hawser_plan plan;
	struct hawser_study_curve reference;
};

static enum hawser_status prepare(struct job *job, const char *path, struct hawser_report *report)
{
	struct hawser_fidelity_choice choice[rows];
	struct hawser_modes_options one = {.n = 1};
	struct hawser_modes modes = {.n = 0};
	int count;
	enum hawser_status status = hawser_scene_open(&job->scene, path, NULL, 0, report);

	if (!status)
		status = hawser_statics_scene(&job->statics, &job->scene, report);
	if (!status)
		status = hawser_modes_solve(&modes, &job->statics, &one, report);
	if (status)
		return status;
	job->options = (struct hawser_frf_options){.method = NULL};
	job->options.from = 0.6*modes.mode[0].omega;
	job->options.to = 3.3*modes.mode[0].omega;
	job->options.step_max = 0.005;
	hawser_modes_clear(&modes);
	status = hawser_fidelities_read(choice, &count, list, rows, report);
	if (!status)
		status = hawser_plan_make(&job->plan, &job->statics, &job->scene, choice, count,
		                          job->options.from, job->options.to, report);
	if (!status)
		status = hawser_study_run(&job->reference, &job->statics, &job->scene,
		                          &job->plan.row[rows - 1].choice, &job->options, report);
	return status;
}

/* One fidelity; returns 1 if the plan was wrong. */
static int measure(const struct job *job, const struct hawser_plan_row *row)
{
	struct hawser_study_curve curve = {.n = 0};
	struct hawser_study_error error = {.partner = NULL};
	struct hawser_report report = {.message = ""};
	double took, ratio;
	int wrong;

	if (hawser_study_run(&curve, &job->statics, &job->scene, &row->choice, &job->options, &report) ||
	    hawser_study_compare(&error, &curve, &job->reference, NULL, &report)) {
		printf("  %-14s %s\n", row->choice.name, report.message);
		hawser_study_clear(&curve);
		return 1;
	}
	took = curve.processor_seconds;
	ratio = took/row->seconds;
	printf("  %-14s %7.0f %7d %9.2g %9.2g %6.2f %10.1e %10.1e %4d %4d\n", row->choice.name,
	       row->points, curve.frf.points, row->seconds, took, ratio, row->omega_error,
	       fabs(error.largest.omega), error.fold.missing + error.peak.missing,
	       error.fold.extra + error.peak.extra);
	wrong = row->n != curve.n || row->quads != curve.quads || row->cubics != curve.cubics;
	if (!strcmp(row->choice.fidelity->name, "condensed"))
		wrong |= ratio > 3.0 || ratio < 1.0/3.0;
	hawser_study_error_clear(&error);
	hawser_study_clear(&curve);
	return wrong;
}

int main(int argc, char **argv)
{
	int wrong = 0;

	for (int i = 1; i < argc; i++) {
		struct job job = {.statics = {.H = 0.0}};
		struct hawser_report report = {.message = ""};

		printf("%s\n  %-14s %7s %7s %9s %9s %6s %10s %10s %4s %4s\n", argv[i], "fidelity",
		       "points", "taken", "time s", "taken", "ratio", "error", "measured", "miss", "xtra");
		if (prepare(&job, argv[i], &report)) {
			printf("  %s\n", report.message);
			wrong = 1;
		} else {
			for (int k = 0; k < rows; k++)
				wrong |= measure(&job, &job.plan.row[k]);
		}
		hawser_study_clear(&job.reference);
		hawser_plan_clear(&job.plan);
		hawser_scene_clear(&job.scene);
	}
	return wrong;
}
