/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Observation(
    @SerialName("state") val state: Map<String, List<Double>>,
    @SerialName("images") val images: Map<String, Image>,
    @SerialName("tensors") val tensors: Map<String, Tensor>,
)
