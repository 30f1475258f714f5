/* Ends on springs in a loaded state: random spans against a chain of rods between springs
 * (tests/lumped-chain.h), closed forms of taut strings, the way to the other state and back, load
 * cases, limits of stiff and soft springs, and refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/statics.h>

#include "tests/lumped-chain.h"
#include "tests/tap.h"

enum { RODS = 64, SPANS = 12 };

static struct hawser_report report = {.message = ""};

static double uniform(double low, double high)
{
	static unsigned long long state = 2385;

	state = state*6364136223846793005ULL + 1442695040888963407ULL;
	return low + (high - low)*(double)(state >> 11)/9007199254740992.0;
}

/* A span with everything that a statics may have; rigid ends. */
static struct hawser_scene scene_of(double d, double h, double T0)
{
	struct hawser_scene scene = {.cable = {.EA = 2.17e7, .rho = 1.571}, .span = {d, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = T0;
	scene.tension.state = HAWSER_STATE_REFERENCE;
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 3; c++)
			scene.support[end].stiffness[c] = INFINITY;
	scene.support[0].present = scene.support[1].present = 1;
	return scene;
}

static void load(struct hawser_scene *scene, double x, double y, double z, double mass)
{
	scene->static_load.present = 1;
	scene->static_load.per_length[0] = x;
	scene->static_load.per_length[1] = y;
	scene->static_load.per_length[2] = z;
	scene->static_load.mass = mass;
}

static void heat(struct hawser_scene *scene, double strain)
{
	scene->temperature.present = 1;
	scene->temperature.change = strain/1.2e-5;
	scene->temperature.expansion = 1.2e-5;
}

static int solve(struct hawser_statics *st, const struct hawser_scene *scene)
{
	*st = (struct hawser_statics){.H = NAN};
	report.message[0] = '\0';
	return ok(!hawser_statics_scene(st, scene, &report), "solved %s", report.message);
}

/* Forces of the cable on its supports, along x, y, z. */
static void pulls(double pull[2][3], const struct hawser_statics *st)
{
	for (int end = 0; end < 2; end++) {
		double V = end ? st->V1 : st->V0, sign = end ? -1.0 : 1.0;
		double f[3] = {sign*st->H, sign*V, 0.0};

		if (st->space) {
			struct hawser_profile_point at = hawser_statics_at(st, end ? st->length0 : 0.0);

			for (int c = 0; c < 3; c++)
				f[c] = sign*at.T*at.tangent[c];
		}
		hawser_statics_to_global(st, pull[end], f);
	}
}

/* Largest component of k u - (P - P0), over the tension. */
static double unbalanced(const struct hawser_statics *st, const struct hawser_statics *given,
                         const struct hawser_scene *scene)
{
	double P[2][3], P0[2][3], most = 0.0;

	pulls(P, st);
	pulls(P0, given);
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 3; c++) {
			double k = scene->support[end].stiffness[c];

			if (isfinite(k))
				most = fmax(most, fabs(k*st->moved[end][c] - (P[end][c] - P0[end][c])));
		}
	return most/st->T0;
}

/* --- a chain between springs --- */

/* Force of the chain on its end: of the rod and of the load of half a rod. */
static double end_force(const struct lumped *c, const double *x, int end)
{
	int rod = end ? c->n - 2 : 1, joint = end ? c->n - 1 : 1;
	double T = lumped_tension(c, x, rod), t[3], sum = 0.0;

	lumped_rod(t, x, rod);
	for (int i = 0; i < 3; i++) {
		double f = (end ? -T : T)*t[i] + c->weight[i]*lumped_share(c, joint);

		sum += f*f;
	}
	return sqrt(sum);
}

