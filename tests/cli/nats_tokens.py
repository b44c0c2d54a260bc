"""Makes keys and signed tokens like NATS's own tools, which Debian does not package. Keys are
Ed25519 in base 32 with a letter for the kind of owner and a checksum; tokens are JWT."""

import base64
import binascii
import json
import subprocess

SEED = "S"
UNLIMITED = {name: -1 for name in ("subs", "data", "payload", "imports", "exports", "conn", "leaf")}
STORING = {name: -1 for name in ("mem_storage", "disk_storage", "streams", "consumer")}


def in_base_32(raw):
    checksum = binascii.crc_hqx(raw, 0).to_bytes(2, "little")
    return base64.b32encode(raw + checksum).decode().rstrip("=")


def in_base_64(raw):
    return base64.urlsafe_b64encode(raw).decode().rstrip("=")


def openssl(*arguments):
    return subprocess.run(["openssl", *arguments], check=True, capture_output=True).stdout


def prefix(letter):
    return (ord(letter) - ord("A")) << 3


class Key:
    """The key of an operator (O), an account (A) or a user (U)."""

    def __init__(self, letter, file):
        self.file = str(file)
        openssl("genpkey", "-algorithm", "ed25519", "-out", self.file)
        public = openssl("pkey", "-in", self.file, "-pubout", "-outform", "DER")[-32:]
        secret = openssl("pkey", "-in", self.file, "-outform", "DER")[-32:]
        whose = prefix(letter)
        self.name = in_base_32(bytes([whose]) + public)
        self.seed = in_base_32(
            bytes([prefix(SEED) | whose >> 5, (whose & 31) << 3]) + secret)

    def signature(self, data):
        with open(self.file + ".data", "wb") as file:
            file.write(data)
        return openssl("pkeyutl", "-sign", "-rawin", "-inkey", self.file, "-in", file.name)

    def token(self, subject, kind, **facts):
        """Returns a token about the subject, signed with this key."""
        head = {"typ": "JWT", "alg": "ed25519-nkey"}
        claims = {"jti": "test", "iat": 1_600_000_000, "iss": self.name, "name": kind,
                  "sub": subject.name, "nats": {"type": kind, "version": 2, **facts}}
        text = ".".join(in_base_64(json.dumps(part).encode()) for part in (head, claims))
        return text + "." + in_base_64(self.signature(text.encode()))


def user_credentials(account, user, seed=None):
    """Returns the text of a *.creds file; the seed is the user's unless another is given."""
    token = account.token(user, "user", subs=-1, data=-1, payload=-1)
    return (f"-----BEGIN NATS USER JWT-----\n{token}\n------END NATS USER JWT------\n\n"
            f"-----BEGIN USER NKEY SEED-----\n{seed or user.seed}\n"
            "------END USER NKEY SEED------\n")


def configuration(operator, system, account):
    """Returns the configuration of a server that admits users whose tokens the account signed."""
    limits = {**UNLIMITED, "wildcards": True}
    accounts = {system.name: operator.token(system, "account", limits=limits),
                account.name: operator.token(account, "account", limits={**limits, **STORING})}
    preloaded = ", ".join(f'{name}: "{token}"' for name, token in accounts.items())
    return (f'operator: "{operator.token(operator, "operator")}"\n'
            f"system_account: {system.name}\nresolver: MEMORY\n"
            f"resolver_preload: {{ {preloaded} }}\n")
