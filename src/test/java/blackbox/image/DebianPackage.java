package blackbox.image;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The image as a Debian package: programs in /usr/lib/simgsm, commands in /usr/bin, menu entries in /usr/share. */
final class DebianPackage {
    private DebianPackage() {}

    /**
     * Builds the package; root is not needed.
     *
     * @param root a folder that is filled, and packed
     */
    static void build(Path image, Path root, Path file, String version, List<ImageProgram> programs)
            throws IOException, InterruptedException {
        Path programsFolder = root.resolve("usr/lib/simgsm");
        for (String part : List.of("bin", "runtime", "worlds", "lessons")) {
            if (Files.exists(image.resolve(part))) {
                Folders.copy(image.resolve(part), programsFolder.resolve(part));
            }
        }
        Folders.copy(image.resolve("share"), root.resolve("usr/share"));
        Folders.copy(image.resolve("docs"), root.resolve("usr/share/doc/simgsm"));
        Files.copy(image.resolve("LICENSE"), root.resolve("usr/share/doc/simgsm/copyright"));
        Path commands = Files.createDirectories(root.resolve("usr/bin"));
        for (ImageProgram program : programs) {
            Files.createSymbolicLink(
                    commands.resolve(program.launcher()), Path.of("../lib/simgsm/bin", program.launcher()));
        }
        Path control = Files.createDirectories(root.resolve("DEBIAN")).resolve("control");
        Files.writeString(control, control(image, version));
        Tool.run(
                root,
                List.of("dpkg-deb", "--root-owner-group", "-Zxz", "-z1", "--build", root.toString(), file.toString()));
    }

    private static String control(Path image, String version) throws IOException, InterruptedException {
        long kibibytes = Folders.size(image) / 1024;
        return """
                Package: simgsm
                Version: %s
                Architecture: %s
                Maintainer: SimGSM suite <simgsm@localhost>
                Section: education
                Priority: optional
                Installed-Size: %d
                Depends: %s
                Description: robot driven by telephone, with its GSM network
                 A GSM phone, an SMS/Phone centre and a Pioneer robot with a GSM modem, each a
                 window of its own. Dial the robot and drive it by the tones of the keys, or by
                 SMS, and watch every message of the network. Java is part of the package.
                """.formatted(version, output("dpkg", "--print-architecture"), kibibytes, libraries(image));
    }

    /** The packages of the system's libraries that the image's libraries load. */
    private static String libraries(Path image) throws IOException, InterruptedException {
        TreeSet<String> packages = new TreeSet<>(List.of("libc6"));
        List<Path> libraries;
        try (Stream<Path> files = Files.walk(image.resolve("runtime/lib"))) {
            libraries = files.filter(file -> file.toString().endsWith(".so")).toList();
        }
        TreeSet<String> needed = new TreeSet<>();
        for (Path library : libraries) {
            output("ldd", library.toString())
                    .lines()
                    .filter(line -> line.contains("=> /") && !line.contains(image.toString()))
                    .map(line -> line.replaceAll(".*=> (\\S+) .*", "$1"))
                    .forEach(needed::add);
        }
        for (String file : needed) {
            // A library may be listed below /usr/lib and linked from /lib.
            String owner =
                    output("dpkg-query", "-S", "*" + Path.of(file).toRealPath().getFileName());
            owner.lines()
                    .filter(line -> line.contains(": /"))
                    .map(line -> line.substring(0, line.indexOf(':')))
                    .filter(name -> name.startsWith("lib") || name.startsWith("zlib"))
                    .findFirst()
                    .ifPresent(packages::add);
        }
        return String.join(", ", packages);
    }

    private static String output(String... command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        process.waitFor();
        return text.strip();
    }
}
