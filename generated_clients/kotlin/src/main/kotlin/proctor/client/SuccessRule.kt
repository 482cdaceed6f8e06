/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
enum class SuccessRule {
    @SerialName("any_step") ANY_STEP,
    @SerialName("last_step") LAST_STEP,
}
