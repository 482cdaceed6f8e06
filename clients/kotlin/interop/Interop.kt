import java.io.File
import java.util.Base64
import java.util.UUID
import java.util.concurrent.Executors
import java.util.concurrent.Future
import kotlin.system.exitProcess
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import proctor.client.*

/*
 * What the Kotlin client sees: InteropKt SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tools/interop.py, which judges; nothing is judged here.
 */

private val VECTOR = listOf(-0.0, 0.1, Double.MIN_VALUE, Double.MAX_VALUE, 9007199254740991.0, 1.0 / 3, -2.5e-8, 1e22)

private typealias Policy = (Turn) -> List<Action>
private typealias Seen = Map<String, Any?>

private fun unique() = UUID.randomUUID().toString()

private fun hex(base64: String) = Base64.getDecoder().decode(base64).joinToString("") { "%02x".format(it) }

private fun counts(turn: Turn) = turn.observations!!.map { it.state.getValue("count")[0] }

private fun byIndex(vararg scores: Double): Policy = { turn -> List(2) { act(scores[turn.episode!!.index]) } }

private fun calibration(task: CalibrationTask, count: Int, maxSteps: Int) = SubmitRun(
    benchmarkId = "calibration",
    policy = PolicyInfo(name = "interop"),
    options = CalibrationOptions(tasks = List(count) { task }, maxSteps = maxSteps),
)

private fun problemOf(attempt: () -> Any?): Seen = try {
    attempt()
    mapOf("code" to "accepted")
} catch (refused: Refused) {
    val problem = refused.problem
    mapOf(
        "status" to refused.status, "code" to problem.code, "retryable" to problem.retryable,
        "side_effects" to problem.sideEffects.name.lowercase(), "retry_after_s" to refused.retryAfterS,
        "pointers" to problem.errors.orEmpty().map { it.pointer }, "expected_seq" to problem.expectedSeq,
        "ended_by" to problem.endedBy,
    )
}

private class Scenarios(private val url: String, token: String) {
    private val server by lazy { Worker(url, token) } // vectors need none
    private val control by lazy { server.control }

    private fun submit(body: SubmitRun, key: String = unique()) = ask { control.submitRun(body, key) }

    private fun attach(run: Run): Turn {
        val key = AttachWorker(attachKey = unique())
        return ask { server.data(run).attachWorker(run.runId, "worker-0", key) }
    }

    private fun predict(run: Run, turn: Turn, seq: Long, actions: List<Action>): Turn {
        val body = Predict(sessionId = turn.sessionId, seq = seq, actions = actions, observe = Observe.ALL)
        return ask { server.data(run).predict(run.runId, "worker-0", body) }
    }

    private fun play(run: Run, policy: Policy, workers: Int = 1): Map<String, List<EpisodeResult>> {
        val results = List(workers) { "worker-$it" }.associateWith { mutableListOf<EpisodeResult>() }
        val team = Executors.newFixedThreadPool(workers)
        val ends = results.map { (worker, list) -> team.submit { server.play(run.runId, worker, policy, list::add) } }
        team.shutdown()
        ends.forEach(Future<*>::get)
        return results
    }

    private fun score(run: Run, vararg more: Pair<String, Any?>): Seen {
        val score = ask { control.getScore(run.runId) }
        return mapOf("run_id" to run.runId, "score" to score.score, "complete" to score.complete, *more)
    }

    fun submit(): Seen {
        val body = calibration(CalibrationTask.SCORE, 1, 10)
        val key = unique()
        val first = submit(body, key).runId
        val second = submit(body, key).runId
        return mapOf(
            "run_ids" to listOf(first, second),
            "listed" to ask { control.listRuns(limit = 1000) }.runs.count { it.runId == first },
            "max_workers" to ask { control.describeService() }.limits.maxWorkers,
            "action_sizes" to ask { control.getBenchmark("calibration") }.actionSpace.mapValues { it.value.size },
        )
    }

    fun twoWorkers(): Seen {
        val run = submit(calibration(CalibrationTask.DELAY, 8, 4))
        val policy: Policy = { turn -> List(2) { act(turn.episode!!.index % 2.0, "delay_s" to listOf(0.05)) } }
        val played = play(run, policy, workers = 2).mapValues { (_, results) -> results.map { it.index } }
        return score(run, "played" to played)
    }