/* Displacements of the ends of the loaded chain, and the tensions there. */
static int chain(double got[8], const struct hawser_scene *scene, const struct hawser_statics *before,
                 const struct hawser_statics *after, int n)
{
	static struct lumped c;
	static double x[3*LUMPED_MOST + 9];
	double mass = scene->static_load.mass;

	memset(&c, 0, sizeof c);
	c.n = n;
	c.L0 = before->length0;
	c.EA = scene->cable.EA;
	c.rho = scene->cable.rho;
	c.gravity = scene->g;
	c.end[0] = scene->span.d;
	c.end[1] = scene->span.h;
	c.weight[1] = -c.rho*c.gravity;
	for (int i = 0; i < scene->attachments; i++) {
		int joint = (int)lround(scene->attach[i].at*n);

		c.attached[joint] = scene->attach[i].mass;
		memcpy(c.dead[joint], scene->attach[i].force, sizeof c.dead[joint]);
	}
	for (int i = 0; i <= n; i++) {
		struct hawser_profile_point at = hawser_statics_at(before, before->length0*i/n);
		double in[3] = {at.x, at.y, at.z};

		hawser_statics_to_global(before, x + 3*i, in);
	}
	memset(x, 0, 3*sizeof *x);
	memcpy(x + 3*n, c.end, sizeof c.end);
	if (!lumped_statics(x, &c))
		return 0;
	for (int end = 0; end < 2; end++)
		for (int i = 0; i < 3; i++)
			c.stiffness[end][i] = fmin(scene->support[end].stiffness[i], 1e14);
	lumped_hold(&c, x);
	c.L0 = after->length0;
	c.rho += mass;
	c.weight[1] -= mass*c.gravity;
	for (int i = 0; i < 3; i++)
		c.weight[i] += scene->static_load.per_length[i];
	for (int i = 0; i <= n; i++) { /* a start: the foundations stay */
		struct hawser_profile_point at = hawser_statics_at(after, after->length0*i/n);
		double in[3] = {at.x, at.y, at.z};

		hawser_statics_to_global(after, x + 3*i + 3, in);
	}
	if (!lumped_statics(x, &c))
		return 0;
	for (int i = 0; i < 3; i++) {
		got[i] = x[3 + i];
		got[3 + i] = x[3*n + 3 + i] - c.end[i];
	}
	got[6] = end_force(&c, x, 0);
	got[7] = end_force(&c, x, 1);
	return 1;
}

static struct hawser_scene random_scene(int index)
{
	double d = uniform(40.0, 450.0), h = d*uniform(-1.2, 1.2), rho = uniform(0.5, 30.0);
	double weight = rho*9.81*hypot(d, h);
	struct hawser_scene scene = scene_of(d, h, weight*uniform(1.2, 6.0));

	scene.cable.rho = rho;
	scene.cable.EA = scene.tension.value*pow(10.0, uniform(2.0, 3.5));
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 3; c++)
			if (uniform(0.0, 1.0) < 0.75)
				scene.support[end].stiffness[c] =
					scene.tension.value/hypot(d, h)*pow(10.0, uniform(1.0, 4.0));
	if (index%3)
		load(&scene, rho*uniform(-2.0, 2.0), rho*uniform(-5.0, 5.0),
		     index%2 ? rho*uniform(-9.0, 9.0) : 0.0, rho*uniform(0.0, 1.0));
	if (index%3 != 1)
		heat(&scene, uniform(-6e-4, 6e-4));
	if (index%4 > 1) {
		scene.attachments = 2;
		scene.attach[0] = (struct hawser_attachment){.at = 0.25, .mass = 0.1*weight/9.81};
		scene.attach[1] = (struct hawser_attachment){.at = 0.625, .mass = 0.03*weight/9.81};
		for (int c = 0; c < (index%4 > 2 ? 3 : 2); c++) /* in the plane, or in space */
			scene.attach[1].force[c] = weight*uniform(-0.2, 0.2);
	}
	return scene;
}

static void chains(void)
{
	for (int k = 0; k < SPANS; k++) {
		struct hawser_scene scene = random_scene(k);
		struct hawser_statics before, after;
		double coarse[8], fine[8], off = 0.0, size = 0.0, tension[2];

		if (!ok(!hawser_statics_reference(&before, &scene, &report), "%s", report.message) ||
		    !solve(&after, &scene) ||
		    !ok(chain(coarse, &scene, &before, &after, RODS) &&
		        chain(fine, &scene, &before, &after, 2*RODS), "span %d: chains", k))
			continue;
		for (int c = 0; c < 6; c++) {
			double want = (4.0*fine[c] - coarse[c])/3.0;

			off = fmax(off, fabs(after.moved[c/3][c%3] - want));
			size = fmax(size, fabs(want));
		}
		for (int end = 0; end < 2; end++)
			tension[end] = (4.0*fine[6 + end] - coarse[6 + end])/3.0/(end ? after.T1 : after.T0) - 1.0;
		ok(off < 2e-8*size, "span %d: ends have moved by up to %.4g m, to %.1e", k, size, off/size);
		ok(fmax(fabs(tension[0]), fabs(tension[1])) < 1e-8, "span %d: tensions to %.1e", k,
		   fmax(fabs(tension[0]), fabs(tension[1])));
		ok(unbalanced(&after, &before, &scene) < 1e-11 && after.imbalance < 1e-11*after.T0,
		   "span %d: springs and cable balance to %.1e", k, unbalanced(&after, &before, &scene));
	}
}

/* --- closed forms --- */

/* A taut string in line with its springs: the strain alpha dT relaxes the force by
 * alpha dT/(1/EA + (1/kA + 1/kB)/L), exactly but for its sag. */
