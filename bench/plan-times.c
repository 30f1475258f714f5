/* bench/plan-times.c - times stated by hawser plan against processor times of the runs, on random
 * scenes: taut, sagging and inclined cables, at rest or travelling, ranges about the first or the
 * second frequency or wide ones, amplitudes at resonance from 0.3 to 50 % of the sag.
 *
 * Each run is a process that is ended after LIMIT s of processor time; the plan must then state
 * more than a third of LIMIT. The ratio is real over planned time.
 *
 *   bench/plan-times [COUNT [SEED [FIRST [LIMIT]]]]
 *
 * COUNT scenes (40) from SEED (1), the first with number FIRST (0), LIMIT 60; 0: no runs, plans
 * alone. Status 1 if fewer than nine of ten ratios are within a factor of 3.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/clock.h"
#include "bench/estimates.h"

enum { FIDELITIES = 4 };

struct job {
	struct hawser_scene scene;
	struct hawser_statics statics;
	double from, to;
	struct hawser_fidelity_choice choice[FIDELITIES];
	char text[200];
};

static void draw_cable(struct hawser_scene *scene, struct chance *chance)
{
	double d = chance_log(chance, 2.0, 500.0), rho = chance_log(chance, 0.05, 50.0);
	double slope = chance_unit(chance) < 0.4 ? 0.0 : chance_between(chance, -0.7, 0.7);
	double sag = chance_unit(chance) < 0.5 ? chance_log(chance, 2e-3, 0.03)
	                                       : chance_log(chance, 0.03, 0.2);
	double H = rho*9.81*d/(8.0*sag);

	*scene = (struct hawser_scene){.g = 9.81};
	scene->cable.rho = rho;
	scene->cable.EA = H/chance_log(chance, 2e-5, 3e-3);
	scene->span.d = d;
	scene->span.h = slope*d;
	scene->tension.given = HAWSER_GIVEN_SAG;
	scene->tension.value = sag*d;
	scene->load.present = 1;
	scene->load.extent[1] = 1.0;
	if (chance_unit(chance) < 0.25) {
		scene->travel.present = 1;
		scene->travel.speed = chance_log(chance, 0.02, 0.25)*sqrt(H/rho);
	}
}

static void draw_load(struct hawser_scene *scene, struct chance *chance,
                      const struct hawser_statics *st, double omega)
{
	double ratio = chance_log(chance, 2e-3, 0.03), part = chance_log(chance, 3e-3, 0.5);
	double size = 2.0*ratio*omega*omega*part*st->sag/st->span.d*st->H/st->span.d;
	int planar = chance_unit(chance) < 0.25;

	scene->load.frame = chance_unit(chance) < 0.5 ? HAWSER_FRAME_GLOBAL : HAWSER_FRAME_LOCAL;
	for (int i = 0; i < 3; i++)
		scene->load.per_length[i] = i == 2 && planar ? 0.0
		                            : size*chance_between(chance, 0.2, 1.0);
	scene->damping.kind = HAWSER_DAMPING_RATIO;
	scene->damping.ratio = ratio;
	scene->model.modes = 5;
	scene->model.accuracy = 0.01;
	scene->model.tolerance = 1e-10;
	scene->model.condense = HAWSER_CONDENSE_STATIC;
	scene->model.inertia = HAWSER_INERTIA_AUTO;
}

static void draw_range(struct job *job, struct chance *chance, const struct hawser_modes *modes)
{
	double one = modes->mode[0].omega, two = modes->mode[1].omega, kind = chance_unit(chance);

	if (kind < 0.35) {
		job->from = one*chance_between(chance, 0.7, 0.95);
		job->to = one*chance_between(chance, 1.05, 1.3);
	} else if (kind < 0.65) {
		job->from = two*chance_between(chance, 0.8, 0.95);
		job->to = two*chance_between(chance, 1.05, 1.3);
	} else {
		job->from = one*chance_between(chance, 0.5, 0.9);
		job->to = one*chance_between(chance, 1.6, 3.3);
	}
}

static int draw_job(struct job *job, struct chance *chance)
{
	static const int raw[] = {5, 9, 12}, condensed[] = {5, 9, 12, 16}, chosen[] = {5, 7, 9};
	struct hawser_modes_options lowest = {.n = 2};
	struct hawser_modes modes = {.n = 0};
	char list[100];
	int count;

	draw_cable(&job->scene, chance);
	if (hawser_statics_scene(&job->statics, &job->scene, NULL) ||
	    hawser_modes_solve(&modes, &job->statics, &lowest, NULL))
		return 1;
	draw_range(job, chance, &modes);
	draw_load(&job->scene, chance, &job->statics, 0.5*(job->from + job->to));
	snprintf(job->text, sizeof job->text, "sag %.3g h/d %.2g eps %.1e speed %.2g ratio %.4f "
	         "%.2f-%.2f w1", job->statics.sag/job->statics.span.d, job->statics.hs,
	         job->statics.epsilon, job->scene.travel.speed, job->scene.damping.ratio,
	         job->from/modes.mode[0].omega, job->to/modes.mode[0].omega);
	hawser_modes_clear(&modes);
	snprintf(list, sizeof list, "raw %d, condensed %d, chosen %d, auto", raw[chance_int(chance, 0, 2)],
	         condensed[chance_int(chance, 0, 3)], chosen[chance_int(chance, 0, 2)]);
	return hawser_fidelities_read(job->choice, &count, list, FIDELITIES, NULL) != HAWSER_OK;
}

/* --- runs --- */

