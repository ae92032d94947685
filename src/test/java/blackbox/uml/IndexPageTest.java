package blackbox.uml;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** {@code docs/uml/README.md} lists every diagram by folder and kind, printed from the files' names and titles. */
@Isolated("reads what the other tests write with -Duml.write=true")
class IndexPageTest {
    private static final String HEAD = """
            # UML

            The paper's set: analysis, design, implementation and testing. State, class and component diagrams are printed from the
            compiled classes, sequences from runs of the real cores with a clock moved by hand; tests in `blackbox.uml` compare
            them. The others are written by hand. This page is printed, too.

            Write all printed sources and docs/REFERENCE.md anew, then draw every SVG:

                mvn -q -pl src/test -am -Dtest='blackbox.uml.*Test,*ReferenceTest' -Dsurefire.failIfNoSpecifiedTests=false -Duml.write=true package
                mvn -q -N -Puml exec:java

            The first command reports the SVG files that it has made stale; after the second, `mvn verify` is green.
            """;

    /** Folder and prefix of the file names, with the section's heading; an empty prefix takes what is left. */
    private static final List<List<String>> SECTIONS = List.of(
            List.of("", "", "What may the robot do in which status?"),
            List.of("analysis", "", "What is the suite about, and who uses it? (by hand)"),
            List.of("design", "sequence-", "Which messages pass, and in which order? (recorded)"),
            List.of("design", "classes-", "Which classes do it? (printed)"),
            List.of("design", "state-", "Which states has a party, and what leads from one to the next? (printed)"),
            List.of("design", "activity-", "Which steps does an order take? (by hand)"),
            List.of("implementation", "modules", "Which module needs which? (printed)"),
            List.of("implementation", "", "Which processes, ports and threads run? (by hand)"),
            List.of("testing", "", "What is tested of an order? (by hand)"));

    @Test
    void thePageListsEveryDiagram() throws IOException {
        Map<String, String> titles = titles();
        StringBuilder page = new StringBuilder(HEAD);
        for (List<String> section : SECTIONS) {
            page.append("\n## ").append(section.get(2)).append("\n\n");
            String start = section.get(0).isEmpty() ? "" : section.get(0) + "/";
            for (String file : List.copyOf(titles.keySet())) {
                if (file.startsWith(start + section.get(1)) && file.indexOf('/') == start.length() - 1) {
                    page.append("![%s](%s)\n\n".formatted(titles.remove(file), file));
                }
            }
            page.setLength(page.length() - 1);
        }
        Diagram.hold("README.md", page.toString());
    }

    /** The SVG of each diagram, relative to {@code docs/uml}, and its title. */
    private static Map<String, String> titles() throws IOException {
        Map<String, String> titles = new TreeMap<>();
        try (Stream<Path> files = Files.walk(Diagram.FOLDER)) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".puml")).toList()) {
                String title = Files.readAllLines(file).stream()
                        .filter(line -> line.startsWith("title "))
                        .findFirst()
                        .orElseThrow()
                        .substring("title ".length())
                        .strip();
                titles.put(
                        Diagram.FOLDER
                                .relativize(file)
                                .toString()
                                .replace('\\', '/')
                                .replace(".puml", ".svg"),
                        title);
            }
        }
        return titles;
    }
}
