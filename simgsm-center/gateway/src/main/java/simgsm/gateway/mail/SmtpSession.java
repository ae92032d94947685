package simgsm.gateway.mail;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.esme.TcpSocket;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * One connection of a mail client to the gateway (RFC 5321, server). A mail has one receiver, a further one is told to
 * wait for the next mail (452): one answer cannot say that the SMSC has taken a message for one number and not for another.
 */
final class SmtpSession implements TcpProtocol {
    /** Octets of a mail, also told as SIZE. */
    static final int MOST_OCTETS = 65_536;

    private static final int MOST_COMMAND = 510;
    private static final int MOST_LINE = 998;
    private static final int MOST_BUFFERED = 2 * MOST_OCTETS;
    private static final int MOST_ERRORS = 20;
    private static final long IDLE_NANOS = TimeUnit.MINUTES.toNanos(5);
    private static final Pattern PATH = Pattern.compile("<(?:@[^:>]*:)?([^<>\\x00-\\x20\\x7f]*)>(?: .*)?");
    private static final Pattern SIZE = Pattern.compile(".* SIZE=([0-9]{1,20})(?: .*)?", Pattern.CASE_INSENSITIVE);

    /** Takes whole mails. */
    interface Receiver {
        /** @param reply receives the SMTP reply, once */
        void mail(String number, String sender, String octets, Consumer<String> reply);
    }

    private enum Mode {
        COMMANDS,
        TEXT,
        ANSWERING
    }

    private final Timers timers;
    private final String domain;
    private final Receiver receiver;
    private final Consumer<String> refused;
    private final SmtpLines lines = new SmtpLines(MOST_LINE);
    private final StringBuilder text = new StringBuilder();
    private TcpSocket socket;
    private Timer idle;
    private Mode mode = Mode.COMMANDS;
    private boolean isGreeted;
    /** Null without MAIL. */
    private String sender;
    /** Null without RCPT. */
    private String number;

    private String textFault = "";
    private int errors;
    private boolean isReading;

    /** @param refused hears each reply that refuses an address or a mail for good */
    SmtpSession(Timers timers, String domain, Receiver receiver, Consumer<String> refused) {
        this.timers = timers;
        this.domain = domain;
        this.receiver = receiver;
        this.refused = refused;
    }

    @Override
    public void connected(TcpSocket opened) {
        socket = opened;
        say("220 " + domain + " SMTP, short messages");
        restartIdle();
    }

    private void restartIdle() {
        timers.cancel(idle);
        idle = timers.start(IDLE_NANOS, () -> end("421 4.4.2 no command for 5 minutes"));
    }

    @Override
    public void received(ByteBuffer octets) {
        lines.accept(octets);
        if (mode != Mode.ANSWERING) {
            restartIdle();
        } else if (lines.length() > MOST_BUFFERED) {
            end("421 4.7.0 too much sent before the answer");
        }
        readLines();
    }

    private void readLines() {
        if (!isReading) {
            isReading = true;
            readEach();
            isReading = false;
        }
    }

    private void readEach() {
        while (socket != null && mode != Mode.ANSWERING) {
            if (lines.isTooLong()) {
                end("500 5.5.2 line too long");
                return;
            }
            String line = lines.next();
            if (line == null) {
                return;
            } else if (mode == Mode.TEXT) {
                textLine(line);
            } else if (line.length() > MOST_COMMAND) {
                fail("500 5.5.2 command too long");
            } else {
                command(line);
            }
        }
    }

    private void command(String line) {
        int blank = line.indexOf(' ');
        String verb = (blank < 0 ? line : line.substring(0, blank)).toUpperCase(Locale.ROOT);
        String argument = blank < 0 ? "" : line.substring(blank + 1).strip();
        switch (verb) {
            case "HELO" -> greeted(argument, "250 " + domain);
            case "EHLO" ->
                greeted(
                        argument,
                        "250-" + domain + "\r\n250-8BITMIME\r\n250-ENHANCEDSTATUSCODES\r\n250 SIZE " + MOST_OCTETS);
            case "MAIL" -> mail(argument);
            case "RCPT" -> recipient(argument);
            case "DATA" -> data();
            case "RSET" -> {
                reset();
                say("250 2.0.0 OK");
            }
            case "NOOP" -> say("250 2.0.0 OK");
            case "VRFY" -> say("252 2.1.5 send a mail and see");
            case "QUIT" -> end("221 2.0.0 bye");
            case "STARTTLS", "AUTH", "EXPN", "HELP", "BDAT" -> fail("502 5.5.1 " + verb + " is not served");
            default -> fail("500 5.5.1 unknown command");
        }
    }

