package blackbox;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A mail server and a mail client, written from RFC 5321 alone. */
final class MailServer implements AutoCloseable {
    private final ServerSocket port = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final BlockingQueue<String> mails = new LinkedBlockingQueue<>();
    private final Thread thread = new Thread(this::run, "mail server");

    MailServer() throws IOException {
        thread.setDaemon(true);
        thread.start();
    }

    int port() {
        return port.getLocalPort();
    }

    /** The next mail, envelope lines first. */
    String next() throws InterruptedException {
        String mail = mails.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (mail == null) {
            throw new AssertionError("no mail has come");
        }
        return mail;
    }

    private void run() {
        while (!port.isClosed()) {
            try (Socket socket = port.accept()) {
                serve(socket);
            } catch (IOException e) {
                // the client has gone, or the test has ended
            }
        }
    }

    private void serve(Socket socket) throws IOException {
        BufferedReader in = new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
        StringBuilder mail = new StringBuilder();
        boolean isText = false;
        say(socket, "220 test");
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            if (isText && line.equals(".")) {
                isText = false;
                mails.add(mail.toString());
                say(socket, "250 taken");
            } else if (isText) {
                mail.append(line).append('\n');
            } else {
                mail.append(line).append('\n');
                isText = line.equals("DATA");
                say(socket, isText ? "354 go" : "250 OK");
            }
        }
    }

    private static void say(Socket socket, String line) throws IOException {
        socket.getOutputStream().write((line + "\r\n").getBytes(StandardCharsets.US_ASCII));
    }

    /** Sends a mail to the gateway's port; returns the reply to its text, or the first that refuses. */
    static String send(int port, String from, String to, String content) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            socket.setSoTimeout(RunningProgram.PATIENCE_SECONDS * 1_000);
            BufferedReader in =
                    new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII));
            String reply = in.readLine();
            for (String command : new String[] {
                "HELO test",
                "MAIL FROM:<" + from + ">",
                "RCPT TO:<" + to + ">",
                "DATA",
                content.replace("\n", "\r\n") + "\r\n."
            }) {
                say(socket, command);
                reply = in.readLine();
                if (!reply.startsWith("2") && !reply.startsWith("3")) {
                    break;
                }
            }
            return reply;
        }
    }

    @Override
    public void close() throws IOException {
        port.close();
    }
}
