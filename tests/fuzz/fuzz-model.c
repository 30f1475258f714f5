/* tests/fuzz/fuzz-model.c - any bytes as a reduced-model file. The result must be an error with
 * file and place, or a model that can be evaluated, written and read again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rom/file/read.h"
#include "tests/fuzz/fuzz.h"

/* Values may overflow; memory accesses must be valid. */
static void evaluate(const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n;
	double *room = malloc((5*n + 2*n*n)*sizeof *room), *u = room, *v = u + n, *a = v + n;
	double *by_omega = a + n, *restoring = by_omega + n, *by_u = restoring + n;
	double *by_v = by_u + n*n;
	double xyz[3], least, most;

	for (size_t i = 0; i < n; i++) {
		u[i] = 0.1 + 0.01*(double)i;
		v[i] = -0.2;
	}
	hawser_rom_tangent(rom, restoring, by_u, u);
	hawser_rom_acceleration(rom, a, u, v, 0.3, 1.1);
	hawser_rom_acceleration_jacobian(rom, a, by_u, by_v, by_omega, u, v, 0.3, 1.1);
	(void)hawser_rom_energy(rom, u, v);
	(void)hawser_rom_asymmetry(rom);
	(void)hawser_rom_tensions(rom, &least, &most, u);
	if (rom->shapes.points > 0) {
		hawser_rom_displacement(rom, xyz, rom->shapes.points - 1, u);
		(void)hawser_rom_tension(rom, 0, u);
	}
	free(room);
}

static void write_again(const struct hawser_rom *rom)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom again;
	char *first = NULL, *second = NULL;

	demand(!hawser_rom_text(rom, &first, &report), "a model can be written", report.message);
	demand(!hawser__rom_parse(&again, first, strlen(first), "m.json", NULL, 0, &report),
	       "a model that was written can be read", report.message);
	demand(!hawser_rom_text(&again, &second, &report), "and written again", report.message);
	demand(!strcmp(first, second), "reading and writing change nothing", second);
	hawser_rom_clear(&again);
	free(first);
	free(second);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	enum hawser_status status = hawser__rom_parse(&rom, (const char *)data, size, "m.json", NULL, 0,
	                                              &report);

	if (status) {
		demand(status == HAWSER_ERR_SCENE && !strncmp(report.message, "m.json: ", 8) &&
		       is_message(report.message), "a model error names the file", report.message);
	} else {
		evaluate(&rom);
		write_again(&rom);
	}
	hawser_rom_clear(&rom);
	return 0;
}
