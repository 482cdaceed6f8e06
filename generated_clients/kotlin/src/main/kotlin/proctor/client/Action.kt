/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Action(
    /** Name → vector, exactly the entries of the benchmark's action space. */
    @SerialName("values") val values: Map<String, List<Double>>,
)
