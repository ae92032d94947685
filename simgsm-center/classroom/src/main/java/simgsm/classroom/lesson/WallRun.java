package simgsm.classroom.lesson;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simgsm.console.Event;
import simgsm.console.ExitStatus;

/** Runs a student's process in SimRobot at full speed, and measures the robot's distance from the walls. */
final class WallRun {
    private static final String SECONDS = "60";
    private static final String TRACK = "track.csv";
    /** Time for finding a wall, excluded from the measurement. */
    private static final double BEGIN_SECONDS = 15;

    private static final double NEAR_METERS = 0.4;
    private static final double FAR_METERS = 0.8;
    private static final double MILLI = 1e-3;
    private static final double PERCENT = 100;

    private record Wall(double x1, double y1, double x2, double y2) {
        /** Distance from a place, in metres. */
        double distance(double x, double y) {
            double dx = x2 - x1;
            double dy = y2 - y1;
            double length = dx * dx + dy * dy;
            double at = length == 0 ? 0 : Math.max(0, Math.min(1, ((x - x1) * dx + (y - y1) * dy) / length));
            return Math.hypot(x - x1 - at * dx, y - y1 - at * dy);
        }
    }

    private WallRun() {}

    /**
     * Runs a process of the lesson's folder for 60 s.
     *
     * @param process its name
     * @return an event {@code drive status= output= name= travelled= collisions= near= far=}: metres, and percentages
     * of the time after the first 15 s with the robot's middle less than 0.4 m and more than 0.8 m from every wall
     */
    static Event run(LessonTools tools, Path folder, String process, String world)
            throws IOException, InterruptedException {
        LessonTools.Printed printed = tools.jar(
                "simrobot.jar",
                List.of(
                        "--headless",
                        "--world",
                        world,
                        "--behaviours",
                        folder.toString(),
                        "--behaviour",
                        process,
                        "--seed",
                        "1",
                        "--run",
                        SECONDS,
                        "--track",
                        TRACK));
        // a follower of walls is never done, so the run's own status says nothing
        boolean hasRun = printed.output().contains("ran robots=");
        Event event = Event.of("drive")
                .with("status", hasRun ? ExitStatus.OK : printed.status())
                .with("output", printed.lastLine())
                .with("name", process);
        Path track = folder.resolve(TRACK);
        if (!hasRun || !Files.exists(track)) {
            return event;
        }
        List<Wall> walls = walls(tools.jar("simrobot.jar", List.of("--world", world, "--print-world"))
                .output());
        return figures(event, Files.readAllLines(track), walls);
    }

    private static List<Wall> walls(String printed) {
        List<Wall> walls = new ArrayList<>();
        for (String line : printed.lines().toList()) {
            String[] words = line.split(",");
            if (words[0].equals("line")) {
                walls.add(new Wall(metres(words[1]), metres(words[2]), metres(words[3]), metres(words[4])));
            }
        }
        return walls;
    }

    private static double metres(String millimetres) {
        return Double.parseDouble(millimetres) * MILLI;
    }

    private static Event figures(Event event, List<String> rows, List<Wall> walls) {
        double travelled = 0;
        int counted = 0;
        int near = 0;
        int far = 0;
        int collisions = 0;
        double lastX = Double.NaN;
        double lastY = Double.NaN;
        for (String row : rows.subList(1, rows.size())) {
            String[] words = row.split(",");
            double x = Double.parseDouble(words[2]);
            double y = Double.parseDouble(words[3]);
            travelled += Double.isNaN(lastX) ? 0 : Math.hypot(x - lastX, y - lastY);
            lastX = x;
            lastY = y;
            collisions += words[5].equals("Collision") ? 1 : 0;
            if (Double.parseDouble(words[1]) >= BEGIN_SECONDS) {
                double distance = walls.stream()
                        .mapToDouble(wall -> wall.distance(x, y))
                        .min()
                        .orElse(Double.POSITIVE_INFINITY);
                counted++;
                near += distance < NEAR_METERS ? 1 : 0;
                far += distance > FAR_METERS ? 1 : 0;
            }
        }
        return event.with("travelled", String.format(Locale.ROOT, "%.2f", travelled))
                .with("collisions", collisions)
                .with("near", share(near, counted))
                .with("far", share(far, counted));
    }

    private static String share(int part, int whole) {
        return String.format(Locale.ROOT, "%.1f", whole == 0 ? PERCENT : PERCENT * part / whole);
    }
}
