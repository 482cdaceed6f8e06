import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Function;
import java.util.stream.Collectors;
import proctor.client.ApiException;
import proctor.client.api.DataApi;
import proctor.client.model.*;

/**
 * What the Java client sees: Interop SCENARIO URL TOKEN prints one JSON line.
 *
 * <p>The scenarios are those of tools/interop.py, which judges; nothing is judged here.
 */
public final class Interop {
    static final List<Double> VECTOR =
            List.of(-0.0, 0.1, Double.MIN_VALUE, Double.MAX_VALUE, 9007199254740991.0, 1.0 / 3, -2.5e-8, 1e22);

    final Worker server;
    final String url;

    Interop(String url, String token) {
        this.url = url;
        this.server = url.startsWith("http") ? new Worker(url, token) : null; // vectors need none
    }

    static String unique() {
        return UUID.randomUUID().toString();
    }

    /** An object for the line that is printed: names and values in turn. */
    static Map<String, Object> seen(Object... parts) {
        Map<String, Object> made = new TreeMap<>();
        for (int i = 0; i < parts.length; i += 2) made.put((String) parts[i], parts[i + 1]);
        return made;
    }

    static <T, U> List<U> each(List<T> items, Function<T, U> function) {
        return items.stream().map(function).collect(Collectors.toList());
    }

    static SubmitRun calibration(CalibrationTask task, int count, int maxSteps) {
        CalibrationOptions options = new CalibrationOptions().tasks(Collections.nCopies(count, task)).maxSteps(maxSteps);
        return new SubmitRun().benchmarkId("calibration").policy(new PolicyInfo().name("interop")).options(options);
    }

    Run submit(SubmitRun body, String key) throws Exception {
        return Worker.ask(() -> server.control.submitRun(body, key, null));
    }

    Turn attach(Run run) throws Exception {
        AttachWorker key = new AttachWorker().attachKey(unique());
        return Worker.ask(() -> server.data(run).attachWorker(run.getRunId(), "worker-0", key, null));
    }

    Turn predict(Run run, Turn turn, long seq, List<Action> actions) throws Exception {
        Predict body = new Predict().sessionId(turn.getSessionId()).seq(seq).actions(actions).observe(Observe.ALL);
        return Worker.ask(() -> server.data(run).predict(run.getRunId(), "worker-0", body, null));
    }

    Map<String, List<EpisodeResult>> play(Run run, Function<Turn, List<Action>> policy, int workers) throws Exception {
        Map<String, List<EpisodeResult>> results = new TreeMap<>();
        ExecutorService team = Executors.newFixedThreadPool(workers);
        List<Future<?>> ends = new ArrayList<>();
        for (int i = 0; i < workers; i++) {
            String worker = "worker-" + i;
            List<EpisodeResult> list = new ArrayList<>();
            results.put(worker, list);
            ends.add(team.submit(() -> {
                server.play(run.getRunId(), worker, policy, list::add);
                return null;
            }));
        }
        for (Future<?> end : ends) end.get();
        team.shutdown();
        return results;
    }

    static Function<Turn, List<Action>> byIndex(double... scores) {
        return turn -> Collections.nCopies(2, Worker.act(scores[turn.getEpisode().getIndex()]));
    }

    static Action with(Action action, String name, List<Double> values) {
        action.getValues().put(name, values);
        return action;
    }

    static List<Double> counts(Turn turn) {
        return each(turn.getObservations(), seen -> seen.getState().get("count").get(0));
    }

    static List<Integer> indices(List<EpisodeResult> results) {
        return each(results, EpisodeResult::getIndex);
    }

    static String hex(String base64) {
        StringBuilder digits = new StringBuilder();
        for (byte part : Base64.getDecoder().decode(base64)) digits.append(String.format("%02x", part));
        return digits.toString();
    }

    Map<String, Object> theScore(Run run, Object... more) throws Exception {
        Score score = Worker.ask(() -> server.control.getScore(run.getRunId(), null));
        Map<String, Object> made = seen(more);
        made.putAll(seen("run_id", run.getRunId(), "score", score.getScore(), "complete", score.getComplete()));
        return made;
    }

    interface Attempt {
        Object make() throws Exception;
    }

