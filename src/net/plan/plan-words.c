/* net/plan/plan-words.c - what the model of a net contains, what it leaves out and why; warnings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "net/motion/motion.h"
#include "net/plan/plan.h"

enum { DECISIONS = 24, WARNINGS = 24, NAMES = 4 };
/* Strain beyond which the linear law of a cable is doubtful; error of the mesh over the sag that a
 * drawing shows; weight over tension below which a cable is as good as weightless. */
static const double STRAIN = 0.1, COARSE = 0.01, LIGHT = 1e-6;
/* Elements in a wave that the mesh must have; distance of a load from a mode, relative. */
static const double RESOLVED = 10.0, NEAR = 0.03;
/* Loads across the plane of the supports, over the weight, that turn the cables by a quarter of a right
 * angle. */
static const double ACROSS = 0.4;

static void say(struct hawser__net_planner *planner, const char *subject, int modelled,
                const char *format, ...) HAWSER_PRINTF(4, 5);
static void say(struct hawser__net_planner *planner, const char *subject, int modelled,
                const char *format, ...)
{
	struct hawser_net_plan *plan = planner->plan;
	va_list args;

	if (plan->decisions == DECISIONS)
		return;
	plan->decision[plan->decisions].subject = subject;
	plan->decision[plan->decisions].modelled = modelled;
	va_start(args, format);
	vsnprintf(plan->decision[plan->decisions++].why, sizeof plan->decision->why, format, args);
	va_end(args);
}

static void warn(struct hawser__net_planner *planner, const char *format, ...) HAWSER_PRINTF(2, 3);
static void warn(struct hawser__net_planner *planner, const char *format, ...)
{
	struct hawser_net_plan *plan = planner->plan;
	va_list args;

	if (plan->warnings == WARNINGS)
		return;
	va_start(args, format);
	vsnprintf(plan->warning[plan->warnings++], HAWSER_NET_WARNING, format, args);
	va_end(args);
}

/* Names of cables with a property, the first ones; returns the number of all. */
typedef int property(const struct hawser__net_planner *planner, int cable);

static int list(char *names, size_t size, const struct hawser__net_planner *planner, property *has)
{
	int count = 0;

	*names = '\0';
	for (int c = 0; c < planner->plan->cables; c++)
		if (has(planner, c) && count++ < NAMES)
			hawser__append(names, size, ", ", "%s", planner->net->cable[c].name);
	if (count > NAMES)
		hawser__append(names, size, " ", "and %d more", count - NAMES);
	return count;
}

static int slack(const struct hawser__net_planner *planner, int c)
{
	return planner->plan->cable[c].slack > 0;
}

static int strained(const struct hawser__net_planner *planner, int c)
{
	return planner->plan->cable[c].strain > STRAIN;
}

static int coarse(const struct hawser__net_planner *planner, int c)
{
	const struct hawser_net_plan_cable *cable = &planner->plan->cable[c];

	return cable->error > COARSE*cable->reach;
}

static int light(const struct hawser__net_planner *planner, int c)
{
	const struct hawser_net_plan_cable *cable = &planner->plan->cable[c];

	return planner->net->cable[c].rho*planner->net->g*cable->length0 <= LIGHT*cable->T_max;
}

static int massless(const struct hawser__net_planner *planner, int c)
{
	return planner->net->cable[c].rho == 0.0 && planner->net->cable[c].elements > 1;
}

static void directions(struct hawser__net_planner *planner)
{
	const struct hawser_net_plan *plan = planner->plan;
	double normal[3];
	/* obstacles have directions of their own: with them the axes alone count */
	int left = 0, plane = planner->net->surfaces ? 0 : hawser__net_plane(normal, planner->net);
	char axes[8] = "";

	for (int k = 0; k < 3; k++)
		if (planner->still[k]) {
			left++;
			hawser__append(axes, sizeof axes, ", ", "%c", "xyz"[k]);
		}
	if (left == 0 && plane != 1) {
		say(planner, "motion along x, y and z", 1, planner->net->surfaces
		    ? "supports, loads and obstacles leave no axis out"
		    : "supports and loads are in no common vertical plane");
		return;
	}
	say(planner, "motion in the plane", 1, "all supports and loads are %s", plane == 2
	    ? "on a vertical line" : "in one vertical plane");
	if (left > 0)
		say(planner, "motion out of the plane", 0, "nothing drives it: integrate builds no "
		    "unknowns along %s, %d instead of %d; it cannot begin by itself, but a parametric "
		    "resonance would need a first push", axes, plan->unknowns/3*(3 - left), plan->unknowns);
	else
		say(planner, "motion out of the plane", 1, "nothing drives it, but the plane (normal %.3g, "
		    "0, %.3g) is not along an axis: turn the axes of the scene, and a third of the "
		    "unknowns is left out",
		    normal[0], normal[2]);
}

