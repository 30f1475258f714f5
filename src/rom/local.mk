noinst_LTLIBRARIES += %D%/librom.la
%C%_librom_la_SOURCES = \
	%D%/condense/answer.c \
	%D%/condense/answer_freeze.c \
	%D%/condense/answer_make.c \
	%D%/file/auto.c \
	%D%/energy/block.c \
	%D%/build/build.c \
	%D%/choose/beyond.c \
	%D%/choose/choose.c \
	%D%/energy/compile.c \
	%D%/energy/compile_cable.c \
	%D%/condense/bend.c \
	%D%/condense/condense.c \
	%D%/condense/condense_load.c \
	%D%/terms/contacts.c \
	%D%/terms/absorbers.c \
	%D%/terms/dampers.c \
	%D%/terms/damping.c \
	%D%/terms/drag.c \
	%D%/file/formula.c \
	%D%/file/export.c \
	%D%/file/modal.c \
	%D%/file/parse.c \
	%D%/file/plug.c \
	%D%/file/read_own.c \
	%D%/terms/rates.c \
	%D%/terms/terms.c \
	%D%/terms/morison.c \
	%D%/terms/wake.c \
	%D%/terms/wind.c \
	%D%/choose/drive.c \
	%D%/energy/effort.c \
	%D%/terms/ends.c \
	%D%/file/entries.c \
	%D%/choose/cycle.c \
	%D%/condense/displaced.c \
	%D%/energy/exact.c \
	%D%/energy/exact_bend.c \
	%D%/energy/exact_block.c \
	%D%/energy/exact_make.c \
	%D%/condense/fields.c \
	%D%/condense/follow.c \
	%D%/terms/forced.c \
	%D%/energy/full.c \
	%D%/energy/full_error.c \
	%D%/energy/full_map.c \
	%D%/energy/gradient.c \
	%D%/terms/history.c \
	%D%/terms/history_motion.c \
	%D%/condense/inertia.c \
	%D%/condense/inertia_amplitude.c \
	%D%/condense/inertia_choice.c \
	%D%/condense/basis.c \
	%D%/energy/kernel.c \
	%D%/condense/known.c \
	%D%/energy/law.c \
	%D%/energy/law_range.c \
	%D%/condense/known_below.c \
	%D%/build/expanded.c \
	%D%/build/expanded_answer.c \
	%D%/build/expanded_inertia.c \
	%D%/build/line.c \
	%D%/build/line_answer.c \
	%D%/build/line_inertia.c \
	%D%/build/line_lift.c \
	%D%/build/line_load.c \
	%D%/terms/load.c \
	%D%/condense/load_fields.c \
	%D%/build/model.c \
	%D%/build/net.c \
	%D%/build/net_damped.c \
	%D%/build/net_fill.c \
	%D%/build/net_finer.c \
	%D%/build/net_inertia.c \
	%D%/build/net_lift.c \
	%D%/build/net_load.c \
	%D%/build/net_place.c \
	%D%/build/net_water.c \
	%D%/build/net_wind.c \
	%D%/file/open.c \
	%D%/condense/order.c \
	%D%/condense/order_effect.c \
	%D%/energy/panel.c \
	%D%/energy/project.c \
	%D%/energy/quartic.c \
	%D%/energy/quartic_make.c \
	%D%/energy/quartic_tangent.c \
	%D%/energy/relax.c \
	%D%/file/read.c \
	%D%/file/read_ends.c \
	%D%/file/read_known.c \
	%D%/file/read_range.c \
	%D%/file/rows.c \
	%D%/energy/shapes.c \
	%D%/condense/support.c \
	%D%/condense/support_energy.c \
	%D%/energy/support_exact.c \
	%D%/terms/ties.c \
	%D%/condense/support_shape.c \
	%D%/terms/travel.c \
	%D%/terms/travel_modes.c \
	%D%/condense/twin.c \
	%D%/terms/vary.c \
	%D%/choose/weigh.c \
	%D%/file/write.c \
	%D%/file/writer.c

# What is the same in all exported models, as lines of C.
EXTRA_DIST += %D%/file/texts/auto.f90 %D%/file/texts/export.m %D%/file/texts/export.jl
BUILT_SOURCES += %D%/auto_text.h %D%/export_text.h
CLEANFILES += %D%/auto_text.h %D%/export_text.h
%D%/auto_text.h: %D%/file/texts/auto.f90 src/lines.awk
	$(AM_V_GEN)$(MKDIR_P) %D% && $(AWK) -f $(srcdir)/src/lines.awk $(srcdir)/%D%/file/texts/auto.f90 >$@.tmp && mv -f $@.tmp $@
%D%/export_text.h: %D%/file/texts/export.m %D%/file/texts/export.jl src/lines.awk
	$(AM_V_GEN)$(MKDIR_P) %D% && $(AWK) -f $(srcdir)/src/lines.awk $(srcdir)/%D%/file/texts/export.m \
		$(srcdir)/%D%/file/texts/export.jl >$@.tmp && mv -f $@.tmp $@
%D%/file/auto.lo: %D%/auto_text.h
%D%/file/export.lo: %D%/export_text.h
