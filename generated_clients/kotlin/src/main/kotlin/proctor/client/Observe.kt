/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** `last` when absent; `all` adds the observation after every executed action. */
@Serializable
enum class Observe {
    @SerialName("last") LAST,
    @SerialName("all") ALL,
}
