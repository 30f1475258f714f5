pkginclude_HEADERS = \
	%D%/hawser/beam.h \
	%D%/hawser/beam_motion.h \
	%D%/hawser/backbone.h \
	%D%/hawser/campbell.h \
	%D%/hawser/decay.h \
	%D%/hawser/folds.h \
	%D%/hawser/frf.h \
	%D%/hawser/gyroscopic.h \
	%D%/hawser/hawser.h \
	%D%/hawser/hill.h \
	%D%/hawser/integrate.h \
	%D%/hawser/irvine.h \
	%D%/hawser/linear.h \
	%D%/hawser/map.h \
	%D%/hawser/modes.h \
	%D%/hawser/orbit.h \
	%D%/hawser/plan.h \
	%D%/hawser/plausible.h \
	%D%/hawser/primary.h \
	%D%/hawser/rom.h \
	%D%/hawser/choose.h \
	%D%/hawser/scales.h \
	%D%/hawser/scene.h \
	%D%/hawser/statics.h \
	%D%/hawser/status.h \
	%D%/hawser/study.h \
	%D%/hawser/accuracy.h
