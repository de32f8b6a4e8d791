#!/usr/bin/env bash
# workflow_test.sh: the workflow in docs/ci is YAML of the expected shape, and its own commands, run here on a
# copy of this tree, build the verifier without the packages that only the prover needs, and verify.
set -euo pipefail
here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../../.." && pwd)
source "$here/expect.sh"
source "$here/workflow.sh"
code=0 out=

expect "no tab" lacks "$(< "$workflow")" $'\t'

expect "every step has a name, and either a command or an action" python3 - "$workflow" << 'END'
import sys, yaml
document = yaml.safe_load(open(sys.argv[1]))
assert set(document) == {"name", True, "permissions", "env", "jobs"}, document.keys()  # `on` reads as true
assert document["permissions"] == {"contents": "read"}
(job,) = document["jobs"].values()
for step in job["steps"]:
    assert step["name"] and ("run" in step) != ("uses" in step), step
names = [step["name"] for step in job["steps"]]
assert names.index("Build the verifier") < names.index("Verify") < names.index("Keep the report")
END
finish

for package in $(awk '$1 ~ /(^|,)verify(,|$)/ { print $2 }' "$root/.ci/packages.txt"); do
    expect "it installs $package" has "$(step "Install what the verifier is built with") " " $package "
    expect "the commands of docs/ci install $package" has "$(commands_by_hand) " " $package "
done

# On a copy of this tree that does not find what the verifier does without.
mkdir -- "$scratch/.dumbbell"
cp -r -- "$root"/{CMakeLists.txt,LICENSE,CITATION.cff,*.md,certificates,cmake,docs,proofs,src} "$scratch/.dumbbell"
cp -- "$root"/certificates/{q-10,stairs-1-100}.dbc "$root/docs/ci/claims.tsv" "$scratch"
for package in Boost CGAL CLI11 Eigen3 fmt nlohmann_json Catch2; do
    sed -i "1a set(CMAKE_DISABLE_FIND_PACKAGE_$package ON)" "$scratch/.dumbbell/CMakeLists.txt"
done
export CLAIMS=claims.tsv
run bash -e -c "$(step "Build the verifier")"
expect "the verifier alone is built and installed" is "$code" 0
expect "nothing else is" test ! -e "$scratch/.dumbbell/installed/bin/dumbbell"
run bash -e -c "$(step Verify)"
expect "verifies" is "$code" 0
expect "verifies all" has "$out" "c files=3 verified=3 "
expect "reports all" grep -q ' tests="3" failures="0" errors="0" ' "$scratch/proofs.xml"
sed -i 's/--exactly 4/--exactly 5/' "$scratch/claims.tsv"
run bash -e -c "$(step Verify)"
expect "a false claim ends the workflow" is "$code" 1
expect "and is in the report" grep -q ' failures="2" errors="0" ' "$scratch/proofs.xml"
finish
