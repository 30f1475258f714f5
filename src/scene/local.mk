noinst_LTLIBRARIES += %D%/libscene.la
%C%_libscene_la_SOURCES = \
	%D%/check.c \
	%D%/document.c \
	%D%/events.c \
	%D%/keys.c \
	%D%/paths.c \
	%D%/plausible.c \
	%D%/scene.c \
	%D%/page/schema.c \
	%D%/page/schema_span.c \
	%D%/page/schema_value.c \
	%D%/span_read.c \
	%D%/span_rows.c \
	%D%/state_file.c \
	%D%/tree.c \
	%D%/tree_keys.c \
	%D%/tree_fill.c \
	%D%/tree_set.c \
	%D%/tree_value.c \
	%D%/units.c \
	%D%/units_common.c \
	%D%/units_explain.c \
	%D%/wind_read.c \
	%D%/write.c

# Writes hawser-scene(5) from the table of keys; man/local.mk runs it.
EXTRA_PROGRAMS += %D%/manpage
CLEANFILES += %D%/manpage$(EXEEXT)
%C%_manpage_SOURCES = \
	%D%/page/example.c \
	%D%/page/manpage.c
%C%_manpage_LDADD = %D%/libscene.la src/core/libcore.la $(YAML_LIBS) $(JANSSON_LIBS) $(UDUNITS_LIBS)
