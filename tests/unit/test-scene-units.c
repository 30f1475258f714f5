/* Numbers with units: conversions against hand-written factors, failures and their messages, and
 * independence of udunits2's state and of other threads.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <udunits2.h>
#include <unistd.h>

#include <hawser/scene.h>
#include "scene/state_file.h"
#include "tests/tap.h"

static void conversions(void)
{
	static const double pi = 3.14159265358979323846;
	const struct {
		const char *text, *unit;
		double value;
	} table[] = {
		{"400 MN", "N", 4e8}, {"80 kN", "N", 8e4}, {"90kN", "N", 9e4}, {"18 km/h", "m/s", 5},
		{"6 kg/m", "kg/m", 6}, {"0.8 N/m", "N/m", 0.8}, {"0.08 kg/m/s", "kg/m/s", 0.08},
		{"0.08 kg m-1 s-1", "kg/m/s", 0.08}, {"0.08 N s/m^2", "kg/m/s", 0.08},
		{"1 kgf", "N", 9.80665}, {"1 lbf", "N", 4.4482216152605}, {"1 ft", "m", 0.3048},
		{"3.16 lb/ft", "kg/m", 3.16*0.45359237/0.3048}, {"2.385", "N", 2.385},
		{"  -2.5e-3 km ", "m", -2.5}, {"50 %", "1", 0.5}, {"0.25", "1", 0.25},
		{"9.81 m/s\xc2\xb2", "m/s^2", 9.81}, {"3 mm", "m", 3e-3}, {"0.1 1/s", "1/s", 0.1},
		{"0.1 s-1", "1/s", 0.1}, {"1.2 rad/s", "rad/s", 1.2}, {"0.3 Hz", "rad/s", 0.6*pi},
		{"2 kHz", "rad/s", 4000*pi}, {"3 hertz", "rad/s", 6*pi}, {"60 rpm", "rad/s", 2*pi},
		{"90 degree/s", "rad/s", 0.5*pi}, {"2 min", "s", 120}, {".5", "m", 0.5},
		{"5.m", "m", 5}, {"1E2 m", "m", 100}, {".inf", "N", INFINITY},
		{"-.Inf", "N", -INFINITY}, {"+.INF MN", "N", INFINITY}, {"1e-320", "m", 1e-320},
	};

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		double value = NAN;
		struct hawser_report report = {.message = ""};
		enum hawser_status status = hawser_unit_parse(&value, table[i].text, table[i].unit,
		                                              &report);

		if (isinf(table[i].value))
			ok(status == HAWSER_OK && value == table[i].value, "%s", table[i].text);
		else if (ok(status == HAWSER_OK, "%s is read %s", table[i].text, report.message))
			close_to(value, table[i].value, 5e-16, table[i].text);
	}
}

/* The units that are converted without udunits2, against udunits2, which reads them in brackets. */
static void common(void)
{
	static const char *const pairs[][2] = {
		{"m", "m"}, {"kg/m", "kg/m"}, {"N/m", "N/m"}, {"m/s", "m/s"}, {"N", "N"}, {"s", "s"},
		{"kg", "kg"}, {"kg/m/s", "kg/m/s"}, {"rad/s", "rad/s"}, {"N.s/m", "N.s/m"},
		{"mm", "m"}, {"cm", "m"}, {"km", "m"}, {"kN", "N"}, {"MN", "N"}, {"GN", "N"},
		{"kN/m", "N/m"}, {"t", "kg"}, {"ms", "s"},
	};
	static const char *const numbers[] = {
		"2.385", "-0.1", "1e-320", "3.3333333333333335", "7e22", "1.7e290",
	};

	for (size_t i = 0; i < sizeof pairs/sizeof *pairs; i++) {
		int same = 1;

		for (size_t k = 0; k < sizeof numbers/sizeof *numbers; k++) {
			char text[64];
			double quick = 0.0, udunits = 1.0;

			snprintf(text, sizeof text, "%s %s", numbers[k], pairs[i][0]);
			same &= hawser_unit_parse(&quick, text, pairs[i][1], NULL) == HAWSER_OK;
			snprintf(text, sizeof text, "%s (%s)", numbers[k], pairs[i][0]);
			same &= hawser_unit_parse(&udunits, text, pairs[i][1], NULL) == HAWSER_OK;
			same &= quick == udunits;
		}
		ok(same, "%s in %s as udunits2 has it, to the last bit", pairs[i][0], pairs[i][1]);
	}
}

