/* study/plan/decide.c - which effects a scene's models include, which they omit, and why: the
 * texts of a plan. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/terms/dampers.h"
#include "rom/terms/load.h"
#include "statics/wind.h"
#include "study/accuracy/survey.h"

enum { most_decisions = 32 };

static void decide(struct hawser_plan *plan, const char *subject, int modelled, const char *format, ...)
	HAWSER_PRINTF(4, 5);

static void decide(struct hawser_plan *plan, const char *subject, int modelled, const char *format, ...)
{
	struct hawser_plan_decision *decision = &plan->decision[plan->decisions++];
	va_list args;

	decision->subject = subject;
	decision->modelled = modelled;
	va_start(args, format);
	vsnprintf(decision->why, sizeof decision->why, format, args);
	va_end(args);
}

/* Number of modes kept in a plane; *driven becomes the number of those that the load drives. */
static int count(int *driven, const struct hawser_plan *plan, enum hawser_plane plane)
{
	int found = 0;
	double most = 0.0;

	*driven = 0;
	for (int j = 0; j < plan->modes.n; j++)
		most = fmax(most, fabs(plan->load[j]));
	for (int j = 0; j < plan->modes.n; j++)
		if (plan->mode[j].kept && plan->modes.mode[j].plane == plane) {
			found++;
			*driven += most > 0.0 && fabs(plan->load[j]) > 1e-12*most;
		}
	return found;
}

static void decide_planes(struct hawser_plan *plan)
{
	int in_driven, out_driven;
	int in = count(&in_driven, plan, HAWSER_IN_PLANE);
	int out = count(&out_driven, plan, HAWSER_OUT_OF_PLANE), n = in + out;

	decide(plan, "motion in the plane", in > 0, "%d of the scene's %d modes; the load drives %d of "
	    "them", in, n, in_driven);
	if (out == 0)
		decide(plan, "motion out of the plane", 0, "none of the scene's %d modes", n);
	else if (out_driven > 0)
		decide(plan, "motion out of the plane", 1, "%d of the scene's %d modes; the load drives %d "
		    "of them", out, n, out_driven);
	else
		decide(plan, "motion out of the plane", 1, "%d of the scene's %d modes; nothing drives them "
		    "directly, but the motion in the plane can make them unstable", out, n);
}

static void decide_inertia(struct hawser_plan *plan, const struct hawser_rom_inertia *inertia)
{
	const char *subject = "inertia of what follows";

	if (inertia->shapes > 0)
		decide(plan, subject, 1, "%d second-order shapes as coordinates: without them the scene's "
		    "model has resonances too high by up to %.1g of their frequency, with them %.1g",
		    inertia->shapes, inertia->shift, inertia->left);
	else
		decide(plan, subject, 0, "it moves resonances of the scene's model by %.1g of their "
		    "frequency", inertia->shift);
}

static void decide_rest(struct hawser_plan *plan, const struct hawser_scene *scene,
                     const struct hawser_rom_inertia *inertia)
{
	int beyond = 0;

	for (int j = 0; j < plan->modes.n; j++)
		beyond += plan->modes.mode[j].family == HAWSER_LONGITUDINAL;
	if (scene->model.condense == HAWSER_CONDENSE_STATIC)
		decide(plan, "modes that are not kept", 1, "they respond statically to the kept ones "
		    "(model.condense: static): one linear solve a pair of kept modes");
	else
		decide(plan, "modes that are not kept", 0, "they are at rest (model.condense: none), which "
		    "makes the cable too stiff: see the errors of the raw fidelities");
	if (scene->model.condense == HAWSER_CONDENSE_STATIC && hawser__loaded(scene) &&
	    !scene->travel.present && scene->model.inertia == HAWSER_INERTIA_AUTO)
		decide_inertia(plan, inertia);
	decide(plan, "longitudinal modes as coordinates", beyond > 0, "%d of the %d lowest modes move "
	    "mostly along the cable%s", beyond, plan->modes.n, beyond > 0 ? "" : ": such modes are far "
	    "above the range and respond statically");
}

static void decide_loads(struct hawser_plan *plan, const struct hawser_scene *scene)
{
	int points = 0, waves = 0, top = 1;

	for (int i = 0; i < scene->loads; i++) {
		const struct hawser_load_piece *piece = &scene->piece[i];

		points += piece->force[0] != 0.0 || piece->force[1] != 0.0 || piece->force[2] != 0.0;
		waves += piece->wave != 0.0;
		top = piece->harmonic > top ? piece->harmonic : top;
	}
	decide(plan, "list of loads", 1, "%d: %d along the cable, %d of these a wave; %d at a point; "
	    "multiples of Omega up to %d. Modes that are not kept %s", scene->loads,
	    scene->loads - points, waves, points, top,
	    scene->model.condense == HAWSER_CONDENSE_STATIC
	    ? "answer statically, with the kinks at points" : "do not answer: the model lacks the kinks "
	      "at points");
}

