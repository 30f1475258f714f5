/* Static loads and changes of temperature: closed forms, a chain of straight elements in space (which
 * knows nothing of planes and catenaries), the state-change equation of line engineers, and the way
 * from the reference state to the loaded one and back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/statics.h>
#include "tests/tap.h"

static struct hawser_scene scene_of(double h)
{
	struct hawser_scene scene = {.cable = {.EA = 2.17e7, .rho = 1.571}, .span = {387.3, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_H;
	scene.tension.value = 2.385e4;
	scene.tension.state = HAWSER_STATE_LOADED;
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
	const double in[3] = {point.x, point.y, 0.0};

	hawser_statics_to_global(st, xyz, in);
}

/* --- equal to spans without load --- */

static void downwards(void)
{
	struct hawser_scene loaded = scene_of(31.7), heavy = scene_of(31.7);
	struct hawser_statics a, b;

	load(&loaded, 0.0, -7.3, 0.0, 0.0);
	heavy.static_load.present = 0;
	heavy.g = 9.81 + 7.3/1.571;
	a = solved(&loaded);
	b = solved(&heavy);
	ok(!a.turned, "a load downwards does not turn the plane");
	close_to(a.T0, b.T0, 1e-15, "load downwards: T0 as with a larger g");
	close_to(a.length0, b.length0, 1e-15, "load downwards: length0 as with a larger g");
	load(&loaded, 0.0, 0.0, 0.0, 0.83);
	heavy.g = 9.81;
	heavy.cable.rho = 1.571 + 0.83;
	a = solved(&loaded);
	b = solved(&heavy);
	close_to(a.T1, b.T1, 1e-15, "mass that adheres: T1 as with a larger rho");
	close_to(a.span.rho, b.span.rho, 1e-15, "mass that adheres: its inertia");
}

/* A strong wind alone: the vertical plane, turned by a right angle about a level chord. */
static void wind_alone(void)
{
	struct hawser_scene wind = scene_of(0.0), heavy = scene_of(0.0);
	struct hawser_statics a, b;
	double xyz[3], most = 0.0;

	wind.g = 0.0;
	load(&wind, 0.0, 0.0, 21.3, 0.0);
	heavy.static_load.present = 0;
	heavy.g = 21.3/1.571;
	a = solved(&wind);
	b = solved(&heavy);
	close_to(a.T0, b.T0, 1e-15, "wind without weight: T0");
	close_to(a.swing, M_PI/2.0, 1e-15, "wind without weight: swing");
	for (int i = 0; i <= 20; i++) {
		struct hawser_profile_point still = hawser_statics_at(&b, b.length0*i/20);

		place(xyz, &a, a.length0*i/20);
		most = fmax(most, hypot(hypot(xyz[0] - still.x, xyz[1]), xyz[2] + still.y));
	}
	ok(most < 1e-12*b.span.d, "wind without weight: the profile, turned: %.2e m", most);
}

/* Upwards: the mirror image of the span under its weight. */
static void upwards(void)
{
	struct hawser_scene lifted = scene_of(31.7), heavy = scene_of(-31.7);
	struct hawser_statics a, b;
	double xyz[3];

	load(&lifted, 0.0, 1.571*(9.81 + 12.1), 0.0, 0.0);
	heavy.static_load.present = 0;
	heavy.g = 12.1;
	a = solved(&lifted);
	b = solved(&heavy);
	close_to(a.T0, b.T0, 1e-13, "lifted: T0 of the mirror image");
	place(xyz, &a, 0.5*a.length0);
	close_to(xyz[1], -hawser_statics_at(&b, 0.5*b.length0).y, 1e-12, "lifted: height of the middle");
}

/* --- a chain in space --- */

/* End of a chain of `count` straight elements that begins with the force F: its load is at the joints,
 * half of it at the ends. */
