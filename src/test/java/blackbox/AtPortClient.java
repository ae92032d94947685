package blackbox;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A client of a program's AT port, which asks line by line. */
final class AtPortClient implements AutoCloseable {
    private static final String FINAL = "OK|ERROR|NO CARRIER|BUSY|\\+CM[ES] ERROR: .*";

    private final Socket socket;
    private final BufferedReader lines;

    private AtPortClient(Socket socket) throws IOException {
        this.socket = socket;
        socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
        lines = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
    }

    /** Connects to the first port of the program, and turns the echo off. */
    static AtPortClient connect(RunningProgram program) throws IOException {
        int port = Integer.parseInt(program.said("ready").field("at"));
        AtPortClient client = new AtPortClient(new Socket(InetAddress.getLoopbackAddress(), port));
        client.ask("ATE0");
        return client;
    }

    /** The lines of the answer up to the final result, separated by bars. */
    String ask(String command) throws IOException {
        socket.getOutputStream().write((command + "\r").getBytes(StandardCharsets.ISO_8859_1));
        List<String> answer = new ArrayList<>();
        do {
            answer.add(next());
        } while (!answer.get(answer.size() - 1).matches(FINAL));
        return String.join("|", answer);
    }

    /** The next line that is not empty. */
    String next() throws IOException {
        String line = lines.readLine();
        while (line != null && line.isBlank()) {
            line = lines.readLine();
        }
        return line;
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
