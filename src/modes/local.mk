noinst_LTLIBRARIES += %D%/libmodes.la
%C%_libmodes_la_SOURCES = \
	%D%/analytic.c \
	%D%/analytic.h \
	%D%/basis.c \
	%D%/cable.c \
	%D%/cable.h \
	%D%/chain.c \
	%D%/chain.h \
	%D%/compare.c \
	%D%/complex_mode.c \
	%D%/complex_mode.h \
	%D%/compliance.c \
	%D%/compliance_refine.c \
	%D%/compliance_springs.c \
	%D%/compliance_springs.h \
	%D%/convection.c \
	%D%/damped.c \
	%D%/damped.h \
	%D%/damped_trace.c \
	%D%/compliance.h \
	%D%/fdm.c \
	%D%/fdm.h \
	%D%/grid.c \
	%D%/grid.h \
	%D%/gyroscopic.c \
	%D%/gyroscopic.h \
	%D%/gyroscopic_analytic.c \
	%D%/gyroscopic_fdm.c \
	%D%/gyroscopic_spectral.c \
	%D%/halving.c \
	%D%/halving.h \
	%D%/krylov.c \
	%D%/krylov.h \
	%D%/label.c \
	%D%/label.h \
	%D%/methods.c \
	%D%/methods.h \
	%D%/quadratic.c \
	%D%/quadratic.h \
	%D%/select.c \
	%D%/spectral.c \
	%D%/spectral.h
# sweeps
%C%_libmodes_la_SOURCES += \
	%D%/branches.h \
	%D%/branches_crossover.c \
	%D%/branches_follow.c \
	%D%/branches_resample.c \
	%D%/branches_sample.c \
	%D%/campbell_range.c \
	%D%/campbell_range.h \
	%D%/campbell_resonance.c \
	%D%/campbell_trace.c \
	%D%/irvine_range.c \
	%D%/irvine_range.h \
	%D%/irvine_trace.c
