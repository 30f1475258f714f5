# Scenes of the tables of the sources, named after them, and some of our own; installed for users to
# start from.
# Table of bench/trade.py, which doc/trade.svg shows.
EXTRA_DIST += %D%/trade.tsv
# Notebooks, which python/tests/test_notebooks.py runs.
EXTRA_DIST += %D%/chairlift.ipynb %D%/how-many-modes.ipynb %D%/irvine.ipynb %D%/stability-map.ipynb %D%/travelling.ipynb
scenesdir = $(pkgdatadir)/scenes
dist_scenes_DATA = \
	%D%/scenes/b-table-2.1.yaml \
	%D%/scenes/b-table-3.5.yaml \
	%D%/scenes/b-table-4.1-case-1.yaml \
	%D%/scenes/b-table-4.1-case-2.yaml \
	%D%/scenes/b-table-4.1-case-3.yaml \
	%D%/scenes/b-table-4.2.yaml \
	%D%/scenes/b-table-4.3-line-1.yaml \
	%D%/scenes/b-table-4.3-line-2.yaml \
	%D%/scenes/b-table-4.4-line-1.yaml \
	%D%/scenes/b-table-4.4-line-2.yaml \
	%D%/scenes/b-table-4.5.yaml \
	%D%/scenes/b-table-4.6-in-plane.yaml \
	%D%/scenes/b-table-4.6-out-of-plane.yaml \
	%D%/scenes/b-table-5.1-fictitious.yaml \
	%D%/scenes/b-table-5.1-hauling-rope.yaml \
	%D%/scenes/b-table-5.1-ropeway.yaml \
	%D%/scenes/b-table-5.2.yaml \
	%D%/scenes/b-table-5.3.yaml \
	%D%/scenes/b-table-5.4-at-rest.yaml \
	%D%/scenes/b-table-5.4.yaml \
	%D%/scenes/b-table-5.5.yaml \
	%D%/scenes/b-table-5.6.yaml \
	%D%/scenes/b-table-6.3.yaml \
	%D%/scenes/bridge-stay.yaml \
	%D%/scenes/net-bars.yaml \
	%D%/scenes/net-capstan.yaml \
	%D%/scenes/net-crosstie.yaml \
	%D%/scenes/net-drag.yaml \
	%D%/scenes/net-dragged.txt \
	%D%/scenes/net-current.yaml \
	%D%/scenes/net-dragged.yaml \
	%D%/scenes/net-impact.yaml \
	%D%/scenes/net-pendulum.yaml \
	%D%/scenes/net-belt.yaml \
	%D%/scenes/net-belt-driven.yaml \
	%D%/scenes/net-table-3-6.yaml \
	%D%/scenes/span-seabed.yaml \
	%D%/scenes/net-mooring.yaml \
	%D%/scenes/net-seabed.yaml \
	%D%/scenes/net-table-3-1.yaml \
	%D%/scenes/stay-anchorage.yaml \
	%D%/scenes/stay-absorber.yaml \
	%D%/scenes/stay-sink.yaml \
	%D%/scenes/stay-damper.yaml \
	%D%/scenes/stay-mast.yaml \
	%D%/scenes/stay-clamped.yaml \
	%D%/scenes/chairlift.yaml \
	%D%/scenes/conductor.yaml \
	%D%/scenes/conductor-iced.yaml \
	%D%/scenes/conductor-spacers.yaml \
	%D%/scenes/conductor-towers.yaml \
	%D%/scenes/decay.tsv \
	%D%/scenes/d-figure-9.1.yaml \
	%D%/scenes/d-figure-9.10.yaml \
	%D%/scenes/d-figure-9.11.yaml \
	%D%/scenes/d-figure-9.2.yaml \
	%D%/scenes/d-figure-9.3.yaml \
	%D%/scenes/d-figure-9.4.yaml \
	%D%/scenes/d-figure-9.5.yaml \
	%D%/scenes/d-figure-9.7.yaml \
	%D%/scenes/d-figure-9.8.yaml \
	%D%/scenes/d-figure-9.9.yaml \
	%D%/scenes/d-section-5.1.2.yaml \
	%D%/scenes/d-section-5.1.3.yaml \
	%D%/scenes/d-section-5.1.4.yaml \
	%D%/scenes/d-section-5.2.2.yaml \
	%D%/scenes/d-section-5.2.4.yaml \
	%D%/scenes/d-section-5.2.5.yaml \
	%D%/scenes/d-section-5.2.6.yaml \
	%D%/scenes/d-section-5.2.3.yaml \
	%D%/scenes/d-section-5.3.yaml \
	%D%/scenes/tow-orbit.yaml \
	%D%/scenes/tow-u-turn.yaml %D%/scenes/tow-waves.yaml \
	%D%/scenes/deep-sag-light.yaml \
	%D%/scenes/deep-sag.yaml \
	%D%/scenes/guide-rope.yaml \
	%D%/scenes/hoist-rope.yaml \
	%D%/scenes/duffing.json \
	%D%/scenes/two-masses.json \
	%D%/scenes/rayleigh.json \
	%D%/scenes/parametric-amplifier.json \
	%D%/scenes/parametric-duffing.json \
	%D%/scenes/inclined.yaml \
	%D%/scenes/level-two-to-one.yaml \
	%D%/scenes/rope.yaml \
	%D%/scenes/rope-current.yaml \
	%D%/scenes/rod-bend.yaml \
	%D%/scenes/rod-hoist.yaml \
	%D%/scenes/rod-pipe.yaml \
	%D%/scenes/rod-roll.yaml \
	%D%/scenes/rod-tether.yaml %D%/scenes/rod-waves.yaml \
	%D%/scenes/ropeway-bouquet.yaml \
	%D%/scenes/ropeway-carriers.yaml \
	%D%/scenes/ropeway-gondola.yaml \
	%D%/scenes/ropeway-transient.yaml \
	%D%/scenes/ropeway-small.yaml \
	%D%/scenes/stay-frequencies.tsv \
	%D%/scenes/second-stable-region.yaml
