package simrobot.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** A world as octets, every number to its last bit, so that it is the same world whatever a map file could say. */
final class WorldCodec {
    private WorldCodec() {}

    static void write(World world, RecordingWriter out) {
        out.text(world.name());
        list(out, world.segments(), WorldCodec::segment);
        list(out, world.points(), WorldCodec::position);
        out.exact(world.pointDiameterMeters());
        list(out, world.boxes(), (o, box) -> area(o.text(box.name()), box.area()));
        list(out, world.homes(), WorldCodec::home);
        list(out, world.forbiddenLines(), WorldCodec::segment);
        list(out, world.forbiddenAreas(), WorldCodec::area);
        list(out, world.treadmills(), WorldCodec::treadmill);
        list(out, world.goals(), WorldCodec::goal);
    }

    static World read(RecordingReader in) {
        try {
            return new World(
                    in.text(),
                    list(in, WorldCodec::segment),
                    list(in, WorldCodec::position),
                    in.exact(),
                    list(in, i -> new Box(i.text(), area(i))),
                    list(in, WorldCodec::home),
                    list(in, WorldCodec::segment),
                    list(in, WorldCodec::area),
                    list(in, i -> new Treadmill(area(i), i.exact(), i.exact())),
                    list(in, i -> new Goal(i.text(), i.text(), position(i), i.exact())));
        } catch (IllegalArgumentException impossible) {
            throw new DamagedException("a world with " + impossible.getMessage());
        }
    }

    private static <T> void list(RecordingWriter out, List<T> items, BiConsumer<RecordingWriter, T> writer) {
        out.number(items.size());
        items.forEach(item -> writer.accept(out, item));
    }

    private static <T> List<T> list(RecordingReader in, Function<RecordingReader, T> reader) {
        int count = in.count();
        List<T> items = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            items.add(reader.apply(in));
        }
        return items;
    }

    private static void position(RecordingWriter out, Position position) {
        out.exact(position.xMeters()).exact(position.yMeters());
    }

    private static Position position(RecordingReader in) {
        return new Position(in.exact(), in.exact());
    }

    private static void segment(RecordingWriter out, Segment segment) {
        out.exact(segment.x1Meters()).exact(segment.y1Meters());
        out.exact(segment.x2Meters()).exact(segment.y2Meters());
    }

    private static Segment segment(RecordingReader in) {
        return new Segment(in.exact(), in.exact(), in.exact(), in.exact());
    }

    private static void area(RecordingWriter out, Area area) {
        out.exact(area.minXMeters()).exact(area.minYMeters());
        out.exact(area.maxXMeters()).exact(area.maxYMeters());
        out.exact(area.rotationRadians());
    }

    private static Area area(RecordingReader in) {
        return new Area(in.exact(), in.exact(), in.exact(), in.exact(), in.exact());
    }

    private static void home(RecordingWriter out, Home home) {
        position(out.text(home.name()), home.position());
        out.exact(home.headingRadians()).octet(home.area().isPresent() ? 1 : 0);
        home.area().ifPresent(area -> area(out, area));
    }

    private static Home home(RecordingReader in) {
        String name = in.text();
        Position position = position(in);
        double heading = in.exact();
        return new Home(name, position, heading, in.octet() == 1 ? Optional.of(area(in)) : Optional.empty());
    }

    private static void goal(RecordingWriter out, Goal goal) {
        position(out.text(goal.type()).text(goal.name()), goal.position());
        out.exact(goal.headingRadians());
    }

    private static void treadmill(RecordingWriter out, Treadmill belt) {
        area(out, belt.area());
        out.exact(belt.speedMetersPerSecond()).exact(belt.directionRadians());
    }
}
