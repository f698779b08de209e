#!/usr/bin/env bash
# The examples of changes in docs/changes.
#
#     scripts/changes.sh [NAME...]           # applies each to a copy of the sources, and compiles everything there
#     scripts/changes.sh --tests [NAME...]   # runs the tests that their heads name, too
#     scripts/changes.sh --record NAME       # writes the changes of the working tree as the patch, under its head
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
all=(--workspace --features wholestring-cli/app)

if [ "${1-}" = --record ]; then
  patch=docs/changes/$2.patch
  head=$(sed '/^diff --git /,$d' "$patch")
  # New files are included. Few lines around a change, so that the patch remains valid longer.
  git add --all --intent-to-add
  changes=$(git diff --abbrev=12 -U2 HEAD -- . ':!docs/changes')
  test -n "$changes" || { echo "the working tree changes nothing that could be a patch"; exit 1; }
  printf '%s\n\n%s\n' "$head" "$changes" > "$patch"
  exit
fi

tests=
if [ "${1-}" = --tests ]; then tests=1; shift; fi
[ $# -gt 0 ] || set -- $(basename --suffix=.patch docs/changes/*.patch)

# A clone in the state of the working tree, with files that git does not know yet. Equal files keep their time, so that
# only the parts that a patch touches are compiled again. It has builds of its own, because cargo identifies crates by
# their path in the workspace.
copy=$root/target/changes/sources
export CARGO_TARGET_DIR=$root/target/changes/target
[ -d "$copy/.git" ] || git clone --quiet --shared --no-checkout . "$copy"
index=$copy/.git/index-of-the-working-tree
cp "$(git rev-parse --git-path index)" "$index"
GIT_INDEX_FILE=$index git add --all
tree=$(GIT_INDEX_FILE=$index git write-tree)

for name; do
  patch=docs/changes/$name.patch
  echo "$patch"
  cd "$copy"
  git read-tree --reset -u "$tree"
  git clean --quiet --force -d
  git apply --whitespace=nowarn "$root/$patch" || {
    echo "$patch does not apply any more: \`git apply -3 $patch\`, resolve the conflicts," \
      "\`scripts/changes.sh --record $name\`, and restore the sources"
    exit 1
  }
  cargo check --quiet --all-targets "${all[@]}"
  [ "$tests" ] || continue
  sed --quiet 's/^Tests: //p' "$root/$patch" | while read -r words; do
    # shellcheck disable=SC2086
    cargo test --quiet "${all[@]}" $words 2>&1 < /dev/null | tee "$copy/../output"
    grep --quiet 'ok\. [1-9][0-9]* passed' "$copy/../output" || { echo "$patch names tests that are not there: $words"; exit 1; }
  done
done
