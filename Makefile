# Two commands for users: `make run` (set-up, build, the paper's batch, the comparison table) and `make test`.
JOBS ?= $(shell nproc)
# What `make run` compares: the paper's observers, ours, no observer and the bound, as published and tuned.
PAPER_SET = none momentum com_wrench nonlinear_dob momentum_com oracle_full
WERROR ?= $(if $(DOB_WERROR),$(DOB_WERROR),OFF)

.PHONY: run test build setup batch-smoke order-study format clean

run: build
	build/bin/dobbench run $(addprefix --observer ,$(PAPER_SET)) --profile paper --profile tuned --seeds 3 --claims --jobs $(JOBS)

test: build
	ctest --preset release -j $(JOBS)

build: setup
	@cmake --preset release -DDOB_WERROR=$(WERROR) >build.log 2>&1 || { cat build.log; rm -f build.log; exit 1; }; rm -f build.log
	@cmake --build --preset release -j $(JOBS)

setup:
	@.ci/setup

# Ten simulated seconds in one job and in two must give the same table.
batch-smoke: build
	rm -rf build/smoke && mkdir -p build/smoke
	build/bin/dobbench run undisturbed --set duration_s=10 --jobs 1 --out build/smoke/one
	build/bin/dobbench run undisturbed --set duration_s=10 --jobs 2 --out build/smoke/two
	build/bin/dobbench table build/smoke/one --format json > build/smoke/one.json
	build/bin/dobbench table build/smoke/two --format json > build/smoke/two.json
	cmp build/smoke/one.json build/smoke/two.json

# Section 5.2 of the paper: observers of order 1 to 5 (docs/order-study.md).
order-study: build
	rm -rf build/order-study
	bench/order_study.sh build/order-study $(JOBS)

format:
	git ls-files '*.h' '*.cc' | xargs clang-format -i

clean:
	rm -rf build
