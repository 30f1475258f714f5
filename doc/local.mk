# The theory notes, installed and distributed: an index and a page a stage. A new page is entered here.
dist_doc_DATA += \
	%D%/errata.md \
	%D%/theory-compare.md \
	%D%/theory-integrate.md \
	%D%/theory-irvine.md \
	%D%/theory-response.md \
	%D%/theory-statics.md \
	%D%/theory-modes.md \
	%D%/theory-rom.md \
	%D%/theory.md
# Figures of the notes are drawn by figures.sh, from benches, and kept.
EXTRA_DIST += %D%/figures.sh
figuresdir = $(docdir)/figures
dist_figures_DATA = %D%/figures/analytic-shapes.svg
