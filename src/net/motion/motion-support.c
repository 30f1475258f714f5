/* net/motion/motion-support.c - motion of supports, by harmonics and from tables; harmonic loads.
 *
 * A table is a text file: a line `t x y z` for each time, in s and m, the displacement of the
 * node from its place in the scene; # begins a comment. Between the times: natural cubic spline.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/locale.h"
#include "core/order.h"
#include "core/report.h"
#include "net/motion/motion.h"

void hawser__support_acceleration(double a[3], const struct hawser__support_table *table, double t)
{
	int low = hawser__interval(table->t, table->rows - 1, t), high = low + 1;
	double part = (t - table->t[low])/(table->t[high] - table->t[low]);

	for (int k = 0; k < 3; k++)
		a[k] = (1.0 - part)*table->curve[low][k] + part*table->curve[high][k];
}

void hawser__motion_waves(double (*wave)[3], const struct hawser__mesh *mesh, double t, double factor)
{
	double f = 0.0;

	for (int i = 0; i < mesh->waves; i++) {
		const struct hawser__mesh_wave *from = &mesh->wave[i];

		if (i == 0 || from->Omega != from[-1].Omega || from->phase != from[-1].phase)
			f = factor*cos(from->Omega*t + from->phase); /* once for all nodes of a cable */
		for (int k = 0; k < 3; k++)
			wave[from->node][k] += f*from->value[k];
	}
}

void hawser__motion_supports(double (*x)[3], double (*v)[3], const struct hawser__motion *motion,
                             double t)
{
	const struct hawser__mesh *mesh = motion->mesh;

	for (int i = 0; i < mesh->motions; i++)
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[mesh->motion[i].node][k] < 0)
				x[mesh->motion[i].node][k] = v[mesh->motion[i].node][k] = 0.0;
	for (int i = 0; i < mesh->motions; i++) {
		const struct hawser__mesh_wave *from = &mesh->motion[i];
		double c = cos(from->Omega*t + from->phase), s = sin(from->Omega*t + from->phase);

		for (int k = 0; k < 3; k++)
			if (mesh->unknown[from->node][k] < 0) {
				x[from->node][k] += from->value[k]*(c - cos(from->phase));
				v[from->node][k] -= from->value[k]*from->Omega*s;
			}
	}
	for (int i = 0; i < motion->tables; i++) {
		const struct hawser__support_table *table = &motion->table[i];
		double here[3], rate[3];

		hawser__support_at(here, rate, table, t);
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[table->node][k] < 0) {
				x[table->node][k] = here[k] - table->from[k];
				v[table->node][k] = rate[k];
			}
	}
}

void hawser__motion_support_accelerations(double (*a)[3], const struct hawser__motion *motion, double t)
{
	const struct hawser__mesh *mesh = motion->mesh;

	memset(a, 0, (size_t)mesh->nodes*sizeof *a);
	for (int i = 0; i < mesh->motions; i++) {
		const struct hawser__mesh_wave *from = &mesh->motion[i];
		double c = from->Omega*from->Omega*cos(from->Omega*t + from->phase);

		for (int k = 0; k < 3; k++)
			if (mesh->unknown[from->node][k] < 0)
				a[from->node][k] -= from->value[k]*c;
	}
	for (int i = 0; i < motion->tables; i++) {
		const struct hawser__support_table *table = &motion->table[i];
		double here[3];

		hawser__support_acceleration(here, table, t);
		for (int k = 0; k < 3; k++)
			if (mesh->unknown[table->node][k] < 0)
				a[table->node][k] = here[k];
	}
}

void hawser__support_clear(struct hawser__support_table *table)
{
	free(table->t);
	free(table->x);
	free(table->curve);
	memset(table, 0, sizeof *table);
}

/* Second derivatives of the natural spline, by elimination; work [rows]. */
static void spline(struct hawser__support_table *table, int k, double *work)
{
	const double *t = table->t;
	int n = table->rows;

	table->curve[0][k] = work[0] = 0.0;
	for (int i = 1; i < n - 1; i++) {
		double a = t[i] - t[i - 1], b = t[i + 1] - t[i];
		double up = table->x[i + 1][k] - table->x[i][k], down = table->x[i][k] - table->x[i - 1][k];
		double slope = up/b - down/a;
		double pivot = 2.0*(a + b) - a*work[i - 1];

		work[i] = b/pivot;
		table->curve[i][k] = (6.0*slope - a*table->curve[i - 1][k])/pivot;
	}
	table->curve[n - 1][k] = 0.0;
	for (int i = n - 2; i > 0; i--)
		table->curve[i][k] -= work[i]*table->curve[i + 1][k];
}

