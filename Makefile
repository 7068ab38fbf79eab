# The few commands a newcomer needs. `make` alone lists them.
# The image to build, explain or measure; `make image` without it builds matrix.yaml's default.target.
TARGET ?=
# The platform to build and test for, such as linux/arm64 (make emulation); empty: the machine's own.
PLATFORM :=
# Groups whose images `make list` lists: distributions, components, frameworks, stacks, architectures.
GROUP ?=
# Stacks whose locks `make locks` makes anew; all if empty.
STACK ?=
# Anything but nothing: list, plan and diff print JSON.
JSON ?=
# What `make diff` compares with: a git revision, or another matrix file.
REV ?= HEAD
# Among how many machines `make plan` deals the images out.
SHARDS ?= 8

SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-print-directory --no-builtin-rules
.DEFAULT_GOAL := help

export PATH := $(CURDIR)/.state/bin:$(PATH)
export UV_COMPILE_BYTECODE := 1
export UV_CACHE_DIR ?= $(CURDIR)/.state/uv
export HYPOTHESIS_STORAGE_DIRECTORY ?= $(CURDIR)/.state/cache/hypothesis
export TARGET REV PLATFORM
# A ROS workspace sets them; they would change what our Python imports.
unexport PYTHONPATH PYTHONHOME PYTHONOPTIMIZE

BOOTSTRAP := python3 scripts/bootstrap.py
RUN := uv run --quiet

.PHONY: help image test test-arm64 lint unit bench list explain generate plan diff locks up emulation down clean status

help: ## this list
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / {printf "  make %-11s %s\n", $$1, $$2}' Makefile

image: .python ## build, test, push and tag one image: make image TARGET=bookworm-base-torch-cu128
	@$(RUN) scripts/publish.py image $(if $(PLATFORM),--platform "$$PLATFORM") --check -- "$$TARGET"
	@$(BOOTSTRAP) up
	@$(RUN) scripts/publish.py image $(if $(PLATFORM),--platform "$$PLATFORM") -- "$$TARGET"

test: up ## the whole suite: linters, unit tests, real builds
	@$(RUN) pytest

test-arm64: emulation ## an image for arm64 with both frameworks, built and tested under emulation: half an hour
	@ROSML_TEST_ARM64=1 $(RUN) pytest tests/e2e/test_arm64.py

lint: .python ## the linters only
	@$(RUN) pytest tests/lint

unit: .python ## the linters and the unit tests: no builder, two minutes
	@$(RUN) pytest tests/lint tests/unit

bench: up ## our second image beside one with RUN pip install, and how fast the generator is: make bench TARGET=bookworm-base-torch-cu128
	@$(RUN) scripts/bench.py --target="$$TARGET"

list: .python ## every image that can be built, or those of groups: make list GROUP="jazzy torch"; JSON=1
	@$(RUN) scripts/generate_bake.py --list $(patsubst %,--group=%,$(GROUP)) $(if $(JSON),--json)

explain: .python ## why an image exists, or why not: make explain TARGET=jazzy-robot
	@$(RUN) scripts/generate_bake.py --explain "$$TARGET"

generate: .python ## docker-bake.hcl, matrix.schema.json and README.md's tables anew, after a change of matrix.yaml
	@$(RUN) scripts/generate_bake.py

plan: .python ## who builds what in CI, with time, download and disk: make plan SHARDS=8; JSON=1
	@$(RUN) scripts/generate_bake.py --shards "$(SHARDS)" $(if $(JSON),--json)

diff: .python ## which images a change builds anew, and why: make diff REV=HEAD~1; JSON=1
	@$(RUN) scripts/generate_bake.py --diff "$$REV" $(if $(JSON),--json)

locks: .python ## the hash-pinned requirements in locks/ anew, after a change of matrix.yaml; UPGRADE=1 moves versions; STACK=cpu: of one stack
	@$(RUN) scripts/lock.py $(if $(UPGRADE),--upgrade) $(patsubst %,--stack=%,$(STACK))

up: ## set up: tools, local registry, builder (the commands above do it by themselves)
	@$(BOOTSTRAP) up

emulation: up ## let this machine build and test for the other architecture too: make image TARGET=bookworm-core PLATFORM=linux/arm64
	@$(BOOTSTRAP) emulate

down: ## stop the registry and the builder; what they stored stays
	@$(BOOTSTRAP) down

clean: ## stop them and remove all that was made
	@$(BOOTSTRAP) clean

status: ## what is running
	@$(BOOTSTRAP) status

.PHONY: .python
.python:
	@$(BOOTSTRAP) tools --python
