# Sourced by tests: what docs/ci says to type, what action.yml does, and what the Containerfile runs.
commands_by_hand() { sed -nE '/^    apt-get install/,/^$/s/^    (.*)/\1 /p' "$root/docs/ci/README.md"; }
container_command() { sed -n 's/^RUN //p' "$root/Containerfile"; }
# The command of the step that is called so.
step() {
    python3 - "$root/action.yml" "$1" << 'END'
import sys, yaml
steps = yaml.safe_load(open(sys.argv[1]))["runs"]["steps"]
(command,) = [step["run"] for step in steps if step["name"] == sys.argv[2]]
print(command)
END
}
