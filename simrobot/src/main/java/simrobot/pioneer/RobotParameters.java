package simrobot.pioneer;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A robot described by a params file of ARIA: text with a {@code Key value} per line; {@code ;} begins a comment. The
 * reader uses the keys of {@link RobotKind}; missing ones have ARIA's default, except the mandatory DistConvFactor.
 *
 * @param subclass the type of the file's robots, by its Subclass or else its name; in lower case
 */
public record RobotParameters(String subclass, RobotKind kind) {
    /** AngleConvFactor 0.001534, rounded in the files: 4096 units per turn. */
    private static final double USUAL_RADIANS_PER_UNIT = 0.001534;

    private static final int LEAST_BITS = 8;
    private static final int MOST_BITS = 16;

    private static final String ENDING = ".p";

    /** @throws IOException if the file cannot be read or describes no robot; the message names what was expected */
    public static RobotParameters read(Path file) throws IOException {
        Map<String, String> values = new HashMap<>();
        for (String line : Files.readString(file, StandardCharsets.ISO_8859_1).split("\\R")) {
            String[] words = line.replaceFirst(";.*", "").strip().split("\\s+", 2);
            if (words.length == 2) {
                values.putIfAbsent(words[0].toLowerCase(Locale.ROOT), words[1]);
            }
        }
        if (!values.containsKey("distconvfactor")) {
            throw new IOException(file + ": no DistConvFactor, expected a params file of ARIA");
        }
        RobotKind kind = new RobotKind(
                number(file, values, "DistConvFactor", 1),
                number(file, values, "RangeConvFactor", 1),
                unitsPerTurn(file, values),
                number(file, values, "VelConvFactor", 1),
                (int) number(file, values, "MaxVelocity", 1000),
                (int) number(file, values, "MaxRVelocity", 180));
        String name = file.getFileName().toString();
        String stem = name.endsWith(ENDING) ? name.substring(0, name.length() - ENDING.length()) : name;
        return new RobotParameters(values.getOrDefault("subclass", stem).toLowerCase(Locale.ROOT), kind);
    }

    private static double number(Path file, Map<String, String> values, String key, double otherwise)
            throws IOException {
        String text = values.get(key.toLowerCase(Locale.ROOT));
        if (text == null) {
            return otherwise;
        }
        try {
            double number = Double.parseDouble(text);
            if (number > 0 && number < 1e6) {
                return number;
            }
        } catch (NumberFormatException notANumber) {
            // reported below, as for any other value
        }
        throw new IOException(file + ": " + key + " " + text + ", expected a number above 0");
    }

    /** The heading's counter of at most 16 bits wraps at a power of two; the factor in the file is rounded. */
    private static int unitsPerTurn(Path file, Map<String, String> values) throws IOException {
        double units = 2 * Math.PI / number(file, values, "AngleConvFactor", USUAL_RADIANS_PER_UNIT);
        long bits = Math.round(Math.log(units) / Math.log(2));
        if (bits < LEAST_BITS || bits > MOST_BITS) {
            throw new IOException(file + ": AngleConvFactor " + values.get("angleconvfactor")
                    + ", expected 0.0000959 to 0.0245 (65536 to 256 units per turn)");
        }
        return 1 << bits;
    }

    /** Returns the kind of robots with this subclass: the file's, if it matches; empty if unknown. */
    static Optional<RobotKind> kindOf(String subclass, Optional<RobotParameters> file) {
        Optional<RobotKind> given = file.filter(
                        parameters -> parameters.subclass().equals(subclass.toLowerCase(Locale.ROOT)))
                .map(RobotParameters::kind);
        return given.isPresent() ? given : RobotKind.named(subclass);
    }
}