static void taut(void)
{
	struct hawser_scene scene = scene_of(100.0, 0.0, 1.2e6);
	double compliance[2] = {1.0/3.1e5, 1.0/7.7e5}, strain = -3.7e-4, change, L;
	struct hawser_statics before, after;

	scene.cable.rho = 1e-3;
	heat(&scene, strain);
	for (int end = 0; end < 2; end++)
		scene.support[end].stiffness[0] = 1.0/compliance[end];
	if (!ok(!hawser_statics_reference(&before, &scene, &report), "%s", report.message) ||
	    !solve(&after, &scene))
		return;
	/* L (1 + s)(1 + (F + f)/EA) = L (1 + F/EA) - C f */
	L = before.length0;
	change = -strain*L*(1.0 + before.H/scene.cable.EA)/
	         (L*(1.0 + strain)/scene.cable.EA + compliance[0] + compliance[1]);
	close_to((after.H - before.H)/change, 1.0, 1e-9, "a string between springs: change of its force");
	close_to(after.moved[0][0]/(change*compliance[0]), 1.0, 1e-9, "a string: end A");
	close_to(after.moved[1][0]/(-change*compliance[1]), 1.0, 1e-9, "a string: end B");
}

/* Ice on a span whose end B yields vertically: it bears half the change of the weight. */
static void heavier(void)
{
	struct hawser_scene scene = scene_of(200.0, 0.0, 3e4);
	struct hawser_statics after;
	double k = 4.7e4;

	load(&scene, 0.0, 0.0, 0.0, 0.9);
	scene.support[0].stiffness[1] = scene.support[1].stiffness[1] = k;
	if (!solve(&after, &scene))
		return;
	close_to(after.moved[0][1], -0.5*0.9*9.81*after.length0/k, 1e-14, "both ends sink alike: A");
	close_to(after.moved[1][1], after.moved[0][1], 1e-14, "both ends sink alike: B");
}

/* --- limits --- */

static void stiff(void)
{
	struct hawser_scene scene = scene_of(387.3, 31.7, 2.385e4), rigid;
	struct hawser_statics a, b;

	load(&scene, 1.3, 2.1, -11.0, 0.7);
	heat(&scene, -2.3e-4);
	rigid = scene;
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 3; c++)
			scene.support[end].stiffness[c] = 1e30;
	if (!solve(&a, &scene) || !solve(&b, &rigid))
		return;
	ok(fabs(a.T0/b.T0 - 1.0) < 1e-13 && fabs(a.T1/b.T1 - 1.0) < 1e-13 &&
	   fabs(a.swing/b.swing - 1.0) < 1e-13, "a stiff spring is a fixed end");
	ok(fabs(a.moved[1][2]) < 1e-25 && a.moved[1][2] != 0.0, "it moves by %g m", a.moved[1][2]);
	rigid.support[0].present = rigid.support[1].present = 0;
	ok(solve(&a, &rigid) && a.T0 == b.T0 && a.moved[1][0] == 0.0 && b.moved[1][0] == 0.0 &&
	   a.imbalance == 0.0, "ends without springs stay");
}

/* A soft spring along a level span keeps the force that it has, as a counterweight does. */
static void counterweight(void)
{
	struct hawser_scene scene = scene_of(300.0, 0.0, 2.4e4);
	struct hawser_statics before, after;

	scene.support[1].stiffness[0] = 1e-9;
	heat(&scene, 4e-4);
	if (!ok(!hawser_statics_reference(&before, &scene, &report), "%s", report.message) ||
	    !solve(&after, &scene))
		return;
	close_to(after.H, before.H, 1e-11, "a counterweight keeps H");
	close_to(after.moved[1][0]/(4e-4*300.0), 1.0, 0.01, "it moves by the change of the length");
}

static void refused(const struct hawser_scene *scene, const char *words)
{
	struct hawser_statics st;

	ok(hawser_statics_scene(&st, scene, &report) == HAWSER_ERR_NO_SOLUTION &&
	   strstr(report.message, words), "saying \"%s\": %s", words, report.message);
}

static void refusals(void)
{
	struct hawser_scene scene = scene_of(387.3, 31.7, 2.385e4);

	load(&scene, 0.0, 0.0, 0.0, 20.0);
	scene.support[1].stiffness[0] = 2.0;
	refused(&scene, "raise support.B.stiffness");
	scene.support[1].stiffness[0] = 1e-200;
	refused(&scene, "raise support.B.stiffness");
	scene.support[1].stiffness[0] = INFINITY;
	scene.support[0].stiffness[0] = 1.0;
	refused(&scene, "raise support.A.stiffness");
	scene = scene_of(2.0, 100.0, 2.385e4);
	load(&scene, 300.0, 0.0, 0.0, 0.0);
	scene.support[0].stiffness[0] = 3e3;
	refused(&scene, "past each other");
}

