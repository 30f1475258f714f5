/* output/curves/plot_frf_tori.c - quasi-periodic motions in the picture of a frequency response: a band
 * between the least and the greatest amplitude, over the curve's range of Omega.
 *
 * The band lies behind the curves; its edges are solid where the tori are stable, and dashed where they
 * are not. It begins at a torus point, where both edges meet the curve.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/curves/plot_frf.h"
#include "output/drawing/style.h"

static const char unstable_dash[] = HAWSER__UNSTABLE_DASH;
/* Fills of the bands, by curve and stability. */
static const char *const fill[2][2] = {{"#9CC9E6", "#DCEBF5"}, {"#F2C097", "#FAE6D6"}};
static const char *const edge[] = {"#4A93C0", "#D08A4E"};

/* The last point of the part with the stability of point i. */
static int part_end(const struct hawser__response_torus *torus, int i)
{
	int k = i;

	while (k + 1 < torus->points && torus->unstable[k + 1] == torus->unstable[i])
		k++;
	return k;
}

/* Edges of all parts with this stability, one after the other; a part includes the first point of the
 * next one. As a band: there along the greatest amplitudes and back along the least. */
static void parts(FILE *script, const struct hawser__response *response, int c, int unstable, int band)
{
	for (int k = 0; k < response->tori; k++) {
		const struct hawser__response_torus *torus = &response->torus[k];
		const double *most = torus->most + (size_t)c*(size_t)torus->points;
		const double *least = torus->least + (size_t)c*(size_t)torus->points;

		for (int i = 0, last; i < torus->points; i = last + 1) {
			int to;

			last = part_end(torus, i);
			to = last + 1 < torus->points ? last + 1 : last;
			if (unstable != (torus->unstable[i] > 0.0))
				continue;
			for (int p = i; p <= to; p++)
				fprintf(script, "%.12g %.9g\n", torus->omega[p], most[p]);
			if (!band)
				fputc('\n', script);
			for (int p = band ? to : i; band ? p >= i : p <= to; p += band ? -1 : 1)
				fprintf(script, "%.12g %.9g\n", torus->omega[p], least[p]);
			fputc('\n', script);
		}
	}
}

void hawser__tori_data(FILE *script, const struct hawser__response *response, int c)
{
	for (int unstable = 0; response->tori > 0 && unstable < 2; unstable++)
		for (int band = 0; band < 2; band++) {
			fprintf(script, "$tori%d_%d_%d << END\n", c, unstable, band);
			parts(script, response, c, unstable, band);
			fputs("NaN NaN\nEND\n", script);
		}
}

/* Whether a curve has tori of this stability. */
static int has(const struct hawser__response *response, int unstable)
{
	for (int k = 0; k < response->tori; k++)
		for (int i = 0; i < response->torus[k].points; i++)
			if ((response->torus[k].unstable[i] > 0.0) == unstable)
				return 1;
	return 0;
}

void hawser__tori_bands(FILE *script, const char **comma, const struct hawser__response *response,
                        int panel)
{
	for (int band = 1; band >= 0; band--)
		for (int c = 0; c < response->curves; c++)
			for (int unstable = 1; unstable >= 0; unstable--) {
				if (response->curve[c].panel != panel || !has(response, unstable))
					continue;
				fprintf(script, "%s$tori%d_%d_%d with ", *comma, c, unstable, band);
				if (band)
					fprintf(script, "filledcurves closed fc rgb '%s' fs solid noborder",
					        fill[c % 2][unstable]);
				else
					fprintf(script, "lines lc rgb '%s' lw 0.7 %s", edge[c % 2],
					        unstable ? unstable_dash : "dt solid");
				*comma = ", ";
			}
}

double hawser__tori_largest(const struct hawser__response *response, int c)
{
	double most = 0.0;

	for (int k = 0; k < response->tori; k++)
		for (int i = 0; i < response->torus[k].points; i++)
			most = fmax(most, response->torus[k].most[c*response->torus[k].points + i]);
	return most;
}

void hawser__tori_legend(struct hawser__legend *entries, const struct hawser__response *response)
{
	if (has(response, 0))
		hawser__legend_add(entries, "tori", "with lines lw 8 lc rgb '%s'", fill[0][0]);
	if (has(response, 1))
		hawser__legend_add(entries, "unstable tori", "with lines lw 8 lc rgb '%s'", fill[0][1]);
}
