/* cli/plan/plan_net_text.c - a plan of a net as text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/plan/plan_result.h"

enum { SHOWN = 12 }; /* cables in the table; JSON has all */

/* "12 ms", "3.4 s", "2 h"; "-". */
static const char *duration(char text[24], double seconds)
{
	double unit = seconds < 0.9995 ? 1e-3 : seconds < 99.5 ? 1.0 : seconds < 5970.0 ? 60.0 : 3600.0;
	double power = pow(10.0, floor(log10(seconds/unit)) - 1.0);

	if (isnan(seconds))
		return "-";
	snprintf(text, 24, "%.6g %s", round(seconds/unit/power)*power, unit < 1.0 ? "ms" : unit == 1.0 ? "s"
	         : unit == 60.0 ? "min" : "h");
	return text;
}

static const char *figure(char text[24], const char *format, double number)
{
	if (isnan(number))
		return "-";
	snprintf(text, 24, format, number); /* NOLINT: the formats are literals below */
	return text;
}

static void print_decisions(FILE *stream, const struct hawser_net_plan *plan)
{
	fputs("\nModelled\n", stream);
	for (int i = 0; i < plan->decisions; i++)
		fprintf(stream, "  %-4s %-26s %s\n", plan->decision[i].modelled ? "yes" : "no",
		        plan->decision[i].subject, plan->decision[i].why);
}

/* The coarsest meshes first. */
static int coarser(const void *a, const void *b)
{
	const struct cli_plan_net_cable *p = a, *q = b;
	double x = p->at.error/p->at.reach, y = q->at.error/q->at.reach;

	if (isnan(x) || isnan(y))
		return isnan(x) - isnan(y);
	return (x < y) - (x > y);
}

static void print_cables(FILE *stream, const struct cli_plan_net_result *result)
{
	const struct hawser_net_plan *plan = &result->plan;
	int shown = plan->cables < SHOWN ? plan->cables : SHOWN;
	struct cli_plan_net_cable *sorted = malloc((size_t)plan->cables*sizeof *sorted);

	if (!sorted)
		return;
	memcpy(sorted, result->cable, (size_t)plan->cables*sizeof *sorted);
	qsort(sorted, (size_t)plan->cables, sizeof *sorted, coarser);
	fprintf(stream, "\nMesh against exact catenaries, %s\n  %-12s %8s %10s %9s %10s %10s %8s %9s "
	        "%9s %8s\n",
	        shown < plan->cables ? "the coarsest cables" : "coarsest first", "cable", "elements",
	        "length m",
	        "sag m", "T_min N", "T_max N", "strain", "error m", "of reach", "for 1e-3");
	for (int i = 0; i < shown; i++) {
		const struct hawser_net_plan_cable *at = &sorted[i].at;
		char text[8][24];

		fprintf(stream, "  %-12s %8d %10s %9s %10s %10s %8s %9s %9s %8s%s\n", sorted[i].name,
		        at->elements,
		        figure(text[0], "%.6g", at->length0), figure(text[1], "%.4g", at->sag),
		        figure(text[2], "%.4g", at->T_min), figure(text[3], "%.4g", at->T_max),
		        figure(text[4], "%.1e", at->strain), figure(text[5], "%.1e", at->error),
		        figure(text[6], "%.1e", at->reach > 0.0 ? at->error/at->reach : NAN),
		        figure(text[7], "%.0f", at->wanted > 0 ? at->wanted : (double)NAN),
		        at->slack ? "  slack" : "");
	}
	free(sorted);
}

static void print_jobs(FILE *stream, const struct hawser_net_plan *plan)
{
	fprintf(stream, "\nCost (processor time of this machine; by run: measured, by estimate: from a "
	        "part)\n"
	        "  %-10s %-20s %9s %12s %9s %-18s %-9s %8s  %s\n", "job", "method", "unknowns",
	        "count", "time",
	        "between", "by", "MB", "why");
	for (int i = 0; i < HAWSER_NET_JOBS; i++) {
		const struct hawser_net_plan_job *job = &plan->job[i];
		char text[5][24], between[56] = "-", count[40] = "-";

		if (!isnan(job->seconds))
			snprintf(between, sizeof between, "%s to %s", duration(text[0], job->least),
			         duration(text[1], job->most));
		if (!isnan(job->count))
			snprintf(count, sizeof count, job->count < 1e7 ? "%.0f %s" : "%.2e %s", job->count,
			         job->counted[0] == 's' ? "steps" : "its");
		fprintf(stream, "  %-10s %-20s %9d %12s %9s %-18s %-9s %8s  %s\n", job->name, job->method,
		        job->unknowns, count, duration(text[2], job->seconds), between,
		        hawser_net_basis_name(job->basis), figure(text[3], "%.3g", job->bytes/1e6), job->why);
	}
	if (isfinite(plan->seconds))
		fprintf(stream, "  this plan itself took %.2g s of processor time\n", plan->seconds);
}

static void print_scales(FILE *stream, const struct hawser_net_plan *plan)
{
	char text[4][24];

	fprintf(stream, "\nTime scales\n");
	if (plan->fastest > 0.0)
		fprintf(stream, "  loads and supports at %.4g to %.4g rad/s: %s elements in the shortest "
		        "wave\n",
		        plan->slowest, plan->fastest, figure(text[0], "%.0f", plan->resolved));
	fprintf(stream, "  lowest mode %s rad/s; fastest axial vibration of the mesh %s rad/s\n",
	        figure(text[1], "%.4g", plan->first), figure(text[2], "%.4g", plan->axial));
	if (isnan(plan->step))
		return;
	fprintf(stream, "  steps of some %.2g s: ", plan->step);
	if (plan->fastest > 0.0)
		fprintf(stream, "%.0f a period of the fastest load, ", 2.0*M_PI/(plan->fastest*plan->step));
	fprintf(stream, "%s a period of that axial vibration\n",
	        figure(text[3], "%.2g", 2.0*M_PI/(plan->axial*plan->step)));
}

void cli_plan_net_print(FILE *stream, const struct cli_plan_net_result *result)
{
	const struct hawser_net_plan *plan = &result->plan;

	fprintf(stream, "hawser %s plan: %s\na net of %d nodes (%d supports) and %d cables: a mesh of "
	        "%d elements with %d unknowns (exact catenaries: %d)\nmotion until %.6g "
	        "s\n", hawser_version(),
	        result->net.name, plan->nodes, plan->supports, plan->cables, plan->elements, plan->unknowns,
	        plan->joint_unknowns, plan->until);
	print_decisions(stream, plan);
	if (plan->warnings)
		fputs("\nWarnings\n", stream);
	for (int i = 0; i < plan->warnings; i++)
		fprintf(stream, "  %s\n", plan->warning[i]);
	print_cables(stream, result);
	print_scales(stream, plan);
	print_jobs(stream, plan);
	fputs("\nSettings in use\n", stream);
	for (int i = 0; i < result->settings; i++) {
		const struct cli_setting *at = &result->setting[i];
		char value[128];

		snprintf(value, sizeof value, "%s %s", at->value, at->unit);
		fprintf(stream, "  %-20s %-16s %-8s %s\n", at->name, value, at->written ? "yours" : "default",
		        at->doc);
	}
}
