/* cli/motion/surge.c - the tension of a run including the axial waves that a change of the travel speed
 * causes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "cli/motion/integrate_result.h"

int cli_surge_warning(char *text, size_t size, const struct cli_integrate_result *result)
{
	const struct hawser_surge *surge = &result->surge;
	double per_omega = cli_per_omega(result->model);

	if (surge->spare >= 0.0)
		return 0;
	if (surge->least < 0.0)
		snprintf(text, size, "slack: with the axial waves of the change of speed the tension falls to "
		         "%.4g N (known to %.2g N) at t = %.9g s; a cable bears no compression, so what "
		         "follows is not the motion of a cable", surge->least, surge->error,
		         surge->least_at/per_omega);
	else
		snprintf(text, size, "the change of speed, with its axial waves, leaves %.4g N at t = %.9g s "
		         "where a cable that travels so fast needs %.4g N (rho v^2) to keep its line: what "
		         "follows is not the motion of the cable", surge->least,
		         surge->spare_at/per_omega, surge->least - surge->spare);
	return 1;
}

enum hawser_status cli_surge_look(struct cli_integrate_result *result,
                                  struct hawser_report *report)
{
	const struct cli_model *model = result->model;
	const struct hawser_scene *scene = &model->scene;
	enum hawser_status status;

	if (!model->has_scene || !scene->travel.present || model->rom.exact || !model->rom.scaled ||
	    model->rom.line.points < 1 || result->run.rows < 2 ||
	    !(scene->travel.braking > 0.0 || scene->travel.fluctuation > 0.0))
		return HAWSER_OK;
	status = hawser_surge_look(&result->surge, &result->run, &model->rom, &model->statics, scene,
	                           result->omega, report);
	result->surges = !status;
	return status;
}

void cli_surge_comments(struct hawser__table *table, const struct cli_integrate_result *result)
{
	const struct hawser_surge *surge = &result->surge;
	double per_omega = cli_per_omega(result->model);

	if (result->surges)
		hawser__table_comment(table, "with the axial waves of the change of speed: %.6g N at "
		                      "t = %.9g s to %.6g N at t = %.9g s, known to %.2g N",
		                      surge->least, surge->least_at/per_omega, surge->most,
		                      surge->most_at/per_omega, surge->error);
	else if (result->model->rom.ramp && !result->model->has_scene)
		hawser__table_comment(table, "not in that tension: the axial waves of the change of speed, "
		                      "which a model file does not have (integrate the scene)");
}

#define OF(member) HAWSER__AT(struct hawser_surge, member)
const struct hawser__field cli_surge_field[] = {
	{"tension_with_waves.min", NULL, "least tension, with the axial waves of the change of speed",
	 OF(least), .unit = HAWSER__NEWTON},
	{"tension_with_waves.max", NULL, "greatest", OF(most), .unit = HAWSER__NEWTON},
	{"tension_with_waves.min_time", NULL, "time of the least", OF(least_at), .unit = HAWSER__S},
	{"tension_with_waves.max_time", NULL, "time of the greatest", OF(most_at), .unit = HAWSER__S},
	{"tension_with_waves.error", NULL, "estimated error of both", OF(error),
	 .unit = HAWSER__NEWTON},
	{"tension_with_waves.spare", NULL, "least value of the tension minus rho v^2; negative: the "
	 "cable does not keep its line", OF(spare), .unit = HAWSER__NEWTON},
	{"tension_of_speeding", NULL, "by how much the tension exceeds that of the model at that time",
	 OF(beyond), .unit = HAWSER__NEWTON},
	HAWSER__END,
};
#undef OF
