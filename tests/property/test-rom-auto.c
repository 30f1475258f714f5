/* The AUTO-07p export: its compiled Fortran has the library's right-hand side and derivatives and
 * starts on an orbit of the model; every error of hawser_rom_export_auto.
 * tests/reference/rom-auto.sh runs AUTO itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "rom/choose/drive.h"
#include "rom/build/model.h"
#include "tests/tap.h"

enum { N = 3, SIZE = 2*N + 2 };

static char folder[] = "rom-auto-XXXXXX";
static char stem[64];

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

/* Products of 1 to HAWSER_TERM_FACTORS coordinates and velocities. */
static void random_terms(struct hawser_term **term, int *terms, int count)
{
	*term = calloc((size_t)count, sizeof **term);
	*terms = count;
	for (int i = 0; i < count; i++) {
		struct hawser_term *t = &(*term)[i];

		t->j = rand()%N;
		t->factors = 1 + i%HAWSER_TERM_FACTORS;
		t->rates = rand()%(t->factors + 1);
		t->value = 0.2*uniform();
		for (int f = 0; f < t->factors; f++)
			t->factor[f] = rand()%N;
	}
}

/* A model with every kind of term: full D and K, Q, C, cosines and sines, powers of Omega,
 * parametric terms, quadratic ones that vary, constant ones, and products of any degree. */
static int random_model(struct hawser_rom *rom)
{
	if (hawser__rom_init(rom, N, NULL))
		return 0;
	rom->Q = calloc(12, sizeof *rom->Q);
	rom->C = calloc(20, sizeof *rom->C);
	rom->harmonic = calloc(4, sizeof *rom->harmonic);
	rom->quads = 12;
	rom->cubics = 20;
	rom->harmonics = 4;
	for (int i = 0; i < N*N; i++) {
		rom->K[i] = i%(N + 1) ? 0.2*uniform() : 2.0 + i;
		rom->D[i] = i%(N + 1) ? 0.1*uniform() : 0.3;
	}
	for (int i = 0; i < 12; i++)
		rom->Q[i] = (struct hawser_quad){rand()%N, rand()%N, rand()%N, uniform()};
	for (int i = 0; i < 20; i++)
		rom->C[i] = (struct hawser_cubic){rand()%N, rand()%N, rand()%N, rand()%N, uniform()};
	for (int h = 0; h < 3; h++) {
		rom->harmonic[h] = (struct hawser_harmonic){.k = h + 1, .omega_power = 2 - h,
			.phase = h%2 ? HAWSER_SIN : HAWSER_COS};
		rom->harmonic[h].f = calloc(N, sizeof(double));
		rom->harmonic[h].D = h != 1 ? calloc(N*N, sizeof(double)) : NULL;
		rom->harmonic[h].K = h != 2 ? calloc(N*N, sizeof(double)) : NULL;
		for (int i = 0; i < N*N; i++) {
			rom->harmonic[h].f[i%N] = 0.2*uniform();
			if (rom->harmonic[h].D)
				rom->harmonic[h].D[i] = 0.1*uniform();
			if (rom->harmonic[h].K)
				rom->harmonic[h].K[i] = 0.1*uniform();
		}
	}
	for (int h = 2; h < 4; h++) {
		rom->harmonic[h].Q = calloc(7, sizeof(struct hawser_quad));
		rom->harmonic[h].quads = 7;
		for (int i = 0; i < 7; i++)
			rom->harmonic[h].Q[i] = (struct hawser_quad){rand()%N, rand()%N, rand()%N,
			                                             0.3*uniform()};
	}
	/* constant terms */
	rom->harmonic[3].f = calloc(N, sizeof(double));
	rom->harmonic[3].K = calloc(N*N, sizeof(double));
	for (int i = 0; i < N*N; i++) {
		rom->harmonic[3].f[i%N] = 0.05*uniform();
		rom->harmonic[3].K[i] = 0.1*uniform();
	}
	random_terms(&rom->term, &rom->terms, 11);
	random_terms(&rom->harmonic[1].term, &rom->harmonic[1].terms, 9);
	random_terms(&rom->harmonic[3].term, &rom->harmonic[3].terms, 5);
	return ok(!hawser_rom_compile(rom, NULL), "a model with every kind of term");
}

