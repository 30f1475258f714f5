/* Spans as nets (hawser/net_span.h): the mesh converges to the exact catenary at order 2, whatever
 * gives the tension, with static loads, temperature, masses and forces; the work of its nodal loads
 * on the modes converges to the forces of the reduced model, which integrates on the grid of modes.
 * Errors of B's Table 4.3, line 2, from an independent prototype: positions 1.949e-3 m with 40
 * elements and 1.218e-4 m with 160, H 2.523e-4 and 1.577e-5 too low.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/net_span.h>
#include <hawser/rom.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static struct hawser_report report;

#define CABLE "cable: {EA: 100 MN, rho: 5.56 kg/m}\nspan: {d: 300 m, h: 15 m}\n"

static int solve(struct hawser_scene *scene, struct hawser_statics *statics, const char *text)
{
	enum hawser_status status = read_text(scene, text, NULL, &report);

	if (!status)
		status = hawser_statics_scene(statics, scene, &report);
	return ok(!status, "a scene is read and solved %s", report.message);
}

/* Errors of the mesh: largest component of the distance of a node from the catenary, and of the
 * force at end A. */
struct error {
	double place, force;
};

static struct error mesh_error(const struct hawser_scene *scene, const struct hawser_statics *statics,
                               int elements)
{
	const struct hawser_net_span_options options = {.elements = elements, .still = 1};
	struct error error = {0.0, 0.0};
	struct hawser_net net;
	struct hawser_net_statics mesh = {0};
	double from = 0.0, reaction = 0.0;

	if (!ok(!hawser_net_span(&net, scene, statics, &options, &report) &&
	        !hawser_net_solve(&mesh, &net, NULL, &report), "%d elements %s", elements, report.message))
		return (struct error){NAN, NAN};
	for (int i = 0; i < mesh.points; i++) {
		const struct hawser_net_point *p = &mesh.point[i];
		struct hawser_profile_point at;
		double x[3], far = 0.0;

		if (i > 0 && p->cable != mesh.point[i - 1].cable)
			from += net.cable[p->cable - 1].value;
		at = hawser_statics_at(statics, fmin(from + p->S, statics->length0));
		hawser_statics_to_global(statics, x, (double[3]){at.x, at.y, at.z});
		for (int k = 0; k < 3; k++)
			far = fmax(far, fabs(p->x[k] - x[k]));
		error.place = fmax(error.place, far);
	}
	for (int k = 0; k < 3; k++)
		reaction += mesh.reaction[0][k]*mesh.reaction[0][k];
	error.force = sqrt(reaction)/statics->T0 - 1.0;
	hawser_net_statics_clear(&mesh);
	hawser_net_clear(&net);
	return error;
}

static void converges(const char *what, const char *text)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct error coarse, fine;
	double order, of_force;

	if (!solve(&scene, &statics, text))
		return;
	coarse = mesh_error(&scene, &statics, 60);
	fine = mesh_error(&scene, &statics, 240);
	order = log(coarse.place/fine.place)/log(4.0);
	of_force = log(coarse.force/fine.force)/log(4.0);
	ok(fabs(order - 2.0) <= 0.02 && fabs(of_force - 2.0) <= 0.02,
	   "%s: order %.3f of positions (%.1e m), %.3f of T0 (%.1e)", what, order, fine.place, of_force,
	   fine.force);
	hawser_scene_clear(&scene);
}

static void published(void)
{
	static const struct {
		int elements;
		double place, H;
	} known[] = {{40, 1.949e-3, -2.523e-4}, {160, 1.218e-4, -1.577e-5}};
	struct hawser_scene scene;
	struct hawser_statics statics;

	if (!solve(&scene, &statics, CABLE "tension: {T0: 80 kN}\n"))
		return;
	for (int i = 0; i < 2; i++) {
		const struct hawser_net_span_options options = {.elements = known[i].elements, .still = 1};
		struct hawser_net net;
		struct hawser_net_statics mesh;

		close_to(mesh_error(&scene, &statics, known[i].elements).place, known[i].place, 5e-4,
		         "positions");
		if (!ok(!hawser_net_span(&net, &scene, &statics, &options, &report) &&
		        !hawser_net_solve(&mesh, &net, NULL, &report), "mesh %s", report.message))
			return;
		close_to(-mesh.reaction[0][0]/statics.H - 1.0, known[i].H, 5e-4, "H");
		hawser_net_statics_clear(&mesh);
		hawser_net_clear(&net);
	}
	hawser_scene_clear(&scene);
}

/* Work of the loads of one harmonic of the net on mode j over H: the force of the model. */
static double work(const struct hawser_net *net, const struct hawser_modes *modes, int j, double Omega,
                   double phase)
{
	double sum = 0.0, from = 0.0;

	for (int c = 0; c < net->cables; c++) {
		const struct hawser_net_cable *cable = &net->cable[c];

		for (int i = 0; i < net->loads; i++) {
			const struct hawser_net_load *load = &net->load[i];

			if (load->cable != c || !load->along || load->Omega != Omega ||
			    fabs(load->phase - phase) > 1e-9)
				continue;
			for (int e = 0; e <= cable->elements; e++) {
				double s = fmin((from + cable->value*e/cable->elements)/modes->statics.span.d,
				                modes->statics.l), phi[3], u[3];
				struct hawser_frame_point at = hawser_statics_frame(&modes->statics, s);

				hawser_modes_at(modes, phi, NULL, j, s);
				for (int k = 0; k < 3; k++)
					u[k] = phi[0]*at.axis[0][k] + phi[1]*at.axis[1][k] + phi[2]*at.axis[2][k];
				hawser_statics_to_global(&modes->statics, u, u);
				for (int k = 0; k < 3; k++)
					sum += load->along[e][k]*u[k];
			}
		}
		from += cable->value;
	}
	return sum/modes->statics.H;
}

