/* Cables with point masses under a static load from the side, which hang in space: the force balance
 * integrated along the cable by Gauss' rule from the forces of the scene alone, limits in which the
 * cable is a plane curve, mirror images, each given quantity, extremes and refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/statics.h>
#include "tests/tap.h"

static double draw(unsigned *seed, double low, double high)
{
	*seed = *seed*1664525u + 1013904223u;
	return low + (high - low)*(*seed >> 8)/16777216.0;
}

static struct hawser_scene scene_of(void)
{
	struct hawser_scene scene = {.cable = {.EA = 2.17e7, .rho = 1.571}, .span = {387.3, 31.7},
	                             .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_H;
	scene.tension.value = 2.385e4;
	scene.tension.state = HAWSER_STATE_REFERENCE;
	scene.static_load.present = 1;
	return scene;
}

static void load(struct hawser_scene *scene, double x, double y, double z, double mass)
{
	scene->static_load.per_length[0] = x;
	scene->static_load.per_length[1] = y;
	scene->static_load.per_length[2] = z;
	scene->static_load.mass = mass;
}

static void attach(struct hawser_scene *scene, double at, double mass)
{
	struct hawser_attachment *a = &scene->attach[scene->attachments++];

	a->at = at;
	a->by_length = at >= 1.0;
	a->mass = mass;
}

static struct hawser_statics solved(const struct hawser_scene *scene)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics st = {.H = NAN};

	if (hawser_statics_scene(&st, scene, &report))
		ok(0, "solve: %s", report.message);
	return st;
}

static void place(double xyz[3], const struct hawser_statics *st, double S)
{
	struct hawser_profile_point point = hawser_statics_at(st, S);
	const double in[3] = {point.x, point.y, point.z};

	hawser_statics_to_global(st, xyz, in);
}

static double apart(const double a[3], const double b[3])
{
	return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

/* --- the differential equation --- */

/* Move x along the piece from S = `from` to `to`, where the force is F at `from`: Gauss' rule with
 * three nodes on parts that become short where the force is small. */
static void integrate(double x[3], const double F[3], const double w[3], double EA, double from,
                      double to)
{
	static const double node[3] = {-0.7745966692414834, 0.0, 0.7745966692414834};
	static const double weight[3] = {5.0/9.0, 8.0/9.0, 5.0/9.0};
	double s = 0.0, total = to - from, size = sqrt(w[0]*w[0] + w[1]*w[1] + w[2]*w[2]);

	while (s < total) {
		double f[3], T = 0.0, step;

		for (int c = 0; c < 3; c++)
			f[c] = F[c] - w[c]*s;
		step = fmin(total - s, 0.004*sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2])/size + 2e-6*total);
		step = fmin(step, total/400.0);
		for (int k = 0; k < 3; k++) {
			for (int c = 0; c < 3; c++)
				f[c] = F[c] - w[c]*(s + 0.5*step*(1.0 + node[k]));
			T = sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]);
			for (int c = 0; c < 3; c++)
				x[c] += 0.5*step*weight[k]*f[c]*(1.0/T + 1.0/EA);
		}
		s = total - s - step < 1e-12*total ? total : s + step;
	}
}

/* From end A with the force there, past the masses, to end B; relative to the length of the cable. */
static double balance(const struct hawser_statics *st, const struct hawser_scene *scene)
{
	const double *p = scene->static_load.per_length;
	double rho = scene->cable.rho + scene->static_load.mass, x[3] = {0.0}, F[3], at[3], worst = 0.0;
	const double w[3] = {p[0], p[1] - rho*scene->g, p[2]};
	struct hawser_profile_point start = hawser_statics_at(st, 0.0);
	double from = 0.0;

	hawser_statics_to_global(st, F, start.tangent);
	for (int c = 0; c < 3; c++)
		F[c] *= start.T;
	for (int i = 0; i <= st->attachments; i++) {
		double to = i < st->attachments ? st->attached[i].S : st->length0;

		integrate(x, F, w, scene->cable.EA, from, to);
		place(at, st, to);
		worst = fmax(worst, apart(at, x)/st->length);
		for (int c = 0; c < 3; c++)
			F[c] -= w[c]*(to - from);
		from = to;
		if (i == st->attachments)
			break;
		worst = fmax(worst, fabs(hawser_statics_before(st, i).T/sqrt(F[0]*F[0] + F[1]*F[1] + F[2]*F[2])
		                         - 1.0));
		F[1] += scene->attach[st->attached[i].index].mass*scene->g;
		for (int c = 0; c < 3; c++)
			F[c] -= scene->attach[st->attached[i].index].force[c];
		worst = fmax(worst, fabs(hawser_statics_at(st, to).T/sqrt(F[0]*F[0] + F[1]*F[1] + F[2]*F[2])
		                         - 1.0));
	}
	at[0] = scene->span.d;
	at[1] = scene->span.h;
	at[2] = 0.0;
	return fmax(worst, apart(at, x)/st->length);
}