    static Map<String, Object> problemOf(Attempt attempt) throws Exception {
        try {
            attempt.make();
        } catch (Worker.Refused refused) {
            Problem problem = refused.problem;
            List<ProblemItem> items = problem.getErrors() == null ? List.of() : problem.getErrors();
            return seen(
                    "status", refused.status, "code", problem.getCode(), "retryable", problem.getRetryable(),
                    "side_effects", problem.getSideEffects().getValue(), "retry_after_s", refused.retryAfterS,
                    "pointers", each(items, ProblemItem::getPointer), "expected_seq", problem.getExpectedSeq(),
                    "ended_by", problem.getEndedBy());
        }
        return seen("code", "accepted");
    }

    Object submit() throws Exception {
        SubmitRun body = calibration(CalibrationTask.SCORE, 1, 10);
        String key = unique();
        String first = submit(body, key).getRunId();
        String second = submit(body, key).getRunId();
        RunList listed = Worker.ask(() -> server.control.listRuns(null, 1000, null));
        Service service = Worker.ask(() -> server.control.describeService(null));
        Benchmark benchmark = Worker.ask(() -> server.control.getBenchmark("calibration", null));
        Map<String, Object> sizes = new TreeMap<>();
        benchmark.getActionSpace().forEach((name, space) -> sizes.put(name, space.getSize()));
        return seen(
                "run_ids", List.of(first, second), "action_sizes", sizes,
                "listed", listed.getRuns().stream().filter(run -> run.getRunId().equals(first)).count(),
                "max_workers", service.getLimits().getMaxWorkers());
    }

    Object twoWorkers() throws Exception {
        Run run = submit(calibration(CalibrationTask.DELAY, 8, 4), unique());
        Map<String, Object> played = new TreeMap<>();
        Function<Turn, List<Action>> policy = turn -> Collections.nCopies(
                2, with(Worker.act(turn.getEpisode().getIndex() % 2), "delay_s", List.of(0.05)));
        play(run, policy, 2).forEach((worker, results) -> played.put(worker, indices(results)));
        return theScore(run, "played", played);
    }