static void decide_load(struct hawser_plan *plan, const struct hawser_scene *scene)
{
	static const char *const axes[] = {"e, n, z", "x, y, z"};

	if (scene->travel.braking > 0.0)
		decide(plan, "braking", 1, "to %g m/s within %g s, for hawser integrate; no response "
		    "repeats itself", scene->travel.final, scene->travel.braking);
	if (scene->travel.fluctuation > 0.0)
		decide(plan, "harmonics of the speed", 1, "sin(Omega t) and its rate on loads, damping and "
		    "stiffness, cos(2 Omega t) on loads and stiffness: %g m/s about %g m/s",
		    scene->travel.fluctuation, scene->travel.speed);
	if (!hawser__scene_driven(scene)) {
		decide(plan, "forced response", 0, "nothing excites the cable again and again%s",
		    scene->wind.present ? " but the wind: hawser frf --over wind.speed=A:B follows equilibria "
		                          "and limit cycles"
		                        : ": statics, modes and the model can be had, hawser frf cannot");
		return;
	}
	if (scene->load.present)
		decide(plan, "harmonics of the load", 1, "one: cos(Omega t), along %s, on the part from "
		    "%g to %g of the cable", axes[scene->load.frame == HAWSER_FRAME_GLOBAL],
		    scene->load.extent[0], scene->load.extent[1]);
	if (scene->loads > 0)
		decide_loads(plan, scene);
	if (hawser__support_moves(scene))
		decide(plan, "motion of the supports", 1, "forces and stiffness at multiples of Omega "
		    "of the motion, sums and differences up to degree three, and constants; exact to the "
		    "order of the energy. Left out: second-order displacement of condensed modes by the "
		    "motion; mode choice (auto)");
	decide(plan, "Floquet multipliers", 1, "at every point of a traced response, for its stability "
	    "and its bifurcations; not for multiple scales");
}

static void decide_static_load(struct hawser_plan *plan, const struct hawser_scene *scene)
{
	const struct hawser_statics *st = &plan->modes.statics;
	int still = scene->tension.state == HAWSER_STATE_LOADED;

	if (scene->static_load.present || scene->wind.present)
		decide(plan, "static load", 1, "%.4g N/m with the weight, %.4g kg/m in motion; the plane of "
		    "the cable, to which \"in the plane\" refers, swings by %.3g rad",
		    hawser_statics_actual(st).span.rho*st->span.g,
		    scene->cable.rho + scene->static_load.mass, st->turned ? st->swing : 0.0);
	if (scene->static_load.present || scene->wind.present || scene->temperature.present)
		decide(plan, "given tension", 1, "that of the %s state (tension.state), with the length of "
		    "cable of %s state%s", still ? "loaded" : "reference", still ? "this" : "that",
		    scene->temperature.present ? ", changed by the temperature" : "");
}

static enum hawser_status decide_wind(struct hawser_plan *plan, const struct hawser_survey *survey,
                                      struct hawser_report *report)
{
	char text[HAWSER__GALLOPS][HAWSER__GALLOP_TEXT];
	const struct hawser_wind *wind = &survey->scene->wind;
	double force[3];
	int count = 0;
	enum hawser_status status;

	if (wind->present && wind->wake.present)
		decide(plan, "vortices", 1, "an oscillator %s, a coordinate each, at %.4g Hz behind a cable at "
		    "rest", wind->wake.places ? "at each of the places" : "for each mode that moves across the "
		    "flow", wind->wake.strouhal*wind->speed/wind->diameter);
	if (!wind->present || wind->wake.present || !hawser__static_load(force, survey->scene))
		return HAWSER_OK;
	decide(plan, "wind", 1, "quasi-steady drag and lift of %g m/s, %s in the velocity of the cable "
	    "(wind.form); at rest, with load.static, %.4g, %.4g and %.4g N/m along x, y and z; sections do "
	    "not turn, modes that are not kept do not feel it", wind->speed,
	    wind->form == HAWSER_WIND_EXACT ? "exact" : "of third order", force[0], force[1], force[2]);
	status = hawser__plan_gallop(text, &count, survey, report);
	for (int i = 0; !status && i < count; i++)
		decide(plan, "galloping", 1, "%s", text[i]);
	return status;
}

/* Of each kind the number of attachments that have it. */
static void decide_attachments(struct hawser_plan *plan)
{
	const struct hawser_statics *st = &plan->modes.statics;
	int masses = 0, springs = 0, dampers = 0;
	double mass = 0.0;

	for (int i = 0; i < st->attachments; i++) {
		const struct hawser_attached *at = &st->attached[i];

		masses += at->mass > 0.0;
		mass += at->mass;
		springs += fmax(at->spring[0], fmax(at->spring[1], at->spring[2])) > 0.0;
		dampers += fmax(at->damper[0], fmax(at->damper[1], at->damper[2])) > 0.0;
	}
	if (masses > 0)
		decide(plan, "point masses", 1, "%d, together %.3g of the mass of the cable: the profile and "
		    "the modes have kinks there, and no coordinates are added", masses,
		    mass/(st->span.rho*st->length0));
	if (springs > 0)
		decide(plan, "springs to ground", 1, "at %d point%s, in the modes: no coordinates are added",
		    springs, springs == 1 ? "" : "s");
	if (dampers > 0)
		decide(plan, "dampers", 1, "at %d point%s: the static shape of each force of a "
		    "damper is a coordinate besides the modes (not in the errors below), and the damping "
		    "couples the modes; modes cannot be chosen (auto)", dampers, dampers == 1 ? "" : "s");
}

