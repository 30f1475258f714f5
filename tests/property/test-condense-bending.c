/* Condensation with bending stiffness against sums over all modes of a basis: the cubic terms, the
 * second-order displacement, the stiffness that a load varies and the response to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/rom.h>

#include "tests/modes-span.h"
#include "tests/rom-condensed.h"
#include "tests/tap.h"

/* xi = L sqrt(T/EI) at mid-span. */
static struct hawser_statics stiff_span(double epsilon, double delta, double hs, double xi, double A,
                                        double B)
{
	struct hawser_statics st = span_of(epsilon, delta, hs);
	double L = st.l*st.span.d;

	st.bending.EI = st.H*L*L/(xi*xi);
	st.bending.rotation[0] = A*st.bending.EI/L;
	st.bending.rotation[1] = B*st.bending.EI/L;
	return st;
}

static void check_span(double epsilon, double delta, double hs, double xi, double A, double B,
                       double tolerance)
{
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC,
	                                       .inertia = HAWSER_INERTIA_NONE}};
	struct hawser_statics st = stiff_span(epsilon, delta, hs, xi, A, B);
	struct hawser_report report = {.message = ""};
	struct hawser_modes few, many;
	struct hawser_rom condensed, raw;
	double *T, left, half;

	if (!ok(modes_of(&few, &st, KEPT) && !hawser_modes_basis(&many, &st, 70, 70, &report) &&
	        !hawser_rom_build(&condensed, &few, &scene, &report) &&
	        !hawser_rom_build(&raw, &few, NULL, &report),
	        "epsilon %g, delta %g, hs %g, xi %g: models %s", epsilon, delta, hs, xi, report.message))
		return;
	T = all_thirds(&many);
	left = rest(&condensed, &raw, T, &many, many.n);
	half = rest(&condensed, &raw, T, &many, many.n/3);
	ok(left < tolerance && left < half, "condensed C against %d modes: %.1e, a third of them %.1e",
	   many.n, left, half);
	left = rest_of_shape(&condensed, T, &many);
	ok(left < 10.0*tolerance, "second-order displacement: %.1e", left);
	left = hawser_rom_asymmetry(&condensed);
	ok(left < 1e-13, "still a potential: %.1e", left);
	free(T);
	hawser_rom_clear(&condensed);
	hawser_rom_clear(&raw);
	hawser_modes_clear(&few);
	hawser_modes_clear(&many);
}

CASE(property_condense_bending)
{
	check_span(0.05, 0.2, 0.0, 31.0, INFINITY, INFINITY, 1e-10);
	check_span(0.05, 0.2, 0.3, 5.3, INFINITY, 0.0, 1e-10);
	check_span(0.2, 1.5, 0.4, 17.0, 2.3, INFINITY, 1e-9);
	check_span(1e-3, 0.3, -0.7, 171.0, INFINITY, INFINITY, 1e-9);
	check_span(1e-3, 0.05, 0.4, 913.0, INFINITY, 7.1, 1e-9);
	return done_testing();
}
