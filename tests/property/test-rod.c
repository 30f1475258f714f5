/* Random rods in space: supports balance the loads, errors of order h^2 as they are stated, a turned
 * scene has a turned solution, equilibria found by load steps and from near; refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <string.h>

#include <hawser/rod.h>

#include "rod/so3.h"
#include "tests/tap.h"

enum { LOADS = 5, RODS = 12, GROWN = 6 };

static unsigned long seed = 2385;

static double number(void) /* -1 to 1 */
{
	seed = (seed*1103515245UL + 12345UL) & 0x7fffffffUL;
	return 2.0*(double)seed/0x7fffffff - 1.0;
}

struct scene {
	struct hawser_rod rod;
	struct hawser_rod_segment segment[2];
	struct hawser_rod_load load[LOADS];
};

/* Two segments, weight, a force and a couple at points, loads per length, some of which follow. */
static void make(struct scene *scene)
{
	struct hawser_rod *rod = &scene->rod;

	*rod = (struct hawser_rod){.segment = scene->segment, .segments = 2, .load = scene->load,
		.loads = LOADS, .hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .g = 9.81};
	for (int i = 0; i < 2; i++) {
		double EI = 40.0*exp(number());

		scene->segment[i] = (struct hawser_rod_segment){
			.length = 1.5 + number(), .rho = 0.6 + 0.5*number(), .EA = 2e4, .GA = {8e3, 9e3},
			.EI = {EI, 2.0*EI}, .GJ = 0.7*EI, .elements = 12,
			.curvature = {number(), number(), number()}};
		rod->length += scene->segment[i].length;
	}
	for (int k = 0; k < 3; k++) {
		rod->at[k] = number();
		rod->tangent[k] = number();
		rod->normal[k] = number();
	}
	for (int l = 0; l < LOADS; l++) {
		struct hawser_rod_load *load = &scene->load[l];

		memset(load, 0, sizeof *load);
		load->distributed = l % 2;
		load->follower = l > 2;
		load->from = l % 2 ? 0.2*rod->length : (0.5 + 0.5*(l > 0))*rod->length;
		load->to = l % 2 ? 0.8*rod->length : load->from;
		for (int k = 0; k < 3; k++) {
			load->force[k] = 8.0*number();
			load->moment[k] = 3.0*number();
		}
	}
}

static void add_moment(double to[3], const double arm[3], const double force[3], double part)
{
	double c[3];

	hawser__cross(c, arm, force);
	for (int k = 0; k < 3; k++)
		to[k] += part*c[k];
}

/* Defects of the balance of forces and of moments about the origin, of what each node bears. */
static void balance(double *force, double *moment, const struct scene *scene,
                    const struct hawser_rod_statics *st)
{
	const struct hawser_rod *rod = &scene->rod;
	double f[3] = {0.0}, m[3] = {0.0};

	for (int k = 0; k < 3; k++) {
		f[k] = st->force[0][k];
		m[k] = st->moment[0][k];
	}
	add_moment(m, st->point[0].x, st->force[0], 1.0);
	for (int l = -1; l < rod->loads; l++)
		for (int i = 0; i < st->points; i++) {
			const struct hawser_rod_point *p = &st->point[i];
			double R[9], own[3] = {0.0}, couple[3] = {0.0}, part = 0.0;

			hawser__quaternion_matrix(R, p->q);
			for (int side = -1; side <= 1; side += 2) {
				const struct hawser_rod_point *other = p + side;
				double middle, h;

				if (i + side < 0 || i + side >= st->points)
					continue;
				middle = 0.5*(p->s + other->s);
				h = 0.5*fabs(p->s - other->s);
				if (l < 0)
					part += h*rod->g*rod->segment[middle > rod->segment[0].length].rho;
				else if (rod->load[l].distributed && middle > rod->load[l].from &&
				         middle < rod->load[l].to)
					part += h;
			}
			if (l >= 0 && !rod->load[l].distributed)
				part = fabs(p->s - rod->load[l].from) < 1e-9;
			own[1] = -(l < 0);
			if (l >= 0 && rod->load[l].follower) {
				hawser__apply(own, R, rod->load[l].force);
				hawser__apply(couple, R, rod->load[l].moment);
			} else if (l >= 0) {
				memcpy(own, rod->load[l].force, sizeof own);
				memcpy(couple, rod->load[l].moment, sizeof couple);
			}
			for (int k = 0; k < 3; k++) {
				f[k] += part*own[k];
				m[k] += part*couple[k];
			}
			add_moment(m, p->x, own, part);
		}
	*force = sqrt(hawser__dot(f, f));
	*moment = sqrt(hawser__dot(m, m));
}