/* --- the other state, and cases --- */

/* What of `a` differs from `b`: tensions and places. */
static double differ(const struct hawser_statics *a, const struct hawser_statics *b)
{
	return fabs(a->T0/b->T0 - 1.0) + fabs(a->T1/b->T1 - 1.0) + fabs(a->length0/b->length0 - 1.0) +
	       fabs(a->sag/b->sag - 1.0);
}

/* The loaded state, given as such between the ends where they are: its reference state is the first
 * one, and so are all cases. */
static void there_and_back(void)
{
	struct hawser_scene scene = scene_of(387.3, 31.7, 2.385e4), back, one[2];
	struct hawser_statics before, after, st[2];

	load(&scene, 0.7, -9.3, 6.1, 0.7);
	heat(&scene, -2.3e-4);
	scene.support[0].stiffness[0] = 3.1e5;
	scene.support[0].stiffness[1] = 2.2e5;
	scene.support[1].stiffness[0] = 4.7e4;
	scene.support[1].stiffness[1] = 8.3e4;
	scene.cases = 2;
	scene.load_case[0] = (struct hawser_case){.loaded = 1, .per_length = {0.0, 0.0, 14.0}};
	scene.load_case[1] = (struct hawser_case){.heated = 1, .change = 40.0, .expansion = 1.2e-5};
	if (!ok(!hawser_statics_reference(&before, &scene, &report), "%s", report.message) ||
	    !solve(&after, &scene))
		return;
	back = scene;
	back.tension.state = HAWSER_STATE_LOADED;
	back.tension.value = after.T0;
	back.span.d += after.moved[1][0] - after.moved[0][0];
	back.span.h += after.moved[1][1] - after.moved[0][1];
	ok(solve(&st[0], &back) && differ(&st[0], &after) < 1e-11 && st[0].moved[1][0] == 0.0,
	   "the loaded state, given");
	ok(!hawser_statics_reference(&st[0], &back, &report), "%s", report.message);
	ok(differ(&st[0], &before) < 1e-10, "its reference state to %.1e", differ(&st[0], &before));
	for (int end = 0; end < 2; end++)
		for (int c = 0; c < 2; c++)
			close_to(st[0].moved[end][c]/after.moved[end][c], -1.0, 1e-9, "the way back");
	for (int k = 0; k < 2; k++) {
		ok(!hawser_statics_case(&one[0], &scene, k, &report) &&
		   !hawser_statics_case(&one[1], &back, k, &report), "cases");
		if (solve(&st[0], &one[0]) && solve(&st[1], &one[1]))
			ok(differ(&st[1], &st[0]) < 1e-10 && st[1].imbalance < 1e-10*st[1].T0,
			   "case %d to %.1e", k, differ(&st[1], &st[0]));
		ok(!hawser_statics_reference(&st[1], &one[1], &report), "%s", report.message);
		ok(differ(&st[1], &before) < 1e-10, "its reference state to %.1e", differ(&st[1], &before));
	}
}

/* A reference state that is out of the plane of the loaded one, whose ends are given in a wind. */
static void aside(void)
{
	struct hawser_scene scene = scene_of(387.3, 31.7, 2.9e4), bare;
	struct hawser_statics before, after;

	load(&scene, 0.0, -2.0, 13.1, 0.3);
	scene.tension.state = HAWSER_STATE_LOADED;
	scene.support[0].stiffness[2] = 3.1e3;
	scene.support[1].stiffness[0] = 1.4e5;
	scene.support[1].stiffness[2] = 2.7e3;
	if (!ok(!hawser_statics_reference(&before, &scene, &report), "%s", report.message) ||
	    !solve(&after, &scene))
		return;
	ok(unbalanced(&before, &after, &scene) < 1e-12, "springs balance to %.1e",
	   unbalanced(&before, &after, &scene));
	close_to(before.swing, 0.0, 1e-14, "without wind the plane is vertical");
	bare = scene;
	bare.static_load.present = 0;
	bare.span.d = hypot(scene.span.d + before.moved[1][0], before.moved[1][2] - before.moved[0][2]);
	bare.tension.given = HAWSER_GIVEN_LENGTH0;
	bare.tension.value = before.length0;
	if (solve(&after, &bare))
		ok(differ(&before, &after) < 1e-12, "a span of that length");
}

CASE(property_statics_yield)
{
	chains();
	taut();
	heavier();
	stiff();
	counterweight();
	refusals();
	there_and_back();
	aside();
	return done_testing();
}
