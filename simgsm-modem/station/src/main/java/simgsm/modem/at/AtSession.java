package simgsm.modem.at;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The dialogue with one client, as octets. Command lines are performed in order; each ends with one final result.
 * Unsolicited codes are held back from the first character of a line until its final result, at most 2 s while the
 * line is incomplete, and after an announcement until 500 ms have passed without a command, at most 2 s. Characters
 * represent octets, as in ISO 8859-1. Owned by one thread.
 */
public final class AtSession<C> {
    /** A longer line is answered with ERROR. */
    static final int MAX_LINE = 2_048;
    /** Replaces a too long line; its repetition is an error, too. */
    private static final String TOO_LONG = "too long";
    /** Longer than any message; a longer text is cut here, and then refused by the command. */
    static final int MAX_TEXT = 4_096;

    static final long PROMPT_NANOS = TimeUnit.SECONDS.toNanos(60);
    static final long INCOMPLETE_LINE_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final int INPUT_ENOUGH = 16_384;
    private static final char BACKSPACE = 0x08;
    private static final char CTRL_Z = 0x1a;
    private static final char ESCAPE = 0x1b;
    private static final char DELETE = 0x7f;

    private enum Mode {
        COMMAND,
        PERFORMING,
        TEXT
    }

    private final AtCommandTable<C> table;
    private final C client;
    private final Timers timers;
    private final Consumer<byte[]> output;
    private final StringBuilder unsent = new StringBuilder();
    private final Deque<Byte> input = new ArrayDeque<>();
    private final HeldCodes held;
    private final StringBuilder line = new StringBuilder();
    private final StringBuilder text = new StringBuilder();

    private AtFormat format = new AtFormat();
    private Mode mode = Mode.COMMAND;
    private boolean isProcessing;
    private boolean isInHandler;
    private boolean isGathering;
    private boolean isTooLong;
    private boolean afterReturn;
    private boolean isClosed;
    private String lastLine = "";
    private AtLineParser parser;
    private AtRequest request;
    private AtResult early;
    private boolean textOfLines;
    private AtRequest.TextReceiver receiver;
    private Timer timer;

    /** @param output receives octets to send, at the end of each call */
    public AtSession(AtCommandTable<C> table, C client, Timers timers, Consumer<byte[]> output) {
        this.table = table;
        this.client = client;
        this.timers = timers;
        this.output = output;
        held = new HeldCodes(timers, this::send, this::sendOrWait);
    }

    /** The format of answers: echo, verbosity, errors. */
    public AtFormat format() {
        return format;
    }

    /** Restores the initial format. */
    public void resetFormat() {
        format = new AtFormat();
    }

    /** Receives octets from the client. */
    public void received(byte[] octets) {
        for (byte octet : octets) {
            input.add(octet);
        }
        process();
    }

    /** False while a command is performed and enough input waits. */
    public boolean wantsInput() {
        return input.size() < INPUT_ENOUGH;
    }

    /** True if a command has no final result yet. */
    public boolean isPerforming() {
        return mode == Mode.PERFORMING;
    }

    /** The client has disconnected: a pending command is dropped. */
    public void close() {
        isClosed = true;
        request = null;
        timers.cancel(timer);
        held.close();
    }

    private void process() {
        if (isProcessing) {
            return;
        }
        isProcessing = true;
        while (mode != Mode.PERFORMING && !input.isEmpty() && !isClosed) {
            take((char) (input.remove() & 0xff));
        }
        isProcessing = false;
        flush();
    }

    private void flush() {
        if (unsent.length() > 0 && !isClosed && !isGathering) {
            byte[] octets = unsent.toString().getBytes(StandardCharsets.ISO_8859_1);
            unsent.setLength(0);
            output.accept(octets);
        }
    }

    /** A line feed directly after a carriage return is ignored: some clients end commands with both. */
    private void take(char character) {
        boolean isSecond = afterReturn && character == '\n';
        afterReturn = character == '\r';
        if (isSecond) {
            return;
        }
        if (mode == Mode.TEXT) {
            takeText(character);
        } else {
            takeCommand(character);
        }
    }

    private void takeCommand(char character) {
        if (character == '\r') {
            echo(character);
            timers.cancel(timer);
            String complete = line.toString();
            line.setLength(0);
            perform(complete);
        } else if (character == ESCAPE || character == CTRL_Z) {
            line.setLength(0);
            isTooLong = false;
            lineIsEmpty();
        } else if (character == BACKSPACE || character == DELETE) {
            echo(character);
            line.setLength(Math.max(0, line.length() - 1));
            lineIsEmpty();
        } else if (character >= ' ') {
            echo(character);
            append(character);
        }
    }

    private void append(char character) {
        if (line.length() == MAX_LINE) {
            isTooLong = true;
            return;
        }
        line.append(character);
        if (line.length() == 2 && line.toString().equalsIgnoreCase("A/")) {
            line.setLength(0);
            perform(lastLine);
        }
    }

    private void lineIsEmpty() {
        if (line.length() == 0) {
            timers.cancel(timer);
            held.send();
        }
    }

