/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class ObservationSpace(
    @SerialName("state") val state: Map<String, VectorSpace>,
    @SerialName("images") val images: Map<String, ImageSpace>,
    @SerialName("tensors") val tensors: Map<String, TensorSpace>,
)
