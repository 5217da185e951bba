# SPDX-License-Identifier: MIT
# Sourced by the other scripts: the packages of Debian 12 that the project is built from, and its
# build tree. Needs root or sudo only when a package is missing; asks nothing.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$project/build/release

# Packages for the command and the library.
command_packages=(
  g++ cmake ninja-build pkg-config
  libgmp-dev libmpfr-dev libboost-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libcairo2-dev zlib1g-dev
)

# Further packages for the tests and the Python package.
test_packages=(
  libcgal-dev catch2 libfast-float-dev doxygen python3 python3-meshio python3-ezdxf python3-h5py python3-numpy freefem++
  pybind11-dev python3-dev python3-pytest python3-skbuild python3-setuptools mypy
  python3-matplotlib python3-shapely python3-scipy python3-nbclient python3-ipykernel
)

# Large packages for tests alone. Without them the tests say that they are skipped.
# ASTERISM_LARGE_PACKAGES=1 installs them too. rustc with its library and LLVM unpacks to 375 MB.
large_packages=(libocct-data-exchange-dev libocct-modeling-algorithms-dev libopenmpi-dev openmpi-bin python3-dolfinx python3-dolfinx-mpc python3-petsc4py python3-mpi4py chromium chromium-driver python3-selenium python3-pil gmsh python3-vtk9 rustc
  zsh fish emscripten nodejs npm coq)
packages=("${command_packages[@]}" "${test_packages[@]}")
[ "${ASTERISM_LARGE_PACKAGES:-0}" = 0 ] || packages+=("${large_packages[@]}")

installed() { dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed; }

# install_packages PACKAGE...: installs those that are missing.
install_packages() {
  local missing=() as_root=()
  for package in "$@"; do
    installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing: ${missing[*]}"
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# configure [OPTION...]: configures the build tree, with everything that no option leaves out.
configure() {
  (cd "$project" && cmake --preset release -B "$build" "$@" >/dev/null)
}

# build_targets [TARGET...]: builds all targets when none is named.
build_targets() {
  cmake --build "$build" --parallel "$(nproc)" ${1:+--target "$@"}
}
