# Benchmarks: `make bench` builds and runs them all. Nothing of this is part of make or make check.
# A new one: a word in BENCHES, its _SOURCES and _LDADD, and a row in README.md.
BENCHES = %D%/kernel %D%/integrate %D%/statics %D%/modes %D%/modes-methods
EXTRA_PROGRAMS += $(BENCHES) %D%/frf %D%/peak %D%/plan %D%/shapes
CLEANFILES += $(BENCHES) %D%/frf %D%/peak %D%/plan %D%/shapes
EXTRA_DIST += %D%/README.md %D%/convergence.sh %D%/defaults.py %D%/frf-auto.py %D%/locus-auto.py %D%/branches-auto.py %D%/long.py \
	%D%/practical.py %D%/progress.py %D%/python.py %D%/scaling.py %D%/ranges.py %D%/ranks-map.py %D%/start.py %D%/sweep.py %D%/trade.py %D%/backbones.py %D%/bending.py \
	%D%/slack.py %D%/rod-waves.py %D%/wet-rods.py %D%/moordyn.py %D%/net-judge.py %D%/moorings.py %D%/nets.py %D%/ropeway-multipliers.py %D%/autonomous.py %D%/autonomous-auto.py

# solves a second of the statics, errors beside them
%C%_statics_SOURCES = %D%/statics.c
%C%_statics_LDADD = $(UPTO_STATICS)

# what a tolerance of the response costs
%C%_frf_SOURCES = %D%/frf.c
%C%_frf_LDADD = $(UPTO_RESPONSE)

# what a point costs against the processor's peak
%C%_peak_SOURCES = %D%/peak.c
%C%_peak_LDADD = $(UPTO_RESPONSE)

# what a plan estimates against what happens
%C%_plan_SOURCES = %D%/plan.c
%C%_plan_LDADD = $(UPTO_STUDY)

# the water of a sea at many places and times
BENCHES += %D%/waves
%C%_waves_SOURCES = %D%/waves.c
%C%_waves_LDADD = $(UPTO_WATER)

# Irvine diagrams: what following the branches costs
BENCHES += %D%/irvine
%C%_irvine_SOURCES = %D%/irvine.c
%C%_irvine_LDADD = $(UPTO_MODES)

# maps: adaptive and point by point
BENCHES += %D%/map
%C%_map_SOURCES = %D%/map.c
%C%_map_LDADD = $(UPTO_STUDY)

%C%_kernel_SOURCES = %D%/kernel.c %D%/kernel-cable.c
%C%_kernel_LDADD = $(UPTO_ROM)
%C%_integrate_SOURCES = %D%/integrate.c
%C%_integrate_LDADD = $(UPTO_RESPONSE)
%C%_modes_SOURCES = %D%/modes.c
%C%_modes_LDADD = $(UPTO_MODES)
%C%_modes_methods_SOURCES = %D%/modes-methods.c
%C%_modes_methods_LDADD = $(UPTO_MODES)

# where the other methods for modes fail, as a table: doc/figures.sh draws it
%C%_shapes_SOURCES = %D%/shapes.c
%C%_shapes_LDADD = $(UPTO_MODES)

# whether chosen modes keep the accuracy asked for, and at what cost; it takes minutes
EXTRA_PROGRAMS += %D%/accuracy %D%/correction
CLEANFILES += %D%/accuracy %D%/correction
%C%_accuracy_SOURCES = %D%/accuracy.c
%C%_accuracy_LDADD = $(UPTO_STUDY)
%C%_correction_SOURCES = %D%/correction.c
%C%_correction_LDADD = $(UPTO_RESPONSE)

# times that a plan states against runs of random scenes; it takes a quarter of an hour and more
EXTRA_PROGRAMS += %D%/plan-times
CLEANFILES += %D%/plan-times
%C%_plan_times_SOURCES = %D%/plan-times.c %D%/estimates-tally.c
%C%_plan_times_LDADD = $(UPTO_STUDY)

# static laws and peaks of reduced models of random cables against exact energy; it takes minutes
EXTRA_PROGRAMS += %D%/judge
CLEANFILES += %D%/judge
%C%_judge_SOURCES = %D%/judge.c %D%/estimates-tally.c
%C%_judge_LDADD = $(UPTO_STUDY)

# events of random models, traced both ways; a thousand take some minutes
EXTRA_PROGRAMS += %D%/events
CLEANFILES += %D%/events
%C%_events_SOURCES = %D%/events.c
%C%_events_LDADD = $(UPTO_RESPONSE)

