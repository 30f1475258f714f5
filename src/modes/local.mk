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
	%D%/compliance.c \
	%D%/convection.c \
	%D%/compliance.h \
	%D%/fdm.c \
	%D%/fdm.h \
	%D%/grid.c \
	%D%/grid.h \
	%D%/gyroscopic.c \
	%D%/gyroscopic.h \
	%D%/gyroscopic_spectral.c \
	%D%/halving.c \
	%D%/halving.h \
	%D%/krylov.c \
	%D%/krylov.h \
	%D%/label.c \
	%D%/label.h \
	%D%/methods.c \
	%D%/methods.h \
	%D%/select.c \
	%D%/spectral.c \
	%D%/spectral.h
# sweeps
%C%_libmodes_la_SOURCES += \
	%D%/irvine_branches.h \
	%D%/irvine_follow.c \
	%D%/irvine_meet.c \
	%D%/irvine_range.c \
	%D%/irvine_range.h \
	%D%/irvine_stop.c \
	%D%/irvine_trace.c