    fun chunks(): Seen {
        val run = submit(calibration(CalibrationTask.COUNT, 1, 10))
        val turns = mutableListOf(attach(run))
        repeat(3) { turns += predict(run, turns.last(), turns.last().seq + 1, List(4) { act(0.0) }) }
        turns.removeAt(0)
        return mapOf(
            "executed" to turns.map { it.executedSteps }, "counts" to turns.map(::counts),
            "rewards" to turns.map { it.rewards.size }, "truncated" to turns.map { it.truncated },
            "stopped_early" to turns.map { it.stoppedEarly }, "done" to turns.last().done,
            "steps" to turns.last().episodeResult!!.steps,
        )
    }

    fun echo(): Seen {
        val images = ImageChoice(codec = "raw", width = 64, height = 48)
        val run = submit(calibration(CalibrationTask.ECHO, 1, 10).copy(images = images))
        val seen = predict(run, attach(run), 1, listOf(act(0.0, "vector" to VECTOR))).observation!!
        val image = seen.images.getValue("pattern")
        return mapOf(
            "codec" to image.codec, "image" to hex(image.data), "size" to listOf(image.height, image.width, image.channels),
            "tensors" to seen.tensors.mapValues { (_, tensor) ->
                mapOf("dtype" to tensor.dtype, "shape" to tensor.shape, "data" to hex(tensor.data))
            },
            "vector" to seen.state.getValue("vector").map { "%016x".format(it.toRawBits()) },
        )
    }

    fun lostAnswer(): Seen {
        val run = submit(calibration(CalibrationTask.COUNT, 1, 6))
        var turn = attach(run)
        val all = mutableListOf<Double>()
        repeat(2) {
            turn = predict(run, turn, turn.seq + 1, List(3) { act(0.0) })
            all += counts(turn)
        }
        return mapOf("run_id" to run.runId, "counts" to all, "done" to turn.done)
    }

    fun lostSession(): Seen {
        val run = submit(calibration(CalibrationTask.COUNT, 1, 10).copy(idleTimeoutS = 2.0))
        val calls = mutableListOf<String>()
        val policy: Policy = { turn ->
            calls += turn.sessionId
            // thinks for longer than the lease
            while (calls.size == 2 && ask { control.getRun(run.runId) }.liveWorkers > 0) Thread.sleep(100)
            List(2) { act(1.0) }
        }
        val results = play(run, policy).getValue("worker-0")
        return score(run, "sessions" to calls.toSet().size, "attempt" to results.last().attempt)
    }

    fun restart(): Seen {
        val run = submit(calibration(CalibrationTask.SCORE, 4, 6))
        val results = play(run, byIndex(0.25, 0.5, 0.75, 1.0)).getValue("worker-0")
        return score(run, "attempts" to results.map { it.attempt })
    }

    fun workerLimit(): Seen {
        val run = submit(calibration(CalibrationTask.SCORE, 3, 10).copy(maxWorkers = 1, idleTimeoutS = 5.0))
        val turn = attach(run)
        val data = server.data(run)
        val problem = problemOf { data.attachWorker(run.runId, "worker-1", AttachWorker(attachKey = "k")) }
        ask { data.detachWorker(run.runId, "worker-0", turn.sessionId) }
        play(run, byIndex(1.0, 1.0, 1.0), workers = 2)
        return score(run, "problem" to problem)
    }

    fun stopResume(): Seen {
        val run = submit(calibration(CalibrationTask.SCORE, 3, 2))
        val policy = byIndex(0.5, 0.25, 1.0)
        val first = attach(run)
        val turn = predict(run, first, 1, policy(first))
        val stopped = ask { control.stopRun(run.runId, StopRun(StopMode.ABORT)) }
        val problem = problemOf { predict(run, turn, 2, policy(turn)) }
        ask { control.resumeRun(run.runId) }
        val after = play(run, policy).getValue("worker-0").map { it.index }
        return score(run, "problem" to problem, "stopped" to stopped.state.name.lowercase(), "after" to after)
    }

    fun problems(): Seen {
        val unknown = SubmitRun(benchmarkId = "no_such", policy = PolicyInfo(name = "interop"))
        val run = submit(calibration(CalibrationTask.COUNT, 1, 10))
        val turn = attach(run)
        return mapOf(
            "problems" to listOf(
                problemOf { control.submitRun(unknown) },
                problemOf { control.getRun("no_such") },
                problemOf { Worker(url, "not-a-token").control.listRuns() },
                problemOf { predict(run, turn, 1, listOf(act(0.0, "vector" to listOf(1.0)))) },
                problemOf { predict(run, turn, 7, listOf(act(0.0))) },
            ),
        )
    }