/* --- the first orbit --- */

static void series(const struct hawser__cycle *cycle, double u[3][N], double tau)
{
	memset(u, 0, 3*sizeof *u);
	for (int h = 0; h <= cycle->order; h++)
		for (int j = 0; j < N; j++) {
			double a = cycle->cosine[h*N + j], b = cycle->sine[h*N + j];

			u[0][j] += a*cos(h*tau) + b*sin(h*tau);
			u[1][j] += h*(b*cos(h*tau) - a*sin(h*tau));
			u[2][j] -= h*h*(a*cos(h*tau) + b*sin(h*tau));
		}
}

static void check_orbit(const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                        double omega)
{
	double worst = 0.0, largest = 0.0;

	for (int i = 0; i < 50; i++) {
		double u[3][N], v[N], acc[N], tau = 0.123 + 2.0*M_PI*i/50;

		series(cycle, u, tau);
		for (int j = 0; j < N; j++)
			v[j] = omega*u[1][j];
		hawser_rom_acceleration(rom, acc, u[0], v, tau, omega);
		for (int j = 0; j < N; j++) {
			worst = fmax(worst, fabs(acc[j] - omega*omega*u[2][j]));
			largest = fmax(largest, fabs(acc[j]));
		}
	}
	ok(worst < 1e-8*largest, "the first orbit fulfils the equations between its phases: %.1e",
	   worst/largest);
}

/* A first orbit far from the linear response, and a model without a periodic orbit. */
static void check_growth(void)
{
	struct hawser_rom rom;
	struct hawser__cycle cycle;
	struct hawser_report report = {0};

	if (hawser__rom_init(&rom, 1, NULL))
		return;
	rom.K[0] = 1.0;
	rom.D[0] = 0.05;
	rom.C = calloc(1, sizeof *rom.C);
	*rom.C = (struct hawser_cubic){0, 0, 0, 0, 4.0};
	rom.cubics = rom.harmonics = 1;
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic->k = 1;
	rom.harmonic->f = calloc(1, sizeof(double));
	rom.harmonic->f[0] = 2.0;
	if (ok(!hawser_rom_compile(&rom, NULL) && !hawser__cycle_find(&cycle, &rom, 0.9, &report),
	       "a hardening oscillator far up its slope %s", report.message))
		ok(cycle.cosine[1] > 0.7, "its amplitude: %.3f", cycle.cosine[1]);
	hawser__cycle_clear(&cycle);
	rom.D[0] = 0.0;
	rom.C->value = 0.0;
	ok(!hawser_rom_compile(&rom, NULL) &&
	   hawser__cycle_find(&cycle, &rom, 1.0, &report) == HAWSER_ERR_CONVERGENCE,
	   "undamped resonance: %s", report.message);
	hawser_rom_clear(&rom);
}

/* --- the Fortran --- */

