/* net/motion/motion-schemes.c - schemes of time integration, as rows of a table; see
 * struct hawser__motion_rule.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "net/motion/motion.h"

static void energy(struct hawser__motion_rule *rule, double h, double rho_inf)
{
	(void)rho_inf;
	*rule = (struct hawser__motion_rule){
		.m = {2.0/(h*h), -2.0/h}, .c = {1.0/h}, .to_v = {2.0/h, -1.0},
		.to_a = {2.0/(h*h), -2.0/h}, .weight = -1.0};
}

/* Chung and Hulbert. */
static void alpha(struct hawser__motion_rule *rule, double h, double rho_inf)
{
	double rho = rho_inf >= 0.0 ? fmin(rho_inf, 1.0) : 0.9;
	double am = (2.0*rho - 1.0)/(rho + 1.0), af = rho/(rho + 1.0);
	double gamma = 0.5 - am + af, beta = 0.25*(1.0 - am + af)*(1.0 - am + af);
	double a[3] = {1.0/(beta*h*h), -1.0/(beta*h), -(0.5 - beta)/beta};

	*rule = (struct hawser__motion_rule){.weight = 1.0 - af};
	for (int i = 0; i < 3; i++) {
		rule->to_a[i] = a[i];
		rule->to_v[i] = h*gamma*a[i] + (i == 1) + (i == 2 ? h*(1.0 - gamma) : 0.0);
		rule->m[i] = (1.0 - am)*a[i] + (i == 2 ? am : 0.0);
		rule->c[i] = (1.0 - af)*rule->to_v[i] + (i == 1 ? af : 0.0);
	}
}

static void trapezoidal(struct hawser__motion_rule *rule, double h, double rho_inf)
{
	energy(rule, h, rho_inf);
	rule->weight = 0.5;
}

/* B (3.43), with the velocity of the step as that of its end. */
static void euler(struct hawser__motion_rule *rule, double h, double rho_inf)
{
	(void)rho_inf;
	*rule = (struct hawser__motion_rule){.m = {1.0/(h*h), -1.0/h}, .c = {0.5/h, 0.5},
	                                     .to_v = {1.0/h}, .to_a = {1.0/(h*h), -1.0/h}, .weight = 1.0};
}

const struct hawser__motion_scheme *hawser__motion_scheme(int index)
{
	static const struct hawser__motion_scheme table[] = {
		{{"energy", "keeps energy and angular momentum: discrete gradient, order 2",
		  "Gonzalez 1996; Simo and Tarnow 1992", 2}, energy, NULL},
		{{"alpha", "generalised-alpha: damps what is faster than the step, order 2",
		  "Chung and Hulbert 1993", 2}, alpha, NULL},
		{{"theta", "theta scheme with theta = 1/2 (trapezoidal rule), order 2",
		  "Bertrand 2022, (3.41)-(3.42)", 2}, trapezoidal, NULL},
		{{"euler", "implicit Euler: damps all, order 1; printed there as theta = 1/2",
		  "Bertrand 2022, (3.43)", 1}, euler, NULL},
		{{"cvode", "CVODE, Adams' formulas to order 12, or BDF if axial waves are overdamped: a "
		  "check", "Hindmarsh et al. 2005", 0}, NULL, hawser__cvode_advance},
	};

	return index >= 0 && (size_t)index < sizeof table/sizeof *table ? &table[index] : NULL;
}

const struct hawser_net_scheme *hawser_net_scheme(int index)
{
	const struct hawser__motion_scheme *row = hawser__motion_scheme(index);

	return row ? &row->shown : NULL;
}
