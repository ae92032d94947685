package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What the documents point at is there, and what they quote is true. */
class DocumentsTest {
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)\\)");

    /** Names in documents that look like classes of ours. */
    private static final Set<String> OF_OTHERS = Set.of(
            "SecureRandom",
            "ScheduledExecutorService",
            "RobotHome",
            "GoalWithHeading",
            "ForbiddenArea",
            "ForbiddenLine");

    private static List<Path> documents() throws IOException {
        List<Path> documents = new ArrayList<>(
                List.of(Dist.root().resolve("README.md"), Dist.root().resolve("CONTRIBUTING.md")));
        try (Stream<Path> files = Files.walk(Dist.root().resolve("docs"))) {
            files.filter(file -> file.toString().endsWith(".md")).forEach(documents::add);
        }
        return documents;
    }

    @Test
    void everyRelativeLinkLeadsSomewhere() throws IOException {
        List<String> dead = new ArrayList<>();
        int links = 0;
        for (Path document : documents()) {
            Matcher link = LINK.matcher(Files.readString(document));
            while (link.find()) {
                links++;
                if (!Files.exists(document.resolveSibling(link.group(1)))) {
                    dead.add(document.getFileName() + " -> " + link.group(1));
                }
            }
        }
        assertEquals(List.of(), dead);
        assertTrue(links >= 5, "links found: " + links);
    }

    @Test
    void everyJarAndWorldThatTheReadmeNamesIsThere() throws IOException {
        String readme = Files.readString(Dist.root().resolve("README.md"));
        Matcher named = Pattern.compile("(target/dist/[a-z-]+\\.jar|worlds/[a-z]+\\.map)")
                .matcher(readme);
        int found = 0;
        while (named.find()) {
            found++;
            assertTrue(Files.exists(Dist.root().resolve(named.group(1))), named.group(1));
        }
        assertTrue(found >= 6, "named: " + found);
    }

    @Test
    void classesThatTheDocumentsNameAreThere() throws IOException {
        Set<String> classes = javaFiles("");
        Set<String> missing = new TreeSet<>();
        for (Path document : documents()) {
            Matcher names =
                    Pattern.compile("`([A-Z][a-z]+(?:[A-Z][a-z0-9]+)+)`").matcher(Files.readString(document));
            while (names.find()) {
                if (!classes.contains(names.group(1)) && !OF_OTHERS.contains(names.group(1))) {
                    missing.add(document.getFileName() + " -> " + names.group(1));
                }
            }
        }
        assertEquals(Set.of(), missing);
    }

    @Test
    void theCatalogueOfTestsNamesOnlyClassesThatAreThere() throws IOException {
        Set<String> named = new TreeSet<>();
        Matcher names = Pattern.compile("`([A-Z]\\w*Test)`")
                .matcher(Files.readString(Dist.root().resolve("docs/TESTS.md")));
        while (names.find()) {
            named.add(names.group(1));
        }
        assertTrue(named.size() >= 20, named.toString());
        named.removeAll(testClasses());
        assertEquals(Set.of(), named);
    }

    @Test
    void theDiagramsOfTheTestsNameOnlyClassesThatAreThere() throws IOException {
        Set<String> named = new TreeSet<>();
        try (Stream<Path> diagrams = Files.list(Dist.root().resolve("docs/uml/testing"))) {
            for (Path diagram :
                    diagrams.filter(file -> file.toString().endsWith(".puml")).toList()) {
                Matcher names = Pattern.compile("\\b([A-Z]\\w*Test)\\b").matcher(Files.readString(diagram));
                while (names.find()) {
                    named.add(names.group(1));
                }
            }
        }
        assertTrue(named.size() >= 10, named.toString());
        named.removeAll(testClasses());
        assertEquals(Set.of(), named);
    }

    private static Set<String> testClasses() throws IOException {
        return javaFiles("Test");
    }

    /** The names of all top-level classes of the repository that end so. */
    private static Set<String> javaFiles(String ending) throws IOException {
        Set<String> names = new TreeSet<>();
        Files.walkFileTree(Dist.root(), new SimpleFileVisitor<>() {
            /** What is built may change meanwhile: CI fetches the peers into a folder there. */
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
                return folder.getFileName().toString().equals("target")
                        ? FileVisitResult.SKIP_SUBTREE
                        : FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                String name = file.getFileName().toString();
                if (name.endsWith(ending + ".java")) {
                    names.add(name.substring(0, name.length() - ".java".length()));
                }
                return FileVisitResult.CONTINUE;
            }
        });
        return names;
    }
}