static void decide_damping(struct hawser_plan *plan, const struct hawser_scene *scene)
{
	int dampers = hawser__has_dampers(&plan->modes.statics);

	if (scene->damping.kind != HAWSER_DAMPING_NONE)
		decide(plan, "damping", 1, dampers ? "as the scene says, and that of the dampers"
		                                   : "as the scene says, diagonal in the modes");
	else
		decide(plan, "damping", dampers, dampers ? "of the dampers alone"
		                                         : "the scene has none: resonances have no height");
}

static void decide_always(struct hawser_plan *plan, const struct hawser_scene *scene)
{
	const struct hawser_motion *motion = &plan->modes.statics.motion;

	decide(plan, "static profile", 1, "elastic catenary; sag over distance %.3g, Irvine's parameter "
	    "%.3g", plan->modes.statics.sag/plan->modes.statics.span.d, plan->modes.statics.irvine);
	decide(plan, "quadratic and cubic terms", hawser__scene_driven(scene), hawser__scene_driven(scene)
	    ? "from the exact strain energy to the fourth order, for response and integration; "
	      "statics and modes do without"
	    : "no response is asked for; hawser rom builds them");
	decide_damping(plan, scene);
	if (motion->nu != 0.0)
		decide(plan, "gyroscopic terms", 1, "the cable travels at %g m/s, %.3g of the speed of its "
		    "transverse waves (scaled): they couple all modes of a plane; of modes that are not "
		    "kept they are neglected", motion->speed, motion->nu);
	else
		decide(plan, "gyroscopic terms", 0, "the cable %s", motion->swing > 0.0
		    ? "has no mean speed: only those of its fluctuation" : "is at rest: it does not travel");
	decide(plan, "bending, torsion, slackness", scene->cable.EI > 0.0, scene->cable.EI > 0.0
	    ? "cable.EI, quadratic in the displacement, in modes and condensed motion; no torsion, and a "
	      "negative tension is compression"
	    : "perfectly flexible; a negative tension is compression");
}

/* What hawser frf answers by default (own.c). */
static void decide_response(struct hawser_plan *plan, const struct hawser_survey *survey)
{
	const struct hawser_accuracy_fixed *fixed = &survey->fixed;

	if (isnan(fixed->estimated))
		return;
	decide(plan, "exact energy in a response", survey->instead == HAWSER__INSTEAD ||
	    survey->instead == HAWSER__PARTLY, "the scene's modes "
	    "are off by %s%.2g, of which %s%.2g with any number of modes, in the resonances below%s",
	    fixed->estimated < 1.0 ? "about " : "more than ", fixed->estimated,
	    fixed->truncation < 1.0 ? "" : "more than ", fmin(fixed->truncation, 1.0),
	    survey->instead == HAWSER__INSTEAD ? ": hawser frf takes full-order models" :
	    survey->instead == HAWSER__PARTLY ? ": hawser frf takes full-order models for as much of the "
	                                        "range as they cover in a bearable time" :
	    survey->instead == HAWSER__TOO_LONG ? "; full-order models take more time than is spent unasked"
	    : survey->instead == HAWSER__NO_BASIS ? "; the range reaches modes that need a larger "
	                                            "basis than is tried unasked" : "");
}

enum hawser_status hawser__decide(struct hawser_plan *plan, const struct hawser_survey *survey,
                                  struct hawser_report *report)
{
	const struct hawser_scene *scene = survey->scene;
	enum hawser_status status;

	plan->decision = calloc(most_decisions, sizeof *plan->decision);
	if (!plan->decision)
		return hawser__no_memory(report, "plan");
	decide_planes(plan);
	decide_rest(plan, scene, &survey->inertia);
	decide_load(plan, scene);
	decide_static_load(plan, scene);
	status = decide_wind(plan, survey, report);
	decide_attachments(plan);
	decide_always(plan, scene);
	if (*survey->range)
		decide(plan, "range of the scene's model", 1, "force, inertia and damping are right within "
		    "%.0f %% up to %s", 100.0*HAWSER_LAW_LIMIT, survey->range);
	if (*survey->forces)
		decide(plan, "forces from strains", strncmp(survey->forces, "from strains", 12) == 0, "%s",
		    survey->forces);
	decide_response(plan, survey);
	return status;
}
