package simrobot.camera;

import java.util.ArrayList;
import java.util.List;
import simrobot.world.Goal;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * Draws landmarks: posters on long walls, each with a unique pattern; numbers next to doors, which are gaps between two
 * walls in line; a flag on each goal, in one of eight colours. They depend on the world alone, so a place looks the
 * same in every run, and neither wheels nor sonars detect them.
 */
final class SignPainter {
    private static final double RANGE_METERS = 15;
    private static final double OFF_WALL_METERS = 0.006;

    private static final double POSTER_METERS = 0.32;
    private static final double POSTER_LOW_METERS = 0.4;
    private static final double POSTER_RIM_METERS = 0.025;
    private static final int POSTER_CELLS = 4;
    private static final double FIRST_POSTER_METERS = 0.9;
    private static final double BETWEEN_POSTERS_METERS = 2.5;

    private static final double LEAST_DOOR_METERS = 0.6;
    private static final double MOST_DOOR_METERS = 1.6;
    private static final double IN_LINE_METERS = 0.02;
    private static final double SIGN_METERS = 0.18;
    private static final double SIGN_LOW_METERS = 0.5;
    private static final double SIGN_HIGH_METERS = 0.62;
    private static final double BESIDE_DOOR_METERS = 0.1;
    /** Maximum number of walls searched for doors; scans have thousands, and no doors in line. */
    private static final int MOST_WALLS_WITH_DOORS = 1_000;

    private static final double FLAG_LOW_METERS = 0.38;
    private static final double POLE_METERS = 0.56;
    private static final double FLAG_LENGTH_METERS = 0.24;
    private static final double POLE_HALF_METERS = 0.012;

    /** Colours not used by robots, walls and floors. */
    private static final int[] COLOURS = {0x2E8B57, 0xE0A91B, 0x2B6CB8, 0xD9772B, 0x6A4FB0, 0x1F9A9A, 0x8A9A1B, 0x4A4A4A
    };

    private static final int PAPER = 0xF6F3EA;
    private static final int INK = 0x23262B;
    private static final int SIGN = 0x2F4B6E;
    private static final int POLE = 0x8A8F96;

    /** Digits of 3 by 5 dots, row by row from the top; the highest of 15 bits is the first. */
    private static final int[] DIGITS = {
        0b111101101101111, 0b010110010010111, 0b111001111100111, 0b111001111001111, 0b101101111001001,
        0b111100111001111, 0b111100111101111, 0b111001010010010, 0b111101111101111, 0b111101111001111
    };

    /** An upright plate. */
    private record Plate(double x1, double y1, double x2, double y2, double low, double high, Texture surface) {}

    private final List<Plate> plates = new ArrayList<>();

    SignPainter(World world) {
        List<Segment> walls = world.items(Segment.class);
        walls.forEach(this::posters);
        if (walls.size() <= MOST_WALLS_WITH_DOORS) {
            doors(walls);
        }
        for (int i = 0; i < world.items(Goal.class).size(); i++) {
            flag(world.items(Goal.class).get(i), COLOURS[i % COLOURS.length]);
        }
    }

    void paint(PixelBuffer canvas, PinholeView eye) {
        FacePainter painter = new FacePainter(canvas, eye);
        for (Plate plate : plates) {
            if (eye.mayShow(plate.x1, plate.y1, POSTER_METERS, RANGE_METERS)) {
                painter.upright(plate.x1, plate.y1, plate.x2, plate.y2, plate.low, plate.high, plate.surface);
            }
        }
    }

    /**
     * Draws a plate on each side of the wall.
     *
     * @param from along the wall, metres
     */
    private void onBothSides(Segment wall, double from, double width, double low, double high, Texture... surfaces) {
        double length = length(wall);
        double ux = (wall.x2Meters() - wall.x1Meters()) / length;
        double uy = (wall.y2Meters() - wall.y1Meters()) / length;
        for (int side = 0; side < 2; side++) {
            double off = side == 0 ? OFF_WALL_METERS : -OFF_WALL_METERS;
            // seen from its side, a plate begins at the left
            double begin = side == 0 ? from + width : from;
            double end = side == 0 ? from : from + width;
            plates.add(new Plate(
                    wall.x1Meters() + begin * ux - off * uy,
                    wall.y1Meters() + begin * uy + off * ux,
                    wall.x1Meters() + end * ux - off * uy,
                    wall.y1Meters() + end * uy + off * ux,
                    low,
                    high,
                    surfaces[side % surfaces.length]));
        }
    }

    private static double length(Segment wall) {
        return Math.hypot(wall.x2Meters() - wall.x1Meters(), wall.y2Meters() - wall.y1Meters());
    }

    // ---- posters ---------------------------------------------------------------------------------------------------

    private void posters(Segment wall) {
        double length = length(wall);
        int number = 0;
        for (double at = FIRST_POSTER_METERS; at + POSTER_METERS < length; at += BETWEEN_POSTERS_METERS) {
            int seed = 31 * wall.hashCode() + number++;
            onBothSides(
                    wall,
                    at - POSTER_METERS / 2,
                    POSTER_METERS,
                    POSTER_LOW_METERS,
                    POSTER_LOW_METERS + POSTER_METERS,
                    poster(scattered(seed)),
                    poster(scattered(~seed)));
        }
    }