static void hang(double end[3], const struct hawser_scene *scene, double length0, int count,
                 const double F[3], double (*joint)[3])
{
	const double *p = scene->static_load.per_length;
	double rho = scene->cable.rho + scene->static_load.mass, part = length0/count;
	const double w[3] = {p[0], p[1] - rho*scene->g, p[2]};

	memset(end, 0, 3*sizeof *end);
	for (int k = 0; k < count; k++) {
		double f[3], size;

		for (int i = 0; i < 3; i++)
			f[i] = F[i] - w[i]*part*(k + 0.5);
		size = sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]);
		for (int i = 0; i < 3; i++)
			end[i] += part*(1.0 + size/scene->cable.EA)*f[i]/size;
		if (joint)
			memcpy(joint[k], end, 3*sizeof *end);
	}
}

static double determinant(const double a[3], const double b[3], const double c[3])
{
	return a[0]*(b[1]*c[2] - b[2]*c[1]) - a[1]*(b[0]*c[2] - b[2]*c[0]) +
	       a[2]*(b[0]*c[1] - b[1]*c[0]);
}

/* One step of Newton's method on the force at end A, with difference quotients. */
static double correct(double F[3], const struct hawser_scene *scene, double length0, int count)
{
	const double want[3] = {scene->span.d, scene->span.h, 0.0}, step = 1e-2;
	double end[3], there[3], J[3][3], gap[3], det; /* J[k]: derivative of the end by F[k] */

	hang(end, scene, length0, count, F, NULL);
	for (int k = 0; k < 3; k++) {
		double moved[3] = {F[0], F[1], F[2]};

		moved[k] += step;
		hang(there, scene, length0, count, moved, NULL);
		for (int i = 0; i < 3; i++)
			J[k][i] = (there[i] - end[i])/step;
	}
	for (int i = 0; i < 3; i++)
		gap[i] = want[i] - end[i];
	det = determinant(J[0], J[1], J[2]);
	F[0] += determinant(gap, J[1], J[2])/det;
	F[1] += determinant(J[0], gap, J[2])/det;
	F[2] += determinant(J[0], J[1], gap)/det;
	return sqrt(gap[0]*gap[0] + gap[1]*gap[1] + gap[2]*gap[2]);
}

/* Largest distance of the joints of a chain from the profile, m; *force: relative error of the force
 * at end A. */
static double apart(double *force, const struct hawser_statics *st, const struct hawser_scene *scene,
                    int count)
{
	static double joint[512][3];
	const double pull[3] = {st->H, st->V0, 0.0};
	double F[3], start[3], at[3], most = 0.0;

	hawser_statics_to_global(st, start, pull);
	for (int i = 0; i < 3; i++)
		F[i] = start[i]*(1.0 + 0.01*(i + 1)); /* a guess that is wrong by percents */
	for (int k = 0; k < 60 && correct(F, scene, st->length0, count) > 1e-9; k++)
		;
	hang(at, scene, st->length0, count, F, joint);
	for (int k = 0; k < count; k++) {
		place(at, st, st->length0*(k + 1)/count);
		most = fmax(most, sqrt(pow(at[0] - joint[k][0], 2) + pow(at[1] - joint[k][1], 2) +
		                       pow(at[2] - joint[k][2], 2)));
	}
	*force = sqrt(pow(F[0] - start[0], 2) + pow(F[1] - start[1], 2) + pow(F[2] - start[2], 2))/st->T0;
	return most;
}

static void against_chain(const char *what, struct hawser_scene *scene)
{
	struct hawser_statics st = solved(scene);
	double force[2], coarse = apart(&force[0], &st, scene, 128);
	double fine = apart(&force[1], &st, scene, 512);

	ok(fine < 3e-5*st.sag && coarse/fine > 15.0 && coarse/fine < 17.0,
	   "%s: distance from a chain of 128 and 512 elements %.2e, %.2e m, of second order", what, coarse,
	   fine);
	ok(force[1] < 3e-5 && force[0]/force[1] > 15.0 && force[0]/force[1] < 17.0,
	   "%s: its pull on end A %.2e, %.2e", what, force[0], force[1]);
}

