package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Makes the image from the built jars: {@code image/simgsm-VERSION/} with launchers, runtime, worlds, lessons and documents,
 * the same as .tar.gz and, where dpkg-deb is found, as .deb. Arguments: the source tree, the folder of the jars, the
 * version, the date of the release.
 */
public final class ImageMain {
    private ImageMain() {}

    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path root = Path.of(arguments[0]).toAbsolutePath().normalize();
        Path dist = Path.of(arguments[1]).toAbsolutePath().normalize();
        String version = arguments[2];
        String date = arguments[3].substring(0, "YYYY-MM-DD".length());
        Path out = dist.resolveSibling("image");
        Path work = dist.resolveSibling("image-work");
        Folders.remove(out);
        Folders.remove(work);
        Files.createDirectories(work);
        Path image = Files.createDirectories(out.resolve("simgsm-" + version));

        List<ImageProgram> programs = ImageProgram.in(dist);
        for (String part : List.of("worlds", "lessons", "docs")) {
            if (Files.exists(root.resolve(part))) {
                Folders.copy(root.resolve(part), image.resolve(part));
            }
        }
        for (String file : List.of("README.md", "LICENSE", "CHANGELOG.md")) {
            Files.copy(root.resolve(file), image.resolve(file));
        }
        RuntimeImage runtime = new RuntimeImage(image.resolve("runtime"));
        runtime.link(dist, programs);
        runtime.archiveClasses(work, programs);
        Launchers.write(image.resolve("bin"), image.resolve("runtime"), programs);
        if (!Tool.IS_WINDOWS) {
            List<ImageProgram> inMenu =
                    programs.stream().filter(program -> program.isInMenu(dist)).toList();
            DesktopFiles.write(image.resolve("share"), inMenu, version, date);
        }
        pack(out, image, work, version, programs);
        System.out.println("image: " + image + ", " + Folders.size(image) / 1_000_000 + " MB");
    }

    private static void pack(Path out, Path image, Path work, String version, List<ImageProgram> programs)
            throws IOException, InterruptedException {
        String name = image.getFileName().toString();
        Tool.run(out, List.of("tar", "-czf", name + ".tar.gz", name));
        if (Tool.find("dpkg-deb").isPresent()) {
            DebianPackage.build(
                    image, work.resolve("deb"), out.resolve("simgsm_" + version + ".deb"), version, programs);
        }
    }
}
