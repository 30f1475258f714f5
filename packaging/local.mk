# Around make install and make uninstall: the loader learns of the library, and folders that the install
# made go away with it.
EXTRA_DIST += %D%/folders.sh %D%/loader.sh
DISTCLEANFILES = installed-folders
INSTALL_FOLDERS = '$(bindir)' '$(libdir)' '$(pkgconfigdir)' '$(pkgincludedir)' '$(docdir)' '$(scenesdir)' \
	'$(man1dir)' '$(man5dir)' '$(bashcompletiondir)' '$(zshcompletiondir)' '$(fishcompletiondir)'
RUN_FOLDERS = DESTDIR='$(DESTDIR)' $(SHELL) $(srcdir)/%D%/folders.sh
RUN_LOADER = DESTDIR='$(DESTDIR)' $(SHELL) $(srcdir)/%D%/loader.sh

# The target stands in a variable: automake would take a rule for it as a replacement of its own. install-am
# starts a make for the files when its prerequisites are done.
before_install = install-am
$(before_install): note-folders
.PHONY: note-folders
note-folders:
	@$(RUN_FOLDERS) note installed-folders $(INSTALL_FOLDERS)

install-exec-hook:
	@$(RUN_LOADER) '$(libdir)' '$(bindir)/hawser$(EXEEXT)'

uninstall-hook:
	@$(RUN_FOLDERS) remove installed-folders $(INSTALL_FOLDERS)
	@$(RUN_LOADER) '$(libdir)'

# Debian packages of the tarball, in deb/; and these in a bare Debian (both need root's tools: see the scripts)
EXTRA_DIST += %D%/deb.sh %D%/check-roots.sh %D%/try-packages.sh %D%/bare-root.sh %D%/static.sh %D%/try-static.sh \
	debian/changelog debian/control debian/copyright debian/hawser.install debian/hawser-doc.docs \
	debian/hawser-doc.install debian/libhawser0.install debian/libhawser-dev.examples \
	debian/libhawser-dev.install debian/rules debian/source/format debian/tests/control \
	debian/tests/library debian/tests/main-job debian/tests/python
.PHONY: deb deb-try check-roots
deb:
	@$(SHELL) $(srcdir)/%D%/deb.sh --needs
	$(MAKE) $(AM_MAKEFLAGS) dist
	$(SHELL) $(srcdir)/%D%/deb.sh $(distdir).tar.gz deb
# As root, and from a clone: the two commands of README.md in bare Debians; logs in roots/.
ROOTS = bookworm trixie
check-roots:
	@$(SHELL) $(srcdir)/%D%/check-roots.sh roots $(ROOTS)
deb-try:
	$(SHELL) $(srcdir)/%D%/bare-root.sh deb

# The program for machines without its packages, linked statically in a build folder of its own, and whether it runs
# in a folder with nothing else, with the results of the program here.
STATIC_NAME = $(PACKAGE_TARNAME)-$(PACKAGE_VERSION)-$(host_cpu)-linux
.PHONY: static-tarball static-try
static-tarball:
	@$(MKDIR_P) static
	@test -f static/config.status || { cd static && $(abs_top_srcdir)/configure -q --disable-shared \
		--without-siconos --without-mpi --without-hdf5 CC='$(CC)' CFLAGS='$(CFLAGS)'; }
	cd static && $(MAKE) all-am
	CC='$(CC)' $(SHELL) $(srcdir)/%D%/static.sh static $(STATIC_NAME)
static-try:
	$(SHELL) $(srcdir)/%D%/try-static.sh $(STATIC_NAME).tar.gz ./hawser$(EXEEXT)
