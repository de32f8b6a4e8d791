# Sourced by chroot_trial: a Debian, $suite, that has nothing but what every Debian has, and commands run in it.

skip() { # skip WHY: loudly, and not as if it had passed
    printf '\nSKIPPED, nothing was tried: %s\n\n' "$*" >&2
    exit 3
}

# What apt of this machine says about the places that it takes Debian from.
targets() { apt-get indextargets --format "$1" 'Created-By: Packages' 'Origin: Debian' 'Component: main' | sort -u; }

# make_base FOLDER: a minimal system that takes its packages from where this machine does.
make_base() {
    local mirror own
    (($(id -u) == 0)) || skip "a chroot needs root"
    command -v debootstrap > /dev/null || skip "there is no debootstrap: .ci/install trust"
    own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
    mirror=$(targets '$(CODENAME) $(SITE)' | sed -n "s/^$own //p" | head -n 1)
    [[ -n $mirror ]] || skip "apt knows no mirror of Debian: apt-get update, on Debian"
    debootstrap --variant=minbase "$suite" "$1" "$mirror" > "$1.log" 2>&1 ||
        skip "debootstrap failed (in a container it needs the right to make devices and mounts): $(tail -n 1 "$1.log")"
    targets 'deb $(SITE) $(RELEASE) main' | sed "s/ $own/ $suite/" > "$1/etc/apt/sources.list"
    apt-config dump | grep -E '^Acquire::(http|https)::Proxy ' > "$1/etc/apt/apt.conf.d/01proxy" || true
    cp -L -- /etc/resolv.conf /etc/hosts "$1/etc/"
    # Whom this machine trusts beyond Debian, such as its proxy: taken over when ca-certificates is installed.
    mkdir -p -- "$1/usr/local/share/ca-certificates"
    cp -r -- /usr/local/share/ca-certificates "$1/usr/local/share/"
}

# inside FOLDER USER COMMAND...: in the chroot, in the user's home, with no environment of this machine. What is mounted
# for it goes with it, and so does what it leaves running. The first process there stays root's: --kill-child forgets others.
inside() {
    local folder=$1 user=$2 home=/root
    shift 2
    [[ $user == root ]] || home=/home/$user
    unshare --mount --pid --fork --kill-child sh -c 'mount --rbind /dev "$0/dev" && mount --rbind /sys "$0/sys" &&
        mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' "$folder" \
        /usr/bin/env -i HOME="$home" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        sh -c 'cd && setpriv --reuid="$0" --regid="$0" --init-groups "$@"; exit $?' "$user" "$@" < /dev/null
}
