// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// PolicyProtocol `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images.
type PolicyProtocol string

const (
	POLICYPROTOCOL_PROCTOR PolicyProtocol = "proctor"
	POLICYPROTOCOL_OPENAI_CHAT PolicyProtocol = "openai_chat"
	POLICYPROTOCOL_OPENAI_COMPLETIONS PolicyProtocol = "openai_completions"
)

// Ptr returns a pointer to the value, as optional members hold it.
func (v PolicyProtocol) Ptr() *PolicyProtocol {
	return &v
}
