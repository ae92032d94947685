package simgsm.modem.client;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The dialogue with a modem: one command at a time, the next after its final result (TS 27.007, 4). Echo is dropped;
 * unsolicited codes and unknown lines are passed to the listener. A command without a final result in time ends the
 * dialogue, because a late result could be taken for the answer to another command.
 */
final class CommandDialogue {
    /** Receives lines that are no answers. */
    interface Listener {
        /** A code of {@link UnsolicitedCode} or a {@link DtmfDialect}. */
        default void unsolicited(String line) {}

        /** The line after a code that has one, whatever its content. */
        default void body(String line) {}

        /** A line that is no answer, echo or known code. */
        default void unreadable(String line) {}

        /** A command had no final result in time; the others have been dropped. Its receiver is called next. */
        default void stalled(ModemCommand command) {}
    }

    private static final String END_OF_COMMAND = "\r";
    /** Ends the text of a short message (TS 27.005, 3.5.1). */
    private static final String END_OF_PAYLOAD = "\u001a";
    /** Leaves the prompt. */
    private static final String ESCAPE = "\u001b";

    private static final Set<String> CALL_ENDS = Set.of("NO CARRIER", "BUSY", "NO ANSWER", "NO DIALTONE");
    private static final Set<String> REFUSALS = Set.of("ERROR", "COMMAND NOT SUPPORT", "TOO MANY PARAMETERS");

    private record Pending(ModemCommand command, Consumer<ModemAnswer> receiver) {
        Pending {
            Objects.requireNonNull(command, "command");
        }
    }

    private final Timers timers;
    private final Consumer<String> output;
    private final Listener listener;
    private final LineFramer framer = new LineFramer(this::line, this::prompted);
    private final Deque<Pending> queue = new ArrayDeque<>();
    /** The command without final result; null if none. */
    private Pending current;

    private final List<String> lines = new ArrayList<>();
    private Timer limit;
    private boolean bodyFollows;

    /** @param output takes text to send, in ISO 8859-1 */
    CommandDialogue(Timers timers, Consumer<String> output, Listener listener) {
        this.timers = timers;
        this.output = output;
        this.listener = listener;
    }

    /** Queues a command. @param receiver gets its answer once */
    void send(ModemCommand command, Consumer<ModemAnswer> receiver) {
        queue.addLast(new Pending(command, receiver));
        next();
    }

    /** Queues a command before the waiting ones. */
    void sendFirst(ModemCommand command, Consumer<ModemAnswer> receiver) {
        queue.addFirst(new Pending(command, receiver));
        next();
    }

    boolean isIdle() {
        return current == null;
    }

    /** Leaves a prompt that may be open, without waiting for an answer. */
    void escape() {
        output.accept(ESCAPE);
    }

    /** Drops all commands, which end as lost, and a half line. */
    void drop() {
        List<Pending> dropped = new ArrayList<>(queue);
        queue.clear();
        if (current != null) {
            dropped.add(0, current);
            finish();
        }
        framer.drop();
        bodyFollows = false;
        dropped.forEach(each -> each.receiver().accept(ModemAnswer.LOST));
    }

    void received(byte[] octets) {
        framer.accept(octets);
    }

    private void next() {
        if (current != null || queue.isEmpty()) {
            return;
        }
        current = queue.remove();
        lines.clear();
        ModemCommand command = current.command();
        framer.expectPrompt(command.payload().isPresent());
        limit = timers.start(command.timeoutNanos(), this::timedOut);
        output.accept(command.text() + END_OF_COMMAND);
    }

    private void finish() {
        timers.cancel(limit);
        framer.expectPrompt(false);
        current = null;
    }

    private void timedOut() {
        Pending late = current;
        if (late.command().payload().isPresent()) {
            escape();
        }
        ModemAnswer answer = new ModemAnswer(ModemAnswer.Ending.TIMED_OUT, List.copyOf(lines), "");
        finish();
        drop();
        listener.stalled(late.command());
        late.receiver().accept(answer);
    }

    private void prompted() {
        framer.expectPrompt(false);
        output.accept(current.command().payload().orElseThrow() + END_OF_PAYLOAD);
    }

    private void line(String line) {
        if (bodyFollows) {
            bodyFollows = false;
            listener.body(line);
        } else if (current == null) {
            stray(line);
        } else if (!isEcho(line)) {
            answered(line);
        }
    }

    private boolean isEcho(String line) {
        String sent = current.command().text();
        return line.equalsIgnoreCase(sent)
                || current.command().payload().filter(line::startsWith).isPresent();
    }

    private void answered(String line) {
        ModemCommand command = current.command();
        if (line.equals("OK")) {
            end(ModemAnswer.Ending.OK, line);
        } else if (isRefusal(line) || command.shape() == ModemCommand.Shape.CALL && CALL_ENDS.contains(line)) {
            end(ModemAnswer.Ending.REFUSED, line);
        } else if (belongs(command, line)) {
            lines.add(line);
        } else if (isCode(line) || !command.isNamedIn(line)) {
            stray(line);
        }
    }

    private static boolean isRefusal(String line) {
        String upper = line.toUpperCase(Locale.ROOT);
        return REFUSALS.contains(upper) || upper.startsWith("+CME ERROR") || upper.startsWith("+CMS ERROR");
    }

    private boolean belongs(ModemCommand command, String line) {
        boolean prefixed = !command.prefix().isEmpty() && line.startsWith(command.prefix());
        return switch (command.shape()) {
            case RESULT_ONLY, CALL -> false;
            case PREFIXED -> prefixed;
            case PREFIXED_WITH_BODY -> prefixed || !lines.isEmpty() && !isCode(line);
            case FREE -> !isCode(line) && line.indexOf(LineFramer.NOISE) < 0;
        };
    }

    private static boolean isCode(String line) {
        return UnsolicitedCode.of(line).isPresent()
                || DtmfDialect.ofReport(line).isPresent();
    }

    private void end(ModemAnswer.Ending ending, String result) {
        Consumer<ModemAnswer> receiver = current.receiver();
        ModemAnswer answer = new ModemAnswer(ending, List.copyOf(lines), result);
        finish();
        receiver.accept(answer);
        next();
    }

    private void stray(String line) {
        if (isCode(line)) {
            bodyFollows =
                    UnsolicitedCode.of(line).filter(UnsolicitedCode::hasBody).isPresent();
            listener.unsolicited(line);
        } else if (!line.equals("OK") && !isRefusal(line)) {
            listener.unreadable(line);
        }
    }
}