static void random_spans(void)
{
	double worst = 0.0;
	unsigned seed = 2385;
	int spans = getenv("HAWSER_LONG") ? 2000 : 60, iterations = 0;

	for (int n = 0; n < spans; n++) {
		struct hawser_scene scene = scene_of();
		struct hawser_statics st;
		int count = 1 + (int)draw(&seed, 0.0, 5.0);
		double size = pow(10.0, draw(&seed, -2.0, 1.5))*15.4, off, chord;

		scene.cable.EA = pow(10.0, draw(&seed, 4.5, 12.0));
		scene.span.h = scene.span.d*pow(draw(&seed, -1.5, 1.5), 3.0);
		chord = hypot(scene.span.d, scene.span.h);
		load(&scene, draw(&seed, -1.0, 1.0)*size, draw(&seed, -1.0, 1.0)*size,
		     draw(&seed, -1.0, 1.0)*size, draw(&seed, 0.0, 1.0));
		for (int i = 0; i < count; i++) {
			double mass = pow(10.0, draw(&seed, -2.0, 1.5))*1.571*chord;

			attach(&scene, (i + draw(&seed, 0.1, 0.9))/count, mass);
			for (int c = 0; c < 3 && n%3; c++)
				scene.attach[i].force[c] = draw(&seed, -20.0, 20.0)*mass;
			if (n%3 == 2)
				scene.attach[i].mass = 0.0;
		}
		scene.static_load.present = n%4 > 0;
		if (n%4 == 0) {
			load(&scene, 0.0, 0.0, 0.0, 0.0);
			scene.attach[0].force[2] = 3.0*size;
		}
		scene.tension.given = HAWSER_GIVEN_LENGTH0;
		scene.tension.value = chord*(0.985 + pow(10.0, draw(&seed, -2.5, 0.3)));
		st = solved(&scene);
		off = balance(&st, &scene);
		ok(st.space && off < 2e-10, "span %d: force balance and closure to %.1e (EA %g, h %g, load %g, "
		   "%d masses)", n, off, scene.cable.EA, scene.span.h, size, count);
		worst = fmax(worst, st.closure/st.length);
		iterations = st.iterations > iterations ? st.iterations : iterations;
	}
	ok(worst < 1e-12, "%d spans close to %.1e of their length, at most %d iterations", spans, worst,
	   iterations);
}

/* --- limits --- */

/* A taut string with a force P from the side at a L0: at a L0 it gives way by P a (1 - a) L/T. */
static void string(void)
{
	double before = 0.0;

	for (int k = 0; k < 2; k++) {
		struct hawser_scene scene = scene_of();
		double a = 0.37, P = 25.0*pow(10.0, -k), x[3], off;
		struct hawser_statics st;

		scene.static_load.present = 0;
		scene.span.h = 0.0;
		scene.g = 1e-6;
		scene.tension.given = HAWSER_GIVEN_T0;
		attach(&scene, a, 0.0);
		scene.attach[0].force[2] = P;
		st = solved(&scene);
		place(x, &st, a*st.length0);
		off = x[2]/(P*a*(1.0 - a)*scene.span.d/scene.tension.value) - 1.0;
		ok(st.space && fabs(off) < 1e-5*pow(100.0, -k) && (!k || fabs(before/off/100.0 - 1.0) < 0.2),
		   "a force of %g N moves a string by %.6g m, %.1e from the closed form", P, x[2], off);
		before = off;
	}
}

