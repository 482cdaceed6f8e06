import java.util.UUID
import proctor.client.*

private const val RETRY_TIMEOUT_MS = 60_000

/**
 * A worker loop on the generated client: the least that a policy needs to be evaluated.
 *
 * The same loop stands in the example of every language; see docs/implement/clients.md.
 */
class Worker(url: String, private val token: String) {
    val control = ControlApi(Connection(url, token))

    fun data(run: Run) = DataApi(Connection(run.endpoint, token))

    /** Play until no episode is left; a lost session is replaced by a new one. */
    fun play(runId: String, workerId: String, policy: (Turn) -> List<Action>, report: (EpisodeResult) -> Unit) {
        while (true) {
            val data = data(untilOpen(runId))
            val key = AttachWorker(attachKey = UUID.randomUUID().toString())
            try {
                var turn = ask { data.attachWorker(runId, workerId, key) }
                while (!turn.done) {
                    val chunk = Predict(sessionId = turn.sessionId, seq = turn.seq + 1, actions = policy(turn))
                    turn = ask { data.predict(runId, workerId, chunk) }
                    turn.episodeResult?.let(report)
                }
                return
            } catch (error: Refused) {
                val why = error.problem
                if (why.code == "illegal_transition" && why.state == RunState.COMPLETED) return // others played the rest
                if (why.code != "session_ended" || why.endedBy in listOf("run_stopped", "run_failed")) throw error
                System.err.println("warning: $workerId lost its session, and the attempt of an episode that had begun: ${error.message}")
            }
        }
    }

    /** The run, as soon as workers may attach. */
    private fun untilOpen(runId: String): Run {
        while (true) {
            val run = ask { control.getRun(runId) }
            if (run.state != RunState.QUEUED) return run
            Thread.sleep(100)
        }
    }
}

/** Send a request until it is answered: a repeat executes nothing twice. */
fun <T> ask(request: () -> T): T {
    val start = System.currentTimeMillis()
    val deadline = start + RETRY_TIMEOUT_MS
    var pauseMs = 100L
    var nextReport = start + 2000 // said after 2 s, and then every 10 s
    while (true) {
        var waitMs = pauseMs
        try {
            return request()
        } catch (error: ProctorException) { // a refusal, no answer, or none that we can read
            if (error is Refused) error.retryAfterS?.let { waitMs = (1000 * it).toLong() }
            val now = System.currentTimeMillis()
            if (!error.mayRepeat || waitMs > deadline - now) throw error
            if (now + waitMs >= nextReport) {
                System.err.println("waiting: ${error.message}")
                nextReport = now + 10_000
            }
        }
        Thread.sleep(waitMs)
        pauseMs = minOf(2 * pauseMs, 2000)
    }
}

/** One action of `calibration`, with some values of its own; its success is a score above one half. */
fun act(score: Double, vararg values: Pair<String, List<Double>>) = Action(
    mapOf(
        "score" to listOf(score),
        "success" to listOf(if (score > 0.5) 1.0 else 0.0),
        "end" to listOf(0.0),
        "delay_s" to listOf(0.0),
        "fault" to listOf(0.0),
        "vector" to List(8) { 0.0 },
        "clipped" to List(2) { 0.0 },
    ) + values,
)
