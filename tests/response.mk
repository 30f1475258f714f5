# tests of the stage response
test_programs += tests/response
tests_response_SOURCES = tests/cases.c \
	tests/extremes/taylor.c \
	tests/extremes/test-folds-extremes.c \
	tests/extremes/test-folds-memory.c \
	tests/extremes/test-frf-extremes.c \
	tests/extremes/test-integrate-late.c \
	tests/extremes/test-integrate-memory.c \
	tests/extremes/test-sweep-curves.c \
	tests/extremes/test-sweep-folds.c \
	tests/extremes/test-sweep-frf.c \
	tests/extremes/test-sweep-integrate.c \
	tests/extremes/test-sweep-load.c \
	tests/extremes/test-sweep-mms.c \
	tests/property/test-absorber-motion.c \
	tests/property/test-absorber-response.c \
	tests/property/test-backbone.c \
	tests/property/test-balance-terms.c \
	tests/property/test-beam-motion.c \
	tests/property/test-branches.c \
	tests/property/test-combined.c \
	tests/property/test-drag.c \
	tests/property/test-event-claims.c \
	tests/property/test-event-errors.c \
	tests/property/test-export-own.c \
	tests/property/test-folds-least.c \
	tests/property/test-folds.c \
	tests/property/test-frf-full.c \
	tests/property/test-frf.c \
	tests/property/test-history.c \
	tests/property/test-integrate-long.c \
	tests/property/test-integrate-stiff.c \
	tests/property/test-integrate-swept.c \
	tests/property/test-integrate-tolerance.c \
	tests/property/test-known-orbits.c \
	tests/property/test-line-rom.c \
	tests/property/test-linear-condensed.c \
	tests/property/test-loads.c \
	tests/property/test-lyapunov.c \
	tests/property/test-mathieu-duffing.c \
	tests/property/test-motion.c \
	tests/property/test-nnm-whirl.c \
	tests/property/test-nnm.c \
	tests/property/test-normal-form.c \
	tests/property/test-own.c \
	tests/property/test-plugin.c \
	tests/property/test-resonance.c \
	tests/property/test-rom-full-motion.c \
	tests/property/test-scales.c \
	tests/property/test-support.c \
	tests/property/test-tori.c \
	tests/property/test-torus.c \
	tests/property/test-travel-motion.c \
	tests/property/test-undamped.c \
	tests/property/test-whirling.c \
	tests/reference/test-autonomous.c \
	tests/reference/test-feigenbaum.c \
	tests/reference/test-folds.c \
	tests/reference/test-galloping.c \
	tests/reference/test-frf-published.c \
	tests/reference/test-locus-own.c \
	tests/reference/test-net-rom.c \
	tests/reference/test-wakes.c \
	tests/unit/test-balance-blocks.c \
	tests/unit/test-balance.c \
	tests/unit/test-collide.c \
	tests/unit/test-cover.c \
	tests/unit/test-floquet.c \
	tests/unit/test-flow.c \
	tests/unit/test-folds.c \
	tests/unit/test-frf-events.c \
	tests/unit/test-frf-vanish.c \
	tests/unit/test-guards-response.c \
	tests/unit/test-hill-matrix.c \
	tests/unit/test-integrate-spectrum.c \
	tests/unit/test-integrate.c \
	tests/unit/test-linear.c \
	tests/unit/test-locus.c \
	tests/unit/test-monodromy.c \
	tests/unit/test-surge.c \
	tests/unit/test-varying.c
nodist_tests_response_SOURCES = tests/response-cases.c
tests_response_LDADD = $(UPTO_RESPONSE) $(GSL_LIBS)
EXTRA_DIST += tests/reference/autonomous/adaptx.json tests/reference/autonomous/string8.json tests/reference/autonomous/corners.json tests/reference/autonomous/lorenz84.json tests/reference/autonomous/cusp.json tests/reference/autonomous/equal.json tests/reference/autonomous/flip.json tests/reference/autonomous/fold-flip.json tests/reference/autonomous/fold-torus.json tests/reference/autonomous/half.json tests/reference/autonomous/pleat.json tests/reference/autonomous/roots.json tests/reference/autonomous/takens.json tests/reference/autonomous/bautin.json tests/reference/autonomous/belt.json tests/reference/autonomous/brusselator.json tests/reference/autonomous/lorenz.json tests/reference/autonomous/o2.json \
	tests/reference/autonomous/parkinson.json tests/reference/autonomous/two.json tests/reference/autonomous/vdp.json tests/reference/autonomous/wake.json tests/reference/autonomous/ziegler.json
EXTRA_DIST += tests/reference/absorber.json tests/reference/frf-cases.txt tests/reference/duffing-nlvib-01.json \
	tests/reference/pair-2to1.json tests/reference/springs-nlvib-06-f1e-3.json \
	tests/reference/springs-nlvib-06-f3e-3.json tests/reference/pair-quintic.json tests/reference/one-to-three.json tests/reference/two-masses-nes.json tests/reference/beam-1to3.json tests/reference/torus-as-doubling.json
EXTRA_DIST += tests/reference/net-rom-carriers.yaml tests/reference/net-rom-cells.yaml tests/reference/net-rom-float.yaml tests/reference/net-rom-moved.yaml \
	tests/reference/net-rom-span.yaml tests/reference/net-rom-spans.yaml tests/reference/net-rom-stays.yaml \
	tests/reference/net-rom-strings.yaml
