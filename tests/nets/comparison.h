/* tests/nets/comparison.h - other methods for the statics of nets, and all methods beside each other on
 * random cables.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_NETS_COMPARISON_H
#define HAWSER_TESTS_NETS_COMPARISON_H

#include "net/statics/solve.h"

/* A cable between two supports, (0, 0, 0) and (d, h, 0). */
struct net_cable {
	double d, h;        /* m */
	double length0;     /* m */
	double rho, EA, g;  /* kg/m, N, m/s2 */
	int elements;
};
/* Problem `number` of the family `seed`; the same on every machine. d is 1 to 1000 m and |h| at most d,
 * length0/chord - 1 is 1e-3 to 3.2 or (one in five) -1e-4 to -1e-2, rho 0.1 to 30 kg/m, EA over the
 * weight 32 to 1e7, and there are 10 to 100 elements. All but h and elements are uniform in their
 * logarithms. */
struct net_cable net_cable(unsigned seed, unsigned number);
/* This cable as a net. */
enum hawser_status net_cable_open(struct hawser_net *net, const struct net_cable *cable,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- whether a result is right --- */

#define NET_RIGHT 1e-5 /* rad, and part of the weight: of methods that stop at 1e-7 of it */
/* What positions and loads alone say of a result of a mesh; nothing of the solver is used. */
struct net_certificate {
	double residual; /* N: largest force at a node that is not balanced, by the law of cables */
	double weight;   /* N: sum of the forces on the nodes */
	double gap;      /* J: the energy is at most this far above the least one of all shapes */
	double scale;    /* J: sum of force times length over the elements */
	double angle;    /* rad: sqrt(2*gap/scale), by which the forces may be turned on the average */
	int compressed;  /* elements that are shorter than unstretched, and that bars would compress */
	int right;       /* 1 if angle is at most NET_RIGHT, and residual at most that part of weight */
};
/* The unstretched length of each cable of the net has to be given (HAWSER_NET_LENGTH0), the net has no
 * obstacles, and the result has to be one of a mesh: not of the method `catenary`. */
enum hawser_status net_certify(struct net_certificate *certificate, const struct hawser_net *net,
                               const struct hawser_net_statics *st,
                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- methods --- */

/* Methods that the library does not have: mixed, two-sided, regularised, descent, relaxation. NULL
 * beyond the last. */
const struct hawser__net_method *net_older(int index);
/* One of them, or a row of the library's; NULL: there is none of this name. */
const struct hawser__net_method *net_method(const char *name);

/* Where the other methods begin: at the force densities of the library's, or, with `chord`, at straight
 * cables whose inner nodes are displaced along each axis by up to `noise` times the chord. */
void net_start_at(int chord, double noise, unsigned seed);
/* Begin there; for the methods. */
void net_start(struct hawser__net_work *work);

enum hawser_status net_mixed(struct hawser__net_work *work, int *done, struct hawser_report *report);
enum hawser_status net_two_sided(struct hawser__net_work *work, int *done,
                                 struct hawser_report *report);
enum hawser_status net_regularised(struct hawser__net_work *work, int *done,
                                   struct hawser_report *report);
enum hawser_status net_descent(struct hawser__net_work *work, int *done, struct hawser_report *report);
enum hawser_status net_relaxation(struct hawser__net_work *work, int *done,
                                  struct hawser_report *report);

/* --- comparison --- */

/* A row of the comparison: a method from one of its starts. */
struct net_way {
	const char *name, *method;
	int chord;
	int iterations; /* most; 0: the method's own */
};

enum net_end {
	NET_SOLVED = 0, /* and certified */
	NET_COMPRESSED, /* ended with compressed elements */
	NET_FAILED,     /* the method says that it has no equilibrium */
	NET_WRONG       /* the method says that it has one, and it is none */
};

/* One way on one net. */
struct net_outcome {
	enum net_end end;
	int iterations;
	double seconds;         /* processor time, the least of several */
	double angle, residual; /* of the certificate, the latter over its weight; NAN: no result */
};

/* One way on all nets. Quantiles are of those that it has solved: half, nine tenths, all. */
enum { NET_QUANTILES = 3 };
struct net_score {
	const struct net_way *way;
	int solved, compressed, failed, wrong;
	double iterations[NET_QUANTILES]; /* NAN: none is solved */
	double seconds[NET_QUANTILES];
	double best;            /* part of all nets that it solves the fastest */
	double ratio;           /* of time to the fastest way of each net, the median of those solved */
};

struct net_comparison {
	int nets, ways;
	struct net_outcome *outcome; /* [ways][nets] */
	struct net_score *score;     /* [ways] */
};

struct net_comparison_options {
	int nets;
	unsigned seed;   /* of the random cables */
	const char *way; /* this one alone; NULL: all */
	double noise;    /* of starts at the chord, over the chord; 0: 1e-4 */
	int steps;       /* most of relaxation; 0: 20000 */
	int repeats;     /* of a brief solution, of which the least time counts; 0: 3 */
};
enum hawser_status net_compare(struct net_comparison *comparison,
                               const struct net_comparison_options *options,
                               struct hawser_report *report) HAWSER_MUST_CHECK;
/* The performance profile of a way (Dolan and More): value [nets], ascending, is the ratio of its time
 * to the least one of all ways on the same net or, with `iterations`, the number of its iterations;
 * INFINITY where it has not solved the net. A part i/nets is solved within value[i - 1]. */
void net_comparison_profile(double *value, const struct net_comparison *comparison, int way,
                            int iterations);
void net_comparison_clear(struct net_comparison *comparison);

#endif
