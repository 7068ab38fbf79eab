# The few commands a newcomer needs. `make` alone lists them.
# The image to build, explain or measure; `make image` without it builds matrix.yaml's default.target.
TARGET ?=
# The platform to build and test for, such as linux/arm64 (make emulation); empty: the machine's own.
PLATFORM :=
# Groups whose images `make list` lists: distributions, components, frameworks, stacks, architectures.
GROUP ?=
# ROS's apt repository in the place of what matrix.yaml says: live, snapshot (with SNAPSHOT=2026-08-07), final.
CHANNEL :=
SNAPSHOT :=
# Stacks whose locks `make locks` makes anew; all if empty.
STACK ?=
# Anything but nothing: list, explain, plan, diff, locks, status, machine and catalogue print JSON, and catalogue writes nothing.
JSON ?=
# Anything but nothing: `make unit` measures what the tests run of rosml/, and fails below pyproject.toml's fail_under.
COVERAGE ?=
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
# For publish, status and catalogue: images by target, pattern or group; where they go; the architectures that are served there.
ONLY ?=
REGISTRY ?=
SERVE ?=
# Only images that differ from a git revision, at most so many of them.
SINCE ?=
AT_MOST ?= 4
# The folder that `make catalogue` writes; .state/catalogue if empty.
OUTPUT ?=
# Where `make locks` writes its table of versions, in Markdown.
REPORT ?=
# Which part of `make test-all` runs: i/n is that of the i-th of n machines.
SHARD ?= 1/1
# Proofs that `make test-all` runs, and nothing else: files in tests/proofs.
PROOF ?=
export SHARD
export TARGET REV PLATFORM ONLY SERVE SINCE REPORT OUTPUT
# Not under its own name, which is that of a variable of docker-bake.hcl.
export PLACE := $(REGISTRY)
unexport REGISTRY
ifneq ($(CHANNEL)$(SNAPSHOT),)
export ROS_CHANNEL := $(CHANNEL)
export ROS_SNAPSHOT := $(SNAPSHOT)
endif
# A ROS workspace sets them; they would change what our Python imports.
unexport PYTHONPATH PYTHONHOME PYTHONOPTIMIZE

# A slip of the command line would build something else in silence: `make image TRAGET=x`, `make image jazzy-base`.
COMMANDS := help image test test-all proofs lint unit page bench list explain generate plan diff locks up client emulation scanner \
  test-scanner signer test-signer room publish status catalogue down clean machine docs
VARIABLES := TARGET PLATFORM GROUP CHANNEL SNAPSHOT STACK JSON COVERAGE REV SHARDS ONLY REGISTRY SERVE SINCE AT_MOST OUTPUT \
  REPORT SHARD PROOF UPGRADE BASES BOOTSTRAP RUN PATH SHELL ROSML_% BUILDX_% OS_%
GIVEN := $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))
UNKNOWN := $(filter-out $(VARIABLES),$(GIVEN)) $(filter-out $(COMMANDS) .%,$(MAKECMDGOALS))
ifneq ($(strip $(UNKNOWN)),)
$(error nothing was done: make has no command or variable $(strip $(UNKNOWN)); see all with: make)
endif

BOOTSTRAP := python3 scripts/bootstrap.py
RUN := uv run --quiet
# Sets up all that tests need, then runs them; the set-up's time counts.
SUITE := started=$$(date +%s); $(BOOTSTRAP) suite; $(RUN) python -m tests.suite --started "$$started"

.PHONY: $(COMMANDS)

help: ## this list
	@awk -F ': make ' '/^[a-z-]+:.* ## / { name = $$1; sub(/:.*/, "", name); sub(/.* ## /, "", $$1); \
	  printf "  make %-12s %s\n", name, $$1; if ($$2) printf "%20smake %s\n", "", $$2 }' Makefile

image: .python ## build, test, push and tag one image: make image TARGET=bookworm-base-torch-cu128
	@$(RUN) scripts/publish.py image $(if $(PLATFORM),--platform "$$PLATFORM") --check -- "$$TARGET"
	@$(BOOTSTRAP) up
	@$(RUN) scripts/publish.py image $(if $(PLATFORM),--platform "$$PLATFORM") -- "$$TARGET"

test: ## what every change must pass: linters, unit tests, the catalogue's page, real images; it says where its time went
	@$(if $(PROOF)$(filter-out 1/1,$(SHARD)),$(error make test has neither PROOF nor SHARD: make test-all has))
	@$(SUITE)

test-all: .python ## that, and every proof in tests/proofs: SHARD=1/3 is the part of the first of three machines, PROOF=cuda one proof
	@$(RUN) python -m tests.suite --check --all --shard "$$SHARD" $(patsubst %,--proof "%",$(PROOF))
	@$(SUITE) --all --shard "$$SHARD" $(patsubst %,--proof "%",$(PROOF))

