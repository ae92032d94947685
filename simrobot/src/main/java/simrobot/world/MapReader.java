package simrobot.world;

import java.util.List;
import java.util.Optional;

/**
 * Reads ARIA's {@code .map}: a first line {@code 2D-Map}, headers {@code Key: value} in any order, then {@code LINES} with a
 * wall per line and {@code DATA} with a point per line, millimetres and degrees.
 *
 * <p>Counts and bounds in the headers are ignored, as in ARIA. Unknown headers and unknown cairns are skipped.
 */
public final class MapReader {
    private static final String MAGIC = "2D-Map";

    private enum Section {
        HEADER,
        LINES,
        DATA
    }

    private final String source;
    private final WorldBuilder world;
    private Section section = Section.HEADER;

    private MapReader(String source) {
        this.source = source;
        world = new WorldBuilder(source);
    }

    /**
     * Reads a world from a text.
     *
     * @param source named in errors and as the world's name
     */
    public static World read(String source, String text) throws WorldFormatException {
        List<String> lines = text.lines().toList();
        if (lines.isEmpty() || !lines.get(0).strip().startsWith(MAGIC)) {
            String found = lines.isEmpty() ? "an empty file" : '"' + brief(lines.get(0)) + '"';
            throw new WorldFormatException(
                    source,
                    1,
                    found,
                    '"' + MAGIC
                            + "\" of an ARIA .map; also read are Saphira .wld, ROS map.yaml with PGM or PNG, and PNG"
                            + " with --resolution METRES");
        }
        MapReader reader = new MapReader(source);
        for (int i = 1; i < lines.size(); i++) {
            reader.accept(i + 1, lines.get(i).strip());
        }
        return reader.world.build();
    }

    private void accept(int number, String line) throws WorldFormatException {
        if (line.isEmpty() || line.startsWith("#") || line.startsWith(";")) {
            return;
        }
        if (!opensSection(line)) {
            LineTokens tokens = new LineTokens(source, number, section == Section.HEADER ? headerValue(line) : line);
            switch (section) {
                case HEADER -> header(line, tokens);
                case LINES -> wall(tokens);
                case DATA -> point(tokens);
            }
        }
    }

    /**
     * True if the line opens a section; maps with several kinds of scan name theirs {@code <kind>LINES} and {@code
     * <kind>DATA}.
     */
    private boolean opensSection(String line) {
        if (line.endsWith("LINES") && isWord(line)) {
            section = Section.LINES;
            return true;
        }
        if (line.endsWith("DATA") && isWord(line)) {
            section = Section.DATA;
            return true;
        }
        return false;
    }

    private static boolean isWord(String line) {
        return line.chars().allMatch(c -> Character.isLetterOrDigit(c) || c == '_');
    }

    /** The value of a used header; empty for others, which may contain anything, even an open quote. */
    private static String headerValue(String line) {
        String value = line.substring(line.indexOf(':') + 1).strip();
        boolean isRead = switch (key(line)) {
            case "Resolution" -> true;
            case "Cairn" -> ItemKinds.ofCairn(firstWord(value)).isPresent();
            default -> false;
        };
        return isRead ? value : "";
    }

    private static String firstWord(String text) {
        return text.split("\\s", 2)[0];
    }

    private static String key(String line) {
        int colon = line.indexOf(':');
        return colon < 0 ? "" : line.substring(0, colon).strip();
    }

    private void header(String line, LineTokens tokens) throws WorldFormatException {
        if (line.indexOf(':') < 0) {
            throw tokens.fault('"' + brief(line) + '"', "a header \"Key: value\", LINES or DATA");
        }
        switch (key(line)) {
            case "Cairn" -> cairn(tokens);
            case "Resolution" -> resolution(tokens);
            default -> {
                // counts, bounds, origins, headers of other programs
            }
        }
    }

    private void resolution(LineTokens tokens) throws WorldFormatException {
        double meters = tokens.meters("the resolution");
        if (meters < 0) {
            throw tokens.fault("a negative resolution", "0 mm or more");
        }
        world.pointDiameter(Math.min(meters, 0.1));
    }

    private void wall(LineTokens tokens) throws WorldFormatException {
        world.add(new Segment(tokens.meters("x1"), tokens.meters("y1"), tokens.meters("x2"), tokens.meters("y2")));
        tokens.end();
    }

    private void point(LineTokens tokens) throws WorldFormatException {
        world.add(new Point(tokens.meters("x"), tokens.meters("y")));
        // some maps carry a third column, the reflectance
        if (tokens.hasMore()) {
            tokens.number("a point's third number");
        }
        tokens.end();
    }

    private void cairn(LineTokens tokens) throws WorldFormatException {
        if (!tokens.hasMore()) {
            return;
        }
        String type = tokens.word("a cairn's type");
        Optional<ItemKind<?>> kind = ItemKinds.ofCairn(type);
        if (kind.isPresent()) {
            world.add(kind.get().read(new Cairn(type, tokens)));
        }
    }

    private static String brief(String line) {
        return line.length() > 40 ? line.substring(0, 40) + "..." : line;
    }
}
