/* response/orbit/collocation.c - the tables of collocation at Gauss nodes, made once: a map opens
 * thousands of orbits that take them.
 *
 * The nodes are computed by Newton's method on P_s from Tricomi's approximation, to the last bit or
 * two. The integrals of Legendre polynomials have closed forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <pthread.h>

#include "response/orbit/collocation.h"

#define S HAWSER__NODES

void hawser__legendre(double *p, double z, int count)
{
	p[0] = 1.0;
	if (count > 1)
		p[1] = z;
	for (int m = 1; m + 1 < count; m++)
		p[m + 1] = ((2*m + 1)*z*p[m] - m*p[m - 1])/(m + 1);
}

/* By (2m + 1) P_m = (P_{m+1} - P_{m-1})', once and twice. */
void hawser__collocation_integrals(double *once, double *twice, double x)
{
	double p[S + 2];

	hawser__legendre(p, 2.0*x - 1.0, S + 2);
	once[0] = x;
	twice[0] = x*x/2.0;
	for (int m = 1; m < S; m++)
		once[m] = (p[m + 1] - p[m - 1])/(2*(2*m + 1));
	twice[1] = x*x*(x/3.0 - 0.5);
	for (int m = 2; m < S; m++)
		twice[m] = ((p[m + 2] - p[m])/(2*(2*m + 3)) - (p[m] - p[m - 2])/(2*(2*m - 1)))/
		           (2*(2*m + 1));
}

/* Node i of the Gauss rule of s nodes on [-1, 1], by Newton from Tricomi's guess, and its weight. */
static double gauss_node(double *weight, int i, int s)
{
	double z = -cos(M_PI*(i + 0.75)/(s + 0.5)), p[S + 1], slope = 1.0;

	for (int k = 0; k < 10; k++) {
		hawser__legendre(p, z, s + 1);
		slope = s*(p[s - 1] - z*p[s])/(1.0 - z*z);
		z -= p[s]/slope;
	}
	*weight = 2.0/((1.0 - z*z)*slope*slope);
	return z;
}

/* row_j = sum_m integral_m transform[m][j] */
static void compose(double *row, const double *integral, const struct hawser__collocation *table)
{
	for (int j = 0; j < table->nodes; j++) {
		row[j] = 0.0;
		for (int m = 0; m < table->nodes; m++)
			row[j] += integral[m]*table->transform[m][j];
	}
}

/* P_s - P_{s-1} */
static double radau(double z, int s)
{
	double p[S + 1];

	hawser__legendre(p, z, s + 1);
	return p[s] - p[s - 1];
}

/* Node i of the Radau rule on [-1, 1] that has 1 as its last, and its weight. The others lie between
 * those of the Gauss rule. */
static double radau_node(double *weight, int i, int s)
{
	double p[S + 1], low = gauss_node(weight, i, s);
	double high = i < s - 1 ? gauss_node(weight, i + 1, s) : 1.0, sign = radau(low, s), z = 1.0;

	while (i < s - 1 && (z = 0.5*(low + high), z > low && z < high))
		*(radau(z, s)*sign > 0.0 ? &low : &high) = z;
	hawser__legendre(p, z, s + 1);
	*weight = (1.0 + z)/(s*p[s - 1]*s*p[s - 1]);
	return z;
}

static void make(struct hawser__collocation *table, double (*node)(double *, int, int), int s)
{
	double once[S], twice[S], value[S], weight;

	table->nodes = s;
	for (int i = 0; i < s; i++) {
		double z = node(&weight, i, s);

		table->node[i] = (1.0 + z)/2.0;
		hawser__legendre(value, z, s);
		for (int m = 0; m < s; m++)
			table->transform[m][i] = (2*m + 1)*weight/2.0*value[m];
	}
	for (int i = 0; i < s; i++) {
		hawser__collocation_integrals(once, twice, table->node[i]);
		compose(table->once[i], once, table);
		compose(table->twice[i], twice, table);
	}
	hawser__collocation_integrals(once, twice, 1.0);
	compose(table->end_once, once, table);
	compose(table->end_twice, twice, table);
}

/* The tables of Gauss' rule and of Radau's with any number of nodes are made once. */
static struct hawser__collocation gauss, radau_of[S + 1];
static pthread_once_t made = PTHREAD_ONCE_INIT;

static void make_all(void)
{
	make(&gauss, gauss_node, S);
	for (int s = 1; s <= S; s++)
		make(&radau_of[s], radau_node, s);
}

void hawser__collocation_make(struct hawser__collocation *table)
{
	pthread_once(&made, make_all);
	*table = gauss;
}

void hawser__collocation_make_radau(struct hawser__collocation *table, int nodes)
{
	pthread_once(&made, make_all);
	*table = radau_of[nodes];
}

void hawser__collocation_indirect(struct hawser__collocation *table)
{
	int s = table->nodes;

	for (int j = 0; j < s; j++) {
		table->end_twice[j] = 0.0;
		for (int k = 0; k < s; k++)
			table->end_twice[j] += table->end_once[k]*table->once[k][j];
		for (int i = 0; i < s; i++) {
			table->twice[i][j] = 0.0;
			for (int k = 0; k < s; k++)
				table->twice[i][j] += table->once[i][k]*table->once[k][j];
		}
	}
}
