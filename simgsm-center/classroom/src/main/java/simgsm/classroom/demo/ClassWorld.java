package simgsm.classroom.demo;

import java.util.Locale;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The world of a class: an identical lane for each student, between walls, in columns that fill a wide window. A box
 * closes the right half of a lane 2.45 m ahead of the robot's front, before the goal. Millimetres.
 */
public record ClassWorld(int students) {
    private static final int LENGTH = 6_200;
    private static final int WIDTH = 2_000;
    private static final int START_X = 1_200;
    private static final int START_Y = 600;
    private static final int BOX_X = 3_900;
    private static final int BOX_LENGTH = 300;
    private static final int BOX_WIDTH = 1_000;
    private static final int GOAL_X = 5_200;
    private static final int GOAL_Y = 1_000;
    /** Width to height of the demo's floor within its margins, rounded up: more columns leave larger lanes. */
    private static final double ASPECT = 2.5;

    private static final double PER_METER = 1_000;

    private int columns() {
        return (int) Math.max(1, Math.round(Math.sqrt(students * ASPECT * WIDTH / LENGTH)));
    }

    private int rows() {
        return (students + columns() - 1) / columns();
    }

    /** The left end of a student's lane; counted from 0, down each column. */
    private int x(int student) {
        return student / rows() * LENGTH;
    }

    private int y(int student) {
        return (rows() - 1 - student % rows()) * WIDTH;
    }

    public double goalXMeters(int student) {
        return (x(student) + GOAL_X) / PER_METER;
    }

    public double goalYMeters(int student) {
        return (y(student) + GOAL_Y) / PER_METER;
    }

    /** The world as ARIA's {@code .map}, with the students' homes in their order. */
    public String map() {
        return lines("2D-Map\n", this::things) + lines("LINES\n", this::walls);
    }

    private String lines(String head, IntFunction<String> lane) {
        return IntStream.range(0, students).mapToObj(lane).collect(Collectors.joining("", head, ""));
    }

    private String things(int student) {
        int left = x(student);
        int right = y(student);
        int box = left + BOX_X;
        return cairn("RobotHome", left + START_X, right + START_Y, ClassRoll.name(student), "")
                + cairn("GoalWithHeading", left + GOAL_X, right + GOAL_Y, "Exit", "")
                + cairn(
                        "Sim.BoxObstacle",
                        box + BOX_LENGTH / 2,
                        right + BOX_WIDTH / 2,
                        "",
                        String.format(Locale.ROOT, " %d %d %d %d", box, right, box + BOX_LENGTH, right + BOX_WIDTH));
    }

    private static String cairn(String kind, int x, int y, String name, String corners) {
        return String.format(Locale.ROOT, "Cairn: %s %d %d 0.000000 \"\" ICON \"%s\"%s\n", kind, x, y, name, corners);
    }

    private String walls(int student) {
        int left = x(student);
        int right = y(student);
        int end = left + LENGTH;
        int top = right + WIDTH;
        return String.format(
                Locale.ROOT,
                "%1$d %2$d %3$d %2$d\n%3$d %2$d %3$d %4$d\n%3$d %4$d %1$d %4$d\n%1$d %4$d %1$d %2$d\n",
                left,
                right,
                end,
                top);
    }
}