static void chains(void)
{
	struct hawser_scene scene = scene_of(31.7);

	load(&scene, 0.0, 0.0, 12.7, 0.9);
	against_chain("ice and wind across an inclined span", &scene);
	load(&scene, 5.3, -2.1, -17.9, 0.0);
	scene.span.h = -211.3;
	scene.tension.value = 3.1e3;
	against_chain("any direction, deep and steep", &scene);
	load(&scene, -3.7, 22.9, 4.3, 0.31);
	scene.span.h = 44.1;
	scene.tension.value = 9e3;
	against_chain("lifted", &scene);
}

/* --- reference and loaded state --- */

/* EA a dT + H2 - H1 + EA d^2/24 ((w1/H1)^2 - (w2/H2)^2) = 0 of a level span with small sag, by
 * bisection for H2; the equation that line engineers use. */
static double state_change(const struct hawser_scene *scene, double w1, double w2)
{
	double EA = scene->cable.EA, H1 = scene->tension.value, d = scene->span.d, low = 1e-3*H1,
	       high = 1e3*H1;
	double strain = scene->temperature.change*scene->temperature.expansion;

	for (int i = 0; i < 200; i++) {
		double H = 0.5*(low + high);
		double rest = EA*strain + H - H1 + EA*d*d/24.0*(pow(w1/H1, 2) - pow(w2/H, 2));

		*(rest > 0.0 ? &high : &low) = H;
	}
	return 0.5*(low + high);
}

/* The equation neglects terms of the order of (w d/H)^2, H/EA and a dT: where all three become a
 * quarter, so has the difference. */
static void small_sag(void)
{
	double before = 0.0;

	for (int i = 0; i < 4; i++) {
		struct hawser_scene scene = scene_of(0.0);
		struct hawser_statics st;
		double w, error;

		scene.span.d = 320.0/(1 << i);
		scene.tension.state = HAWSER_STATE_REFERENCE;
		scene.temperature.present = 1;
		scene.temperature.change = -31.0;
		scene.temperature.expansion = 1.89e-5/(1 << 2*i);
		scene.cable.EA *= 1 << 2*i;
		load(&scene, 0.0, 0.0, 9.7, 0.73);
		w = hypot((1.571 + 0.73)*9.81, 9.7);
		st = solved(&scene);
		error = fabs(state_change(&scene, 1.571*9.81, w)/st.H - 1.0);
		ok(error < 0.05*pow(w*scene.span.d/st.H, 2) && (i == 0 || fabs(before/error/4.0 - 1.0) < 0.2),
		   "state-change equation, d = %g m: relative difference %.2e, (w d/H)^2 = %.2e", scene.span.d,
		   error, pow(w*scene.span.d/st.H, 2));
		before = error;
	}
}

static void there_and_back(void)
{
	static const enum hawser_given given[] = {HAWSER_GIVEN_H, HAWSER_GIVEN_T0, HAWSER_GIVEN_T1,
	                                          HAWSER_GIVEN_LENGTH0, HAWSER_GIVEN_SAG};
	struct hawser_scene scene = scene_of(31.7);
	struct hawser_report report = {.message = ""};
	struct hawser_statics st, reference;

	load(&scene, 1.1, 0.7, -14.2, 0.57);
	scene.temperature.present = 1;
	scene.temperature.change = 38.5;
	scene.temperature.expansion = 2.3e-5;
	scene.tension.state = HAWSER_STATE_REFERENCE;
	st = solved(&scene);
	ok(!hawser_statics_reference(&reference, &scene, &report) && !reference.turned &&
	   fabs(reference.H/2.385e4 - 1.0) < 1e-15, "the reference state has the given tension");
	close_to(st.length0, reference.length0*(1.0 + 38.5*2.3e-5), 1e-14,
	         "the length of the cable is held");
	scene.tension.state = HAWSER_STATE_LOADED;
	for (int i = 0; i < 5; i++) {
		struct hawser_statics back;

		scene.tension.given = given[i];
		scene.tension.value = given[i] == HAWSER_GIVEN_H ? st.H : given[i] == HAWSER_GIVEN_T0 ? st.T0
		                      : given[i] == HAWSER_GIVEN_T1 ? st.T1
		                      : given[i] == HAWSER_GIVEN_SAG ? st.sag : st.length0;
		if (ok(!hawser_statics_reference(&back, &scene, &report), "%s", report.message))
			close_to(back.H, reference.H, 1e-11, "back from the loaded state");
	}
}

