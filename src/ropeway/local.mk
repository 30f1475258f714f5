noinst_LTLIBRARIES += %D%/libropeway.la
%C%_libropeway_la_SOURCES = \
	%D%/ahead.c \
	%D%/arc.c \
	%D%/at.c \
	%D%/check.c \
	%D%/flight.c \
	%D%/given.c \
	%D%/line.h \
	%D%/march.c \
	%D%/march.h \
	%D%/path.c \
	%D%/rope.h \
	%D%/search.c \
	%D%/solution.c \
	%D%/trace.c

# The ropeway: its scene, and its two lanes as lines.
%C%_libropeway_la_SOURCES += \
	%D%/contact.c \
	%D%/frame.c \
	%D%/frame.h \
	%D%/lane.c \
	%D%/read.c \
	%D%/read.h \
	%D%/state.c \
	%D%/sweep.c \
	%D%/towers.c