    private void greeted(String name, String answer) {
        if (name.isEmpty()) {
            fail("501 5.5.4 expected a host name");
            return;
        }
        isGreeted = true;
        reset();
        say(answer);
    }

    private void reset() {
        sender = null;
        number = null;
        textFault = "";
        text.setLength(0);
    }

    private void mail(String argument) {
        Matcher path = path(argument, "FROM:");
        Matcher size = SIZE.matcher(argument);
        if (!isGreeted || sender != null) {
            fail("503 5.5.1 expected " + (isGreeted ? "RCPT" : "EHLO"));
        } else if (!path.matches()) {
            fail("501 5.1.7 expected MAIL FROM:<ADDRESS>");
        } else if (size.matches() && Double.parseDouble(size.group(1)) > MOST_OCTETS) {
            fail("552 5.3.4 at most " + MOST_OCTETS + " octets");
        } else if (!path.group(1).matches("\\p{ASCII}*")) {
            fail("553 5.6.7 expected an address in ASCII");
        } else {
            sender = path.group(1);
            say("250 2.1.0 OK");
        }
    }

    private static Matcher path(String argument, String word) {
        boolean isWord = argument.regionMatches(true, 0, word, 0, word.length());
        return PATH.matcher(isWord ? argument.substring(word.length()).strip() : "");
    }

    private void recipient(String argument) {
        Matcher path = path(argument, "TO:");
        if (sender == null) {
            fail("503 5.5.1 expected MAIL");
        } else if (!path.matches()) {
            fail("501 5.1.3 expected RCPT TO:<NUMBER@" + domain + ">");
        } else if (number != null) {
            say("452 4.5.3 one receiver a mail");
        } else {
            String address = path.group(1);
            int at = address.lastIndexOf('@');
            String local = address.substring(0, Math.max(at, 0)).replaceFirst("^\\+", "");
            if (!address.substring(at + 1).equalsIgnoreCase(domain)) {
                refuse("550 5.7.1 only addresses of " + domain);
            } else if (!local.matches("[0-9]{1,15}")) {
                refuse("550 5.1.1 expected a telephone number before the @");
            } else {
                number = local;
                say("250 2.1.5 OK");
            }
        }
    }

    private void data() {
        if (number == null) {
            fail("503 5.5.1 expected RCPT");
        } else {
            mode = Mode.TEXT;
            say("354 end with a line of one dot");
        }
    }

    private void textLine(String line) {
        if (!line.equals(".")) {
            text.append(line, line.startsWith(".") ? 1 : 0, line.length()).append("\r\n");
            if (text.length() > MOST_OCTETS) {
                textFault = "552 5.3.4 at most " + MOST_OCTETS + " octets";
                text.setLength(0);
            }
            return;
        }
        mode = Mode.ANSWERING;
        timers.cancel(idle);
        if (textFault.isEmpty()) {
            receiver.mail(number, sender, text.toString(), this::answered);
        } else {
            answered(textFault);
        }
    }

    private void answered(String reply) {
        if (socket == null) {
            return;
        }
        mode = Mode.COMMANDS;
        reset();
        if (reply.startsWith("5")) {
            refuse(reply);
        } else {
            say(reply);
        }
        restartIdle();
        readLines();
    }

    private void refuse(String reply) {
        refused.accept(reply);
        fail(reply);
    }

    private void fail(String reply) {
        errors++;
        if (errors > MOST_ERRORS) {
            end("421 4.7.0 too many errors");
        } else {
            say(reply);
        }
    }

    private void say(String reply) {
        if (socket != null) {
            socket.send((reply + "\r\n").getBytes(StandardCharsets.ISO_8859_1));
        }
    }

    private void end(String reply) {
        say(reply);
        timers.cancel(idle);
        if (socket != null) {
            socket.closeWhenSent();
            socket = null;
        }
    }

    @Override
    public void lost(String reason) {
        timers.cancel(idle);
        socket = null;
    }
}