    /** Maps similar numbers to unlike ones (the finalizer of MurmurHash3). */
    private static int scattered(int number) {
        int h = number ^ number >>> 16;
        h *= 0x85EBCA6B;
        h ^= h >>> 13;
        h *= 0xC2B2AE35;
        return h ^ h >>> 16;
    }

    /** A poster of 4 by 4 fields, coloured or white by the low 16 bits. */
    private static Texture poster(int bits) {
        int colour = COLOURS[bits >>> 16 & COLOURS.length - 1];
        double field = (POSTER_METERS - 2 * POSTER_RIM_METERS) / POSTER_CELLS;
        return (along, up) -> {
            double x = (along - POSTER_RIM_METERS) / field;
            double y = (up - POSTER_LOW_METERS - POSTER_RIM_METERS) / field;
            boolean isRim = x < 0 || y < 0 || x >= POSTER_CELLS || y >= POSTER_CELLS;
            return isRim ? INK : (bits >> (int) y * POSTER_CELLS + (int) x & 1) != 0 ? colour : PAPER;
        };
    }

    // ---- doors -----------------------------------------------------------------------------------------------------

    private void doors(List<Segment> walls) {
        int number = 1;
        for (int i = 0; i < walls.size(); i++) {
            for (int j = 0; j < walls.size(); j++) {
                Segment wall = walls.get(i);
                if (i != j && length(wall) > SIGN_METERS + 2 * BESIDE_DOOR_METERS && isDoor(wall, walls.get(j))) {
                    double from = length(wall) - BESIDE_DOOR_METERS - SIGN_METERS;
                    onBothSides(wall, from, SIGN_METERS, SIGN_LOW_METERS, SIGN_HIGH_METERS, sign(number++));
                }
            }
        }
    }

    /** True if the other wall continues this one's line after a gap at its second end. */
    private static boolean isDoor(Segment wall, Segment other) {
        double length = length(wall);
        double ux = (wall.x2Meters() - wall.x1Meters()) / length;
        double uy = (wall.y2Meters() - wall.y1Meters()) / length;
        double first = (other.x1Meters() - wall.x2Meters()) * ux + (other.y1Meters() - wall.y2Meters()) * uy;
        double second = (other.x2Meters() - wall.x2Meters()) * ux + (other.y2Meters() - wall.y2Meters()) * uy;
        double offFirst = (other.y1Meters() - wall.y2Meters()) * ux - (other.x1Meters() - wall.x2Meters()) * uy;
        double offSecond = (other.y2Meters() - wall.y2Meters()) * ux - (other.x2Meters() - wall.x2Meters()) * uy;
        double gap = Math.min(first, second);
        return Math.max(Math.abs(offFirst), Math.abs(offSecond)) < IN_LINE_METERS
                && gap >= LEAST_DOOR_METERS
                && gap <= MOST_DOOR_METERS;
    }

    /** A blue plate with a white number of one or two digits. */
    private static Texture sign(int number) {
        String digits = Integer.toString(number % 100);
        double dot = SIGN_METERS / (4 * digits.length() + 3);
        double left = 2 * dot;
        double top = (SIGN_LOW_METERS + SIGN_HIGH_METERS) / 2 + 2.5 * dot;
        return (along, up) -> {
            int column = (int) Math.floor((along - left) / dot);
            int row = (int) Math.floor((top - up) / dot);
            boolean isOutside = column < 0 || row < 0 || row >= 5 || column / 4 >= digits.length() || column % 4 == 3;
            boolean isDot =
                    !isOutside && (DIGITS[digits.charAt(column / 4) - '0'] >> 14 - row * 3 - column % 4 & 1) != 0;
            return isDot ? PAPER : SIGN;
        };
    }

    // ---- goals -----------------------------------------------------------------------------------------------------

    private void flag(Goal goal, int colour) {
        double x = goal.position().xMeters();
        double y = goal.position().yMeters();
        for (int i = 0; i < 2; i++) {
            double dx = i == 0 ? 1 : 0;
            double dy = 1 - dx;
            plates.add(new Plate(
                    x - dx * POLE_HALF_METERS,
                    y - dy * POLE_HALF_METERS,
                    x + dx * POLE_HALF_METERS,
                    y + dy * POLE_HALF_METERS,
                    0,
                    POLE_METERS,
                    Texture.plain(POLE)));
            plates.add(new Plate(
                    x,
                    y,
                    x + dx * FLAG_LENGTH_METERS,
                    y + dy * FLAG_LENGTH_METERS,
                    FLAG_LOW_METERS,
                    POLE_METERS,
                    Texture.plain(colour)));
        }
    }

    /** The colour of a goal. @param index in the world's list */
    static int goalColour(int index) {
        return COLOURS[index % COLOURS.length];
    }
}
