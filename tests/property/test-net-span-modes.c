/* Modes of spans by their mesh against the spectral method, which shares no code: frequencies of order
 * 2 within the stated errors, the same planes, families and symmetries, shapes. B's Table 4.2: errors
 * 5.1e-4 with 25 elements and 3.3e-5 with 100.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_span.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { N = 8 };
static struct hawser_report report;

#define CABLE "cable: {EA: 100 MN, rho: 5.56 kg/m}\nspan: {d: 300 m, h: 15 m}\n"

static int solve(struct hawser_scene *scene, struct hawser_statics *statics,
                 struct hawser_modes *reference, int n, const char *text)
{
	const struct hawser_modes_options choice = {.n = n};
	enum hawser_status status = read_text(scene, text, NULL, &report);

	if (!status)
		status = hawser_statics_scene(statics, scene, &report);
	if (!status)
		status = hawser_modes_solve(reference, statics, &choice, &report);
	return ok(!status, "scene, statics, modes %s", report.message);
}

static void published(void)
{
	static const struct {
		int elements;
		double error, half;
	} known[] = {{25, 5.1e-4, 0.05e-4}, {100, 3.3e-5, 0.05e-5}};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes exact, mesh;

	if (!solve(&scene, &statics, &exact, 6, "cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 "
	           "m}\ntension: {T0: 80 kN}\n"))
		return;
	for (int i = 0; i < 2; i++) {
		double worst = 0.0;

		if (!ok(!hawser_net_span_modes(&mesh, &scene, &statics, 6, known[i].elements, &report),
		        "mesh %s", report.message))
			return;
		for (int k = 0; k < 6; k++)
			worst = fmax(worst, fabs(mesh.mode[k].omega/exact.mode[k].omega - 1.0));
		ok(fabs(worst - known[i].error) <= known[i].half, "B's Table 4.2, %d elements: %.3e",
		   known[i].elements, worst);
		hawser_modes_clear(&mesh);
	}
	hawser_modes_clear(&exact);
	hawser_scene_clear(&scene);
}

/* Largest error of a frequency, relative; counts what is labelled otherwise, errors above those that
 * are stated, and the largest error of a shape. */
struct found {
	double error, shape, stated;
	int labels, beyond;
};

static struct found against(const struct hawser_modes *mesh, const struct hawser_modes *exact)
{
	struct found found = {.error = 0.0};
	struct hawser_modes_error *error = calloc((size_t)mesh->n, sizeof *error);

	if (!error || !ok(!hawser_modes_compare(error, mesh, exact, &report), "compared %s",
	                  report.message))
		return found;
	for (int k = 0; k < mesh->n; k++) {
		const struct hawser_mode *a = &mesh->mode[k], *b = &exact->mode[error[k].partner];

		found.error = fmax(found.error, error[k].frequency);
		found.shape = fmax(found.shape, error[k].shape);
		found.stated = fmax(found.stated, a->residual);
		found.beyond += error[k].frequency > a->residual;
		found.labels += a->plane != b->plane || a->family != b->family ||
		                a->symmetry != b->symmetry || a->number != b->number;
	}
	free(error);
	return found;
}

static void converges(const char *what, const char *text)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes exact, mesh;
	struct found found[2];
	double order;

	if (!solve(&scene, &statics, &exact, N + 3, text))
		return;
	for (int i = 0; i < 2; i++) {
		if (!ok(!hawser_net_span_modes(&mesh, &scene, &statics, N, i ? 240 : 60, &report), "mesh %s",
		        report.message))
			return;
		found[i] = against(&mesh, &exact);
		hawser_modes_clear(&mesh);
	}
	order = log(found[0].error/found[1].error)/log(4.0);
	ok(fabs(order - 2.0) <= 0.1, "%s: order %.3f of frequencies (%.1e)", what, order, found[1].error);
	ok(found[0].labels == 0 && found[1].labels == 0, "the same planes, families and symmetries: but %d",
	   found[0].labels + found[1].labels);
	ok(found[0].beyond == 0 && found[1].beyond == 0, "errors within those stated (%.1e) but %d",
	   found[1].stated, found[0].beyond + found[1].beyond);
	ok(found[1].shape <= 1e-3, "shapes differ by %.1e", found[1].shape);
	hawser_modes_clear(&exact);
	hawser_scene_clear(&scene);
}

CASE(property_net_span_modes)
{
	published();
	converges("T0", CABLE "tension: {T0: 80 kN}\n");
	converges("deep", CABLE "tension: {sag: 47.5 m}\n");
	converges("stiff, steep", "cable: {EA: 400 MN, rho: 1.2}\nspan: {d: 100 m, h: 170 m}\ntension: "
	          "{H: 41.7 kN}\n");
	converges("ice", CABLE "tension: {H: 41.7 kN}\nload: {static: {per_length: [0, -13, 0], mass: "
	          "1.3}}\n"
	          "attach: [{at: 0.3127, mass: 210 kg}]\n");
	converges("wind", CABLE "tension: {H: 41.7 kN}\nload: {static: {per_length: [2, 0, 31]}}\n");
	converges("masses", CABLE "tension: {T0: 80 kN}\nattach: [{at: 0.3127, mass: 210 kg}, {at: 0.71, "
	          "mass: 90 kg}]\n");
	converges("a force across", CABLE "tension: {length0: 305 m}\nattach: [{at: 0.3127, mass: 210 kg, "
	          "force: [-310, 700, 1100]}]\n");
	return done_testing();
}
