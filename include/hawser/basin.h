/* hawser/basin.h - basins of attraction: at which periodic response a motion ends that begins at a
 * given state, as a map (map.h) over two components of that state.
 *
 * The responses of a model at one frequency are those of curves that are followed over the frequency,
 * and those at which motions from states of the map end. Each has a neighbourhood in which the map of
 * its period contracts a quadratic form; a motion that enters it ends at this response.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BASIN_H
#define HAWSER_BASIN_H

#include <hawser/map.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A stable periodic response. The numbers of the map refer to it: 1 is the first. */
struct hawser_basin {
	int period;        /* number of periods of the load in one of the response */
	double amplitude;  /* peak displacement as the quantity amplitude has it, m (scaled if the model
	                    * has no units) */
	double tension;    /* least tension over the period, N; NaN if the model has none */
	double multiplier; /* largest modulus of its multipliers, over its period */
	double radius;     /* of its neighbourhood: largest |z|/|x| for which the form was seen to
	                    * contract in every direction that was tried */
	int followed;      /* 1: it is on a curve that was followed; 0: a motion of the map led to it */
	double share;      /* of the area of the map */
	double error;      /* of the share, at most: half the area of the cells on its boundary */
};

struct hawser_basins {
	int n;                       /* coordinates of the model */
	int count;
	struct hawser_basin *basin;  /* [count] by amplitude */
	double *state;               /* [count][2n] u (m) then u' (m/s) at phase 0 */
	double other, other_error;   /* share of motions that end at none of them within `periods`: they are
	                              * quasi-periodic or chaotic, have more than 8 periods, or are slow */
	double escaped, escaped_error; /* share of motions that grow beyond all bounds */
	double entropy;              /* basin entropy of boxes of 5 x 5 points, */
	double boundary_entropy;     /* and of those of them with several numbers: above log 2 the boundary
	                              * is fractal */
	int periods;                 /* most periods of a motion */
};

/* The field of a map over two components of the initial state: source->key is "u1", "v1", ..., in m and
 * m/s (scaled if the model has no units); the others are zero. source->omega is the frequency. The
 * number of a point is that of the response, 0 where the motion ends at none, and -1 where it escapes;
 * the value is the number. `source` must outlive the field; release with hawser_map_basin_close.
 * HAWSER_ERR_ARGUMENT (keys, no frequency), HAWSER_ERR_NO_SOLUTION (no stable periodic response is
 * found), and those of the model. */
enum hawser_status hawser_map_basin_open(struct hawser_map_field *field,
                                         const struct hawser_map_source *source,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_map_basin_close(struct hawser_map_field *field);

/* The responses of the field, and their shares of the map that was traced with it. Release with
 * hawser_basins_clear. HAWSER_ERR_MEMORY. */
enum hawser_status hawser_basins_count(struct hawser_basins *basins,
                                       const struct hawser_map_field *field,
                                       const struct hawser_map *map,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_basins_clear(struct hawser_basins *basins);

#ifdef __cplusplus
}
#endif
#endif
