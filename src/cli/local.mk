bin_PROGRAMS += hawser
hawser_SOURCES = \
	%D%/main.c
hawser_LDADD = src/output/liboutput.la libhawser.la $(JANSSON_LIBS)
