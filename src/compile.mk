# libtool's script starts some forty processes for each object that it compiles, which together take longer than the compiler.
# Where one kind of library is made, on Linux, src/compile.sh does the same, and src/archive.sh what libtool does for an archive.
# automake does not understand conditions of make, so make includes this file itself. LTCOMPILE is libtool's command; what stands after --mode=compile is the compiler's.
libraries_made = $(host_os) $(enable_shared) $(enable_static)
ifeq ($(libraries_made),linux-gnu yes no)
kind_made = shared
endif
ifeq ($(libraries_made),linux-gnu no yes)
kind_made = static
endif
ifdef kind_made
LTCOMPILE = $(SHELL) $(top_srcdir)/src/compile.sh $(kind_made) $(CC) $(DEFS) $(DEFAULT_INCLUDES) $(INCLUDES) $(AM_CPPFLAGS) \
	$(CPPFLAGS) $(AM_CFLAGS) $(CFLAGS)
$(noinst_LTLIBRARIES): private LINK = $(SHELL) $(top_srcdir)/src/archive.sh $(kind_made) $(AR) -o $@
endif
