import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.function.Consumer;
import java.util.function.Function;
import proctor.client.ApiException;
import proctor.client.Connection;
import proctor.client.api.ControlApi;
import proctor.client.api.DataApi;
import proctor.client.model.*;

/**
 * A worker loop on the generated client: the least that a policy needs to be evaluated.
 *
 * <p>The same loop stands in the example of every language; see docs/implement/clients.md.
 */
public final class Worker {
    static final long RETRY_TIMEOUT_MS = 60_000;

    /** The request failed: `problem` says why and what to do. status: 0 if no answer came. */
    static final class Refused extends Exception {
        final int status;
        final Problem problem;
        final Double retryAfterS;

        Refused(int status, Problem problem, Double retryAfterS) {
            super(problem.getDetail() + " [" + problem.getCode() + "]");
            this.status = status;
            this.problem = problem;
            this.retryAfterS = retryAfterS;
        }
    }

    interface Request<T> {
        T send() throws ApiException;
    }

    final ControlApi control;
    private final String token;

    Worker(String url, String token) {
        this.token = token;
        this.control = new ControlApi(Connection.connect(url, token));
    }

    DataApi data(Run run) {
        return new DataApi(Connection.connect(run.getEndpoint(), token));
    }


    /** Send a request; a failure becomes Refused. */
    static <T> T once(Request<T> request) throws Refused {
        try {
            return request.send();
        } catch (ApiException error) {
            throw new Refused(error.getCode(), Connection.problemOf(error), secondsOf(error));
        }
    }

    /** Retry-After, if it is a number of seconds: it may be a date. */
    private static Double secondsOf(ApiException error) {
        Map<String, List<String>> headers = error.getResponseHeaders();
        if (headers == null) return null; // no answer came
        String text = headers.getOrDefault("retry-after", List.of("")).get(0);
        return text.matches("[0-9]{1,6}") ? Double.valueOf(text) : null;
    }

    /** Send a request until it is answered: a repeat executes nothing twice. */
    static <T> T ask(Request<T> request) throws Exception {
        long start = System.currentTimeMillis(), deadline = start + RETRY_TIMEOUT_MS;
        long nextReport = start + 2000; // said after 2 s, and then every 10 s
        for (long pause = 100; ; pause = Math.min(2 * pause, 2000)) {
            long wait = pause, now;
            String why;
            try {
                return once(request);
            } catch (Refused error) {
                now = System.currentTimeMillis();
                why = error.getMessage();
                if (error.retryAfterS != null) wait = Math.round(1000 * error.retryAfterS);
                if (!error.problem.getRetryable() || now + wait > deadline) throw error;
            }
            if (now + wait >= nextReport) {
                System.err.println("waiting: " + why);
                nextReport = now + 10_000;
            }
            Thread.sleep(wait);
        }
    }

    /** Play until no episode is left; a lost session is replaced by a new one. */
    void play(String runId, String workerId, Function<Turn, List<Action>> policy, Consumer<EpisodeResult> report)
            throws Exception {
        while (true) {
            DataApi data = data(untilOpen(runId));
            AttachWorker key = new AttachWorker().attachKey(UUID.randomUUID().toString());
            try {
                Turn turn = ask(() -> data.attachWorker(runId, workerId, key, null));
                while (!turn.getDone()) {
                    Predict chunk = new Predict().sessionId(turn.getSessionId()).seq(turn.getSeq() + 1);
                    chunk.setActions(policy.apply(turn));
                    turn = ask(() -> data.predict(runId, workerId, chunk, null));
                    if (turn.getEpisodeResult() != null) report.accept(turn.getEpisodeResult());
                }
                return;
            } catch (Refused error) {
                Problem why = error.problem;
                boolean completed = why.getState() == RunState.COMPLETED;
                if (why.getCode().equals("illegal_transition") && completed) return; // others played the rest
                boolean over = "run_stopped".equals(why.getEndedBy()) || "run_failed".equals(why.getEndedBy());
                if (!why.getCode().equals("session_ended") || over) throw error;
                String lost = " lost its session, and the attempt of an episode that had begun: ";
                System.err.println("warning: " + workerId + lost + error.getMessage());
            }
        }
    }

    /** The run, as soon as workers may attach. */
    Run untilOpen(String runId) throws Exception {
        while (true) {
            Run run = ask(() -> control.getRun(runId, null, null, null));
            if (run.getState() != RunState.QUEUED) return run;
            Thread.sleep(100);
        }
    }

    /** One action of `calibration`; its success is a score above one half. */
    static Action act(double score) {
        Map<String, List<Double>> values = new HashMap<>();
        for (String name : List.of("end", "delay_s", "fault")) values.put(name, List.of(0.0));
        values.put("score", List.of(score));
        values.put("success", List.of(score > 0.5 ? 1.0 : 0.0));
        values.put("vector", Collections.nCopies(8, 0.0));
        values.put("clipped", Collections.nCopies(2, 0.0));
        return new Action().values(values);
    }
}
