# The theory notes, installed and distributed: an index and a page a stage. A new page is entered here.
dist_doc_DATA += \
	%D%/coming-from.md \
	%D%/cluster.md \
	%D%/commands.md \
	%D%/errata.md \
	%D%/gallery.md \
	%D%/glossary.md \
	%D%/install.md \
	%D%/library.md \
	%D%/python.md \
	%D%/theory-beam.md \
	%D%/theory-net.md %D%/theory-net-motion.md \
	%D%/theory-bending.md \
	%D%/robustness.md \
	%D%/theory-campbell.md \
	%D%/moorings.md \
	%D%/theory-contact.md \
	%D%/theory-compare.md \
	%D%/theory-friction.md \
	%D%/theory-folds.md \
	%D%/theory-gyroscopic.md \
	%D%/theory-hill.md \
	%D%/theory-identify.md \
	%D%/theory-integrate.md \
	%D%/theory-irvine.md \
	%D%/theory-map.md \
	%D%/theory-response.md \
	%D%/theory-ropeway.md \
	%D%/theory-scales.md \
	%D%/theory-statics.md \
	%D%/spans.md \
	%D%/theory-study.md \
	%D%/theory-modes.md \
	%D%/theory-obstacles.md \
	%D%/theory-lengthening.md \
	%D%/theory-rod.md \
	%D%/theory-rom.md \
	%D%/theory-ropeway-modes.md \
	%D%/theory-ropeway-response.md \
	%D%/theory-ropeway-transient.md \
	%D%/theory-tow.md \
	%D%/theory-travel-rom.md \
	%D%/theory-travel.md \
	%D%/theory.md \
	%D%/tutorial.md \
	%D%/tutorial-chairlift.md \
	%D%/tutorial-galloping.md \
	%D%/tutorial-models.md \
	%D%/tutorial-mooring.md \
	%D%/tutorial-nets.md \
	%D%/tutorial-stay.md \
	%D%/waves.md \
	%D%/water.md
# The list of all messages, from the sources. It is not in the repository, and not in a build without python3.
doc_DATA += $(message_pages)
if PYTHON
message_pages = %D%/messages.md
endif
MOSTLYCLEANFILES += %D%/messages.md
%D%/messages.md: $(srcdir)/tests/checks/messages.py hawser$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) %D% && python3 -S $(srcdir)/tests/checks/messages.py list $(srcdir) >$@.tmp && mv -f $@.tmp $@
# Figures of the notes: `make figures` draws them into the build folder's figures/, from benches.
EXTRA_DIST += %D%/campbell.svg %D%/carriers.svg %D%/convergence.svg %D%/damper-place.svg %D%/absorber.svg %D%/spacers.svg %D%/over-tension.svg %D%/loci.svg %D%/net-bars.svg %D%/net-modes.svg %D%/net-profile.svg %D%/nnm-tongue.svg %D%/response.svg %D%/tori.svg %D%/damper-size.svg %D%/figures-beam.sh %D%/figures-spans.sh %D%/figures-travel.sh %D%/figures-validity.sh %D%/figures.sh \
	%D%/stay-map.svg %D%/trade.svg %D%/travel-holds.svg %D%/validity.svg
.PHONY: figures
figures: bench/shapes hawser
	SRCDIR=$(top_srcdir) $(SHELL) $(srcdir)/doc/figures.sh figures

# The documentation site in site/: of the documents, manual pages and headers, with the pictures that the commands of its pages draw.
# SITE_PICTURES=no leaves these out. Sphinx, MyST, furo and mandoc make it (packages.txt).
EXTRA_DIST += %D%/site/assemble.py %D%/site/build.sh %D%/site/conf.py %D%/site/equations.py %D%/site/headers.py %D%/site/manual.py %D%/site/pictures.sh \
	%D%/site/static/hawser.css %D%/site/templates/page.html tests/checks/links.py
SITE_PICTURES = yes
.PHONY: site
site: hawser$(EXEEXT) $(command_pages) man/hawser-scene.5
	SRCDIR='$(abs_top_srcdir)' MANDIR=man VERSION='$(PACKAGE_VERSION)' PICTURES='$(SITE_PICTURES)' \
		HAWSER='$(abs_top_builddir)/hawser$(EXEEXT)' \
		$(SHELL) $(srcdir)/%D%/site/build.sh site
	python3 $(srcdir)/tests/checks/links.py site
	@echo "the site is in $$PWD/site: open index.html"
