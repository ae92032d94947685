package blackbox.image;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A display for the windows that the build of the image opens: the user's, or an Xvfb for as long as it is needed. */
final class VirtualDisplay implements AutoCloseable {
    /** Whether windows need an X11 server here. */
    static final boolean IS_X11 = System.getProperty("os.name").startsWith("Linux");

    private final Optional<Process> server;
    private final Optional<String> name;

    private VirtualDisplay(Optional<Process> server, Optional<String> name) {
        this.server = server;
        this.name = name;
    }

    /** The display of this process, else one of Xvfb, which chooses a free number; empty without both. */
    static Optional<VirtualDisplay> open() throws IOException {
        if (!IS_X11 || !System.getenv().getOrDefault("DISPLAY", "").isBlank()) {
            return Optional.of(new VirtualDisplay(Optional.empty(), Optional.empty()));
        }
        if (Tool.find("Xvfb").isEmpty()) {
            return Optional.empty();
        }
        Process xvfb = new ProcessBuilder(
                        List.of("Xvfb", "-displayfd", "1", "-screen", "0", "1920x1080x24", "-noreset"))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        String number =
                new BufferedReader(new InputStreamReader(xvfb.getInputStream(), StandardCharsets.US_ASCII)).readLine();
        if (number == null) {
            throw new IOException("Xvfb gave no display and ended");
        }
        return Optional.of(new VirtualDisplay(Optional.of(xvfb), Optional.of(":" + number)));
    }

    /** Names the display to a process that is to be started. */
    void in(Map<String, String> environment) {
        name.ifPresent(it -> environment.put("DISPLAY", it));
    }

    @Override
    public void close() {
        server.ifPresent(Process::destroy);
    }
}
