package simrobot.source.child;

import java.util.Map;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;

/** Reads and writes senses as a line. Ranges have millimetres, other numbers all their digits. */
public final class PipeSenses {
    private static final int BUMPERS = 5;

    private static final Map<String, Function<Measurements, Object>> VALUES = Map.ofEntries(
            Map.entry("seconds", Measurements::seconds),
            Map.entry("x", Measurements::xMeters),
            Map.entry("y", Measurements::yMeters),
            Map.entry("heading", Measurements::headingRadians),
            Map.entry("odometryX", now -> now.odometry().xMeters()),
            Map.entry("odometryY", now -> now.odometry().yMeters()),
            Map.entry("odometryHeading", now -> now.odometry().headingRadians()),
            Map.entry("speed", Measurements::metersPerSecond),
            Map.entry("blocked", now -> now.isBlocked() ? 1 : 0),
            Map.entry("front", Measurements::front),
            Map.entry("rear", Measurements::rear),
            Map.entry("arrived", now -> now.hasArrived() ? 1 : 0),
            Map.entry("caller", now -> now.call().caller()),
            Map.entry("key", now -> Character.toString(now.call().key())),
            Map.entry("pressed", now -> now.call().pressed()));

    private PipeSenses() {}

    /** Returns the senses of a robot that decides without a line. @param ranges applied to the ranges of each array */
    public static Measurements of(Senses live, UnaryOperator<IntToDoubleFunction> ranges) {
        return new Measurements(
                live.seconds(),
                live.xMeters(),
                live.yMeters(),
                live.headingRadians(),
                live.odometry(),
                live.metersPerSecond(),
                live.isBlocked(),
                live.hasArrived(),
                live.call(),
                bits(live::isFrontBumperPressed),
                bits(live::isRearBumperPressed),
                ranges.apply(live::sonarMeters),
                ranges.apply(live::laserMeters));
    }

    /** Returns the senses that a line carries. */
    static Measurements parse(PipeLine line) {
        return new Measurements(
                line.number("seconds"),
                line.number("x"),
                line.number("y"),
                line.number("heading"),
                new OdometryPose(line.number("odometryX"), line.number("odometryY"), line.number("odometryHeading")),
                line.number("speed"),
                line.flag("blocked"),
                line.flag("arrived"),
                new Call(line.text("caller"), line.text("key").charAt(0), line.text("pressed")),
                line.values().get("front"),
                line.values().get("rear"),
                ranges(line, "sonar"),
                line.values().containsKey("laser") ? ranges(line, "laser") : PipeSenses::noLaser);
    }

    private static IntToDoubleFunction ranges(PipeLine line, String name) {
        double[] meters = Stream.of(line.values().get(name).split(","))
                .mapToDouble(Double::parseDouble)
                .toArray();
        return i -> meters[i];
    }

    private static double noLaser(int reading) {
        throw new UnsupportedOperationException("this robot has no laser, expected sonarMeters");
    }

    /** Returns the line that asks a child for a decision. @param live read on the thread that owns the robot */
    public static String line(int robot, Senses live, boolean withLaser) {
        StringBuilder line = new StringBuilder(1500).append("decide robot=").append(robot);
        Measurements now = of(live, ranges -> ranges);
        VALUES.forEach((name, value) -> line.append(PipeLine.of("", name, value.apply(now))));
        append(line, "sonar", Senses.SONARS, live::sonarMeters);
        if (withLaser && hasLaser(live)) {
            append(line, "laser", Senses.LASER_READINGS, live::laserMeters);
        }
        return line.toString();
    }

    private static boolean hasLaser(Senses live) {
        try {
            live.laserMeters(0);
            return true;
        } catch (UnsupportedOperationException none) {
            return false;
        }
    }

    private static String bits(IntPredicate isPressed) {
        return IntStream.range(0, BUMPERS)
                .mapToObj(i -> isPressed.test(i) ? "1" : "0")
                .collect(Collectors.joining());
    }

    /** Writes millimetres digit by digit, for the text of a double takes a hundred times as long. */
    private static void append(StringBuilder line, String name, int count, IntToDoubleFunction ranges) {
        line.append(' ').append(name);
        for (int i = 0; i < count; i++) {
            long millimeters = Math.round(ranges.applyAsDouble(i) * 1000);
            line.append(i == 0 ? '=' : ',').append(millimeters / 1000).append('.');
            line.append((char) ('0' + millimeters / 100 % 10))
                    .append((char) ('0' + millimeters / 10 % 10))
                    .append((char) ('0' + millimeters % 10));
        }
    }
}
