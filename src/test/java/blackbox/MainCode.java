package blackbox;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The compiled main code of all modules that the poms list, and the modules' descriptors. */
public final class MainCode {
    private static final Pattern MODULE = Pattern.compile("<module>([^<]+)</module>");

    public static final List<Path> FOLDERS = foldersUnder(Dist.root());

    public static final JavaClasses CLASSES = new ClassFileImporter()
            .importPaths(FOLDERS.stream().map(MainCode::classes).toList());

    private MainCode() {}

    /** The folders of all modules with main code, in the poms' order. */
    private static List<Path> foldersUnder(Path folder) {
        List<Path> folders = new ArrayList<>();
        if (Files.exists(classes(folder).resolve("module-info.class"))) {
            folders.add(folder);
        }
        Matcher nested = MODULE.matcher(read(folder.resolve("pom.xml")));
        while (nested.find()) {
            folders.addAll(foldersUnder(folder.resolve(nested.group(1))));
        }
        return folders;
    }

    private static Path classes(Path folder) {
        return folder.resolve("target").resolve("classes");
    }

    /** The descriptor of the module in a folder, with its packages. */
    public static ModuleDescriptor descriptor(Path folder) {
        return ModuleFinder.of(classes(folder)).findAll().iterator().next().descriptor();
    }

    public static List<ModuleDescriptor> descriptors() {
        return FOLDERS.stream().map(MainCode::descriptor).toList();
    }

    /** All packages, sorted. */
    public static List<String> packages() {
        return descriptors().stream()
                .flatMap(module -> module.packages().stream())
                .filter(MainCode::isOurs)
                .sorted()
                .toList();
    }

    public static boolean isOurs(String packageName) {
        return Stream.of("vericommand", "simgsm", "simrobot")
                .anyMatch(root -> packageName.equals(root) || packageName.startsWith(root + "."));
    }

    /** The main source files of all modules, without package-info and module-info. */
    public static List<Path> sources() {
        return FOLDERS.stream()
                .flatMap(folder -> filesUnder(folder.resolve("src/main/java")))
                .filter(file -> file.toString().endsWith(".java"))
                .filter(file -> !file.toString().endsWith("-info.java"))
                .toList();
    }

    private static Stream<Path> filesUnder(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).toList().stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