static void law(struct hawser__net_planner *planner)
{
	char names[160];
	int count = list(names, sizeof names, planner, slack);

	if (!planner->st.x)
		say(planner, "slack members", 1, "which ones: the statics say");
	else if (count)
		say(planner, "slack members", 1, "%d of %d cables have slack elements in the equilibrium (%s): "
		    "these have no stiffness", count, planner->plan->cables, names);
	else
		say(planner, "slack members", 1, "none in the equilibrium; in motion elements become slack and "
		    "taut");
	say(planner, "compression", 0, "cables carry tension only: T = EA max(strain, 0)");
	say(planner, "bending, torsion", 0, "perfectly flexible; EI is no key of nets");
	say(planner, "stretching", 1, "linear law, whatever the rotation");
}

static int of_models(const struct hawser_net *net)
{
	return net->ratio > 0.0 || net->mass_rate > 0.0;
}

static void mass(struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	int points = 0;

	for (int i = 0; i < net->nodes; i++)
		points += net->node[i].mass > 0.0;
	say(planner, "mass", 1, "mean of the consistent and the lumped matrix%s", points
	    ? ", and point masses" : "");
	if (planner->plan->axial > 0.0)
		say(planner, "axial waves", 1, "up to %.3g rad/s in this mesh; steps need not follow them "
		    "(implicit schemes)", planner->plan->axial);
	if (net->alpha > 0.0 || net->axial > 0.0)
		say(planner, "damping", 1, "%s%s%s", net->alpha > 0.0 ? "viscous (alpha)" : "",
		    net->alpha > 0.0 &&
		    net->axial > 0.0 ? " and " : "", net->axial > 0.0 ? "Kelvin-Voigt (axial)" : "");
	else if (net->water.density > 0.0)
		say(planner, "damping", 1, "the drag of the %s, in integrate%s", net->winds ? "wind" : "water",
		    net->surfaces ? "" : " and models");
	else if (!of_models(net))
		say(planner, "damping", 0, "the scene has none: motions do not decay");
	if (of_models(net))
		say(planner, "damping of modes", 1, "ratio or rayleigh, in reduced models alone (frf, "
		    "integrate -n): integrate of the mesh needs alpha or axial");
}

static void driving(struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	int harmonic = 0, tables = 0;

	for (int i = 0; i < net->loads; i++)
		harmonic += net->load[i].harmonic;
	for (int i = 0; i < net->nodes; i++)
		tables += net->node[i].table != NULL;
	if (net->loads > harmonic)
		say(planner, "constant loads", 1, "%d, in the equilibrium", net->loads - harmonic);
	if (harmonic)
		say(planner, "harmonic loads", 1, "%d, in integrate and in reduced models; not in statics and "
		    "modes", harmonic);
	if (net->motions + tables)
		say(planner, "moving supports", 1, "%d harmonic displacement%s and %d table%s, in "
		    "integrate; not in statics and "
		    "modes", net->motions, net->motions == 1 ? "" : "s", tables,
		    tables == 1 ? "" : "s");
	if (net->dynamics.releases)
		say(planner, "release", 1, "%d supports are taken away at t = 0", net->dynamics.releases);
	if (net->water.waves.count)
		say(planner, "waves", 1, "%d component%s, in integrate, frf and models in regular waves",
		    net->water.waves.count, net->water.waves.count == 1 ? "" : "s");
	if (net->failures + net->winches)
		say(planner, "failures, winches", 1, "%d and %d, in integrate", net->failures, net->winches);
	if (!harmonic && !net->motions && !tables && !net->dynamics.releases && !net->dynamics.from &&
	    !net->water.waves.count && !net->failures && !net->winches)
		say(planner, "motion", 0, "nothing sets the net in motion: integrate would show the "
		    "equilibrium");
}

