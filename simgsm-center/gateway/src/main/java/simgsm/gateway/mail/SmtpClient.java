package simgsm.gateway.mail;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.esme.TcpSocket;

/** Hands one mail to the mail server (RFC 5321). Time limits are the owner's, which calls {@link #abort}. */
final class SmtpClient implements TcpProtocol {
    private static final int MOST_REPLY = 4_096;
    private static final int MOST_PRINTED = 200;
    private static final int TRY_LATER = 421;

    private enum Step {
        GREETING,
        EHLO,
        HELO,
        MAIL,
        RCPT,
        DATA,
        TEXT,
        ENDED
    }

    /** Receives the outcome. */
    interface Listener {
        /** The final dot is sent: from now on the server may have taken the mail. */
        void textSent();

        /**
         * The mail is taken, or not; called once.
         *
         * @param code 250, or the reply that refused; 421 for a connection that failed
         * @param refused reply by address that the server refuses for good
         */
        void ended(int code, String text, Map<String, String> refused);
    }

    private final OutgoingMail mail;
    private final Listener listener;
    private final SmtpLines lines = new SmtpLines(MOST_REPLY);
    private final Map<String, String> refused = new LinkedHashMap<>();
    private TcpSocket socket;
    private Step step = Step.GREETING;
    private boolean takesEightBits;
    private int recipient;

    SmtpClient(OutgoingMail mail, Listener listener) {
        this.mail = mail;
        this.listener = listener;
    }

    @Override
    public void connected(TcpSocket opened) {
        socket = opened;
        if (step == Step.ENDED) {
            socket.closeWhenSent();
        }
    }

    @Override
    public void received(ByteBuffer octets) {
        lines.accept(octets);
        if (lines.isTooLong()) {
            end(TRY_LATER, "a reply of over " + MOST_REPLY + " octets");
        }
        for (String line = lines.next(); line != null && step != Step.ENDED; line = lines.next()) {
            if (!line.matches("[2-5][0-9][0-9]([ -].*)?")) {
                end(TRY_LATER, "no reply of SMTP: " + printable(line));
            } else if (line.length() > 3 && line.charAt(3) == '-') {
                noteExtension(line);
            } else {
                noteExtension(line);
                answered(Integer.parseInt(line.substring(0, 3)), printable(line));
            }
        }
    }

    /** One line of at most 200 printable characters. */
    static String printable(String text) {
        String line = text.replaceAll("[^ -~]+", " ").strip();
        return line.substring(0, Math.min(line.length(), MOST_PRINTED));
    }

    private void noteExtension(String line) {
        takesEightBits |= step == Step.EHLO && line.regionMatches(true, 4, "8BITMIME", 0, 8);
    }

    private void answered(int code, String line) {
        boolean isRefusal = code >= 400;
        switch (step) {
            case GREETING -> goOn(code, line, Step.EHLO, "EHLO " + mail.domain());
            case EHLO -> {
                if (code >= 500) {
                    say(Step.HELO, "HELO " + mail.domain());
                } else {
                    goOn(code, line, Step.MAIL, mailFrom());
                }
            }
            case HELO -> goOn(code, line, Step.MAIL, mailFrom());
            case MAIL -> goOn(code, line, Step.RCPT, recipientCommand());
            case RCPT -> recipientAnswered(code, line);
            case DATA -> {
                if (isRefusal) {
                    end(code, line);
                } else {
                    step = Step.TEXT;
                    listener.textSent();
                    send(mail.withDots(takesEightBits));
                }
            }
            default -> end(code, line);
        }
    }

    private String mailFrom() {
        return "MAIL FROM:<" + mail.from() + ">" + (takesEightBits ? " BODY=8BITMIME" : "");
    }

    private String recipientCommand() {
        return "RCPT TO:<" + mail.to().get(recipient) + ">";
    }

    private void recipientAnswered(int code, String line) {
        if (code >= 400 && code < 500) {
            end(code, line);
            return;
        }
        if (code >= 500) {
            refused.put(mail.to().get(recipient), line);
        }
        recipient++;
        if (recipient < mail.to().size()) {
            say(Step.RCPT, recipientCommand());
        } else if (refused.size() == recipient) {
            end(code, line);
        } else {
            say(Step.DATA, "DATA");
        }
    }

    private void goOn(int code, String line, Step next, String command) {
        if (code >= 400) {
            end(code, line);
        } else {
            say(next, command);
        }
    }

    private void say(Step next, String command) {
        step = next;
        send(command + "\r\n");
    }

    private void send(String octets) {
        socket.send(octets.getBytes(StandardCharsets.ISO_8859_1));
    }

    private void end(int code, String text) {
        if (step == Step.ENDED) {
            return;
        }
        step = Step.ENDED;
        if (socket != null) {
            send("QUIT\r\n");
            socket.closeWhenSent();
        }
        listener.ended(code, text, refused);
    }

    /** Closes the connection at once; the mail is not taken. */
    void abort(String reason) {
        end(TRY_LATER, reason);
    }

    @Override
    public void lost(String reason) {
        socket = null;
        end(TRY_LATER, "421 " + reason);
    }
}
