package blackbox.uml;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.Dist;
import blackbox.PrintedFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A diagram's source in {@code docs/uml} that the code prints. */
final class Diagram {
    static final Path FOLDER = Dist.root().resolve("docs").resolve("uml");

    private Diagram() {}

    /** The head of a diagram that lies in a folder of {@code docs/uml}. */
    static String head(String title) {
        return "@startuml\n!include ../look.iuml\ntitle " + title + "\n";
    }

    /** Compares a diagram with its file, or writes the file. */
    static void hold(String file, String text) throws IOException {
        PrintedFile.hold(FOLDER.resolve(file), text);
    }

    /** Requires that a folder holds these printed diagrams and no others with the prefix; when writing, deletes others. */
    static void holdOnly(String folder, String prefix, Set<String> expected) throws IOException {
        if (PrintedFile.IS_WRITING) {
            for (String name : printed(folder, prefix)) {
                if (!expected.contains(name)) {
                    Files.delete(FOLDER.resolve(folder).resolve(name));
                    Files.deleteIfExists(FOLDER.resolve(folder).resolve(name.replace(".puml", ".svg")));
                }
            }
        }
        assertEquals(new TreeSet<>(expected), printed(folder, prefix));
    }

    private static Set<String> printed(String folder, String prefix) throws IOException {
        try (Stream<Path> files = Files.list(FOLDER.resolve(folder))) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.startsWith(prefix) && name.endsWith(".puml"))
                    .collect(Collectors.toCollection(TreeSet::new));
        }
    }

    /** {@code "Mobile call"} becomes {@code mobile-call}. */
    static String fileName(String title) {
        return title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "");
    }
}
