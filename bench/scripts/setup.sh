# Sourced by ./study and ./check: what both need before they build. Needs `root`, the project's root.

packages=(g++ cmake ninja-build git libbenchmark-dev libtbb-dev libxsimd-dev libopencv-dev
  libleptonica-dev libgtest-dev xz-utils valgrind
  libcli11-dev nlohmann-json3-dev python3 python3-numpy python3-scipy python3-matplotlib
  python3-jinja2 python3-pytest)

say() { printf '\n== %s\n' "$*"; }

# fail STATUS LINE: one clear line on standard error.
fail() {
  printf '%s: %s\n' "${0##*/}" "$2" >&2
  exit "$1"
}

# check_foreground VALUE, check_threshold VALUE: as the programs say it, before anything is built.
check_foreground() {
  case $1 in
    auto | bright | dark) ;;
    *) fail 2 "--foreground: expected auto, bright or dark, got '$1'" ;;
  esac
}

check_threshold() {
  case $1 in
    otsu | [0-9] | [1-9][0-9] | 1[0-9][0-9] | 2[0-4][0-9] | 25[0-5]) ;;
    *) fail 2 "--threshold: expected an integer in [0, 255] or 'otsu', got '$1'" ;;
  esac
}

# absolute PATH: as the caller meant it, wherever the script goes afterwards.
absolute() {
  case "$1" in
    /*) printf '%s' "$1" ;;
    *) printf '%s/%s' "$PWD" "$1" ;;
  esac
}

missing_packages() {
  local package
  for package in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' ||
      printf '%s\n' "$package"
  done
}

# Installs what is missing, as root or through sudo; else says which command would.
install_packages() {
  command -v dpkg-query >/dev/null || fail 1 "needs Debian's packages (dpkg-query not found); install \
by hand and use --no-install: ${packages[*]}"
  local missing
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${#missing[@]} packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    local command="sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}"
    command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; } && sudo -v ||
      fail 1 "packages are missing and this user may not install them; run: $command"
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq || fail 1 "apt-get update failed"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
    --no-install-recommends "${missing[@]}" >/dev/null || fail 1 "apt-get could not install: ${missing[*]}"
}

# build PRESET [TARGET...]: configures and builds; the log is shown only if something fails.
build() {
  local log="$root/build/$1.log"
  mkdir -p "$root/build"
  local targets=()
  [ $# -eq 1 ] || targets=(--target "${@:2}")
  (cd "$root" && cmake --preset "$1" && cmake --build --preset "$1" --parallel "${targets[@]}") >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    fail 1 "the build failed; the whole log is $log"
  }
}
