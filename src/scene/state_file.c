/* scene/state_file.c - see state_file.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/file.h"
#include "core/locale.h"
#include "core/report.h"
#include "scene/state_file.h"

enum { LINE = 80 }; /* characters of the first line, at most */

enum hawser_status hawser__state_write(const double *state, int count, const char *kind,
                                       const char *path, struct hawser_report *report)
{
	struct hawser__locale locale;
	struct hawser__file file;
	enum hawser_status status = hawser__file_begin(&file, path, report);

	if (status)
		return status;
	hawser__locale_begin(&locale);
	fprintf(file.stream, "%s %d", kind, count);
	for (int i = 0; i < count; i++)
		fprintf(file.stream, "\n%.17g", state[i]);
	fprintf(file.stream, "\n");
	hawser__locale_end(&locale);
	return hawser__file_commit(&file, report);
}

enum hawser_status hawser__state_read(double **state, int count, const char *kind, const char *path,
                                      const char *stage, struct hawser_report *report)
{
	struct hawser__locale locale;
	FILE *file = fopen(path, "r");
	char first[LINE], want[LINE];
	int good;

	*state = NULL;
	if (!file)
		return hawser__fail(report, hawser__unreadable(errno), stage,
		                    "cannot read the state in %s: %s", path, strerror(errno));
	snprintf(want, sizeof want, "%s %d\n", kind, count);
	good = fgets(first, sizeof first, file) && strcmp(first, want) == 0;
	*state = good ? malloc((size_t)count*sizeof **state) : NULL;
	if (good && !*state) {
		fclose(file);
		return hawser__no_memory(report, stage);
	}
	hawser__locale_begin(&locale);
	for (int i = 0; i < count && good; i++) /* NOLINTNEXTLINE(cert-err34-c): overflow is not finite */
		good = fscanf(file, "%lf", &(*state)[i]) == 1 && isfinite((*state)[i]);
	hawser__locale_end(&locale);
	fclose(file);
	if (!good) {
		free(*state);
		*state = NULL;
	}
	return HAWSER_OK;
}