static double distance(const double a[3], const double b[3])
{
	return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static void random_rods(void)
{
	double force = 0.0, moment = 0.0, low = INFINITY, high = 0.0, stated = 0.0;
	int failed = 0;

	for (int c = 0; c < RODS; c++) {
		struct scene scene;
		struct hawser_rod_statics st[3];
		struct hawser_report report;
		double defect[2], coarse, fine, ratio;

		make(&scene);
		memset(st, 0, sizeof st);
		for (int i = 0; i < 3; i++) {
			struct hawser_rod_options options = {.refine = 1 << i, .skip_error = i > 0, .steps = 4};

			failed += hawser_rod_solve(&st[i], &scene.rod, &options, &report) != HAWSER_OK;
			if (failed)
				return (void)ok(0, "rod %d: %s", c, report.message);
			balance(&defect[0], &defect[1], &scene, &st[i]);
			force = fmax(force, defect[0]);
			moment = fmax(moment, defect[1]);
		}
		coarse = distance(st[0].point[st[0].points - 1].x, st[1].point[st[1].points - 1].x);
		fine = distance(st[1].point[st[1].points - 1].x, st[2].point[st[2].points - 1].x);
		ratio = coarse/fine;
		low = fmin(low, ratio);
		high = fmax(high, ratio);
		stated = fmax(stated, (coarse + fine)/st[0].error_x);
		for (int i = 0; i < 3; i++)
			hawser_rod_statics_clear(&st[i]);
	}
	ok(force < 1e-9 && moment < 1e-9, "supports balance loads: defects %.1e N, %.1e N m", force,
	   moment);
	ok(low > 3.7 && high < 4.3, "twice as many elements: errors fall by %.3f to %.3f", low, high);
	ok(stated < 1.02, "error of places at the tip: at most %.3f of what is stated", stated);
}

/* A force and a moment of fixed directions: the equilibrium is that of 50 load steps. The whole load
 * at once leads the first of the rods, of the outside program's kind, to another one, where it gives
 * way. */
static void grown(void)
{
	double worst = 0.0, other = 0.0;

	for (int c = 0; c < GROWN; c++) {
		struct hawser_rod_segment segment = {.length = 4.607, .EA = 25180.0, .GA = {12590.0, 12590.0},
		                                     .EI = {5.3446, 5.3446}, .GJ = 3.6617, .elements = 20};
		struct hawser_rod_load load[2] = {
			{.from = 4.607, .to = 4.607, .force = {-1.28575, 0.49626, 0.0}},
			{.from = 4.607, .to = 4.607, .moment = {0.0, 0.0, -0.47477}}};
		struct hawser_rod rod = {.segment = &segment, .segments = 1, .length = 4.607, .load = load,
			.loads = 2, .hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .tangent = {1.0},
			.normal = {0.0, 1.0}};
		struct hawser_rod_statics st[2];
		struct hawser_report report;

		for (int k = 0; k < 3 && c > 0; k++) {
			load[0].force[k] = number();
			load[1].moment[k] = 2.0*number();
		}
		for (int i = 0; i < 2; i++) {
			struct hawser_rod_options options = {.skip_error = 1, .steps = i ? 50 : 0};

			if (hawser_rod_solve(&st[i], &rod, &options, &report))
				return (void)ok(0, "rod %d: %s", c, report.message);
		}
		worst = fmax(worst, distance(st[0].point[20].x, st[1].point[20].x));
		other = c == 0 ? st[0].other : other;
		for (int i = 0; i < 2; i++)
			hawser_rod_statics_clear(&st[i]);
	}
	ok(worst < 1e-6, "as the load grows: tips of %d rods within %.1e m", GROWN, worst);
	ok(other > 4.607, "and that another equilibrium of the first is %.3g m away is stated", other);
}

/* The whole scene turned. */
static void turned(void)
{
	double v[3] = {1.1, -2.0, 0.7}, q[4], R[9], worst = 0.0, size = 0.0;
	struct scene scene;
	struct hawser_rod_statics st[2];
	struct hawser_rod_options options = {.steps = 4};
	struct hawser_report report;

	hawser__quaternion_exp(q, v);
	hawser__quaternion_matrix(R, q);
	make(&scene);
	scene.rod.g = 0.0;
	memset(scene.rod.at, 0, sizeof scene.rod.at);
	for (int i = 0; i < 2; i++) {
		if (hawser_rod_solve(&st[i], &scene.rod, &options, &report))
			return (void)ok(0, "%s", report.message);
		for (int l = -1; l < LOADS && i == 0; l++) {
			double *one = l < 0 ? scene.rod.tangent : scene.load[l].force;
			double *other = l < 0 ? scene.rod.normal : scene.load[l].moment, a[3], b[3];

			if (l >= 0 && scene.load[l].follower)
				continue;
			hawser__apply(a, R, one);
			hawser__apply(b, R, other);
			memcpy(one, a, sizeof a);
			memcpy(other, b, sizeof b);
		}
	}
	for (int i = 0; i < st[0].points; i++) {
		double x[3];

		hawser__apply(x, R, st[0].point[i].x);
		worst = fmax(worst, distance(x, st[1].point[i].x));
		for (int k = 0; k < 3; k++) {
			worst = fmax(worst, fabs(st[0].point[i].M[k] - st[1].point[i].M[k])/100.0);
			size = fmax(size, fabs(st[0].point[i].M[k]));
		}
	}
	ok(worst < 1e-10 && size > 1.0, "a turned scene has the turned solution to %.1e", worst);
	hawser_rod_statics_clear(&st[0]);
	hawser_rod_statics_clear(&st[1]);
}

/* A straight rod whose clamped end is brought to half a circle. */
static void brought(void)
{
	const double pi = acos(-1.0);
	struct hawser_rod_segment segment = {.length = 2.0, .EA = 1e5, .GA = {1e5, 1e5}, .EI = {3.0, 3.0},
	                                     .GJ = 2.0, .elements = 40};
	struct hawser_rod rod = {.segment = &segment, .segments = 1, .length = 2.0, .tangent = {1.0},
		.normal = {0.0, 1.0}, .placed = 1, .turned = 1, .end_at = {0.0, 4.0/pi}, .end_tangent = {-1.0},
		.end_normal = {0.0, -1.0}};
	struct hawser_rod_statics st;
	struct hawser_report report;

	if (!ok(hawser_rod_solve(&st, &rod, NULL, &report) == HAWSER_OK, "an end that is brought round"))
		return;
	close_to(st.M_max, 1.5*pi, 2e-3, "moment of half a circle");
	close_to(st.point[20].x[0], 2.0/pi, 1e-3, "its farthest point");
	close_to(st.energy, 0.5*3.0*0.25*pi*pi*2.0, 2e-3, "its energy");
	hawser_rod_statics_clear(&st);
	rod.turned = 0;
	rod.end_at[0] = -1.4;
	rod.end_at[1] = 0.2;
	if (!ok(hawser_rod_solve(&st, &rod, NULL, &report) == HAWSER_OK, "an end beyond the start"))
		return;
	ok(st.strain < 0.1 && st.error_x < 0.02, "its strain %.1e, mesh error %.1e m", st.strain,
	   st.error_x);
	hawser_rod_statics_clear(&st);
}

/* Nearly inextensible rods: as those that stretch a little, with as many iterations, or refused. */
static void stiff(void)
{
	struct hawser_rod_segment segment = {.length = 1.0, .EI = {1.0, 2.0}, .GJ = 0.5, .elements = 40,
	                                     .curvature = {0.5, 0.0, 2.0}};
	struct hawser_rod_load load[2] = {{.from = 1.0, .to = 1.0, .force = {20.0, -15.0, 10.0}},
	                                  {.to = 1.0, .distributed = 1, .moment = {0.0, 0.3, 0.5}}};
	struct hawser_rod rod = {.segment = &segment, .segments = 1, .length = 1.0, .tangent = {1.0},
		.normal = {0.0, 1.0}, .hold = {HAWSER_ROD_CLAMPED, HAWSER_ROD_FREE}, .load = load,
		.loads = 2};
	struct hawser_report report = {0};
	double tip[2][3];
	int most = 0;

	for (int i = 0; i < 4; i++) {
		struct hawser_rod_statics st;
		enum hawser_status status;

		segment.EA = pow(10.0, (double[]){6.0, 9.0, 11.0, 30.0}[i]);
		segment.GA[0] = segment.GA[1] = segment.EA;
		status = hawser_rod_solve(&st, &rod, NULL, &report);
		if (i == 3) {
			ok(status == HAWSER_ERR_CONVERGENCE && strstr(report.message, "Give at most"),
			   "EA 1e30: %s", report.message);
		} else if (!ok(status == HAWSER_OK, "EA %.0e: %d iterations", segment.EA, st.iterations)) {
			return;
		} else {
			most = st.iterations > most ? st.iterations : most;
			memcpy(tip[i > 0], st.point[st.points - 1].x, sizeof tip[0]);
			ok(distance(tip[0], tip[i > 0]) < 1e-4, "its tip moves by %.1e m",
			   distance(tip[0], tip[i > 0]));
		}
		hawser_rod_statics_clear(&st);
	}
	ok(most <= 40, "at most %d iterations", most);
}

static void refused(void)
{
	struct scene scene;
	struct hawser_rod_statics st;
	struct hawser_report report;

	make(&scene);
	scene.rod.hold[0] = HAWSER_ROD_FREE;
	ok(hawser_rod_solve(&st, &scene.rod, NULL, &report) == HAWSER_ERR_NO_SOLUTION, "both ends free: %s",
	   report.message);
	scene.rod.hold[0] = HAWSER_ROD_CLAMPED;
	scene.load[0].force[1] = 1e9;
	ok(hawser_rod_solve(&st, &scene.rod, NULL, &report) != HAWSER_OK || st.strain > 1.0,
	   "a thousand tons on a wire: %s", report.message);
	hawser_rod_statics_clear(&st);
	scene.load[0].force[1] = NAN;
	ok(hawser_rod_solve(&st, &scene.rod, NULL, &report) == HAWSER_ERR_NAN, "not a number: %s",
	   report.message);
	ok(hawser_rod_solve(&st, &scene.rod, &(struct hawser_rod_options){.refine = INT_MAX}, &report) ==
	   HAWSER_ERR_ARGUMENT, "more elements than an int counts: %s", report.message);
}

CASE(property_rod)
{
	random_rods();
	turned();
	grown();
	brought();
	stiff();
	refused();
	return done_testing();
}