# whether stated errors hold, on random scenes; a thousand a command take minutes
EXTRA_PROGRAMS += %D%/estimates
CLEANFILES += %D%/estimates
ESTIMATES_SOURCES = bench/estimates-tally.c bench/estimates-table.c bench/estimates-catenary.c \
	bench/estimates-modes.c bench/estimates-campbell.c \
	bench/estimates-models.c bench/estimates-frf.c bench/estimates-integrate.c \
	bench/estimates-hill.c bench/estimates-beam.c bench/estimates-landmarks.c \
	bench/estimates-accuracy.c bench/estimates-spans.c bench/estimates-reference.c \
	bench/estimates-net.c
%C%_estimates_SOURCES = %D%/estimates.c $(ESTIMATES_SOURCES)
%C%_estimates_LDADD = $(UPTO_STUDY)

.PHONY: bench
bench: $(BENCHES) %D%/frf %D%/peak %D%/plan hawser
	@SRCDIR=$(top_srcdir); export SRCDIR; status=0; for program in $(BENCHES); do \
		OPENBLAS_NUM_THREADS=1 ./$$program || status=1; \
	done; \
	OPENBLAS_NUM_THREADS=1 %D%/frf $(top_srcdir)/notebooks-data/scenes/b-table-4.2.yaml || \
		status=1; \
	OPENBLAS_NUM_THREADS=1 %D%/peak $(top_srcdir)/notebooks-data/scenes/b-table-4.4-line-2.yaml || \
		status=1; \
	OPENBLAS_NUM_THREADS=1 %D%/plan $(top_srcdir)/notebooks-data/scenes/b-table-4.4-line-2.yaml || \
		status=1; \
	if test "$(AUTO07P)" = no || test "$(GFORTRAN)" = no || test "$(PYTHON3)" = no; then \
		echo "frf-auto: left out: it needs auto-07p, gfortran and python3"; \
	else \
		$(PYTHON3) $(top_srcdir)/bench/frf-auto.py --hawser ./hawser \
			--scene $(top_srcdir)/notebooks-data/scenes/b-table-4.2.yaml || status=1; \
	fi; exit $$status

# motions of rods
BENCHES += %D%/rod-motion
%C%_rod_motion_SOURCES = %D%/rod-motion.c
%C%_rod_motion_LDADD = $(UPTO_ROD)
BENCHES += %D%/rod-band
%C%_rod_band_SOURCES = %D%/rod-band.c
%C%_rod_band_LDADD = $(UPTO_ROD)

# a time step of a mesh
BENCHES += %D%/net-motion
%C%_net_motion_SOURCES = %D%/net-motion.c
%C%_net_motion_LDADD = $(UPTO_NET)

# modes of nets: times over size, bounds, counts
BENCHES += %D%/net-modes
%C%_net_modes_SOURCES = %D%/net-modes.c
%C%_net_modes_LDADD = $(UPTO_NET)

# statics of nets: times and memory over size; and random nets, of which none may fail
BENCHES += %D%/net-statics
%C%_net_statics_SOURCES = %D%/net-statics.c
%C%_net_statics_LDADD = tests/libnets.a $(UPTO_NET)
# all methods on the random cables of B 3.2.3; doc/figures.sh draws their performance profiles
EXTRA_PROGRAMS += %D%/net-profile
CLEANFILES += %D%/net-profile
%C%_net_profile_SOURCES = %D%/net-profile.c
%C%_net_profile_LDADD = tests/libnets.a $(UPTO_NET)
EXTRA_PROGRAMS += %D%/net-random
CLEANFILES += %D%/net-random
%C%_net_random_SOURCES = %D%/net-random.c
%C%_net_random_LDADD = $(UPTO_NET)

# times that a plan of a net estimates
EXTRA_PROGRAMS += %D%/net-plan
CLEANFILES += %D%/net-plan
%C%_net_plan_SOURCES = %D%/net-plan.c
%C%_net_plan_LDADD = $(UPTO_NET)

# steady states and motions of towed bodies
BENCHES += %D%/tow
%C%_tow_SOURCES = %D%/tow.c
%C%_tow_LDADD = $(UPTO_TOW)
# statics of ropeways: the cost of a sweep over the phases, and random lines
BENCHES += %D%/ropeway
%C%_ropeway_SOURCES = %D%/ropeway.c
%C%_ropeway_LDADD = $(UPTO_ROPEWAY)

# contact with friction in one step: time over contacts, agreement with Siconos
BENCHES += %D%/friction
%C%_friction_SOURCES = %D%/friction.c
%C%_friction_LDADD = tests/libsiconos.a $(UPTO_CONTACT)

# what it costs to hand out tasks to ranks; under mpirun or alone
EXTRA_PROGRAMS += %D%/ranks
CLEANFILES += %D%/ranks
%C%_ranks_SOURCES = %D%/ranks.c src/cli/frame/ranks.c
%C%_ranks_LDADD = src/cli/libloaded.la $(UPTO_CORE)
