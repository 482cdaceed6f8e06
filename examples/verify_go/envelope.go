package main

import (
	"crypto/ed25519"
	"crypto/sha256"
	"encoding/base64"
	"encoding/hex"
	"fmt"
	"hash"
	"regexp"
)

const payloadType = "application/vnd.in-toto+json"

var envelopeForm = regexp.MustCompile(`^\{"payload":"([A-Za-z0-9+/]+={0,2})",` +
	`"payloadType":"application/vnd\.in-toto\+json",` +
	`"signatures":\[\{"keyid":"(SHA256:[0-9a-f]{64})","sig":"([A-Za-z0-9+/]{86}==)"\}\]\}$`)

func newSHA256() hash.Hash       { return sha256.New() }
func hexOf(sum hash.Hash) string { return hex.EncodeToString(sum.Sum(nil)) }

func hexDigest(data []byte) string {
	sum := sha256.Sum256(data)
	return hex.EncodeToString(sum[:])
}

// openEnvelope gives the payload of a signed file, and the keyid (REC-005, REC-006).
// signer is the member of the predicate that has the key.
func openEnvelope(file string, data []byte, signer string) (*object, string) {
	form := envelopeForm.FindSubmatch(data)
	if form == nil {
		refuse(file, "REC-005", "it is no envelope in the form that a record has")
	}
	payload, keyid, signature := decode(file, form[1]), string(form[2]), decode(file, form[3])
	key := keyIn(file, payload, signer)
	if "SHA256:"+hexDigest(key) != keyid {
		refuse(file, "REC-006", "its keyid is not that of the public key in it")
	}
	signed := fmt.Appendf(nil, "DSSEv1 %d %s %d %s", len(payloadType), payloadType, len(payload), payload)
	if !ed25519.Verify(key, signed, signature) {
		refuse(file, "REC-006", "its signature does not fit")
	}
	statement := readObject(file, payload)
	if statement.object("predicate").object(signer).text("keyid") != keyid {
		refuse(file, "REC-006", "it names another keyid than it has")
	}
	return statement, keyid
}

func decode(file string, text []byte) []byte {
	data, err := base64.StdEncoding.Strict().DecodeString(string(text))
	if err != nil {
		refuse(file, "REC-005", "its base64 is invalid")
	}
	return data
}

// keyIn reads the key before the payload is trusted: whatever is wrong is the signature.
func keyIn(file string, payload []byte, signer string) (key ed25519.PublicKey) {
	defer func() {
		if recover() != nil {
			refuse(file, "REC-006", "no public key can be read from it")
		}
	}()
	text := readObject(file, payload).object("predicate").object(signer).text("public_key")
	key, err := base64.StdEncoding.Strict().DecodeString(text)
	if err != nil || len(key) != ed25519.PublicKeySize {
		refuse(file, "REC-006", "it holds no Ed25519 public key")
	}
	return key
}
