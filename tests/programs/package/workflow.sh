# Sourced by tests: what docs/ci says to type, or to copy into a workflow.
workflow=$root/docs/ci/verify-proofs.yml

# The command of the step that is called so.
step() {
    python3 - "$workflow" "$1" << 'END'
import sys, yaml
document = yaml.safe_load(open(sys.argv[1]))
(job,) = document["jobs"].values()
(command,) = [s["run"] for s in job["steps"] if s.get("name") == sys.argv[2]]
print(command)
END
}
commands_by_hand() { sed -nE '/^    apt-get install/,/^$/s/^    (.*)/\1 /p' "$root/docs/ci/README.md"; }
