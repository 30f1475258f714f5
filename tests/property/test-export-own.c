/* The equilibria and limit cycles of models over a parameter as AUTO-07p equations: their compiled
 * Fortran has the right-hand side of the models within the range, of second order (a wake
 * oscillator, by 1/Ur^2) and of first, with derivatives that differences confirm, and starts at rest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <hawser/family.h>

#include "tests/tap.h"

enum { MOST = 4 };

static const char driver[] =
	"PROGRAM MAIN\n"
	"  IMPLICIT NONE\n"
	"  INTEGER, PARAMETER :: S = %d\n"
	"  INTEGER :: I\n"
	"  DOUBLE PRECISION :: PAR(36), D(S,36), X(S+3), Y(S+3), Z(S+3), E\n"
	"  CALL STPNT(S, X, PAR, 0D0)\n"
	"  X(S+1:) = PAR(1:3)\n"
	"  PRINT '(ES25.17)', MAXVAL(ABS(AT(X))), PAR(1)\n"
	"  X(1:S) = COS((/(1D0*I, I = 1, S)/))\n"
	"  X(S+1) = %.17gD0\n"
	"  PRINT '(ES25.17)', AT(X)\n"
	"  E = 0\n"
	"  DO I = 1, S + 3\n"
	"    Y = X\n"
	"    Z = X\n"
	"    Y(I) = X(I) + 1D-5\n"
	"    Z(I) = X(I) - 1D-5\n"
	"    Y(1:S) = (AT(Y) - AT(Z))/2D-5\n"
	"    Z(1:S) = AT(X)\n"
	"    E = MAX(E, MAXVAL(ABS(Y(1:S) - D(:,I))))\n"
	"  END DO\n"
	"  PRINT '(ES25.17)', E\n"
	"CONTAINS\n"
	"  FUNCTION AT(W) RESULT(F)\n"
	"    DOUBLE PRECISION :: W(S+3), F(S), J(S,S), P(S,36)\n"
	"    CALL FUNC(S, W, (/1, 11/), W(S+1:), 2, F, J, P)\n"
	"    D(:,1:S) = J\n"
	"    D(:,S+1:S+3) = P(:,1:3)\n"
	"  END FUNCTION AT\n"
	"END PROGRAM MAIN\n";

/* value [states + 3] of the driver at the parameter p. */
static int compile_and_run(double *value, int states, double p)
{
	FILE *stream = fopen("export-own-driver.f90", "w");
	int got = 0;

	if (!stream)
		return 0;
	fprintf(stream, driver, states, p);
	fclose(stream);
	if (system("gfortran -Wall -Wno-unused-dummy-argument -O0 export-own.f90 export-own-driver.f90 "
	           "-o export-own-driver >export-own-log 2>&1 && ./export-own-driver "
	           ">export-own-output") != 0)
		return 0;
	stream = fopen("export-own-output", "r");
	while (stream && got < states + 3 && fscanf(stream, "%lf", &value[got]) == 1)
		got++;
	if (stream)
		fclose(stream);
	return got == states + 3;
}

static void compare(const char *name, const char *key, double from, double to, double p)
{
	struct hawser_auto_options options = {.ntst = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_rom_source source;
	struct hawser_rom_family family = {.context = NULL};
	const struct hawser_rom *rom;
	double x[MOST], f[MOST], value[MOST + 3], worst = 0.0;
	const char *path = source_file("tests/reference/autonomous/%s.json", name);
	int states;
	enum hawser_status status;

	options.from = from;
	options.to = to;
	status = hawser_rom_source_open(&source, path, &report);
	if (!status)
		status = hawser_parameter_open(&family, &source, key, 0.0, &report);
	if (!status)
		status = hawser_family_export_auto(&family, key, from, NULL, "export-own", &options, &report);
	if (!status)
		status = family.model(family.context, &rom, p, &report);
	if (ok(!status, "%s is written %s", name, report.message)) {
		states = rom->first ? rom->n : 2*rom->n;
		for (int i = 0; i < states; i++)
			x[i] = cos(i + 1);
		memcpy(f, x + rom->n, (size_t)(states - rom->n)*sizeof *f);
		hawser_rom_acceleration(rom->first ? rom->first : rom, f + states - rom->n, x, x + rom->n,
		                        0.0, 1.0);
		if (ok(compile_and_run(value, states, p), "its Fortran runs")) {
			ok(fabs(value[0]) < 1e-12 && value[1] == from, "it starts at rest: %.1e", value[0]);
			for (int i = 0; i < states; i++)
				worst = fmax(worst, fabs(value[2 + i] - f[i]));
			ok(worst < 1e-12, "FUNC is the right-hand side between the points: %.1e", worst);
			ok(value[2 + states] < 1e-8, "its derivatives against differences: %.1e",
			   value[2 + states]);
		}
	}
	hawser_parameter_close(&family);
	hawser_rom_source_clear(&source);
}

CASE(property_export_own)
{
	static const char *const left[] = {"export-own.f90", "export-own.auto", "c.export-own",
		"export-own-driver.f90", "export-own-driver", "export-own-log", "export-own-output"};

	if (system("gfortran --version >/dev/null 2>&1") != 0) {
		ok(1, "the Fortran # SKIP gfortran is not installed");
		return done_testing();
	}
	compare("wake", "Ur", 4.0, 6.5, 5.385);
	compare("bautin", "b1", -0.3, 0.2, 0.0385);
	for (size_t i = 0; i < sizeof left/sizeof *left; i++)
		remove(left[i]);
	return done_testing();
}