/* With a wind that vanishes, the plane solution with the masses; the difference decreases with the
 * wind: along z with it, in the plane with its square. */
static void no_wind(void)
{
	double before[2] = {0.0};

	for (int k = 0; k < 3; k++) {
		struct hawser_scene scene = scene_of();
		struct hawser_statics space, plane;
		double a[3], b[3], wind = pow(10.0, -2.0*k), off[2];

		attach(&scene, 0.41, 133.7);
		attach(&scene, 91.3, 57.1);
		load(&scene, 0.0, -1.7, wind, 0.37);
		space = solved(&scene);
		load(&scene, 0.0, -1.7, 0.0, 0.37);
		plane = solved(&scene);
		ok(space.space && !plane.space && !plane.turned, "space and plane");
		place(a, &space, 0.37*space.length0);
		place(b, &plane, 0.37*plane.length0);
		off[0] = fabs(space.T0/plane.T0 - 1.0);
		off[1] = apart(a, b);
		if (k > 0)
			ok(fabs(before[1]/off[1]/100.0 - 1.0) < 0.1 &&
			   (off[0] < 1e-9 || fabs(before[0]/off[0]/1e4 - 1.0) < 0.1),
			   "wind %g N/m: T0 to %.1e, position to %.1e m", wind, off[0], off[1]);
		memcpy(before, off, sizeof off);
		if (k == 2)
			place(a, &space, space.length0);
	}
}

/* A force upwards that exceeds the weight: the space solution in a plane, the mirror image of a span
 * under its weight whose masses pull upwards. */
static void in_the_plane(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_statics plane, space;
	double gravity[3] = {0.0, -9.81, 0.0}, most = 0.0;
	struct hawser_span span = {2.17e7, 1.571, 9.81, 387.3, 31.7};
	struct hawser_report report = {.message = ""};

	attach(&scene, 0.23, 210.0);
	attach(&scene, 0.61, 83.0);
	ok(!hawser_statics_weighted(&plane, &span, HAWSER_GIVEN_LENGTH0, 391.2, HAWSER_BRANCH_TAUT,
	                            scene.attach, 2, gravity, &report), "plane %s", report.message);
	gravity[2] = 1e-300; /* the way in space, with the same forces */
	ok(!hawser_statics_weighted(&space, &span, HAWSER_GIVEN_LENGTH0, 391.2, HAWSER_BRANCH_TAUT,
	                            scene.attach, 2, gravity, &report), "space %s", report.message);
	ok(space.space && !plane.space, "two ways");
	close_to(space.H, plane.H, 1e-12, "without wind: H");
	close_to(space.T0, plane.T0, 1e-12, "without wind: T0");
	close_to(space.T1, plane.T1, 1e-12, "without wind: T1");
	close_to(space.sag, plane.sag, 1e-12, "without wind: sag");
	close_to(space.length, plane.length, 1e-13, "without wind: stretched length");
	close_to(space.irvine, plane.irvine, 1e-11, "without wind: irvine");
	for (int i = 0; i <= 20; i++) {
		struct hawser_profile_point a = hawser_statics_at(&space, 391.2*i/20);
		struct hawser_profile_point b = hawser_statics_at(&plane, 391.2*i/20);

		most = fmax(most, hypot(a.x - b.x, a.y - b.y) + fabs(a.slope - b.slope) + fabs(a.z));
	}
	ok(most < 1e-12*391.2, "without wind: profile to %.1e", most);
}