/* Names of the obstacles that are touched, with the number of nodes, or of the others; returns how many
 * there are. */
static int obstacles(char *names, size_t size, const struct hawser__net_planner *planner, int touched)
{
	const struct hawser_net *net = planner->net;
	int count = 0;

	*names = '\0';
	for (int s = 0; s < net->surfaces; s++) {
		int nodes = 0;

		for (int i = 0; i < planner->st.contacts; i++)
			nodes += planner->st.contact[i].surface == s;
		if ((nodes > 0) != touched || count++ >= NAMES)
			continue;
		hawser__append(names, size, ", ", "%s", net->surface[s].name);
		if (touched)
			hawser__append(names, size, " ", "(%d node%s)", nodes, nodes == 1 ? "" : "s");
	}
	if (count > NAMES)
		hawser__append(names, size, " ", "and %d more", count - NAMES);
	return count;
}

static void friction(struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	int rough = 0, moving = 0, stick = 0;

	for (int s = 0; s < net->surfaces; s++) {
		const struct hawser_surface *of = &net->surface[s];
		double v = fabs(of->speed) + fabs(of->velocity[0]) + fabs(of->velocity[1]) +
		           fabs(of->velocity[2]);

		rough += of->friction > 0.0;
		moving += of->friction > 0.0 && v > 0.0;
	}
	for (int i = 0; i < planner->st.contacts; i++)
		stick += planner->st.contact[i].sticks;
	if (rough == 0)
		say(planner, "friction", 0, "no obstacle has any");
	else if (net->contact.history)
		say(planner, "friction", 1, "along the way of the supports (contact.path), %d nodes stick at "
		    "its end", stick);
	else if (moving)
		say(planner, "friction", 1, "of %d obstacle%s whose surface moves; at rest it depends on the "
		    "way here, which contact.path would give", moving, moving == 1 ? "" : "s");
	else
		say(planner, "friction", 0, "in statics: at rest it depends on the way here, which %s",
		    net->bodies ? "is not known of bodies"
		                : "contact.sliding: history and contact.path would give");
	if (net->contact.modes != HAWSER_NET_MODES_SLIP && stick > 0)
		say(planner, "contact in modes", 1, "%d nodes stick, %d slip along the obstacles "
		    "(contact.modes)", stick, planner->st.contacts - stick);
	else if (planner->st.contacts > 0)
		say(planner, "contact in modes", 1, "nodes that touch slip along the obstacles, without "
		    "friction");
}

static void contacts(struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	char names[160];
	int count;

	if (!net->surfaces)
		return;
	if (!planner->st.x) {
		say(planner, "contact", 1, "with which obstacles: the statics say");
		return;
	}
	count = obstacles(names, sizeof names, planner, 1);
	if (count > 0)
		say(planner, "contact", 1, "%d of %d obstacle%s touched in the equilibrium: %s", count,
		    net->surfaces, net->surfaces == 1 ? "" : "s", names);
	count = obstacles(names, sizeof names, planner, 0);
	if (count > 0)
		say(planner, "obstacles not touched", 0, "in the equilibrium: %s; modes are those without them",
		    names);
	friction(planner);
	say(planner, "error of the mesh", 0, "exact catenaries know no obstacles: compare with twice as "
	    "many elements");
}

