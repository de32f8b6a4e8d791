#!/usr/bin/env bash
# workflow_test.sh: action.yml is YAML of the expected shape, and its own commands and the Containerfile's, run here on a
# copy of this tree, build the verifier without the packages that only the prover needs, and verify.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
root=$(readlink -f -- "$here/../../..")
source "$here/expect.sh"
source "$here/workflow.sh"
code=0 out=

expect "every step has a name, and either a command with its shell or an action" python3 - "$root/action.yml" << 'END'
import sys, yaml
document = yaml.safe_load(open(sys.argv[1]))
assert set(document) == {"name", "description", "inputs", "runs"} and document["runs"]["using"] == "composite"
for step in document["runs"]["steps"]:
    assert step["name"] and ("run" in step) != ("uses" in step) and ("run" in step) == ("shell" in step), step
    assert "github.workspace" not in str(step), "a container has another name for that folder"
    assert all(".ci/install" in line for line in step.get("run", "").splitlines() if "sudo" in line), "it would leave files of root's"
END
for package in $("$root/.ci/install" --names verify); do
    expect "the commands of docs/ci install $package" has "$(commands_by_hand) " " $package "
done

# On a copy of this tree that does not find what the verifier does without.
copy=$scratch/dumbbell
mkdir -- "$copy"
cp -r -- "$root"/{.ci,run,CMakeLists.txt,CMakePresets.json,LICENSE,CITATION.*,*.md,certificates,cmake,docs,proofs,src} "$copy"
cp -- "$root"/certificates/{q-10,stairs-1-100}.dbc "$root/docs/ci/claims.tsv" "$scratch"
for package in Boost CGAL CLI11 Eigen3 fmt nlohmann_json Catch2; do
    sed -i "1a set(CMAKE_DISABLE_FIND_PACKAGE_$package ON)" "$copy/CMakeLists.txt"
done
export GITHUB_ACTION_PATH=$copy GITHUB_OUTPUT=$scratch/output RUNNER_TEMP=$scratch/temporary CLAIMS=claims.tsv
run bash -e -c "$(step "Name the verifier by the digest of its source")"
expect "the verifier has a name" grep -qE '^name=dumbbell-verify-[^-]+-[0-9a-f]{64}$' "$scratch/output"
for part in .ci/packages.txt CMakeLists.txt CMakePresets.json cmake/options.cmake run src/verify/program/main.cpp; do
    echo >> "$copy/$part"
    run bash -e -c "$(step "Name the verifier by the digest of its source")"
    expect "another one, if $part changes" is "$(grep -c ^name= "$scratch/output")" "$(grep ^name= "$scratch/output" | sort -u | wc -l)"
done
run bash -e -c "$(step "Build it")"
expect "the verifier is built" is "$code" 0
expect "and nothing else" is "$(ls "$copy/build/static/bin")" dumbbell-verify
run bash -e -c "$(step Verify)"
expect "verifies" is "$code" 0
expect "leaves nothing in the workspace" is "$(ls -A -- "$scratch" | xargs)" "claims.tsv dumbbell output q-10.dbc stairs-1-100.dbc temporary"
expect "verifies all" has "$out" "c files=3 verified=3 "
run env -i "$RUNNER_TEMP/dumbbell/dumbbell-verify" --ratio 10 --exactly 4 q-10.dbc
expect "it needs no environment" is "$code" 0
run ldd "$RUNNER_TEMP/dumbbell/dumbbell-verify"
expect "and no library" has "$out" "not a dynamic executable"
sed -i 's/--exactly 4/--exactly 5/' "$scratch/claims.tsv"
run bash -e -c "$(step Verify)"
expect "a false claim ends the workflow" is "$code" 1
expect "and is told" has "$out" " rejected=2 "

run bash -e -c "$(container_command | sed "s| /dumbbell| $copy|g; s|^/dumbbell|$copy|")"
expect "the Containerfile's command makes the verifier" is "$code" 0
run "$copy-verify" --ratio 1:100 --max 10 stairs-1-100.dbc
expect "which verifies" is "$code" 0
finish
