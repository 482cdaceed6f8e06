import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import proctor.client.model.*;

/** Plays the benchmark `calibration` with a scripted policy, or goes on: PROCTOR_TOKEN=… Main URL [RUN_ID]. */
public final class Main {
    static void evaluate(Worker server, String runId) throws Exception {
        SubmitRun submit = new SubmitRun().benchmarkId("calibration").policy(new PolicyInfo().name("scripted"));
        submit.setOptions(new CalibrationOptions().tasks(Collections.nCopies(8, CalibrationTask.SCORE)));
        String key = UUID.randomUUID().toString();
        Run run = runId == null
                ? Worker.ask(() -> server.control.submitRun(submit, key, null))
                : Worker.ask(() -> server.control.resumeRun(runId, null));
        System.out.printf("run %s: %d episodes; its id, as RUN_ID, goes on with it%n", run.getRunId(), run.getProgress().getEpisodesTotal());
        ExecutorService team = Executors.newFixedThreadPool(2);
        List<Future<?>> results = new ArrayList<>();
        for (String worker : List.of("worker-0", "worker-1")) {
            results.add(team.submit(() -> {
                server.play(run.getRunId(), worker,
                        turn -> Collections.nCopies(5, Worker.act(turn.getEpisode().getIndex() % 5 / 4.0)),
                        r -> System.out.printf("  episode %d (%s): %s, score %s%n",
                                r.getIndex(), r.getTask(), r.getOutcome(), r.getScore()));
                return null;
            }));
        }
        team.shutdown();
        for (Future<?> result : results) result.get();
        Score score = Worker.ask(() -> server.control.getScore(run.getRunId(), null));
        System.out.println("score " + score.getScore());
    }

    public static void main(String[] arguments) throws Exception {
        String token = System.getenv("PROCTOR_TOKEN");
        if (token == null || token.isEmpty() || (arguments.length != 1 && arguments.length != 2)) {
            System.err.println("usage: Main URL [RUN_ID]; the token is PROCTOR_TOKEN");
            System.exit(1);
        }
        try {
            evaluate(new Worker(arguments[0], token), arguments.length > 1 ? arguments[1] : null);
        } catch (Exception error) {
            Throwable cause = error.getCause() == null ? error : error.getCause();
            System.err.println(cause.getMessage());
            System.exit(1);
        }
        System.exit(0); // the HTTP client's threads are no reason to stay
    }
}
