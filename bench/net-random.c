/* bench/net-random - statics of random nets (tests/net-random.h): none may fail, and none may be wrong.
 *
 *     bench/net-random [-n NETS] [-o ONE] [-s SEED] [-m METHOD] [-w DIR]
 *
 * Each net (or ONE alone) is solved by the default method (or METHOD) and verified: the residual
 * against round-off and tolerance, the certificate (gap of the energy), and the tensions of all
 * elements against those of another method with the same mesh. Errors are relative to the loads and
 * tensions or, without loads, to 1e-6 of the least EA, as the tolerance of the statics is. -w writes
 * the scenes to DIR/net-NUMBER.json. Prints one line for each kind of net. The status is 1 if one
 * failed or is wrong.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include "bench/clock.h"
#include "tests/net-random.h"

static const char *const kind_name[] = {"heavy", "light and heavy", "bars"};
static const char *const change_name[CHANGES] = {"partly held", "wind", "stiff", "long", "uneven",
                                                 "other units", "no gravity", "some rigid"};

struct tally {
	int nets, slack, failed, wrong; /* slack: nets with slack elements */
	int other;                      /* the second method failed */
	long iterations;
	double gap, force; /* largest: gap and differences of tensions, relative */
};

struct settings {
	long nets, only; /* only: the number of one net, or -1 */
	uint64_t seed;
	const char *method, *folder;
};

/* --- scenes --- */

static void write_vector(FILE *file, const double x[3])
{
	fprintf(file, "[%.17g, %.17g, %.17g]", x[0], x[1], x[2]);
}

static void write_supports(FILE *file, const struct random_net *r)
{
	int first = 1;

	fprintf(file, "},\n\"supports\": {");
	for (int i = 0; i < r->net.nodes; i++) {
		const unsigned char *held = r->node[i].held;
		const char *comma = "";

		if (!held[0] && !held[1] && !held[2])
			continue;
		fprintf(file, "%s\"%s\": {\"fixed\": [", first ? "" : ", ", r->node[i].name);
		for (int k = 0; k < 3; k++)
			if (held[k]) {
				fprintf(file, "%s\"%c\"", comma, "xyz"[k]);
				comma = ", ";
			}
		fprintf(file, "]}");
		first = 0;
	}
}

static void write_loads(FILE *file, const struct random_net *r)
{
	fprintf(file, "},\n\"loads\": {");
	for (int i = 0; i < r->net.loads; i++) {
		const struct hawser_net_load *load = &r->load[i];
		int cable = load->cable >= 0;

		fprintf(file, "%s\"%s\": %s", i ? ", " : "",
		        cable ? r->cable[load->cable].name : r->node[load->node].name,
		        cable ? "{\"per_length\": " : "");
		write_vector(file, load->value);
		fprintf(file, "%s", cable ? "}" : "");
	}
}

/* A scene in JSON, which is YAML too. */
static int write_scene(const char *folder, long number, const struct random_net *r)
{
	char path[1000];
	FILE *file;

	snprintf(path, sizeof path, "%s/net-%ld.json", folder, number);
	file = fopen(path, "w");
	if (!file)
		return 1;
	fprintf(file, "{\n\"kind\": \"net\",\n\"g\": %.17g,\n\"nodes\": {", r->net.g);
	for (int i = 0; i < r->net.nodes; i++) {
		fprintf(file, "%s\"%s\": ", i ? ", " : "", r->node[i].name);
		write_vector(file, r->node[i].x);
	}
	fprintf(file, "},\n\"masses\": {");
	for (int i = 0; i < r->net.nodes; i++)
		fprintf(file, "%s\"%s\": %.17g", i ? ", " : "", r->node[i].name, r->node[i].mass);
	write_supports(file, r);
	write_loads(file, r);
	fprintf(file, "},\n\"cables\": [\n");
	for (int c = 0; c < r->net.cables; c++) {
		const struct hawser_net_cable *one = &r->cable[c];

		fprintf(file, "{\"name\": \"%s\", \"from\": \"%s\", \"to\": \"%s\", \"EA\": %.17g, "
		        "\"rho\": %.17g, \"length0\": %.17g, \"elements\": %d}%s\n", one->name,
		        r->node[one->from].name, r->node[one->to].name, one->EA, one->rho, one->value,
		        one->elements, c < r->net.cables - 1 ? "," : "");
	}
	fprintf(file, "]}\n");
	return fclose(file) != 0;
}

/* --- checks --- */

/* Largest difference of the tensions, over that of the loads and tensions. */
static double forces(const struct hawser_net_statics *a, const struct hawser_net_statics *b,
                     double weight)
{
	double most = 0.0, size = weight;

	for (int c = 0; c < a->cables; c++) {
		size = fmax(size, a->member[c].T_max);
		most = fmax(most, fmax(fabs(a->member[c].T_max - b->member[c].T_max),
		                       fabs(a->member[c].T_min - b->member[c].T_min)));
	}
	return size > 0.0 ? most/size : most;
}

/* Scale of the forces. */
static double scale_of(const struct random_net *r)
{
	double least = INFINITY;

	for (int c = 0; c < r->net.cables; c++)
		least = fmin(least, r->cable[c].EA);
	return r->weight > 0.0 ? r->weight : 1e-6*least;
}

