package simrobot.source.child;

import java.util.Map;
import java.util.function.Function;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;

/** Senses at one moment, as a line carries them. Ranges have millimetres, other numbers all their digits. */
public final class PipeSenses implements Senses {
    private static final int BUMPERS = 5;

    private static final Map<String, Function<Senses, Object>> VALUES = Map.ofEntries(
            Map.entry("seconds", Senses::seconds),
            Map.entry("x", Senses::xMeters),
            Map.entry("y", Senses::yMeters),
            Map.entry("heading", Senses::headingRadians),
            Map.entry("odometryX", live -> live.odometry().xMeters()),
            Map.entry("odometryY", live -> live.odometry().yMeters()),
            Map.entry("odometryHeading", live -> live.odometry().headingRadians()),
            Map.entry("speed", Senses::metersPerSecond),
            Map.entry("blocked", live -> live.isBlocked() ? 1 : 0),
            Map.entry("front", live -> bits(live::isFrontBumperPressed)),
            Map.entry("rear", live -> bits(live::isRearBumperPressed)),
            Map.entry("arrived", live -> live.hasArrived() ? 1 : 0),
            Map.entry("caller", live -> live.call().caller()),
            Map.entry("key", live -> Character.toString(live.call().key())),
            Map.entry("pressed", live -> live.call().pressed()));

    private final PipeLine line;
    /** Null until they are asked for. */
    private double[] sonars;

    private double[] laser;

    PipeSenses(PipeLine line) {
        this.line = line;
    }

    /** Returns the line that asks a child for a decision. @param live read on the thread that owns the robot */
    public static String line(int robot, Senses live, boolean withLaser) {
        StringBuilder line = new StringBuilder(1500).append("decide robot=").append(robot);
        VALUES.forEach((name, value) -> line.append(PipeLine.of("", name, value.apply(live))));
        append(line, "sonar", SONARS, live::sonarMeters);
        if (withLaser && hasLaser(live)) {
            append(line, "laser", LASER_READINGS, live::laserMeters);
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

    private double[] ranges(String name) {
        return Stream.of(line.values().get(name).split(","))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    @Override
    public double sonarMeters(int sonar) {
        if (sonars == null) {
            sonars = ranges("sonar");
        }
        return sonars[sonar];
    }

    @Override
    public double laserMeters(int reading) {
        if (laser == null) {
            if (!line.values().containsKey("laser")) {
                throw new UnsupportedOperationException("this robot has no laser, expected sonarMeters");
            }
            laser = ranges("laser");
        }
        return laser[reading];
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return line.values().get("front").charAt(bumper) == '1';
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return line.values().get("rear").charAt(bumper) == '1';
    }

    @Override
    public double xMeters() {
        return line.number("x");
    }

    @Override
    public double yMeters() {
        return line.number("y");
    }

    @Override
    public double headingRadians() {
        return line.number("heading");
    }

    @Override
    public OdometryPose odometry() {
        return new OdometryPose(line.number("odometryX"), line.number("odometryY"), line.number("odometryHeading"));
    }

    @Override
    public boolean hasArrived() {
        return line.flag("arrived");
    }

    @Override
    public Call call() {
        return new Call(line.text("caller"), line.text("key").charAt(0), line.text("pressed"));
    }

    @Override
    public double metersPerSecond() {
        return line.number("speed");
    }

    @Override
    public boolean isBlocked() {
        return line.flag("blocked");
    }

    @Override
    public double seconds() {
        return line.number("seconds");
    }
}
