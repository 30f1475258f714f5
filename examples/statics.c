/* examples/statics.c - the static shape of one span, from numbers in the program.
 *
 *     cc statics.c $(pkg-config --cflags --libs hawser) -o statics && ./statics
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <hawser/hawser.h>

int main(void)
{
	/* A chairlift's span: 250 m wide, 10 m high, 80 kN at the lower end. SI throughout. */
	const struct hawser_span span = {.EA = 400e6, .rho = 6.0, .g = 9.81, .d = 250.0, .h = 10.0};
	struct hawser_statics statics;
	struct hawser_report report;

	if (hawser_statics_solve(&statics, &span, HAWSER_GIVEN_T0, 80e3, HAWSER_BRANCH_TAUT,
	                         &report) != HAWSER_OK) {
		fprintf(stderr, "statics: %s\n", report.message);
		return hawser_status_exit(report.status);
	}
	printf("horizontal tension  %10.3f N\n", statics.H);
	printf("unstretched length  %10.6f m\n", statics.length0);
	printf("sag                 %10.6f m\n", statics.sag);

	printf("%10s %10s %12s\n", "x (m)", "y (m)", "T (N)");
	for (int i = 0; i <= 4; i++) {
		struct hawser_profile_point p = hawser_statics_at(&statics, i*statics.length0/4.0);

		printf("%10.4f %10.4f %12.3f\n", p.x, p.y, p.T);
	}
	return 0;
}
