package simrobot.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetWriter;
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

    static void write(World world, OctetWriter out) {
        out.text(world.name());
        list(out, world.segments(), WorldCodec::segment);
        list(out, world.points(), WorldCodec::position);
        out.real(world.pointDiameterMeters());
        list(out, world.boxes(), (o, box) -> area(o.text(box.name()), box.area()));
        list(out, world.homes(), WorldCodec::home);
        list(out, world.forbiddenLines(), WorldCodec::segment);
        list(out, world.forbiddenAreas(), WorldCodec::area);
        list(out, world.treadmills(), WorldCodec::treadmill);
        list(out, world.goals(), WorldCodec::goal);
    }

    static World read(OctetReader<DamagedException> in) {
        try {
            return new World(
                    in.text(),
                    list(in, WorldCodec::segment),
                    list(in, WorldCodec::position),
                    in.real(),
                    list(in, i -> new Box(i.text(), area(i))),
                    list(in, WorldCodec::home),
                    list(in, WorldCodec::segment),
                    list(in, WorldCodec::area),
                    list(in, i -> new Treadmill(area(i), i.real(), i.real())),
                    list(in, i -> new Goal(i.text(), i.text(), position(i), i.real())));
        } catch (IllegalArgumentException impossible) {
            throw new DamagedException("a world with " + impossible.getMessage());
        }
    }

    private static <T> void list(OctetWriter out, List<T> items, BiConsumer<OctetWriter, T> writer) {
        out.compact(items.size());
        items.forEach(item -> writer.accept(out, item));
    }

    private static <T> List<T> list(
            OctetReader<DamagedException> in, Function<OctetReader<DamagedException>, T> reader) {
        int count = in.count();
        List<T> items = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            items.add(reader.apply(in));
        }
        return items;
    }

    private static void position(OctetWriter out, Position position) {
        out.real(position.xMeters()).real(position.yMeters());
    }

    private static Position position(OctetReader<DamagedException> in) {
        return new Position(in.real(), in.real());
    }

    private static void segment(OctetWriter out, Segment segment) {
        out.real(segment.x1Meters()).real(segment.y1Meters());
        out.real(segment.x2Meters()).real(segment.y2Meters());
    }

    private static Segment segment(OctetReader<DamagedException> in) {
        return new Segment(in.real(), in.real(), in.real(), in.real());
    }

    private static void area(OctetWriter out, Area area) {
        out.real(area.minXMeters()).real(area.minYMeters());
        out.real(area.maxXMeters()).real(area.maxYMeters());
        out.real(area.rotationRadians());
    }

    private static Area area(OctetReader<DamagedException> in) {
        return new Area(in.real(), in.real(), in.real(), in.real(), in.real());
    }

    private static void home(OctetWriter out, Home home) {
        position(out.text(home.name()), home.position());
        out.real(home.headingRadians()).octet(home.area().isPresent() ? 1 : 0);
        home.area().ifPresent(area -> area(out, area));
    }

    private static Home home(OctetReader<DamagedException> in) {
        String name = in.text();
        Position position = position(in);
        double heading = in.real();
        return new Home(name, position, heading, in.octet("a flag") == 1 ? Optional.of(area(in)) : Optional.empty());
    }

    private static void goal(OctetWriter out, Goal goal) {
        position(out.text(goal.type()).text(goal.name()), goal.position());
        out.real(goal.headingRadians());
    }

    private static void treadmill(OctetWriter out, Treadmill belt) {
        area(out, belt.area());
        out.real(belt.speedMetersPerSecond()).real(belt.directionRadians());
    }
}
