package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Names that tell classes apart, and packages that can be read in one go. */
class NamesAndSizesTest {
    private static final int FILES_PER_PACKAGE = 40;
    private static final int LINES_PER_PACKAGE = 3_000;

    /** Nested classes of one name differ by the class around them, such as the states of two tables. */
    @Test
    void noTopLevelClassNameStandsTwiceNorAsAVisibleNestedClass() {
        Map<String, Set<String>> classes = MainCode.CLASSES.stream()
                .filter(type -> type.isTopLevelClass() || type.isMemberClass())
                .filter(type -> !type.getModifiers().contains(JavaModifier.PRIVATE))
                .filter(type -> !type.getSimpleName().endsWith("-info"))
                .collect(Collectors.groupingBy(
                        JavaClass::getSimpleName,
                        TreeMap::new,
                        Collectors.mapping(JavaClass::getName, Collectors.toCollection(TreeSet::new))));
        classes.values().removeIf(names -> names.size() == 1 || names.stream().allMatch(name -> name.contains("$")));
        assertEquals(Map.of(), classes);
    }

    @Test
    void noClassIsCalledAfterNothing() {
        assertEquals(
                List.of(),
                MainCode.sources().stream()
                        .map(file -> file.getFileName().toString())
                        .filter(name -> name.matches(".*(Utils?|Helpers?|Managers?|Impl)\\.java"))
                        .toList());
    }

    @Test
    void noPackageHasMoreThan40FilesOr3000Lines() {
        Map<Path, List<Path>> packages = MainCode.sources().stream().collect(Collectors.groupingBy(Path::getParent));
        Map<String, String> tooLarge = new TreeMap<>();
        packages.forEach((folder, files) -> {
            long lines = files.stream()
                    .mapToLong(file -> MainCode.read(file).lines().count())
                    .sum();
            if (files.size() > FILES_PER_PACKAGE || lines > LINES_PER_PACKAGE) {
                tooLarge.put(nameOf(folder), files.size() + " files, " + lines + " lines");
            }
        });
        assertEquals(Map.of(), tooLarge);
    }

    private static String nameOf(Path folder) {
        String path = folder.toString().replace(folder.getFileSystem().getSeparator(), "/");
        return path.substring(path.indexOf("/src/main/java/") + "/src/main/java/".length())
                .replace('/', '.');
    }
}
