package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The commands of the image, as shell scripts or, on Windows, batch files. */
final class Launchers {
    private Launchers() {}

    /** @param bin the folder beside that of the runtime */
    static void write(Path bin, List<ImageProgram> programs) throws IOException {
        Files.createDirectories(bin);
        for (ImageProgram program : programs) {
            if (Tool.IS_WINDOWS) {
                Files.writeString(bin.resolve(program.launcher() + ".cmd"), batch(program));
            } else {
                Path script = Files.writeString(bin.resolve(program.launcher()), shell(program));
                if (!script.toFile().setExecutable(true, false)) {
                    throw new IOException(script + ": cannot be made executable");
                }
            }
        }
    }

    /** A window starts in half the CPU time with the first compiler and the serial collector only. */
    private static String shell(ImageProgram program) {
        return """
                #!/bin/sh
                # Starts a program of the SimGSM suite with the Java of this image.
                home=$(dirname "$(dirname "$(readlink -f "$0")")")
                case " $* " in
                *" --headless "* | *" --run"*) quick= ;;
                *) quick="-XX:TieredStopAtLevel=1 -XX:+UseSerialGC" ;;
                esac
                exec "$home/runtime/bin/java" $quick %s "$@"
                """.formatted(program.words());
    }

    private static String batch(ImageProgram program) {
        return """
                @echo off\r
                rem Starts a program of the SimGSM suite with the Java of this image.\r
                "%%~dp0..\\runtime\\bin\\java.exe" -XX:TieredStopAtLevel=1 -XX:+UseSerialGC %s %%*\r
                """.formatted(program.words());
    }
}
