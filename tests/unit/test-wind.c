/* Drag and lift of a section: the derivative of the force against differences, the series against a
 * formula by hand and against the force, of sums of powers and of tables; the speeds between which the
 * drag crisis makes a section unstable along the wind; and the wind on a span at rest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "statics/wind.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static const struct hawser_wind iced = {
	.present = 1, .speed = 7.0, .density = 1.225, .diameter = 0.032, .angle = 0.11,
	.drag = {1.0, -0.4, 1.5, 0.3, -0.7}, .drags = 5, .lift = {0.6, -1.8, 0.2, 8.0}, .lifts = 4};

/* f by the series at v. */
static void sum(double f[2], double series[2][HAWSER__WIND_TERMS], const double v[2])
{
	for (int i = 0; i < 2; i++) {
		f[i] = 0.0;
		for (int t = 0; t < HAWSER__WIND_TERMS; t++)
			f[i] += series[i][t]*pow(v[0], hawser__wind_power[t][0])*
			        pow(v[1], hawser__wind_power[t][1]);
	}
}

/* The derivative against central differences, and the defect of the series, which falls with the
 * fourth power of the velocity. */
static void check_section(const struct hawser_wind *wind, double speed, const char *what)
{
	const double v[2] = {0.83, -1.27}, h = 1e-5*speed;
	struct hawser__section section;
	double f[2], by_v[2][2], series[2][HAWSER__WIND_TERMS], gap[2] = {0.0}, worst = 0.0, most = 0.0;

	hawser__section_make(&section, wind);
	hawser__section_force(f, by_v, &section, speed, v);
	for (int c = 0; c < 2; c++) {
		double up[2], down[2], at[2] = {v[0], v[1]};

		at[c] = v[c] + h;
		hawser__section_force(up, NULL, &section, speed, at);
		at[c] = v[c] - h;
		hawser__section_force(down, NULL, &section, speed, at);
		for (int i = 0; i < 2; i++) {
			worst = fmax(worst, fabs((up[i] - down[i])/(2.0*h) - by_v[i][c]));
			most = fmax(most, fabs(by_v[i][c]));
		}
	}
	ok(worst < 1e-7*most, "%s: derivative against differences, %.1e", what, worst/most);
	hawser__section_series(series, &section, speed);
	for (int k = 0; k < 2; k++) {
		double at[2] = {0.01*speed*(k ? 0.5 : 1.0), -0.013*speed*(k ? 0.5 : 1.0)}, by_series[2];

		hawser__section_force(f, NULL, &section, speed, at);
		sum(by_series, series, at);
		gap[k] = fmax(fabs(f[0] - by_series[0]), fabs(f[1] - by_series[1]));
	}
	ok(gap[0] < 1e-5*fabs(series[0][0]) && gap[0] > 12.0*gap[1] && gap[0] < 20.0*gap[1],
	   "%s: the series is right to the third order, defect %.2e, at half the velocity 1/%.3g", what,
	   gap[0]/fabs(series[0][0]), gap[0]/gap[1]);
}

/* Of powers, by hand: f_i = q [h_i0 (1 - b)^2 + h_i1 a (1 - b) + h_i2 a^2 + h_i3 a^3] with a = v_2/U,
 * b = v_1/U, q = density D U^2/2. */
static void by_hand(void)
{
	const double U = 6.0, *d = iced.drag, *l = iced.lift, q = 0.5*iced.density*iced.diameter*U*U;
	const double h[2][4] = {
		{d[0], l[0] - d[1], d[0]/2 + d[2] - l[1], l[0]/2 + l[2] - d[1]/6 - d[3]},
		{l[0], -(d[0] + l[1]), l[0]/2 + l[2] + d[1], -(d[0]/2 + d[2] + l[1]/6 + l[3])}};
	struct hawser_wind wind = iced;
	struct hawser__section section;
	double series[2][HAWSER__WIND_TERMS], worst = 0.0;

	wind.angle = 0.0;
	hawser__section_make(&section, &wind);
	hawser__section_series(series, &section, U);
	for (int i = 0; i < 2; i++) {
		const double want[HAWSER__WIND_TERMS] = {h[i][0], -2.0*h[i][0]/U, h[i][1]/U, h[i][0]/(U*U),
			-h[i][1]/(U*U), h[i][2]/(U*U), 0.0, 0.0, 0.0, h[i][3]/(U*U*U)};

		for (int t = 0; t < HAWSER__WIND_TERMS; t++)
			worst = fmax(worst, fabs(series[i][t]/q - want[t]));
	}
	ok(worst < 1e-14, "series of sums of powers against the formula, %.1e", worst);
}

/* A table of the same polynomials. */
static void table(void)
{
	struct hawser_wind wind = iced;

	wind.tables = 41;
	for (int i = 0; i < wind.tables; i++) {
		double x = -1.0 + 0.05*i;

		wind.table[i][0] = x;
		wind.table[i][1] = 1.0 - 0.4*x + 1.5*x*x;
		wind.table[i][2] = 0.6 - 1.8*x + 8.0*x*x*x;
	}
	wind.angle = 0.123;
	check_section(&wind, 9.0, "a table");
}

