/* hawser/net_comparison.h - methods of the statics of nets beside each other, on one net and on random
 * cables.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_COMPARISON_H
#define HAWSER_NET_COMPARISON_H

#include <hawser/net.h>
#include <hawser/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A cable between two supports, (0, 0, 0) and (d, h, 0). */
struct hawser_net_random {
	double d, h;        /* m */
	double length0;     /* m */
	double rho, EA, g;  /* kg/m, N, m/s2 */
	int elements;
};
/* Problem `number` of the family `seed`; the same on every machine. d is 1 to 1000 m and |h| at most d,
 * length0/chord - 1 is 1e-3 to 3.2 or (one in five) -1e-4 to -1e-2, rho 0.1 to 30 kg/m, EA over the
 * weight 32 to 1e7, and there are 10 to 100 elements. All but h and elements are uniform in their
 * logarithms. */
struct hawser_net_random hawser_net_random(unsigned seed, unsigned number);
/* This cable as a net. */
enum hawser_status hawser_net_random_open(struct hawser_net *net,
                                          const struct hawser_net_random *cable,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- whether a result is right --- */

#define HAWSER_NET_RIGHT 1e-5 /* rad, and part of the weight: of methods that stop at 1e-7 of it */
/* What positions and loads alone say of a result of a mesh; nothing of the solver is used. */
struct hawser_net_certificate {
	double residual; /* N: largest force at a node that is not balanced, by the law of cables */
	double weight;   /* N: sum of the forces on the nodes */
	double gap;      /* J: the energy is at most this far above the least one of all shapes */
	double scale;    /* J: sum of force times length over the elements */
	double angle;    /* rad: sqrt(2*gap/scale), by which the forces may be turned on the average */
	int compressed;  /* elements that are shorter than unstretched, and that bars would compress */
	int right;       /* 1 if angle is at most HAWSER_NET_RIGHT, and residual at most that part of
	                  * weight */
};
/* The unstretched length of each cable of the net has to be given (HAWSER_NET_LENGTH0), and the result
 * has to be one of a mesh: not of the method `catenary`. */
enum hawser_status hawser_net_certify(struct hawser_net_certificate *certificate,
                                      const struct hawser_net *net,
                                      const struct hawser_net_statics *st,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- comparison --- */

/* A row of the comparison: a method from one of its starts. */
struct hawser_net_way {
	const char *name, *method;
	enum hawser_net_start start;
	int iterations; /* most; 0: the method's own */
};
const struct hawser_net_way *hawser_net_way(int index);

enum hawser_net_end {
	HAWSER_NET_SOLVED = 0, /* and certified */
	HAWSER_NET_COMPRESSED, /* ended with compressed elements */
	HAWSER_NET_FAILED,     /* the method says that it has no equilibrium */
	HAWSER_NET_WRONG       /* the method says that it has one, and it is none */
};
const char *hawser_net_end_name(enum hawser_net_end end);

/* One way on one net. */
struct hawser_net_outcome {
	enum hawser_net_end end;
	int iterations;
	double seconds;         /* processor time, the least of several */
	double angle, residual; /* of the certificate, the latter over its weight; NAN: no result */
};

/* One way on all nets. Quantiles are of those that it has solved: half, nine tenths, all. */
enum { HAWSER_NET_QUANTILES = 3 };
struct hawser_net_score {
	const struct hawser_net_way *way;
	int solved, compressed, failed, wrong;
	double iterations[HAWSER_NET_QUANTILES]; /* NAN: none is solved */
	double seconds[HAWSER_NET_QUANTILES];
	double best;            /* part of all nets that it solves the fastest */
	double ratio;           /* of time to the fastest way of each net, the median of those solved */
	double angle, residual; /* largest of those solved */
};

struct hawser_net_comparison {
	int nets, ways;
	unsigned seed;
	struct hawser_net_random *random;   /* [nets], or NULL */
	struct hawser_net_outcome *outcome; /* [ways][nets] */
	struct hawser_net_score *score;     /* [ways] */
	int interrupted;                    /* 1: fewer nets than were to be compared */
};

struct hawser_net_comparison_options {
	const struct hawser_net *net; /* [nets], or NULL: random cables */
	int nets;                     /* 0: 1600 */
	unsigned seed;                /* of the random cables */
	const char *way;              /* this one alone; NULL: all */
	double tolerance;             /* of all methods, as in hawser_net_options; 0: 1e-7 */
	double noise;                 /* of starts at the chord, as in hawser_net_options */
	int steps;                    /* most of relaxation; 0: 20000 for random cables, else 1000000 */
	int repeats;                  /* of a brief solution, of which the least time counts; 0: 3 */
	struct hawser_progress progress;
};
enum hawser_status hawser_net_compare(struct hawser_net_comparison *comparison,
                                      const struct hawser_net_comparison_options *options,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* The performance profile of a way (Dolan and More): value [nets], ascending, is the ratio of its time
 * to the least one of all ways on the same net or, with `iterations`, the number of its iterations;
 * INFINITY where it has not solved the net. A part i/nets is solved within value[i - 1]. */
void hawser_net_comparison_profile(double *value, const struct hawser_net_comparison *comparison,
                                   int way, int iterations);
void hawser_net_comparison_clear(struct hawser_net_comparison *comparison);

#ifdef __cplusplus
}
#endif
#endif
