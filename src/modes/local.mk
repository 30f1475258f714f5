noinst_LTLIBRARIES += %D%/libmodes.la
%C%_libmodes_la_SOURCES = \
	%D%/analytic.c \
	%D%/basis.c \
	%D%/bending/bending.c \
	%D%/cable.c \
	%D%/cable_space.c \
	%D%/chain.c \
	%D%/compare.c \
	%D%/complex/complex_mode.c \
	%D%/compliance.c \
	%D%/compliance_refine.c \
	%D%/compliance_springs.c \
	%D%/complex/convection.c \
	%D%/complex/damped.c \
	%D%/complex/damped_trace.c \
	%D%/complex/wind.c \
	%D%/driven.c \
	%D%/fdm.c \
	%D%/bending/flexure.c \
	%D%/bending/flexure_basis.c \
	%D%/bending/flexure_solve.c \
	%D%/grid.c \
	%D%/complex/gyroscopic.c \
	%D%/complex/gyroscopic_analytic.c \
	%D%/complex/gyroscopic_fdm.c \
	%D%/complex/gyroscopic_span.c \
	%D%/complex/gyroscopic_spectral.c \
	%D%/halving.c \
	%D%/krylov.c \
	%D%/label.c \
	%D%/pairing.c \
	%D%/methods.c \
	%D%/complex/quadratic.c \
	%D%/select.c \
	%D%/spectral.c
# sweeps
%C%_libmodes_la_SOURCES += \
	%D%/sweep/branches_crossover.c \
	%D%/sweep/branches_follow.c \
	%D%/sweep/branches_resample.c \
	%D%/sweep/branches_sample.c \
	%D%/sweep/campbell_range.c \
	%D%/sweep/campbell_resonance.c \
	%D%/sweep/campbell_trace.c \
	%D%/sweep/irvine_range.c \
	%D%/sweep/irvine_trace.c
