# Sourced by tests: what docs/ci says to type, what action.yml and the workflows do, and what the Containerfile runs.
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
# workflow FILE SUITE: the commands of its jobs in a container of that Debian, each with a NUL behind it.
workflow() {
    python3 - "$root/.github/workflows/$1" "debian:$2" << 'END'
import sys, yaml
for job in yaml.safe_load(open(sys.argv[1]))["jobs"].values():
    suites = job.get("strategy", {}).get("matrix", {}).get("suite", [""])
    if sys.argv[2] in [job.get("container", "").replace("${{ matrix.suite }}", suite) for suite in suites]:
        print(*(step["run"] + "\0" for step in job["steps"] if "run" in step), sep="", end="")
END
}