    private void perform(String complete) {
        String commands = complete.strip().replaceFirst(AtLineParser.BEFORE_PREFIX, "");
        boolean wasTooLong = isTooLong;
        isTooLong = false;
        if (commands.isEmpty()) {
            held.send();
        } else if (wasTooLong) {
            lastLine = TOO_LONG;
            end(AtResult.ERROR);
        } else if (!commands.toUpperCase(Locale.ROOT).startsWith("AT")) {
            end(AtResult.ERROR);
        } else {
            lastLine = commands;
            parser = new AtLineParser(commands.substring(2));
            mode = Mode.PERFORMING;
            performRest();
        }
    }

    private void performRest() {
        try {
            while (parser.hasNext()) {
                AtResult result = perform(parser.next());
                if (result == AtResult.PENDING) {
                    return;
                }
                if (result != AtResult.OK) {
                    end(result);
                    return;
                }
            }
            end(AtResult.OK);
        } catch (AtException refused) {
            end(refused.result());
        }
    }

    private AtResult perform(AtCommand command) throws AtException {
        AtHandler<C> handler = table.handler(command).orElseThrow(() -> new AtException(AtResult.ERROR));
        request = new AtRequest(this, command);
        early = null;
        isInHandler = true;
        AtResult result;
        try {
            result = handler.perform(client, request);
        } finally {
            isInHandler = false;
        }
        return result == AtResult.PENDING && early != null ? early : result;
    }

    boolean isPerforming(AtRequest asked) {
        return request == asked;
    }

    /** A pending command has its result, possibly before its handler has returned. */
    void finished(AtRequest ended, AtResult result) {
        if (request != ended) {
            return;
        }
        if (isInHandler) {
            early = result;
            return;
        }
        goOn(result);
        process();
    }

    private void goOn(AtResult result) {
        mode = Mode.PERFORMING;
        if (result == AtResult.OK) {
            performRest();
        } else {
            end(result);
        }
    }

    private void end(AtResult result) {
        request = null;
        mode = Mode.COMMAND;
        send(result);
        held.commandEnded();
    }

    // ---- the prompt ---------------------------------------------------------------------------------------------

    void prompt(AtRequest asking, boolean ofLines, AtRequest.TextReceiver newReceiver) {
        if (request == asking) {
            mode = Mode.TEXT;
            textOfLines = ofLines;
            receiver = newReceiver;
            text.setLength(0);
            send("\r\n> ");
            watchPrompt();
        }
    }

    private void watchPrompt() {
        timers.cancel(timer);
        timer = timers.start(PROMPT_NANOS, () -> {
            end(AtResult.ERROR);
            process();
        });
    }

    private void takeText(char character) {
        watchPrompt();
        if (character == CTRL_Z) {
            echo(character);
            endText();
        } else if (character == ESCAPE) {
            timers.cancel(timer);
            goOn(AtResult.OK);
        } else if (character == BACKSPACE) {
            echo(character);
            text.setLength(Math.max(0, text.length() - 1));
        } else if (character == '\r') {
            if (textOfLines) {
                addToText('\n');
                send(format.isEchoed() ? "\r\n> " : "");
            }
        } else {
            echo(character);
            addToText(character);
        }
    }

    private void addToText(char character) {
        if (text.length() < MAX_TEXT) {
            text.append(character);
        }
    }

    private void endText() {
        timers.cancel(timer);
        mode = Mode.PERFORMING;
        early = null;
        isInHandler = true;
        AtResult result;
        try {
            result = receiver.take(text.toString().getBytes(StandardCharsets.ISO_8859_1));
        } catch (AtException refused) {
            result = refused.result();
        } finally {
            isInHandler = false;
        }
        if (result == AtResult.PENDING && early == null) {
            return;
        }
        goOn(early != null ? early : result);
    }

    // ---- what is sent -------------------------------------------------------------------------------------------

    private void echo(char character) {
        if (format.isEchoed()) {
            unsent.append(character);
        }
    }

    private void send(String octets) {
        unsent.append(octets);
    }

    void line(String information) {
        send(format.line(information));
    }

    private void send(AtResult result) {
        send(format.result(result));
    }

    /** Sends an unsolicited line of information, now or after the current command. */
    public void report(String information) {
        reportFormatted(format.line(information), false);
    }

    /** Sends an unsolicited line that a client answers with a command, such as +CMTI; later codes wait for that. */
    public void announce(String information) {
        reportFormatted(format.line(information), true);
    }

    /** Sends an unsolicited result code such as NO CARRIER, likewise. */
    public void report(AtResult code) {
        reportFormatted(format.result(code), false);
    }

    /** Sends all reports of a task as one piece: clients read RING and +CLIP as one notification. */
    public void reportTogether(Runnable reports) {
        isGathering = true;
        reports.run();
        isGathering = false;
        flush();
    }

    private void reportFormatted(String octets, boolean isAnnouncement) {
        if (!isClosed && !octets.isEmpty()) {
            held.add(octets, isAnnouncement);
            sendOrWait();
        }
    }

    /** Sends held codes between two lines, or 2 s after the start of an incomplete one; a command's end sends the rest. */
    private void sendOrWait() {
        if (mode == Mode.COMMAND && line.length() == 0 && !isProcessing) {
            held.send();
            flush();
        } else if (mode == Mode.COMMAND && (timer == null || !timer.isRunning())) {
            timer = timers.start(INCOMPLETE_LINE_NANOS, () -> {
                held.send();
                flush();
            });
        }
    }
}