static const char driver[] =
	"PROGRAM MAIN\n"
	"  IMPLICIT NONE\n"
	"  INTEGER, PARAMETER :: S = 8\n"
	"  INTEGER :: ICP(2) = (/1, 11/), I\n"
	"  DOUBLE PRECISION :: U(S), PAR(36), F(S), G(S), J(S,S), P(S,36), Q(S,36), T, STEP, E\n"
	"  READ *, U, PAR(1), T\n"
	"  PAR(2:3) = 1\n"
	"  CALL FUNC(S, U, ICP, PAR, 2, F, J, P)\n"
	"  PRINT '(ES25.17)', F, J, P(:,1)\n"
	"  E = 0\n"
	"  STEP = 1D-5\n"
	"  DO I = 1, S\n"
	"    U(I) = U(I) + STEP\n"
	"    CALL FUNC(S, U, ICP, PAR, 0, F, J, P)\n"
	"    U(I) = U(I) - 2*STEP\n"
	"    CALL FUNC(S, U, ICP, PAR, 0, G, J, P)\n"
	"    U(I) = U(I) + STEP\n"
	"    E = MAX(E, MAXVAL(ABS((F - G)/(2*STEP) - J(:,I))))\n"
	"  END DO\n"
	"  DO I = 1, 3\n"
	"    CALL FUNC(S, U, ICP, PAR, 2, F, J, P)\n"
	"    PAR(I) = PAR(I) + STEP\n"
	"    CALL FUNC(S, U, ICP, PAR, 0, F, J, Q)\n"
	"    PAR(I) = PAR(I) - 2*STEP\n"
	"    CALL FUNC(S, U, ICP, PAR, 0, G, J, Q)\n"
	"    PAR(I) = PAR(I) + STEP\n"
	"    E = MAX(E, MAXVAL(ABS((F - G)/(2*STEP) - P(:,I))))\n"
	"  END DO\n"
	"  CALL STPNT(S, U, PAR, T)\n"
	"  PRINT '(ES25.17)', E, U, PAR(1), PAR(11)\n"
	"END PROGRAM MAIN\n";

static int read_all(double *value, int count, const char *path)
{
	FILE *stream = fopen(path, "r");
	int got = 0;

	while (stream && got < count && fscanf(stream, "%lf", &value[got]) == 1)
		got++;
	if (stream)
		fclose(stream);
	return got == count;
}

static int compile_and_run(double *value, int count, const double *input)
{
	char text[400];
	FILE *stream;

	snprintf(text, sizeof text, "%s/driver.f90", folder);
	stream = fopen(text, "w");
	if (!stream)
		return 0;
	fputs(driver, stream);
	fclose(stream);
	snprintf(text, sizeof text, "%s/input", folder);
	stream = fopen(text, "w");
	if (!stream)
		return 0;
	for (int i = 0; i < SIZE + 2; i++)
		fprintf(stream, "%.17g\n", input[i]);
	fclose(stream);
	snprintf(text, sizeof text, "cd %s && gfortran -Wall -Wno-unused-dummy-argument "
	         "-Werror=conversion -O1 model.f90 driver.f90 -o driver >log 2>&1 && ./driver <input "
	         ">output", folder);
	if (system(text) != 0)
		return 0;
	snprintf(text, sizeof text, "%s/output", folder);
	return read_all(value, count, text);
}

static double distance(const double *a, const double *b, int count)
{
	double worst = 0.0;

	for (int i = 0; i < count; i++)
		worst = fmax(worst, fabs(a[i] - b[i])/(1.0 + fabs(b[i])));
	return worst;
}

static void compare(const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                    const double *input, const double *value, double from)
{
	const double *F = value, *J = F + SIZE, *P = J + SIZE*SIZE, *E = P + SIZE, *start = E + 1;
	double omega = input[SIZE], tau = atan2(input[2*N], input[2*N + 1]), acc[N], by_u[N*N];
	double by_v[N*N], by_omega[N], u[3][N], worst = 0.0;

	hawser_rom_acceleration_jacobian(rom, acc, by_u, by_v, by_omega, input, input + N, tau,
	                                 omega);
	ok(distance(F, input + N, N) == 0.0 && distance(F + N, acc, N) < 1e-14,
	   "FUNC is the library's right-hand side: %.1e", distance(F + N, acc, N));
	for (int j = 0; j < N; j++)
		for (int k = 0; k < N; k++)
			worst = fmax(worst, fmax(fabs(J[k*SIZE + N + j] - by_u[j*N + k]),
			                         fabs(J[(N + k)*SIZE + N + j] - by_v[j*N + k])));
	ok(worst < 1e-13, "its derivatives by u and v too: %.1e", worst);
	ok(distance(P + N, by_omega, N) < 1e-13 && P[2*N] == input[2*N + 1] &&
	   P[2*N + 1] == -input[2*N], "and by Omega: %.1e", distance(P + N, by_omega, N));
	ok(E[0] < 1e-8, "all derivatives against differences, oscillator too: %.1e", E[0]);
	series(cycle, u, 2.0*M_PI*input[SIZE + 1]);
	for (int j = 0; j < N; j++)
		u[1][j] *= from;
	ok(distance(start, u[0], N) < 1e-14 && distance(start + N, u[1], N) < 1e-13,
	   "STPNT is on the first orbit");
	ok(start[SIZE] == from && fabs(start[SIZE + 1] - 2.0*M_PI/from) < 1e-14, "Omega, period");
}