static void refusals(void)
{
	static const struct {
		const char *text, *unit, *message;
	} table[] = {
		{"400 kg", "N", "\"400 kg\" is a mass (\"kg\"); a force is wanted: under standard gravity it "
		 "belongs to \"3922.66 N\", or \"881.84905 lbf\""},
		{"400 Mn", "N", "\"400 Mn\" has an unknown unit \"Mn\": did you mean MN? give "
		 "a number in N, or with "
		                "a unit that converts to N"},
		{"foo", "N", "\"foo\" is not a number: give a number in N, or with a unit that "
		             "converts to N"},
		{"", "m", "\"\" is not a number: give a number in m, or with a unit that converts to m"},
		{".nan", "m", "\".nan\" is not a number (NaN): give a number in m, or with a unit that "
		              "converts to m"},
		{"1e999", "m", "\"1e999\" is beyond double precision: give a number in m, or with "
		               "a unit that converts to m"},
		{"3 m", "1", "\"3 m\" has a wrong unit \"m\", not convertible to a pure number: give "
		             "a pure number"},
		{"3 1/s", "rad/s", "\"3 1/s\" has a wrong unit \"1/s\", not convertible to rad/s: give "
		                   "a number in rad/s, or with a unit such as rad/s or Hz"},
		{"3 rad/s", "1/s", "\"3 rad/s\" has a wrong unit \"rad/s\", not convertible to 1/s: give "
		                   "a number in 1/s, or with a unit that converts to 1/s"},
	};
	/* texts that some parser of numbers or units would accept */
	static const char *const nonsense[] = {
		"0x10 m", "nan m", "nan(7)", "infinity", "inf", "1_000 m", "1,5 m", "1 000 m", "3 m 5",
		"3 5 m", "m", "- 3 m", "--3 m", "+-3", "5 m @ 3", "5 m since 2", "5 lg(re 1 m)", "5 m2/m/1 7",
		"5 2/3 m", "1e m s", "5 K", "5 (m", "5 m)", "5 m;", "5 \"m\"", ".", "+", "e5", "5 \xff",
		"12:30", "5 3m", "5 m*2", "5 m^", "5 m 2 /2"};

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		double value = 2.385;
		struct hawser_report report = {.message = ""};

		ok(hawser_unit_parse(&value, table[i].text, table[i].unit, &report) ==
		   HAWSER_ERR_ARGUMENT && value == 2.385, "\"%s\" is refused", table[i].text);
		if (!ok(!strcmp(report.message, table[i].message), "with its message"))
			printf("# got  %s\n# want %s\n", report.message, table[i].message);
	}
	for (size_t i = 0; i < sizeof nonsense/sizeof *nonsense; i++) {
		double value = 2.385;

		ok(hawser_unit_parse(&value, nonsense[i], "m", NULL) == HAWSER_ERR_ARGUMENT &&
		   value == 2.385, "\"%s\" is not a length", nonsense[i]);
	}
}

static int called;

static int spy(const char *format, va_list args)
{
	(void)format;
	(void)args;
	return called++;
}

static void no_trace(void)
{
	double value;

	ut_set_error_message_handler(spy);
	ok(hawser_unit_parse(&value, "3 quux", "m", NULL) == HAWSER_ERR_ARGUMENT, "an unknown unit");
	ok(called == 0, "udunits2's own handler is not called");
	ok(ut_set_error_message_handler(ut_ignore) == spy, "and is in place again");
}

/* Files of states have points, too. */
static void state(void)
{
	const double given[] = {0.5, -2.385e-7};
	char path[] = "/tmp/hawser-state-XXXXXX", text[80] = "";
	double *read = NULL;
	int fd = mkstemp(path);
	enum hawser_status status = hawser__state_write(given, 2, "state", path, NULL);
	FILE *file = fopen(path, "r");

	if (!status)
		status = hawser__state_read(&read, 2, "state", path, "test", NULL);
	if (file) {
		(void)!fread(text, 1, sizeof text - 1, file);
		fclose(file);
	}
	ok(!status && strstr(text, "\n0.5\n") && read && memcmp(read, given, sizeof given) == 0,
	   "a state is written and read with points");
	free(read);
	if (fd >= 0)
		close(fd);
	unlink(path);
}

static void comma(void)
{
	static const char *const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"};
	double value = 0.0;

	for (size_t i = 0; i < sizeof names/sizeof *names; i++)
		if (setlocale(LC_ALL, names[i])) {
			ok(hawser_unit_parse(&value, "0.5 m", "m", NULL) == HAWSER_OK && value == 0.5,
			   "a point is a point in %s", names[i]);
			state();
			setlocale(LC_ALL, "C");
			return;
		}
	ok(1, "a locale with a decimal comma # SKIP none installed");
}

static void database(void)
{
	struct hawser_report report = {.message = ""};
	double value = 2.385;

	setenv("UDUNITS2_XML_PATH", "/nowhere/udunits2.xml", 1);
	ok(hawser_unit_parse(&value, "3 ft", "m", &report) == HAWSER_ERR_IO && value == 2.385 &&
	   !strcmp(report.message, "\"3 ft\" needs the unit database of udunits2, which can't be read: "
	                           "install it (Debian package libudunits2-data), or write plain "
	                           "numbers in SI units"), "no database: %s", report.message);
	ok(hawser_unit_parse(&value, "3", "m", &report) == HAWSER_OK && value == 3.0,
	   "plain numbers need none");
	ok(hawser_unit_parse(&value, "3 kN", "N", &report) == HAWSER_OK && value == 3000.0,
	   "common units need none");
	unsetenv("UDUNITS2_XML_PATH");
}

static void *worker(void *argument)
{
	double *wrong = argument;

	for (int i = 1; i <= 10; i++) {
		char text[32];
		double value = 0.0;

		snprintf(text, sizeof text, "%d.5 kN", i);
		if (hawser_unit_parse(&value, text, "N", NULL) != HAWSER_OK || value != 1e3*i + 500.0)
			*wrong += 1.0;
		if (hawser_unit_parse(&value, "3 kg", "N", NULL) != HAWSER_ERR_ARGUMENT)
			*wrong += 1.0;
	}
	return NULL;
}

static void threads(void)
{
	enum { N = 4 };
	pthread_t thread[N];
	double wrong[N] = {0.0}, sum = 0.0;

	for (int i = 0; i < N; i++)
		if (pthread_create(&thread[i], NULL, worker, &wrong[i]))
			exit(99);
	for (int i = 0; i < N; i++) {
		pthread_join(thread[i], NULL);
		sum += wrong[i];
	}
	ok(sum == 0.0, "%d threads at once, %g wrong answers", N, sum);
}

CASE(unit_scene_units)
{
	conversions();
	common();
	refusals();
	no_trace();
	state();
	comma();
	database();
	threads();
	return done_testing();
}
