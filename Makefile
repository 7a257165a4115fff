# The main commands. Each command first installs missing packages (tools/packages.txt), which takes
# no time if none is missing.
#
#   make demo       build the program, run it on a helical pair, print where the files are
#   make test       configure, build and test: cmake --workflow --preset check
#   make npm        the npm package with the program and the engine in WebAssembly, build/web/*.tgz
#   make test-wasm  the unit tests of the core in WebAssembly; every example, compared with the program
#   make test-long  the tests whose names start with Long
#   make test-cluster  searches under a Slurm of two nodes, which the test starts; skipped if the
#                      daemons of Slurm cannot run
#   make web        the page for browsers: build/web for a server, and the single file build/web/gearwright.html
#   make test-web   the page in a headless browser, compared with the native program
#   make bench      benchmarks
#   make lint       formatting (must be clean) and clang-tidy (advice)
#   make docs       the API reference and all pages as HTML, build/docs/html
#   make figures    draw the figures of the theory pages again
#   make python     the Python package as a wheel, build/python/*.whl
#   make package    the Debian packages alone, build/package/*.deb
#   make dist       programs for Windows (with an installer) and Linux that need no package, Debian packages, the wheel,
#                   the npm package and the page: build/dist
#   make test-dist  these programs under Wine and QEMU, compared with the native one
#   make test-portable  the program for Windows under Wine with ten examples, compared with the native one; not run if
#                   Wine does not start on this machine
#   make clean      remove build/

.PHONY: demo test web test-web npm test-wasm test-long test-cluster bench lint docs figures python package dist test-dist test-dist-arm test-dist-others test-portable clean
JOBS ?= $(shell nproc)
export CMAKE_BUILD_PARALLEL_LEVEL ?= $(JOBS)
DEMO = examples/helical_pair.toml
DEMO_OUT = build/demo/helical_pair_out

demo:
	@tools/install_packages.sh core
	@cmake --preset release
	@cmake --build --preset release --target gearwright_cli
	build/release/gearwright run $(DEMO) --out $(DEMO_OUT)
	@echo
	@echo "Report     $(CURDIR)/$(DEMO_OUT)/report.html"
	@echo "CAD files"
	@cd $(DEMO_OUT) && ls -1 *.step *.stl *.3mf *.dxf *.svg *.glb | sed 's#^#  $(CURDIR)/$(DEMO_OUT)/#'

test:
	@tools/install_packages.sh core mpi python test docs
	@tools/install_npm_tools.sh
	@cmake --workflow --preset check

npm:
	@tools/install_packages.sh core wasm
	@cmake --preset wasm -DGEARWRIGHT_TESTS=OFF > /dev/null
	@cmake --build --preset wasm --target web_npm
	@cd build/web && npm pack --silent ./npm

test-wasm:
	@tools/install_packages.sh core test wasm
	@cmake --preset release -DGEARWRIGHT_BENCH=OFF > /dev/null
	@cmake --build --preset release --target gearwright_cli
	@cmake --preset wasm -DGEARWRIGHT_TESTS=ON > /dev/null
	@cmake --build --preset wasm
	@ctest --preset wasm

test-long:
	@tools/install_packages.sh core mpi python test cluster long
	@tools/install_npm_tools.sh
	@cmake --preset release
	@cmake --build --preset release
	@ctest --preset long

test-cluster:
	@tools/install_packages.sh core mpi python test cluster
	@cmake --preset release
	@cmake --build --preset release --target gearwright_cli --target gearwright_mpi
	@ctest --preset cluster

web:
	@tools/install_packages.sh core wasm web
	@tools/build_web.sh $(JOBS)

test-web: web
	@cmake --preset release > /dev/null
	@cmake --build --preset release --target gearwright_cli
	node --experimental-websocket --test --test-concurrency=1 apps/web/test/*_test.mjs

bench:
	@tools/install_packages.sh core mpi python test
	@cmake --preset release
	@cmake --build --preset release --target bench
	build/release/bench/bench
	@cmake --build --preset release --target python_module
	python3 bench/python_overhead.py build/release

lint:
	@tools/install_packages.sh core mpi python test lint
	@cmake --preset release -B build/lint -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null
	@tools/lint.sh

docs:
	@tools/install_packages.sh docs
	@tools/make_docs.sh

figures:
	@tools/install_packages.sh core mpi python test
	@cmake --preset release > /dev/null
	@cmake --build --preset release --target docs_figures
	build/release/docs/figures/docs_figures docs/theory/images

python:
	@tools/install_packages.sh core python
	@cmake --preset release -DGEARWRIGHT_PYTHON=ON
	@cmake --build --preset release --target python_wheel
	@mkdir -p build/python && rm -f build/python/*.whl && cp build/release/python/*.whl build/python
	@echo && echo "Wheel  $$(ls $(CURDIR)/build/python/*.whl)"

package:
	@tools/install_packages.sh core mpi python package
	@tools/deb.sh build/package

dist:
	@tools/install_packages.sh core mpi python wasm web package portable dist
	@tools/dist.sh

# The packages are made again only if a file of the sources is newer than they are.
build/dist/SHA256SUMS: $(wildcard $(shell git ls-files 2>/dev/null))
	@$(MAKE) dist

# Two parts run at once: the programs for ARM need QEMU and take as long as all others.
test-dist: build/dist/SHA256SUMS
	@cmake --preset release > /dev/null
	@cmake --build --preset release --target gearwright_cli
	cd build/dist && sha256sum --quiet -c SHA256SUMS
	@$(MAKE) --no-print-directory -j2 test-dist-arm test-dist-others

test-dist-arm:
	tests/dist/test_rpm.sh build/release/gearwright build/dist/gearwright-*.aarch64.rpm qemu-aarch64-static
	tests/dist/test_portable.py build/release/gearwright build/portable/linux-aarch64/gearwright --under qemu-aarch64-static

test-dist-others:
	tests/dist/test_portable.py build/release/gearwright build/portable/windows-x86_64/gearwright.exe --under wine \
	  --zip build/dist/gearwright-*-windows-x86_64.zip
	tests/dist/test_installer.py build/dist/gearwright-*-windows-x86_64-setup.exe
	tests/dist/test_portable.py build/release/gearwright build/portable/linux-x86_64/gearwright
	tests/dist/test_rpm.sh build/release/gearwright build/dist/gearwright-*.x86_64.rpm
	tests/dist/test_deb.sh build/release/gearwright build/dist
	tests/dist/test_npm.sh build/release/gearwright build/dist/gearwright-[0-9]*.tgz
	tests/dist/test_compilers.py build/release/gearwright --only unoptimised

test-portable:
	@tools/install_packages.sh core portable
	@cmake --preset release > /dev/null
	@cmake --build --preset release --target gearwright_cli
	@tools/portable_program.sh windows-x86_64; status=$$?; \
	if [ $$status = 75 ]; then \
	  echo "test-portable: skipped, because the sources of the libraries cannot be fetched"; \
	elif [ $$status != 0 ]; then \
	  exit $$status; \
	else \
	  tests/dist/test_portable.py build/release/gearwright build/portable/windows-x86_64/gearwright.exe \
	    --under wine --may-skip --examples 10; \
	fi

clean:
	rm -rf build
