/* rom/file/formula.h - numbers that a model file gives as texts with named parameters. See formula.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_FORMULA_H
#define HAWSER_ROM_FORMULA_H

#include <stddef.h>

#include <hawser/rom_source.h>

/* *value of a text such as "1 + 2*eps^2", with the values of parameter [count]. Returns 0, or 1 with
 * the reason in wrong [size]. */
int hawser__formula(double *value, const char *text, const struct hawser_parameter *parameter,
                    int count, char *wrong, size_t size);

/* 1: the text can be the name of a parameter. */
int hawser__formula_name(const char *name);

#endif
