package simgsm.classroom.lesson;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import simgsm.console.Event;

/** A connection to a terminal's AT port that exchanges commands and answers. */
final class AtLine implements AutoCloseable {
    private static final int PATIENCE_MILLIS = 15_000;
    private static final char CTRL_Z = 0x1a;
    private static final int OCTET_DIGITS = 2;

    private final Socket socket;

    AtLine(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(PATIENCE_MILLIS);
    }

    /**
     * Sends a command and returns the event {@code at command= answer=}; the answer, up to its final result, is joined
     * to one line.
     */
    Event command(String command) throws IOException {
        return Event.of("at").with("command", command).with("answer", ask(command + "\r"));
    }

    /**
     * Sends a SUBMIT in PDU mode with the default service centre.
     *
     * @param hex of the TPDU
     */
    Event submit(String hex) throws IOException {
        ask("AT+CMGF=0\r");
        String prompt = ask("AT+CMGS=" + hex.length() / OCTET_DIGITS + "\r");
        String answer = prompt.endsWith(">") ? ask("00" + hex + CTRL_Z) : prompt;
        return Event.of("at").with("command", "AT+CMGS").with("answer", answer);
    }

    private String ask(String text) throws IOException {
        socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
        socket.getOutputStream().flush();
        InputStream in = socket.getInputStream();
        StringBuilder answer = new StringBuilder();
        try {
            while (!isFinal(answer.toString().strip())) {
                int octet = in.read();
                if (octet < 0) {
                    throw new IOException("the AT port has closed");
                }
                answer.append((char) octet);
            }
        } catch (SocketTimeoutException e) {
            throw new IOException("no answer to " + text.strip(), e);
        }
        return answer.toString().replaceAll("\\s+", " ").strip();
    }

    private static boolean isFinal(String answer) {
        return answer.endsWith("\nOK")
                || answer.endsWith("\nERROR")
                || answer.matches("(?s).*\\+CM[ES] ERROR: [^\r\n]+")
                || answer.endsWith("\n>");
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
