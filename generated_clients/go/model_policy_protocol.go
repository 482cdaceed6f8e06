// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyProtocol `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words.
type PolicyProtocol string

const (
	POLICYPROTOCOL_PROCTOR PolicyProtocol = "proctor"
	POLICYPROTOCOL_OPENAI_CHAT PolicyProtocol = "openai_chat"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v PolicyProtocol) Ptr() *PolicyProtocol {
	return &v
}
