# The Python package: sources and tests; pip installs it (doc/python.md).
EXTRA_DIST += \
	%D%/pyproject.toml \
	%D%/setup.py \
	%D%/hawser/__init__.py \
	%D%/hawser/_headers.py \
	%D%/hawser/_interrupts.py \
	%D%/hawser/_library.py \
	%D%/hawser/_stubs.py \
	%D%/hawser/errors.py \
	%D%/hawser/interactive.py \
	%D%/hawser/models.py \
	%D%/hawser/objects.py \
	%D%/hawser/pictures.py \
	%D%/hawser/plots.py \
	%D%/hawser/py.typed \
	%D%/hawser/results.py \
	%D%/hawser/scenes.py \
	%D%/hawser/sweeps.py \
	%D%/tests/conftest.py \
	%D%/tests/test_documents.py \
	%D%/tests/test_hawser.py \
	%D%/tests/test_interrupts.py \
	%D%/tests/test_layout.py \
	%D%/tests/test_notebooks.py \
	%D%/tests/test_objects.py \
	%D%/tests/test_pictures.py
