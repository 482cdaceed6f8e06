// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// TensorSpace is a message of the protocol.
type TensorSpace struct {
	Dtype string `json:"dtype" validate:"regexp=^[a-z][a-z0-9_]{0\\,63}$"`
	Shape []int32 `json:"shape"`
	Description string `json:"description"`
	Tasks []string `json:"tasks,omitzero"`
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *TensorSpace) GetTasks() (v []string) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *TensorSpace) SetTasks(v []string) {
	o.Tasks = v
}