proofs: .linters ## when each proof of test-all last ran, and how many commits touched its files since
	@$(RUN) python -m tests.suite --list

lint: .linters ## the linters only
	@$(RUN) pytest tests/lint

unit: .linters ## the linters and the unit tests: no builder, about four minutes on two cores; COVERAGE=1 fails below 90 % of rosml/
	@$(RUN) python -m tests.suite --phase unit $(if $(COVERAGE),--coverage)

page: ## the catalogue's page in a browser; installs Chromium where there is none
	@$(BOOTSTRAP) browser
	@$(RUN) python -m tests.suite --phase page

bench: up ## our images beside those with RUN pip install, what more tags cost, and how fast the generator is: make bench TARGET=bookworm-base-torch-cu128
	@$(RUN) python -m bench --target="$$TARGET"

list: .python ## every image of the matrix, or those of groups: make list GROUP="jazzy torch"; JSON=1
	@$(RUN) -m rosml list $(if $(JSON),--json) $(GROUP)

explain: .python ## why an image exists, or why not: make explain TARGET=jazzy-robot; JSON=1
	@$(RUN) -m rosml explain $(if $(JSON),--json) -- "$$TARGET"

generate: .python ## docker-bake.hcl, schemas and the README's tables anew, after a change of matrix.yaml
	@$(RUN) scripts/generate_bake.py

plan: .python ## who builds what in CI, with time, download and disk: make plan SHARDS=8; JSON=1
	@$(RUN) scripts/generate_bake.py --shards "$(SHARDS)" $(if $(JSON),--json)

diff: .python ## which images a change builds anew, and why: make diff REV=HEAD~1; JSON=1
	@$(RUN) -m rosml diff $(if $(JSON),--json) -- "$$REV"

locks: .python ## the hash-pinned requirements in locks/ anew, after a change of matrix.yaml; UPGRADE=1 moves versions and base images, BASES=1 these alone; STACK=cpu: of one stack; JSON=1
	@$(RUN) scripts/lock.py $(if $(UPGRADE),--upgrade) $(if $(BASES),--bases) $(patsubst %,--stack=%,$(STACK)) $(if $(REPORT),--report "$$REPORT") $(if $(JSON),--json)

up: ## set up: tools, local registry, builder (the commands above do it by themselves)
	@$(BOOTSTRAP) up

emulation: up ## let this machine build and test for the other architecture too: make image TARGET=bookworm-core PLATFORM=linux/arm64
	@$(BOOTSTRAP) emulate

scanner: ## trivy, which looks for known vulnerabilities in images; building it takes 10 minutes, once
	@$(BOOTSTRAP) scanner

test-scanner: ## that trivy finds what it must in a small image, in a registry with a password: before a scan relies on it
	@$(BOOTSTRAP) scanner --tests
	@$(RUN) pytest tests/e2e/test_scanner.py

signer: ## cosign, which signs images where publish.py is called with --sign; building it takes a quarter of an hour, once
	@$(BOOTSTRAP) signer

test-signer: ## that cosign signs with a key, in a registry with a password: before tags rely on it
	@$(BOOTSTRAP) signer --tests
	@$(RUN) pytest tests/e2e/test_signer.py

client: ## set up for commands that only read or write a registry: no builder, no local registry
	@$(BOOTSTRAP) client

room: ## in CI, before up: remove what GitHub's machines bring and nobody needs here
	@$(BOOTSTRAP) room

publish: up ## all that is not as it should be, to the local registry or another one: make publish ONLY="bookworm-*" REGISTRY=ghcr.io/me/rosml SERVE=amd64; SINCE=main
	@$(RUN) scripts/publish.py all --only "$$ONLY" --registry "$$PLACE" --since "$$SINCE" --at-most "$(AT_MOST)" --serve "$$SERVE"

status: .python ## how the images stand: published, outdated, failed, missing; ONLY and REGISTRY as above
	@$(RUN) scripts/publish.py status --only "$$ONLY" --registry "$$PLACE" $(if $(JSON),--json)

catalogue: .python ## a page and catalogue.json of what is published, for any static host: make catalogue REGISTRY=ghcr.io/me/rosml OUTPUT=public; JSON=1
	@$(RUN) scripts/catalogue.py --only "$$ONLY" --registry "$$PLACE" $(if $(OUTPUT),--output "$$OUTPUT") $(if $(JSON),--json)

down: ## stop the registry and the builder; what they stored stays
	@$(BOOTSTRAP) down

clean: ## stop them and remove all that was made
	@$(BOOTSTRAP) clean

machine: ## what set-up installed, and what runs
	@$(BOOTSTRAP) status $(if $(JSON),--json)

docs: .python ## the documentation as a site in .state/docs/site, without a broken link
	@$(RUN) scripts/docs.py

.PHONY: .python
.python:
	@$(BOOTSTRAP) tools --python

.PHONY: .linters
.linters:
	@$(BOOTSTRAP) linters