struct outcome {
	double seconds;
	int points;
	char method[12];
};

static void run(struct outcome *outcome, const struct job *job,
                const struct hawser_fidelity_choice *choice)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_study_curve curve = {.n = 0};
	double start = cpu_secs();
	int failed;

	options.from = job->from;
	options.to = job->to;
	options.step_max = 0.005;
	failed = hawser_study_run(&curve, &job->statics, &job->scene, choice, &options, NULL) !=
	         HAWSER_OK;
	*outcome = (struct outcome){.seconds = failed ? cpu_secs() - start : curve.processor_seconds,
	                            .points = curve.frf.points};
	snprintf(outcome->method, sizeof outcome->method, "%s", failed ? "fails"
	         : curve.frf.method ? curve.frf.method : "-");
}

/* 1: ended after the limit. */
static int run_apart(struct outcome *outcome, const struct job *job,
                     const struct hawser_fidelity_choice *choice, double limit)
{
	struct rlimit bound = {(rlim_t)ceil(limit), (rlim_t)ceil(limit) + 1};
	int ends[2], state = 0, got;
	pid_t child;

	*outcome = (struct outcome){.seconds = limit, .method = "-"};
	fflush(stdout);
	if (pipe(ends) || (child = fork()) < 0)
		return 1;
	if (child == 0) {
		setrlimit(RLIMIT_CPU, &bound);
		run(outcome, job, choice);
		_exit(write(ends[1], outcome, sizeof *outcome) != sizeof *outcome);
	}
	close(ends[1]);
	got = read(ends[0], outcome, sizeof *outcome) == sizeof *outcome;
	close(ends[0]);
	waitpid(child, &state, 0);
	return !got;
}

/* --- statistics --- */

/* Real over planned time. For a run that was ended: 1 if the plan states more than a third of the
 * limit. */
static double ratio_of(const struct outcome *at, int over, const struct hawser_plan_row *row)
{
	double ratio = at->seconds/row->seconds;

	return over && row->seconds > at->seconds/3.0 ? 1.0 : ratio;
}

static void show(const struct job *job, const struct hawser_plan_row *row, const struct outcome *at,
                 int over, int scene)
{
	printf("  %4d %-14s %s%8.3g s planned %8.3g %5d points planned %6.0f, %3d coordinates  "
	       "%s: %s%s%s\n", scene, row->choice.name, over ? ">" : " ", at->seconds, row->seconds,
	       at->points, row->points, row->n, at->method, job->text, *row->foreseen ? "; " : "",
	       row->foreseen);
}

/* 1: the conditions above are not met. */
static int report_ratios(const char *name, struct ratios *ratios)
{
	int within = 0;
	double worst = 0.0;

	for (int i = 0; i < ratios->count; i++) {
		double off = fmax(ratios->ratio[i], 1.0/ratios->ratio[i]);

		within += off <= 3.0;
		worst = fmax(worst, off);
	}
	printf("%-10s %5d %8.3f %8.2f %8.2f %8.2f %8.2f %8.2f\n", name, ratios->count,
	       ratios->count ? (double)within/ratios->count : NAN, worst, tally_quantile(ratios, 0.05),
	       tally_quantile(ratios, 0.5), tally_quantile(ratios, 0.9), tally_quantile(ratios, 1.0));
	return within < 0.9*ratios->count;
}

static void study(struct tally *tally, const struct job *job, double limit, int scene)
{
	struct hawser_plan plan = {.rows = 0};
	struct hawser_report report = {.message = ""};

	if (hawser_plan_make(&plan, &job->statics, &job->scene, job->choice, FIDELITIES, job->from,
	                     job->to, &report))
		printf("  %4d plan: %s\n", scene, report.message);
	for (int k = 0; k < FIDELITIES && k < plan.rows; k++) {
		struct outcome at;
		int over = limit > 0.0 && run_apart(&at, job, &job->choice[k], limit);

		if (limit > 0.0)
			tally_note(&tally[k], ratio_of(&at, over, &plan.row[k]), 1.0, "%s",
			           job->choice[k].name);
		else
			at = (struct outcome){.seconds = NAN, .method = "-"};
		show(job, &plan.row[k], &at, over, scene);
	}
	fflush(stdout);
	hawser_plan_clear(&plan);
}

int main(int argc, char **argv)
{
	static const char *const name[FIDELITIES] = {"raw", "condensed", "chosen", "auto"};
	int count = argc > 1 ? atoi(argv[1]) : 40, first = argc > 3 ? atoi(argv[3]) : 0, broken = 0;
	uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
	double limit = argc > 4 ? atof(argv[4]) : 60.0;
	struct tally tally[FIDELITIES] = {{.divide = 1.0}, {.divide = 1.0}, {.divide = 1.0},
	                                  {.divide = 1.0}};

	for (int i = first; i < first + count; i++) {
		struct chance chance = chance_at(seed, 1, (uint64_t)i);
		struct job job = {.from = 0.0};

		if (!draw_job(&job, &chance))
			study(tally, &job, limit, i);
	}
	printf("%-10s %5s %8s %8s %8s %8s %8s %8s\n", "real/plan", "runs", "within 3",
	       "worst", "5 %", "50 %", "90 %", "largest");
	for (int k = 0; k < FIDELITIES; k++) {
		broken |= report_ratios(name[k], &tally[k].all);
		tally_clear(&tally[k]);
	}
	return broken;
}
