#!/usr/bin/env bash
# clone_test.sh: a clone has every byte of this tree, whatever its owner tells git about the ends of lines.
set -euo pipefail
root=$(readlink -f -- "$(dirname -- "$0")/../../..")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
export HOME=$scratch
cd -- "$root"
export GIT_DIR=$scratch/repository GIT_WORK_TREE=$root
git init -q
git add -A
git -c user.name=test -c user.email=test@example.org commit -qm "This tree"
git ls-files -z | xargs -0 sha256sum > "$scratch/sums"
unset GIT_DIR GIT_WORK_TREE

echo '* text=auto' > "$scratch/attributes"
failures=0
for setting in core.autocrlf=true core.autocrlf=input core.eol=crlf; do
    rm -rf -- "$scratch/clone"
    git clone -q -c core.attributesFile="$scratch/attributes" -c "$setting" "$scratch/repository" "$scratch/clone"
    (cd -- "$scratch/clone" && sha256sum --quiet -c "$scratch/sums") || { failures=1; echo "FAILED: $setting"; }
    bash -n "$scratch/clone/run" || { failures=1; echo "FAILED: $setting: ./run does not start"; }
done
exit "$failures"
