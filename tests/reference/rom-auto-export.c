/* rom-auto-export MODEL STEM FROM TO [TOLERANCE NTST]: export for AUTO-07p, for rom-auto.sh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/rom.h>

int main(int count, char **word)
{
	struct hawser_auto_options options = {.ntst = 0};
	struct hawser_report report = {0};
	struct hawser_rom rom;
	enum hawser_status status;

	if (count != 5 && count != 7)
		return 1;
	options.from = strtod(word[3], NULL);
	options.to = strtod(word[4], NULL);
	if (count == 7) {
		options.tolerance = strtod(word[5], NULL);
		options.ntst = atoi(word[6]);
	}
	status = hawser_rom_open(&rom, word[1], &report);
	if (!status)
		status = hawser_rom_export_auto(&rom, word[2], &options, &report);
	hawser_rom_clear(&rom);
	if (status)
		fprintf(stderr, "%s\n", report.message);
	return hawser_status_exit(status);
}