/* Without masses the bare span, turned. */
static void no_masses(void)
{
	double before = 0.0;

	for (int k = 0; k < 3; k++) {
		struct hawser_scene scene = scene_of();
		struct hawser_statics heavy, bare;
		double a[3], b[3], off;

		load(&scene, 1.3, 0.9, 17.1, 0.37);
		bare = solved(&scene);
		attach(&scene, 0.41, 10.0*pow(10.0, -2.0*k));
		heavy = solved(&scene);
		place(a, &heavy, 0.37*heavy.length0);
		place(b, &bare, 0.37*bare.length0);
		off = apart(a, b);
		if (k > 0)
			ok(fabs(before/off/100.0 - 1.0) < 0.02, "mass %g kg: position to %.1e m",
			   10.0*pow(10.0, -2.0*k), off);
		before = off;
		close_to(heavy.swing, bare.swing, 0.1*pow(10.0, -2.0*k), "swing");
	}
}

/* Turned about the vertical, a span under wind is another scene of the same: wind and masses together
 * with the ends exchanged, and mirrored across the vertical plane. */
static void mirrored(void)
{
	struct hawser_scene scene = scene_of(), back, other;
	struct hawser_statics a, b, c;
	double x[3], y[3], most = 0.0;

	load(&scene, 3.1, 1.9, -21.7, 0.37);
	attach(&scene, 0.31, 77.7);
	attach(&scene, 0.83, 241.3);
	back = other = scene;
	back.span.h = -scene.span.h;
	back.static_load.per_length[0] *= -1.0;
	back.attach[0].at = 1.0 - 0.31;
	back.attach[1].at = 1.0 - 0.83;
	other.static_load.per_length[2] *= -1.0;
	a = solved(&scene);
	b = solved(&back);
	c = solved(&other);
	close_to(a.T0, b.T1, 1e-12, "ends exchanged: T0");
	close_to(a.T0, c.T0, 1e-14, "mirrored: T0");
	close_to(a.swing, -c.swing, 1e-13, "mirrored: swing");
	for (int i = 0; i <= 16; i++) {
		place(x, &a, a.length0*i/16);
		place(y, &b, b.length0*(16 - i)/16);
		y[0] = scene.span.d - y[0];
		y[1] += scene.span.h;
		most = fmax(most, apart(x, y));
		place(y, &c, c.length0*i/16);
		y[2] = -y[2];
		most = fmax(most, apart(x, y));
	}
	ok(most < 1e-12*a.length, "mirrored: profile to %.1e m", most);
}

/* --- given quantities --- */

static void there_and_back(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_report report = {.message = ""};
	struct hawser_statics st, reference, back;
	static const enum hawser_given given[] = {HAWSER_GIVEN_T0, HAWSER_GIVEN_T1, HAWSER_GIVEN_LENGTH0};

	load(&scene, 1.1, 0.7, -14.2, 0.57);
	attach(&scene, 0.31, 77.7);
	attach(&scene, 200.0, 141.3);
	scene.temperature.present = 1;
	scene.temperature.change = 38.5;
	scene.temperature.expansion = 2.3e-5;
	st = solved(&scene);
	ok(!hawser_statics_reference(&reference, &scene, &report) && !reference.space &&
	   fabs(reference.H/2.385e4 - 1.0) < 1e-15, "the reference state is plane, with the given tension");
	close_to(st.length0, reference.length0*(1.0 + 38.5*2.3e-5), 1e-14, "its length is held");
	scene.tension.state = HAWSER_STATE_LOADED;
	for (int i = 0; i < 3; i++) {
		struct hawser_statics loaded;

		scene.tension.given = given[i];
		scene.tension.value = given[i] == HAWSER_GIVEN_T0 ? st.T0
		                      : given[i] == HAWSER_GIVEN_T1 ? st.T1 : st.length0;
		loaded = solved(&scene);
		close_to(loaded.length0, st.length0, 1e-13, "the same length from the loaded state");
		if (ok(!hawser_statics_reference(&back, &scene, &report), "%s", report.message))
			close_to(back.H, reference.H, 1e-9, "back from the loaded state");
	}
}

