package simrobot.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** The worlds of the speed comparison: a square with inner walls every 8 m, a door of 2 m in each, and homes by chance. */
public final class WanderWorld {
    private static final int ROOM_METERS = 8;

    private WanderWorld() {}

    /** The side of the square for this number of robots. */
    public static int sideMeters(int robots) {
        return robots <= 10 ? 16 : robots <= 100 ? 40 : robots <= 1000 ? 128 : 400;
    }

    /** The world as an ARIA map. */
    public static String map(int robots, long seed) {
        int side = sideMeters(robots);
        List<String> lines = new ArrayList<>(List.of("2D-Map"));
        homes(robots, side, new Random(seed))
                .forEach(home -> lines.add(String.format(
                        Locale.ROOT, "Cairn: RobotHome %.0f %.0f %.0f \"\" ICON \"\"", home[0], home[1], home[2])));
        lines.add("LINES");
        for (int at = 0; at <= side; at += ROOM_METERS) {
            boolean outer = at == 0 || at == side;
            for (int from = 0; from < side; from += ROOM_METERS) {
                if (outer) {
                    wall(lines, at, from, from + 8);
                } else {
                    wall(lines, at, from, from + 3);
                    wall(lines, at, from + 5, from + 8);
                }
            }
        }
        lines.add("DATA");
        return String.join("\n", lines) + "\n";
    }

    /** A wall across and the same one along. */
    private static void wall(List<String> lines, int at, int from, int to) {
        lines.add(at * 1000 + " " + from * 1000 + " " + at * 1000 + " " + to * 1000);
        lines.add(from * 1000 + " " + at * 1000 + " " + to * 1000 + " " + at * 1000);
    }

    private static List<double[]> homes(int robots, int side, Random chance) {
        List<double[]> homes = new ArrayList<>();
        boolean[][] taken = new boolean[side][side];
        while (homes.size() < robots) {
            int column = chance.nextInt(side);
            int row = chance.nextInt(side);
            boolean nearWall = column % ROOM_METERS == 0
                    || row % ROOM_METERS == 0
                    || column % ROOM_METERS == ROOM_METERS - 1
                    || row % ROOM_METERS == ROOM_METERS - 1;
            if (!nearWall && !taken[column][row]) {
                taken[column][row] = true;
                homes.add(new double[] {column * 1000 + 500, row * 1000 + 500, chance.nextInt(360) - 180});
            }
        }
        return homes;
    }
}
