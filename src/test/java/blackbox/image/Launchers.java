package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simgsm.console.QuickStart;

/** The commands of the image, as shell scripts or, on Windows, batch files. */
final class Launchers {
    private Launchers() {}

    /**
     * Writes them.
     *
     * @param bin the folder beside that of the runtime
     * @param runtime with the caches that the launchers name
     */
    static void write(Path bin, Path runtime, List<ImageProgram> programs) throws IOException {
        Files.createDirectories(bin);
        for (ImageProgram program : programs) {
            String cache = "";
            Path file = QuickStart.cacheOf(runtime, program.cacheName());
            if (Files.exists(file)) {
                cache = "\"-Xlog:aot*=off\" \"-XX:AOTCache=%s" + file.getFileName() + "\" ";
            }
            if (Tool.IS_WINDOWS) {
                String lib = "%~dp0..\\runtime\\lib\\";
                Files.writeString(bin.resolve(program.launcher() + ".cmd"), batch(program, cache.replace("%s", lib)));
            } else {
                String text = shell(program, cache.replace("%s", "$home/runtime/lib/"));
                Path script = Files.writeString(bin.resolve(program.launcher()), text);
                if (!script.toFile().setExecutable(true, false)) {
                    throw new IOException(script + ": cannot be made executable");
                }
            }
        }
    }

    /** A window starts in half the CPU time with the first compiler and the serial collector only. */
    private static String shell(ImageProgram program, String cache) {
        return """
                #!/bin/sh
                # Starts a program of the SimGSM suite with the Java of this image.
                home=$(readlink -f "$0")
                home=${home%%/bin/*}
                case " $* " in
                *" --headless "* | *" --run"*) quick= ;;
                *) quick="%s" ;;
                esac
                exec "$home/runtime/bin/java" $quick %s%s "$@"
                """.formatted(String.join(" ", QuickStart.options()), cache, program.words());
    }

    private static String batch(ImageProgram program, String cache) {
        return """
                @echo off\r
                rem Starts a program of the SimGSM suite with the Java of this image.\r
                "%%~dp0..\\runtime\\bin\\java.exe" %s %s%s %%*\r
                """.formatted(String.join(" ", QuickStart.options()), cache, program.words());
    }
}
