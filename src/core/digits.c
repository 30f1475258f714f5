/* core/digits.c - numbers as text with 17 significant digits, faster than printf.
 *
 *   value = m 2^b       m a 64-bit integer whose highest bit is 1
 *   10^k  = c 2^q       c rounded down to 64 bits, so that c <= exact < c + 1 + 2^-50
 *   value 10^k = N + f  N the 17 digits before rounding, k = 16 - X, X the decimal exponent
 *
 * The high 64 bits h of the product m c contain N and, in their lowest `rest` = 5 to 11 bits, the
 * fraction. The exact product is at most 2 units of h above h, hence the rounding is known unless the
 * fraction in h is at most 2 units below one half, or equal to it. In this case (about 2 % of numbers,
 * among them all ties) printf gives the digits. printf itself takes about ten times as long because it
 * computes with all digits of the exact decimal expansion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"

enum { DIGITS = 17 };
#define LOWEST 10000000000000000u /* 10^16, the smallest integer of 17 digits */

/* --- powers of ten, from 128-bit mantissas --- */

struct wide {
	uint64_t high, low;
	int exponent; /* of the unit of `high` */
};

/* x*10 = (x + x/4)*8 */
static struct wide times_ten(struct wide x)
{
	struct wide sum = {x.high + (x.high >> 2), x.low + (x.low >> 2 | x.high << 62),
	                   x.exponent + 3};
	int carry = sum.low < x.low;

	sum.high += (uint64_t)carry;
	if (sum.high >= x.high)
		return sum;
	/* the sum has 129 bits */
	sum.low = sum.low >> 1 | sum.high << 63;
	sum.high = sum.high >> 1 | (uint64_t)1 << 63;
	sum.exponent++;
	return sum;
}

/* x/10 = (x - x/5)/8 */
static struct wide tenth(struct wide x)
{
	const uint32_t part[4] = {(uint32_t)(x.high >> 32), (uint32_t)x.high,
	                          (uint32_t)(x.low >> 32), (uint32_t)x.low};
	struct wide rest = {.exponent = x.exponent - 3};
	uint64_t quotient[4], left = 0, low, high;

	for (int i = 0; i < 4; i++) {
		left = left << 32 | part[i];
		quotient[i] = left/5;
		left %= 5;
	}
	high = quotient[0] << 32 | quotient[1];
	low = quotient[2] << 32 | quotient[3];
	rest.low = x.low - low;
	rest.high = x.high - high - (x.low < low);
	if (rest.high >> 63)
		return rest;
	rest.high = rest.high << 1 | rest.low >> 63;
	rest.low <<= 1;
	rest.exponent--;
	return rest;
}

/* Each step loses less than 4 units of 128 bits: 340 steps less than 2^-53 units of 64 bits. */
void hawser__powers_make(struct hawser__powers *powers)
{
	const struct wide one = {(uint64_t)1 << 63, 0, -63};
	struct hawser__power *power = powers->power - HAWSER__LEAST_POWER;
	struct wide x = one;

	for (int k = 0; k <= HAWSER__MOST_POWER; k++, x = times_ten(x))
		power[k] = (struct hawser__power){x.high, x.exponent};
	x = tenth(one);
	for (int k = -1; k >= HAWSER__LEAST_POWER; k--, x = tenth(x))
		power[k] = (struct hawser__power){x.high, x.exponent};
}

/* --- digits of a number --- */

/* High 64 bits of a product. */
static uint64_t high_product(uint64_t a, uint64_t b)
{
	uint64_t a1 = a >> 32, a0 = a & 0xffffffffu, b1 = b >> 32, b0 = b & 0xffffffffu;
	uint64_t middle = a1*b0 + (a0*b0 >> 32), other = a0*b1 + (middle & 0xffffffffu);

	return a1*b1 + (middle >> 32) + (other >> 32);
}

/* The 17 digits, and the decimal exponent of the first, by printf. */
static uint64_t slow_digits(int *X, double magnitude)
{
	uint64_t digits = 0;
	char text[40], *at = text;

	snprintf(text, sizeof text, "%.*e", DIGITS - 1, magnitude);
	for (; *at != 'e'; at++) /* skips the decimal point of the locale */
		if (*at >= '0' && *at <= '9')
			digits = 10*digits + (uint64_t)(*at - '0');
	*X = (int)strtol(at + 1, NULL, 10);
	return digits;
}

static uint64_t digits_of(int *X, double magnitude, const struct hawser__powers *powers)
{
	int b, rest;
	uint64_t m = (uint64_t)ldexp(frexp(magnitude, &b), 64), h, half, fraction, N;

	/* floor((b - 1) log10(2)), which is the exponent or one less */
	*X = (int)floor((b - 1)*0.30102999566398120);
	for (;; ++*X) {
		const struct hawser__power *p = &powers->power[16 - *X - HAWSER__LEAST_POWER];

		h = high_product(m, p->mantissa);
		rest = -(b + p->exponent); /* b - 64 is the exponent of m, and h has the unit 2^64 */
		N = h >> rest;
		if (N < 10*LOWEST)
			break;
	}
	half = (uint64_t)1 << (rest - 1);
	fraction = h & (2*half - 1);
	if (fraction + 2 >= half && fraction <= half)
		return slow_digits(X, magnitude);
	N += fraction > half;
	if (N < 10*LOWEST)
		return N;
	++*X;
	return LOWEST;
}

/* --- text --- */

/* digit[0..count) with the point after the first `whole` (1 or more) of them. */
static char *put_digits(char *to, const char *digit, int count, int whole)
{
	for (int i = 0; i < count || i < whole; i++) {
		if (i == whole)
			*to++ = '.';
		*to++ = (char)(i < count ? digit[i] : '0');
	}
	return to;
}

static char *put_exponent(char *to, int X)
{
	return to + sprintf(to, "e%d", X);
}

static char *put(char *to, const char *digit, int count, int X)
{
	if (X < -4 || X >= DIGITS)
		return put_exponent(put_digits(to, digit, count, 1), X);
	if (X < 0) {
		/* NOLINTNEXTLINE(bugprone-not-null-terminated-result): more follows */
		memcpy(to, "0.0000", 6);
		to += 1 - X;
		memcpy(to, digit, (size_t)count);
		return to + count;
	}
	to = put_digits(to, digit, count, X + 1);
	if (count <= X + 1) {
		*to++ = '.';
		*to++ = '0';
	}
	return to;
}

size_t hawser__digits(char *text, double value, const struct hawser__powers *powers)
{
	char digit[DIGITS], *end = text;
	int X = 0, count = DIGITS;
	uint64_t N = value == 0.0 ? 0 : digits_of(&X, fabs(value), powers);

	if (signbit(value))
		*end++ = '-';
	for (int i = DIGITS - 1; i >= 0; i--, N /= 10)
		digit[i] = (char)('0' + N%10);
	while (count > 1 && digit[count - 1] == '0')
		count--;
	end = put(end, digit, count, X);
	*end = '\0';
	return (size_t)(end - text);
}
