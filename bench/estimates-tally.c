/* bench/estimates-tally.c - random numbers, and statistics of the ratio of true to stated error
 * (estimates.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "core/order.h"

/* splitmix64: any state is a good seed. */
static uint64_t next(struct chance *chance)
{
	uint64_t z = chance->state += UINT64_C(0x9e3779b97f4a7c15);

	z = (z ^ (z >> 30))*UINT64_C(0xbf58476d1ce4e5b9);
	z = (z ^ (z >> 27))*UINT64_C(0x94d049bb133111eb);
	return z ^ (z >> 31);
}

struct chance chance_at(uint64_t seed, uint64_t command, uint64_t scene)
{
	struct chance chance = {seed};

	chance.state = next(&chance) + command;
	chance.state = next(&chance) + scene;
	chance.state = next(&chance);
	return chance;
}

double chance_unit(struct chance *chance)
{
	return (double)(next(chance) >> 11)*0x1p-53;
}

double chance_between(struct chance *chance, double low, double high)
{
	return low + chance_unit(chance)*(high - low);
}

double chance_log(struct chance *chance, double low, double high)
{
	return low*exp(chance_unit(chance)*log(high/low));
}

int chance_int(struct chance *chance, int low, int high)
{
	return low + (int)(chance_unit(chance)*(high - low + 1));
}

static int append(struct ratios *ratios, double ratio)
{
	if (ratios->count == ratios->capacity) {
		int capacity = ratios->capacity ? 2*ratios->capacity : 1024;
		double *larger = realloc(ratios->ratio, (size_t)capacity*sizeof *larger);

		if (!larger)
			return 1;
		ratios->ratio = larger;
		ratios->capacity = capacity;
	}
	ratios->ratio[ratios->count++] = ratio;
	return 0;
}

void tally_note(struct tally *tally, double true_error, double stated, const char *format, ...)
{
	double ratio = true_error == 0.0 ? 0.0 : true_error/(stated/tally->divide);

	if (isnan(ratio)) /* nothing is known, or no error was stated: the largest ratio */
		ratio = INFINITY;
	tally->failed |= append(&tally->all, ratio);
	tally->number_exceeded += ratio > 1.0;
	tally->here = fmax(tally->here, ratio);
	if (tally->show > 0.0 && ratio > tally->show) {
		va_list list;

		printf("  scene %d: %.2g true, %.2g stated: ", tally->scene, true_error,
		       stated/tally->divide);
		va_start(list, format);
		vprintf(format, list);
		va_end(list);
		putchar('\n');
	}
}

void tally_scene(struct tally *tally, int refused)
{
	tally->scenes++;
	if (refused || tally->here < 0.0) {
		tally->refused++;
	} else {
		tally->failed |= append(&tally->worst, tally->here);
		tally->exceeded += tally->here > 1.0;
		tally->far_exceeded += tally->here > 10.0;
	}
	tally->here = -1.0;
}

double tally_quantile(struct ratios *ratios, double part)
{
	int at = (int)(part*ratios->count);

	if (ratios->count == 0)
		return NAN;
	qsort(ratios->ratio, (size_t)ratios->count, sizeof *ratios->ratio, hawser__ascending);
	return ratios->ratio[at < ratios->count ? at : ratios->count - 1];
}

void tally_clear(struct tally *tally)
{
	free(tally->all.ratio);
	free(tally->worst.ratio);
	*tally = (struct tally){.here = -1.0, .divide = 1.0};
}

void estimate_run(struct tally *tally, const struct estimate *estimate, int first, int count,
                  uint64_t seed)
{
	uint64_t command = 0;

	for (const char *c = estimate->name; *c; c++)
		command = 131*command + (unsigned char)*c;
	tally->here = -1.0;
	for (tally->scene = first; tally->scene < first + count; tally->scene++) {
		struct chance chance = chance_at(seed, command, (uint64_t)tally->scene);

		tally_scene(tally, estimate->scene(tally, &chance));
	}
}
