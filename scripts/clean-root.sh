#!/usr/bin/env bash
# Program and wheel in a minimal Debian root without Rust: checks that the documented system packages suffice.
#
#     scripts/clean-root.sh [SUITE...]    # stable and oldstable by default
#
# It takes minutes and requires debootstrap and root rights.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${CARGO_TARGET_DIR:-target}/clean-root
command -v debootstrap > /dev/null || { echo "there is no debootstrap here: install Debian's package"; exit 1; }

cargo build --release --workspace --features wholestring-cli/app --bin wholestring
rm -rf "$folder/wheel"
python3 -m pip wheel --quiet --no-deps --wheel-dir "$folder/wheel" crates/python
# The first Python example of the README.
QUICK_START=$(sed -n '/^```python$/,/^```$/p' README.md | sed '1d; /^```$/,$d')
test -n "$QUICK_START"
export QUICK_START

[ $# -gt 0 ] || set -- stable oldstable
for suite; do
  root=$folder/$suite
  if [ ! -f "$root/etc/debian_version" ]; then
    debootstrap --variant=minbase --include=python3,python3-venv,ca-certificates "$suite" "$root"
  fi
  # Name servers and trusted certificates, to download packages inside.
  for file in etc/resolv.conf etc/ssl/certs/ca-certificates.crt; do
    if [ -f "/$file" ]; then cp "/$file" "$root/$file"; fi
  done
  rm -rf "$root/desk"
  mkdir "$root/desk"
  cp -r "${CARGO_TARGET_DIR:-target}/release/wholestring" cases "$folder"/wheel/*.whl "$root/desk"
  # shellcheck disable=SC2016
  chroot "$root" /bin/sh -c '
    set -e; cd /desk
    if command -v rustc cargo; then echo "there is Rust here"; exit 1; fi
    ./wholestring run cases/np13-x1042.toml
    python3 -m venv fresh
    fresh/bin/pip install --quiet ./*.whl
    fresh/bin/python -c "$QUICK_START"'
  echo "$suite: program and wheel run"
done
