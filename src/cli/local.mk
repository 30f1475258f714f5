bin_PROGRAMS += hawser
hawser_SOURCES = \
	%D%/choice.c \
	%D%/cli.h \
	%D%/cmd_compare.c \
	%D%/cmd_folds.c \
	%D%/cmd_frf.c \
	%D%/cmd_hill.c \
	%D%/cmd_integrate.c \
	%D%/cmd_irvine.c \
	%D%/cmd_map.c \
	%D%/cmd_mms.c \
	%D%/cmd_modes.c \
	%D%/cmd_plan.c \
	%D%/cmd_rom.c \
	%D%/cmd_statics.c \
	%D%/compare_modes.c \
	%D%/compare_result.c \
	%D%/compare_result.h \
	%D%/deliver.c \
	%D%/echo.c \
	%D%/folds_draw.c \
	%D%/folds_result.c \
	%D%/frf_draw.c \
	%D%/frf_result.c \
	%D%/gauge.c \
	%D%/hill_result.c \
	%D%/hill_result.h \
	%D%/integrate_draw.c \
	%D%/integrate_result.c \
	%D%/irvine_draw.c \
	%D%/irvine_result.c \
	%D%/irvine_result.h \
	%D%/main.c \
	%D%/map_draw.c \
	%D%/map_result.c \
	%D%/mms_result.c \
	%D%/mms_result.h \
	%D%/model.c \
	%D%/natural.c \
	%D%/nearest.c \
	%D%/options.c \
	%D%/plan_result.c \
	%D%/plan_result.h \
	%D%/progress.c \
	%D%/quantity.c \
	%D%/state.c \
	%D%/statics_curves.c
# libcore brings the report's functions, which libhawser does not export
hawser_LDADD = src/output/liboutput.la libhawser.la src/core/libcore.la $(JANSSON_LIBS) \
	$(LAPACKE_LIBS) $(BLAS_LIBS)
