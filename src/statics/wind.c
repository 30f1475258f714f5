/* statics/wind.c - drag and lift of a section in a flow, and the wind of a scene.
 *
 *   U, v     speed of the flow, velocity of the section; along the flow (1) and across it (2)
 *   p        (U - v_1, -v_2), the flow that the section feels; R p = (-p_2, p_1)
 *   g        angle of attack: that at rest plus the angle of p from direction 1 towards 2
 *   Re       |p| D/nu, Reynolds' number
 *   f        half |p| (C_D(g, Re) p + C_L(g) R p)
 *
 * The quasi-steady force of a flow that changes slowly against D/U. The section does not turn. With a
 * table over Re, C_D(g, Re) = C(Re) + C_D(g) - C_D(0).
 *
 * The series is that of f itself: sums, products and compositions of polynomials in (v_1, v_2) that are
 * cut off above degree 3, so that every law with a third derivative has one. Of a law without Re, f is
 * homogeneous of degree 2 in p, and the only cubic term is that of v_2^3 (tests/unit/test-wind.c). A
 * table is a natural cubic spline, whose third derivative jumps at the knots: there it is the mean of
 * both sides. Outside its range a table keeps its end values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "statics/wind.h"

enum { TERMS = HAWSER__WIND_TERMS, ORDER = 3 };
const int hawser__wind_power[TERMS][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0},
                                          {2, 1}, {1, 2}, {0, 3}};

/* --- laws --- */

static void powers(struct hawser__coefficient *law, const double *value, int count)
{
	law->powers = count > 0 ? count : 1;
	memcpy(law->power, value, (size_t)law->powers*sizeof *value);
}

/* Second derivatives of the natural spline, by elimination in the tridiagonal system. */
static void spline(struct hawser__coefficient *law, const double *x, const double *y, int stride,
                   int count)
{
	double pivot[HAWSER_WIND_ROWS], *m = law->bend;

	law->knots = count;
	for (int i = 0; i < count; i++) {
		law->x[i] = x[i*stride];
		law->y[i] = y[i*stride];
		m[i] = 0.0;
	}
	for (int i = 1; i < count - 1; i++) {
		double h = law->x[i] - law->x[i - 1], next = law->x[i + 1] - law->x[i];
		double factor = i > 1 ? h/pivot[i - 1] : 0.0;

		pivot[i] = 2.0*(h + next) - factor*h;
		m[i] = 6.0*((law->y[i + 1] - law->y[i])/next - (law->y[i] - law->y[i - 1])/h) -
		       factor*m[i - 1];
	}
	for (int i = count - 2; i > 0; i--)
		m[i] = (m[i] - (law->x[i + 1] - law->x[i])*m[i + 1])/pivot[i];
}

/* Taylor's coefficients c [4] of the spline's piece between knots i and i + 1. */
static void piece(double c[ORDER + 1], const struct hawser__coefficient *law, int i, double x)
{
	double h = law->x[i + 1] - law->x[i], t = x - law->x[i];
	double third = (law->bend[i + 1] - law->bend[i])/h;
	double slope = (law->y[i + 1] - law->y[i])/h - h*(2.0*law->bend[i] + law->bend[i + 1])/6.0;

	c[0] = law->y[i] + t*(slope + t*(law->bend[i]/2.0 + t*third/6.0));
	c[1] = slope + t*(law->bend[i] + t*third/2.0);
	c[2] = (law->bend[i] + t*third)/2.0;
	c[3] = third/6.0;
}

/* Taylor's coefficients c [4] of a law at x. */
static void expand(double c[ORDER + 1], const struct hawser__coefficient *law, double x)
{
	int last = law->knots - 1, i = 0;

	memset(c, 0, (ORDER + 1)*sizeof *c);
	if (law->powers) {
		for (int p = law->powers - 1; p >= 0; p--) {
			for (int k = ORDER; k > 0; k--)
				c[k] = c[k]*x + c[k - 1];
			c[0] = c[0]*x + law->power[p];
		}
	} else if (x < law->x[0] || x > law->x[last]) {
		c[0] = law->y[x > law->x[last] ? last : 0];
	} else {
		while (i + 2 < law->knots && x >= law->x[i + 1])
			i++;
		piece(c, law, i, x);
		if (i > 0 && x == law->x[i]) {
			double before[ORDER + 1];

			piece(before, law, i - 1, x);
			c[3] = 0.5*(c[3] + before[3]);
		}
	}
}

