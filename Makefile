# Short words for the README's commands. ./rosml has all of them: ./rosml --help
TARGET ?=
PLATFORM ?=
SHARD ?= 1/1
PROOF ?=
VERSION ?=

SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-print-directory --no-builtin-rules
.DEFAULT_GOAL := help
export PATH := $(CURDIR)/.state/bin:$(PATH)
export UV_COMPILE_BYTECODE := 1
export UV_CACHE_DIR ?= $(CURDIR)/.state/uv
export HYPOTHESIS_STORAGE_DIRECTORY ?= $(CURDIR)/.state/cache/hypothesis
export TARGET PLATFORM SHARD VERSION
unexport PYTHONPATH PYTHONHOME PYTHONOPTIMIZE

# A typo must not build something else: `make image TRAGET=x`, `make image jazzy-base`.
COMMANDS := help image test test-all lint unit page bench docs clean release release-build release-publish test-scanner test-signer test-packages
VARIABLES := TARGET PLATFORM SHARD PROOF COVERAGE VERSION PATH SHELL ROSML_% ROS_% BUILDX_% OS_%
UNKNOWN := $(filter-out $(VARIABLES),$(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))) $(filter-out $(COMMANDS),$(MAKECMDGOALS))
$(if $(strip $(UNKNOWN)),$(error nothing was done: make has no command or variable $(strip $(UNKNOWN)); see make's words with: make, all others with: ./rosml --help))

$(if $(and $(filter test,$(MAKECMDGOALS)),$(filter command,$(origin PROOF) $(origin SHARD))),$(error nothing was done: PROOF and SHARD are for make test-all))

SETUP := python3 scripts/bootstrap.py
SUITE := started=$$(date +%s); $(SETUP) suite; .venv/bin/python -m tests.suite --started "$$started"

.PHONY: $(COMMANDS)

help: ## this list
	@awk -F ':.* ## ' '/^[a-z-]+:.* ## / { printf "  make %-13s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST)); echo "All other commands: ./rosml --help"

image: ## set up, build, test and tag one image: make image TARGET=ros1-bookworm-base-torch-cu128 PLATFORM=linux/arm64
	@./rosml image $(if $(PLATFORM),--platform "$$PLATFORM") -- "$$TARGET"

test: ## what every change must pass: linters, unit tests, the catalogue's page, real images
	@$(SUITE)

test-all: ## that, and every proof: SHARD=1/3 is the part of the first of three machines, PROOF=cuda one proof
	@$(SETUP) linters; .venv/bin/python -m tests.suite --check --all --shard "$$SHARD" $(PROOF:%=--proof "%"); $(SUITE) --all --shard "$$SHARD" $(PROOF:%=--proof "%")

lint: ## the linters
	@$(SETUP) linters; .venv/bin/python -m pytest tests/lint

unit: ## the linters and the unit tests, without a builder; COVERAGE=1 fails below 90 % of src/rosml/
	@$(SETUP) linters; .venv/bin/python -m tests.suite --phase unit $(if $(filter 1,$(COVERAGE)),--coverage)

page: ## tests of the catalogue's page in a browser; installs Chromium where there is none
	@$(SETUP) browser; .venv/bin/python -m tests.suite --phase page

bench: ## our images beside those with RUN pip install: make bench TARGET=ros1-bookworm-base-torch-cu128
	@$(SETUP) linters; $(SETUP) up; .venv/bin/python -m bench image --target="$$TARGET"

test-scanner: ## that trivy finds what it must, before a scan relies on it; building trivy takes 10 minutes, once
	@$(SETUP) scanner --tests; .venv/bin/python -m pytest tests/e2e/test_scanner.py

test-signer: ## that cosign signs, before tags rely on it; building cosign takes a quarter of an hour, once
	@$(SETUP) signer --tests; .venv/bin/python -m pytest tests/e2e/test_signer.py

# Docker brings a runc of its own, and Debian's package would take its place, and Docker's with it.
test-packages: ## installs what the proofs desktop and engines need, on Debian and Ubuntu
	@sudo apt-get update && sudo apt-get install --yes --no-install-recommends xvfb xauth x11-utils weston podman uidmap $$(command -v runc >/dev/null || echo runc)

docs: ## the documentation as a site in .state/docs/site, without a broken link
	@$(SETUP) python --tests; .venv/bin/python scripts/docs.py

release: ## write, commit and tag a version, and push nothing: make release VERSION=0.2.0
	@$(SETUP) python; .venv/bin/python scripts/release.py start "$$VERSION"

release-build: ## the wheel and the notes of the tag that is checked out, into .state/release
	@$(SETUP) python; .venv/bin/python scripts/release.py build

release-publish: ## GitHub's release of them, by gh
	@$(SETUP) python; .venv/bin/python scripts/release.py publish

clean: ## stop what runs, and remove all that was made
	@$(SETUP) clean
