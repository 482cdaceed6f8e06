// Code generated from spec/openapi.yaml by `make generate`; DO NOT EDIT.

package proctor

// ImageSpace is a message of the protocol.
type ImageSpace struct {
	Channels int32 `json:"channels"`
	Description string `json:"description"`
	Tasks []string `json:"tasks,omitzero"`
}

// GetTasks returns tasks, or the zero value when it is absent.
func (o *ImageSpace) GetTasks() (v []string) {
	if o != nil && o.Tasks != nil {
		v = o.Tasks
	}
	return v
}

// SetTasks sets tasks.
func (o *ImageSpace) SetTasks(v []string) {
	o.Tasks = v
}