static double load_error(const struct hawser_scene *scene, const struct hawser_modes *modes,
                         const struct hawser_rom *rom, int elements)
{
	const struct hawser_net_span_options options = {.elements = elements, .Omega = 1.7};
	struct hawser_net net;
	double worst = 0.0, most = 0.0;

	if (!ok(!hawser_net_span(&net, scene, &modes->statics, &options, &report), "loads %s",
	        report.message))
		return NAN;
	/* harmonics of the load; those with a power of it are products */
	for (int h = 0; h < rom->harmonics && rom->harmonic[h].load_power == 0; h++)
		for (int j = 0; j < rom->n; j++) {
			double got = work(&net, modes, j, rom->harmonic[h].k*options.Omega,
			                  rom->harmonic[h].phase == HAWSER_SIN ? -M_PI/2.0 : 0.0);

			worst = fmax(worst, fabs(got - rom->harmonic[h].f[j]));
			most = fmax(most, fabs(rom->harmonic[h].f[j]));
		}
	hawser_net_clear(&net);
	return worst/most;
}

static void loads(const char *what, const char *text, int odd)
{
	const struct hawser_modes_options choice = {.n = 5};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {0};
	struct hawser_rom rom = {0};
	double coarse, fine, order;

	if (!solve(&scene, &statics, text) ||
	    !ok(!hawser_modes_solve(&modes, &statics, &choice, &report) &&
	        !hawser_rom_build_linear(&rom, &modes, &scene, &report), "modes %s", report.message))
		return;
	coarse = load_error(&scene, &modes, &rom, 60);
	fine = load_error(&scene, &modes, &rom, 240);
	order = log(coarse/fine)/log(4.0);
	/* where a load ends within an element, the constant of the order depends on where */
	ok(fabs(order - 2.0) <= (odd ? 0.25 : 0.02), "%s: %d harmonics, order %.3f (%.1e)", what,
	   rom.harmonics, order, fine);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* What is refused: a load without its frequency, and keys without counterpart. */
static void refused(const char *what, const char *text, int still, const char *message)
{
	const struct hawser_net_span_options options = {.still = still};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_net net;
	enum hawser_status status;

	if (!solve(&scene, &statics, text))
		return;
	status = hawser_net_span(&net, &scene, &statics, &options, &report);
	ok(status && strcmp(report.message, message) == 0 && !net.node && !net.name, "%s: %s", what,
	   report.message);
	hawser_scene_clear(&scene);
}

CASE(property_net_span)
{
	refused("no frequency", CABLE "tension: {T0: 80 kN}\nload: {frame: local, per_length: [0, 1, 0]}\n",
	        0, "s.yaml: the load or the motion of the ends needs a positive frequency Omega");
	refused("a damper to a deck", CABLE "tension: {T0: 80 kN}\nattach: [{at: 0.5, damper: [0, 9, 0], "
	        "damper_to: A}]\n", 1, "s.yaml: attach.0.damper_to: dampers of a mesh of cable elements "
	        "are to the ground, and its absorbers linear");
	published();
	converges("H", CABLE "tension: {H: 41.7 kN}\n");
	converges("T1", CABLE "tension: {T1: 63 kN}\n");
	converges("length0", CABLE "tension: {length0: 311.3 m}\n");
	converges("sag", CABLE "tension: {sag: 47.5 m}\n");
	converges("slack branch", CABLE "tension: {T0: 12 kN, branch: slack}\n");
	converges("wind, ice and heat", CABLE "tension: {H: 41.7 kN}\ntemperature: {change: 41, expansion: "
	          "1.2e-5}\nload: {static: {per_length: [2.5, -1.5, 31], mass: 1.3}}\n");
	converges("masses", CABLE "tension: {T0: 80 kN}\nattach: [{at: 0.3127, mass: 210 kg}, {at: 0.7, "
	          "force: [0, -900, 0]}]\n");
	converges("a force across", CABLE "tension: {length0: 305 m}\nattach: [{at: 0.3127, mass: 210 kg, "
	          "force: [-310, 700, 1100]}]\n");
	loads("global load", CABLE "tension: {T0: 80 kN}\n"
	      "load: {frame: global, per_length: [0.8, 0.5, 0.3]}\n", 0);
	loads("local load", CABLE "tension: {sag: 47.5 m}\n"
	      "load: {frame: local, per_length: [0.8, 0.5, 0.3]}\n", 0);
	loads("waves, parts and points", CABLE "tension: {sag: 47.5 m}\nloads:\n  - {frame: local, "
	      "per_length: [0, 0.5, 0.3], from: 0.2127, to: 201.3 m, phase: 0.7}\n  - {frame: local, "
	      "harmonic: 2, "
	      "per_length: [0.1, 0.5, 0.3], wave: -71 m}\n  - {frame: global, harmonic: 3, force: "
	      "[11, 0, 23], at: 0.377, phase: 1.1}\n", 1);
	loads("in a turned plane", CABLE "tension: {H: 41.7 kN}\nload: {frame: local, "
	      "per_length: [0.2, 0.5, 0.3], static: {per_length: [0, 0, 31]}}\n", 0);
	return done_testing();
}
