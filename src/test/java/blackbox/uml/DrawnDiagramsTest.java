package blackbox.uml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;

/** Every diagram has been drawn as SVG from its present source. */
class DrawnDiagramsTest {
    /** PlantUML puts the source into the SVG: deflated, six bits a character. */
    private static final Pattern SOURCE = Pattern.compile("<\\?plantuml-src (\\S+?)\\?>");

    private static final String SIX_BITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz-_";

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(Diagram.FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".puml"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void everySvgIsDrawnFromTheSourceBesideIt() throws IOException {
        assertTrue(sources().size() >= 20, sources().toString());
        for (Path source : sources()) {
            Path svg = source.resolveSibling(source.getFileName().toString().replace(".puml", ".svg"));
            String text = Files.exists(svg) ? Files.readString(svg) : "";
            assertFalse(text.contains("has crashed"), svg + ": PlantUML could not draw it");
            Matcher drawn = SOURCE.matcher(text);
            assertTrue(drawn.find(), svg + ": not drawn; mvn -N -Puml exec:java draws it");
            assertEquals(
                    body(Files.readString(source)),
                    body(inflated(drawn.group(1))),
                    svg + ": drawn from an older source; mvn -N -Puml exec:java draws it again");
        }
    }

    /** The lines between {@code @startuml} and {@code @enduml}. */
    private static String body(String source) {
        return source.lines()
                .filter(line -> !line.startsWith("@startuml") && !line.startsWith("@enduml"))
                .map(String::stripTrailing)
                .reduce("", (all, line) -> all + line + "\n")
                .strip();
    }

    private static String inflated(String encoded) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        for (int i = 0; i < encoded.length(); i += 4) {
            int bits = 0;
            for (int j = i; j < i + 4; j++) {
                bits = bits << 6 | (j < encoded.length() ? SIX_BITS.indexOf(encoded.charAt(j)) : 0);
            }
            octets.write(bits >> 16);
            octets.write(bits >> 8);
            octets.write(bits);
        }
        byte[] source = new InflaterInputStream(new ByteArrayInputStream(octets.toByteArray()), new Inflater(true))
                .readAllBytes();
        return new String(source, StandardCharsets.UTF_8);
    }
}
