# Two commands for users: `make run` (set-up, build, the paper's batch, the comparison table) and `make test`.
JOBS ?= $(shell nproc)
# What `make run` compares: the paper's observers, ours, no observer and the bound, as published and tuned.
PAPER_SET = none momentum com_wrench nonlinear_dob momentum_com oracle_full
WERROR ?= $(if $(DOB_WERROR),$(DOB_WERROR),OFF)

.PHONY: run test build setup paper publish everything batch-smoke order-study repeatability lint coverage mutation asan tsan fuzz docs format clean

run: build
	build/bin/dobbench run $(addprefix --observer ,$(PAPER_SET)) --profile paper --profile tuned --seeds 3 --claims --jobs $(JOBS)

test: build
	ctest --preset release -j $(JOBS)

build: setup
	@cmake --preset release -DDOB_WERROR=$(WERROR) >build.log 2>&1 || { cat build.log; rm -f build.log; exit 1; }; rm -f build.log
	@cmake --build --preset release -j $(JOBS)

setup:
	@.ci/setup

# What is published: the paper's cases, every observer tuned and the paper's three in every profile, gain sets paper and
# stiff, ten seeds. About 75 minutes on two quiet cores; interrupted, it goes on where it was (docs/run-directory.md).
PAPER_OUT ?= dobbench-results/paper
paper: build
	build/bin/dobbench run --profile tuned --gains paper --gains stiff --seeds 10 --jobs $(JOBS) --resume --out $(PAPER_OUT)/tuned
	build/bin/dobbench run --observer momentum --observer com_wrench --observer nonlinear_dob --profile paper --profile matched \
	  --gains paper --gains stiff --seeds 10 --jobs $(JOBS) --resume --out $(PAPER_OUT)/profiles
	build/bin/dobbench table $(PAPER_OUT)/tuned --claims --recorded $(PAPER_OUT)/profiles
	build/bin/dobbench table $(PAPER_OUT)/profiles --claims --recorded $(PAPER_OUT)/tuned

# The tables and figures of a run directory as files: make publish RUN=dobbench-results/0001 TO=results/published/paper-set
publish: build
	mkdir -p $(TO)
	for format in md csv json; do \
	  build/bin/dobbench table $(RUN) --format $$format > $(TO)/table.$$format && \
	  build/bin/dobbench table $(RUN) --claims --format $$format > $(TO)/claims.$$format || exit $$?; done
	build/bin/dobbench figures $(RUN) --out $(TO)/figures && rm $(TO)/figures/*.gp $(TO)/figures/*.dat

# The full product of scenarios, observers, profiles, gain sets and planners: a day and more. The gain sets are DogBot's.
EVERYTHING_OUT ?= dobbench-results/everything
everything: build
	for planner in zmp spline paper_split; do \
	  build/bin/dobbench run $(filter-out quad12_%,$(notdir $(basename $(wildcard scenarios/*.toml)))) --planner $$planner --gains paper --gains swing300 \
	    --gains stiff --seeds 10 --jobs $(JOBS) --resume --out $(EVERYTHING_OUT)/$$planner || exit $$?; done

# Ten simulated seconds in one job and in two must give the same table.
batch-smoke: build
	rm -rf build/smoke && mkdir -p build/smoke
	build/bin/dobbench run undisturbed --set duration_s=10 --jobs 1 --out build/smoke/one
	build/bin/dobbench run undisturbed --set duration_s=10 --jobs 2 --out build/smoke/two
	build/bin/dobbench table build/smoke/one --format json > build/smoke/one.json
	build/bin/dobbench table build/smoke/two --format json > build/smoke/two.json
	cmp build/smoke/one.json build/smoke/two.json
	build/bin/dobbench verify build/smoke/two --sample 6 --jobs 2

# Section 5.2 of the paper: observers of order 1 to 5 (docs/order-study.md).
order-study: build
	rm -rf build/order-study
	bench/order_study.sh build/order-study $(JOBS)

# Other compilers, flags and C library functions against this build (docs/repeatability.md): half an hour and more.
repeatability: build
	.ci/setup .ci/packages-checks
	bench/repeatability.sh build/repeatability $(JOBS)

# Gates that take too long for every push; last results in docs/quality.md.
lint: setup
	.ci/setup .ci/packages-checks
	.ci/check-lint robot observers controller sim scenarios results bench test

coverage: setup
	.ci/setup .ci/packages-checks
	test/coverage.sh $(JOBS)

mutation: setup
	test/mutation/mutate.py --jobs $(JOBS)

asan: setup
	.ci/setup .ci/packages-checks
	GTEST_FILTER='*' .ci/check-sanitizers robot_test observers_test controller_test sim_test scenarios_test results_test bench_test

tsan: setup
	cmake --preset tsan -DDOB_WERROR=OFF >/dev/null
	cmake --build --preset tsan -j $(JOBS) --target robot_test results_test
	build/tsan/bin/robot_test --gtest_brief=1
	build/tsan/bin/results_test --gtest_brief=1

# Hostile input: every fuzz target for ten minutes, two at a time (docs/fuzzing.md).
FUZZ_SECONDS ?= 600
fuzz: setup
	.ci/setup .ci/packages-checks
	.ci/check-fuzz $(FUZZ_SECONDS)

# The API and the pages as HTML, build/docs/html/index.html; every warning is an error. Needs doxygen.
docs:
	.ci/setup .ci/packages-checks
	docs/doxygen/prepare build/docs/source
	cd build/docs/source && doxygen docs/Doxyfile

.PHONY: package test-deb
# Debian packages in build/packages, from a build without tests; installed, run and removed on a bare Debian 12 (as root).
package: setup
	cmake -G Ninja -S . -B build/package -DCMAKE_BUILD_TYPE=Release -DDOB_UNITY=ON -DDOB_TESTS=OFF -DDOB_WERROR=$(WERROR) >/dev/null
	cmake --build build/package -j $(JOBS)
	rm -rf build/packages
	cpack --config build/package/CPackConfig.cmake -B build/packages >/dev/null
	ls build/packages/*.deb

test-deb: package
	.ci/check-deb

.PHONY: test-slurm
# A campaign as a job array on a real Slurm of one node, which the test starts and stops itself (as root).
test-slurm: build
	test/slurm/run build/bin/dobbench

format:
	git ls-files '*.h' '*.cc' | xargs clang-format -i

clean:
	rm -rf build