    /** Every run that is listed is answered by what is no run. */
    fun wrongAnswers(): Seen = mapOf("errors" to ask { control.listRuns() }.runs.associate { run ->
        run.runId to try {
            control.getRun(run.runId)
            "accepted"
        } catch (_: InvalidAnswer) {
            "bad_answer"
        }
    })

    fun laterVersion(): Seen {
        val service = ask { control.describeService() }
        val benchmark = ask { control.getBenchmark("calibration") }
        val vector = benchmark.actionSpace.getValue("vector")
        val run = submit(calibration(CalibrationTask.ECHO, 1, 10))
        val seen = attach(run).observation!!
        return mapOf(
            "profiles" to service.profiles, "image_codecs" to service.imageCodecs,
            "success_rule" to benchmark.successRule, "rotation" to vector.parts?.get("all")?.rotation,
            "out_of_range" to vector.outOfRange, "mode" to run.mode, "policy" to run.policy.name,
            "codec" to seen.images.getValue("pattern").codec, "dtype" to seen.tensors.getValue("float64").dtype,
            "problem" to problemOf { control.getRun("no_such") },
        )
    }

    fun score(): Seen {
        val run = submit(calibration(CalibrationTask.SCORE, 5, 2))
        play(run, byIndex(1.0, 0.5, 0.25, 0.0, 0.25))
        val score = ask { control.getScore(run.runId) }
        val pages = mutableListOf<EpisodeList>()
        do {
            val cursor = pages.lastOrNull()?.nextCursor
            pages += ask { control.listEpisodes(run.runId, cursor, 2) }
        } while (pages.last().nextCursor != null)
        return mapOf(
            "run_id" to run.runId, "score" to score.score, "success_rate" to score.successRate,
            "interval" to listOf(score.successInterval.low, score.successInterval.high),
            "success" to score.counts.success, "splits" to score.bySplit.mapValues { it.value.mean }, "pages" to pages.size,
            "episodes" to pages.flatMap { it.episodes }.map { listOf(it.index, it.result!!.score, it.result!!.seed) },
        )
    }

    /** Each golden vector decoded by the client's messages and encoded again. */
    fun vectors(): Seen = File(url).listFiles { file -> file.extension == "json" }!!
        .flatMap { json.parseToJsonElement(it.readText()).jsonObject.getValue("vectors").jsonArray }
        .map { it.jsonObject }.filter { "refused" !in it } // those are for servers
        .associate { it.text("id") to again(it.text("schema"), it.text("json")) }

    private fun JsonObject.text(name: String) = getValue(name).jsonPrimitive.content
}

private inline fun <reified Message> again(text: String) = json.encodeToString(json.decodeFromString<Message>(text))

private fun again(schema: String, text: String) = when (schema) {
    "Action" -> again<Action>(text)
    "Image" -> again<Image>(text)
    "Predict" -> again<Predict>(text)
    "Problem" -> again<Problem>(text)
    "Tensor" -> again<Tensor>(text)
    "Turn" -> again<Turn>(text)
    else -> error(schema)
}

private fun toJson(value: Any?): JsonElement = when (value) {
    null -> JsonNull
    is Map<*, *> -> JsonObject(value.entries.associate { it.key.toString() to toJson(it.value) })
    is List<*> -> JsonArray(value.map(::toJson))
    is Number -> JsonPrimitive(value)
    is Boolean -> JsonPrimitive(value)
    else -> JsonPrimitive(value.toString())
}

private fun scenario(name: String, on: Scenarios): Seen = when (name) {
    "submit" -> on.submit()
    "two_workers" -> on.twoWorkers()
    "chunks" -> on.chunks()
    "echo" -> on.echo()
    "lost_answer" -> on.lostAnswer()
    "lost_session" -> on.lostSession()
    "restart" -> on.restart()
    "worker_limit" -> on.workerLimit()
    "stop_resume" -> on.stopResume()
    "problems" -> on.problems()
    "wrong_answers" -> on.wrongAnswers()
    "later_version" -> on.laterVersion()
    "score" -> on.score()
    "vectors" -> on.vectors()
    else -> error(name)
}

fun main(arguments: Array<String>) {
    try {
        println(toJson(scenario(arguments[0], Scenarios(arguments[1], arguments[2]))))
    } catch (error: Throwable) {
        error.printStackTrace()
        exitProcess(1)
    }
}
