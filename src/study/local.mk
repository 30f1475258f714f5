noinst_LTLIBRARIES += %D%/libstudy.la
%C%_libstudy_la_SOURCES = \
	%D%/chosen.c \
	%D%/closed.c \
	%D%/cost.c \
	%D%/decide.c \
	%D%/estimate.c \
	%D%/fidelity.c \
	%D%/landmark.c \
	%D%/landmark.h \
	%D%/match.c \
	%D%/motions.c \
	%D%/motions.h \
	%D%/plan.c \
	%D%/respond.h \
	%D%/run.c \
	%D%/scales.c \
	%D%/scales.h \
	%D%/sharpen.c \
	%D%/survey.h
# accuracy asked for
%C%_libstudy_la_SOURCES += \
	%D%/accuracy.c \
	%D%/distance.c \
	%D%/distance.h
