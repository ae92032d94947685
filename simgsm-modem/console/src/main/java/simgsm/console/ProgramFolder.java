package simgsm.console;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.lang.module.ModuleReference;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The programs of the suite: jars in one folder, or modules of a runtime image.
 *
 * @param path the jars' folder, or the runtime image's
 * @param isImage true if the programs are modules of the image, not jars
 */
public record ProgramFolder(Path path, boolean isImage) {
    private static final String IMAGE_SCHEME = "jrt";
    /** The jar is in target/dist of the source tree, or next to the suite's folders. */
    private static final int FOLDERS_UPWARD = 3;

    /**
     * The folder of a program's own class.
     *
     * @throws IOException if the class is neither in a jar nor in an image
     */
    public static ProgramFolder of(Class<?> member) throws IOException {
        Optional<URI> known = location(member);
        if (known.isEmpty()) {
            throw new IOException("the Java machine does not tell where " + member + " lies");
        }
        URI own = known.get();
        if (own.getScheme().equals(IMAGE_SCHEME)) {
            return new ProgramFolder(Path.of(System.getProperty("java.home")), true);
        }
        Path jar = Path.of(own).toAbsolutePath();
        if (Files.isDirectory(jar)) {
            throw new IOException(
                    "other programs can only be started from the built jars (target/dist), not from " + jar);
        }
        return new ProgramFolder(jar.getParent(), false);
    }

    /** The folder above the files of a program's own class, in a jar or not; empty if unknown. */
    public static Optional<Path> above(Class<?> member) {
        return location(member)
                .map(own -> own.getScheme().equals(IMAGE_SCHEME)
                        ? Path.of(System.getProperty("java.home"))
                        : Path.of(own).toAbsolutePath().getParent());
    }

    /**
     * Finds a file of the suite: by its name, in a folder of that name, or upward from the files of a program's own
     * class, with or without the folder.
     *
     * @param folder as {@code worlds}
     * @return the file unchanged if it is not found
     */
    public static Path find(Class<?> member, Path folder, Path wanted) {
        List<Path> places = new ArrayList<>(List.of(wanted, folder.resolve(wanted)));
        Path above = above(member).orElse(null);
        for (int i = 0; i < FOLDERS_UPWARD && above != null; i++) {
            places.add(above.resolve(wanted));
            places.add(above.resolve(folder).resolve(wanted));
            above = above.getParent();
        }
        return places.stream().filter(Files::exists).findFirst().orElse(wanted);
    }

    /**
     * The content of a file of the suite, from the jar of a program's own class.
     *
     * @param folder as for {@link #find}
     * @param resources the folder in the jar
     * @return empty if the jar has no such file, or another folder is named
     */
    public static Optional<byte[]> carried(Class<?> member, Path folder, Path wanted, String resources)
            throws IOException {
        boolean mayBe = wanted.getParent() == null || wanted.getParent().equals(folder);
        try (InputStream in = mayBe ? member.getResourceAsStream(resources + wanted.getFileName()) : null) {
            return in == null ? Optional.empty() : Optional.of(in.readAllBytes());
        }
    }

    private static Optional<URI> location(Class<?> member) {
        CodeSource source = member.getProtectionDomain().getCodeSource();
        try {
            return source == null
                    ? Optional.empty()
                    : Optional.of(source.getLocation().toURI());
        } catch (URISyntaxException e) {
            return Optional.empty();
        }
    }

    /**
     * The command that starts a program, without its arguments.
     *
     * @param jar the program by its jar's name, {@code simgsm-phone.jar}; its module is {@code simgsm.phone}
     * @param machineOptions options of the Java machine
     * @throws IOException naming the program if it is missing
     */
    public List<String> command(String jar, List<String> machineOptions) throws IOException {
        List<String> command = new ArrayList<>(
                List.of(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java"));
        command.addAll(machineOptions);
        if (isImage) {
            command.addAll(List.of("-m", module(jar)));
            return command;
        }
        Path program = path.resolve(jar);
        if (!Files.isReadable(program)) {
            throw new IOException(program + ": no such program");
        }
        command.addAll(List.of("-jar", program.toString()));
        return command;
    }

    /** The command of this program's own Java, without further arguments. */
    public static List<String> java(List<String> machineOptions) {
        List<String> command = new ArrayList<>(
                List.of(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java"));
        command.addAll(machineOptions);
        return command;
    }

    private static String module(String jar) throws IOException {
        String name = jar.substring(0, jar.length() - ".jar".length()).replace('-', '.');
        return ModuleFinder.ofSystem()
                .find(name)
                .map(ModuleReference::descriptor)
                .flatMap(ModuleDescriptor::mainClass)
                .map(main -> name + "/" + main)
                .orElseThrow(() -> new IOException(name + ": no such program in " + System.getProperty("java.home")));
    }
}
