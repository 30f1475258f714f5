/* beam/scale.c - the scaled beam of a scene.
 *
 * The unit of length is L. The unit of time is L^2 sqrt(rhoA/EI) for a scene with mu, D (8.3.1),
 * and L sqrt(rhoA/T) for a scene with theta, D (9.3.1). A beam in SI is scaled by its tension
 * too, so that the string is the special case theta = 0.
 *
 *   mu:     theta = 1, tension = mu^2, weight = rho, drag = c, rotary = 1/slenderness^2, speed = v
 *   theta:  tension = 1, weight = rho, drag = c, rotary = slenderness^2, speed = v
 *   SI:     theta = EI/(T L^2), tension = 1, weight = rhoA g sin(inclination) L/T,
 *           drag = drag L/sqrt(rhoA T), rotary = (gyration/L)^2, speed = speed sqrt(rhoA/T)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/beam.h>

#include "core/report.h"

/* Sine of the angle of the travel above the horizontal; exact where the scene names the
 * direction. */
static double rise_of(const struct hawser_scene *scene)
{
	if (scene->beam.weight == HAWSER_WEIGHT_INCLINATION)
		return sin(scene->beam.inclination);
	return scene->beam.gravity == HAWSER_GRAVITY_ALONG ? 1.0 : 0.0;
}

static double across_of(const struct hawser_scene *scene)
{
	if (scene->beam.weight == HAWSER_WEIGHT_INCLINATION)
		return cos(scene->beam.inclination);
	return scene->beam.gravity == HAWSER_GRAVITY_ACROSS ? 1.0 : 0.0;
}

static void from_si(struct hawser_beam *beam, const struct hawser_scene *scene)
{
	double T = scene->beam.tension_end, L = scene->beam.L, rhoA = scene->beam.rhoA;
	double weight = rhoA*scene->g*L/T;

	beam->theta = scene->beam.EI/(T*L*L);
	beam->tension = 1.0;
	beam->weight = weight*rise_of(scene);
	beam->across = weight*across_of(scene);
	beam->drag = scene->beam.drag*L/sqrt(rhoA*T);
	beam->rotary = scene->beam.gyration*scene->beam.gyration/(L*L);
	beam->speed = scene->beam.speed*sqrt(rhoA/T);
	beam->length = L;
	beam->time = L*sqrt(rhoA/T);
}

static enum hawser_status refuse_slack(const struct hawser_beam *beam, struct hawser_report *report)
{
	double least = hawser_beam_least_tension(beam);

	if (beam->theta > 0.0 || least > 0.0)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "beam",
	                    "the tension at the lower end is %.6g of that at the upper: a string cannot "
	                    "carry that; raise the tension, or give a bending rigidity",
	                    least/beam->tension);
}

enum hawser_status hawser_beam_scene(struct hawser_beam *beam, const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	double slenderness = scene->beam.slenderness;

	*beam = (struct hawser_beam){.ends = (enum hawser_beam_ends)scene->beam.ends,
	                             .moment = (enum hawser_beam_moment)scene->beam.moment};
	if (scene->beam.form == HAWSER_BEAM_NONE)
		return hawser__fail(report, HAWSER_ERR_SCENE, "beam",
		                    "this scene is of a cable: hawser beam takes one with a section beam "
		                    "(man hawser-scene)");
	if (scene->beam.form == HAWSER_BEAM_EI) {
		from_si(beam, scene);
	} else {
		int mu = scene->beam.form == HAWSER_BEAM_MU;

		beam->theta = mu ? 1.0 : scene->beam.theta;
		beam->tension = mu ? scene->beam.mu*scene->beam.mu : 1.0;
		beam->weight = scene->beam.rho;
		beam->drag = scene->beam.c;
		beam->rotary = mu && slenderness > 0.0 ? 1.0/(slenderness*slenderness)
		                                       : slenderness*slenderness;
		beam->speed = scene->beam.v;
	}
	return refuse_slack(beam, report);
}

double hawser_beam_least_tension(const struct hawser_beam *beam)
{
	return beam->tension - fmax(beam->weight, 0.0);
}
