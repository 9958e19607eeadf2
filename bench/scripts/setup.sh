# Sourced by ./study and ./check: what they need before they build. Needs `root`, the project's root.

packages=(g++ cmake ninja-build git libbenchmark-dev libgtest-dev libtbb-dev libxsimd-dev libopencv-dev
  libleptonica-dev libjpeg-dev libpng-dev libtiff-dev libyaml-cpp-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libjs-chart.js valgrind parallel python3 python3-numpy python3-pandas python3-scipy python3-matplotlib python3-jinja2
  python3-jsonschema python3-junitparser)
# Machine code is written for x86-64 alone.
[ "$(uname -m)" != x86_64 ] || packages+=(libxbyak-dev)
many_images_packages=(python3-opencv python3-skimage python3-dask python3-distributed)
# Of the tests alone.
test_packages=(clang-format chromium chromium-driver dpkg-dev file pkg-config mypy python3-pytest python3-selenium
  python3-build python3-pip python3-setuptools python3-venv python3-wheel python3-hypothesis
  python3-pil python3-tifffile python3-zarr imagemagick "${many_images_packages[@]}")

say() { printf '\n== %s\n' "$*"; }

# fail STATUS LINE: one clear line on standard error.
fail() {
  printf '%s: %s\n' "${0##*/}" "$2" >&2
  exit "$1"
}

# missing_packages ARCHITECTURE: this machine's.
missing_packages() {
  local package architectures="all|$1"
  for package in "${packages[@]}"; do
    case "$package" in *:*) architectures=${package#*:} ;; esac
    dpkg-query -W -f '${Status} ${Architecture}\n' "$package" 2>/dev/null |
      grep -Eqx "install ok installed ($architectures)" || printf '%s\n' "$package"
  done
}

# Installs what is missing, as root or through sudo; else says which command would.
install_packages() {
  command -v dpkg-query >/dev/null || fail 1 "needs Debian's packages (dpkg-query not found); install \
by hand and use --no-install: ${packages[*]}"
  local missing package architecture
  architecture=$(dpkg --print-architecture) || fail 1 "dpkg does not work"
  mapfile -t missing < <(missing_packages "$architecture")
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${#missing[@]} packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    local command="sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}"
    command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; } && sudo -v ||
      fail 1 "packages are missing and this user may not install them; run: $command"
    as_root=(sudo)
  fi
  for package in "${missing[@]}"; do
    case "$package" in *:*) "${as_root[@]}" dpkg --add-architecture "${package#*:}" ;; esac
  done
  "${as_root[@]}" apt-get update -qq || fail 1 "apt-get update failed"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
    --no-install-recommends "${missing[@]}" >/dev/null || fail 1 "apt-get could not install: ${missing[*]}"
}
