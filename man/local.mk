# man
dist_man_MANS += \
	%D%/hawser-rom.5
# Made of man/PAGE.in, the text that pages share, and the program's lists of columns and keys.
command_pages = \
	%D%/hawser.1 \
	%D%/hawser-beam.1 \
	%D%/hawser-campbell.1 \
	%D%/hawser-check.1 \
	%D%/hawser-completion.1 \
	%D%/hawser-compare.1 \
	%D%/hawser-damping.1 \
	%D%/hawser-folds.1 \
	%D%/hawser-locus.1 \
	%D%/hawser-frf.1 \
	%D%/hawser-hill.1 \
	%D%/hawser-identify.1 \
	%D%/hawser-init.1 \
	%D%/hawser-integrate.1 \
	%D%/hawser-irvine.1 \
	%D%/hawser-map.1 \
	%D%/hawser-merge.1 \
	%D%/hawser-mms.1 \
	%D%/hawser-modes.1 \
	%D%/hawser-nnm.1 \
	%D%/hawser-orbit.1 \
	%D%/hawser-plan.1 \
	%D%/hawser-report.1 \
	%D%/hawser-rom.1 \
	%D%/hawser-schema.1 \
	%D%/hawser-statics.1 \
	%D%/hawser-sweep.1 \
	%D%/hawser-tow.1 \
	%D%/hawser-trajectory.1 \
	%D%/hawser-transient.1
shared_text = \
	%D%/shared/examples \
	%D%/shared/exit \
	%D%/shared/exit-failed \
	%D%/shared/exit-nothing \
	%D%/shared/exit-partial \
	%D%/shared/files \
	%D%/shared/followed \
	%D%/shared/frequencies \
	%D%/shared/library \
	%D%/shared/help \
	%D%/shared/mesh \
	%D%/shared/lane \
	%D%/shared/lane-damping \
	%D%/shared/lane-load \
	%D%/shared/lane-undamped \
	%D%/shared/modes \
	%D%/shared/picture \
	%D%/shared/picture-gp \
	%D%/shared/picture-size \
	%D%/shared/picture-title \
	%D%/shared/reproducible \
	%D%/shared/units \
	%D%/shared/scene \
	%D%/shared/scene-or-model \
	%D%/shared/set \
	%D%/shared/table
man_MANS += $(command_pages) %D%/hawser-scene.5
EXTRA_DIST += %D%/page.awk $(command_pages:=.in) %D%/hawser-scene.5.in $(shared_text)
MOSTLYCLEANFILES += $(command_pages) %D%/hawser-scene.5
# In the build folder hawser is a script of libtool's, which starts a dozen processes before the program.
program = $$(test -x .libs/hawser && echo LD_LIBRARY_PATH=.libs .libs/hawser || echo ./hawser$(EXEEXT))
$(command_pages): %D%/%.1: $(srcdir)/%D%/%.1.in hawser$(EXEEXT) %D%/page.awk $(shared_text)
	$(AM_V_GEN)$(MKDIR_P) %D% && LC_ALL=C $(AWK) -v hawser="$(program)" -v shared=$(srcdir)/%D%/shared \
		-f $(srcdir)/%D%/page.awk $< >$@.tmp && mv -f $@.tmp $@
%D%/hawser-scene.5: src/scene/manpage$(EXEEXT) $(srcdir)/%D%/hawser-scene.5.in
	$(AM_V_GEN)$(MKDIR_P) %D% && src/scene/manpage$(EXEEXT) <$(srcdir)/%D%/hawser-scene.5.in >$@.tmp && \
		mv -f $@.tmp $@
# Completion in shells, written by the program.
bash_completion = completions/hawser
zsh_completion = completions/_hawser
fish_completion = completions/hawser.fish
bashcompletiondir = $(datadir)/bash-completion/completions
zshcompletiondir = $(datadir)/zsh/site-functions
fishcompletiondir = $(datadir)/fish/vendor_completions.d
nodist_bashcompletion_DATA = $(bash_completion)
nodist_zshcompletion_DATA = $(zsh_completion)
nodist_fishcompletion_DATA = $(fish_completion)
MOSTLYCLEANFILES += $(bash_completion) $(zsh_completion) $(fish_completion)
$(bash_completion): hawser$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) completions && env $(program) completion bash >$@.tmp && mv -f $@.tmp $@
$(zsh_completion): hawser$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) completions && env $(program) completion zsh >$@.tmp && mv -f $@.tmp $@
$(fish_completion): hawser$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) completions && env $(program) completion fish >$@.tmp && mv -f $@.tmp $@