void hawser__section_make(struct hawser__section *section, const struct hawser_wind *wind)
{
	double c[ORDER + 1];

	memset(section, 0, sizeof *section);
	section->half = 0.5*wind->density*wind->diameter;
	section->angle = wind->angle;
	if (wind->tables) {
		spline(&section->drag, &wind->table[0][0], &wind->table[0][1], 3, wind->tables);
		spline(&section->lift, &wind->table[0][0], &wind->table[0][2], 3, wind->tables);
	} else {
		powers(&section->drag, wind->drag, wind->drags);
		powers(&section->lift, wind->lift, wind->lifts);
	}
	if (wind->crises) {
		spline(&section->reynolds, &wind->reynolds[0][0], &wind->reynolds[0][1], 2, wind->crises);
		section->per_speed = wind->diameter/wind->viscosity;
	}
	expand(c, &section->drag, 0.0);
	section->reference = c[0];
	section->turns = section->drag.powers != 1 || section->lift.powers != 1 || wind->crises > 0;
}

/* --- force --- */

/* C_D, C_L, and their derivatives by the angle; reynolds: of C_D by |p|. */
struct coefficients {
	double drag, drag_angle, drag_speed, lift, lift_angle;
};

static struct coefficients coefficients(const struct hawser__section *section, const double p[2],
                                        double speed)
{
	struct coefficients of = {.drag = section->drag.power[0], .lift = section->lift.power[0]};
	double c[ORDER + 1], angle;

	if (!section->turns)
		return of;
	angle = section->angle + atan2(p[1], p[0]);
	expand(c, &section->drag, angle);
	of.drag = c[0];
	of.drag_angle = c[1];
	expand(c, &section->lift, angle);
	of.lift = c[0];
	of.lift_angle = c[1];
	if (section->reynolds.knots) {
		expand(c, &section->reynolds, speed*section->per_speed);
		of.drag += c[0] - section->reference;
		of.drag_speed = c[1]*section->per_speed;
	}
	return of;
}

void hawser__section_force(double f[2], double (*by_v)[2], const struct hawser__section *section,
                           double speed, const double v[2])
{
	const double p[2] = {speed - v[0], -v[1]}, norm = sqrt(p[0]*p[0] + p[1]*p[1]);
	struct coefficients is;

	f[0] = f[1] = 0.0;
	if (by_v)
		memset(by_v, 0, 4*sizeof(double));
	if (norm == 0.0)
		return; /* the force is of second order there, and its derivative 0 */
	is = coefficients(section, p, norm);
	f[0] = section->half*norm*(is.drag*p[0] - is.lift*p[1]);
	f[1] = section->half*norm*(is.drag*p[1] + is.lift*p[0]);
	if (!by_v)
		return;
	for (int c = 0; c < 2; c++) {
		double unit = p[c]/norm, part = unit/norm;

		by_v[0][c] = -f[0]*part - section->half*norm*(c ? -is.lift : is.drag);
		by_v[1][c] = -f[1]*part - section->half*norm*(c ? is.drag : is.lift);
		if (section->turns) {
			double turn = (c ? p[0] : -p[1])/(norm*norm), lift = is.lift_angle*turn;
			double drag = is.drag_angle*turn + is.drag_speed*unit;

			by_v[0][c] -= section->half*norm*(drag*p[0] - lift*p[1]);
			by_v[1][c] -= section->half*norm*(drag*p[1] + lift*p[0]);
		}
	}
}