static void check_fortran(const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                          double from)
{
	double input[SIZE + 2], value[SIZE + SIZE*SIZE + SIZE + 1 + SIZE + 2];

	if (system("gfortran --version >/dev/null 2>&1") != 0) {
		ok(1, "the Fortran # SKIP gfortran is not installed");
		return;
	}
	for (int i = 0; i < 2*N; i++)
		input[i] = uniform();
	input[2*N] = sin(0.77);
	input[2*N + 1] = cos(0.77);
	input[SIZE] = 1.385;
	input[SIZE + 1] = 0.317;
	if (ok(compile_and_run(value, sizeof value/sizeof *value, input), "it compiles and runs"))
		compare(rom, cycle, input, value, from);
}

/* --- errors and files --- */

static int is_there(const char *name)
{
	char path[96];

	snprintf(path, sizeof path, "%s/%s", folder, name);
	return access(path, F_OK) == 0;
}

static void check_errors(struct hawser_rom *rom)
{
	struct hawser_auto_options fine = {.ntst = 0}, bad;
	struct hawser_report report = {0};
	char path[96];
	int harmonics = rom->harmonics;

	fine.from = 1.0;
	fine.to = 2.0;
	bad = fine;
	bad.to = 1.0;
	ok(hawser_rom_export_auto(rom, stem, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad.to = -1.0;
	ok(hawser_rom_export_auto(rom, stem, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = fine;
	bad.ncol = 8;
	ok(hawser_rom_export_auto(rom, stem, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	ok(hawser_rom_export_auto(rom, "a.b", &fine, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	ok(hawser_rom_export_auto(rom, "a/", &fine, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	ok(hawser_rom_export(rom, "octave", stem, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "octave is no format"), "%s", report.message);
	rom->harmonics = 0;
	ok(hawser_rom_export_auto(rom, stem, &fine, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	rom->harmonics = harmonics;
	ok(hawser_rom_export_auto(rom, "no/such/model", &fine, &report) == HAWSER_ERR_IO &&
	   strstr(report.message, "no/such/model.f90"), "%s", report.message);
	snprintf(path, sizeof path, "%s/c.half", folder);
	mkdir(path, 0777);
	snprintf(path, sizeof path, "%s/half", folder);
	ok(hawser_rom_export_auto(rom, path, &fine, &report) == HAWSER_ERR_IO && !is_there("half.f90"),
	   "no equations without constants: %s", report.message);
}

CASE(property_rom_auto)
{
	const double from = 0.83;
	struct hawser_auto_options options = {.ntst = 0};
	struct hawser_report report = {0};
	struct hawser__cycle cycle = {0};
	struct hawser_rom rom;
	char command[64];

	srand(2385);
	if (!ok(mkdtemp(folder) != NULL, "a folder") || !random_model(&rom))
		return done_testing();
	snprintf(stem, sizeof stem, "%s/model", folder);
	options.from = from;
	options.to = 2.1;
	ok(!hawser_rom_export_auto(&rom, stem, &options, &report), "exported %s", report.message);
	ok(is_there("model.f90") && is_there("c.model") && is_there("model.auto"), "three files");
	ok(!hawser__cycle_find(&cycle, &rom, from, &report), "first orbit %s", report.message);
	check_orbit(&rom, &cycle, from);
	check_fortran(&rom, &cycle, from);
	check_growth();
	check_errors(&rom);
	hawser__cycle_clear(&cycle);
	hawser_rom_clear(&rom);
	snprintf(command, sizeof command, "rm -rf %s", folder);
	ok(system(command) == 0, "cleaned up");
	return done_testing();
}