/* A travelling cable holds what the scene gives, in the loaded state. */
static void travelling(void)
{
	static const enum hawser_given given[] = {HAWSER_GIVEN_H, HAWSER_GIVEN_T0, HAWSER_GIVEN_T1};

	for (int i = 0; i < 3; i++) {
		struct hawser_scene scene = scene_of(31.7);
		struct hawser_statics rest, moving;

		scene.tension.given = given[i];
		scene.tension.state = HAWSER_STATE_REFERENCE;
		load(&scene, 0.0, 0.0, 11.9, 0.4);
		rest = solved(&scene);
		scene.travel.present = 1;
		scene.travel.speed = 9.3;
		moving = solved(&scene);
		if (given[i] == HAWSER_GIVEN_T0)
			close_to(moving.motion.tension, rest.T0, 1e-12, "travelling: T0 held");
		else if (given[i] == HAWSER_GIVEN_T1)
			close_to(moving.motion.tension1, rest.T1, 1e-12, "travelling: T1 held");
		else
			close_to(hawser_statics_actual(&moving).H, rest.H, 1e-12, "travelling: H held");
		close_to(moving.swing, rest.swing, 1e-15, "travelling: the same plane");
	}
}

/* --- refusals --- */

static void refused(struct hawser_scene *scene, enum hawser_status want, const char *words)
{
	struct hawser_report report = {.message = ""};
	struct hawser_statics st;
	enum hawser_status got = hawser_statics_scene(&st, scene, &report);

	ok(got == want && strstr(report.message, words), "%s, saying \"%s\": %s", hawser_status_name(got),
	   words, report.message);
}

/* A load that balances the weight, as buoyancy: the cable is straight, T = EA*(chord/length0 - 1), or
 * has the tension that is given. */
static void afloat(void)
{
	struct hawser_scene scene = scene_of(31.7);
	double chord = hypot(387.3, 31.7), length0 = 385.9;
	struct hawser_statics st;

	load(&scene, 0.0, (1.571 + 0.2)*9.81, 0.0, 0.2);
	scene.tension.given = HAWSER_GIVEN_LENGTH0;
	scene.tension.value = length0;
	st = solved(&scene);
	close_to(st.T0, 2.17e7*(chord/length0 - 1.0), 1e-10, "tension of a straight cable, N");
	close_to(st.T1, st.T0, 1e-10, "the same at both ends, N");
	ok(st.sag < 1e-9*chord, "without sag: %.1e m", st.sag);
	scene.tension.value = chord;
	refused(&scene, HAWSER_ERR_NO_SOLUTION, "the shape is not determined");
	scene.tension.given = HAWSER_GIVEN_SAG;
	refused(&scene, HAWSER_ERR_NO_SOLUTION, "it has no sag");
	scene.tension.given = HAWSER_GIVEN_T1;
	scene.tension.value = 2.385e4;
	st = solved(&scene);
	close_to(st.T0, 2.385e4, 1e-10, "tension of a straight cable that is given, N");
	close_to(st.length0, chord/(1.0 + 2.385e4/2.17e7), 1e-10, "and its length, m");
}

static void refusals(void)
{
	struct hawser_scene scene = scene_of(31.7);

	load(&scene, 2.0*387.3, 1.571*9.81 + 2.0*31.7, 0.0, 0.0);
	refused(&scene, HAWSER_ERR_ARGUMENT, "act along the chord");
	load(&scene, 0.0, INFINITY, 0.0, 0.0);
	refused(&scene, HAWSER_ERR_NO_SOLUTION, "the load");
	load(&scene, 0.0, 0.0, 1.0, 0.0);
	scene.temperature.present = 1;
	scene.temperature.change = -1000.0;
	scene.temperature.expansion = 1.1e-3;
	refused(&scene, HAWSER_ERR_ARGUMENT, "no change of temperature");
}

CASE(property_static_load)
{
	afloat();
	downwards();
	wind_alone();
	upwards();
	chains();
	small_sag();
	there_and_back();
	travelling();
	refusals();
	return done_testing();
}