double hawser__flow_frame(double e[2][3], const double U[3], const double t[3])
{
	double along = hawser__dot(U, t), size, up[3] = {-t[0]*t[1], 1.0 - t[1]*t[1], -t[1]*t[2]};

	for (int k = 0; k < 3; k++)
		e[0][k] = U[k] - along*t[k];
	size = hawser__norm(e[0]);
	if (!(size > 0.0) && hawser__norm(up) > 0.0)
		memcpy(e[0], up, sizeof up);
	else if (!(size > 0.0))
		memcpy(e[0], (const double[3]){1.0}, sizeof up);
	along = hawser__norm(e[0]);
	for (int k = 0; k < 3; k++)
		e[0][k] /= along;
	hawser__cross(e[1], t, e[0]);
	along = e[1][1] < 0.0 ? -1.0 : 1.0;
	for (int k = 0; k < 3; k++)
		e[1][k] *= along;
	return size;
}

/* The axes turn with t by the angle (U.t)/|U normal to t| times (dt.e2) about t, and out of the plane
 * normal to it. */
void hawser__section_line(double f[3], double (*f_r)[3], double (*f_x)[3],
                          const struct hawser__section *section, const double U[3], const double r[3],
                          const double t[3], double inverse)
{
	double e[2][3], size = hawser__flow_frame(e, U, t), local[2], by_v[2][2];
	const double p[2] = {hawser__dot(e[0], r), hawser__dot(e[1], r)}, past = hawser__dot(t, r);
	const double turn = size > 0.0 ? hawser__dot(t, U)/size : 0.0;

	hawser__section_force(local, by_v, section, size, (const double[2]){size - p[0], -p[1]});
	for (int i = 0; i < 3; i++)
		f[i] = local[0]*e[0][i] + local[1]*e[1][i];
	for (int k = 0; k < 9 && f_r; k++) {
		int i = k/3, j = k%3;
		double twist = turn*e[1][j], dp[2], df[2]; /* by t_j */

		f_r[i][j] = 0.0;
		for (int c = 0; c < 4; c++)
			f_r[i][j] -= e[c/2][i]*by_v[c/2][c%2]*e[c%2][j];
		dp[0] = -twist*p[1] - past*e[0][j];
		dp[1] = twist*p[0] - past*e[1][j];
		for (int c = 0; c < 2; c++)
			df[c] = -by_v[c][0]*dp[0] - by_v[c][1]*dp[1];
		f_x[i][j] = inverse*((df[0] + twist*local[1])*e[0][i] + (df[1] - twist*local[0])*e[1][i] -
		                     t[i]*(local[0]*e[0][j] + local[1]*e[1][j]));
	}
}

/* --- series --- */

/* c = a b, cut off. */
static void multiply(double *c, const double *a, const double *b)
{
	double product[TERMS] = {0.0};

	for (int i = 0; i < TERMS; i++)
		for (int j = 0; j < TERMS; j++) {
			int across = hawser__wind_power[i][1] + hawser__wind_power[j][1];
			int degree = hawser__wind_power[i][0] + hawser__wind_power[j][0] + across;

			if (degree > ORDER)
				break;
			product[hawser__wind_term(degree, across)] += a[i]*b[j];
		}
	memcpy(c, product, sizeof product);
}

/* to = sum of c[k] (x - its constant term)^k. */
static void compose(double to[TERMS], const double c[ORDER + 1], const double x[TERMS])
{
	double change[TERMS];

	memcpy(change, x, sizeof change);
	change[0] = 0.0;
	memset(to, 0, TERMS*sizeof *to);
	for (int k = ORDER; k >= 0; k--) {
		multiply(to, to, change);
		to[0] += c[k];
	}
}

