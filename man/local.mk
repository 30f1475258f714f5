# man
dist_man_MANS += \
	%D%/hawser-beam.1 \
	%D%/hawser-campbell.1 \
	%D%/hawser-compare.1 \
	%D%/hawser-damping.1 \
	%D%/hawser-folds.1 \
	%D%/hawser-frf.1 \
	%D%/hawser-hill.1 \
	%D%/hawser-integrate.1 \
	%D%/hawser-irvine.1 \
	%D%/hawser-map.1 \
	%D%/hawser-mms.1 \
	%D%/hawser-modes.1 \
	%D%/hawser-plan.1 \
	%D%/hawser-rom.1 \
	%D%/hawser-rom.5 \
	%D%/hawser-statics.1 \
	%D%/hawser.1
man_MANS += %D%/hawser-scene.5
MOSTLYCLEANFILES += %D%/hawser-scene.5
%D%/hawser-scene.5: src/scene/manpage$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) %D% && src/scene/manpage$(EXEEXT) >$@.tmp && mv -f $@.tmp $@
