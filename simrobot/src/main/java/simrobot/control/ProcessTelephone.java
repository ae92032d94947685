package simrobot.control;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simrobot.behaviour.BehaviourRequest;

/** Connects one robot's process to its telephone, and reports its output. For the simulation's thread. */
final class ProcessTelephone {
    /** The least time between two SMS of a robot's process, so that a loop does not flood the network. */
    private static final long MESSAGE_NANOS = 10_000_000_000L;

    /** A tone of 150 ms and its pause of 70 ms. */
    private static final long TONE_NANOS = 220_000_000;

    private static final long PRINTING_NANOS = 1_000_000_000;
    private static final int MOST_LINES = 100;
    private static final int MOST_CHARACTERS = 200;

    private final ModemPort modem;
    private final LongSupplier callNumber;
    private final LongSupplier clockNanos;
    private final Consumer<RobotEvent> listener;
    private long nextMessageNanos;
    private long nextToneNanos;
    private boolean isRefused;
    private long printingNanos;
    private int lines;

    ProcessTelephone(ModemPort modem, LongSupplier callNumber, LongSupplier clockNanos, Consumer<RobotEvent> listener) {
        this.modem = modem;
        this.callNumber = callNumber;
        this.clockNanos = clockNanos;
        this.listener = listener;
        nextMessageNanos = clockNanos.getAsLong();
        nextToneNanos = nextMessageNanos;
        printingNanos = nextMessageNanos;
    }

    void perform(String process, BehaviourRequest asked) {
        long now = clockNanos.getAsLong();
        if (asked instanceof BehaviourRequest.Printed printed) {
            print(process, printed.text(), now);
        } else if (asked instanceof BehaviourRequest.Tones tones && now - nextToneNanos >= 0) {
            tones.keys().chars().forEach(key -> modem.sendTone(callNumber.getAsLong(), (char) key));
            nextToneNanos = now + TONE_NANOS * tones.keys().length();
        } else if (asked instanceof BehaviourRequest.Sms sms && now - nextMessageNanos >= 0) {
            if (modem.sendMessage(sms.to(), sms.text())) {
                nextMessageNanos = now + MESSAGE_NANOS;
                isRefused = false;
                listener.accept(new RobotEvent.ReplySent(sms.to(), sms.text()));
            }
        } else if (asked instanceof BehaviourRequest.Sms sms && !isRefused) {
            // told once until the next one leaves
            isRefused = true;
            String text = "error: sms to " + sms.to() + " is not sent, expected at most one in 10 s";
            listener.accept(new RobotEvent.Printed(process, text));
        }
    }

    /** Reports the first 100 lines of each second, and how many more there were. */
    private void print(String process, String text, long now) {
        if (now - printingNanos >= PRINTING_NANOS) {
            if (lines > MOST_LINES) {
                listener.accept(new RobotEvent.Printed(process, "... and " + (lines - MOST_LINES) + " more lines"));
            }
            printingNanos = now;
            lines = 0;
        }
        for (String line : text.lines().toList()) {
            lines++;
            if (lines <= MOST_LINES) {
                String shown = line.substring(0, Math.min(line.length(), MOST_CHARACTERS));
                listener.accept(new RobotEvent.Printed(process, shown));
            }
        }
    }
}