/* C_D = 0.8 - 0.3 tanh((Re - 3e5)/3e4): damping along the wind density U D (2 C_D + Re C_D')/2. */
static void crisis(void)
{
	struct hawser_wind wind = {.present = 1, .density = 1.225, .diameter = 0.16, .viscosity = 1.5e-5,
	                           .crises = 61};
	const double rest[2] = {0.0}, want[2] = {26.352355, 31.357107};
	struct hawser__section section;

	for (int i = 0; i < wind.crises; i++) {
		wind.reynolds[i][0] = 1.5e5 + 5e3*i;
		wind.reynolds[i][1] = 0.8 - 0.3*tanh((wind.reynolds[i][0] - 3e5)/3e4);
	}
	hawser__section_make(&section, &wind);
	for (int end = 0; end < 2; end++) {
		double low = end ? 29.0 : 24.0, high = end ? 34.0 : 29.0, f[2], by_v[2][2];

		for (int i = 0; i < 50; i++) {
			double U = 0.5*(low + high);

			hawser__section_force(f, by_v, &section, U, rest);
			*((by_v[0][0] > 0.0) == end ? &low : &high) = U;
		}
		close_to(low, want[end], 1e-4, end ? "the drag crisis ends" : "the drag crisis begins");
	}
	check_section(&wind, 27.55, "Reynolds"); /* between two knots */
}

/* Of a line in space: its derivatives against differences. */
static void along_a_line(void)
{
	const double U[3] = {3.1, -1.2, 6.7}, r[3] = {2.4, -0.3, 7.9}, x[3] = {2.0, 0.7, -0.4}, h = 1e-6;
	struct hawser__section section;
	double f[3], f_r[3][3], f_x[3][3], unused[3][3], worst = 0.0;

	hawser__section_make(&section, &iced);
	for (int k = -1; k < 6; k++) {
		double t[3], g[2][3];

		for (int side = 0; side < 2; side++) {
			double flow[3] = {r[0], r[1], r[2]}, way[3] = {x[0], x[1], x[2]}, length;

			*(k < 0 ? flow : k < 3 ? &flow[k] : &way[k - 3]) += k < 0 ? 0.0 : side ? -h : h;
			length = sqrt(way[0]*way[0] + way[1]*way[1] + way[2]*way[2]);
			for (int i = 0; i < 3; i++)
				t[i] = way[i]/length;
			hawser__section_line(g[side], k < 0 ? f_r : unused, k < 0 ? f_x : unused, &section, U, flow,
			                     t, 1.0/length);
		}
		for (int i = 0; i < 3 && k >= 0; i++)
			worst = fmax(worst, fabs((g[0][i] - g[1][i])/(2.0*h) -
			                         (k < 3 ? f_r[i][k] : f_x[i][k - 3])));
		if (k < 0)
			memcpy(f, g[0], sizeof f);
	}
	ok(worst < 1e-8, "a line: derivatives against differences, %.1e", worst);
	close_to(fabs(f[0]*x[0] + f[1]*x[1] + f[2]*x[2]) + 1.0, 1.0, 1e-14, "nothing acts along it");
}

static void on_a_span(void)
{
	const char *text = "cable: {EA: 25 MN, rho: 1.6}\nspan: {d: 40, h: 30}\ntension: {H: 30 kN}\n"
	                   "wind: {speed: 8, direction: [3, 0, 4], density: 1.25, diameter: 0.03,\n"
	                   "       drag: [1.1, 0.2], lift: 0.3, profile: [[0, 0.8], [0.5, 1.2]]}\n";
	struct hawser_report report;
	struct hawser_scene scene;
	double force[3], across, mean;
	/* chord (4, 3, 0)/5; wind (3, 0, 4)/5 less its part along it: (27, -36, 100)/125 */
	const double blow[3] = {27.0/125.0, -36.0/125.0, 0.8}, size = sqrt(0.6*0.6*0.36 + 0.64);

	if (!ok(!read_text(&scene, text, NULL, &report), "a scene with a wind %s", report.message))
		return;
	ok(hawser__static_load(force, &scene), "it has a static load");
	mean = 0.5*(0.64 + 0.96 + 1.44)/3.0 + 0.5*1.44;
	across = 0.5*1.25*0.03*64.0*size*size*mean;
	close_to((force[0]*blow[0] + force[1]*blow[1] + force[2]*blow[2])/size, 1.1*across, 1e-14,
	         "drag on the chord at rest");
	close_to(sqrt(force[0]*force[0] + force[1]*force[1] + force[2]*force[2]),
	         hypot(1.1, 0.3)*across, 1e-14, "drag and lift");
	close_to(force[0]*0.8 + force[1]*0.6, 0.0, 1e-15, "nothing along the chord");
	ok(force[1] > blow[1]/size*1.1*across, "lift is upwards");
	hawser_scene_clear(&scene);
}

CASE(unit_wind)
{
	struct hawser_wind scaled = iced;

	check_section(&iced, 7.0, "powers");
	scaled.drags = scaled.lifts = 0;
	check_section(&scaled, 3.0, "constants");
	by_hand();
	table();
	crisis();
	along_a_line();
	on_a_span();
	return done_testing();
}