void hawser__section_series(double series[2][TERMS], const struct hawser__section *section,
                            double speed)
{
	const double U = speed, arc[ORDER + 1] = {0.0, 1.0, 0.0, -1.0/3.0};
	const double inverse[ORDER + 1] = {1.0/U, -1.0/(U*U), 1.0/(U*U*U), -1.0/(U*U*U*U)};
	const double root[ORDER + 1] = {U, 0.5/U, -0.125/(U*U*U), 0.0625/(U*U*U*U*U)};
	const double p[2][TERMS] = {{U, -1.0}, {0.0, 0.0, -1.0}};
	double norm[TERMS], angle[TERMS], drag[TERMS], lift[TERMS], c[ORDER + 1], square[TERMS];

	multiply(square, p[0], p[0]);
	multiply(norm, p[1], p[1]);
	for (int t = 0; t < TERMS; t++)
		square[t] += norm[t];
	compose(norm, root, square);
	compose(angle, inverse, p[0]);
	multiply(angle, angle, p[1]);
	compose(angle, arc, angle);
	expand(c, &section->drag, section->angle);
	compose(drag, c, angle);
	expand(c, &section->lift, section->angle);
	compose(lift, c, angle);
	if (section->reynolds.knots) {
		double change[TERMS];

		expand(c, &section->reynolds, U*section->per_speed);
		for (int k = 1, power = 1; k <= ORDER; k++)
			c[k] *= pow(section->per_speed, power++);
		compose(change, c, norm);
		for (int t = 0; t < TERMS; t++)
			drag[t] += change[t];
		drag[0] -= section->reference;
	}
	for (int i = 0; i < 2; i++) {
		double along[TERMS], across[TERMS];

		multiply(along, drag, p[i]);
		multiply(across, lift, p[1 - i]);
		for (int t = 0; t < TERMS; t++)
			along[t] = section->half*(along[t] + (i ? across[t] : -across[t]));
		multiply(series[i], along, norm);
	}
}

/* --- wind of a scene --- */

double hawser__wind_profile(const struct hawser_wind *wind, double part)
{
	const double (*row)[2] = wind->profile;
	int i = 0;

	if (wind->profiles == 0)
		return 1.0;
	while (i < wind->profiles && row[i][0] < part)
		i++;
	if (i == 0 || i == wind->profiles)
		return row[i ? i - 1 : 0][1];
	return row[i - 1][1] + (row[i][1] - row[i - 1][1])*(part - row[i - 1][0])/
	                       (row[i][0] - row[i - 1][0]);
}

/* The mean of the square of the profile: Simpson's rule, exact between its places. */
static double mean_square(const struct hawser_wind *wind)
{
	double sum = 0.0, from = 0.0;

	for (int i = 0; i <= wind->profiles; i++) {
		double to = i < wind->profiles ? fmin(wind->profile[i][0], 1.0) : 1.0;
		double a = hawser__wind_profile(wind, from), b = hawser__wind_profile(wind, to);

		sum += (to - from)*(a*a + a*b + b*b)/3.0;
		from = to;
	}
	return sum;
}

double hawser__added_mass(const struct hawser_scene *scene)
{
	const struct hawser_wind *wind = &scene->wind;

	return wind->present && wind->wake.present
	       ? wind->wake.added_mass*wind->density*M_PI/4.0*wind->diameter*wind->diameter : 0.0;
}

int hawser__static_load(double force[3], const struct hawser_scene *scene)
{
	static const double rest[2] = {0.0};
	const double *blow = scene->wind.direction;
	double t[3] = {scene->span.d, scene->span.h}, U[3], e[2][3], chord = hawser__norm(t), speed, f[2];
	struct hawser__section section;

	for (int c = 0; c < 3; c++)
		force[c] = scene->static_load.present ? scene->static_load.per_length[c] : 0.0;
	if (!scene->wind.present)
		return scene->static_load.present;
	for (int c = 0; c < 3; c++) {
		t[c] /= chord;
		U[c] = scene->wind.speed*blow[c]/hawser__norm(blow);
	}
	speed = hawser__flow_frame(e, U, t);
	if (!(speed > 0.0))
		return 1;
	hawser__section_make(&section, &scene->wind);
	hawser__section_force(f, NULL, &section, speed*sqrt(mean_square(&scene->wind)), rest);
	for (int c = 0; c < 3; c++)
		force[c] += f[0]*e[0][c] + f[1]*e[1][c];
	return 1;
}