static void check(struct tally *tally, long number, const struct random_net *r,
                  const struct settings *settings)
{
	struct hawser_net_options main_one = {.method = settings->method};
	struct hawser_net_options second = {.method = "forces"};
	struct hawser_report report = {0};
	struct hawser_net_statics a, b;
	double size = 0.0, allowed, weight = scale_of(r);
	int slack = 0, wrong;

	tally->nets++;
	if (hawser_net_solve(&a, &r->net, &main_one, &report)) {
		printf("net %ld: %s\n", number, report.message);
		tally->failed++;
		return;
	}
	for (int c = 0; c < a.cables; c++) {
		slack |= a.member[c].slack > 0;
		size = fmax(size, a.member[c].T_max);
	}
	size = fmax(size, weight)*r->size; /* J */
	allowed = fmax(1e-10*weight, a.floor)*(1.0 + 1e-9);
	wrong = !(a.residual <= allowed) || !(a.gap <= 1e-8*size + 1e-300) || !isfinite(a.energy);
	tally->gap = fmax(tally->gap, size > 0.0 ? a.gap/size : 0.0);
	tally->slack += slack;
	tally->iterations += a.iterations;
	if (hawser_net_solve(&b, &r->net, &second, &report))
		tally->other++;
	else {
		double error = forces(&a, &b, weight);

		wrong |= !(error <= 1e-6 + 100.0*a.floor/weight);
		if (wrong)
			printf("net %ld: residual %.3g N, floor %.3g N, weight %.3g N, gap %.3g of %.3g J, "
			       "tensions differ by %.3g\n", number, a.residual, a.floor, weight, a.gap,
			       size, error);
		tally->force = fmax(tally->force, error);
		hawser_net_statics_clear(&b);
	}
	tally->wrong += wrong;
	hawser_net_statics_clear(&a);
}

static int read_settings(struct settings *settings, int argc, char **argv)
{
	int option;

	*settings = (struct settings){.nets = 1000, .only = -1, .seed = 1};
	while ((option = getopt(argc, argv, "n:o:s:m:w:")) != -1)
		switch (option) {
		case 'n': settings->nets = atol(optarg); break;
		case 'o': settings->only = atol(optarg); break;
		case 's': settings->seed = strtoull(optarg, NULL, 10); break;
		case 'm': settings->method = optarg; break;
		case 'w': settings->folder = optarg; break;
		default: return 1;
		}
	return 0;
}

static void show(const char *name, const struct tally *tally)
{
	printf("%-16s %7d nets, %6d with slack elements, %d failed, %d wrong; %.1f iterations, gap %.1e, "
	       "tensions %.1e (second method failed on %d)\n", name, tally->nets, tally->slack,
	       tally->failed, tally->wrong, (double)tally->iterations/fmax(tally->nets, 1.0), tally->gap,
	       tally->force, tally->other);
}

static void sum_up(struct tally *all, const struct tally *one)
{
	all->nets += one->nets;
	all->slack += one->slack;
	all->iterations += one->iterations;
	all->failed += one->failed;
	all->wrong += one->wrong;
	all->other += one->other;
	all->gap = fmax(all->gap, one->gap);
	all->force = fmax(all->force, one->force);
}

int main(int argc, char **argv)
{
	struct tally kind[3] = {{0}}, change[CHANGES] = {{0}}, all = {0};
	struct settings settings;
	double began = cpu_secs();

	if (read_settings(&settings, argc, argv)) {
		fprintf(stderr, "usage: net-random [-n NETS] [-o ONE] [-s SEED] [-m METHOD] [-w DIR]\n");
		return 1;
	}
	for (long i = 0; i < settings.nets; i++) {
		uint64_t state = settings.seed*1000003u + (uint64_t)i;
		struct tally one = {0};
		struct random_net r;
		int which, changes = 0;

		if (settings.only >= 0 && i != settings.only)
			continue;
		for (int j = 0; j < 4; j++)
			uniform(&state); /* seeds that follow one another begin alike */
		which = (int)(3.0*uniform(&state));
		for (int k = 0; k < CHANGES && i%2; k++)
			changes |= uniform(&state) < 0.25 ? 1 << k : 0;
		random_net(&r, &state, (enum random_kind)which);
		random_harder(&r, &state, (enum random_kind)which, changes);
		if (settings.folder) {
			if (write_scene(settings.folder, i, &r)) {
				perror(settings.folder);
				return 1;
			}
			continue;
		}
		check(&one, i, &r, &settings);
		sum_up(&kind[which], &one);
		for (int k = 0; k < CHANGES; k++)
			if (changes & 1 << k)
				sum_up(&change[k], &one);
		sum_up(&all, &one);
	}
	for (int k = 0; k < 3 && !settings.folder; k++)
		show(kind_name[k], &kind[k]);
	for (int k = 0; k < CHANGES && !settings.folder; k++)
		show(change_name[k], &change[k]);
	show("all", &all);
	printf("processor time %.1f s\n", cpu_secs() - began);
	return all.failed || all.wrong;
}
