# man
man_MANS += %D%/hawser-scene.5
MOSTLYCLEANFILES += %D%/hawser-scene.5
%D%/hawser-scene.5: src/scene/manpage$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) %D% && src/scene/manpage$(EXEEXT) >$@.tmp && mv -f $@.tmp $@
