/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

/** Each call waits for its answer, and throws [ProctorException]. Any number of threads may call. */
class DataApi(private val connection: Connection) {
    /** Open a session for a worker and get its turn 0 */
    fun attachWorker(runId: String, workerId: String, attachWorker: AttachWorker, proctorVersion: String? = null): Turn {
        val request = Request("PUT", "/v1/runs/{run_id}/workers/{worker_id}")
        request.path("run_id", runId)
        request.path("worker_id", workerId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(attachWorker)
        return connection.receive(request)
    }

    /** Close a session and free its slot at once */
    fun detachWorker(runId: String, workerId: String, sessionId: String, proctorVersion: String? = null) {
        val request = Request("DELETE", "/v1/runs/{run_id}/workers/{worker_id}")
        request.path("run_id", runId)
        request.path("worker_id", workerId)
        request.query("session_id", sessionId)
        request.header("Proctor-Version", proctorVersion)
        connection.send(request)
    }

    /** Extend the lease while the policy thinks */
    fun heartbeat(runId: String, workerId: String, heartbeat: Heartbeat, proctorVersion: String? = null): Lease {
        val request = Request("POST", "/v1/runs/{run_id}/workers/{worker_id}/heartbeat")
        request.path("run_id", runId)
        request.path("worker_id", workerId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(heartbeat)
        return connection.receive(request)
    }

    /** A chunk of actions in, the next observation out */
    fun predict(runId: String, workerId: String, predict: Predict, proctorVersion: String? = null): Turn {
        val request = Request("POST", "/v1/runs/{run_id}/workers/{worker_id}/predict")
        request.path("run_id", runId)
        request.path("worker_id", workerId)
        request.header("Proctor-Version", proctorVersion)
        request.body = json.encodeToString(predict)
        return connection.receive(request)
    }
}
