# Sourced by tests of programs: a scratch folder, commands that are run in it, and what is expected of them.
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

# run COMMAND...: in the scratch folder; leaves $code and $out (stdout and stderr).
run() {
    code=0
    out=$(cd -- "$scratch" && "$@" 2>&1 < /dev/null) || code=$?
}
expect() { # expect WHAT CONDITION...: the condition is a command
    local what=$1
    shift
    if "$@"; then
        echo "ok: $what"
    else
        failures=$((failures + 1))
        printf 'FAILED: %s\n  exit code: %s\n  output: %s\n%s\n' "$what" "$code" "$out" "${err-}"
    fi
}
has() { [[ $1 == *"$2"* ]]; }
lacks() { [[ $1 != *"$2"* ]]; }
is() { [[ $1 == "$2" ]]; }
finish() { ((failures == 0)) || { echo "$failures failed"; exit 1; }; }
