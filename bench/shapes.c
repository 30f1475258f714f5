/* bench/shapes.c - the parameters for which a method's shapes fail: largest error of the first
 * three modes of each plane against the spectral method, for the cables of B Table 4.1, over slope
 * and tension. B (4.1.5) remarks that its analytic shapes fail for inclined, nearly inextensible
 * cables; this bench gives the errors. Output is a table for gnuplot, one block for each cable and
 * slope. Arguments: METHOD [POINTS].
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/modes.h>

enum { MODES = 3, ASKED = 8, SPARE = 6 };

static const struct hawser_span cases[] = {
	{235e6, 12.94, 9.81, 100.0, 0.0}, {40e6, 6.0, 9.81, 100.0, 0.0}, {1e6, 3.0, 9.81, 100.0, 0.0},
};
static const double slopes[] = {0.0, 0.05, 0.1, 0.25, 1.0/3.0};

/* Largest errors of the first MODES modes of a plane. */
static void largest(double *frequency, double *shape, const struct hawser_modes_error *error,
                    const struct hawser_modes *modes, enum hawser_plane plane)
{
	int found = 0;

	*frequency = *shape = 0.0;
	for (int k = 0; k < modes->n && found < MODES; k++)
		if (modes->mode[k].plane == plane) {
			*frequency = fmax(*frequency, error[k].frequency);
			*shape = fmax(*shape, error[k].shape);
			found++;
		}
}

static int line(const struct hawser_span *span, double H, const char *method)
{
	struct hawser_modes_options choice = {.n = ASKED + SPARE};
	struct hawser_modes exact = {0}, modes = {0};
	struct hawser_modes_error error[ASKED];
	struct hawser_report report = {0};
	struct hawser_statics st;
	double frequency[2], shape[2];
	int done = hawser_statics_solve(&st, span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, &report)
	               == HAWSER_OK
	           && hawser_modes_solve(&exact, &st, &choice, &report) == HAWSER_OK;

	choice = (struct hawser_modes_options){.n = ASKED, .method = method};
	done = done && hawser_modes_solve(&modes, &st, &choice, &report) == HAWSER_OK
	       && hawser_modes_compare(error, &modes, &exact, &report) == HAWSER_OK;
	if (done) {
		largest(&frequency[0], &shape[0], error, &modes, HAWSER_IN_PLANE);
		largest(&frequency[1], &shape[1], error, &modes, HAWSER_OUT_OF_PLANE);
		printf("%.6g\t%.6g\t%.6g\t%.6g\t%.3e\t%.3e\t%.3e\t%.3e\n", H, st.epsilon, st.delta,
		       st.irvine, frequency[0], shape[0], frequency[1], shape[1]);
	} else {
		fprintf(stderr, "shapes: H = %g N: %s\n", H, report.message);
	}
	hawser_modes_clear(&modes);
	hawser_modes_clear(&exact);
	return done;
}

int main(int argc, char **argv)
{
	const char *method = argc > 1 ? argv[1] : "analytic";
	int points = argc > 2 ? atoi(argv[2]) : 9, done = 1;

	printf("# method: %s; largest errors of the first %d modes of each plane\n"
	       "# columns: H_N epsilon delta irvine in_plane_frequency in_plane_shape "
	       "out_of_plane_frequency out_of_plane_shape\n", method, MODES);
	for (size_t c = 0; c < sizeof cases/sizeof *cases; c++)
		for (size_t s = 0; s < sizeof slopes/sizeof *slopes; s++) {
			struct hawser_span span = cases[c];
			double weight = span.rho*span.g*span.d, low = weight, high = 0.02*span.EA;

			span.h = slopes[s]*span.d;
			printf("\n\n# case %zu, h/d = %.4g\n", c + 1, slopes[s]);
			for (int i = 0; i < points; i++)
				done &= line(&span, low*pow(high/low, points > 1 ? (double)i/(points - 1) : 0.0),
				             method);
		}
	return !done;
}