/* A slack span of the same T0 as a taut one, and the least T0 between both. */
static void slack(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_report report = {.message = ""};
	struct hawser_statics taut, deep;

	load(&scene, 0.0, 0.0, 14.2, 0.57);
	attach(&scene, 0.31, 377.7);
	scene.tension.state = HAWSER_STATE_LOADED;
	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 1.7e4;
	taut = solved(&scene);
	scene.tension.branch = HAWSER_BRANCH_SLACK;
	deep = solved(&scene);
	ok(deep.length0 > 1.5*taut.length0, "slack: %.4g m in place of %.4g m", deep.length0, taut.length0);
	close_to(taut.T0, 1.7e4, 1e-13, "taut: T0");
	close_to(deep.T0, 1.7e4, 1e-13, "slack: T0");
	scene.tension.value = 3e3;
	ok(hawser_statics_scene(&deep, &scene, &report) == HAWSER_ERR_NO_SOLUTION &&
	   strstr(report.message, "below the least one"), "%s", report.message);
}

/* --- extremes --- */

static void extreme(const char *what, const struct hawser_scene *scene)
{
	struct hawser_statics st = solved(scene);
	double off = balance(&st, scene);

	ok(st.space && off < 1e-9 && st.closure < 1e-11*st.length, "%s: force balance to %.1e, closure "
	   "%.1e, %d iterations", what, off, st.closure/st.length, st.iterations);
}

static void extremes(void)
{
	struct hawser_scene scene = scene_of(), base;

	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = 389.5;
	load(&scene, 0.0, 0.0, 12.0, 0.0);
	attach(&scene, 0.313, 211.0);
	attach(&scene, 0.787, 90.0);
	base = scene;
	scene.cable.EA = 1e15;
	extreme("nearly inextensible, nearly straight", &scene);
	scene.cable.EA = INFINITY;
	extreme("inextensible", &scene);
	scene = base;
	scene.tension.value = 1500.0;
	extreme("slack", &scene);
	scene = base;
	scene.tension.value = 120.0;
	scene.cable.EA = 4e3;
	extreme("rubber", &scene);
	scene = base;
	load(&scene, 0.0, 0.0, 1500.0, 0.0);
	extreme("wind of a hundred times the weight", &scene);
	scene = base;
	load(&scene, 0.0, 0.0, -1e-5, 0.0);
	extreme("hardly any wind", &scene);
	scene = base;
	scene.attach[0].mass = 2e5;
	extreme("a mass of three hundred times the cable", &scene);
	scene = base;
	scene.span.h = 3200.0;
	scene.tension.value = 3230.0;
	extreme("steep", &scene);
	scene = base;
	scene.span.h = -3200.0;
	scene.tension.value = 3500.0;
	load(&scene, 700.0, 15.0, 1.0, 0.0);
	extreme("steep, wind along the span", &scene);
	scene = base;
	load(&scene, 0.0, 60.0, 0.0, 0.0);
	extreme("lifted, masses hanging", &scene);
}

static void refused(void)
{
	struct hawser_scene scene = scene_of();
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;

	load(&scene, 0.0, 0.0, 12.0, 0.0);
	attach(&scene, 0.313, 211.0);
	scene.tension.state = HAWSER_STATE_LOADED;
	ok(hawser_statics_scene(&st, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "give T0, T1 or length0"), "%s", report.message);
	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = 388.0;
	scene.cable.EA = INFINITY;
	ok(hawser_statics_scene(&st, &scene, &report) == HAWSER_ERR_NO_SOLUTION &&
	   strstr(report.message, "chord"), "%s", report.message);
	scene.cable.EA = 2.17e7;
	scene.span.h = 0.0;
	load(&scene, 12.0, 1.571*9.81 + 211.0*9.81/388.0, 0.0, 0.0); /* the masses compensate the lift */
	ok(hawser_statics_scene(&st, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "attachments together act along the chord"), "%s", report.message);
	scene = scene_of();
	load(&scene, 0.0, 0.0, 12.0, 0.0);
	attach(&scene, 0.313, 211.0);
	scene.attach[0].spring[1] = 1e3;
	ok(hawser_statics_scene(&st, &scene, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "attach[0]"), "%s", report.message);
}

CASE(property_statics_space)
{
	random_spans();
	string();
	no_wind();
	in_the_plane();
	no_masses();
	mirrored();
	there_and_back();
	slack();
	extremes();
	refused();
	return done_testing();
}
