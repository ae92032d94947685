package simgsm.classroom.demo;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import simgsm.center.app.ClassRow;
import simgsm.classroom.ui.ClassView;
import simgsm.console.Event;

/**
 * The results of a class: each student's orders and time of arrival at the goal. Fed with events and their times; one
 * thread at a time.
 */
final class ClassBoard {
    /** The distance within which a robot's middle counts as at the goal. */
    static final double GOAL_RADIUS_METERS = 0.5;

    private static final double NANOS_PER_SECOND = TimeUnit.SECONDS.toNanos(1);

    private final Map<String, Result> results = new LinkedHashMap<>();
    private ClassView.Phase phase = ClassView.Phase.FREE;
    private long startedNanos;
    private long stoppedNanos;

    /**
     * A student's result. The seconds to the goal count from the beginning of the challenge, without one from the first
     * key or message; NaN before the goal.
     */
    static final class Result {
        final String phone;
        final String number;
        private final double goalX;
        private final double goalY;
        private String name = "";
        private int keys;
        private int orders;
        private int collisions;
        private long beganNanos = -1;
        /** True if keys or messages were received since the beginning. */
        private boolean hasPlayed;

        private double seconds = Double.NaN;
        private String lesson = "";
        /** By lesson and step. */
        private final Map<String, StepRecord> steps = new LinkedHashMap<>();

        private Result(String phone, String number, double goalX, double goalY) {
            this.phone = phone;
            this.number = number;
            this.goalX = goalX;
            this.goalY = goalY;
        }

        private void begin(long nowNanos) {
            beganNanos = nowNanos;
            hasPlayed = false;
            keys = 0;
            orders = 0;
            collisions = 0;
            seconds = Double.NaN;
        }

        boolean isAtGoal() {
            return !Double.isNaN(seconds);
        }

        /** Phone, name, robot, orders, keys, collisions, seconds, lesson, steps of it that are passed. */
        List<String> cells() {
            return List.of(
                    phone,
                    name,
                    number,
                    Integer.toString(orders),
                    Integer.toString(keys),
                    Integer.toString(collisions),
                    seconds(),
                    lesson,
                    score());
        }

        private String seconds() {
            return isAtGoal() ? String.format(Locale.ROOT, "%.1f", seconds) : "";
        }

        private String score() {
            long passed = steps.entrySet().stream()
                    .filter(step -> step.getKey().startsWith(lesson + " "))
                    .filter(step -> step.getValue().isPassed)
                    .count();
            return lesson.isEmpty() ? "" : Long.toString(passed);
        }

        private boolean told(Event event) {
            Map<String, String> fields = event.fields();
            if (event.name().equals("lesson-result")) {
                lesson = fields.get("lesson");
                steps.merge(lesson + " " + fields.get("step"), StepRecord.of(fields), StepRecord::then);
                return true;
            }
            String told = fields.getOrDefault("name", "");
            boolean isNew = !told.isEmpty() && !told.equals(name);
            name = isNew ? told : name;
            return isNew;
        }

        /** All steps of all lessons. */
        String steps() {
            return steps.entrySet().stream()
                    .map(step -> step.getKey() + " " + step.getValue())
                    .collect(Collectors.joining("; "));
        }

        /** A row of the console's command {@code class}. */
        ClassRow row() {
            return new ClassRow(phone, name, number, orders, collisions, lesson, score());
        }

        Event event() {
            return Event.of("result")
                    .with("number", phone)
                    .with("robot", number)
                    .with("orders", orders)
                    .with("keys", keys)
                    .with("collisions", collisions)
                    .with("seconds", seconds());
        }
    }

    /**
     * A step until its first pass, over all runs of its lesson.
     *
     * @param before tries of the earlier runs
     * @param tries of the latest run
     * @param hints the greatest of all runs
     */
    private record StepRecord(boolean isPassed, int before, int tries, int hints) {
        static StepRecord of(Map<String, String> fields) {
            boolean isPassed = "pass".equals(fields.get("result"));
            return new StepRecord(
                    isPassed, 0, Integer.parseInt(fields.get("tries")), Integer.parseInt(fields.get("hints")));
        }

        /** Adds a later result. A run's tries only grow, so a number that does not begins another run. */
        StepRecord then(StepRecord next) {
            int earlier = next.tries > tries ? before : before + tries;
            return isPassed ? this : new StepRecord(next.isPassed, earlier, next.tries, Math.max(hints, next.hints));
        }

