/* Print the BLAS that a program uses: the name of OpenBLAS's kernel (or "none" with another BLAS),
 * then the files that contain dgemm, its C interface and dgeev. Products, a factorisation and
 * eigenvalues are computed first, so that a kernel that the processor cannot run ends the program
 * by SIGILL.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <dlfcn.h>
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 67 };

static double a[N*N], b[N*N], c[N*N], wr[N], wi[N];
static lapack_int pivots[N];

static double number(int i, int j)
{
	return sin(1.7*i + 0.3) + cos(2.3*j + 0.1*i*j);
}

static const char *file_of(const char *symbol)
{
	void *at = dlsym(RTLD_DEFAULT, symbol);
	Dl_info info;

	return at && dladdr(at, &info) && info.dli_fname ? info.dli_fname : "none";
}

/* Largest |entry| of C minus the product of A and B, computed by plain loops. */
static double worst_product(void)
{
	double worst = 0.0;

	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++) {
			double sum = 0.0;

			for (int k = 0; k < N; k++)
				sum += a[i*N + k]*b[k*N + j];
			worst = fmax(worst, fabs(sum - c[i*N + j]));
		}
	return worst;
}

int main(void)
{
	char *(*corename)(void);
	double worst;

	*(void **)&corename = dlsym(RTLD_DEFAULT, "openblas_get_corename");
	for (int i = 0; i < N*N; i++) {
		a[i] = number(i/N, i % N);
		b[i] = number(i % N, i/N);
	}
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, N, N, N, 1.0, a, N, b, N, 0.0, c, N);
	worst = worst_product();
	cblas_dgemv(CblasRowMajor, CblasTrans, N, N, 1.0, a, N, b, 1, 0.0, wr, 1);
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasNoTrans, N, N, 1.0, a, N, 0.0, c, N);
	if (LAPACKE_dgetrf(LAPACK_COL_MAJOR, N, N, b, N, pivots) != 0 ||
	    LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'N', N, a, N, wr, wi, NULL, 1, NULL, 1) != 0 ||
	    !(worst < 1e-11)) {
		fprintf(stderr, "wrong results: a product is off by %.1e\n", worst);
		return 1;
	}
	printf("%s %s %s %s\n", corename ? corename() : "none", file_of("dgemm_"),
	       file_of("cblas_dgemm"), file_of("dgeev_"));
	return 0;
}
