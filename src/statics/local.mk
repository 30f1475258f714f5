noinst_LTLIBRARIES += %D%/libstatics.la
%C%_libstatics_la_SOURCES = \
	%D%/catenary.h \
	%D%/frame.h \
	%D%/models.h \
	%D%/search.h \
	%D%/travel.h \
	%D%/catenary.c \
	%D%/tension.c \
	%D%/travel.c \
	%D%/wind.c \
	%D%/wind.h \
	%D%/equivalent.c \
	%D%/held.c \
	%D%/limit.c \
	%D%/load.c \
	%D%/load.h \
	%D%/loaded.c \
	%D%/loaded.h \
	%D%/loaded_solve.c \
	%D%/sag.c \
	%D%/length.c \
	%D%/solve.c \
	%D%/irvine.c \
	%D%/models.c \
	%D%/parabola.c \
	%D%/plausible.c \
	%D%/profile.c \
	%D%/profile_space.c \
	%D%/space.c \
	%D%/yield.c
