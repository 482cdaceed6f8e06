import java.util.UUID
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import kotlin.system.exitProcess
import proctor.client.*

/** Plays the benchmark `calibration` with a scripted policy, or goes on with a run. */
private fun evaluate(server: Worker, runId: String?) {
    val options = CalibrationOptions(tasks = List(8) { CalibrationTask.SCORE })
    val submit = SubmitRun(benchmarkId = "calibration", policy = PolicyInfo(name = "scripted"), options = options)
    val key = UUID.randomUUID().toString()
    val run = ask { if (runId == null) server.control.submitRun(submit, key) else server.control.resumeRun(runId) }
    println("run ${run.runId}: ${run.progress.episodesTotal} episodes; its id, as RUN_ID, goes on with it")
    val policy = { turn: Turn -> List(5) { act(turn.episode!!.index % 5 / 4.0) } }
    val report = { result: EpisodeResult ->
        println("  episode ${result.index} (${result.task}): ${result.outcome.name.lowercase()}, score ${result.score}")
    }
    val team = Executors.newFixedThreadPool(2)
    val results = List(2) { team.submit { server.play(run.runId, "worker-$it", policy, report) } }
    team.shutdown()
    results.forEach { it.get() }
    println("score ${ask { server.control.getScore(run.runId) }.score}")
}

fun main(arguments: Array<String>) {
    val token = System.getenv("PROCTOR_TOKEN").orEmpty()
    if (token.isEmpty() || arguments.size !in 1..2) {
        System.err.println("usage: MainKt URL [RUN_ID]; the token is PROCTOR_TOKEN")
        exitProcess(1)
    }
    try {
        evaluate(Worker(arguments[0], token), arguments.getOrNull(1))
    } catch (error: Exception) {
        val cause = if (error is ExecutionException) error.cause else error
        System.err.println(cause?.message)
        exitProcess(1)
    }
}
