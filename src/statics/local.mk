noinst_LTLIBRARIES += %D%/libstatics.la
%C%_libstatics_la_SOURCES = \
	%D%/catenary.c \
	%D%/tension.c \
	%D%/travel.c \
	%D%/wind.c \
	%D%/equivalent.c \
	%D%/held.c \
	%D%/limit.c \
	%D%/load.c \
	%D%/loaded.c \
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
