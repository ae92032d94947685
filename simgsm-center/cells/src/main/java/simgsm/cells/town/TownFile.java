package simgsm.cells.town;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads town files: one object a line, {@code #} begins a comment.
 *
 * <pre>tower NAME X Y arfcn=N bsic=N lac=N [site=N] [height=METRES] [power=DBM]</pre>
 */
public final class TownFile {
    private static final int FIRST_SITE = 6969;
    private static final String HEIGHT_METRES = "30";
    private static final String POWER_DBM = "43";

    private TownFile() {}

    /** @throws IOException naming the file, and the line that is wrong with what was expected */
    public static Town read(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
        List<Tower> towers = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).replaceFirst("#.*", "").strip();
            if (!line.isEmpty()) {
                try {
                    towers.add(tower(line.split("\\s+"), FIRST_SITE + towers.size()));
                } catch (IllegalArgumentException e) {
                    throw new IOException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
                }
            }
        }
        if (towers.isEmpty()) {
            throw new IOException(file + ": expected at least one tower");
        }
        return new Town(towers);
    }

    private static Tower tower(String[] words, int site) {
        if (words.length < 4 || !words[0].equals("tower")) {
            throw new IllegalArgumentException(
                    "expected tower NAME X Y arfcn=N bsic=N lac=N, found " + String.join(" ", words));
        }
        Map<String, String> values = new HashMap<>(
                Map.of("height", HEIGHT_METRES, "power", POWER_DBM, "site", Integer.toString(site), "lac", "1"));
        for (int i = 4; i < words.length; i++) {
            int equals = words[i].indexOf('=');
            if (equals <= 0) {
                throw new IllegalArgumentException("expected key=value, found " + words[i]);
            }
            values.put(words[i].substring(0, equals), words[i].substring(equals + 1));
        }
        return new Tower(
                words[1],
                new Place(number("x", words[2]), number("y", words[3])),
                number("height", values.get("height")),
                number("power", values.get("power")),
                whole("arfcn", values.get("arfcn")),
                whole("bsic", values.get("bsic")),
                whole("lac", values.get("lac")),
                whole("site", values.get("site")));
    }

    private static double number(String name, String text) {
        if (text == null || !text.matches("-?[0-9]+(\\.[0-9]+)?")) {
            throw new IllegalArgumentException(name + ": expected a number, found " + text);
        }
        return Double.parseDouble(text);
    }

    private static int whole(String name, String text) {
        if (text == null || !text.matches("[0-9]{1,6}")) {
            throw new IllegalArgumentException(name + ": expected a whole number, found " + text);
        }
        return Integer.parseInt(text);
    }
}