void hawser__support_at(double x[3], double v[3], const struct hawser__support_table *table, double t)
{
	int low = hawser__interval(table->t, table->rows - 1, t), high = low + 1;
	double h, a, b;

	h = table->t[high] - table->t[low];
	a = (table->t[high] - t)/h;
	b = (t - table->t[low])/h;
	for (int k = 0; k < 3; k++) {
		double p = table->x[low][k], q = table->x[high][k], c = table->curve[low][k],
		       d = table->curve[high][k];

		x[k] = a*p + b*q + ((a*a*a - a)*c + (b*b*b - b)*d)*h*h/6.0;
		v[k] = (q - p)/h - (3.0*a*a - 1.0)/6.0*h*c + (3.0*b*b - 1.0)/6.0*h*d;
	}
}

void hawser__support_within(double x[3], double v[3], const struct hawser__support_table *table,
                            double t)
{
	double at = fmin(fmax(t, table->t[0]), table->t[table->rows - 1]);

	hawser__support_at(x, v, table, at);
	for (int k = 0; k < 3 && at != t; k++)
		v[k] = 0.0;
}

/* One line; *blank is 1 if it has no numbers. */
static int parse(double value[4], int *blank, char *line)
{
	char *at = line, *end;

	line[strcspn(line, "#\r\n")] = '\0';
	*blank = line[strspn(line, " \t,")] == '\0';
	for (int k = 0; k < 4 && !*blank; k++) {
		value[k] = strtod(at, &end);
		if (end == at || !isfinite(value[k]))
			return 0;
		at = end + strspn(end, " \t,");
	}
	return *blank || *at == '\0';
}

static enum hawser_status rows(struct hawser__support_table *table, FILE *file, const char *path,
                               struct hawser_report *report)
{
	char line[512];
	int number = 0, blank;
	double value[4];

	while (fgets(line, sizeof line, file)) {
		number++;
		if (!parse(value, &blank, line))
			return hawser__fail(report, HAWSER_ERR_SCENE, "net", "%s:%d: a line must have 4 numbers: "
			                    "time in s, and displacements x, y, z in m (of a current, velocities "
			                    "in m/s)", path, number);
		if (blank)
			continue;
		if (table->rows && value[0] <= table->t[table->rows - 1])
			return hawser__fail(report, HAWSER_ERR_SCENE, "net", "%s:%d: the time %g s is not after "
			                    "that of the line before", path, number, value[0]);
		if (hawser__more(&table->t, table->rows, sizeof *table->t) ||
		    hawser__more(&table->x, table->rows, sizeof *table->x))
			return hawser__no_memory(report, "net");
		table->t[table->rows] = value[0];
		memcpy(table->x[table->rows++], value + 1, sizeof *table->x);
	}
	if (table->rows < 2)
		return hawser__fail(report, HAWSER_ERR_SCENE, "net", "%s: a motion of a support, or a current, "
		                    "needs two times at least", path);
	return HAWSER_OK;
}

enum hawser_status hawser__support_read(struct hawser__support_table *table, const char *path,
                                      struct hawser_report *report)
{
	FILE *file = fopen(path, "r");
	struct hawser__locale locale;
	double *work = NULL;
	enum hawser_status status;

	if (!file)
		return hawser__fail(report, hawser__unreadable(errno), "net", "%s: %s: the table with the "
		                    "motion of a support cannot be read", path, strerror(errno));
	hawser__locale_begin(&locale);
	status = rows(table, file, path, report);
	hawser__locale_end(&locale);
	fclose(file);
	if (!status) {
		table->curve = calloc((size_t)table->rows, sizeof *table->curve);
		work = calloc((size_t)table->rows, sizeof *work);
		if (!table->curve || !work)
			status = hawser__no_memory(report, "net");
	}
	for (int k = 0; k < 3 && !status; k++)
		spline(table, k, work);
	free(work);
	if (status)
		hawser__support_clear(table);
	return status;
}

enum hawser_status hawser__supports_read(struct hawser__support_table **table, int *tables,
                                         const struct hawser_net *net, double until,
                                         struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*table = calloc((size_t)net->nodes + 1, sizeof **table);
	if (!*table)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < net->nodes && !status; i++) {
		struct hawser__support_table *to = &(*table)[*tables];

		if (!net->node[i].table)
			continue;
		status = hawser__support_read(to, net->node[i].table, report);
		if (status)
			break;
		to->node = i;
		++*tables;
		if (to->t[0] > 0.0 || to->t[to->rows - 1] < until)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: the motion of node %s is "
			                    "given from %g s to %g s, and the run is from 0 to %g s: make it end "
			                    "earlier, or the table longer", net->node[i].table,
			                    net->node[i].name, to->t[0], to->t[to->rows - 1], until);
	}
	return status;
}

void hawser__supports_begin(double (*q)[3], const struct hawser_net *net,
                            struct hawser__support_table *table, int tables)
{
	double rate[3];

	for (int i = 0; i < net->motions; i++)
		for (int k = 0; k < 3; k++)
			q[net->motion[i].node][k] += net->motion[i].value[k]*cos(net->motion[i].phase);
	for (int i = 0; i < tables; i++) {
		hawser__support_at(table[i].from, rate, &table[i], 0.0);
		for (int k = 0; k < 3; k++)
			if (net->node[table[i].node].held[k])
				q[table[i].node][k] += table[i].from[k];
	}
}