/* What the loads of a scene may be at odds with. */
static void warn_loads(struct hawser__net_planner *planner)
{
	const struct hawser_net *net = planner->net;
	const struct hawser_net_plan *plan = planner->plan;
	struct hawser_net bare = *net;
	double normal[3], out = 0.0, weight = 0.0;

	bare.loads = bare.motions = 0;
	for (int i = 0; i < planner->mesh.nodes; i++)
		weight += fabs(planner->mesh.force[i][1]);
	if (net->loads && hawser__net_plane(normal, &bare) == 1)
		for (int i = 0; i < net->loads; i++) {
			int c = net->load[i].cable;
			double length = c < 0 ? 1.0 : plan->cable[c].length0;

			out += length*fabs(net->load[i].value[0]*normal[0] + net->load[i].value[2]*normal[2]);
		}
	if (out > ACROSS*weight)
		warn(planner, "loads across the vertical plane of the supports are %.0f %% of the weight: "
		     "only the tension of the cables holds against these, so that the net moves far out of "
		     "its plane",
		     100.0*out/weight);
	for (int j = 0; j < planner->modes.n; j++)
		for (int i = 0; i < net->loads + net->motions; i++) {
			const struct hawser_net_load *load = i < net->loads ? &net->load[i]
			                                                    : &net->motion[i - net->loads];

			if (load->harmonic && fabs(load->Omega/planner->modes.omega[j] - 1.0) < NEAR) {
				warn(planner, "a load or support at %.4g rad/s is within %.1f %% of mode %d (%.4g "
				     "rad/s): the motion grows for long, %s", load->Omega,
				     100.0*fabs(load->Omega/planner->modes.omega[j] - 1.0), j + 1,
				     planner->modes.omega[j], net->alpha > 0.0 ? "until damping balances the load"
				     : "and there is no viscous damping");
				break;
			}
		}
	if (plan->resolved < RESOLVED)
		warn(planner, "the fastest load has only %.1f elements in a wave: give the cables %.0f "
		     "times as many elements", plan->resolved, ceil(RESOLVED/plan->resolved));
}

static void warn_cables(struct hawser__net_planner *planner)
{
	const struct hawser_net_plan *plan = planner->plan;
	char names[160];
	int count = list(names, sizeof names, planner, slack);

	if (count)
		warn(planner, "slack in the equilibrium: %s; modes need tension in all cables", names);
	count = list(names, sizeof names, planner, strained);
	if (count)
		warn(planner, "strained by more than 10 %%: %s; the law T = EA*strain is rarely true "
		     "there", names);
	count = list(names, sizeof names, planner, coarse);
	if (count) {
		int most = 0;

		for (int c = 0; c < plan->cables; c++)
			most = most < plan->cable[c].wanted ? plan->cable[c].wanted : most;
		warn(planner, "the mesh is coarse: positions are off by more than 1 %% of the sag in %s; "
		     "%d elements would make it 0.1 %%", names, most);
	}
	count = list(names, sizeof names, planner, massless);
	if (count)
		warn(planner, "no mass: the inner nodes of %s; a motion needs it: give rho, or 1 element",
		     names);
	else if (planner->st.x && !planner->net->surfaces &&
	         (count = list(names, sizeof names, planner, light)))
		warn(planner, "as good as weightless: %s; 1 element is enough for statics", names);
	if (planner->motion.switches > 0 && planner->net->axial == 0.0)
		warn(planner, "elements become slack and taut in the motion (%ld times in its first %.3g "
		     "s), without damping.axial: axial waves are then chaotic", planner->motion.switches,
		     planner->motion.reached);
}

enum hawser_status hawser__plan_words(struct hawser__net_planner *planner, struct hawser_report *report)
{
	struct hawser_net_plan *plan = planner->plan;

	plan->decision = calloc(DECISIONS, sizeof *plan->decision);
	plan->warning = calloc(WARNINGS, sizeof *plan->warning);
	if (!plan->decision || !plan->warning)
		return hawser__no_memory(report, "net");
	directions(planner);
	law(planner);
	contacts(planner);
	mass(planner);
	driving(planner);
	for (int i = 0; i < HAWSER_NET_JOBS; i++)
		if (plan->job[i].basis == HAWSER_NET_BASIS_NONE && (i == 0 || plan->job[0].basis) &&
		    !(i == 1 && planner->slack) && plan->job[i].unknowns > 0 &&
		    strncmp(plan->job[i].why, "nothing", 7) != 0)
			warn(planner, "%s: %s", plan->job[i].name, plan->job[i].why);
	if (planner->st.x)
		warn_cables(planner);
	warn_loads(planner);
	return HAWSER_OK;
}