    Object chunks() throws Exception {
        Run run = submit(calibration(CalibrationTask.COUNT, 1, 10), unique());
        Turn turn = attach(run);
        List<Turn> turns = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            turn = predict(run, turn, turn.getSeq() + 1, Collections.nCopies(4, Worker.act(0)));
            turns.add(turn);
        }
        return seen(
                "executed", each(turns, Turn::getExecutedSteps), "counts", each(turns, Interop::counts),
                "rewards", each(turns, t -> t.getRewards().size()), "truncated", each(turns, Turn::getTruncated),
                "stopped_early", each(turns, Turn::getStoppedEarly), "done", turn.getDone(),
                "steps", turn.getEpisodeResult().getSteps());
    }

    Object echo() throws Exception {
        SubmitRun body = calibration(CalibrationTask.ECHO, 1, 10);
        body.setImages(new ImageChoice().codec("raw").width(64).height(48));
        Run run = submit(body, unique());
        Turn turn = predict(run, attach(run), 1, List.of(with(Worker.act(0), "vector", VECTOR)));
        Image image = turn.getObservation().getImages().get("pattern");
        Map<String, Object> tensors = new TreeMap<>();
        turn.getObservation().getTensors().forEach((name, tensor) -> tensors.put(name, seen(
                "dtype", tensor.getDtype(), "shape", tensor.getShape(), "data", hex(tensor.getData()))));
        return seen(
                "codec", image.getCodec(), "image", hex(image.getData()), "tensors", tensors,
                "size", List.of(image.getHeight(), image.getWidth(), image.getChannels()),
                "vector", each(turn.getObservation().getState().get("vector"),
                        value -> String.format("%016x", Double.doubleToRawLongBits(value))));
    }

    Object lostAnswer() throws Exception {
        Run run = submit(calibration(CalibrationTask.COUNT, 1, 6), unique());
        Turn turn = attach(run);
        List<Double> all = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            turn = predict(run, turn, turn.getSeq() + 1, Collections.nCopies(3, Worker.act(0)));
            all.addAll(counts(turn));
        }
        return seen("run_id", run.getRunId(), "counts", all, "done", turn.getDone());
    }

    Object lostSession() throws Exception {
        Run run = submit(calibration(CalibrationTask.COUNT, 1, 10).idleTimeoutS(2.0), unique());
        List<String> calls = new ArrayList<>();
        Function<Turn, List<Action>> policy = turn -> {
            calls.add(turn.getSessionId());
            try {
                while (calls.size() == 2 // thinks for longer than the lease
                        && Worker.ask(() -> server.control.getRun(run.getRunId(), null, null, null)).getLiveWorkers() > 0) {
                    Thread.sleep(100);
                }
            } catch (Exception error) {
                throw new IllegalStateException(error);
            }
            return Collections.nCopies(2, Worker.act(1));
        };
        List<EpisodeResult> results = play(run, policy, 1).get("worker-0");
        Set<String> sessions = new HashSet<>(calls);
        return theScore(run, "sessions", sessions.size(), "attempt", results.get(results.size() - 1).getAttempt());
    }

    Object restart() throws Exception {
        Run run = submit(calibration(CalibrationTask.SCORE, 4, 6), unique());
        List<EpisodeResult> results = play(run, byIndex(0.25, 0.5, 0.75, 1), 1).get("worker-0");
        return theScore(run, "attempts", each(results, EpisodeResult::getAttempt));
    }

    Object workerLimit() throws Exception {
        Run run = submit(calibration(CalibrationTask.SCORE, 3, 10).maxWorkers(1).idleTimeoutS(5.0), unique());
        Turn turn = attach(run);
        DataApi data = server.data(run);
        AttachWorker key = new AttachWorker().attachKey("k");
        Object problem = problemOf(() -> Worker.once(() -> data.attachWorker(run.getRunId(), "worker-1", key, null)));
        Worker.ask(() -> {
            data.detachWorker(run.getRunId(), "worker-0", turn.getSessionId(), null);
            return null;
        });
        play(run, byIndex(1, 1, 1), 2);
        return theScore(run, "problem", problem);
    }

    Object stopResume() throws Exception {
        Run run = submit(calibration(CalibrationTask.SCORE, 3, 2), unique());
        Function<Turn, List<Action>> policy = byIndex(0.5, 0.25, 1);
        Turn first = attach(run);
        Turn turn = predict(run, first, 1, policy.apply(first));
        StopRun abort = new StopRun().mode(StopMode.ABORT);
        Run stopped = Worker.ask(() -> server.control.stopRun(run.getRunId(), abort, null));
        Object problem = problemOf(() -> predict(run, turn, 2, policy.apply(turn)));
        Worker.ask(() -> server.control.resumeRun(run.getRunId(), null));
        List<Integer> after = indices(play(run, policy, 1).get("worker-0"));
        return theScore(run, "problem", problem, "stopped", stopped.getState().getValue(), "after", after);
    }

    Object problems() throws Exception {
        SubmitRun unknown = new SubmitRun().benchmarkId("no_such").policy(new PolicyInfo().name("interop"));
        Worker unauthenticated = new Worker(url, "not-a-token");
        Run run = submit(calibration(CalibrationTask.COUNT, 1, 10), unique());
        Turn turn = attach(run);
        return seen("problems", List.of(
                problemOf(() -> Worker.once(() -> server.control.submitRun(unknown, null, null))),
                problemOf(() -> Worker.once(() -> server.control.getRun("no_such", null, null, null))),
                problemOf(() -> Worker.once(() -> unauthenticated.control.listRuns(null, null, null))),
                problemOf(() -> predict(run, turn, 1, List.of(with(Worker.act(0), "vector", List.of(1.0))))),
                problemOf(() -> predict(run, turn, 7, List.of(Worker.act(0))))));
    }

    /** Every run that is listed is answered by what is no run. */
    Object wrongAnswers() throws Exception {
        Map<String, Object> errors = new TreeMap<>();
        for (Run run : Worker.ask(() -> server.control.listRuns(null, null, null)).getRuns()) {
            try {
                server.control.getRun(run.getRunId(), null, null, null);
                errors.put(run.getRunId(), "accepted");
            } catch (ApiException error) {
                errors.put(run.getRunId(), error.getCode() == 200 ? "bad_answer" : "refused");
            }
        }
        return seen("errors", errors);
    }

    Object laterVersion() throws Exception {
        Service service = Worker.ask(() -> server.control.describeService(null));
        Benchmark benchmark = Worker.ask(() -> server.control.getBenchmark("calibration", null));
        VectorSpace vector = benchmark.getActionSpace().get("vector");
        Run run = submit(calibration(CalibrationTask.ECHO, 1, 10), unique());
        Observation seen = attach(run).getObservation();
        return seen(
                "profiles", service.getProfiles(), "image_codecs", service.getImageCodecs(),
                "success_rule", benchmark.getSuccessRule(), "rotation", vector.getParts().get("all").getRotation(),
                "out_of_range", vector.getOutOfRange(), "mode", run.getMode(), "policy", run.getPolicy().getName(),
                "codec", seen.getImages().get("pattern").getCodec(), "dtype", seen.getTensors().get("float64").getDtype(),
                "problem", problemOf(() -> Worker.once(() -> server.control.getRun("no_such", null, null, null))));
    }

    Object score() throws Exception {
        Run run = submit(calibration(CalibrationTask.SCORE, 5, 2), unique());
        play(run, byIndex(1, 0.5, 0.25, 0, 0.25), 1);
        Score score = Worker.ask(() -> server.control.getScore(run.getRunId(), null));
        List<Object> episodes = new ArrayList<>();
        int pages = 0;
        for (String cursor = null; pages == 0 || cursor != null; pages++) {
            String at = cursor;
            EpisodeList page = Worker.ask(() -> server.control.listEpisodes(run.getRunId(), at, 2, null));
            for (Episode e : page.getEpisodes()) {
                episodes.add(List.of(e.getIndex(), e.getResult().getScore(), e.getResult().getSeed()));
            }
            cursor = page.getNextCursor();
        }
        Map<String, Object> splits = new TreeMap<>();
        score.getBySplit().forEach((name, group) -> splits.put(name, group.getMean()));
        Interval interval = score.getSuccessInterval();
        return seen(
                "run_id", run.getRunId(), "score", score.getScore(), "success_rate", score.getSuccessRate(),
                "interval", List.of(interval.getLow(), interval.getHigh()), "success", score.getCounts().getSuccess(),
                "splits", splits, "pages", pages, "episodes", episodes);
    }

    static String again(String schema, String text) throws Exception {
        switch (schema) {
            case "Action": return Action.fromJson(text).toJson();
            case "Image": return Image.fromJson(text).toJson();
            case "Predict": return Predict.fromJson(text).toJson();
            case "Problem": return Problem.fromJson(text).toJson();
            case "Tensor": return Tensor.fromJson(text).toJson();
            case "Turn": return Turn.fromJson(text).toJson();
            default: throw new IllegalArgumentException(schema);
        }
    }

    /** Each golden vector decoded by the client's models and encoded again. */
    static Object vectors(String directory) throws Exception {
        Map<String, Object> made = new TreeMap<>();
        for (File file : new File(directory).listFiles((place, name) -> name.endsWith(".json"))) {
            JsonObject document = JsonParser.parseString(Files.readString(file.toPath())).getAsJsonObject();
            for (JsonElement element : document.getAsJsonArray("vectors")) {
                JsonObject vector = element.getAsJsonObject();
                if (vector.has("refused")) continue; // for servers
                String text = vector.get("json").getAsString();
                made.put(vector.get("id").getAsString(), again(vector.get("schema").getAsString(), text));
            }
        }
        return made;
    }

    Object scenario(String name) throws Exception {
        switch (name) {
            case "submit": return submit();
            case "two_workers": return twoWorkers();
            case "chunks": return chunks();
            case "echo": return echo();
            case "lost_answer": return lostAnswer();
            case "lost_session": return lostSession();
            case "restart": return restart();
            case "worker_limit": return workerLimit();
            case "stop_resume": return stopResume();
            case "problems": return problems();
            case "wrong_answers": return wrongAnswers();
            case "later_version": return laterVersion();
            case "score": return score();
            case "vectors": return vectors(url);
            default: throw new IllegalArgumentException(name);
        }
    }

    public static void main(String[] arguments) {
        Gson gson = new GsonBuilder().serializeNulls().disableHtmlEscaping().create();
        try {
            System.out.println(gson.toJson(new Interop(arguments[1], arguments[2]).scenario(arguments[0])));
        } catch (Throwable error) {
            error.printStackTrace();
            System.exit(1);
        }
        System.exit(0); // the HTTP client's threads are no reason to stay
    }
}
