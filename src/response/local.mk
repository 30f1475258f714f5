noinst_LTLIBRARIES += %D%/libresponse.la
%C%_libresponse_la_SOURCES = \
	%D%/amplitude.c \
	%D%/amplitude.h \
	%D%/collocation.c \
	%D%/collocation.h \
	%D%/cvode.c \
	%D%/floquet.c \
	%D%/floquet.h \
	%D%/flow.c \
	%D%/flow.h \
	%D%/frf.c \
	%D%/gauss.c \
	%D%/integrate.c \
	%D%/judge.c \
	%D%/locate.c \
	%D%/locate.h \
	%D%/mesh.c \
	%D%/planner.c \
	%D%/planner.h \
	%D%/record.c \
	%D%/record.h \
	%D%/shooting.c \
	%D%/shooting.h \
	%D%/spectrum.c \
	%D%/start.c \
	%D%/start.h \
	%D%/station.c \
	%D%/station.h \
	%D%/step.c \
	%D%/stepper.c \
	%D%/stepper.h \
	%D%/sweep.c \
	%D%/tableau.c \
	%D%/tableau.h \
	%D%/trace.h
