noinst_LTLIBRARIES += %D%/libscene.la
%C%_libscene_la_SOURCES = \
	%D%/placeholder.c
