/* Refusals of what own models have in a file: terms, mass matrix, first order, parameters and formulas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/rom.h>

#include "tests/tap.h"

/* Reading fails with a message that has each part of `wanted`, which are separated by |. */
static void refused(const char *text, const char *wanted)
{
	char path[] = "/tmp/hawser-own-XXXXXX", parts[200];
	struct hawser_report report = {.message = ""};
	int file = mkstemp(path), fine;
	struct hawser_rom rom;

	fine = file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text);
	fine = fine && hawser_rom_open(&rom, path, &report) == HAWSER_ERR_SCENE;
	snprintf(parts, sizeof parts, "%s", wanted);
	for (char *part = strtok(parts, "|"); part; part = strtok(NULL, "|"))
		fine = fine && strstr(report.message, part);
	ok(fine, "%s: %s", wanted, report.message);
	close(file);
	unlink(path);
}

#define MODEL(more) "{\"n\": 2, \"K\": [[1, 0], [0, 3]]" more "}"
#define PARAMETERS(formula) "{\"n\": 1, \"parameters\": {\"eps\": 0.1}, \"K\": [[\"" formula "\"]]}"

static void many_parameters(void)
{
	char text[3000] = "{\"n\": 1, \"K\": [[1]], \"parameters\": {\"a\": 1";

	for (int i = 0; i < 64; i++)
		snprintf(text + strlen(text), sizeof text - strlen(text), ", \"a%d\": 1", i);
	strcat(text, "}}");
	refused(text, "more than 64 parameters");
}

static void deep_formula(void)
{
	char text[400] = "{\"n\": 1, \"parameters\": {\"eps\": 0.1}, \"K\": [[\"";

	for (int i = 0; i < 60; i++)
		strcat(text, "-");
	strcat(text, "1\"]]}");
	refused(text, "nested too deeply");
}

CASE(unit_own_file)
{
	refused(MODEL(", \"terms\": 1"), "terms: a list of entries");
	refused(MODEL(", \"terms\": [[0, [1], 2]]"), "terms[0]: [j, [coordinates], [velocities], value]");
	refused(MODEL(", \"terms\": [[2, [1], [1], 2]]"), "terms[0]: the equation j is 2|from 0 to 1");
	refused(MODEL(", \"terms\": [[0, [1], 1, 2]]"), "terms[0]: a list of the indices of velocities");
	refused(MODEL(", \"terms\": [[0, [1], [2], 2]]"), "terms[0]: factor 2 is 2");
	refused(MODEL(", \"terms\": [[0, [], [], 2]]"), "terms[0] has no factor|k 0");
	refused(MODEL(", \"terms\": [[0, [0,0,0,0,0], [0,0,0,0,0], 2]]"), "terms[0]: more than 9 factors");
	refused(MODEL(", \"terms\": [[0, [0], [], \"x\"]]"), "terms[0]: the value is \"x\"");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"terms\": [[0, [0], [7], 1]]}]"),
	        "harmonics[0].terms[0]: factor 2 is 7");
	refused(MODEL(", \"harmonics\": [{\"k\": 1, \"C\": [[0, 0, 0, 1]]}]"),
	        "harmonics[0].C[0] is a list of 4");
	refused(MODEL(", \"M\": [[1, 1], [1, 1]]"), "M is singular|eliminate");
	refused(MODEL(", \"M\": [[1, 0]]"), "M is a list of 1");
	refused(MODEL(", \"M\": [[1, 0], [0, 2]], \"ramp\": {\"time\": 1}"),
	        "M goes with models that have neither");
	refused(MODEL(", \"first_order\": 1"), "first_order: true or false");
	refused(MODEL(", \"relaxation\": 1"), "relaxation is for models of first_order");
	refused(MODEL(", \"first_order\": true, \"relaxation\": 0"), "relaxation is 0|positive");
	refused(MODEL(", \"first_order\": true, \"D\": [[0, 0], [0, 1]]"), "D in a model of first_order");
	refused(MODEL(", \"first_order\": true, \"terms\": [[0, [], [0], 1]]"), "terms[0] has velocities");
	refused(MODEL(", \"first_order\": true, \"ramp\": {\"time\": 1}"),
	        "a ramp in a model of first_order");
	refused(MODEL(", \"first_order\": true, \"harmonics\": [{\"k\": 1, \"D\": [[0, 0], [0, 1]]}]"),
	        "harmonics[0] has a D, in a model of first_order");
	refused(MODEL(", \"first_order\": true, \"harmonics\": [{\"k\": 1, \"f\": [1, 1], "
	              "\"omega_power\": 2}]"),
	        "harmonics[0] has omega_power 2, in");
	refused(MODEL(", \"first_order\": true, \"harmonics\": [{\"k\": 0, \"Q\": [[1, 1, 1, 1]]}]"),
	        "harmonics[0] of k 0 has more than an f");
	refused(MODEL(", \"first_order\": true, \"harmonics\": [{\"k\": 1, \"terms\": [[1, [1], [1], "
	              "1]]}]"),
	        "harmonics[0] has terms with velocities");
	refused(MODEL(", \"parameters\": 1"), "parameters: an object");
	refused(MODEL(", \"parameters\": {\"2a\": 1}"), "\"2a\" can't be a name");
	refused(MODEL(", \"parameters\": {\"sin\": 1}"), "\"sin\" can't be a name");
	refused(MODEL(", \"parameters\": {\"Omega\": 1}"), "\"Omega\" can't be a name");
	refused(MODEL(", \"parameters\": {\"a\": true}"), "parameters.a is true or false");
	many_parameters();
	deep_formula();
	refused(PARAMETERS("2*ep"), "K[0][0] is \"2*ep\": ep is no parameter of the file");
	refused(PARAMETERS("2*(eps"), "a bracket is open");
	refused(PARAMETERS("2 eps"), "\"e\" is unexpected");
	refused(PARAMETERS("2*#"), "\"#\" is unexpected");
	refused(PARAMETERS("2*"), "a number or name is missing at the end");
	refused(PARAMETERS("sin 2"), "sin needs its argument in brackets");
	refused(PARAMETERS("1/(eps - 0.1)"), "its value is not finite");
	return done_testing();
}
