# Everything a person or a machine runs in this repository. `make help` lists it.
# Needs GNU make, a network and any Python >= 3.11 (PYTHON=... names one).

.DELETE_ON_ERROR:
.PHONY: $(shell sed -n 's/^\([a-z-]*\):.*## .*/\1/p' Makefile)
unexport PYTHONPATH  # robot middleware sets it, and its plugins break our pytest

python := .venv/bin/python
environment = @PYTHON="$(PYTHON)" sh tools/setup.sh
pytest := PYTHONDONTWRITEBYTECODE= $(python) -m pytest tests --durations 25 --durations-min 3 --dist worksteal --maxprocesses 8 --numprocesses# what Python compiles is kept
waiting := $(shell expr $$(getconf _NPROCESSORS_ONLN || echo 2) \* 3 / 2)# slow tests wait half of their time

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-18s %s\n", $$1, $$2 } \
		/^# +[A-Z_0-9]+=/ { print "  " substr($$0, 2) }' $(MAKEFILE_LIST)

setup: .venv/ready ## Install everything that is needed into .venv

.venv/ready: requirements/dev.txt requirements/hashes.txt pyproject.toml tools/setup.sh
	$(environment) dev

.venv-%/ready: requirements/%.txt .venv/ready; $(environment) $*

# Tokens travel by environment, never on a command line; `value` keeps any $ in them.
export RAW_RESTART_CMD = $(value RESTART_CMD)
ifdef TOKEN
export PROCTOR_TOKEN = $(value TOKEN)
endif
ifdef TOKEN_2
export PROCTOR_TOKEN_2 = $(value TOKEN_2)
endif

conformance: setup ## Judge a server; without URL, the reference server
#                   URL=https://... TOKEN=... TOKEN_2=... RESTART_CMD='...'
#                   LEVEL=core QUICK=1 SEED=... ONLY=... ARGS='...'
#                   Fails unless conformant: "Error 1" violated, "Error 2" not judged
	@set --; \
	if [ -n "$$URL" ]; then set -- --url "$$URL"; \
	else set -- --start-cmd "$(python) -m reference_server"; fi; \
	PYTHONDONTWRITEBYTECODE= $(python) -m conformance "$$@" $${QUICK:+--quick} \
		$${RAW_RESTART_CMD:+--restart-cmd "$$RAW_RESTART_CMD"} \
		$${LEVEL:+--level "$$LEVEL"} $${SEED:+--seed "$$SEED"} $${ONLY:+--only "$$ONLY"} $(ARGS)
conformance-policy: setup; @$(python) -m conformance.policy --url "$$URL" $(ARGS) ## Judge a policy server at URL; PROCTOR_POLICY_KEY, ARGS
conformance-simulator: setup; @$(python) -m conformance.simulator $(ARGS) $(CMD) ## Judge a simulator: CMD='./my_sim', or unix:SOCKET; ARGS

# These need an older MuJoCo than ours, and so an environment of their own.
apart := $(patsubst gym_%,%,$(firstword $(foreach name,gym_aloha robosuite metaworld,\
	$(findstring $(name),$(subst gymnasium_robotics,metaworld,$(BENCHMARK))))))
serving := .venv$(if $(apart),-$(apart),$(if $(wildcard requirements/own.in),-own))
export LIBERO_PYTHON ?= $(CURDIR)/.venv-libero/bin/python
serve: $(serving)/ready $(if $(findstring libero,$(BENCHMARK)),libero) ## Run the reference server
#                   BENCHMARK=gymnasium:CartPole-v1 or as in docs/host/benchmarks.md
#                   PORT=8461; PROFILE=ebench,flageval; ARGS='...' for its options
	@echo "Starting the server; the first time takes some seconds." >&2; exec $(serving)/bin/python -m reference_server \
		$${BENCHMARK:+--benchmarks "$$BENCHMARK"} $${PROFILE:+--profiles "$$PROFILE"} $${PORT:+--port "$$PORT"} $(ARGS)
cluster: .venv-cluster/ready; @exec .venv-cluster/bin/python -m tools cluster --nodes 3 --database postgresql --simulators ray $(ARGS) ## Run PostgreSQL, Ray and three servers behind a balancer; ARGS='--nodes 5'
add: setup; @sh requirements/add.sh "$$PACKAGE" ## Add PACKAGE='gymnasium[box2d] …' to the server, apart from .venv
requirements/own.txt: requirements/own.in requirements/dev.txt; @sh requirements/add.sh
metaworld: .venv-metaworld/ready ## Install Meta-World and Gymnasium-Robotics apart; `make metaworld-check` tests them
metaworld-table: metaworld; @OPENBLAS_NUM_THREADS=1 .venv-metaworld/bin/python -m tools both-ways metaworld ## Play its experts directly and through the protocol
aloha: .venv-aloha/ready ## Install gym-aloha apart; `make aloha-check` tests it
robosuite: .venv-robosuite/ready ## Install robosuite apart; `make robosuite-check` tests it
lerobot: .venv-lerobot/ready ## Install LeRobot and torch apart (7 GB on Linux); `make lerobot-check` tests it
libero: .venv/ready .venv-libero/ready ## Install LIBERO apart; `make libero-check LIBERO_PATH=…` tests it with its assets
libero-check: libero; @$(python) -m pytest tests/sim/external/libero_checks.py
%-check: %; @.venv-$*/bin/python -m pytest tests/*/*/$*_*checks.py

