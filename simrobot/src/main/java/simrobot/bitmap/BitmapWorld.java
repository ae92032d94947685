package simrobot.bitmap;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.file.Utf8Text;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldBuilder;
import simrobot.world.WorldReader;

/**
 * Reads worlds, and also pictures of floors: a ROS {@code map.yaml} with its PGM or PNG (keys {@code image},
 * {@code resolution}, {@code origin}, {@code negate}, {@code occupied_thresh}), or a PNG or PGM alone with a given resolution.
 * Occupied areas become walls along their outlines; unknown ones are free. Single cells become points.
 */
public final class BitmapWorld {
    /** Default of the key, as in map_server's usual files. */
    private static final double OCCUPIED = 0.65;

    private static final Pattern KEY = Pattern.compile("^([a-z_]+)\\s*:\\s*(.*?)\\s*(#.*)?$");

    private final String name;
    private final GrayPicture picture;
    private final double cellMeters;
    private final double occupied;
    private final boolean negate;
    private final double x;
    private final double y;
    private final double cos;
    private final double sin;

    private BitmapWorld(
            String name, GrayPicture picture, double cellMeters, double occupied, boolean negate, double[] origin) {
        this.name = name;
        this.picture = picture;
        this.cellMeters = cellMeters;
        this.occupied = occupied;
        this.negate = negate;
        x = origin[0];
        y = origin[1];
        cos = Math.cos(origin[2]);
        sin = Math.sin(origin[2]);
    }

    /**
     * Reads a world file of any format, selected by its extension.
     *
     * @param resolutionMeters the width of a pixel of a picture without a map.yaml
     */
    public static World read(Path file, OptionalDouble resolutionMeters) throws IOException {
        String ending =
                String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).replaceFirst(".*\\.", "");
        return switch (ending) {
            case "yaml", "yml" -> ofYaml(file);
            case "png", "pgm" -> {
                if (resolutionMeters.isEmpty()) {
                    throw new PictureFormatException(
                            file.toString(), "a picture without a scale, expected --resolution METRES or a map.yaml");
                }
                double cell = resolutionMeters.getAsDouble();
                yield new BitmapWorld(name(file), picture(file), cell, 0.5, false, new double[3]).world();
            }
            default -> WorldReader.read(file);
        };
    }

    private static String name(Path file) {
        return String.valueOf(file.getFileName());
    }

    private static GrayPicture picture(Path file) throws IOException {
        byte[] octets = WorldReader.octets(file);
        if (PngReader.isOne(octets)) {
            return PngReader.read(file.toString(), octets);
        }
        if (PgmReader.isOne(octets)) {
            return PgmReader.read(file.toString(), octets);
        }
        throw new PictureFormatException(file.toString(), "neither PNG nor PGM, expected one of the two");
    }

    // ---- map.yaml --------------------------------------------------------------------------------------------------

    private static World ofYaml(Path file) throws IOException {
        Map<String, String> keys = keys(file);
        Path image = file.resolveSibling(unquoted(value(file, keys, "image")));
        double[] origin = origin(file, keys);
        double cell = number(file, "resolution", value(file, keys, "resolution"));
        if (!(cell > 0)) {
            throw new PictureFormatException(file.toString(), "resolution " + cell + ", expected metres above 0");
        }
        double occupied = number(file, "occupied_thresh", keys.getOrDefault("occupied_thresh", "" + OCCUPIED));
        boolean negate = number(file, "negate", keys.getOrDefault("negate", "0")) != 0;
        return new BitmapWorld(name(file), picture(image), cell, occupied, negate, origin).world();
    }

    /** The keys of one level; a list that continues on separate lines, as {@code - 1.0}, is joined. */
    private static Map<String, String> keys(Path file) throws IOException {
        Map<String, String> keys = new HashMap<>();
        String last = "";
        for (String line : text(file).lines().toList()) {
            Matcher key = KEY.matcher(line);
            if (key.matches()) {
                last = key.group(1);
                keys.put(last, key.group(2));
            } else if (line.strip().startsWith("-") && !last.isEmpty()) {
                keys.merge(
                        last,
                        line.strip().substring(1).strip(),
                        (all, more) -> all.isEmpty() ? more : all + "," + more);
            }
        }
        return keys;
    }

    private static String text(Path file) throws IOException {
        try {
            return Utf8Text.of(WorldReader.octets(file));
        } catch (CharacterCodingException e) {
            throw new PictureFormatException(file.toString(), e.getMessage());
        }
    }

    private static String value(Path file, Map<String, String> keys, String key) throws PictureFormatException {
        String value = keys.get(key);
        if (value == null || value.isEmpty()) {
            throw new PictureFormatException(
                    file.toString(), "found no " + key + ", expected the keys image, resolution and origin");
        }
        return value;
    }

    private static String unquoted(String text) {
        return text.replaceFirst("^([\"'])(.*)\\1$", "$2");
    }

    private static double[] origin(Path file, Map<String, String> keys) throws PictureFormatException {
        String[] parts =
                value(file, keys, "origin").replaceAll("[\\[\\]]", "").strip().split("\\s*,\\s*");
        if (parts.length < 2 || parts.length > 3) {
            throw new PictureFormatException(
                    file.toString(), "found " + parts.length + " numbers for origin, expected [x, y, yaw]");
        }
        double[] origin = new double[3];
        for (int i = 0; i < parts.length; i++) {
            origin[i] = number(file, "origin", parts[i]);
        }
        return origin;
    }

    private static double number(Path file, String key, String text) throws PictureFormatException {
        try {
            double value = switch (text.toLowerCase(Locale.ROOT)) {
                case "true" -> 1;
                case "false" -> 0;
                default -> Double.parseDouble(text);
            };
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // reported below, as for an infinite one
        }
        throw new PictureFormatException(file.toString(), "found \"" + text + "\" for " + key + ", expected a number");
    }

    // ---- the world -------------------------------------------------------------------------------------------------

    private World world() {
        int width = picture.width();
        int height = picture.height();
        BitSet cells = new BitSet(width * height);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int value = picture.at(column, height - 1 - row);
                double dark = (negate ? value : 255 - value) / 255.0;
                cells.set(row * width + column, dark > occupied);
            }
        }
        WorldBuilder world = new WorldBuilder(name).pointDiameter(cellMeters);
        List<int[]> outlines = new OutlineTracer(width, height, cells).outlines();
        for (int[] outline : outlines) {
            if (isCell(outline)) {
                Position middle = place((outline[0] + outline[4]) / 2.0, (outline[1] + outline[5]) / 2.0);
                world.add(new Point(middle.xMeters(), middle.yMeters()));
            } else {
                for (int i = 0; i < outline.length; i += 2) {
                    int to = (i + 2) % outline.length;
                    world.add(Segment.between(place(outline[i], outline[i + 1]), place(outline[to], outline[to + 1])));
                }
            }
        }
        return world.build();
    }

    private static boolean isCell(int[] outline) {
        return outline.length == 8 && Math.abs(outline[0] - outline[4]) == 1 && Math.abs(outline[1] - outline[5]) == 1;
    }

    /** A position in cells from the lower left corner, rounded to 0.1 mm. */
    private Position place(double column, double row) {
        double dx = column * cellMeters;
        double dy = row * cellMeters;
        return new Position(rounded(x + dx * cos - dy * sin), rounded(y + dx * sin + dy * cos));
    }

    private static double rounded(double meters) {
        return Math.rint(meters * 1e4) / 1e4;
    }
}