        @Override
        public String toString() {
            return (isPassed ? "pass" : "fail") + " tries=" + (before + tries) + " hints=" + hints;
        }
    }

    /** @param robot name of the student's robot; @param phone the student's number; @param number the robot's; its goal in metres */
    void add(String robot, String phone, String number, double goalX, double goalY) {
        results.put(robot, new Result(phone, number, goalX, goalY));
    }

    /**
     * What a student's phone or browser tells of its user: {@code joined} or {@code named} with {@code name=}, or {@code
     * lesson-result}.
     *
     * @return whether a result has changed
     */
    boolean told(Event event) {
        return results.values().stream()
                .filter(result -> result.phone.equals(event.fields().get("number")))
                .anyMatch(result -> result.told(event));
    }

    /** The rows of the console's command {@code class}, in the order of the numbers. */
    List<ClassRow> list() {
        return results.values().stream().map(Result::row).toList();
    }

    /**
     * Counts an event of SimRobot; events after the goal do not count.
     *
     * @return true if a result has changed
     */
    boolean event(Event event, long nowNanos) {
        Result result = results.get(event.fields().getOrDefault("robot", ""));
        if (result == null || result.isAtGoal() || phase == ClassView.Phase.STOPPED) {
            return false;
        }
        switch (event.name()) {
            case "keys" -> {
                begin(result, nowNanos);
                result.keys += event.fields().getOrDefault("keys", "").length();
            }
            case "sms" -> begin(result, nowNanos);
            case "order" -> result.orders += "accepted".equals(event.fields().get("verdict")) ? 1 : 0;
            case "status" ->
                result.collisions += "Collision".equals(event.fields().get("value")) ? 1 : 0;
            case "pose" -> pose(result, event, nowNanos);
            default -> {
                return false;
            }
        }
        return true;
    }

    private static void begin(Result result, long nowNanos) {
        result.hasPlayed = true;
        if (result.beganNanos < 0) {
            result.beganNanos = nowNanos;
        }
    }

    private void pose(Result result, Event event, long nowNanos) {
        double x = Double.parseDouble(event.fields().getOrDefault("x", "NaN"));
        double y = Double.parseDouble(event.fields().getOrDefault("y", "NaN"));
        if (result.beganNanos >= 0 && Math.hypot(x - result.goalX, y - result.goalY) <= GOAL_RADIUS_METERS) {
            result.seconds = (nowNanos - result.beganNanos) / NANOS_PER_SECOND;
        }
    }

    /** Begins a challenge: resets all results, and starts the time for all. */
    void start(long nowNanos) {
        phase = ClassView.Phase.RUNNING;
        startedNanos = nowNanos;
        results.values().forEach(result -> result.begin(nowNanos));
    }

    /** Ends the challenge; later events do not count. */
    void stop(long nowNanos) {
        if (phase == ClassView.Phase.RUNNING) {
            phase = ClassView.Phase.STOPPED;
            stoppedNanos = nowNanos;
        }
    }

    ClassView.Phase phase() {
        return phase;
    }

    /** Whole seconds of the challenge; 0 before the first. */
    long seconds(long nowNanos) {
        return switch (phase) {
            case FREE -> 0;
            case RUNNING -> TimeUnit.NANOSECONDS.toSeconds(nowNanos - startedNanos);
            case STOPPED -> TimeUnit.NANOSECONDS.toSeconds(stoppedNanos - startedNanos);
        };
    }

    /** Start of a student's run; empty before. */
    OptionalLong beganNanos(String phone) {
        return results.values().stream()
                .filter(result -> result.phone.equals(phone) && result.beganNanos >= 0)
                .mapToLong(result -> result.beganNanos)
                .findFirst();
    }

    /** The window's rows: {@link #ranked} with the first marked if it is at the goal. */
    List<ClassView.Row> rows() {
        List<ClassView.Row> rows = new ArrayList<>();
        for (Result result : ranked()) {
            rows.add(new ClassView.Row(result.cells(), rows.isEmpty() && result.isAtGoal(), result.steps()));
        }
        return rows;
    }

    /** Best first: results at the goal by their time; then by key presses, collisions and number of keys. */
    List<Result> ranked() {
        List<Result> ranked = new ArrayList<>(results.values());
        ranked.sort(Comparator.<Result>comparingDouble(
                        result -> result.isAtGoal() ? result.seconds : Double.POSITIVE_INFINITY)
                .thenComparing(result -> !result.hasPlayed)
                .thenComparingInt(result -> result.collisions)
                .thenComparingInt(result -> result.keys));
        return ranked;
    }
}