tested := setup programs .venv-cluster/ready lint generate-check
check: setup lint generate-check ## Lint, check generated files, run the fast tests
	@$(pytest) auto -m "not slow and not release"
test: $(tested) ## The gate: the same with slow tests, and a sample of mutants and clients
	@$(pytest) $(waiting) -m "not release"
test-all: $(tested); @$(pytest) $(waiting) ## Everything, every mutant by all rows: before a release, nightly; hours
lint: setup ## Check style and types
	@$(python) -m ruff check --quiet . && $(python) -m ruff format --check --quiet .
	@$(python) -m mypy
generate: .venv-generate/ready; @.venv-generate/bin/python -m tools generate ## Rewrite models and clients from spec/
generate-check: .venv-generate/ready; @.venv-generate/bin/python -m tools generate --check ## Fail if generated files differ from spec/
programs: .venv/proxies/ready ## Provide nginx, HAProxy, Chromium and bubblewrap for the tests
.venv/proxies/ready: .venv/ready tools/browser.sh tools/sandbox.sh tools/debian_packages.sh tools/proxies.sh; @sh tools/browser.sh && sh tools/sandbox.sh && sh tools/proxies.sh
client: .venv-generate/ready ## Write a client in LANGUAGE=go or any other into build/clients/, or TO=... a new folder
	@.venv-generate/bin/python -m tools generate --client "$(LANGUAGE)" $${TO:+--to "$$TO"}
docs: setup; @$(python) -m tools traceability && $(python) -m tools diagrams ## Rewrite the pictures in docs/, build the table of all rules
site: .venv-generate/ready; @$(python) -m tools site ## Build the site of the standard into build/site/html, in minutes
interop: setup .venv-generate/ready ## Play every scenario through each language's client
#                   URL=... TOKEN=... RESTART_CMD='...' LANGUAGES=go,rust ONLY=echo
	@$(python) -m tools interop

lock: setup ## Resolve requirements/*.in into locks with hashes; ARGS=--upgrade
	@$(python) -m tools lock $(ARGS)
dist: setup .venv-generate/ready; @$(python) -m tools dist --clients ## Build the wheels with locks and bills of materials, and archives of clients, into dist/

kill-matrix: setup; @$(python) -m tests.mutants.kill --write ## Judge the kit on broken servers
false-alarms: setup; @$(python) -m tools false-alarms $(ARGS) ## Run the kit on right servers again and again; ARGS='--runs 200 --load busy -j 2'
mutation: setup ## Judge the kit on machine-made changes of a server
#                   SERVER=js or go; SAMPLE=150 (all without it) SEED=1 JOBS=2
#                   WRITTEN=1 (bugs that people wrote) ARGS='--again survived'
	@$(python) -m tests.mutation "$${SERVER:-js}" $${WRITTEN:+--written} --sample "$${SAMPLE:-0}" \
		--seed "$${SEED:-1}" --jobs "$${JOBS:-2}" $(ARGS)
attack: setup; @$(python) -m tests.campaigns $@ $${LONG:+--long} --only "$$ONLY" --seed "$${SEED:-1}" $(ARGS) ## Attack the reference server while others use it, judge it
#                   LONG=1 (hours) ONLY='fuzz,full disk' SEED=1
chaos: setup; @$(python) -m tests.campaigns $@ $${LONG:+--long} --only "$$ONLY" --seed "$${SEED:-1}" $(ARGS) ## Break a cluster while it is used, judge it; as attack, and ARGS='--simulators ray'
soak: setup; @$(python) -m tests.campaigns $@ $${LONG:+--long} --only "$$ONLY" --seed "$${SEED:-1}" $(ARGS) ## Break a host while policies are handed in, judge it; as attack
experts: setup; @$(python) -m tools experts --write $(ARGS) ## Measure the scripted experts, rewrite their page
bench: setup .venv-bench/ready ## Measure beside the alternatives; ARGS='round_trips --try'
	@$(python) -m benchmarks $(ARGS)

clean: ## Remove environments, caches, reports; not data in var/
	rm -rf .venv .venv-* .cache .hypothesis .*_cache .coverage* build dist report *.egg-info
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
